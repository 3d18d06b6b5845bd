#!/usr/bin/python3
"""In a narrow window a table scrolls in its own box, the page does not; measured by a browser where there is one."""
import os
import re
import shutil
import subprocess
import sys
import unittest
from html.parser import HTMLParser

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from weld_report_case import WeldReportCase

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
PROBE = ("<script>onload = function () { var page = document.documentElement;"
         " page.innerHTML = '<p>' + page.clientWidth + ' of ' + page.scrollWidth + '</p>'; }</script></body>")
LONG = "/home/operator/calibrations/" + "a_name_without_a_blank_" * 8 + ".yaml"


class Boxes(HTMLParser):
    """What every table lies in."""

    def __init__(self):
        super().__init__()
        self.open, self.around = [], []

    def handle_starttag(self, tag, attributes):
        if tag == "table":
            self.around.append(self.open[-1])
        if tag not in ("meta", "img", "br"):
            self.open.append((tag, dict(attributes).get("class", "")))

    def handle_endtag(self, tag):
        self.open.pop()


class ReportWidth(WeldReportCase):

    def setUp(self):
        super().setUp()
        self.make()
        self.edit(lambda record: (record.update(id="N" * 90), record["calibration"].update(file=LONG)))
        self.change_rows()

    def change_rows(self):
        """As wide as they come: two digits of s, the side, a limit that was not verified in every line."""
        with open(self.path("verdict.csv"), encoding="utf-8") as file:
            head, *lines = [line.rstrip("\n").split(",") for line in file]
        for line in lines:
            if line[head.index("imperfection")] == "misalignment":
                line[head.index("side")], line[head.index("s_mm")] = "right", "123.4"
        self.write("verdict.csv", "\n".join(",".join(line) for line in [head] + lines) + "\n")

    def html(self):
        self.page()
        with open(self.path("report.html"), encoding="utf-8") as file:
            return file.read()

    def widths(self, content, window):
        """(of the window, of what it shows) in pixels of the screen."""
        self.write("probe.html", content.replace("</body>", PROBE))
        shown = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=%d,900" % window,
                                "--user-data-dir=" + os.path.join(self.temporary.name, "browser"), "--dump-dom",
                                "file://" + self.path("probe.html")],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=100, check=False)
        found = re.search(r"<p>(\d+) of (\d+)</p>", shown.stdout.decode("utf-8", "replace"))
        if not found:
            self.skipTest(BROWSER + " does not show a page here")
        return int(found.group(1)), int(found.group(2))

    def test_every_table_lies_in_a_box_that_scrolls(self):
        content, boxes = self.html(), Boxes()
        boxes.feed(content)
        self.assertGreater(len(boxes.around), 6)
        self.assertEqual(set(boxes.around), {("div", "scroll")})
        self.assertIn(".scroll { overflow-x: auto; }", content)
        self.assertRegex(content, r"@media print \{ \.scroll \{ overflow: visible; \}", "paper has no bar to scroll with")

    @unittest.skipUnless(BROWSER, "no browser")
    def test_the_page_is_no_wider_than_its_window(self):
        content = self.html()
        for window in (800, 500):
            inside, shown = self.widths(content, window)
            self.assertLessEqual(inside, window)
            self.assertEqual(shown, inside, "a window of %d" % window)
        own = content.replace(".scroll { overflow-x: auto; }", "")
        inside, shown = self.widths(own, 800)
        self.assertEqual(shown, inside, "the table of verdicts fits a window of 800 without scrolling")


if __name__ == "__main__":
    unittest.main()
