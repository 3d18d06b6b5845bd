"""The scan as a solid block seen at an angle: a parallel projection of the height map, drawn pixel by pixel."""
import math

import numpy as np

WIDTH, SUPER = 1200, 2  # of the picture [px]; a pixel is the mean of 2 x 2
WALLS = ((0.60, 0.62, 0.66), (0.47, 0.49, 0.53))  # the two sides of the block that face the viewer
HOLE = (0.88, 0.88, 0.88)


class View:
    """Turns the block by `azimuth` about its vertical axis and looks down at `elevation`."""

    def __init__(self, azimuth_deg, elevation_deg=36.0, exaggeration=1.0):
        self.cos, self.sin = math.cos(math.radians(azimuth_deg)), math.sin(math.radians(azimuth_deg))
        self.up, self.away = math.cos(math.radians(elevation_deg)), math.sin(math.radians(elevation_deg))
        self.exaggeration = exaggeration

    def turned(self, x, y):
        """Across the view, away from the viewer."""
        return x * self.cos - y * self.sin, x * self.sin + y * self.cos

    def back(self, across, away):
        return across * self.cos + away * self.sin, -across * self.sin + away * self.cos

    def project(self, x, y, z):
        """Where a point lies in the picture [mm of the picture]."""
        across, away = self.turned(x, y)
        return across, away * self.away + z * self.exaggeration * self.up


def exaggeration_for(field, extent):
    """1, 2, 3 or 5: flat things are drawn higher than they are."""
    size = math.sqrt((extent[1] - extent[0]) * (extent[3] - extent[2]))
    relief = np.nanpercentile(field, 99.8) - np.nanpercentile(field, 0.2)
    for factor, least in ((1.0, 0.10), (2.0, 0.05), (3.0, 0.02)):
        if relief > least * size:
            return factor
    return 5.0


def render(field, picture, grid, view):
    """RGB picture of the block and its extent in View.project's millimetres; white where it is not.

    field: heights [mm], NaN = hole; picture: RGB of the same shape. Seen from the front, a column of pixels shows for
    each height in the picture the first surface point that rises to it: the running maximum along the line of sight.
    """
    filled = np.where(np.isfinite(field), field, np.nanpercentile(field, 5))
    base = float(np.nanpercentile(field, 0.2)) - 0.06 * (grid.right - grid.left)
    corners = [view.project(x, y, z) for x in (grid.left, grid.right) for y in (grid.near, grid.far)
               for z in (base, float(filled.max()))]
    left, right = min(c[0] for c in corners), max(c[0] for c in corners)
    low, high = min(c[1] for c in corners), max(c[1] for c in corners)
    pixel = (right - left) / (WIDTH * SUPER)
    if (high - low) / pixel > 2.0 * WIDTH * SUPER:
        pixel = (high - low) / (2.0 * WIDTH * SUPER)
    columns, rows = int((right - left) / pixel), int((high - low) / pixel)
    image = np.ones((rows // SUPER, columns // SUPER, 3), np.float32)
    block = _Block(filled, np.where(np.isfinite(field)[..., None], picture, HOLE), grid, view)
    heights = low + pixel * (np.arange(rows) + 0.5)
    for first in range(0, columns - SUPER + 1, 256):  # in strips, for the memory
        count = min(256, columns - first) // SUPER * SUPER
        across = left + pixel * (first + np.arange(count) + 0.5)
        strip = block.strip(across, heights, base)
        strip = strip[:rows // SUPER * SUPER]
        strip = 0.25 * (strip[::2, ::2] + strip[1::2, ::2] + strip[::2, 1::2] + strip[1::2, 1::2])
        image[:, first // SUPER:(first + count) // SUPER] = strip
    return _trimmed(image, (left, right, low, high))


def _trimmed(image, extent):
    """Without the white above the block."""
    used = np.nonzero((image < 0.999).any(axis=(1, 2)))[0]
    last = min(used[-1] + 4, len(image)) if len(used) else len(image)
    left, right, low, high = extent
    return image[:last], (left, right, low, low + (high - low) * last / len(image))


class _Block:
    """Heights without holes, and their colours, under a view."""

    def __init__(self, field, picture, grid, view):
        self.field, self.picture, self.grid, self.view = field, picture, grid, view

    def strip(self, across, heights, base):
        """Pixels of some columns, the lowest first."""
        grid, view = self.grid, self.view
        corners = [view.turned(x, y)[1] for x in (grid.left, grid.right) for y in (grid.near, grid.far)]
        step = min(grid.dx, grid.dy)
        away = np.arange(min(corners) - step, max(corners) + step, step)
        x, y = view.back(across[:, None], away[None, :])
        inside = (x >= grid.left) & (x < grid.right) & (y >= grid.near) & (y < grid.far)
        z = np.where(inside, _bilinear(self.field, grid, x, y), 0.0)
        seen = np.where(inside, away * view.away + z * view.exaggeration * view.up, -1e9)
        entry = inside.argmax(axis=1)  # where the line of sight meets the block
        some = inside.any(axis=1)
        horizon = np.maximum.accumulate(seen, axis=1)
        steps = np.arange(len(across))[:, None] * 1e6  # makes one rising array of all columns
        place = np.searchsorted(np.clip(horizon + steps, -4e5 + steps, None).ravel(),
                                (heights[None, :] + steps).ravel()).reshape(len(across), -1)
        place -= np.arange(len(across))[:, None] * len(away)
        beyond = place >= len(away)
        place = np.minimum(place, len(away) - 1)
        colour = _colours(self.picture, grid, np.take_along_axis(x, place, 1), np.take_along_axis(y, place, 1))
        foot = (away[entry] * view.away + base * view.exaggeration * view.up)[:, None]
        top = np.take_along_axis(seen, entry[:, None], 1)
        wall = (heights[None, :] >= foot) & (heights[None, :] <= top)
        entry_x = x[np.arange(len(across)), entry]
        near_side = np.minimum(np.abs(entry_x - grid.left), np.abs(entry_x - grid.right)) > 1.5 * step
        colour[wall] = np.where(near_side[:, None, None], WALLS[0], WALLS[1])[np.nonzero(wall)[0], 0]
        colour[beyond | ~some[:, None] | (heights[None, :] < foot)] = 1.0
        return colour.transpose(1, 0, 2)


def _bilinear(field, grid, x, y):
    column = np.clip((x - grid.left) / grid.dx - 0.5, 0, grid.columns - 1.001)
    row = np.clip((y - grid.near) / grid.dy - 0.5, 0, grid.rows - 1.001)
    if grid.columns < 2 or grid.rows < 2:
        return field[row.round().astype(int), column.round().astype(int)]
    i, j = row.astype(np.int32), column.astype(np.int32)
    a, b = row - i, column - j
    return ((1 - a) * ((1 - b) * field[i, j] + b * field[i, j + 1])
            + a * ((1 - b) * field[i + 1, j] + b * field[i + 1, j + 1]))


def _colours(picture, grid, x, y):
    column = np.clip((x - grid.left) / grid.dx, 0, grid.columns - 1).astype(np.int32)
    row = np.clip((y - grid.near) / grid.dy, 0, grid.rows - 1).astype(np.int32)
    return picture[row, column].astype(np.float32)
