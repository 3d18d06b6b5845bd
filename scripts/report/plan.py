"""Maps of a weld seen from above, travel to the right or upward, with what was found drawn into them."""
import numpy as np
from matplotlib import patheffects
from matplotlib.colors import to_rgba

from report import style
from report.cloud import UNDERCUT
from report.grid import colours_of, shaded

CIRCLE = 0.22  # diameter of a section's number [in]
OUTLINE = [patheffects.withStroke(linewidth=2.6, foreground="white")]


class Plan:
    """Where x, y of the scan go on the page; a long scan lies on its side, left still left of the travel."""

    def __init__(self, grid):
        self.extent = grid.extent()
        left, right, near, far = self.extent
        self.lying = far - near > right - left
        self.ratio = (right - left) / (far - near) if self.lying else (far - near) / (right - left)

    def wide(self):
        """Fills the width of a page; else another picture has room beside it."""
        return self.lying or self.ratio < 0.45

    def place(self, x, y):
        return (y, x) if self.lying else (x, y)

    def picture(self, image):
        return image.swapaxes(0, 1) if self.lying else image

    def box(self):
        left, right, near, far = self.extent
        return (near, far, left, right) if self.lying else (left, right, near, far)

    def height(self, width, least=1.1, most=4.6):
        """Of axes of that width [in]."""
        return min(max(width * self.ratio, least), most)

    def finish(self, axes):
        box = self.box()
        axes.set_xlim(box[0], box[1])
        axes.set_ylim(*((box[3], box[2]) if self.lying else (box[2], box[3])))  # lying: x points down the page
        true_scale = 0.12 < self.ratio < 1.6
        axes.set_aspect("equal" if true_scale else "auto")
        names = ("y along the stage [mm]", "x across [mm]")
        axes.set_xlabel(names[0] if self.lying else names[1])
        axes.set_ylabel(names[1] if self.lying else names[0])


def draw_map(axes, plan, image):
    axes.imshow(plan.picture(image), origin="lower", extent=plan.box(), interpolation="bilinear", aspect="auto")
    axes.set_facecolor("white")
    plan.finish(axes)


def _line(axes, plan, points, **look):
    if np.isfinite(points[:, 0]).any():
        axes.plot(*plan.place(points[:, 0], points[:, 1]), path_effects=OUTLINE, **look)


def draw_toes(axes, plan, folder):
    left, right = folder.toes()
    _line(axes, plan, left, color=style.INK, linewidth=1.2, label="toes")
    _line(axes, plan, right, color=style.INK, linewidth=1.2)


def crest(folder):
    """The highest point of each section above the chord of its toes: (sections, 2) [mm]."""
    left, right = folder.toes()
    share = np.linspace(0.1, 0.9, 49)
    places = left[:, None, :] + share[None, :, None] * (right - left)[:, None, :]
    chord = folder.height_over_plane(places[..., 0], places[..., 1], places[..., 2])
    above = folder.grid.sample(folder.heights, places[..., 0], places[..., 1]) - chord
    kernel = np.ones(5) / 5.0
    found = np.full((len(left), 2), np.nan)
    for i, row in enumerate(above):
        if np.isfinite(row).sum() > 25:
            smoothed = np.convolve(np.where(np.isfinite(row), row, np.nanmin(row)), kernel, "same")
            found[i] = places[i, int(smoothed.argmax()), :2]
    return _running_median(found, 9)


def _running_median(points, length):
    half = length // 2
    padded = np.pad(points, ((half, half), (0, 0)), mode="edge")
    stack = np.stack([padded[i:i + len(points)] for i in range(length)])
    known = np.isfinite(stack).any(axis=(0, 2))
    result = np.full(points.shape, np.nan)
    result[known] = np.nanmedian(stack[:, known], axis=0)
    return result


def draw_undercut(axes, plan, folder):
    """Cells where the undercut was labelled, dark red."""
    labels = folder.cloud.labels()
    if labels is None or not (labels == UNDERCUT).any():
        return
    share = np.nan_to_num(folder.grid.share(labels == UNDERCUT))
    if not (share > 0.5).any():
        return
    overlay = np.zeros(share.shape + (4,))
    overlay[share > 0.5] = to_rgba(style.ALARM)
    axes.imshow(plan.picture(overlay), origin="lower", extent=plan.box(), interpolation="nearest", aspect="auto")
    plan.finish(axes)
    axes.plot([], [], linestyle="none", marker="s", color=style.ALARM, label="undercut")


def draw_spots(axes, plan, folder):
    kinds = np.array(folder.spots.texts("kind"), dtype=str)
    x, y = folder.spots.numbers("x_mm"), folder.spots.numbers("y_mm")
    for kind, marker in (("pore", "v"), ("spatter", "o")):
        keep = (kinds == kind) & np.isfinite(x) & np.isfinite(y)
        if keep.any():
            axes.plot(*plan.place(x[keep], y[keep]), linestyle="none", marker=marker, markersize=6, markerfacecolor="none",
                      markeredgecolor=style.INK, markeredgewidth=1.1, path_effects=OUTLINE, label=kind)


def draw_places(axes, plan, folder):
    """Where the sections that are shown lie, marked as in a drawing: 1-1, 2-2."""
    left, right = folder.toes()
    circle = circle_size(axes, plan)
    near = circle[0 if plan.lying else 1]
    last, out = -np.inf, 0
    for number, index in enumerate(folder.chosen, 1):
        across = right[index, :2] - left[index, :2]
        middle = 0.5 * (left[index, :2] + right[index, :2])
        out = out + 1 if middle[1] - last < near else 0  # too near to the one before: further out
        last = middle[1]
        aside = 0.35 * across + out % 3 * 1.1 * circle[1 if plan.lying else 0] * across / np.hypot(*across)
        ends = [left[index, :2] - aside, right[index, :2] + aside]
        h, v = plan.place(np.array([e[0] for e in ends]), np.array([e[1] for e in ends]))
        axes.plot(h, v, color=style.INK, linewidth=0.9, linestyle=(0, (9, 2, 2, 2)), path_effects=OUTLINE)
        box = plan.box()
        for end in (0, 1):
            axes.text(np.clip(h[end], box[0] + 0.5 * circle[0], box[1] - 0.5 * circle[0]),
                      np.clip(v[end], box[2] + 0.5 * circle[1], box[3] - 0.5 * circle[1]), str(number), fontsize=8.5, fontweight="bold",
                      ha="center", va="center", clip_on=True,
                      bbox={"boxstyle": "circle,pad=0.18", "facecolor": "white", "edgecolor": style.INK, "linewidth": 0.7})


def draw_other_beads(axes, plan, folder):
    for bead in folder.record.records("other_beads"):
        x, near, far = (1e3 * bead.number(name) for name in ("x", "y_from", "y_to"))
        if np.isfinite([x, near, far]).all():
            h, v = plan.place(np.array([x, x]), np.array([near, far]))
            axes.plot(h, v, color=style.INK, linewidth=1.2, linestyle=(0, (1, 2)), path_effects=OUTLINE, label="other bead")


def height_label(folder):
    return "above the mean plane\nof the base metal [mm]" if folder.levelled else "height z [mm]"


def legend(axes, columns):
    """Under the map: every kind of mark once."""
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles))
    if once:
        axes.apply_aspect()
        axes.legend(list(once.values()), list(once), loc="upper center", bbox_to_anchor=(0.5, -0.37 / axes_height(axes)),
                    ncol=columns, handlelength=2.6, columnspacing=1.6, borderaxespad=0.0)


def circle_size(axes, plan):
    """A section's number along the page and up it [mm]."""
    axes.apply_aspect()
    box, place = plan.box(), axes.get_position()
    scales = ((box[1] - box[0]) / (place.width * axes.figure.get_figwidth()), (box[3] - box[2]) / axes_height(axes))
    return [CIRCLE * scale for scale in (scales if axes.get_aspect() == "auto" else [max(scales)] * 2)]


def axes_height(axes):
    """[in]"""
    return axes.get_position().height * axes.figure.get_figheight()


def colour_bar(figure, axes, scale, label):
    bar = figure.colorbar(scale, ax=axes, fraction=0.025, pad=0.015, aspect=30)
    bar.set_label(label, fontsize=7)
    bar.outline.set_linewidth(0.5)


def height_map(figure, axes, folder, legend_columns=7):
    """The scan, and all that was found on it."""
    plan, scale = Plan(folder.grid), colours_of(folder.heights)
    draw_map(axes, plan, shaded(folder.heights, scale, folder.grid))
    if len(folder.sections):
        draw_undercut(axes, plan, folder)
        draw_toes(axes, plan, folder)
        _line(axes, plan, crest(folder), color=style.INK, linewidth=0.8, linestyle=(0, (4, 2, 1, 2)), label="crest")
        draw_places(axes, plan, folder)
    draw_spots(axes, plan, folder)
    draw_other_beads(axes, plan, folder)
    colour_bar(figure, axes, scale, height_label(folder))
    legend(axes, legend_columns)


def removal_map(figure, axes, folder, legend_columns=7):
    """White = nothing to remove; dark = much."""
    plan = Plan(folder.grid)
    removal = folder.grid.mean(folder.cloud.millimetres("removal"))
    scale = colours_of(removal, "Greys", (0.0, 99.9))
    scale.set_clim(0.0, max(scale.norm.vmax, 0.02) * 1.15)  # so that the highest is not black: toes stay visible
    image = scale.to_rgba(np.nan_to_num(removal))[..., :3]
    image[~np.isfinite(removal)] = (0.80, 0.85, 0.95)
    draw_map(axes, plan, image)
    if len(folder.sections):
        draw_toes(axes, plan, folder)
    colour_bar(figure, axes, scale, "to be removed [mm]")
    legend(axes, legend_columns)
