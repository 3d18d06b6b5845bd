#!/usr/bin/python3
"""Writes the report of a comparison before and after grinding: DIR/report.html and DIR/report.png.

DIR holds compare.json and difference.pcd as compare_scans leaves them (docs/report.md). Both files appear, or neither.
Exit status: 0 written, 1 bad input (one line says file, cause and remedy), 2 usage.
"""
import argparse
import os
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DIR", help="holds compare.json and difference.pcd")
    parser.add_argument("--named", metavar="PATH", help="the folder's name in the report, where it is not DIR")
    arguments = parser.parse_args()

    from report import style  # after the usage: matplotlib takes its time
    from report.compare_folder import CompareFolder
    from report.compare_page import compare_overview, compare_page
    from report.files import ReportError, write_together
    try:
        style.prepare()
        folder = CompareFolder(arguments.folder, arguments.named)
        write_together({os.path.join(arguments.folder, "report.html"): compare_page(folder),
                        os.path.join(arguments.folder, "report.png"): compare_overview(folder)})
    except ReportError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
