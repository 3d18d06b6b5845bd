#!/usr/bin/python3
"""Draws width and height along three simulated welds, as measured and as read off a weld gauge (the paper's Fig. 11).

  plot_weld_gauge.py --json FILE [--out docs/figures/weld_gauge.png]

FILE is what `scripts/bench weld_accuracy --gauge-only --json FILE` wrote.
"""
import argparse
import json
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MEASURED, TRUE, GAUGE = "#1f77b4", "#000000", "#d62728"


def load(path):
    """The welds in order: name -> the rows of scan and gauge."""
    with open(path, encoding="utf-8") as file:
        rows = json.load(file)["tables"]["gauge"]["rows"]
    welds = {}
    for row in rows:
        welds.setdefault(row["weld"], {"scan": [], "gauge": [], "truth": [], "summary": []})[row["source"]].append(row)
    if not welds or any(not weld["scan"] or not weld["gauge"] for weld in welds.values()):
        raise ValueError("the table `gauge` has no welds with sections and readings")
    return welds


def column(rows, name):
    return [float("nan") if row[name] is None else row[name] for row in rows]


def draw_quantity(axis, weld, name, label):
    scan, gauge, truth = weld["scan"], weld["gauge"], weld["truth"]
    axis.plot(column(truth, "s_mm"), column(truth, "%s_mm" % name), color=TRUE, linewidth=0.8, label="truth", zorder=3)
    axis.plot(column(scan, "s_mm"), column(scan, "%s_mm" % name), ".", color=MEASURED, markersize=3, label="scan",
              zorder=2)
    # half a reading's step either way, and the error of reading it
    axis.errorbar(column(gauge, "s_mm"), column(gauge, "%s_mm" % name), yerr=0.1, fmt="s", color=GAUGE, markersize=4,
                  capsize=2, linewidth=0.8, label="gauge, read to 0.1 mm", zorder=1)
    read = column(gauge, "%s_mm" % name)
    axis.set_ylim(min(read) - 0.25, max(read) + 0.25)  # the weld's ends run out of the picture
    axis.set_ylabel("%s [mm]" % label)
    axis.grid(alpha=0.3)


def draw(welds, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(2, len(welds), figsize=(4.2 * len(welds), 5.4), sharex=True, squeeze=False)
    for i, (name, weld) in enumerate(welds.items()):
        draw_quantity(axes[0, i], weld, "width", "width")
        draw_quantity(axes[1, i], weld, "height", weld["scan"][0]["height"])
        axes[0, i].set_title(name)
        axes[1, i].set_xlabel("along the weld [mm]")
        axes[1, i].set_xlim(-1.0, 51.0)
    axes[0, 0].legend(loc="lower center", fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", required=True, help="what weld_accuracy wrote")
    parser.add_argument("--out", default=os.path.join(ROOT, "docs", "figures", "weld_gauge.png"))
    arguments = parser.parse_args()
    try:
        draw(load(arguments.json), arguments.out)
    except (OSError, KeyError, ValueError) as error:
        sys.exit("plot_weld_gauge.py: %s: %s; give it the --json of weld_accuracy" % (arguments.json, error))


if __name__ == "__main__":
    main()
