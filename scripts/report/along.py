"""What was measured along the weld, with bands of two standard deviations and the limits (the paper's Fig. 11)."""
import numpy as np

from report import style
from report.limits import constant_limits, height_limits
from report.plan import axes_height

LOOKS = {"left": {"color": style.LEFT, "linestyle": "-"}, "right": {"color": style.RIGHT, "linestyle": (0, (4, 1.2))}}

STRIP = 0.16  # for a line of text above the values [in]


def _with_breaks(s, *columns):
    """NaN put between sections that lie further apart than three usual steps: no line across a hole."""
    steps = np.diff(s)
    usual = np.median(steps[np.isfinite(steps)]) if np.isfinite(steps).any() else 0.0
    gaps = np.nonzero(steps > 3.0 * usual + 1e-9)[0] + 1
    return [np.insert(values.astype(float), gaps, np.nan) for values in (s,) + columns]


def curve(axes, table, name, label, **look):
    """The value and its band; True if there was any."""
    value, sigma = table.quantity(name)
    s = table.numbers("s_mm")
    known = np.isfinite(s) & np.isfinite(value)
    if not known.any():
        return False
    s, value, sigma = _with_breaks(s, np.where(known, value, np.nan), sigma)
    look = dict({"color": style.INK, "linewidth": 1.0}, **look)
    lonely = known.sum() < 3
    axes.plot(s, value, label=label, marker="o" if lonely else None, markersize=3, **look)
    band = np.where(np.isfinite(sigma), 2 * sigma, 0.0)
    axes.fill_between(s, value - band, value + band, color=look["color"], alpha=0.22, linewidth=0)
    return True


def _data_range(axes, table, names, also=()):
    """Limits of the y axis: the values with their bands, but no wild sigma."""
    values = [values[np.isfinite(values)] for values in [table.numbers(name) for name in names] + list(also)]
    values = np.concatenate(values) if values else np.empty(0)
    if not values.size:
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    sigmas = [table.quantity(name)[1] for name in names]
    sigmas = np.concatenate([sigma[np.isfinite(sigma)] for sigma in sigmas]) if sigmas else np.empty(0)
    pad = max(0.08 * (high - low), 3.0 * float(np.median(sigmas)) if sigmas.size else 0.0, 0.02 * abs(high), 1e-3)
    return low - pad, high + pad


def _label_level(axes, s, y, level):
    axes.annotate(level, (s, y), xytext=(3, 0), textcoords="offset points", fontsize=7.5, fontweight="bold", va="center",
                  annotation_clip=False)


def _draw_levels(axes, lines, low, high):
    """Lines {level: (s, limit)} as far as they help: up to the first that lies well beyond the values."""
    shown, beyond = [], []
    span = high - low
    for level, (s, limit) in lines.items():
        middle = float(np.nanmedian(limit))
        if low - 1.2 * span - 0.5 <= middle <= high + 1.2 * span + 0.5:
            shown.append((level, s, limit))
        else:
            beyond.append("%s %.3g" % (level, middle))
    for level, s, limit in shown:
        axes.plot(s, limit, color=style.ALARM, linewidth=0.9, linestyle=style.LEVEL_LINES[level])
        known = np.isfinite(limit)
        _label_level(axes, s[known][-1], limit[known][-1], level)
        low, high = min(low, float(np.nanmin(limit)) - 0.06 * span), max(high, float(np.nanmax(limit)) + 0.06 * span)
    return low, high, beyond


def _gauge(axes, gauge, values, label="gauge"):
    known = np.isfinite(gauge.s) & np.isfinite(values)
    if known.any():
        half = np.nan_to_num(gauge.resolution[known]) / 2
        axes.errorbar(gauge.s[known], values[known], yerr=half, linestyle="none", marker="s", markersize=3.6, color=style.ALARM,
                      markerfacecolor="white", markeredgewidth=0.9, elinewidth=0.8, capsize=2, label=label, zorder=4)


def draw_width(axes, folder):
    curve(axes, folder.sections, "width_mm", "width b")
    also = []
    if folder.gauge:
        _gauge(axes, folder.gauge, folder.gauge.width)
        also = [folder.gauge.width]
    axes.set_ylim(*_data_range(axes, folder.sections, ["width_mm"], also))
    axes.set_ylabel("width b [mm]")


def draw_height(axes, folder):
    table = folder.sections
    what = "convexity" if folder.kind == "fillet" else "reinforcement"
    curve(axes, table, "reinforcement_mm", what + " h above the chord")
    names, also = ["reinforcement_mm"], []
    if folder.kind != "fillet":
        for side in ("left", "right"):
            values = table.numbers("height_%s_mm" % side)
            apart = np.abs(values - table.numbers("reinforcement_mm"))
            if np.isfinite(apart).any() and np.nanmedian(apart) > 0.05:
                curve(axes, table, "height_%s_mm" % side, "above the %s plate" % side, linewidth=0.7, **LOOKS[side])
                names.append("height_%s_mm" % side)
    if folder.gauge:
        _gauge(axes, folder.gauge, folder.gauge.height)
        also = [folder.gauge.height]
    low, high = _data_range(axes, table, names, also)
    lines, known = height_limits(folder)
    low, high, beyond = _draw_levels(axes, lines, low, high)
    axes.set_ylim(low, high)
    axes.set_ylabel("height h [mm]")
    return known, beyond


def draw_pair(axes, folder, stem, imperfection, ylabel):
    """Left and right, with limits that are the same everywhere."""
    names = [stem.replace("*", side) for side in ("left", "right")]
    for side, name in zip(("left", "right"), names):
        curve(axes, folder.sections, name, side, **LOOKS[side])
    return _finish_constant(axes, folder, names, imperfection, ylabel)


def draw_single(axes, folder, name, imperfection, ylabel):
    curve(axes, folder.sections, name, None)
    return _finish_constant(axes, folder, [name], imperfection, ylabel)


def _finish_constant(axes, folder, names, imperfection, ylabel):
    low, high = _data_range(axes, folder.sections, names)
    low, high, beyond = _draw_levels(axes, constant_limits(folder, imperfection), low, high)
    axes.set_ylim(low, high)
    axes.set_ylabel(ylabel)
    return beyond


def finish(axes, folder, beyond=(), last=False):
    """Frame, places of the drawn sections, legend above; limits that lie outside named in a strip of their own."""
    axes.grid(True)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    s = folder.sections.numbers("s_mm")
    if np.isfinite(s).any():
        low, high = float(np.nanmin(s)), float(np.nanmax(s))
        pad = 0.01 * (high - low) or 1.0
        axes.set_xlim(low - pad, high + pad)
    for number, index in enumerate(folder.chosen, 1):
        axes.axvline(s[index], color=style.GREY, linewidth=0.5, linestyle=(0, (9, 2, 2, 2)), zorder=0)
        axes.annotate(str(number), (s[index], 1.0), xycoords=("data", "axes fraction"), xytext=(0, 1.5),
                      textcoords="offset points", fontsize=6.5, ha="center", color=style.GREY)
    handles, labels = axes.get_legend_handles_labels()
    if beyond:
        low, high = axes.get_ylim()
        axes.set_ylim(low, low + (high - low) / max(1.0 - STRIP / axes_height(axes), 0.5))
        axes.annotate("limits outside: " + ", ".join(beyond), (1.0, 1.0), xycoords="axes fraction", xytext=(-2, -2),
                      textcoords="offset points", fontsize=6.5, ha="right", va="top", color=style.ALARM,
                      bbox={"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none"})
    if len(handles) > 1:
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0 + 0.13 / axes_height(axes)), ncol=len(handles),
                    handlelength=2.2, borderaxespad=0.1)
    if last:
        axes.set_xlabel("s along the weld [mm]")
    else:
        axes.tick_params(labelbottom=False)
