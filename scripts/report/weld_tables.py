"""The tables of a weld's report."""
import math

import numpy as np

from report import html, numbers
from report.numbers import NONE, at, fixed, with_uncertainty
from report.verdicts import UNVERIFIED, judged_in_part

SECTION_VALUES = (
    ("width_mm", "width b", "mm"), ("reinforcement_mm", "reinforcement h", "mm"), ("height_left_mm", "above the left plate", "mm"),
    ("height_right_mm", "above the right plate", "mm"), ("toe_angle_left_deg", "toe angle left", "°"),
    ("toe_angle_right_deg", "toe angle right", "°"), ("undercut_left_mm", "undercut left", "mm"),
    ("undercut_right_mm", "undercut right", "mm"), ("misalignment_mm", "misalignment", "mm"), ("angle_deg", "angle of the plates", "°"),
    ("leg_left_mm", "leg left", "mm"), ("leg_right_mm", "leg right", "mm"), ("throat_mm", "throat", "mm"),
    ("incomplete_fill_mm", "incomplete fill", "mm"), ("area_mm2", "area over the chord", "mm²"))


def applies(kind, name):
    """Whether a weld of this kind has such a quantity at all."""
    return not name.startswith(("misalignment", "incomplete_fill") if kind == "fillet" else ("leg", "throat"))


def summary(folder):
    """The weld as a whole."""
    record, rows = folder.record, []
    for key, name, scale, unit in (("length", "length", 1e3, "mm"), ("volume", "volume over the chord", 1e9, "mm³"),
                                   ("removal_volume", "volume to remove", 1e9, "mm³"),
                                   ("ripple_pitch", "ripple pitch", 1e3, "mm"), ("ripple_height", "ripple height", 1e3, "mm")):
        value, sigma = (scale * number for number in record.quantity(key))
        rows.append((name, with_uncertainty(value, sigma, unit)))
    share = record.number("measured_share")
    sections = record.number("sections")
    rows.append(("sections", fixed(sections, 0)))
    rows.append(("share of them measured", fixed(100 * share, 1, "%")))
    return rows


def _from_sections(folder):
    """Statistics where weld.json has none: {name: values [what people read]}."""
    columns = (("width", "width_mm"), ("reinforcement", "reinforcement_mm"), ("undercut_left", "undercut_left_mm"),
               ("undercut_right", "undercut_right_mm"), ("misalignment", "misalignment_mm"))
    rows = []
    for name, column in columns:
        values = folder.sections.numbers(column)
        values = values[np.isfinite(values)]
        if values.size:
            rows.append([numbers.readable(name) + " [mm]", "%d" % values.size, fixed(values.mean(), 3), fixed(values.std(), 3),
                         fixed(values.min(), 3), fixed(values.max(), 3)])
    return rows


def statistics(folder):
    record, rows = folder.record.record("statistics"), []
    for name in record.keys():
        values = record.record(name)
        scale, unit = numbers.scale_and_unit(name)
        places = 1 if unit == "°" else 3
        count = values.number("count")
        if not count > 0 and not applies(folder.kind, name):
            continue
        if not count > 0:
            rows.append(["%s [%s]" % (numbers.readable(name), unit), "0"] + [NONE] * 4)
            continue
        sigma = values.number("mean_sigma")
        mean = scale * values.number("mean")
        rows.append(["%s [%s]" % (numbers.readable(name), unit), fixed(count, 0),
                     with_uncertainty(mean, scale * sigma, none=NONE) if math.isfinite(sigma) else fixed(mean, places)]
                    + [fixed(scale * values.number(key), places) for key in ("deviation", "least", "largest")])
    rows = rows or _from_sections(folder)
    if not rows:
        return html.tag("p", "No statistics: nothing was measured.")
    return html.table(["along the weld", "sections", "mean ± 2σ", "standard deviation", "least", "largest"], rows, range(1, 6), "whole")


def verdict(folder):
    """A line an imperfection and level."""
    table, rows, last = folder.verdict, [], None
    columns = {name: table.texts(name) for name in ("imperfection", "level", "decision", "source", "iso_6520", "side", "rule")}
    place, length = table.numbers("s_mm"), table.numbers("length_mm")
    for i, name in enumerate(columns["imperfection"]):
        angle = math.isfinite(table.numbers("value_deg")[i])
        suffix, unit = ("_deg", "°") if angle else ("_mm", "mm")
        value, sigma, limit, margin, margin_sigma = (
            table.numbers(key + suffix)[i] for key in ("value", "sigma", "limit", "margin", "sigma_margin"))
        margin_sigma = margin_sigma if math.isfinite(margin_sigma) else sigma
        decision = columns["decision"][i]
        words = numbers.DECISIONS.get(decision, decision)
        if columns["source"][i] == "unverified" and decision in ("pass", "fail", "undecided"):
            words = html.join(words, html.tag("div", UNVERIFIED, kind="small"))
        places = " ".join(filter(None, ["s %s" % fixed(place[i], 1) if math.isfinite(place[i]) else "", columns["side"][i]]))
        first = name != last
        last = name
        label = numbers.IMPERFECTIONS.get(name, numbers.readable(name))
        number = columns["iso_6520"][i]
        rows.append(("group" if first else "",
                     [(label + (", no. %s" % number if number else "")) if first else "", columns["level"][i],
                      with_uncertainty(value, sigma, unit, NONE), _limit(limit, unit, columns["rule"][i]),
                      with_uncertainty(margin, margin_sigma, unit, NONE), (places or NONE, "at"), fixed(length[i], 1),
                      (words, decision if decision in ("fail", "undecided") else "")]))
    if not rows:
        return html.tag("p", "No verdict: verdict.csv is missing or has no line.")
    return html.table(["imperfection", "level", "value ± 2σ", "limit", "margin ± 2σ", "at [mm]",
                       "length [mm]", "decision"], rows, (2, 3, 4, 6), "verdicts")


def _limit(limit, unit, rule):
    if rule == "not_permitted":
        return "not permitted"
    return fixed(limit, 1 if unit == "°" else 3, unit) + (" (short)" if rule == "short" else "")


def sections(folder):
    """Every value of the sections that are drawn, a column a section."""
    rows = []
    for name, label, unit in SECTION_VALUES:
        values, sigmas = folder.sections.quantity(name)
        if folder.sections.has(name) and (np.isfinite(values).any() or applies(folder.kind, name)):
            rows.append(["%s [%s]" % (label, unit)] + [with_uncertainty(values[i], sigmas[i], none=NONE) for i in folder.chosen])
    names = ["section"] + ["%d–%d" % (number, number) for number in range(1, len(folder.chosen) + 1)]
    return html.table(names, rows, range(1, len(names)), "whole")


def section_verdict(folder, index):
    word = folder.sections.texts("verdict")[index]
    if not word:
        return "not judged"
    met = "level %s" % word + (" by what was judged" if judged_in_part(folder) else "")
    text = {"fail": "fails", "undecided": "undecided"}.get(word, met)
    return text + (" (%s)" % UNVERIFIED if folder.sections.texts("verdict_source")[index] == "unverified" else "")


def gauge(folder):
    """Readings by hand beside what was scanned there."""
    readings, table, rows, differences = folder.gauge, folder.sections, [], {}
    s = table.numbers("s_mm")
    for name, column, read in (("width", "width_mm", readings.width), ("height", "reinforcement_mm", readings.height)):
        scanned = at(s, table.numbers(column), readings.s)
        sigma = at(s, table.quantity(column)[1], readings.s)
        differences[name] = (scanned, scanned - read, sigma)
    resolution = readings.stated_resolution()
    for name, (_, difference, _) in differences.items():
        known = difference[np.isfinite(difference)]
        if not known.size:
            rows.append([name, "0"] + [NONE] * 4)
            continue
        within = "%d of %d" % ((np.abs(known) <= resolution).sum(), known.size) if math.isfinite(resolution) else NONE
        rows.append([name, "%d" % known.size, fixed(known.mean(), 3), fixed(known.std(ddof=1) if known.size > 1 else math.nan, 3),
                     fixed(np.abs(known).max(), 3), within])
    stated = ("The gauge reads in steps of %g mm." % resolution if math.isfinite(resolution)
              else "The gauge's resolution was not stated (column resolution_mm).")
    return html.join(html.table(["scan − gauge [mm]", "readings", "mean", "standard deviation", "largest", "within one step"], rows,
                                range(1, 6)), html.tag("p", stated, kind="note"))


def spots(folder):
    table = folder.spots
    if not len(table):
        return ""
    rows = []
    for i, kind in enumerate(table.texts("kind")):
        cells = [kind] + [fixed(table.numbers(name)[i], 1) for name in ("s_mm", "x_mm", "y_mm")]
        for name in ("diameter_mm", "height_mm"):
            value, sigma = (values[i] for values in table.quantity(name))
            cells.append(with_uncertainty(value, sigma, none=NONE))
        rows.append(cells)
    more = len(rows) - 40
    return html.join(html.table(["spot", "s [mm]", "x [mm]", "y [mm]", "diameter ± 2σ [mm]", "height ± 2σ [mm]"], rows[:40],
                                range(1, 6)),
                     html.tag("p", "And %d more in spots.csv." % more, kind="small") if more > 0 else "")


def settings(folder):
    """Every parameter, as weld.json has it."""
    content = folder.record.record("settings").content
    rows = [(name, NONE if value in (None, "") else "%.6g" % value if isinstance(value, float) else str(value))
            for name, value in _flat(content)]
    if not rows:
        return html.tag("p", "weld.json holds no settings.")
    half = (len(rows) + 1) // 2
    return html.tag("div", html.facts(rows[:half]), html.facts(rows[half:]), kind="two")


def _flat(content, prefix=""):
    for name, value in content.items():
        if isinstance(value, dict):
            yield from _flat(value, prefix + name + ".")
        else:
            yield prefix + name, value
