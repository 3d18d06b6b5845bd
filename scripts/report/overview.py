"""A weld on one page, as a picture."""
import math
import textwrap

from report import along, plan, style
from report.cut import Cut
from report.drawing import Drawing
from report.numbers import KINDS, fixed, readable, readable_date, with_uncertainty
from report.software import software
from report.verdicts import UNVERIFIED, Verdict

WIDTH, HEIGHT, MARGIN = 8.27, 11.69, 0.55  # A4 [in]
INNER = WIDTH - 2 * MARGIN
HEAD, LINE, MOST_LINES = 1.02, 0.156, 11  # the lines beside the verdict: where, how far apart [in], how many
MAPS_END, SECTION_END = 6.05, 8.15  # [in]


def page_box(left, top, width, height):
    """Place on the page in inches, from its upper left."""
    return [left / WIDTH, 1.0 - (top + height) / HEIGHT, width / WIDTH, height / HEIGHT]


def page_axes(figure, left, top, width, height):
    return figure.add_axes(page_box(left, top, width, height))


def write(figure, left, top, text, **look):
    look = dict({"va": "top", "ha": "left", "color": style.INK}, **look)
    figure.text(left / WIDTH, 1.0 - top / HEIGHT, style.plain(text), **look)


def rule(figure, top, width=1.0):
    axes = page_axes(figure, MARGIN, top, INNER, 0.001)
    axes.axhline(0.0, color=style.INK, linewidth=width, clip_on=False)
    axes.axis("off")


def shortened(text, length):
    return text if len(text) <= length else text[:length - 1] + "…"


def _head(figure, folder):
    """Name and verdict with all that it rests on; where it ends [in]."""
    record, verdict = folder.record, Verdict(folder)
    write(figure, MARGIN, 0.45, shortened(record.text("id") or "Weld without a name", 44), fontsize=16, fontweight="bold")
    kind = KINDS.get(folder.kind, readable(folder.kind))
    write(figure, WIDTH - MARGIN, 0.45, "%s\n%s" % (kind, readable_date(record.text("date"))), fontsize=8, ha="right", color=style.GREY)
    rule(figure, 0.86, 1.5)
    dark = verdict.kind == "fail"
    ground = style.INK if dark else {"undecided": style.OPEN, "none": style.OPEN}.get(verdict.kind, "white")
    write(figure, MARGIN + 0.12, 1.08, verdict.mark, fontsize=17, fontweight="bold", color="white" if dark else style.INK,
           bbox={"boxstyle": "square,pad=0.3", "facecolor": ground, "edgecolor": style.INK})
    lines = [part for sentence in verdict.why + verdict.missing for part in textwrap.wrap(sentence, 68)]
    last = ["This verdict %s." % UNVERIFIED] if verdict.unverified else []
    last += [verdict.beside(folder)] if folder.has_weld() and verdict.beside(folder) else []
    room = MOST_LINES - len(last)
    lines = (lines if len(lines) <= room else lines[:room - 1] + ["… more in report.html"]) + last
    write(figure, MARGIN + 3.15, HEAD, "\n".join(lines), fontsize=8, linespacing=1.4)
    return max(HEAD + LINE * len(lines) + 0.1, 1.72)


def _numbers(figure, folder, top):
    """Two lines of what matters most."""
    record = folder.record
    cells = [(name, with_uncertainty(*[scale * number for number in record.quantity(key)], unit=unit))
             for key, name, scale, unit in (("length", "length", 1e3, "mm"), ("volume", "volume", 1e9, "mm³"),
                                            ("removal_volume", "to remove", 1e9, "mm³"))]
    statistics = record.record("statistics")
    for name in ("width", "reinforcement"):
        values = statistics.record(name)
        mean, sigma = 1e3 * values.number("mean"), 1e3 * values.number("mean_sigma")
        name = "convexity" if folder.kind == "fillet" and name == "reinforcement" else name
        cells.append(("mean " + name, with_uncertainty(mean, sigma, "mm")))
    share, sections = record.number("measured_share"), record.number("sections")
    of = " of %.0f" % sections if math.isfinite(sections) else ""
    cells.append(("sections measured", fixed(100 * share, 1, "%") + of))
    for i, (name, value) in enumerate(cells):
        left, down = MARGIN + (i % 3) * INNER / 3, top + (i // 3) * 0.36
        write(figure, left, down, name, fontsize=6.5, color=style.GREY)
        write(figure, left, down + 0.12, value, fontsize=9)


def _maps(figure, folder, relief, top, height):
    """Both views; the room that is left for a cross-section: (left, top, width, height) [in]."""
    below = (MARGIN, MAPS_END + 0.1, INNER, SECTION_END - MAPS_END - 0.1)
    if folder.grid is None:
        write(figure, MARGIN, top, "The folder holds no points.", fontsize=8)
        return below
    shape = plan.Plan(folder.grid)
    wide = shape.wide()
    tall = folder.kind == "fillet" and folder.chosen  # its cross-section is nearly as high as it is wide
    if wide:
        upper = min(height * 0.46, max(6.0 * shape.ratio + 0.1, 0.85))  # a scan of three rows: room for the axes' names
        axes = page_axes(figure, MARGIN + 0.45, top, INNER - 1.1, upper)
        begin = top + upper + 0.75
        lower = page_axes(figure, MARGIN, begin, INNER, height - upper - 0.75)
        if tall:
            lower.set_position(page_box(MARGIN, begin + 0.4, 0.36 * INNER, 2.0))
            below = (MARGIN + 0.38 * INNER, begin, 0.62 * INNER, SECTION_END - begin)
    else:
        if tall:
            height, below = height - 0.9, (below[0], below[1] - 0.9, below[2], below[3] + 0.9)
        axes = page_axes(figure, MARGIN + 0.42, top, 0.40 * INNER, height - 0.85)
        lower = page_axes(figure, MARGIN + 0.56 * INNER, top, 0.44 * INNER, height)
    plan.height_map(figure, axes, folder, 7 if wide else 3)
    relief.draw(lower)
    if relief.view.exaggeration != 1:
        lower.text(1.0, -0.01, "heights × %g" % relief.view.exaggeration, transform=lower.transAxes, fontsize=6.5, ha="right",
                   va="top", color=style.GREY)
    return below


def _section(figure, folder, left, top, width, height):
    """The middle one of those in the report."""
    number = len(folder.chosen) // 2
    cut = Cut(folder, folder.chosen[number])
    axes = page_axes(figure, left, top, width, height)
    Drawing(axes, folder, cut).draw()
    write(figure, left, top + height, "Section %d–%d at s = %s mm, millimetres ± 2σ" % (number + 1, number + 1, fixed(cut.s, 2)),
           fontsize=6.5, color=style.GREY)


def overview(folder, relief):
    """The bytes of report.png."""
    figure = style.page(HEIGHT, WIDTH)
    top = _head(figure, folder)
    if folder.has_weld():
        _numbers(figure, folder, top)
        top += 0.88
    room = _maps(figure, folder, relief, top, (MAPS_END if folder.chosen else SECTION_END) - top)
    if folder.chosen:
        _section(figure, folder, *room)
    if folder.has_weld() and len(folder.sections):
        axes = page_axes(figure, MARGIN + 0.5, 8.6, INNER - 0.75, 0.85)
        along.draw_width(axes, folder)
        along.finish(axes, folder)
        axes = page_axes(figure, MARGIN + 0.5, 9.8, INNER - 0.75, 0.95)
        _, beyond = along.draw_height(axes, folder)
        along.finish(axes, folder, beyond, True)
    rule(figure, HEIGHT - 0.5, 0.6)
    calibration = folder.record.record("calibration")
    age = calibration.number("age_days")
    aged = "not dated" if not math.isfinite(age) else "%.1f days old" % age
    write(figure, MARGIN, HEIGHT - 0.44, "%s\n%s" % (
        shortened("Calibration %s (%s), %s. Settings %s." % (
            calibration.text("file") or "not named", calibration.text("hash") or "no hash", aged,
            folder.record.text("settings_hash") or "not named"), 150),
        shortened("%s. Bands and ±: two standard deviations." % (
            software(folder.record)[:1].upper() + software(folder.record)[1:]), 150)), fontsize=6.2, color=style.GREY, linespacing=1.4)
    return style.png(figure, 150)
