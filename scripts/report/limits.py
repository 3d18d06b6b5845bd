"""The limits along a weld, from what verdict.csv and weld.json say; nothing is drawn that they contradict."""
import math

import numpy as np

from report.numbers import at
from report.style import LEVELS

# min(base + factor * width, cap) [mm] of ISO 5817:2003, as in the shipped table: nos. 502 and 503
HEIGHT_RULES = {
    "excess_weld_metal": {"B": (1.0, 0.10, 5.0), "C": (1.0, 0.15, 7.0), "D": (1.0, 0.25, 10.0)},
    "convexity": {"B": (1.0, 0.10, 3.0), "C": (1.0, 0.15, 4.0), "D": (1.0, 0.25, 5.0)}}


def rows_of(folder, imperfection):
    """{level: line number} in verdict.csv."""
    table = folder.verdict
    return {level: i for i, (name, level) in enumerate(zip(table.texts("imperfection"), table.texts("level")))
            if name == imperfection and level in LEVELS}


def constant_limits(folder, imperfection):
    """{level: (s, limit)} of limits that do not depend on the width; empty without any."""
    name = "limit_deg" if imperfection == "toe_angle" else "limit_mm"
    s = folder.sections.numbers("s_mm")
    s = s[np.isfinite(s)]
    if not s.size:
        return {}
    limits = {level: folder.verdict.numbers(name)[i] for level, i in rows_of(folder, imperfection).items()}
    return {level: (np.array([s.min(), s.max()]), np.array([limit, limit]))
            for level, limit in limits.items() if math.isfinite(limit)}


def height_rules(folder):
    """{level: (base, factor, cap)} [mm]: from weld.json's verdict.height_limits, else the shipped table's."""
    stated = folder.record.record("verdict").record("height_limits")
    rules = {}
    for level in LEVELS:
        rule = stated.record(level)
        if rule:
            cap = rule.number("cap")
            rules[level] = (1e3 * rule.number("base"), rule.number("factor"), 1e3 * cap if math.isfinite(cap) else math.inf)
    return rules or HEIGHT_RULES["convexity" if folder.kind == "fillet" else "excess_weld_metal"]


def height_limits(folder):
    """({level: (s, limit)}, whether the rule agrees with verdict.csv). Other tables of limits have other rules: where
    a limit in verdict.csv is not the rule's, its level has no line."""
    imperfection = "convexity" if folder.kind == "fillet" else "excess_weld_metal"
    rows = rows_of(folder, imperfection)
    s, width = folder.sections.numbers("s_mm"), folder.sections.numbers("width_mm")
    known = np.isfinite(s) & np.isfinite(width)
    lines, agrees = {}, True
    for level, (base, factor, cap) in height_rules(folder).items():
        stated = folder.verdict.numbers("limit_mm")[rows[level]] if level in rows else math.nan
        if not known.any() or not math.isfinite(stated):
            continue
        limit = np.minimum(base + factor * width, cap)
        here = at(s, limit, [folder.verdict.numbers("s_mm")[rows[level]]])[0]
        # limits are those of a running median of the width: sections around it differ a little
        spread = 0.1 + factor * float(np.nanstd(width))
        elsewhere = math.isfinite(here) and abs(here - stated) > spread
        if elsewhere or not np.nanmin(limit) - spread <= stated <= np.nanmax(limit) + spread:
            agrees = False
            continue
        lines[level] = (s, limit)
    return lines, agrees
