#!/usr/bin/python3
"""compare_report.py on a folder whose numbers are known."""
import json
import os
import unittest

import numpy as np

from compare_folder import write_compare
from report_case import ReportCase
from weld_folder import write_pcd

from report.compare_folder import CompareFolder  # found through report_case


class Case(ReportCase):
    program = "compare_report"

    def setUp(self):
        super().setUp()
        self.record = write_compare(self.folder, 120, 240)

    def edit(self, change):
        change(self.record)
        with open(self.path("compare.json"), "w") as file:
            json.dump(self.record, file)


class WhatIsShown(Case):
    def test_volumes_spots_and_alignment(self):
        page = self.page()
        self.assertAlmostEqual(float(page.row("removed")[1].split()[0]), 1e9 * self.record["removed_volume"]["value"], delta=0.06)
        self.assertAlmostEqual(float(page.row("remaining above the target")[1].split()[0]),
                               1e9 * self.record["remaining_volume"]["value"], delta=0.006)
        self.assertEqual(page.row("1")[1:5], ["10.0", "2.0", "10.0", "0.120 ± 0.012"])
        self.assertEqual(page.row("shift x")[1], "0.120 ± 0.008 mm")
        self.assertEqual(page.row("turn about z")[1], "0.172 ± 0.023 °")
        for part in ("OVER-GROUND", "more than 0.05 mm", "1 such place", "scans/before", "scans/after", "seen in one scan only"):
            self.assertIn(part, page.text)
        self.assertEqual(len(page.images), 3)

    def test_maps_hold_the_pit_and_the_rest(self):
        folder = CompareFolder(self.folder)
        row, column = np.unravel_index(np.nanargmin(folder.maps["remaining"]), folder.maps["remaining"].shape)
        self.assertAlmostEqual(folder.grid.left + folder.grid.dx * (column + 0.5), 2.0, delta=0.8)
        self.assertAlmostEqual(folder.grid.near + folder.grid.dy * (row + 0.5), 10.0, delta=0.8)
        y, low = folder.lowest()
        self.assertAlmostEqual(np.nanmin(low), -0.12, delta=0.02)
        y, area = folder.along("remaining")
        self.assertAlmostEqual(np.nanmean(area[y > 26]), 0.15 * 10, delta=0.2)

    def made(self, names):
        """A plate at z = 0 with a groove of 0.2 mm in the middle, before and after alike."""
        x, y = np.meshgrid(np.arange(80) * 1e-3, np.arange(40) * 1e-3)
        cloud = np.zeros(x.shape, [(name, "<f4") for name in names])
        groove = np.where(abs(x - 0.04) < 0.003, -2e-4, 0.0)
        cloud["x"], cloud["y"], cloud["z"], cloud["after"], cloud["remaining"] = x, y, groove, groove, groove
        return cloud

    def test_an_undercut_that_was_there_before_is_not_marked(self):
        write_pcd(self.path("difference.pcd"), self.made(("x", "y", "z", "after", "removed", "remaining")))
        folder = CompareFolder(self.folder)
        self.assertFalse(folder.deep.any())
        self.assertAlmostEqual(np.nanmin(folder.lowest()[1]), 0.0, delta=0.001)

    def test_the_places_of_the_file_are_marked(self):
        cloud = self.made(("x", "y", "z", "after", "removed", "remaining", "spot"))
        cloud["spot"][10:20, 60:70] = 1
        write_pcd(self.path("difference.pcd"), cloud)
        folder = CompareFolder(self.folder)
        y, x = np.nonzero(folder.deep)
        self.assertGreater(len(x), 10)
        self.assertTrue((abs(folder.grid.left + folder.grid.dx * (x + 0.5) - 64.5) < 6.5).all())
        self.assertTrue((abs(folder.grid.near + folder.grid.dy * (y + 0.5) - 14.5) < 6.5).all())

    def test_the_folder_is_called_as_asked(self):
        with open(self.path("report.html"), "w"):
            pass
        self.assertEqual(self.run_program("--named=/elsewhere/ground", self.folder)[0], 0)
        with open(self.path("report.html")) as file:
            self.assertIn("/elsewhere/ground", file.read())

    def test_a_clean_surface_is_said_to_be_one(self):
        self.edit(lambda record: record.update({"over_ground": []}))
        page = self.page()
        self.assertIn("NOT OVER-GROUND", page.text)

    def test_unknown_spots_are_no_clean_surface(self):
        self.edit(lambda record: record.pop("over_ground"))
        self.assertIn("OVER-GROUND NOT KNOWN", self.page().text)


class Input(Case):
    def test_without_the_map(self):
        os.remove(self.path("difference.pcd"))
        page = self.page()
        self.assertIn("difference.pcd is missing", page.text)
        self.assertIn("OVER-GROUND", page.text)

    def test_nulls_everywhere(self):
        self.edit(lambda record: record.update({key: None for key in list(record)}))
        self.assertIn("not measured", self.page().text)

    def test_an_empty_record_and_no_map(self):
        os.remove(self.path("difference.pcd"))
        with open(self.path("compare.json"), "w") as file:
            file.write("{}")
        self.assertIn("NOT COMPARED", self.page().text)

    def test_a_map_of_holes(self):
        cloud = np.full((4, 5), np.nan, np.float32)
        made = np.zeros((4, 5), [(name, "<f4") for name in ("x", "y", "z", "after", "removed", "remaining")])
        for name in made.dtype.names:
            made[name] = cloud
        write_pcd(self.path("difference.pcd"), made)
        self.page()
        made["x"], made["y"], made["z"] = np.meshgrid(np.arange(5) * 1e-3, np.arange(4) * 1e-3)[0], 0.001, 0.0
        write_pcd(self.path("difference.pcd"), made)  # seen before, nowhere after
        self.page()

    def test_broken_files(self):
        with open(self.path("difference.pcd"), "rb") as file:
            content = file.read()
        with open(self.path("difference.pcd"), "wb") as file:
            file.write(content[:-5])
        self.assert_refused("difference.pcd: ends after")
        with open(self.path("difference.pcd"), "wb") as file:
            file.write(content.replace(b" removed ", b" taken ", 1))
        self.assert_refused("difference.pcd: has no field removed")
        self.edit(lambda record: record.update({"aligned": {"shift": [1, 2]}}))
        with open(self.path("difference.pcd"), "wb") as file:
            file.write(content)
        self.assert_refused("compare.json: aligned.shift")
        os.remove(self.path("compare.json"))
        self.assert_refused("compare.json: cannot be read", "compare the scans again")
        self.assertEqual(self.run_program()[0], 2)


if __name__ == "__main__":
    unittest.main()
