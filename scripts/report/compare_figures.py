"""The figures of a comparison before and after grinding."""
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, to_rgba

from report import plan, style
from report.grid import colours_of, shaded
from report.weld_figures import framed

# light in the middle, so that a grey printer shows how far off a place is; below the target it is hatched as well
REST = LinearSegmentedColormap.from_list("rest", ["#67001f", "#d6604d", "#f7f7f7", "#4393c3", "#053061"])
TITLES = {"before": "before, height z [mm]", "after": "after, height z [mm]", "removed": "removed [mm]",
          "remaining": "remaining above the target [mm]"}


def _scale(folder, name):
    field = folder.maps[name]
    if name in ("before", "after"):
        both = np.concatenate([folder.maps["before"].ravel(), folder.maps["after"].ravel()])
        return colours_of(both)
    if name == "removed":
        scale = colours_of(field, "Greys", (0.5, 99.9))
        scale.set_clim(min(scale.norm.vmin, 0.0), 1.15 * max(scale.norm.vmax, 0.02))
        return scale
    scale = colours_of(field, REST)
    known = np.abs(field[np.isfinite(field)])
    reach = max(float(np.percentile(known, 99.5)) if known.size else 0.0, 1.5 * folder.limit)
    scale.set_clim(-reach, reach)
    return scale


def draw_map(figure, axes, folder, name):
    shape, scale, field = plan.Plan(folder.grid), _scale(folder, name), folder.maps[name]
    if name in ("before", "after"):
        image = shaded(field, scale, folder.grid)
    else:
        image = scale.to_rgba(np.nan_to_num(field))[..., :3]
        image[~np.isfinite(field)] = (0.85, 0.85, 0.85)
    plan.draw_map(axes, shape, image)
    if name == "remaining":
        _draw_over_ground(axes, shape, folder)
    plan.colour_bar(figure, axes, scale, "")
    axes.set_title(TITLES[name], loc="left", fontsize=8)


def _draw_over_ground(axes, shape, folder):
    """Places that were ground below the target by more than the limit: dots, and numbers of the spots."""
    low = folder.deep
    if low.any():
        overlay = np.zeros(low.shape + (4,))
        checks = (np.add.outer(np.arange(low.shape[0]), np.arange(low.shape[1])) // 2) % 2 == 0
        overlay[low & checks] = to_rgba(style.INK)
        axes.imshow(shape.picture(overlay), origin="lower", extent=shape.box(), interpolation="nearest", aspect="auto")
        shape.finish(axes)
    for number, spot in enumerate(folder.spots[:20], 1):
        x, y = 1e3 * spot.number("x"), 1e3 * spot.number("y")
        if np.isfinite([x, y]).all():
            h, v = shape.place(x, y)
            axes.annotate(str(number), (h, v), xytext=(9, 9), textcoords="offset points", fontsize=7.5, fontweight="bold",
                          ha="center", va="center", annotation_clip=False, arrowprops={"arrowstyle": "-", "linewidth": 0.7},
                          bbox={"boxstyle": "circle,pad=0.18", "facecolor": "white", "edgecolor": style.INK, "linewidth": 0.7})


def maps_layout(folder, width):
    """Height of the four maps on a page of that width [in], and the place of each: left, bottom, width, height."""
    shape = plan.Plan(folder.grid)
    columns = 1 if shape.lying and shape.ratio < 0.35 else 2
    inner = width / columns - 1.0
    tall = shape.height(inner, 0.7, 3.2)
    rows = 4 // columns
    step = tall + 0.72
    places = [((i % columns) * width / columns + 0.45, (rows - 1 - i // columns) * step + 0.42, inner, tall) for i in range(4)]
    return rows * step + 0.05, places


def maps_figure(folder):
    height, places = maps_layout(folder, style.PAGE_WIDTH)
    figure = style.page(height)
    for name, place in zip(TITLES, places):
        draw_map(figure, framed(figure, style.PAGE_WIDTH, height, place), folder, name)
    return style.png(figure)


def draw_profile(axes, folder, share, legend):
    x, before, after, target, y = folder.profile(share)
    axes.fill_between(x, np.minimum(after, before), before, facecolor="#d9d9d9", edgecolor="none", linewidth=0, label="removed")
    axes.plot(x, before, color=style.GREY, linewidth=0.9, linestyle=(0, (4, 1.5)), label="before")
    axes.plot(x, after, color=style.INK, linewidth=1.1, label="after")
    axes.plot(x, target, color=style.ALARM, linewidth=0.9, linestyle=(0, (10, 2, 2, 2)), label="target")
    axes.set_ylabel("z [mm]")
    axes.set_title("y = %.1f mm" % y, loc="right", fontsize=7.5)
    if legend:
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=4, borderaxespad=0.1)
    _plain(axes)


def _plain(axes):
    axes.grid(True)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def profiles_figure(folder, shares=(0.2, 0.5, 0.8)):
    height = 1.55 * len(shares) + 0.5
    figure = style.page(height)
    for i, share in enumerate(shares):
        axes = framed(figure, style.PAGE_WIDTH, height, (0.6, 0.45 + 1.55 * (len(shares) - 1 - i), 6.2, 1.15))
        draw_profile(axes, folder, share, i == 0)
    axes.set_xlabel("x across [mm]")
    return style.svg(figure)


def draw_areas(axes, folder):
    """Removed and remaining, section by section."""
    for name, look in (("removed", {"color": style.INK}), ("remaining", {"color": style.LEFT, "linestyle": (0, (4, 1.5))})):
        axes.plot(*folder.along(name), label=name, **look)
    axes.set_ylabel("area [mm²]")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2, borderaxespad=0.1)
    _plain(axes)


def draw_lowest(axes, folder):
    axes.plot(*folder.lowest(), color=style.INK)
    axes.axhline(-folder.limit, color=style.ALARM, linewidth=0.9, linestyle=(0, (6, 2)))
    axes.annotate("limit", (1.0, -folder.limit), xycoords=("axes fraction", "data"), xytext=(2, 0), textcoords="offset points",
                  fontsize=7, va="center", annotation_clip=False)
    axes.set_ylabel("ground below\nthe target [mm]")
    axes.set_xlabel("y along the stage [mm]")
    _plain(axes)


def along_figure(folder):
    figure = style.page(3.5)
    draw_areas(framed(figure, style.PAGE_WIDTH, 3.5, (0.65, 2.0, 5.95, 1.2)), folder)
    draw_lowest(framed(figure, style.PAGE_WIDTH, 3.5, (0.65, 0.45, 5.95, 1.2)), folder)
    return style.svg(figure)
