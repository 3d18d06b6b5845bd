"""What the tests of weld_report.py share: a folder whose numbers are known, and changing it."""
import json

from report_case import ReportCase
from weld_folder import COLUMNS, Weld, write_csv, write_folder, write_json


class WeldReportCase(ReportCase):
    """A folder with a measured weld whose numbers are known."""

    program = "weld_report"

    def make(self, kind="butt", rows=60, cells=720):
        """A small scan: 30 mm across at 42 um, 15 mm along."""
        weld = Weld(kind, rows, cells)
        self.record, self.sections = write_folder(self.folder, weld)
        return weld

    def edit(self, change):
        with open(self.path("weld.json")) as file:
            content = json.load(file)
        change(content)
        write_json(self.path("weld.json"), content)

    def written(self):
        contents = []
        for name in ("report.html", "report.png"):
            with open(self.path(name), "rb") as file:
                contents.append(file.read())
        return contents

    def rewrite_sections(self, change):
        for row in self.sections:
            change(row)
        write_csv(self.path("weld.csv"), COLUMNS, self.sections)
