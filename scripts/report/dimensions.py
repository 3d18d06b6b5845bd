"""Dimensions as in a mechanical drawing: extension lines, arrows, text on the line."""
import math

import numpy as np

from report.style import DIMENSION, INK

THIN = 0.55
PAPER = {"boxstyle": "square,pad=0.12", "facecolor": "white", "edgecolor": "none"}


def _arrow(axes, tail, head, style="-|>"):
    axes.annotate("", xy=head, xytext=tail, annotation_clip=False,
                  arrowprops={"arrowstyle": style + ",head_length=0.45,head_width=0.16", "color": DIMENSION, "linewidth": THIN,
                              "shrinkA": 0, "shrinkB": 0})


def _segment(axes, start, end, **look):
    look = dict({"color": DIMENSION, "linewidth": THIN, "clip_on": False}, **look)
    axes.plot([start[0], end[0]], [start[1], end[1]], solid_capstyle="butt", **look)


def write(axes, place, text, **look):
    look = dict({"ha": "center", "va": "center", "fontsize": 7.5, "color": DIMENSION, "bbox": PAPER}, **look)
    axes.text(place[0], place[1], text, **look)


def distance(axes, start, end, offset, text):
    """Between two points, the dimension line shifted by `offset` [mm] to the left of start -> end."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    along = (end - start) / max(np.hypot(*(end - start)), 1e-9)
    aside = np.array([-along[1], along[0]])
    first, second = start + offset * aside, end + offset * aside
    reach = offset + math.copysign(0.12 * abs(offset), offset)
    for point in (start, end):
        _segment(axes, point + 0.10 * offset * aside, point + reach * aside)
    _arrow(axes, first, second, "<|-|>")
    turn = math.degrees(math.atan2(along[1], along[0]))
    turn = turn - 180 if turn > 90 else turn + 180 if turn < -90 else turn
    write(axes, 0.5 * (first + second), text, rotation=turn, rotation_mode="anchor")


def height(axes, foot, top, place_q, text, size):
    """Of a point over a level, measured upright at place_q; outside arrows where it is small against `size` [mm]."""
    for point in (foot, top):
        beyond = place_q + math.copysign(0.02 * size, place_q - point[0])
        _segment(axes, point, (beyond, point[1]))
    low, high = (place_q, foot[1]), (place_q, top[1])
    if high[1] - low[1] > 0.05 * size:
        _arrow(axes, low, high, "<|-|>")
    else:
        _arrow(axes, (place_q, low[1] - 0.045 * size), low)
        _arrow(axes, (place_q, high[1] + 0.045 * size), high)
        _segment(axes, low, high)
    write(axes, (place_q + 0.012 * size, 0.5 * (low[1] + high[1])), text, ha="left")


def note(axes, point, place, text, **look):
    """A text with a line that ends in a dot at what it speaks of."""
    _segment(axes, place, point)
    axes.plot([point[0]], [point[1]], marker="o", markersize=2.2, color=DIMENSION, clip_on=False)
    write(axes, place, text, **look)


def angle(axes, corner, directions_deg, radius, text, share=0.5):
    """The arc from one direction to the other, anticlockwise, and its text at that share of it."""
    first, last = directions_deg
    turns = np.radians(np.linspace(first, last, 40))
    q, z = corner[0] + radius * np.cos(turns), corner[1] + radius * np.sin(turns)
    axes.plot(q, z, color=DIMENSION, linewidth=THIN, clip_on=False)
    for end, before in ((0, 2), (-1, -3)):
        _arrow(axes, (q[before], z[before]), (q[end], z[end]))
    middle = math.radians(first + share * (last - first))
    write(axes, (corner[0] + radius * math.cos(middle), corner[1] + radius * math.sin(middle)), text)


def chain(axes, start, end):
    """A line that is thought, not seen."""
    _segment(axes, start, end, color=INK, linestyle=(0, (10, 2.5, 2, 2.5)), linewidth=0.6, clip_on=True)
