"""The figures of a weld's report, as bytes of PNG or SVG."""
import numpy as np

from report import along, plan, style
from report.cut import Cut
from report.drawing import Drawing
from report.grid import colours_of, shaded
from report.relief import View, exaggeration_for, render

PLOTS = (("undercut_*_mm", "undercut", "undercut [mm]"), ("toe_angle_*_deg", "toe_angle", "toe angle [°]"))

TALLEST = 4.3  # of a cross-section: two of them find room on a page [in]


def framed(figure, width, height, box):
    """Axes at (left, bottom, width, height) in inches."""
    return figure.add_axes([box[0] / width, box[1] / height, box[2] / width, box[3] / height])


def map_figure(folder, draw, wide):
    """A map drawn by draw(figure, axes, folder), over the page or half of it."""
    width = style.PAGE_WIDTH if wide else 0.5 * style.PAGE_WIDTH
    shape = plan.Plan(folder.grid)
    inner = width - 1.15  # the axes' names at the left, those of the colours at the right
    tall = shape.height(inner)
    height = tall + (0.85 if wide else 1.0)
    figure = style.page(height, width)
    axes = framed(figure, width, height, (0.5, height - tall - 0.08, inner, tall))
    draw(figure, axes, folder, 7 if wide else 3)
    return style.png(figure, 170 if wide else 240)


class Relief:
    """The block, rendered once, drawn where it is wanted."""

    def __init__(self, folder):
        grid, heights = folder.grid, folder.heights
        self.grid = grid
        azimuth = -62.0 if plan.Plan(grid).lying else -28.0  # a long scan runs to the right, a short one away
        self.view = View(azimuth, exaggeration=exaggeration_for(heights, grid.extent()))
        picture = shaded(heights, colours_of(heights), grid, 1.0)
        self.image, self.extent = render(heights, picture, grid, self.view)
        self.ratio = (self.extent[3] - self.extent[2]) / (self.extent[1] - self.extent[0])

    def draw(self, axes):
        axes.imshow(self.image, origin="lower", extent=self.extent, interpolation="bilinear")
        axes.set_aspect("equal")
        axes.axis("off")

    def png(self):
        height = min(style.PAGE_WIDTH * 0.86 * self.ratio, 4.4)
        figure = style.page(height, min(style.PAGE_WIDTH, height / self.ratio))
        self.draw(figure.add_axes([0, 0, 1, 1]))
        return style.png(figure)


def section_figure(folder, index):
    cut = Cut(folder, index)
    figure = style.page(1.0)
    drawing = Drawing(figure.add_axes([0, 0, 1, 1]), folder, cut)
    ratio = max(drawing.ratio(), 0.15)
    height = min(style.PAGE_WIDTH * ratio, TALLEST)
    figure.set_size_inches(height / ratio, height)
    drawing.draw()
    return style.svg(figure)


def size_figure(folder):
    """Width and height along the weld; and whether the height's limits could be drawn."""
    height = 4.6
    figure = style.page(height)
    upper = framed(figure, style.PAGE_WIDTH, height, (0.6, 2.75, 6.1, 1.5))
    lower = framed(figure, style.PAGE_WIDTH, height, (0.6, 0.45, 6.1, 1.85))
    along.draw_width(upper, folder)
    along.finish(upper, folder)
    agrees, beyond = along.draw_height(lower, folder)
    along.finish(lower, folder, beyond, True)
    return style.svg(figure), agrees


def other_figure(folder):
    """Undercut, toe angle and misalignment, as far as there are any; None if there are none."""
    plots = [(lambda axes, args=args: along.draw_pair(axes, folder, *args)) for args in PLOTS
             if _any(folder, [args[0].replace("*", side) for side in ("left", "right")])]
    if folder.kind == "fillet":
        if _any(folder, ["leg_left_mm", "leg_right_mm"]):
            plots.append(lambda axes: along.draw_pair(axes, folder, "leg_*_mm", "leg", "leg [mm]"))
        if _any(folder, ["throat_mm"]):
            plots.append(lambda axes: along.draw_single(axes, folder, "throat_mm", "throat", "throat [mm]"))
    if _any(folder, ["misalignment_mm"]):
        plots.append(lambda axes: along.draw_single(axes, folder, "misalignment_mm", "misalignment", "misalignment\n[mm]"))
    if not plots:
        return None
    height = 1.65 * len(plots) + 0.5
    figure = style.page(height)
    for i, plot in enumerate(plots):
        axes = framed(figure, style.PAGE_WIDTH, height, (0.6, 0.45 + 1.65 * (len(plots) - 1 - i), 6.1, 1.2))
        along.finish(axes, folder, plot(axes), i == len(plots) - 1)
    return style.svg(figure)


def _any(folder, names):
    return any(np.isfinite(folder.sections.numbers(name)).any() for name in names)
