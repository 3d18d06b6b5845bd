"""How every figure looks: readable on paper, on a grey printer too, and the same bytes from the same input."""
import base64
import io
import warnings

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

PAGE_WIDTH = 7.0  # of a figure that fills an A4 page between its margins [in]
INK, GREY, LIGHT, DIMENSION = "#1a1a1a", "#6e6e6e", "#c9c9c9", "#0b3c7d"
OPEN = "#e4e4e4"  # behind a verdict that is none
LEFT, RIGHT, ALARM = "#0b3c7d", "#c25a00", "#a3001b"
LEVELS = ("B", "C", "D")
LEVEL_LINES = {"B": (0, (6, 2)), "C": (0, (3, 2)), "D": (0, (1, 1.5))}


def prepare():
    """Settings of the user's own matplotlib would change what a customer gets."""
    matplotlib.rcdefaults()
    matplotlib.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 8, "axes.titlesize": 8.5, "axes.labelsize": 8, "xtick.labelsize": 7,
        "ytick.labelsize": 7, "legend.fontsize": 7, "axes.linewidth": 0.6, "lines.linewidth": 1.0, "axes.edgecolor": INK,
        "xtick.major.width": 0.6, "ytick.major.width": 0.6, "svg.hashsalt": "weld_profiler", "svg.fonttype": "path",
        "grid.color": "#dddddd", "grid.linewidth": 0.5, "legend.frameon": False})
    warnings.filterwarnings("ignore", message="Glyph .* missing")


def page(height, width=PAGE_WIDTH, dpi=150):
    figure = Figure(figsize=(width, height), dpi=dpi)
    FigureCanvasAgg(figure)
    return figure


def plain(text):
    """A text that may come from a user, for matplotlib: a dollar begins no formula."""
    return text.replace("$", r"\$")


def png(figure, dpi=170):
    stream = io.BytesIO()
    FigureCanvasAgg(figure)
    figure.savefig(stream, format="png", dpi=dpi, facecolor="white", metadata={"Software": "weld_profiler"})
    return stream.getvalue()


def svg(figure):
    stream = io.BytesIO()
    FigureCanvasSVG(figure)
    figure.savefig(stream, format="svg", facecolor="white", metadata={"Date": None})
    return stream.getvalue()


def data_uri(content):
    kind = "png" if content[:4] == b"\x89PNG" else "svg+xml"
    return "data:image/%s;base64,%s" % (kind, base64.b64encode(content).decode("ascii"))
