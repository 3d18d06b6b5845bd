#!/usr/bin/python3
"""weld_report.py on folders that are broken: refused, and what it leaves then."""
import json
import os
import unittest

from weld_report_case import WeldReportCase


class Broken(WeldReportCase):
    def setUp(self):
        super().setUp()
        self.make(rows=12, cells=100)

    def test_no_folder(self):
        self.folder = os.path.join(self.temporary.name, "elsewhere")
        self.assert_refused("elsewhere: is no folder")

    def test_no_weld_json(self):
        os.remove(self.path("weld.json"))
        self.assert_refused("weld.json: cannot be read: No such file", "measure the scan again")

    def test_weld_json_that_is_none(self):
        for text, cause in (("{", "is no JSON"), ("[1]", "holds no JSON object"), ("", "is no JSON")):
            with self.subTest(text):
                self.write("weld.json", text)
                self.assert_refused("weld.json", cause)
        with open(self.path("weld.json"), "wb") as file:
            file.write(b"\xff\xfe{}")
        self.assert_refused("weld.json: is no UTF-8 text")

    def test_wrong_types_in_weld_json(self):
        with open(self.path("weld.json")) as file:
            sound = file.read()
        for key, value in (("verdict", 5), ("kind", 3), ("length", "long"), ("other_beads", {}), ("other_beads", [1]),
                           ("measured_share", "all"), ("statistics", []), ("calibration", "a")):
            with self.subTest("%s %r" % (key, value)):
                self.write("weld.json", json.dumps(dict(json.loads(sound), **{key: value})))
                self.assert_refused("weld.json: " + key, "must be")

    def test_csv_with_text_for_a_number(self):
        with open(self.path("weld.csv")) as file:
            lines = file.read().splitlines()
        lines[3] = lines[3].replace(lines[3].split(",")[2], "wide", 1)
        self.write("weld.csv", "\n".join(lines))
        self.assert_refused("weld.csv: line 4: width_mm is 'wide'")

    def test_csv_with_a_short_line(self):
        with open(self.path("weld.csv")) as file:
            text = file.read()
        self.write("weld.csv", text[:-40])
        self.assert_refused("weld.csv: line 13: has")

    def test_csv_without_its_columns_or_empty(self):
        self.write("verdict.csv", "a,b\n1,2\n")
        self.assert_refused("verdict.csv: line 1: has no column imperfection, level, decision")
        self.write("verdict.csv", "")
        self.assert_refused("verdict.csv: is empty")

    def test_cloud_cut_short(self):
        with open(self.path("weld_points.pcd"), "rb") as file:
            content = file.read()
        for length in (len(content) - 9, 300, 30, 0):
            with self.subTest(length):
                with open(self.path("weld_points.pcd"), "wb") as file:
                    file.write(content[:length])
                self.assert_refused("weld_points.pcd")

    def test_cloud_with_a_damaged_header(self):
        with open(self.path("weld_points.pcd"), "rb") as file:
            content = file.read()
        for old, new in ((b"WIDTH 100", b"WIDTH abc"), (b"TYPE F", b"TYPE Q"), (b"HEIGHT 12", b"HEIGHT"), (b"FIELDS x", b"FIELDS q"),
                         (b"SIZE 4", b"SIZE 3")):
            with self.subTest(new):
                with open(self.path("weld_points.pcd"), "wb") as file:
                    file.write(content.replace(old, new, 1))
                self.assert_refused("weld_points.pcd")

    def test_gauge_readings_that_are_none(self):
        gauge = os.path.join(self.temporary.name, "gauge.csv")
        self.assert_refused("gauge.csv: cannot be read", "s_mm,width_mm,height_mm", arguments=["--gauge", gauge])
        for text, cause in (("s_mm,width_mm\n1,2\n", "has no column height_mm"), ("s_mm,width_mm,height_mm\n,1,2\n", "no reading"),
                            ("s_mm,width_mm,height_mm\n1,x,2\n", "width_mm is 'x'"),
                            ("s_mm,width_mm,height_mm,resolution_mm\n1,1,2,-1\n", "resolution_mm is below 0")):
            with self.subTest(cause):
                with open(gauge, "w") as file:
                    file.write(text)
                self.assert_refused("gauge.csv", cause, arguments=["--gauge", gauge])

    def test_an_earlier_report_stays_when_the_new_one_fails(self):
        self.page()
        with open(self.path("report.html"), "rb") as file:
            before = file.read()
        self.write("weld.csv", "x\n")
        code, _ = self.run_program(self.folder)
        self.assertEqual(code, 1)
        with open(self.path("report.html"), "rb") as file:
            self.assertEqual(file.read(), before)

    def test_a_place_that_cannot_be_written_leaves_neither_file(self):
        os.mkdir(self.path("report.png"))
        code, errors = self.run_program(self.folder)
        self.assertEqual(code, 1)
        self.assertIn("cannot be written", errors)
        self.assertFalse(os.path.exists(self.path("report.html")))
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith(".part")], [])

    def test_usage(self):
        self.assertEqual(self.run_program()[0], 2)
        self.assertEqual(self.run_program(self.folder, "--colour")[0], 2)
        self.assertEqual(self.run_program("--help")[0], 0)


if __name__ == "__main__":
    unittest.main()
