"""The folder that compare_scans leaves, read (docs/report.md)."""
import os

import numpy as np

from report.cloud import read_cloud
from report.files import ReportError, read_json
from report.grid import Grid, smooth

COMPARE = "compare the scans again"
MAPS = ("after", "removed", "remaining")


class CompareFolder:
    """A comparison of two scans. Maps are grids [mm]; None without a point."""

    def __init__(self, path, named=None):
        if not os.path.isdir(path):
            raise ReportError("%s: is no folder, give the folder that holds compare.json" % path)
        self.path, self.named = path, named or path
        self.record = read_json(os.path.join(path, "compare.json"), COMPARE)
        limit = self.record.number("over_ground_limit")
        self.limit = 1e3 * limit if np.isfinite(limit) else 0.05
        self.spots = self.record.records("over_ground")
        self.cloud = self.grid = None
        self.maps, self.taken, self.deep = {}, None, None
        self._read_points(os.path.join(path, "difference.pcd"))

    def _read_points(self, path):
        if not os.path.lexists(path):
            return
        cloud = read_cloud(path, MAPS)
        if not cloud.good.any():
            return
        self.cloud, self.grid = cloud, Grid(cloud.x, cloud.y, cloud.good)
        self.maps = {"before": self.grid.mean(cloud.z)}
        for name in MAPS:
            self.maps[name] = self.grid.mean(cloud.millimetres(name))
        # what was ground below the target: a place that lay there before (an undercut) does not count
        self.taken = np.maximum(smooth(self.maps["remaining"]), smooth(-self.maps["removed"]))
        if cloud.has("spot"):
            with np.errstate(invalid="ignore"):
                self.deep = self.grid.share(cloud.scan["spot"] > 0) >= 0.5
        else:
            self.deep = self.taken < -self.limit

    def profile(self, share):
        """The row at a share of the scan: x, before, after, target and its y [mm], sorted by x."""
        row = int(round(share * (self.cloud.x.shape[0] - 1)))
        keep = self.cloud.good[row]
        order = np.argsort(self.cloud.x[row][keep], kind="stable")
        x, y, before, after, remaining = (
            values[row][keep][order].astype(float) for values in
            (self.cloud.x, self.cloud.y, self.cloud.z, self.cloud.millimetres("after"), self.cloud.millimetres("remaining")))
        return x, before, after, after - remaining, float(np.median(y)) if len(y) else np.nan

    def along(self, name):
        """y [mm] and the area of a cross-section [mm^2] of `removed` or `remaining`, row by row. With their signs: positive
        parts alone would add up noise."""
        field = self.maps[name]
        known = np.isfinite(field).any(axis=1)
        y = self.grid.near + self.grid.dy * (np.arange(self.grid.rows) + 0.5)
        area = np.nansum(field, axis=1) * self.grid.dx
        return y, np.where(known, area, np.nan)

    def lowest(self):
        """y and the deepest place under the target, row by row [mm]: over the smoothed map, no single point; places that
        lay as low before do not count."""
        field = self.taken
        known = np.isfinite(field).any(axis=1)
        low = np.full(len(field), np.nan)
        low[known] = np.nanmin(field[known], axis=1)
        return self.grid.near + self.grid.dy * (np.arange(self.grid.rows) + 0.5), low
