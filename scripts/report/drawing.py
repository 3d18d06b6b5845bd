"""A cross-section as a mechanical drawing, true to scale, its dimensions from weld.csv with two standard deviations."""
import math

import numpy as np

from report import dimensions, style
from report.numbers import decimals_for


METAL = "#eeeeee"
ON_METAL = dict(dimensions.PAPER, facecolor=METAL)


def short(table, name, index, symbol, unit=""):
    """`b 10.02 ± 0.04`, or empty if it was not measured."""
    value, sigma = (values[index] for values in table.quantity(name))
    if not math.isfinite(value):
        return ""
    decimals = min(decimals_for(2 * sigma), 3)
    number = "%.*f%s" % (decimals, value, unit)
    if math.isfinite(sigma):
        number += " ± %.*f%s" % (decimals, 2 * sigma, unit)
    return ("%s %s" % (symbol, number)).strip()


class Drawing:
    """Draws into axes; `size` is the width of what is seen [mm]."""

    def __init__(self, axes, folder, cut):
        self.axes, self.table, self.cut, self.fillet = axes, folder.sections, cut, folder.kind == "fillet"
        pad = max(0.42 * cut.width, 3.0)
        self.low_q, self.high_q = cut.left[0] - pad, cut.right[0] + 1.65 * pad  # room for the height at the right
        self.size = self.high_q - self.low_q
        seen = cut.z[(cut.q > self.low_q) & (cut.q < self.high_q)]
        self.low = float(seen.min()) if seen.size else min(cut.left[1], cut.right[1])
        self.high = float(seen.max()) if seen.size else max(cut.left[1], cut.right[1])
        root = cut.root() if self.fillet else None
        if root:
            self.low = min(self.low, root[1] - 0.02 * self.size)
        top = cut.crest()
        along, _ = cut.chord_frame()
        self.hangs = abs(along[1]) > 0.2  # the chord: its dimensions are written along it, the height between face and width
        self.clear = 0.16 if self.fillet else 0.12 if self.hangs else 0.10  # of the width over the crest
        self.above = 0.22 if self.hangs and not self.fillet else 0.15
        self.top = max(top[0][1] if top else 0.0, cut.left[1], cut.right[1])
        if self.fillet:  # the plates rise beside it: no need to follow them
            self.high = min(self.high, self.top + 0.11 * self.size)

    def text(self, name, symbol, unit=""):
        return short(self.table, name, self.cut.index, symbol, unit)

    def draw(self):
        self._surface()
        self._parents()
        self._width()
        self._reinforcement()
        if self.fillet:
            self._legs_and_throat()
        else:
            self._misalignment()
        for side in ("left", "right"):
            self._undercut(side)
            self._toe_angle(side)
        self._finish()

    def _surface(self):
        q, z = self.cut.line()
        floor = self.low - 0.13 * self.size
        self.axes.fill_between(q, z, floor, facecolor=METAL, edgecolor="none", linewidth=0)
        self.axes.plot(q, z, color=style.INK, linewidth=1.1, solid_joinstyle="round")
        for toe in (self.cut.left, self.cut.right):
            self.axes.plot([toe[0]], [toe[1]], marker="o", markersize=3, markerfacecolor="white", markeredgecolor=style.INK,
                           markeredgewidth=0.8, zorder=5)

    def _parents(self):
        cut, root = self.cut, self.cut.root()
        end = root[0] if root else 0.0
        over = 0.04 * self.size
        if cut.line_left:
            a, c = cut.line_left
            dimensions.chain(self.axes, (self.low_q, a * self.low_q + c), (end + over, a * (end + over) + c))
        if cut.line_right:
            a, c = cut.line_right
            dimensions.chain(self.axes, (end - over, a * (end - over) + c), (self.high_q, a * self.high_q + c))
        dimensions._segment(self.axes, cut.left, cut.right, color=style.GREY, linestyle=(0, (3, 2)))

    def _width(self):
        _, up = self.cut.chord_frame()
        crest = max((self.top - max(self.cut.left[1], self.cut.right[1])) * abs(up[1]), 0.0)
        if self.hangs and self.cut.crest():
            crest = float(np.hypot(*np.subtract(*self.cut.crest())))
        clear = crest + self.clear * self.size
        text = self.text("width_mm", "b")
        if text:
            dimensions.distance(self.axes, self.cut.left, self.cut.right, clear, text)

    def _reinforcement(self):
        crest, text = self.cut.crest(), self.text("reinforcement_mm", "h")
        if crest and text:
            along, up = self.cut.chord_frame()
            place = self.cut.right[0] + 0.16 * self.size
            if self.hangs:  # measured where the crest is
                clear = 0.45 * self.clear * self.size
                dimensions.note(self.axes, 0.5 * (crest[0] + crest[1]), crest[0] + clear * up, text,
                                rotation=math.degrees(math.atan2(along[1], along[0])), rotation_mode="anchor")
            else:
                foot = crest[1] + along * (place - crest[1][0])
                dimensions.height(self.axes, (crest[1][0], foot[1]), (crest[0][0], foot[1] + crest[0][1] - crest[1][1]), place,
                                  text, self.size)

    def _legs_and_throat(self):
        cut, root = self.cut, self.cut.root()
        if not root:
            return
        for toe, name, offset in ((cut.left, "leg_left_mm", 1), (cut.right, "leg_right_mm", -1)):
            text = self.text(name, "z")
            if text:
                dimensions.distance(self.axes, root, toe, offset * 0.11 * self.size, text)
        along, up = cut.chord_frame()
        foot = np.asarray(root) + up * np.dot(np.subtract(cut.left, root), up)
        text = self.text("throat_mm", "a")
        if text:
            dimensions._arrow(self.axes, root, foot, "<|-|>")
            dimensions.write(self.axes, 0.55 * foot + 0.45 * np.asarray(root), text, bbox=ON_METAL)

    def _misalignment(self):
        cut, text = self.cut, self.text("misalignment_mm", "507:")
        if text and cut.line_left and cut.line_right:
            middle = 0.5 * (cut.line_left[1] + cut.line_right[1])
            dimensions.note(self.axes, (0.0, middle), (0.0, self.low - 0.085 * self.size), text,
                            bbox=ON_METAL)

    def _undercut(self, side):
        name, found = "undercut_%s_mm" % side, self.cut.undercut(side)
        value, sigma = (values[self.cut.index] for values in self.table.quantity(name))
        if found is None or not value > 2 * np.nan_to_num(sigma) or not value > 0.01:
            return
        (q, z), _ = found
        out = -1 if side == "left" else 1
        dimensions.note(self.axes, (q, z), (self._note_place(q, out), self.low - 0.085 * self.size),
                        self.text(name, "5011:"), ha="right" if side == "left" else "left",
                        bbox=ON_METAL)

    def _note_place(self, q, out):
        """Aside of what it speaks of, its text still inside the drawing."""
        wanted = q + 0.03 * out * self.size
        return max(wanted, self.low_q + 0.19 * self.size) if out < 0 else min(wanted, self.high_q - 0.19 * self.size)

    def _toe_angle(self, side):
        text = self.text("toe_angle_%s_deg" % side, "", "°")
        value = self.table.numbers("toe_angle_%s_deg" % side)[self.cut.index]
        toe, line = (self.cut.left, self.cut.line_left) if side == "left" else (self.cut.right, self.cut.line_right)
        if not text or not 0 < value < 360:
            return
        slope = math.degrees(math.atan(line[0])) if line else 0.0
        plate = 180.0 + slope if side == "left" else slope
        directions = (plate - value, plate) if side == "left" else (plate, plate + value)
        radius = min(0.105 * self.size, 0.55 * self.cut.width)
        face = math.radians(directions[0] if side == "left" else directions[1])
        dimensions._segment(self.axes, toe, (toe[0] + 1.2 * radius * math.cos(face), toe[1] + 1.2 * radius * math.sin(face)))
        dimensions.angle(self.axes, toe, directions, radius, text, 0.68 if side == "left" else 0.32)

    def _finish(self):
        floor = self.low - 0.13 * self.size
        self.axes.set_xlim(self.low_q, self.high_q)
        self.axes.set_ylim(floor, max(self.high, self.top) + self.above * self.size)
        self.axes.set_aspect("equal")
        self.axes.axis("off")
        bar = 10 ** math.floor(math.log10(0.25 * self.size))
        bar *= 5 if 5 * bar < 0.25 * self.size else 2 if 2 * bar < 0.25 * self.size else 1
        aside = self.high_q - bar - 0.01 * self.size
        # a fillet's plate takes the upper corner: the metal below is free
        place = (aside, floor + 0.03 * self.size) if self.fillet else (aside, max(self.high, self.top) + (self.above - 0.05) * self.size)
        self.axes.plot([place[0], place[0] + bar], [place[1]] * 2, color=style.INK, linewidth=2.0, solid_capstyle="butt")
        self.axes.text(place[0] + 0.5 * bar, place[1] + 0.012 * self.size, "%g mm" % bar, fontsize=7, ha="center", va="bottom")

    def ratio(self):
        """Height over width of what is seen."""
        return (max(self.high, self.top) - self.low + (0.13 + self.above) * self.size) / self.size
