"""The report of a comparison before and after grinding, as a page and as a picture."""
import math
import os

from report import html, numbers, style, weld_tables
from report import compare_figures as figures
from report.html import tag
from report.numbers import NONE, fixed, with_uncertainty
from report.overview import HEIGHT, INNER, MARGIN, WIDTH, page_axes, rule, shortened, write
from report.software import software

MAPS = ("Seen from above. Remaining: blue = still above the target, red = below it (also an undercut that was there before), "
        "checked = over-ground, grey = not known. Numbers: the over-ground places of the table.")
PROFILES = "Rows of the scan at 20, 50 and 80 % of its length; heights larger than true to scale."
ALONG = ("Area of each cross-section (what is below the target counts as negative), and how far below the target it was ground: its "
         "lowest place (means over 3 × 3 cells of the map); what lay as low before grinding, an undercut, does not count.")


def result(folder):
    """(mark, kind, sentences)."""
    if folder.grid is None and not math.isfinite(folder.record.quantity("removed_volume")[0]):
        return "NOT COMPARED", "none", [folder.record.text("reason") or "compare.json holds no volume and there is no map"]
    why = ["Over-ground: below the target by more than %.3g mm." % folder.limit]
    if folder.record.content.get("over_ground") is None:
        return "OVER-GROUND NOT KNOWN", "undecided", why
    count = len(folder.spots)
    if not count:
        return "NOT OVER-GROUND", "level", why + ["No such place was found."]
    depths = [1e3 * spot.quantity("depth")[0] for spot in folder.spots]
    depths = [depth for depth in depths if math.isfinite(depth)]
    deepest = " The deepest: %.3f mm." % max(depths) if depths else ""
    return "OVER-GROUND", "fail", why + ["%d such place%s.%s" % (count, "" if count == 1 else "s", deepest)]


def volumes(folder):
    record = folder.record
    rows = [(name, with_uncertainty(*[1e9 * number for number in record.quantity(key)], unit="mm³"))
            for key, name in (("removed_volume", "removed"), ("remaining_volume", "remaining above the target"))]
    rows.append(("share of the weld compared", fixed(100 * record.number("measured_share"), 1, "%")))
    return rows


def alignment(folder):
    aligned = folder.record.record("aligned")
    shift, shift_sigma = aligned.numbers("shift", 3), aligned.numbers("shift_sigma", 3)
    turn, turn_sigma = aligned.numbers("rotation", 3), aligned.numbers("rotation_sigma", 3)
    shift, shift_sigma = shift or [math.nan] * 3, shift_sigma or [math.nan] * 3
    rows = [("shift " + axis, with_uncertainty(1e3 * shift[i], 1e3 * shift_sigma[i], "mm")) for i, axis in enumerate("xyz")]
    rows += [("turn about " + axis, with_uncertainty(math.degrees(turn[i]), math.degrees(turn_sigma[i]), "°"))
             for i, axis in enumerate("xyz")]
    residual = 1e3 * aligned.number("residual")
    return rows + [("parents apart after it, RMS", fixed(residual, 4, "mm"))]


def spots(folder):
    rows = []
    for number, spot in enumerate(folder.spots, 1):
        depth, sigma = spot.quantity("depth")
        sigma = spot.number("sigma_depth") if not math.isfinite(sigma) else sigma
        rows.append(["%d" % number] + [fixed(1e3 * spot.number(key), 1) for key in ("s", "x", "y")]
                    + [with_uncertainty(1e3 * depth, 1e3 * sigma, none=NONE) if math.isfinite(sigma) else fixed(1e3 * depth, 3),
                       fixed(1e6 * spot.number("area"), 2)])
    if not rows:
        return tag("p", "None.")
    return html.table(["no.", "s [mm]", "x [mm]", "y [mm]", "depth below the target [mm]", "area [mm²]"], rows, range(6))


def compare_page(folder):
    record = folder.record
    mark, kind, why = result(folder)
    head = tag("header", tag("h1", record.text("id") or "Before and after grinding"),
               tag("div", "Comparison before and after grinding", tag("br"),
                   numbers.KINDS.get(record.text("kind"), numbers.readable(record.text("kind"))), kind="what"))
    box = tag("div", tag("div", mark, kind="mark"), tag("div", *[tag("div", line) for line in why], kind="why"),
              kind="verdict " + kind)
    parts = [head, box, html.facts(volumes(folder)), tag("h2", "Maps")]
    if folder.grid is None:
        parts.append(tag("p", "No map: difference.pcd is missing or holds no point."))
    else:
        parts += [html.figure(figures.maps_figure(folder), MAPS, "Maps of the comparison"),
                  tag("h2", "Over-ground places"), spots(folder), tag("h2", "Cross-sections"),
                  html.figure(figures.profiles_figure(folder), PROFILES, "Cross-sections before and after"),
                  tag("h2", "Along the scan"),
                  html.figure(figures.along_figure(folder), ALONG, "Removed and remaining along the scan")]
    notes = [record.text("reason")] * bool(record.text("reason")) + record.texts("notes")
    calibration = record.record("calibration")
    origin = [("before", record.text("before") or NONE), ("after", record.text("after") or NONE),
              ("calibration", "%s (%s)" % (calibration.text("file") or NONE, calibration.text("hash") or "no hash")),
              ("software", software(record)), ("folder", os.path.abspath(folder.named))]
    parts += [tag("h2", "What could not be compared, and why"),
              tag("ul", *[tag("li", note) for note in notes]) if notes else tag("p", "Nothing was left out."),
              tag("h2", "How the scans were aligned"), html.facts(alignment(folder)), tag("h2", "Origin"), html.facts(origin),
              tag("h2", "Settings"), weld_tables.settings(folder),
              tag("footer", "Uncertainties are two standard deviations (k = 2) as the comparison states them.")]
    return html.page("%s – before and after grinding" % (record.text("id") or "Weld"), html.join(*parts))


def compare_overview(folder):
    """The bytes of the one-page picture."""
    figure = style.page(HEIGHT, WIDTH)
    mark, kind, why = result(folder)
    title = folder.record.text("id") or "Before and after grinding"
    write(figure, MARGIN, 0.45, shortened(title, 44), fontsize=16, fontweight="bold")
    write(figure, WIDTH - MARGIN, 0.45, shortened("before: " + folder.record.text("before"), 60) + "\n"
          + shortened("after: " + folder.record.text("after"), 60), fontsize=7, ha="right", color=style.GREY)
    rule(figure, 0.86, 1.5)
    dark = kind == "fail"
    write(figure, MARGIN + 0.12, 1.08, mark, fontsize=15, fontweight="bold", color="white" if dark else style.INK,
          bbox={"boxstyle": "square,pad=0.3", "facecolor": style.INK if dark else "white", "edgecolor": style.INK})
    write(figure, MARGIN + 3.5, 1.02, "\n".join(shortened(line, 66) for line in why), fontsize=8, linespacing=1.4)
    for i, (name, value) in enumerate(volumes(folder)):
        write(figure, MARGIN + i * INNER / 3, 1.72, name, fontsize=6.5, color=style.GREY)
        write(figure, MARGIN + i * INNER / 3, 1.84, value, fontsize=9)
    if folder.grid is not None:
        _draw_maps(figure, folder)
    rule(figure, HEIGHT - 0.5, 0.6)
    write(figure, MARGIN, HEIGHT - 0.44, shortened(software(folder.record), 150), fontsize=6.2, color=style.GREY)
    return style.png(figure, 150)


def _draw_maps(figure, folder):
    height, places = figures.maps_layout(folder, INNER)
    for name, (left, bottom, width, tall) in zip(figures.TITLES, places):
        figures.draw_map(figure, page_axes(figure, MARGIN + left, 2.4 + height - bottom - tall, width, tall), folder, name)
    top = 2.4 + height + 0.15
    if top + 1.3 < HEIGHT - 1.2:
        axes = page_axes(figure, MARGIN + 0.55, top, INNER - 0.7, 1.1)
        figures.draw_profile(axes, folder, 0.5, True)
        axes.set_xlabel("x across [mm]")
    if top + 2.9 < HEIGHT - 1.0:
        figures.draw_areas(page_axes(figure, MARGIN + 0.55, top + 1.85, INNER - 0.8, 0.85), folder)
    if top + 4.1 < HEIGHT - 0.8:
        figures.draw_lowest(page_axes(figure, MARGIN + 0.55, top + 3.0, INNER - 0.8, 0.85), folder)
