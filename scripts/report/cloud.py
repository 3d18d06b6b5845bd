"""The points of a scan in millimetres, organised as the file has them."""
import numpy as np

from report.files import ReportError
from scan_file import ScanFileError, read_scan

BASE, UNDERCUT = 1, 3  # values of the field label


class Cloud:
    """x, y, z [mm] of shape (rows, cells), NaN where nothing was measured; further fields as the file has them."""

    def __init__(self, path, scan):
        self.path, self.scan = path, scan
        self.x, self.y, self.z = (self.millimetres(name) for name in ("x", "y", "z"))
        self.good = np.isfinite(self.x) & np.isfinite(self.y) & np.isfinite(self.z)

    def has(self, name):
        return name in self.scan.dtype.names

    def millimetres(self, name):
        values = np.ascontiguousarray(self.scan[name], dtype=np.float32) * np.float32(1e3)
        return np.where(np.abs(values) < 1e6, values, np.float32(np.nan))  # an infinity is no place

    def labels(self):
        """None if the file has none."""
        return self.scan["label"] if self.has("label") else None

    def near_rows(self, row, count):
        """The points of the rows around one of them: x, y, z and whether base metal, as flat arrays."""
        first, last = max(row - count, 0), row + count + 1
        keep = self.good[first:last]
        labels = self.labels()
        base = np.ones(self.good.shape, bool) if labels is None else labels == BASE
        return tuple(values[first:last][keep] for values in (self.x, self.y, self.z, base))

    def row_pitch(self):
        """Median distance of neighbouring rows along y [mm]; NaN for a single row."""
        steps = np.abs(np.diff(self.y[:, ::8], axis=0))
        steps = steps[np.isfinite(steps) & (steps > 1e-4)]
        return float(np.median(steps)) if steps.size else np.nan


def read_cloud(path, needed=()):
    """@throws ReportError; a cloud without a point is none."""
    try:
        scan = read_scan(path)
    except ScanFileError as error:
        raise ReportError(str(error))
    except (ValueError, KeyError, IndexError, TypeError, MemoryError) as error:
        raise ReportError("%s: its PCD header is damaged (%s), write it again" % (path, error))
    for name in needed:
        if name not in scan.dtype.names:
            raise ReportError("%s: has no field %s, write it again" % (path, name))
    return Cloud(path, scan)


def mean_plane(cloud):
    """(a, b, c) of z = a x + b y + c through the base metal [mm], or None where none is labelled."""
    labels = cloud.labels()
    if labels is None:
        return None
    keep = cloud.good & (labels == BASE)
    count = int(keep.sum())
    if count < 100:
        return None
    step = max(count // 20000, 1)
    x, y, z = (values[keep][::step].astype(float) for values in (cloud.x, cloud.y, cloud.z))
    middle = x.mean(), y.mean()  # with the middle taken out, a single row leaves the plane level along y
    matrix = np.column_stack([x - middle[0], y - middle[1], np.ones_like(x)])
    a, b, c = np.linalg.lstsq(matrix, z, rcond=1e-6)[0]
    return a, b, c - a * middle[0] - b * middle[1]
