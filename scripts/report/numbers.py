"""Numbers as a certificate has them: rounded to two digits of their expanded uncertainty (k = 2), to a micrometre at most."""
import math

import numpy as np

NONE = "–"
NOT_MEASURED = "not measured"
DECISIONS = {"pass": "✓ pass", "fail": "✗ FAIL", "undecided": "? undecided", "not_judged": "not judged", "": "not measured"}
IMPERFECTIONS = {
    "excess_weld_metal": "excess weld metal", "convexity": "excessive convexity", "undercut": "undercut",
    "misalignment": "linear misalignment", "toe_angle": "incorrect weld toe", "incomplete_fill": "incompletely filled groove",
    "surface_pore": "surface pore", "weld": "the weld as a whole"}
KINDS = {"butt": "butt weld", "fillet": "fillet weld", "bead_on_plate": "bead on plate", "none": "no weld"}


def decimals_for(expanded):
    """Of a value with this expanded uncertainty."""
    if not (math.isfinite(expanded) and expanded > 0):
        return 3
    return min(max(1 - int(math.floor(math.log10(expanded))), 0), 3)


def with_uncertainty(value, sigma, unit="", none=NOT_MEASURED):
    """`12.034 ± 0.021 mm`: the value and two standard deviations."""
    if not math.isfinite(value):
        return none
    suffix = " " + unit if unit else ""
    if not math.isfinite(sigma):
        return "%.3f%s (uncertainty unknown)" % (value, suffix)
    decimals = decimals_for(2 * sigma)
    return "%.*f ± %.*f%s" % (decimals, value, decimals, 2 * sigma, suffix)


def fixed(value, decimals, unit="", none=NONE):
    if not math.isfinite(value):
        return none
    return "%.*f%s" % (decimals, value + 0.0, " " + unit if unit else "")


def scale_and_unit(name):
    """From SI to what people read, by a quantity's name."""
    if "angle" in name or "yaw" in name:
        return 180 / math.pi, "°"
    if "volume" in name:
        return 1e9, "mm³"
    if "area" in name:
        return 1e6, "mm²"
    return 1e3, "mm"


def readable(name):
    return name.replace("_", " ")


def readable_date(text):
    return text.replace("T", " ").replace("Z", " UTC") if text else NONE


def at(s, values, places):
    """Values along the weld interpolated at places; NaN beyond a hole of more than three usual steps."""
    known = np.isfinite(s) & np.isfinite(values)
    result = np.full(len(places), np.nan)
    if known.sum() < 2:
        return result
    order = np.argsort(s[known], kind="stable")
    s, values = s[known][order], values[known][order]
    step = np.median(np.diff(s))
    for i, place in enumerate(places):
        if not (s[0] - step <= place <= s[-1] + step):
            continue
        after = min(max(int(np.searchsorted(s, place)), 1), len(s) - 1)
        if s[after] - s[after - 1] <= 3.0 * step + 1e-9:
            result[i] = np.interp(place, s[after - 1:after + 1], values[after - 1:after + 1])
    return result
