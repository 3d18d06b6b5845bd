#!/usr/bin/python3
"""weld_report.py on folders whose numbers are known."""
import csv
import os
import re
import subprocess
import sys
import unittest

import numpy as np

from report_case import SCRIPTS
from weld_folder import write_csv
from weld_report_case import WeldReportCase

from report.cut import Cut  # found through report_case
from report.weld_folder import WeldFolder

UNVERIFIED = "rests on limits that were not verified"


def number(text):
    """The value of `12.03 ± 0.02 mm`."""
    return float(text.split()[0])


class WhatIsShown(WeldReportCase):
    def test_names_the_weld_and_its_verdict_with_what_it_rests_on(self):
        self.make()
        page = self.page()
        for part in ("K-17/3", "butt weld", "2024-05-01 12:00:00 UTC", "LEVEL B NOT MET", "Level C is the best level met",
                     "This verdict " + UNVERIFIED, "ISO 5817, built in", "3f9a01c2d4e5", "3.2 days", "calibration.yaml",
                     "Another bead was seen", "x 21.0 mm", "weld_profiler"):
            self.assertIn(part, page.text)
        row = page.row("linear misalignment, no. 507")
        self.assertIn(UNVERIFIED, row[-1])
        self.assertNotIn(UNVERIFIED, page.row("undercut, no. 5011")[-1])

    def test_does_not_speak_of_unverified_limits_when_all_were(self):
        self.make()
        self.edit(lambda record: record["verdict"].update({"unverified": False}))
        with open(self.path("verdict.csv")) as file:
            text = file.read()
        self.write("verdict.csv", text.replace("unverified", "read"))
        self.rewrite_sections(lambda row: row.update({"verdict_source": "read"}))
        self.assertNotIn(UNVERIFIED, self.page().text)

    def test_says_why_a_verdict_is_open(self):
        self.make(rows=30, cells=300)
        self.edit(lambda record: record["verdict"].update({"overall": "undecided", "asked": "", "asked_decision": "not_judged"}))
        with open(self.path("verdict.csv")) as file:
            rows = list(csv.DictReader(file))
        deciding = [row for row in rows if row["imperfection"] == "excess_weld_metal" and row["level"] == "D"]
        self.assertEqual(len(deciding), 1)
        near, little = "A limit lies within two standard deviations", "Too little of the weld was measured"
        for margin, sentence, other in (("0.001", near, little), ("1.2", little, near)):
            deciding[0].update({"decision": "undecided", "margin_mm": margin, "sigma_margin_mm": "0.006"})
            write_csv(self.path("verdict.csv"), list(rows[0]), rows)
            page = self.page()
            self.assertIn(sentence, page.text)
            self.assertNotIn(other, page.text)

    def test_says_what_a_verdict_waits_for(self):
        self.make(rows=30, cells=300)
        self.edit(lambda record: record["verdict"].update({"overall": "undecided", "asked": "", "asked_decision": "not_judged",
                                                           "waits_for": ["undercut", "excess_weld_metal"]}))
        self.assertIn("It waits for what was not measured: undercut, excess weld metal.", self.page().text)

    def test_draws_no_parent_line_through_what_is_no_base_metal(self):
        self.make("bead_on_plate")
        folder = WeldFolder(self.folder)
        index = len(self.sections) // 2
        clean = Cut(folder, index).line_right
        labels = folder.cloud.labels().copy()
        labels[:, 530:700] = 0  # a bead beside it, most of what is seen of the plate
        folder.cloud.labels = lambda: labels
        folder.cloud.z[:, 530:700] += 0.8
        found = Cut(folder, index).line_right
        self.assertAlmostEqual(found[0], clean[0], delta=0.004)
        self.assertAlmostEqual(found[1], clean[1], delta=0.02)

    def test_shows_the_numbers_of_the_files(self):
        self.make()
        page = self.page()
        self.assertEqual(page.row("length")[1], "15.000 ± 0.020 mm")
        volume = 1e9 * self.record["volume"]["value"]
        self.assertAlmostEqual(number(page.row("volume over the chord")[1]), volume, delta=0.05)
        self.assertAlmostEqual(number(page.row("volume to remove")[1]), 1.01 * volume, delta=0.05)
        widths = [row["width_mm"] for row in self.sections]
        row = page.row("width [mm]")
        self.assertEqual(row[1], "60")
        self.assertAlmostEqual(number(row[2]), np.mean(widths), delta=6e-4)
        self.assertAlmostEqual(float(row[4]), min(widths), delta=6e-4)
        self.assertAlmostEqual(float(row[5]), max(widths), delta=6e-4)
        angles = [row["toe_angle_left_deg"] for row in self.sections]
        self.assertAlmostEqual(number(page.row("toe angle left [°]")[2]), np.mean(angles), delta=0.06)

    def test_shows_each_line_of_the_verdict(self):
        self.make()
        page = self.page()
        with open(self.path("verdict.csv")) as file:
            lines = [row for row in csv.DictReader(file) if row["imperfection"] != "weld"]
        self.assertEqual(len(lines), 12)
        start = page.rows.index(page.row("excess weld metal, no. 502"))
        for line, row in zip(lines, page.rows[start:]):
            self.assertEqual(row[1], line["level"])
            if line["limit_mm"]:
                self.assertAlmostEqual(number(row[2]), float(line["value_mm"]), delta=6e-4)
                self.assertAlmostEqual(number(row[3]), float(line["limit_mm"]), delta=6e-4)
                self.assertAlmostEqual(number(row[4]), float(line["margin_mm"]), delta=6e-4)
            self.assertIn({"pass": "pass", "fail": "FAIL", "not_judged": "not judged"}[line["decision"]], row[-1])

    def test_draws_three_sections_or_more_with_the_values_of_weld_csv(self):
        self.make()
        page = self.page()
        header = page.row("section")
        self.assertGreaterEqual(len(header), 4)
        drawn = [image for image in page.images if image["alt"].startswith("Cross-section")]
        self.assertEqual(len(drawn), len(header) - 1)
        places = [float(place) for place in re.findall(r"Section \d–\d at s = ([0-9.]+) mm", page.text)]
        self.assertEqual(len(places), len(drawn))
        widths = page.row("width b [mm]")
        for place, shown in zip(places, widths[1:]):
            row = self.sections[int(round(place / 0.25))]
            self.assertAlmostEqual(number(shown), row["width_mm"], delta=6e-4)

    def test_height_map_shows_the_bead_where_it_is(self):
        weld = self.make("bead_on_plate")
        folder = WeldFolder(self.folder)
        self.assertTrue(folder.levelled)
        crest = np.nanmax(folder.heights)
        self.assertAlmostEqual(crest, 1e3 * weld.height, delta=0.35)
        row, column = np.unravel_index(np.nanargmax(folder.heights), folder.heights.shape)
        x = folder.grid.left + folder.grid.dx * (column + 0.5)
        y = folder.grid.near + folder.grid.dy * (row + 0.5)
        self.assertLess(abs(1e3 * weld.across(1e-3 * x, 1e-3 * y)[0]), 2.0)

    def test_the_bead_is_bright_in_the_map_and_the_block(self):
        self.make("bead_on_plate")
        page = self.page()
        for alt in ("Height map", "3-D view"):
            _, picture = page.picture(alt)
            yellow = (picture[..., 0] - picture[..., 2] > 0.25).mean()
            self.assertTrue(0.02 < yellow < 0.6, "%s: %.3f of it is the colour of the bead" % (alt, yellow))

    def test_fillet_shows_legs_and_throat(self):
        self.make("fillet")
        page = self.page()
        self.assertIn("fillet weld", page.text)
        self.assertIn("excessive convexity, no. 503", [row[0] for row in page.rows if row])
        self.assertAlmostEqual(number(page.row("throat [mm]")[1].replace("(", " (")), 5.0, delta=0.3)

    def test_same_input_same_bytes(self):
        self.make(rows=30, cells=300)
        self.page()
        first = self.written()
        self.page()
        self.assertEqual(first, self.written())

    def test_runs_as_a_program(self):
        self.make(rows=20, cells=200)
        run = subprocess.run([sys.executable, "-B", os.path.join(SCRIPTS, "weld_report.py"), self.folder], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual((run.returncode, run.stdout), (0, ""))
        self.assertTrue(os.path.exists(self.path("report.html")))

    def test_a_name_is_text_and_nothing_else(self):
        self.make(rows=30, cells=300)
        name = "<script>alert('1')</script> $x^$ \u710a\u7f1d & \"K\""
        self.edit(lambda record: record.update({"id": name}))
        page = self.page()
        self.assertIn(name, page.text)
        self.assertNotIn("script", page.tags)


if __name__ == "__main__":
    unittest.main()
