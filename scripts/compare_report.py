#!/usr/bin/python3
"""Writes the report of a comparison before and after grinding: DIR/report.html and DIR/report.png.

DIR holds compare.json and difference.pcd as compare_scans leaves them (docs/report.md). Both files appear, or neither.
Exit status: 0 written, 1 bad input (one line says file, cause and remedy), 2 usage,
130 interrupted.
"""
import argparse
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DIR", help="holds compare.json and difference.pcd")
    parser.add_argument("--named", metavar="PATH", help="the folder's name in the report, where it is not DIR")
    arguments = parser.parse_args()

    from report.compare_folder import CompareFolder  # after the usage: matplotlib takes its time
    from report.compare_page import compare_overview, compare_page
    from report.program import write_report

    def make():
        folder = CompareFolder(arguments.folder, arguments.named)
        return compare_page(folder), compare_overview(folder)
    return write_report(arguments.folder, make)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
