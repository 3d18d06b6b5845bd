#!/usr/bin/python3
"""Draws a scan seen from above: height as colour, shaded so that ripples and undercuts show."""
import argparse
import os
import sys

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LightSource, Normalize
from matplotlib.figure import Figure

from scan_file import ScanFileError, read_scan

LARGEST_GRID = 4000  # cells along a side, so that a stray point cannot ask for all the memory


def height_map(scan):
    """Mean height on a regular grid [mm], NaN where nothing was measured, and its edges (left, right, near, far) [mm]."""
    x, y, z = (1e3 * scan[name].astype(float) for name in ("x", "y", "z"))
    step_x = 2.0 * _spacing(x, axis=1)
    step_y = 1.02 * _spacing(y, axis=0)  # a little above the rows' pitch: no empty line between two rows
    good = np.isfinite(x) & np.isfinite(y) & np.isfinite(z)
    x, y, z = x[good], y[good], z[good]
    left, right, near, far = x.min(), x.max(), y.min(), y.max()
    columns = int(min(max((right - left) / step_x, 1), LARGEST_GRID))
    rows = int(min(max((far - near) / step_y, 1), LARGEST_GRID))
    edges = [np.linspace(near, far, rows + 1), np.linspace(left, right, columns + 1)]
    sums = np.histogram2d(y, x, bins=edges, weights=z)[0]
    counts = np.histogram2d(y, x, bins=edges)[0]
    with np.errstate(invalid="ignore"):
        heights = np.where(counts > 0, sums / counts, np.nan)
    return _close_single_gaps(heights), (left, right, near, far)


def _spacing(values, axis):
    """Median distance of neighbours [mm]; something drawable for a single row or column."""
    steps = np.abs(np.diff(values, axis=axis))
    steps = steps[np.isfinite(steps) & (steps > 1e-4)]
    return float(np.median(steps)) if steps.size else 0.25


def _close_single_gaps(heights):
    """Fills a row or column of the grid that lies empty between two full ones: rows need not come at an even pitch."""
    for axis in (0, 1):
        before, after = np.roll(heights, 1, axis), np.roll(heights, -1, axis)
        heights = np.where(np.isnan(heights), 0.5 * (before + after), heights)
    return heights


def draw(heights, extent, title, path):
    """Writes the picture, whole or not at all."""
    low, high = np.nanpercentile(heights, [0.2, 99.8])
    if not high > low:
        low, high = low - 0.1, low + 0.1
    colours = ScalarMappable(Normalize(low, high), "viridis")
    picture = colours.to_rgba(heights)[..., :3]
    filled = np.where(np.isnan(heights), np.nanmedian(heights), heights)
    left, right, near, far = extent
    picture = LightSource(azdeg=315, altdeg=40).shade_rgb(
        picture, filled, fraction=1.0, blend_mode="soft", vert_exag=2.0,
        dx=(right - left) / heights.shape[1], dy=(far - near) / heights.shape[0])
    picture[np.isnan(heights)] = 1.0

    figure = Figure(figsize=(9.0, 7.0), dpi=120, layout="constrained") if _has_layout() else Figure(figsize=(9.0, 7.0), dpi=120)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.imshow(picture, origin="lower", extent=extent, interpolation="bilinear", aspect="equal")
    axes.set_xlabel("x across the weld [mm]")
    axes.set_ylabel("y along the stage [mm]")
    axes.set_title(title)
    figure.colorbar(colours, ax=axes, shrink=0.8, label="height z [mm]")
    temporary = path + ".part"
    figure.savefig(temporary, format="png")
    os.replace(temporary, path)


def _has_layout():
    """Figure(layout=) came with matplotlib 3.5; Ubuntu 20.04 has 3.1."""
    from matplotlib import __version__
    return tuple(int(part) for part in __version__.split(".")[:2]) >= (3, 5)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", help="scan.pcd as save_scan and scan_bag write it")
    parser.add_argument("picture", help="PNG to write")
    parser.add_argument("--title", default="", help="stands above the picture")
    arguments = parser.parse_args()
    try:
        scan = read_scan(arguments.scan)
        if not np.isfinite(scan["z"]).any():
            raise ScanFileError("%s: holds no point" % arguments.scan)
        heights, extent = height_map(scan)
        draw(heights, extent, arguments.title, arguments.picture)
    except ScanFileError as error:
        print(error, file=sys.stderr)
        return 1
    except OSError as error:
        print("%s: cannot be written: %s" % (arguments.picture, error.strerror), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
