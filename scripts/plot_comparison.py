#!/usr/bin/python3
"""Draws what benchmark/stripe_comparison measured, and keeps README.md's table equal to it.

  plot_comparison.py                 figures and README.md from docs/figures/stripe_comparison.json
  plot_comparison.py --json FILE     keeps FILE as docs/figures/stripe_comparison.json first
  plot_comparison.py --check         changes nothing; exit status 1 if README.md's table is not that of the json
"""
import argparse
import json
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BEGIN, END = "<!-- comparison: begin -->", "<!-- comparison: end -->"
COLOURS = {"ridge": "#d62728", "steger": "#1f77b4", "opencv_steger": "#7f7f7f", "squared_centroid": "#2ca02c",
           "gray_centroid": "#98df8a", "svd": "#9467bd", "pca": "#c5b0d5", "gauss_fit": "#ff7f0e", "fir_peak": "#17becf",
           "log_parabola": "#bcbd22", "paper_to_the_letter": "#000000"}
LABELS = {"opencv_steger": "textbook Steger (OpenCV)", "paper_to_the_letter": "paper to the letter"}


class Comparison:
    """The tables of one run, as lists of {column: value}."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
        self.tables = {name: table["rows"] for name, table in content["tables"].items()}
        self.acceptance = content["acceptance"]

    def rows(self, table, **where):
        return [row for row in self.tables.get(table, []) if all(row.get(key) == value for key, value in where.items())]

    def value(self, table, column, **where):
        """Of the one row that fits; None if there is none."""
        found = self.rows(table, **where)
        return found[0].get(column) if found else None

    def methods(self):
        return list(dict.fromkeys(row["method"] for row in self.tables.get("clean", [])))


def median(values):
    values = sorted(value for value in values if value is not None)
    return values[len(values) // 2] if values else None


def text(value, decimals):
    if value is None:
        return "–"
    return "%.*f" % (decimals, value) if abs(value) < 1000 else "%.0f" % value


def table_lines(run):
    """The table of README.md, a method a line."""
    columns = [
        ("clean", lambda m: text(median([row["rmse_mpx"] for row in run.rows("clean", method=m, snr=50, sigma=2)]), 1)),
        ("/ bound of a column",
         lambda m: text(median([row["ratio_column"] for row in run.rows("clean", method=m)]), 2)),
        ("/ bound of the columns used",
         lambda m: text(median([row["ratio_used"] for row in run.rows("clean", method=m)]), 2)),
        ("bead", lambda m: text(run.value("scenes", "rmse_mpx", scene="bead", method=m), 0)),
        ("reflectance", lambda m: text(run.value("scenes", "rmse_mpx", scene="reflectance", method=m), 0)),
        ("speckle", lambda m: text(run.value("scenes", "rmse_mpx", scene="speckle", method=m), 0)),
        ("notch kept", lambda m: text(run.value("notch", "snr_50", method=m), 0) + " %"),
        ("ghosts: off / missing",
         lambda m: "%s / %s %%" % (text(run.value("scenes", "outliers%", scene="ghosts", method=m), 1),
                                   text(run.value("scenes", "missing%", scene="ghosts", method=m), 1))),
        ("time [us]", lambda m: text(run.value("times", "cold_us", method=m), 0)),
        ("/ read", lambda m: text(run.value("times", "ratio", method=m), 1)),
    ]
    lines = ["| | " + " | ".join(name for name, _ in columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for method in run.methods():
        name = LABELS.get(method, "`%s`" % method)
        lines.append("| %s | " % name + " | ".join(cell(method) for _, cell in columns) + " |")
    return lines


def with_table(readme, run):
    """README's text with the table in its place."""
    begin, end = readme.find(BEGIN), readme.find(END)
    if begin < 0 or end < begin:
        raise ValueError("README.md has no '%s' followed by '%s': put both where the table is to stand" % (BEGIN, END))
    return readme[:begin] + BEGIN + "\n" + "\n".join(table_lines(run)) + "\n" + readme[end:]


def figure(width, height):
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    page = Figure(figsize=(width, height))
    FigureCanvasAgg(page)
    return page


def style(method):
    return {"color": COLOURS.get(method), "label": LABELS.get(method, method),
            "linestyle": "--" if method in LABELS else "-", "linewidth": 2.4 if method == "ridge" else 1.3}


def save(page, path):
    """Whole or not at all."""
    partial = path + ".partial.png"
    page.savefig(partial, dpi=110, bbox_inches="tight")
    os.replace(partial, path)


def rms(values):
    values = [value for value in values if value is not None]
    return (sum(value * value for value in values) / len(values)) ** 0.5 if values else None


def draw_snr(run, folder):
    """RMSE over the slopes against SNR, sigma 2 px, with the bound of one column."""
    page = figure(8.5, 5.2)
    axes = page.add_subplot()
    snrs = sorted({row["snr"] for row in run.rows("clean")})
    for method in run.methods():
        values = [rms([row["rmse_mpx"] for row in run.rows("clean", method=method, snr=snr, sigma=2)]) for snr in snrs]
        if all(value is not None for value in values):
            axes.loglog(snrs, values, marker="o", markersize=4, **style(method))
    first = run.methods()[0]
    bound = [rms([row["bound_of_column_mpx"] for row in run.rows("clean", method=first, snr=snr, sigma=2)]) for snr in snrs]
    axes.loglog(snrs, bound, color="black", linestyle=":", linewidth=1.6, label="bound of one column")
    default = [row for row in run.acceptance if row["what"].startswith("clean")]
    if default and "ridge" in run.methods():
        used = [rms([row["bound_of_used_mpx"] for row in run.rows("clean", method="ridge", snr=snr, sigma=2)])
                for snr in snrs]
        axes.loglog(snrs, used, color=COLOURS["ridge"], linestyle=":", linewidth=1.6, label="bound of the columns ridge uses")
    axes.set_xticks(snrs)
    axes.set_xticklabels(["%g" % snr for snr in snrs])
    axes.minorticks_off()
    axes.set_yticks([5, 10, 20, 50, 100, 200, 500])
    axes.set_yticklabels(["5", "10", "20", "50", "100", "200", "500"])
    axes.set_xlabel("SNR: peak over its noise")
    axes.set_ylabel("RMSE across the stripe [mpx]")
    axes.set_title("Straight stripes, sigma 2 px, RMS over slopes of 0 to 60 deg")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    save(page, os.path.join(folder, "accuracy_snr.png"))


def draw_bead(run, folder):
    """Error along one bead, the methods worth looking at."""
    wanted = [name for name in ("ridge", "steger", "squared_centroid", "svd") if run.rows("bead_trace", method=name)]
    page = figure(9.0, 1.6 + 1.5 * len(wanted))
    axes = page.subplots(len(wanted) + 1, 1, sharex=True)
    first = sorted(run.rows("bead_trace", method=wanted[0]), key=lambda row: row["u"])
    axes[0].plot([row["u"] for row in first], [row["row"] for row in first], color="black", linewidth=1)
    axes[0].invert_yaxis()
    axes[0].set_ylabel("row [px]")
    axes[0].set_title("Error across the stripe along a bead, flanks of 45 deg, SNR 50")
    for place, method in zip(axes[1:], wanted):
        rows = run.rows("bead_trace", method=method)
        place.plot([row["u"] for row in rows], [row["error_mpx"] for row in rows], color=COLOURS[method], linewidth=0.8)
        place.axhline(0.0, color="black", linewidth=0.5)
        place.set_ylim(-125, 125)
        place.set_ylabel("error [mpx]")
        place.text(0.01, 0.86, "%s: RMS %.0f mpx" % (method, rms([row["error_mpx"] for row in rows])),
                   transform=place.transAxes, fontsize=9, bbox={"color": "white", "alpha": 0.7, "pad": 1})
        place.grid(alpha=0.3)
    axes[-1].set_xlabel("column [px]")
    save(page, os.path.join(folder, "error_along_bead.png"))


def draw_sizes(run, folder):
    """Time from memory against the number of pixels."""
    page = figure(8.5, 5.2)
    axes = page.add_subplot()
    rows = run.rows("sizes")
    sizes = sorted({(row["width"], row["height"]) for row in rows}, key=lambda size: size[0] * size[1])
    pixels = [1e-6 * width * height for width, height in sizes]
    for method in dict.fromkeys(row["method"] for row in rows):
        values = [run.value("sizes", "cold_us", method=method, width=w, height=h) for w, h in sizes]
        axes.loglog(pixels, [1e-3 * value for value in values], marker="o", markersize=4, **style(method))
    sums = [median([row["sum_us"] for row in run.rows("sizes", width=w, height=h)]) for w, h in sizes]
    axes.loglog(pixels, [1e-3 * value for value in sums], color="black", linestyle=":", linewidth=1.6,
                label="one SIMD sum of the frame")
    axes.set_xticks(pixels)
    axes.set_xticklabels(["%dx%d" % (int(w), int(h)) for w, h in sizes], fontsize=8)
    axes.minorticks_off()
    axes.set_ylabel("time a frame, from memory [ms]")
    axes.set_title("One thread, median")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    save(page, os.path.join(folder, "time_size.png"))


def replace_file(path, content):
    partial = path + ".partial"
    with open(partial, "w", encoding="utf-8") as file:
        file.write(content)
    os.replace(partial, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", help="result of stripe_comparison --json")
    parser.add_argument("--check", action="store_true", help="only compare README.md with the kept json")
    options = parser.parse_args()
    folder = os.path.join(ROOT, "docs", "figures")
    kept, readme_path = os.path.join(folder, "stripe_comparison.json"), os.path.join(ROOT, "README.md")
    try:
        run = Comparison(options.json or kept)
        with open(readme_path, encoding="utf-8") as file:
            readme = file.read()
        wanted = with_table(readme, run)
    except (OSError, ValueError, KeyError) as error:
        print("plot_comparison.py: %s" % error, file=sys.stderr)
        return 1
    if options.check:
        if wanted != readme:
            print("plot_comparison.py: README.md's table is not that of docs/figures/stripe_comparison.json, run "
                  "scripts/plot_comparison.py", file=sys.stderr)
            return 1
        return 0
    if options.json and os.path.abspath(options.json) != kept:
        with open(options.json, encoding="utf-8") as file:
            replace_file(kept, file.read())
    draw_snr(run, folder)
    draw_bead(run, folder)
    draw_sizes(run, folder)
    replace_file(readme_path, wanted)
    return 0


if __name__ == "__main__":
    sys.exit(main())
