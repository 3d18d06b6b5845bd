#!/usr/bin/python3
"""What weld_report.py draws along a weld: limits, and readings by hand."""
import csv
import os
import unittest

import numpy as np

from weld_folder import write_csv
from weld_report_case import WeldReportCase

from report.limits import height_limits  # found through report_case
from report.weld_folder import WeldFolder


class AlongTheWeld(WeldReportCase):
    def test_draws_limits_of_the_height_that_follow_the_width(self):
        weld = self.make()
        lines, agrees = height_limits(WeldFolder(self.folder))
        self.assertTrue(agrees)
        for level, factor in (("B", 0.10), ("C", 0.15), ("D", 0.25)):
            s, limit = lines[level]
            self.assertEqual(len(s), weld.rows)
            np.testing.assert_allclose(limit, [1 + factor * row["width_mm"] for row in self.sections], atol=1e-4)

    def test_draws_no_limits_that_the_verdict_contradicts(self):
        self.make()
        with open(self.path("verdict.csv")) as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            if row["imperfection"] == "excess_weld_metal":
                row["limit_mm"] = "0.8"
        write_csv(self.path("verdict.csv"), list(rows[0]), rows)
        self.assertIn("Limits are not drawn", self.page().text)

    def test_a_table_of_its_own_is_drawn_when_it_is_stated(self):
        self.make()
        self.edit(lambda record: record["verdict"].update({"height_limits": {"B": {"base": 0.002, "factor": 0.0, "cap": None}}}))
        with open(self.path("verdict.csv")) as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            if row["imperfection"] == "excess_weld_metal":
                row["limit_mm"] = "2.0" if row["level"] == "B" else ""
        write_csv(self.path("verdict.csv"), list(rows[0]), rows)
        lines, agrees = height_limits(WeldFolder(self.folder))
        self.assertTrue(agrees)
        self.assertEqual(list(lines), ["B"])
        np.testing.assert_allclose(lines["B"][1], 2.0)

    def test_compares_with_readings_by_hand(self):
        self.make()
        readings = ["s_mm,width_mm,height_mm,resolution_mm"]
        for index, offset in ((10, 0.02), (25, 0.04), (40, 0.06)):
            row = self.sections[index]
            readings.append("%.6f,%.6f,%.6f,0.1" % (row["s_mm"], row["width_mm"] - offset, row["reinforcement_mm"] + 0.05))
        readings.append("99,10,2,0.1")  # beyond the weld: nothing to compare with
        gauge = os.path.join(self.temporary.name, "gauge.csv")
        with open(gauge, "w") as file:
            file.write("\n".join(readings) + "\n")
        page = self.page("--gauge", gauge)
        begin = page.rows.index(page.row("scan − gauge [mm]"))
        self.assertEqual(page.rows[begin + 1][:5], ["width", "3", "0.040", "0.020", "0.060"])
        self.assertEqual(page.rows[begin + 2][:5], ["height", "3", "-0.050", "0.000", "0.050"])
        self.assertEqual(page.rows[begin + 1][5], "3 of 3")
        self.assertIn("steps of 0.1 mm", page.text)

    def test_readings_without_resolution_say_so(self):
        self.make(rows=30, cells=300)
        gauge = os.path.join(self.temporary.name, "gauge.csv")
        with open(gauge, "w") as file:
            file.write("s_mm,width_mm,height_mm\n2,10,\n4,,2.1\n")
        self.assertIn("resolution was not stated", self.page("--gauge", gauge).text)


if __name__ == "__main__":
    unittest.main()
