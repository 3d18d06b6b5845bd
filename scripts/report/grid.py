"""A scan seen from above: scattered points on a regular grid, and the picture of it."""
import numpy as np
from matplotlib.cm import ScalarMappable, cividis
from matplotlib.colors import LinearSegmentedColormap, Normalize

LARGEST_GRID = 1600  # cells along a side: more than a page resolves
HEIGHTS = LinearSegmentedColormap.from_list("heights", cividis(np.linspace(0.42, 1.0, 128)))  # dark = low: survives grey


class Grid:
    """Rows along y, columns along x; NaN where there is no point."""

    def __init__(self, x, y, good):
        self.good = good
        self.left, self.right = _range(x[good])
        self.near, self.far = _range(y[good])
        step_x = max(2.0 * _spacing(x, 1), (self.right - self.left) / LARGEST_GRID)
        step_y = max(1.02 * _spacing(y, 0), (self.far - self.near) / LARGEST_GRID)
        self.columns = max(int((self.right - self.left) / step_x), 1)
        self.rows = max(int((self.far - self.near) / step_y), 1)
        self.dx, self.dy = (self.right - self.left) / self.columns, (self.far - self.near) / self.rows
        column = np.clip(((x[good] - self.left) / self.dx).astype(np.int64), 0, self.columns - 1)
        row = np.clip(((y[good] - self.near) / self.dy).astype(np.int64), 0, self.rows - 1)
        self.index = row * self.columns + column

    def extent(self):
        return self.left, self.right, self.near, self.far

    def mean(self, values):
        """Mean of a field that is organised as the scan, single empty lines closed."""
        values = values[self.good].astype(float)
        known = np.isfinite(values)
        size = self.rows * self.columns
        sums = np.bincount(self.index[known], values[known], size)
        counts = np.bincount(self.index[known], minlength=size)
        with np.errstate(invalid="ignore", divide="ignore"):
            means = np.where(counts > 0, sums / counts, np.nan)
        return _close_single_gaps(means.reshape(self.rows, self.columns))

    def share(self, mask):
        """Share of a cell's points for which the mask holds; NaN without points."""
        return self.mean(mask.astype(np.float32))

    def sample(self, field, x, y):
        """The field at places, of any shape; NaN outside."""
        with np.errstate(invalid="ignore"):
            column, row = np.floor((x - self.left) / self.dx), np.floor((y - self.near) / self.dy)
            inside = (column >= 0) & (column < self.columns) & (row >= 0) & (row < self.rows)
        column, row = np.where(inside, column, 0).astype(int), np.where(inside, row, 0).astype(int)
        return np.where(inside, field[row, column], np.nan)


def _range(values):
    low, high = float(values.min()), float(values.max())
    return (low, high) if high - low > 1e-3 else (low - 0.05, low + 0.05)


def _spacing(values, axis):
    """Median distance of neighbours [mm]; something drawable for a single row or column."""
    thinned = values[::4] if axis == 1 else values[:, ::8]
    steps = np.abs(np.diff(thinned, axis=axis))
    steps = steps[np.isfinite(steps) & (steps > 1e-4)]
    return float(np.median(steps)) if steps.size else 0.1


def _close_single_gaps(field):
    """Fills a cell between two full ones: rows need not come at an even pitch."""
    for axis in (0, 1):
        if field.shape[axis] < 3:
            continue
        inner = np.moveaxis(field, axis, 0)[1:-1]
        between = 0.5 * (np.moveaxis(field, axis, 0)[:-2] + np.moveaxis(field, axis, 0)[2:])
        inner[...] = np.where(np.isnan(inner), between, inner)
    return field


def smooth(field, passes=1):
    """Means over 3 x 3 cells, holes left out; what a hillshade needs of a noisy surface."""
    for _ in range(passes):
        known = np.isfinite(field)
        padded = np.pad(np.where(known, field, 0.0), 1, mode="edge")
        weight = np.pad(known.astype(float), 1, mode="edge")
        sums, counts = np.zeros(field.shape), np.zeros(field.shape)
        for i in range(3):
            for j in range(3):
                window = (slice(i, i + field.shape[0]), slice(j, j + field.shape[1]))
                sums += padded[window]
                counts += weight[window]
        field = np.where(known, sums / np.maximum(counts, 1.0), np.nan)
    return field


def hillshade(field, dx, dy, exaggeration=1.0):
    """Light from the upper left, 0..1; holes are 0.5."""
    filled = np.where(np.isfinite(field), field, np.nanmedian(field)) * exaggeration
    slope_y = np.gradient(filled, dy, axis=0) if field.shape[0] > 1 else np.zeros(field.shape)
    slope_x = np.gradient(filled, dx, axis=1) if field.shape[1] > 1 else np.zeros(field.shape)
    light = np.array([-0.45, 0.45, 0.77])
    return np.clip((-slope_x * light[0] - slope_y * light[1] + light[2]) / np.sqrt(1 + slope_x ** 2 + slope_y ** 2), 0, 1)


def colours_of(field, colour_map=HEIGHTS, percentiles=(0.2, 99.8)):
    """The scale of a field."""
    low, high = np.nanpercentile(field, percentiles) if np.isfinite(field).any() else (0.0, 1.0)
    if not high - low > 1e-6:
        low, high = low - 0.05, low + 0.05
    scale = ScalarMappable(Normalize(low, high), colour_map)
    scale.set_array([])
    return scale


def shaded(field, scale, grid, strength=0.6):
    """RGB picture of a field in the scale's colours, shaded; holes white."""
    if not np.isfinite(field).any():
        return np.ones(field.shape + (3,))
    picture = scale.to_rgba(np.where(np.isfinite(field), field, scale.norm.vmin))[..., :3]
    shade = np.maximum(hillshade(smooth(field, 2), grid.dx, grid.dy, 2.0)[..., None], 0.3)
    picture = np.clip(picture * (1.0 + strength * (shade - 0.77)), 0.0, 1.0)
    picture[~np.isfinite(field)] = 1.0
    return picture
