#!/usr/bin/python3
"""Writes the report of a measured weld: DIR/report.html (one file, for screen and A4) and DIR/report.png (one page).

DIR is a folder as docs/weld-files.md describes it; docs/report.md says what the report shows. Both files appear, or
neither. Exit status: 0 written, 1 bad input (one line says file, cause and remedy), 2 usage,
130 interrupted.
"""
import argparse
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DIR", help="holds weld.json, weld.csv, verdict.csv, spots.csv, weld_points.pcd")
    parser.add_argument("--gauge", metavar="FILE.csv",
                        help="readings by hand to draw beside: s_mm,width_mm,height_mm and if known resolution_mm")
    arguments = parser.parse_args()

    from report.cut import choose  # after the usage: matplotlib takes its time
    from report.overview import overview
    from report.program import write_report
    from report.weld_figures import Relief
    from report.weld_folder import WeldFolder
    from report.weld_page import weld_page

    def make():
        folder = WeldFolder(arguments.folder, arguments.gauge)
        folder.chosen = choose(folder) if folder.has_weld() else []
        relief = Relief(folder) if folder.grid is not None else None
        return weld_page(folder, relief), overview(folder, relief)
    return write_report(arguments.folder, make)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
