"""A folder as the measuring of a weld leaves it, of a bead whose numbers are known: a circular segment."""
import json
import os

import numpy as np

SIGMA = 12e-6  # of a point [m]
FIELDS = [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4"), ("sigma", "<f4"), ("stage", "<f4"), ("time", "<f4"),
          ("flags", "u1"), ("pad", "V3"), ("label", "<u4"), ("removal", "<f4")]
MEASURED = ("width_mm reinforcement_mm toe_left_x_mm toe_right_x_mm toe_angle_left_deg toe_angle_right_deg undercut_left_mm "
            "undercut_right_mm misalignment_mm area_mm2").split()
LATER = ("toe_left_y_mm toe_left_z_mm toe_right_y_mm toe_right_z_mm leg_left_mm leg_right_mm throat_mm height_left_mm "
         "height_right_mm").split()
LAST = ["angle_deg", "incomplete_fill_mm"]
COLUMNS = (["row", "stage_mm"] + MEASURED + ["verdict", "section", "s_mm", "yaw_deg"] + LATER
           + ["sigma_" + name for name in MEASURED + LATER] + ["reference"] + LAST + ["sigma_" + name for name in LAST]
           + ["verdict_source"])
VERDICT = ("imperfection,level,value_mm,sigma_mm,limit_mm,margin_mm,length_mm,decision,source,edition,iso_6520,rule,side,s_mm,"
           "sigma_margin_mm,measured_mm,value_deg,sigma_deg,limit_deg,margin_deg,sigma_margin_deg").split(",")
SIGMAS = {"width_mm": 0.02, "reinforcement_mm": 0.006, "toe_angle_left_deg": 0.9, "toe_angle_right_deg": 0.9,
          "undercut_left_mm": 0.008, "undercut_right_mm": 0.008, "misalignment_mm": 0.007, "area_mm2": 0.06,
          "height_left_mm": 0.01, "height_right_mm": 0.01, "angle_deg": 0.03}


class Weld:
    """Known numbers, SI; `fillet`: plates at 45 deg to either side, the face a segment on the chord of the toes."""

    def __init__(self, kind="butt", rows=200, cells=1440, pitch=2.5e-4, seed=1):
        self.kind, self.rows, self.cells, self.pitch = kind, rows, cells, pitch
        self.width, self.height, self.undercut, self.step, self.yaw = 0.010, 0.0021, 0.0, 0.0, np.radians(4.0)
        if kind == "butt":
            self.undercut, self.step = 0.00018, 0.00025
        if kind == "fillet":
            self.height, self.yaw = 0.0006, 0.0
        self.random = np.random.RandomState(seed)

    def local_width(self, s):
        return self.width * (1 + 0.04 * np.sin(2 * np.pi * s / 0.04))

    def local_height(self, s):
        return self.height * (1 + 0.08 * np.sin(2 * np.pi * s / 0.025 + 1.0))

    def across(self, x, y):
        return x * np.cos(self.yaw) + y * np.sin(self.yaw), y * np.cos(self.yaw) - x * np.sin(self.yaw)

    def parents(self, q):
        if self.kind == "fillet":
            return np.abs(q)
        return np.where(q < 0, self.step, 0.0) + 0.01 * q

    def surface(self, x, y):
        q, s = self.across(x, y)
        half, height = 0.5 * self.local_width(s), self.local_height(s)
        radius = (half ** 2 + height ** 2) / (2 * height)
        cap = np.sqrt(np.maximum(radius ** 2 - q ** 2, 0)) - (radius - height)
        ripple = 4e-5 * np.sin(2 * np.pi * s / 0.0025 + (q / 0.004) ** 2) * np.clip(1 - (q / half) ** 2, 0, 1)
        left, right = self.parents(-half), self.parents(half)
        chord = left + (right - left) * (q + half) / (2 * half)
        groove = self.undercut * np.clip(1 - ((q + half + 5e-4) / 5e-4) ** 2, 0, None) * (np.sin(2 * np.pi * s / 0.03) > -0.3)
        bead = np.abs(q) < half
        z = np.where(bead, chord + cap + ripple, self.parents(q) - groove)
        label = np.where(bead, 2, np.where(groove > 2e-5, 3, 1))
        removal = np.where(bead, np.maximum(z - self.parents(q), 0), 0.0)
        return z, label, removal

    def points(self):
        across = (np.arange(self.cells) - 0.5 * self.cells) * 4.17e-5
        along = np.arange(self.rows) * self.pitch
        x, y = np.meshgrid(across, along)
        z, label, removal = self.surface(x, y)
        cloud = np.zeros((self.rows, self.cells), np.dtype(FIELDS))
        cloud["x"], cloud["y"], cloud["stage"] = x, y, y
        cloud["z"] = z + self.random.normal(0, SIGMA, z.shape) + 0.02 * x + 0.004 * y  # a plate that lies askew
        cloud["label"], cloud["removal"], cloud["sigma"] = label, removal, SIGMA
        cloud["z"][:, 700:703][3:9] = np.nan
        cloud["x"][5, 100:160] = cloud["y"][5, 100:160] = cloud["z"][5, 100:160] = np.nan
        return cloud

    def section(self, index):
        """A line of weld.csv as {column: value}."""
        s = index * self.pitch
        width, height = self.local_width(s), self.local_height(s)
        half = 0.5 * width
        angle = 180 - np.degrees(2 * np.arctan2(2 * height, width)) - (45 if self.kind == "fillet" else 0)
        values = {"row": index, "section": index, "stage_mm": 1e3 * s, "s_mm": 1e3 * s, "yaw_deg": np.degrees(self.yaw),
                  "width_mm": 1e3 * width, "reinforcement_mm": 1e3 * height, "toe_angle_left_deg": angle,
                  "toe_angle_right_deg": angle, "undercut_right_mm": 0.003, "misalignment_mm": 1e3 * self.step,
                  "undercut_left_mm": 1e3 * self.undercut * (np.sin(2 * np.pi * s / 0.03) > -0.3),
                  "area_mm2": 1e6 * 2 / 3 * width * height, "height_left_mm": 1e3 * height - 0.5e3 * self.step,
                  "height_right_mm": 1e3 * height + 0.5e3 * self.step, "angle_deg": 0.1, "reference": "chord", "verdict": "C",
                  "verdict_source": "unverified"}
        if self.kind == "fillet":
            values.update({"leg_left_mm": 1e3 * half * np.sqrt(2), "leg_right_mm": 1e3 * half * np.sqrt(2),
                           "throat_mm": 1e3 * half, "misalignment_mm": ""})
        for side, q in (("left", -half), ("right", half)):
            # on the path through (0, s), perpendicular to it
            x, y = q * np.cos(self.yaw) - s * np.sin(self.yaw), q * np.sin(self.yaw) + s * np.cos(self.yaw)
            z = self.parents(q) + 0.02 * x + 0.004 * y
            values.update({"toe_%s_x_mm" % side: 1e3 * x, "toe_%s_y_mm" % side: 1e3 * y, "toe_%s_z_mm" % side: 1e3 * z})
        for name, sigma in SIGMAS.items():
            if values[name] != "":
                values[name] += self.random.normal(0, sigma)
                values["sigma_" + name] = sigma
        return values


def write_pcd(path, cloud):
    names = ["_" if name == "pad" else name for name, _ in cloud.dtype.descr]
    kinds = [np.dtype(kind) for _, kind in cloud.dtype.descr]
    lines = ["VERSION 0.7", "FIELDS " + " ".join(names),
             "SIZE " + " ".join("1" if kind.kind == "V" else str(kind.itemsize) for kind in kinds),
             "TYPE " + " ".join({"f": "F", "u": "U", "V": "U"}[kind.kind] for kind in kinds),
             "COUNT " + " ".join(str(kind.itemsize) if kind.kind == "V" else "1" for kind in kinds),
             "WIDTH %d" % cloud.shape[1], "HEIGHT %d" % cloud.shape[0], "VIEWPOINT 0 0 0 1 0 0 0",
             "POINTS %d" % cloud.size, "DATA binary"]
    with open(path, "wb") as file:
        file.write(("\n".join(lines) + "\n").encode() + cloud.tobytes())


def write_csv(path, columns, rows):
    with open(path, "w") as file:
        file.write(",".join(columns) + "\n")
        for row in rows:
            cells = [row.get(name, "") for name in columns]
            file.write(",".join("%.6g" % cell if isinstance(cell, float) else str(cell) for cell in cells) + "\n")


def verdict_rows(weld, sections):
    width, height = sections[0]["width_mm"], sections[0]["reinforcement_mm"]
    fillet = weld.kind == "fillet"
    rows = []
    for level, factor, undercut, decision in (("B", 0.10, 0.05, "fail"), ("C", 0.15, 0.1, "pass"), ("D", 0.25, 0.2, "pass")):
        limit = 1 + factor * width
        rows.append({"imperfection": "convexity" if fillet else "excess_weld_metal", "level": level, "value_mm": height,
                     "sigma_mm": 0.006, "limit_mm": limit, "margin_mm": limit - height, "length_mm": 0.0, "decision": "pass",
                     "source": "read", "edition": "2003 with corrigendum 1:2006", "iso_6520": 503 if fillet else 502,
                     "rule": "max", "s_mm": 0.0, "sigma_margin_mm": 0.0063, "measured_mm": 49.75})
        if fillet:
            continue
        rows.append({"imperfection": "undercut", "level": level, "value_mm": 0.18, "sigma_mm": 0.008, "limit_mm": 3.2 * undercut,
                     "margin_mm": 3.2 * undercut - 0.18, "length_mm": 30.0 if level == "B" else 0.0, "decision": decision,
                     "source": "read", "edition": "2003 with corrigendum 1:2006", "iso_6520": 5011, "rule": "max",
                     "side": "left", "s_mm": 12.0, "sigma_margin_mm": 0.008, "measured_mm": 49.0})
        rows.append({"imperfection": "misalignment", "level": level, "value_mm": 0.25, "sigma_mm": 0.007, "limit_mm": 3.2 * factor,
                     "margin_mm": 3.2 * factor - 0.25, "length_mm": 0.0, "decision": "pass", "source": "unverified",
                     "edition": "not established", "iso_6520": 507, "rule": "max", "s_mm": 20.0, "sigma_margin_mm": 0.007})
        rows.append({"imperfection": "toe_angle", "level": level, "decision": "not_judged", "iso_6520": 505,
                     "value_deg": 134.0, "sigma_deg": 0.9})
    for level, decision in (("B", "fail"), ("C", "pass"), ("D", "pass")):
        rows.append({"imperfection": "weld", "level": level, "length_mm": 49.75, "decision": decision,
                     "source": "read" if decision == "fail" else "unverified"})
    order = ["excess_weld_metal", "convexity", "undercut", "misalignment", "toe_angle", "weld"]
    return sorted(rows, key=lambda row: order.index(row["imperfection"]))


def record(weld, sections):
    """weld.json's content."""
    names = {"width": ("width_mm", 1e-3), "reinforcement": ("reinforcement_mm", 1e-3), "undercut_left": ("undercut_left_mm", 1e-3),
             "toe_angle_left": ("toe_angle_left_deg", np.pi / 180), "area": ("area_mm2", 1e-6)}
    statistics = {}
    for name, (column, scale) in names.items():
        values = np.array([section[column] for section in sections]) * scale
        statistics[name] = {"count": len(values), "mean": values.mean(), "mean_sigma": 3e-6, "deviation": values.std(),
                            "least": values.min(), "largest": values.max()}
    length = len(sections) * weld.pitch
    volume = length * 2 / 3 * weld.width * weld.height
    return {"id": "K-17/3", "date": "2024-05-01T12:00:00Z", "frame_id": "weld_profiler_scan", "kind": weld.kind, "reason": "",
            "scores": {"butt": 0.97, "fillet": 0.0, "bead_on_plate": 0.02}, "sections": len(sections), "measured_share": 0.995,
            "length": {"value": length, "sigma": 1e-5}, "volume": {"value": volume, "sigma": 0.004 * volume},
            "removal_volume": {"value": 1.01 * volume, "sigma": 0.004 * volume},
            "ripple_pitch": {"value": 0.0025, "sigma": 4e-5}, "ripple_height": {"value": 8e-5, "sigma": 6e-6},
            "statistics": statistics,
            "other_beads": [{"x": 0.021, "y_from": 0.0, "y_to": 0.012, "width": 0.004, "height": 0.0006}],
            "verdict": {"overall": "C", "unverified": True, "asked": "B", "asked_decision": "fail",
                        "levels": {"B": "fail", "C": "pass", "D": "pass"},
                        "notes": ["limits not checked against a copy of ISO 5817: misalignment"],
                        "lacks_thickness": [], "limits": "ISO 5817, built in", "thickness": 0.0032},
            "settings": {"kind": "auto", "target": "flush", "rest_height": 2e-4, "max_gap": 5e-4, "level": "B"},
            "calibration": {"file": "calibration.yaml", "hash": "3f9a01c2d4e5", "date": "2024-04-28T08:00:00Z", "age_days": 3.2}}


def write_folder(folder, weld):
    """All files; the sections' values as they stand in weld.csv."""
    os.makedirs(folder, exist_ok=True)
    sections = [weld.section(index) for index in range(weld.rows)]
    write_pcd(os.path.join(folder, "weld_points.pcd"), weld.points())
    write_csv(os.path.join(folder, "weld.csv"), COLUMNS, sections)
    write_csv(os.path.join(folder, "verdict.csv"), VERDICT, verdict_rows(weld, sections))
    spots = ("kind,s_mm,x_mm,y_mm,z_mm,diameter_mm,height_mm,sigma_diameter_mm,sigma_height_mm\n"
             "spatter,14,9.5,14,0.4,1.1,0.45,0.05,0.01\npore,30,-1.5,30,2.0,0.6,-0.3,0.05,0.01\n")
    with open(os.path.join(folder, "spots.csv"), "w") as file:
        file.write(spots)
    content = record(weld, sections)
    write_json(os.path.join(folder, "weld.json"), content)
    return content, sections


def write_json(path, content):
    with open(path, "w") as file:
        json.dump(content, file)
