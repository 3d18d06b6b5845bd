#!/usr/bin/python3
"""What weld_report.py says beside the verdict, on the page and in the picture, and that nothing is drawn over anything."""
import csv
import os
import unittest
from unittest import mock

from weld_folder import write_csv
from weld_report_case import WeldReportCase

from report import along, overview, plan, style, weld_figures  # found through report_case
from report.cut import choose
from report.verdicts import UNVERIFIED
from report.weld_folder import WeldFolder


class Layout(WeldReportCase):
    def folder_with_chosen(self, gauge=None):
        folder = WeldFolder(self.folder, gauge)
        folder.chosen = choose(folder)
        return folder

    def picture_says(self):
        """All text beside the verdict in report.png."""
        figure = style.page(overview.HEIGHT, overview.WIDTH)
        overview._head(figure, self.folder_with_chosen())
        return " ".join(" ".join(text.get_text().split()) for text in figure.texts)

    def boxes(self, figure, texts):
        renderer = figure.canvas.get_renderer()
        return [text.get_window_extent(renderer) for text in texts]

    def change_verdict_rows(self, change):
        with open(self.path("verdict.csv")) as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            change(row)
        write_csv(self.path("verdict.csv"), list(rows[0]), rows)

    def test_limits_outside_are_named_where_nothing_else_is(self):
        self.make()
        self.rewrite_sections(lambda row: row.update(reinforcement_mm=0.15 + 0.001 * row["section"], height_left_mm=0.4,
                                                     height_right_mm=0.05))
        gauge = os.path.join(self.temporary.name, "gauge.csv")
        with open(gauge, "w") as file:
            file.write("s_mm,width_mm,height_mm\n2,10,0.2\n")
        style.prepare()
        figure = style.page(2.0)
        axes = figure.add_axes([0.1, 0.2, 0.87, 0.55])
        folder = self.folder_with_chosen(gauge)
        _, beyond = along.draw_height(axes, folder)
        self.assertEqual(len(beyond), 3, "all limits lie far above 0.15 mm")
        along.finish(axes, folder, beyond, True)
        figure.canvas.draw()
        named = [text for text in axes.texts if text.get_text().startswith("limits outside: B ")]
        self.assertEqual(len(named), 1)
        box = self.boxes(figure, named)[0]
        others = self.boxes(figure, [text for text in axes.texts if text is not named[0]] + [axes.get_legend()])
        self.assertEqual(len(axes.get_legend().get_texts()), 4, "three heights and the gauge")
        for other in others:
            self.assertFalse(box.overlaps(other))
        highest = axes.transData.transform((0.0, 0.4))[1]
        self.assertGreater(box.y0, highest, "over a value")
        self.assertLessEqual(box.y1, axes.bbox.y1)

    def test_numbers_of_sections_lie_in_the_map_and_apart(self):
        self.make()
        folder = WeldFolder(self.folder)
        folder.chosen = [0, 1, 30, 32, 59]
        figure = style.page(4.0)
        axes = figure.add_axes([0.1, 0.2, 0.6, 0.6])
        plan.height_map(figure, axes, folder)
        figure.canvas.draw()
        numbers = [text for text in axes.texts if text.get_text().isdigit()]
        self.assertEqual(len(numbers), 10)
        patches = [text.get_bbox_patch().get_window_extent(figure.canvas.get_renderer()) for text in numbers]
        for i, box in enumerate(patches):
            for corner in ((box.x0, box.y0), (box.x1, box.y1)):
                self.assertTrue(axes.bbox.expanded(1.02, 1.02).contains(*corner), numbers[i].get_text())
            for other in patches[:i]:
                self.assertFalse(box.shrunk(0.9, 0.9).overlaps(other.shrunk(0.9, 0.9)), numbers[i].get_text())

    def test_maps_have_room_for_all_that_is_written_beside_them(self):
        style.prepare()
        for rows, cells in ((60, 720), (40, 1000), (200, 300)):
            self.make(rows=rows, cells=cells)
            folder = self.folder_with_chosen()
            shape = plan.Plan(folder.grid)
            for draw in (plan.height_map, plan.removal_map):
                with mock.patch.object(style, "png", side_effect=lambda figure, dpi: figure):
                    figure = weld_figures.map_figure(folder, draw, shape.wide())
                figure.canvas.draw()
                axes, colours = figure.axes
                written = [axes.xaxis.label, axes.yaxis.label, axes.get_legend(), colours.yaxis.label]
                low, high = colours.get_ylim()
                written += [text for place, text in zip(colours.get_yticks(), colours.get_yticklabels()) if low <= place <= high]
                self.assertGreater(len(written), 5)
                for text, box in zip(written, self.boxes(figure, written)):
                    for corner in ((box.x0, box.y0), (box.x1, box.y1)):
                        self.assertTrue(figure.bbox.expanded(1.001, 1.001).contains(*corner), (rows, cells, text))
                label, legend = self.boxes(figure, [axes.xaxis.label, axes.get_legend()])
                self.assertFalse(label.overlaps(legend), (rows, cells))

    def test_both_say_how_little_was_measured(self):
        self.make()
        reason = "59 of 60 sections could not be measured: a toe is hidden; the volumes are of 0.2 mm of weld, 15 mm were seen"
        notes = ["only 0.2 mm of weld were seen: the verdict is about no more than these",
                 "limits not checked against a copy of ISO 5817: misalignment"]
        self.edit(lambda record: (record.update(reason=reason, measured_share=1 / 60),
                                  record["verdict"].update(overall="undecided", asked_decision="undecided", notes=notes,
                                                           levels=dict.fromkeys("BCD", "undecided"))))
        page, picture = self.page().text, self.picture_says()
        for said in (page, picture):
            self.assertIn("LEVEL B UNDECIDED", said)
            self.assertNotIn("MET", said)
            self.assertIn("59 of 60 sections could not be measured: a toe is hidden.", said)
            self.assertIn("The volumes are of 0.2 mm of weld, 15 mm were seen.", said)
            self.assertIn("Only 0.2 mm of weld were seen: the verdict is about no more than these.", said)
        self.assertNotIn("not checked against", picture, "told by: " + UNVERIFIED)
        self.assertIn(UNVERIFIED, picture)

    def test_says_by_what_the_level_asked_for_fails_and_what_is_open(self):
        self.make()
        self.assertIn("Asked for: level B, which fails by undercut.", self.page().text)
        self.edit(lambda record: record["verdict"].update(overall="undecided",
                                                          levels={"B": "fail", "C": "fail", "D": "undecided"}))
        self.assertIn("Level D is undecided: a limit lies within", self.page().text)
        self.edit(lambda record: record["verdict"].update(overall="fail", asked="", asked_decision="not_judged"))
        self.change_verdict_rows(lambda row: row.update(decision="fail") if row["imperfection"] == "misalignment" else None)
        self.assertIn("Not even level D is met: linear misalignment.", self.picture_says())

    def test_without_a_thickness_no_level_stands_large(self):
        self.make()
        self.edit(lambda record: record["verdict"].update(thickness=None, lacks_thickness=["undercut", "misalignment"]))
        self.change_verdict_rows(lambda row: row.update(decision="not_judged", limit_mm="", edition="")
                                 if row["imperfection"] in ("undercut", "misalignment") else None)
        alone = "Level C is the best level met by what was judged, which is only: excess weld metal."
        for asked, decision in (("", "not_judged"), ("C", "not_judged")):
            self.edit(lambda record: record["verdict"].update(asked=asked, asked_decision=decision))
            page = self.page()
            for said in (page.text, self.picture_says()):
                self.assertIn("NOT FULLY JUDGED", said)
                self.assertNotIn("LEVEL C", said)
                self.assertIn(alone, said)
            self.assertIn("level C by what was judged (%s)." % UNVERIFIED, page.text, "of a section")
        self.edit(lambda record: record["verdict"].update(asked="B", asked_decision="fail"))
        for said in (self.page().text, self.picture_says()):
            self.assertIn("LEVEL B NOT MET", said, "one failure suffices")
            self.assertIn(alone, said)

    def test_a_level_asked_for_is_not_told_as_met_where_not_all_was_judged(self):
        self.make()
        self.edit(lambda record: record["verdict"].update(
            overall="undecided", asked="C", asked_decision="not_judged", thickness=None, lacks_thickness=["undercut"],
            levels={"B": "undecided", "C": "pass", "D": "pass"}))
        for said in (self.page().text, self.picture_says()):
            self.assertIn("NOT FULLY JUDGED", said)
            self.assertIn("Asked for: level C.", said)

    def test_a_table_that_needs_no_thickness_is_judged_without_one(self):
        self.make()
        self.edit(lambda record: record["verdict"].update(asked="C", asked_decision="pass", thickness=None, limits="own.yaml"))
        page = self.page()
        for said in (page.text, self.picture_says()):
            self.assertIn("LEVEL C MET", said)
            self.assertIn("Level C is the best level met.", said)
        self.assertNotIn("by what was judged", page.text)
        self.edit(lambda record: record["verdict"].pop("lacks_thickness"))
        self.assertIn("NOT FULLY JUDGED", self.page().text, "of an earlier version, which did not say")

    def test_with_a_thickness_the_level_stands_large(self):
        self.make()
        self.edit(lambda record: record["verdict"].update(asked="", asked_decision="not_judged"))
        for said in (self.page().text, self.picture_says()):
            self.assertIn("LEVEL C", said)
            self.assertNotIn("JUDGED", said)

    def test_more_than_fits_the_picture_is_said_to_be_on_the_page(self):
        self.make()
        self.edit(lambda record: record.update(reason="; ".join("something is missing %d" % i for i in range(30))))
        picture = self.picture_says()
        self.assertIn("more in report.html", picture)
        self.assertIn(UNVERIFIED, picture, "is said however long the rest is")
        self.assertIn("Something is missing 29.", self.page().text)

    def test_shows_sections_that_were_measured_each_once(self):
        self.make()
        for row in self.sections:
            if row["section"] != 40:
                row["width_mm"] = ""
        self.rewrite_sections(lambda row: None)
        self.assertEqual(choose(WeldFolder(self.folder)), [40])

    def test_a_kind_is_not_said_to_lack_what_it_has_not(self):
        self.make("fillet")
        self.rewrite_sections(lambda row: row.update(misalignment_mm="", incomplete_fill_mm=""))
        self.edit(lambda record: record["statistics"].update(misalignment={"count": 0}, undercut_right={"count": 0}))
        page = self.page()
        self.assertNotIn("misalignment", [row[0].split(" [")[0] for row in page.rows if row])
        self.assertNotIn("misalignment: not measured", page.text)
        self.assertEqual(page.row("undercut right [mm]")[1], "0")

    def test_what_is_not_judged_rests_on_no_limit(self):
        self.make()
        self.change_verdict_rows(lambda row: row.update(source="unverified"))
        page = self.page()
        self.assertNotIn(UNVERIFIED, page.row("incorrect weld toe, no. 505")[-1])
        self.assertIn(UNVERIFIED, page.row("linear misalignment, no. 507")[-1])


if __name__ == "__main__":
    unittest.main()
