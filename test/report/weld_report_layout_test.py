#!/usr/bin/python3
"""That weld_report.py draws nothing over anything."""
import os
import unittest

from weld_report_case import WeldReportCase

from report import along, style  # found through report_case
from report.cut import choose
from report.weld_folder import WeldFolder


class Layout(WeldReportCase):
    def folder_with_chosen(self, gauge=None):
        folder = WeldFolder(self.folder, gauge)
        folder.chosen = choose(folder)
        return folder

    def boxes(self, figure, texts):
        renderer = figure.canvas.get_renderer()
        return [text.get_window_extent(renderer) for text in texts]

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


if __name__ == "__main__":
    unittest.main()
