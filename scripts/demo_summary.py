#!/usr/bin/python3
"""Writes the demo's summary: where every frame went, how old the data was, how far the cloud is from the truth."""
import argparse
import json
import sys

from compare_with_truth import Truth, compare, report
from scan_file import ScanFileError, read_scan

KEPT = ("rows", "no stripe", "skipped", "unplaced", "dropped", "waiting")
PX_EQUIVALENT = 83.3e-6  # a pixel row of the simulated rig, in height [m]


def balance(figures):
    """Lines of the balance, and whether it closes."""
    frames_in = int(figures.get("frames in", 0))
    total = 0
    lines = ["frames in            %d" % frames_in]
    for key in KEPT:
        count = int(figures.get(key, 0))
        total += count
        lines.append("  %-18s %d" % (key, count))
        for name, value in sorted(figures.items()):
            if key in ("unplaced", "dropped") and name.startswith(key + " "):
                lines.append("    %-16s %s" % (name[len(key) + 1:], value))
    closes = frames_in > 0 and total == frames_in
    lines.append("  sum                %d, the balance %s" % (total, "closes" if closes else "does NOT close"))
    return lines, closes


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", help="figures.json of demo_watch")
    parser.add_argument("scan", help="scan.pcd")
    parser.add_argument("truth", help="centres.csv of the same run")
    arguments = parser.parse_args()
    try:
        with open(arguments.figures) as file:
            figures = json.load(file)
        scan = read_scan(arguments.scan)
        truth = compare(scan, Truth(arguments.truth), PX_EQUIVALENT)
    except (OSError, ValueError, ScanFileError) as error:
        print("demo_summary: %s" % error, file=sys.stderr)
        return 1
    lines, closes = balance(figures)
    print("One simulated scan through the nodelets, live, with rviz looking on.\n")
    print("cloud                %d rows x %d cells\n" % scan.shape)
    print("\n".join(lines))
    print("\nage of the profiles when published, from the middle of the exposure")
    for name in ("p50", "p99", "max"):
        print("  %-18s %s ms" % (name, figures.get("age %s [ms]" % name, "unknown")))
    print("\nagainst the truth of the simulation (a px-equivalent is 83.3 um of height)")
    for line in report(truth, PX_EQUIVALENT):
        print("  " + line)
    return 0 if closes else 1


if __name__ == "__main__":
    sys.exit(main())
