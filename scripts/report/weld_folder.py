"""The folder that the measuring of a weld leaves, read (docs/weld-files.md)."""
import os

import numpy as np

from report.cloud import mean_plane, read_cloud
from report.files import ReportError, read_json
from report.grid import Grid
from report.table import empty_table, read_table

MEASURE = "measure the scan again"


class WeldFolder:
    """What is missing is empty and named in `missing`; `cloud` and `grid` are None without a point."""

    def __init__(self, path, gauge_path=None):
        if not os.path.isdir(path):
            raise ReportError("%s: is no folder, give the folder that holds weld.json" % path)
        self.path, self.missing, self.chosen = path, [], []
        self.record = read_json(os.path.join(path, "weld.json"), MEASURE)
        self.kind = self.record.text("kind") or "none"
        self.sections = self._table("weld.csv", ["row"])
        self.verdict = self._table("verdict.csv", ["imperfection", "level", "decision"])
        self.spots = self._table("spots.csv", ["kind"])
        self._refuse_mixed()
        self.gauge = read_gauge(gauge_path) if gauge_path else None
        self._read_points()

    def has_weld(self):
        return self.kind != "none"

    def _table(self, name, required):
        path = os.path.join(self.path, name)
        if os.path.lexists(path):
            return read_table(path, required, MEASURE)
        if self.has_weld():
            self.missing.append(name)
        return empty_table(path)

    def _refuse_mixed(self):
        """Tables that are missing, cut short or of another measurement than weld.json."""
        count = self.record.number("sections")
        if self.has_weld() and count > 0:
            for table, name in ((self.sections, "weld.csv"), (self.verdict, "verdict.csv")):
                if len(table) == 0:
                    raise ReportError("%s: %s, weld.json tells of %d sections: %s"
                                      % (table.path, "is missing" if name in self.missing else "has no line", count, MEASURE))
            if len(self.sections) != count:
                raise ReportError("%s: holds %d sections, weld.json tells of %d: %s"
                                  % (self.sections.path, len(self.sections), count, MEASURE))
        traced = {"weld_id": self.record.text("id").replace(",", ";").replace('"', "'").strip(),
                  "calibration_hash": self.record.record("calibration").text("hash"),
                  "settings_hash": self.record.text("settings_hash")}
        for table in (self.sections, self.verdict, self.spots):
            for name, value in traced.items():
                for other in table.texts(name) if table.has(name) else []:
                    if other != value:
                        raise ReportError("%s: is of another measurement than weld.json: %s is '%.40s', there '%.40s': %s"
                                          % (table.path, name, other, value, MEASURE))

    def _read_points(self):
        self.cloud = self.grid = self.heights = None
        self.levelled = False
        names = [name for name in ("weld_points.pcd", "scan.pcd") if os.path.lexists(os.path.join(self.path, name))]
        if not names or names[0] != "weld_points.pcd":
            self.missing.append("weld_points.pcd")
        if not names:
            return
        cloud = read_cloud(os.path.join(self.path, names[0]))
        if not cloud.good.any():
            self.missing.append("%s holds no point" % names[0])
            return
        self.cloud, self.grid = cloud, Grid(cloud.x, cloud.y, cloud.good)
        self.plane = mean_plane(cloud) if self.kind in ("butt", "bead_on_plate") else None
        self.levelled = self.plane is not None
        self.heights = self.grid.mean(self.height_over_plane(cloud.x, cloud.y, cloud.z))

    def height_over_plane(self, x, y, z):
        if not self.levelled:
            return z
        a, b, c = self.plane
        return z - np.asarray(a * x + b * y + c, dtype=z.dtype)

    def toes(self):
        """(left, right), each an array of x, y, z [mm] a section."""
        return tuple(np.column_stack([self.sections.numbers("toe_%s_%s_mm" % (side, axis)) for axis in "xyz"])
                     for side in ("left", "right"))


class Gauge:
    """Readings by hand [mm]; NaN where there is none."""

    def __init__(self, table):
        self.s, self.width, self.height = (table.numbers(name) for name in ("s_mm", "width_mm", "height_mm"))
        self.resolution = table.numbers("resolution_mm")

    def stated_resolution(self):
        """Of all readings, the coarsest; NaN where none is stated."""
        known = self.resolution[np.isfinite(self.resolution)]
        return float(known.max()) if known.size else np.nan


def read_gauge(path):
    table = read_table(path, ["s_mm", "width_mm", "height_mm"],
                       "give a CSV with the columns s_mm,width_mm,height_mm and if known resolution_mm")
    gauge = Gauge(table)
    if not np.isfinite(gauge.s).any():
        raise ReportError("%s: holds no reading with an s_mm, give its place along the weld" % path)
    if (gauge.resolution < 0).any():
        raise ReportError("%s: resolution_mm is below 0, must be the gauge's smallest step" % path)
    return gauge
