"""A weld's report as a page."""
import math

import numpy as np

from report import html, numbers, plan, weld_tables
from report.html import tag
from report.numbers import fixed, with_uncertainty
from report.software import software
from report.verdicts import UNVERIFIED, Verdict
from report.weld_figures import map_figure, other_figure, section_figure, size_figure

VERDICT_NOTE = ("Numbers of ISO 6520-1. Margin > 0: within the limit. At: the place that decides, s along the weld. Length: of weld "
                "beyond the limit (rule short: the most in any 100 mm; the weld: its own).")
BANDS = "Bands and ± are two standard deviations (about 95 %)."


def title(folder):
    return folder.record.text("id") or "Weld without a name"


def headline(folder):
    record = folder.record
    what = [numbers.KINDS.get(folder.kind, numbers.readable(folder.kind)), numbers.readable_date(record.text("date"))]
    thickness = record.record("verdict").number("thickness")
    if math.isfinite(thickness):
        what.append("plate %g mm" % (1e3 * thickness))
    return tag("header", tag("h1", title(folder)), tag("div", "Report of a weld scan", tag("br"), " · ".join(what), kind="what"))


def verdict_box(folder):
    verdict = Verdict(folder)
    why = tag("div", *[tag("div", sentence) for sentence in verdict.why + verdict.missing],
              tag("div", tag("span", "This verdict %s." % UNVERIFIED, kind="unverified")) if verdict.unverified else "", kind="why")
    return tag("div", tag("div", verdict.mark, kind="mark"), why, kind="verdict " + verdict.kind)


def not_measured(folder):
    """What is missing and why; other beads."""
    record, lines = folder.record, []
    if record.text("reason") and folder.has_weld():
        lines.append(record.text("reason"))
    lines += record.record("verdict").texts("notes")
    lines += [name if " " in name else "%s is not in the folder" % name for name in folder.missing]
    table = folder.sections
    for name, label, _ in weld_tables.SECTION_VALUES:
        if len(table) and table.has(name):
            holes = int(np.isnan(table.numbers(name)).sum())
            if holes and (holes < len(table) or weld_tables.applies(folder.kind, name)):
                lines.append("%s: not measured in %s of %d sections" % (label, "all" if holes == len(table) else holes, len(table)))
    for bead in record.records("other_beads"):
        x, near, far, width, height = (fixed(1e3 * bead.number(key), 1) for key in ("x", "y_from", "y_to", "width", "height"))
        lines.append("Another bead was seen and not measured: x %s mm, y %s to %s mm, about %s mm wide and %s mm high."
                     % (x, near, far, width, height))
    return tag("ul", *[tag("li", line) for line in lines]) if lines else tag("p", "Everything was measured in every section.")


def maps(folder, relief):
    if folder.grid is None:
        return tag("p", "No map: the folder holds no points.")
    reference = "the mean plane of the base metal" if folder.levelled else "z = 0 of the scan"
    shape = plan.Plan(folder.grid)
    wide = shape.wide()
    above = html.figure(map_figure(folder, plan.height_map, wide),
                        "Seen from above, travel %s. Heights over %s; white = not measured. Numbers mark the cross-sections."
                        % ("to the right" if shape.lying else "upward", reference), "Height map with toes and crest")
    block = html.figure(relief.png(), "The scan as a block of %.1f × %.1f mm, travel %s, heights drawn %s; light "
                        "grey = not measured." % (folder.grid.right - folder.grid.left, folder.grid.far - folder.grid.near,
                                                  "to the right" if shape.lying else "away from the viewer",
                                                  "true" if relief.view.exaggeration == 1 else "× %g" % relief.view.exaggeration),
                        "3-D view of the scan")
    return html.join(above, block) if wide else tag("div", above, block, kind="two")


def sections(folder):
    """Drawings, and all values of these sections."""
    if not folder.chosen:
        return tag("p", "No cross-section can be drawn: no section has both toes, or the points are missing.")
    parts = [tag("p", "Seen along the travel, true to scale, cut out of the points as they were measured. Dash-dotted: parent "
                 "lines. b width between the toes (circles), h reinforcement over their chord, 5011 undercut, 507 misalignment "
                 "(ISO 6520-1); for a fillet z legs and a throat. Millimetres ± 2σ.", kind="small")]
    for number, index in enumerate(folder.chosen, 1):
        s = folder.sections.numbers("s_mm")[index]
        caption = "Section %d–%d at s = %s mm: %s." % (number, number, fixed(s, 2), weld_tables.section_verdict(folder, index))
        parts.append(html.figure(section_figure(folder, index), caption, "Cross-section %d with dimensions" % number))
    parts.append(tag("p", "All values of these sections, ± 2σ; – = not measured.", kind="small"))
    parts.append(weld_tables.sections(folder))
    return html.join(*parts)


def along_weld(folder):
    if not len(folder.sections):
        return tag("p", "No sections were measured.")
    picture, agrees = size_figure(folder)
    limits = "Dashed: limits of level B, C, D, which follow the width." if agrees else \
        "Limits are not drawn: verdict.csv was judged after another table, whose rule along the weld is not known."
    gauge = " Squares: readings by hand, bars = half a step of the gauge to either side." if folder.gauge else ""
    parts = [html.figure(picture, "%s %s%s" % (BANDS, limits, gauge), "Width and height along the weld")]
    if folder.gauge:
        parts.append(weld_tables.gauge(folder))
    other = other_figure(folder)
    if other:
        parts.append(html.figure(other, "%s Dashed: limits." % BANDS, "Further sizes along the weld"))
    return html.join(*parts)


def removal(folder):
    record = folder.record
    value, sigma = (1e9 * number for number in record.quantity("removal_volume"))
    target = record.record("settings").content.get("target")
    target = target if isinstance(target, str) else ""
    words = {"flush": "flush with the parents", "rest": "a rest above the parents"}.get(target, target or "not stated")
    length = 1e3 * record.number("volume_length")
    along = " over %.1f mm of weld" % length if math.isfinite(length) else ""
    line = tag("p", "To be removed: ", tag("b", with_uncertainty(value, sigma, "mm³")), "%s. Target: %s." % (along, words))
    if folder.cloud is None or not folder.cloud.has("removal"):
        return html.join(line, tag("p", "No map: the points carry no removal."))
    wide = plan.Plan(folder.grid).wide()
    picture = map_figure(folder, plan.removal_map, wide)
    return html.join(line, html.figure(picture, "Height above the target; white = nothing to remove, pale blue = not known. "
                                       "Lines: toes.", "Removal map", "" if wide else "half"))


def origin(folder):
    """Calibration and software: what a number can be traced to."""
    calibration = folder.record.record("calibration")
    age = calibration.number("age_days")
    rows = [("calibration file", calibration.text("file") or numbers.NONE), ("its hash", calibration.text("hash") or numbers.NONE),
            ("calibrated", numbers.readable_date(calibration.text("date"))),
            ("age at the scan", "not dated" if not math.isfinite(age) else "%.1f days" % age),
            ("frame", folder.record.text("frame_id") or numbers.NONE), ("software", software(folder.record)),
            ("settings, their hash", folder.record.text("settings_hash") or numbers.NONE), ("folder", folder.path)]
    scores = folder.record.record("scores")
    if scores:
        rows.append(("agreement with each kind", ", ".join("%s %.2f" % (numbers.readable(name), scores.number(name))
                                                           for name in scores.keys())))
    return html.facts(rows)


def weld_page(folder, relief):
    parts = [headline(folder), verdict_box(folder)]
    if folder.has_weld():
        facts = weld_tables.summary(folder)
        parts.append(tag("div", html.facts(facts[:4]), html.facts(facts[4:]), kind="two"))
    parts += [tag("h2", "The scan"), maps(folder, relief)]
    if folder.has_weld():
        parts += [tag("h2", "Statistics"), weld_tables.statistics(folder), tag("h2", "Cross-sections"), sections(folder),
                  tag("h2", "Along the weld"), along_weld(folder),
                  tag("h2", "Verdict"), verdict_box(folder), weld_tables.verdict(folder),
                  tag("p", VERDICT_NOTE, kind="note")]
        if len(folder.spots):
            parts += [tag("h2", "Pores and spatter"), weld_tables.spots(folder)]
        parts.append(tag("div", tag("h2", "What grinding must remove"), removal(folder), style="break-inside: avoid"))
    parts += [tag("h2", "What could not be measured, and why" if folder.has_weld() else "What was seen"), not_measured(folder),
              tag("h2", "Calibration and software"), origin(folder), tag("h2", "Settings"), weld_tables.settings(folder),
              tag("footer", "Uncertainties are two standard deviations (k = 2) as the measurement states them.")]
    return html.page("%s – weld report" % title(folder), html.join(*parts))
