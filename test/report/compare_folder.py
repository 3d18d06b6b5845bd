"""A folder as compare_scans leaves it: a ground weld with one place too deep."""
import os

import numpy as np

from weld_folder import SIGMA, Weld, write_json, write_pcd

FIELDS = [(name, "<f4") for name in ("x", "y", "z", "after", "removed", "remaining")]


def write_compare(folder, rows=120, cells=480):
    """The record; depth 0.12 mm at x = 2 mm, y = 10 mm; a rest of 0.15 mm along the weld's end."""
    os.makedirs(folder, exist_ok=True)
    weld = Weld("bead_on_plate", rows, cells)
    weld.yaw = 0.0
    x, y = np.meshgrid((np.arange(cells) - 0.5 * cells) * 1.25e-4, np.arange(rows) * 2.5e-4)
    before, label, _ = weld.surface(x, y)
    target = weld.parents(weld.across(x, y)[0])
    rest = np.where(label == 2, 1.5e-4 * np.clip((y - 0.02) / 0.005, 0, 1), 0.0)
    pit = 1.2e-4 * np.exp(-((x - 0.002) ** 2 + (y - 0.010) ** 2) / 0.0015 ** 2)
    after = np.where(label == 2, np.minimum(target + rest, before), before) - pit
    cloud = np.zeros((rows, cells), np.dtype(FIELDS))
    noise = weld.random.normal(0, SIGMA, (2,) + x.shape)
    cloud["x"], cloud["y"], cloud["z"], cloud["after"] = x, y, before + noise[0], after + noise[1]
    cloud["removed"], cloud["remaining"] = cloud["z"] - cloud["after"], cloud["after"] - target
    cloud["after"][40:50, 60:90] = cloud["removed"][40:50, 60:90] = cloud["remaining"][40:50, 60:90] = np.nan
    write_pcd(os.path.join(folder, "difference.pcd"), cloud)
    cell = 1.25e-4 * 2.5e-4
    record = {"id": "K-17/3", "before": "scans/before", "after": "scans/after", "kind": "bead_on_plate", "reason": "",
              "aligned": {"shift": [1.2e-4, -3e-5, 8e-6], "shift_sigma": [4e-6, 5e-5, 1e-6], "rotation": [1e-4, -2e-4, 3e-3],
                          "rotation_sigma": [1e-5, 1e-5, 2e-4], "residual": 4e-6},
              "removed_volume": {"value": float((before - after).sum() * cell), "sigma": 2e-9},
              "remaining_volume": {"value": float(rest.sum() * cell), "sigma": 4e-10},
              "over_ground": [{"x": 0.002, "y": 0.010, "s": 0.010, "depth": {"value": 1.2e-4, "sigma": 6e-6}, "area": 6.2e-6}],
              "over_ground_limit": 5e-5, "measured_share": 0.98, "notes": ["0.6 % of the scan was seen in one scan only"],
              "settings": {"over_ground_limit": 5e-5, "target": "flush"},
              "calibration": {"file": "calibration.yaml", "hash": "3f9a01c2d4e5"}}
    write_json(os.path.join(folder, "compare.json"), record)
    return record
