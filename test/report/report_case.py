"""What the tests of the reports share: running a program, and reading what it wrote."""
import base64
import contextlib
import importlib
import io
import os
import sys
import tempfile
import unittest
import warnings
import xml.etree.ElementTree as xml
from html.parser import HTMLParser
from unittest import mock

from matplotlib.image import imread

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPTS = os.path.join(os.path.dirname(os.path.dirname(HERE)), "scripts")
sys.path.insert(0, SCRIPTS)
EMPTY_TAGS = {"meta", "img", "br"}


class Page(HTMLParser):
    """Text, rows of cells and images of a page; that every element is closed."""

    def __init__(self, path):
        super().__init__()
        self.images, self.links, self.rows, self.words, self.open, self.tags = [], [], [], [], [], set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())
        self.close()
        self.text = " ".join(" ".join(self.words).split())

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.add(tag)
        self.links += [value for key, value in attributes.items() if key in ("src", "href")]
        if tag == "img":
            self.images.append(attributes)
        if tag not in EMPTY_TAGS:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, "</%s> closes nothing" % tag

    def handle_data(self, data):
        if "style" in self.open:
            return
        self.words.append(data)
        if "td" in self.open or "th" in self.open:
            self.rows[-1][-1] += data

    def row(self, first, second=None):
        """Cells of the first row that begins so."""
        for row in self.rows:
            if row and row[0] == first and (second is None or row[1] == second):
                return row
        raise AssertionError("no row '%s' in %s" % (first, [row[:1] for row in self.rows]))

    def picture(self, alt):
        found = [image for image in self.images if image["alt"].startswith(alt)]
        assert len(found) == 1, "%d images '%s'" % (len(found), alt)
        return decoded(found[0]["src"])


def decoded(uri):
    """(kind, array of a PNG or root of an SVG)."""
    head, content = uri.split(",", 1)
    content = base64.b64decode(content, validate=True)
    if head == "data:image/png;base64":
        return "png", imread(io.BytesIO(content), format="png")
    assert head == "data:image/svg+xml;base64", head
    return "svg", xml.fromstring(content)


class ReportCase(unittest.TestCase):
    program = ""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = os.path.join(self.temporary.name, "scan")

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def run_program(self, *arguments):
        """Exit status and what stood on standard error; within this process, for the time that matplotlib takes to load."""
        module = importlib.import_module(self.program)
        errors = io.StringIO()
        with mock.patch.object(sys, "argv", [self.program] + list(arguments)), contextlib.redirect_stderr(errors), \
                contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("always")
            try:
                code = module.main()
            except SystemExit as leaving:
                code = leaving.code
        return code, errors.getvalue()

    def page(self, *arguments):
        """Runs it on the folder; what a good run must leave."""
        code, errors = self.run_program(self.folder, *arguments)
        self.assertEqual((code, errors), (0, ""))
        page = Page(self.path("report.html"))
        self.assertEqual(page.open, [], "elements left open")
        for link in page.links:
            self.assertTrue(link.startswith("data:"), "fetches " + link[:60])
        for image in page.images:
            self.assert_drawn(image)
        picture = imread(self.path("report.png"))
        self.assertGreater(picture.shape[0], 1000)
        self.assertGreater(picture[..., :3].std(), 0.03, "report.png is blank")
        self.assertEqual([name for name in os.listdir(self.folder) if "part" in name], [])
        return page

    def assert_drawn(self, image):
        kind, content = decoded(image["src"])
        if kind == "png":
            self.assertGreater(content[..., :3].std(), 0.03, image["alt"] + " is blank")
        else:
            self.assertGreater(len(content.findall(".//{http://www.w3.org/2000/svg}path")), 20, image["alt"] + " is blank")

    def assert_refused(self, *parts, arguments=()):
        """Status 1, one line that has these parts, nothing written."""
        code, errors = self.run_program(self.folder, *arguments)
        self.assertEqual(code, 1, errors)
        self.assertEqual(len(errors.strip().splitlines()), 1, errors)
        for part in parts:
            self.assertIn(part, errors)
        left = [name for name in os.listdir(self.folder) if name.startswith("report")] if os.path.isdir(self.folder) else []
        self.assertEqual(left, [])
