#!/usr/bin/python3
"""Tells whether a screenshot of rviz shows a cloud: coloured pixels, and hues, in its 3D panel.

The panel is found by its background, which rviz/weld_profiler.rviz sets and nothing else on the screen has; the image
panels beside it do not count. Exit status: 0 shows a cloud, 1 does not, 2 usage.
"""
import argparse
import sys

import numpy as np
from matplotlib.colors import rgb_to_hsv
from matplotlib.image import imread

BACKGROUND = np.array([38, 40, 44])  # Background Color of rviz/weld_profiler.rviz
HUE_BINS = 72                        # one hue = 5 degrees
PIXELS_A_HUE = 20                    # fewer are anti-aliased edges, not a surface of that hue
LEAST_SATURATION = 0.3
LEAST_VALUE = 0.2


def find_panel(picture):
    """Rows and columns of the bounding box of the background's colour; None if it is nowhere."""
    background = np.all(picture == BACKGROUND, axis=2)
    # a line of the panel has many background pixels; a chance hit elsewhere does not stretch the box
    rows = np.flatnonzero(background.sum(axis=1) > 20)
    columns = np.flatnonzero(background.sum(axis=0) > 20)
    if rows.size == 0 or columns.size == 0:
        return None
    return slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)


def count_colours(panel):
    """Number of coloured pixels, and of hues that have enough of them."""
    hsv = rgb_to_hsv(panel / 255.0)
    coloured = (hsv[..., 1] >= LEAST_SATURATION) & (hsv[..., 2] >= LEAST_VALUE)
    hues = np.floor(hsv[..., 0][coloured] * HUE_BINS).astype(int) % HUE_BINS
    counts = np.bincount(hues, minlength=HUE_BINS)
    return int(coloured.sum()), int((counts >= PIXELS_A_HUE).sum())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", help="screenshot, PNG")
    parser.add_argument("--pixels", type=int, default=5000, help="least number of coloured pixels (default 5000)")
    parser.add_argument("--hues", type=int, default=20, help="least number of hues (default 20)")
    arguments = parser.parse_args()
    try:
        picture = imread(arguments.picture)
    except (OSError, SyntaxError, ValueError) as error:
        print("%s: cannot be read: %s" % (arguments.picture, error), file=sys.stderr)
        return 1
    if picture.ndim != 3:
        print("%s: has no colours, must be an RGB screenshot" % arguments.picture, file=sys.stderr)
        return 1
    if picture.dtype != np.uint8:
        picture = np.round(picture * 255.0).astype(np.uint8)
    picture = picture[..., :3]
    place = find_panel(picture)
    if place is None:
        print("%s: no 3D panel with background %s" % (arguments.picture, tuple(BACKGROUND)), file=sys.stderr)
        return 1
    pixels, hues = count_colours(picture[place])
    print("%s: %d coloured pixels in %d hues in the 3D panel" % (arguments.picture, pixels, hues))
    if pixels >= arguments.pixels and hues >= arguments.hues:
        return 0
    print("%s: needs %d pixels in %d hues" % (arguments.picture, arguments.pixels, arguments.hues), file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
