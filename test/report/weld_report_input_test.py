#!/usr/bin/python3
"""weld_report.py on folders that are incomplete, or whose files hold little or nothing."""
import os
import unittest

import numpy as np

from weld_folder import COLUMNS, Weld, write_csv, write_folder, write_json, write_pcd
from weld_report_case import WeldReportCase


class Incomplete(WeldReportCase):
    def test_without_any_optional_file(self):
        self.make(rows=30, cells=300)
        for name in ("spots.csv", "weld_points.pcd"):
            os.remove(self.path(name))
        page = self.page()
        self.assertIn("LEVEL B NOT MET", page.text)
        for name in ("spots.csv", "weld_points.pcd"):
            self.assertIn(name + " is not in the folder", page.text)

    def test_each_file_alone_may_be_missing(self):
        for name in ("spots.csv", "weld_points.pcd"):
            with self.subTest(name):
                self.make(rows=30, cells=300)
                os.remove(self.path(name))
                self.assertIn(name + " is not in the folder", self.page().text)

    def test_the_tables_of_a_weld_must_be_there(self):
        for name in ("weld.csv", "verdict.csv"):
            with self.subTest(name):
                self.make(rows=30, cells=300)
                os.remove(self.path(name))
                self.assert_refused(name, "is missing", "30 sections")

    def test_tables_of_another_measurement_are_refused(self):
        self.make(rows=30, cells=300)
        self.edit(lambda record: record.update(id='K, "17"', settings_hash="5e77"))
        mine = {"weld_id": "K; '17'", "calibration_hash": "3f9a01c2d4e5", "settings_hash": "5e77"}
        for name in ("weld.csv", "verdict.csv", "spots.csv"):
            with open(self.path(name)) as file:
                lines = file.read().splitlines()

            def write(trace, last=None):
                tails = [",".join(mine)] + [",".join(trace.values())] * (len(lines) - 1)
                tails[-1] = ",".join((last or trace).values())
                self.write(name, "".join("%s,%s\n" % both for both in zip(lines, tails)))
            for key in mine:
                with self.subTest(name, key=key):
                    write(mine, dict(mine, **{key: "other"}))
                    self.assert_refused(name + ": is of another measurement", "%s is 'other', there '%s'" % (key, mine[key]))
            write(mine)
        self.page()

    def test_scan_pcd_serves_where_there_are_no_weld_points(self):
        weld = self.make(rows=30, cells=300)
        os.remove(self.path("weld_points.pcd"))
        cloud = weld.points()
        plain = np.zeros(cloud.shape, [(name, "<f4") for name in ("x", "y", "z")])
        for name in plain.dtype.names:
            plain[name] = cloud[name]
        write_pcd(self.path("scan.pcd"), plain)
        page = self.page()
        self.assertIn("the points carry no removal", page.text)
        self.assertEqual(page.picture("Height map")[0], "png")

    def test_a_scan_without_a_weld_gives_a_short_report(self):
        self.make(rows=30, cells=300)
        for name in ("weld.csv", "verdict.csv", "spots.csv"):
            os.remove(self.path(name))
        write_json(self.path("weld.json"), {"id": "", "kind": "none", "reason": "no bead higher than 0.05 mm", "sections": 0,
                                            "scores": {"butt": 0.01, "fillet": 0.0, "bead_on_plate": 0.02}, "verdict": {"overall": ""}})
        page = self.page()
        self.assertIn("NO WELD", page.text)
        self.assertIn("no bead higher than 0.05 mm", page.text)
        self.assertEqual([image["alt"] for image in page.images], ["Height map with toes and crest", "3-D view of the scan"])
        self.assertNotIn("Cross-sections", page.text)
        self.assertNotIn("is not in the folder", page.text)

    def test_nothing_measured_anywhere(self):
        self.make(rows=30, cells=300)
        keep = ("row", "section", "stage_mm", "s_mm", "yaw_deg", "reference")
        for empty in ("", "nan"):
            with self.subTest(empty):
                rows = [{name: row.get(name, "") if name in keep else ("" if "verdict" in name else empty) for name in COLUMNS}
                        for row in self.sections]
                write_csv(self.path("weld.csv"), COLUMNS, rows)
                page = self.page()
                self.assertIn("width b: not measured in all of 30 sections", page.text)

    def test_nulls_everywhere_in_weld_json(self):
        self.make(rows=30, cells=300)
        self.edit(lambda record: record.update({key: None for key in list(record) if key not in ("kind", "id")}))
        self.assertIn("not measured", self.page().row("length")[1])

    def test_only_a_kind_in_weld_json(self):
        self.make(rows=30, cells=300)
        write_json(self.path("weld.json"), {"kind": "butt"})
        self.assertIn("NOT JUDGED", self.page().text)

    def test_a_cloud_of_nothing_but_holes(self):
        weld = self.make(rows=30, cells=300)
        cloud = weld.points()
        for name in ("x", "y", "z", "removal"):
            cloud[name] = np.nan
        write_pcd(self.path("weld_points.pcd"), cloud)
        self.assertIn("weld_points.pcd holds no point", self.page().text)

    def test_an_empty_cloud(self):
        weld = self.make(rows=30, cells=300)
        write_pcd(self.path("weld_points.pcd"), weld.points()[:0])
        self.assertIn("weld_points.pcd holds no point", self.page().text)

    def test_few_points(self):
        for shape in ((1, 300), (3, 300), (30, 1), (1, 1)):
            with self.subTest(shape):
                weld = self.make(rows=30, cells=300)
                write_pcd(self.path("weld_points.pcd"), np.ascontiguousarray(weld.points()[:shape[0], :shape[1]]))
                self.page()

    def test_mostly_holes_and_strays(self):
        weld = self.make(rows=40, cells=300)
        cloud = weld.points()
        holes = weld.random.rand(*cloud.shape) < 0.6
        for name in ("x", "y", "z"):
            cloud[name][holes] = np.nan
        cloud["z"][20, 150], cloud["z"][21, 150], cloud["x"][22, 150] = 3.0, np.inf, -np.inf
        cloud["removal"] = np.nan
        write_pcd(self.path("weld_points.pcd"), cloud)
        self.page()

    def test_one_section_and_tables_of_a_header_only(self):
        self.make(rows=30, cells=300)
        write_csv(self.path("weld.csv"), COLUMNS, self.sections[7:8])
        self.assert_refused("weld.csv: holds 1 sections, weld.json tells of 30")
        write_csv(self.path("weld.csv"), COLUMNS, [])
        self.assert_refused("weld.csv: has no line, weld.json tells of 30 sections")
        write_csv(self.path("weld.csv"), COLUMNS, self.sections[7:8])
        self.edit(lambda record: record.update(sections=1))
        self.page()
        write_csv(self.path("weld.csv"), COLUMNS, [])
        self.edit(lambda record: record.update(sections=0))
        self.write("spots.csv", "kind,s_mm\n")
        self.write("verdict.csv", "imperfection,level,decision\n")
        self.assertIn("verdict.csv is missing or has no line", self.page().text)

    def test_a_long_weld_lies_on_its_side(self):
        self.folder += "_long"
        weld = Weld("butt", rows=300, cells=400, pitch=5e-4)
        self.record, self.sections = write_folder(self.folder, weld)
        self.assertIn("travel to the right", self.page().text)

    def test_negative_sigmas_and_absurd_numbers_do_no_harm(self):
        self.make(rows=30, cells=300)
        self.rewrite_sections(lambda row: row.update({"sigma_width_mm": -1.0, "reinforcement_mm": 1e300, "yaw_deg": 1e9}))
        self.page()


if __name__ == "__main__":
    unittest.main()
