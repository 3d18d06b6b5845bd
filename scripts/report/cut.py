"""A cross-section cut out of the cloud, in its own plane: q to the right of the travel, z up [mm]."""
import math

import numpy as np

PARENT_FROM, PARENT_TO = 1.0, 12.0  # beside a toe, where a parent line is drawn through the points [mm]
BREAK = 0.4  # a wider step between neighbours is a hole: the line stops [mm]


class Cut:
    """Points of one section; `left`, `right` the toes, lines as (slope, z at q = 0) or None."""

    def __init__(self, folder, index):
        left, right = (toe[index] for toe in folder.toes())
        yaw = math.radians(np.nan_to_num(folder.sections.numbers("yaw_deg")[index]))
        self.index, self.s = index, folder.sections.numbers("s_mm")[index]
        middle = 0.5 * (left + right)
        self.base = middle[2]
        across, along = (math.cos(yaw), math.sin(yaw)), (-math.sin(yaw), math.cos(yaw))
        self.left, self.right = ((np.dot(toe[:2] - middle[:2], across), toe[2] - self.base) for toe in (left, right))
        self.width = self.right[0] - self.left[0]
        self.q, self.z, self.on_base = self._points(folder, middle, across, along)
        self.line_left = self._parent(self.left, -1)
        self.line_right = self._parent(self.right, 1)

    def _points(self, folder, middle, across, along):
        cloud = folder.cloud
        pitch = cloud.row_pitch()
        pitch = pitch if math.isfinite(pitch) else 0.1
        reach = 1.5 * self.width + 15.0
        row = folder.sections.numbers("row")[self.index]
        row = int(min(max(np.nan_to_num(row), 0), cloud.x.shape[0] - 1))
        x, y, z, base = cloud.near_rows(row, int(reach * abs(along[0]) / pitch) + 3)
        dx, dy = x - middle[0], y - middle[1]
        keep = (np.abs(dx * along[0] + dy * along[1]) <= 0.55 * pitch) & (np.abs(dx * across[0] + dy * across[1]) < reach)
        q = (dx * across[0] + dy * across[1])[keep]
        order = np.argsort(q, kind="stable")
        return q[order].astype(float), (z[keep][order] - self.base).astype(float), base[keep][order]

    def _parent(self, toe, side):
        """A robust line through the base metal beside the toe, for the drawing; None where there is too little of it."""
        distance = side * (self.q - toe[0])
        keep = (distance > PARENT_FROM) & (distance < PARENT_TO) & self.on_base
        q, z = self.q[keep], self.z[keep]
        if len(q) < 20 or np.ptp(q) < 1.0:
            return None
        weight = np.ones(len(q))
        for _ in range(8):
            slope, height = np.polyfit(q, z, 1, w=np.sqrt(weight))
            rest = np.abs(z - slope * q - height)
            scale = max(1.5 * float(np.median(rest)), 1e-3)
            weight = 1.0 / (1.0 + (rest / (2.0 * scale)) ** 2) ** 2
        return float(slope), float(height)

    def line(self):
        """q, z with NaN in the holes."""
        if not len(self.q):
            return self.q, self.z
        gaps = np.nonzero(np.diff(self.q) > BREAK)[0] + 1
        return np.insert(self.q, gaps, np.nan), np.insert(self.z, gaps, np.nan)

    def smoothed(self):
        """Running medians of z over 0.3 mm, to find places by."""
        if len(self.q) < 5:
            return self.z
        step = max(float(np.median(np.diff(self.q))), 1e-3)
        half = int(min(max(0.15 / step, 1), 40, (len(self.q) - 1) // 2))
        padded = np.pad(self.z, half, mode="edge")
        return np.median(np.stack([padded[i:i + len(self.z)] for i in range(2 * half + 1)]), axis=0)

    def chord_frame(self):
        """Unit vectors along the chord and up from it."""
        along = np.subtract(self.right, self.left)
        along = along / np.hypot(*along)
        return along, np.array([-along[1], along[0]])

    def crest(self):
        """The face's highest point above the chord and its foot on the chord, or None."""
        inside = (self.q > self.left[0]) & (self.q < self.right[0])
        if inside.sum() < 5:
            return None
        along, up = self.chord_frame()
        points = np.column_stack([self.q, self.smoothed()])[inside]
        heights = (points - self.left) @ up
        top = points[int(heights.argmax())]
        return top, top - up * heights.max()

    def undercut(self, side):
        """The lowest point under the parent line within 2.5 mm outside a toe, and the point of the line above it."""
        toe, line = (self.left, self.line_left) if side == "left" else (self.right, self.line_right)
        if line is None:
            return None
        distance = (self.q - toe[0]) * (-1 if side == "left" else 1)
        keep = (distance > -0.1) & (distance < 2.5)
        if keep.sum() < 5:
            return None
        q, z = self.q[keep], self.smoothed()[keep]
        depth = line[0] * q + line[1] - z
        worst = int(depth.argmax())
        return (q[worst], z[worst]), (q[worst], z[worst] + depth[worst])

    def root(self):
        """Where the parent lines meet, or None for lines that are nearly parallel."""
        if self.line_left is None or self.line_right is None or abs(self.line_left[0] - self.line_right[0]) < 0.2:
            return None
        q = (self.line_right[1] - self.line_left[1]) / (self.line_left[0] - self.line_right[0])
        return q, self.line_left[0] * q + self.line_left[1]


def _deciding(folder):
    """Where along the weld an imperfection decided against a level, the worst decision first [mm]."""
    table = folder.verdict
    rows = list(zip(table.texts("decision"), table.texts("level"), table.numbers("s_mm")))
    for decision in ("fail", "undecided"):
        for level in ("D", "C", "B"):
            places = [s for d, l, s in rows if (d, l) == (decision, level) and math.isfinite(s)]
            if places:
                return places[0]
    return math.nan


def choose(folder, most=5):
    """Sections worth showing, in their order along the weld: spread evenly, the one that decided, the highest."""
    left, right = folder.toes()
    s = folder.sections.numbers("s_mm")
    usable = np.nonzero(np.isfinite(left).all(axis=1) & np.isfinite(right).all(axis=1) & np.isfinite(s)
                        & (np.hypot(*(right - left)[:, :2].T) > 1e-3))[0] if len(folder.sections) else []
    if not len(usable) or folder.cloud is None:
        return []
    measured = np.isfinite(folder.sections.numbers("width_mm")[usable])
    usable = usable[measured] if measured.any() else usable  # a section with toes alone shows no dimensions
    near, far = s[usable].min(), s[usable].max()
    wanted = [near + share * (far - near) for share in (0.15, 0.5, 0.85)] + [_deciding(folder)]
    heights = folder.sections.numbers("reinforcement_mm")[usable]
    if np.isfinite(heights).any():
        wanted.append(s[usable][int(np.nanargmax(heights))])
    chosen = []
    for place in wanted:
        if not math.isfinite(place) or len(chosen) >= most:
            continue
        index = int(usable[int(np.abs(s[usable] - place).argmin())])
        if index not in chosen and all(abs(s[index] - s[other]) >= 0.06 * (far - near) for other in chosen):
            chosen.append(index)
    return sorted(chosen, key=lambda index: s[index])
