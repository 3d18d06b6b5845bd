#!/usr/bin/python3
"""Compares a scan with the truth of the simulation, per point of the same frame and cell.

Rows and frames are joined by time, never by place, so that a wrongly placed row shows. Only points that were measured
count (not INTERPOLATED), and only cells that the camera can see (visible). A px-equivalent is what a pixel row of the
rig is worth in height.
"""
import argparse
import json
import sys

import numpy as np

from scan_file import ScanFileError, read_scan

INTERPOLATED = 1


class Truth:
    """centres.csv as grids: a line a frame, a column a cell, NaN where there is no truth."""

    def __init__(self, path):
        try:
            with open(path) as file:
                names = file.readline().strip().split(",")
                table = np.loadtxt(file, delimiter=",", ndmin=2)
        except OSError as error:
            raise ScanFileError("%s: cannot be read: %s" % (path, error.strerror))
        except ValueError as error:
            raise ScanFileError("%s: is no truth: %s" % (path, error))
        for name in ("frame", "stamp", "stage_m", "cell", "x_m", "y_m", "z_m", "visible"):
            if name not in names:
                raise ScanFileError("%s: has no column %s" % (path, name))
        if table.shape[0] == 0:
            raise ScanFileError("%s: holds no centre" % path)
        column = {name: table[:, place] for place, name in enumerate(names)}
        frames, line, first = _unique(column["frame"].astype(int))
        self.frame = frames
        self.stamp = column["stamp"][first] - column["stamp"][0]
        self.stage = column["stage_m"][first]
        self.cells = int(column["cell"].max()) + 1
        shape = (frames.size, self.cells)
        cell = column["cell"].astype(int)
        self.x, self.y, self.z = (np.full(shape, np.nan) for _ in range(3))
        self.visible = np.zeros(shape, bool)
        self.x[line, cell] = column["x_m"]
        self.y[line, cell] = column["y_m"]
        self.z[line, cell] = column["z_m"]
        self.visible[line, cell] = column["visible"] > 0.5


def _unique(values):
    frames, first, line = np.unique(values, return_index=True, return_inverse=True)
    return frames, line, first


def join(scan, truth):
    """For each row of the scan the line of the truth, -1 where there is none. Rows without a point are left out."""
    with np.errstate(all="ignore"):
        known = np.isfinite(scan["z"]).any(axis=1)
        time = np.array([np.nanmedian(row) if good else np.nan for row, good in zip(scan["time"].astype(float), known)])
        stage = np.array([np.nanmedian(row) if good else np.nan for row, good in zip(scan["stage"].astype(float), known)])
    if not known.any():
        raise ScanFileError("the scan holds no point")
    if truth.stamp.size == 1:
        return np.where(known, 0, -1)
    interval = float(np.median(np.diff(truth.stamp)))
    best, best_error = None, np.inf
    for start in truth.stamp:  # which frame was the first row? the one with which most stages agree
        lines = _nearest(truth.stamp, time + start)
        late = np.abs(truth.stamp[lines] - (time + start))
        lines = np.where(known & (late < 0.25 * interval), lines, -1)
        matched = lines >= 0
        unmatched = known.sum() - matched.sum()
        if not matched.any():
            continue
        error = np.median(np.abs(stage[matched] - truth.stage[lines[matched]])) + unmatched
        if error < best_error:
            best, best_error = lines, error
    if best is None:
        raise ScanFileError("no row of the scan has the time of a frame of the truth: are they of one run?")
    return best


def _nearest(sorted_values, values):
    right = np.clip(np.searchsorted(sorted_values, np.nan_to_num(values)), 1, sorted_values.size - 1)
    nearer_left = np.abs(sorted_values[right - 1] - values) <= np.abs(sorted_values[right] - values)
    return np.where(nearer_left, right - 1, right)


def compare(scan, truth, px_equivalent):
    """The figures, in metres and shares. Missing counts over all frames of the truth, rows or not."""
    lines = join(scan, truth)
    rows = np.flatnonzero(lines >= 0)
    cells = min(scan.shape[1], truth.cells)
    part, line = scan[rows][:, :cells], lines[rows]
    visible = truth.visible[line, :cells]
    measured = np.isfinite(part["z"]) & ((part["flags"] & INTERPOLATED) == 0)
    judged = measured & visible
    if not judged.any():
        raise ScanFileError("no measured point lies in a visible cell: are scan and truth of one run?")
    error = {axis: part[axis].astype(float) - getattr(truth, axis)[line, :cells] for axis in "xyz"}
    unseen = measured & ~visible  # measured where the truth says that nothing can be seen
    beyond = np.abs(error["z"]) > px_equivalent
    return {
        "frames_of_truth": int(truth.frame.size),
        "frames_missing": int(truth.frame.size - np.unique(line).size),
        "rows": int(scan.shape[0]),
        "rows_compared": int(rows.size),
        "points_compared": int(judged.sum()),
        "rms_z": _rms(error["z"][judged]),
        "mean_z": float(error["z"][judged].mean()),
        "share_beyond": float(np.mean(beyond[judged])),
        "share_missing": float(1.0 - judged.sum() / max(truth.visible.sum(), 1)),
        "rms_x": _rms(error["x"][judged]),
        "rms_y": _rms(error["y"][judged]),
        "points_unseen": int(unseen.sum()),
        "points_unseen_beyond": int((unseen & ~(np.abs(error["z"]) <= px_equivalent)).sum()),
    }


def _rms(values):
    return float(np.sqrt(np.mean(values ** 2)))


def report(figures, px_equivalent):
    """Lines for people: micrometres, px-equivalents, per cent."""
    um = 1e6
    px = 1.0 / px_equivalent
    yield "rows compared        %d of %d, %d frames in the truth" % (
        figures["rows_compared"], figures["rows"], figures["frames_of_truth"])
    yield "points compared      %d" % figures["points_compared"]
    yield "RMS z                %.2f um = %.3f px-eq" % (um * figures["rms_z"], px * figures["rms_z"])
    yield "mean z               %+.2f um = %+.3f px-eq" % (um * figures["mean_z"], px * figures["mean_z"])
    yield "beyond 1 px-eq       %.3f %%" % (100.0 * figures["share_beyond"])
    yield "visible cells missing %.3f %%, frames without a row %d" % (
        100.0 * figures["share_missing"], figures["frames_missing"])
    yield "measured where nothing is visible: %d points, %d of them beyond 1 px-eq or without truth" % (
        figures["points_unseen"], figures["points_unseen_beyond"])
    yield "RMS x                %.2f um" % (um * figures["rms_x"])
    yield "RMS y                %.2f um" % (um * figures["rms_y"])


def within_limits(figures, px_equivalent):
    """What preset `realistic` must hold; yields what does not."""
    limits = (
        ("RMS z", figures["rms_z"] / px_equivalent, 0.25, "px-eq"),
        ("|mean z|", abs(figures["mean_z"]) / px_equivalent, 0.1, "px-eq"),
        ("share beyond 1 px-eq", figures["share_beyond"], 0.01, ""),
        ("share of visible cells missing", figures["share_missing"], 0.02, ""),
        ("RMS x", 1e6 * figures["rms_x"], 5.0, "um"),
        ("RMS y", 1e6 * figures["rms_y"], 5.0, "um"),
        # rows and frames are joined by their times, the first by the stages: unambiguous only while hardly one is missing
        ("share of frames without a row", figures["frames_missing"] / figures["frames_of_truth"], 0.02, ""),
        ("share of points where nothing is visible and the height is wrong",
         figures["points_unseen_beyond"] / figures["points_compared"], 0.002, ""),
        ("share of rows without a frame", 1.0 - figures["rows_compared"] / figures["rows"], 0.02, ""),
    )
    for name, value, limit, unit in limits:
        if not value <= limit:
            yield "%s is %.4g %s, must be at most %g" % (name, value, unit, limit)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", help="scan.pcd")
    parser.add_argument("truth", help="centres.csv of the same run")
    parser.add_argument("--px-um", type=float, default=83.3, help="a px-equivalent [um] (default 83.3, the default rig)")
    parser.add_argument("--json", action="store_true", help="figures as JSON, in metres and shares")
    parser.add_argument("--check", action="store_true", help="exit status 3 when the limits of preset realistic are passed")
    arguments = parser.parse_args()
    if not arguments.px_um > 0.0:
        parser.error("--px-um is %g, must be above 0" % arguments.px_um)
    px_equivalent = 1e-6 * arguments.px_um
    try:
        figures = compare(read_scan(arguments.scan), Truth(arguments.truth), px_equivalent)
    except ScanFileError as error:
        print(error, file=sys.stderr)
        return 1
    print(json.dumps(figures, indent=2) if arguments.json else "\n".join(report(figures, px_equivalent)))
    broken = list(within_limits(figures, px_equivalent)) if arguments.check else []
    for line in broken:
        print(line, file=sys.stderr)
    return 3 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
