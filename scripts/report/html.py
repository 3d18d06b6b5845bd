"""The page: one file, nothing fetched from anywhere, made for a screen and for A4."""
from html import escape

from report.style import data_uri

CSS = """
:root { --ink: #1a1a1a; --grey: #666; --rule: #c9c9c9; }
* { box-sizing: border-box; }
body { font: 10pt/1.4 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; color: var(--ink);
  max-width: 186mm; margin: 8mm auto; padding: 0 4mm; background: white; overflow-wrap: break-word; }
h1 { font-size: 17pt; margin: 0; line-height: 1.2; min-width: 0; overflow-wrap: anywhere; }
h2 { font-size: 12pt; margin: 8mm 0 2mm; padding-bottom: 0.8mm; border-bottom: 0.5pt solid var(--ink); break-after: avoid; }
p { margin: 1.5mm 0; } p.small { break-after: avoid; }
header { display: flex; justify-content: space-between; align-items: flex-end; border-bottom: 1.5pt solid var(--ink);
  padding-bottom: 2mm; }
header .what { color: var(--grey); text-align: right; font-size: 9pt; }
.verdict { display: flex; border: 1.5pt solid var(--ink); margin: 4mm 0; break-inside: avoid; }
.verdict .mark { display: flex; align-items: center; font-size: 24pt; font-weight: bold; padding: 3mm 6mm; white-space: nowrap;
  border-right: 1.5pt solid var(--ink); }
.verdict .why { padding: 2mm 5mm; min-width: 0; overflow-wrap: anywhere; }
.verdict.fail .mark { background: #1a1a1a; color: white; }
.verdict.undecided .mark, .verdict.none .mark { background: #e4e4e4; }
.unverified { font-weight: bold; border-bottom: 0.8pt dashed var(--ink); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; margin: 2mm 0; font-size: 9pt; font-variant-numeric: tabular-nums; }
th, td { padding: 0.7mm 2mm; text-align: left; border-bottom: 0.4pt solid var(--rule); vertical-align: top; }
th { border-bottom: 0.8pt solid var(--ink); font-weight: bold; }
td.n, th.n { text-align: right; white-space: nowrap; }
tr { break-inside: avoid; } thead { display: table-header-group; }
table.whole { break-inside: avoid; }
table.facts td.n { white-space: normal; overflow-wrap: anywhere; }
table.verdicts { font-size: 8.5pt; } table.verdicts th, table.verdicts td { padding: 0.7mm 1.2mm; }
table.verdicts td:first-child { min-width: 26mm; } table.verdicts td:last-child { min-width: 28mm; } td.at { white-space: nowrap; }
tr.group td { border-top: 0.8pt solid var(--grey); }
td.fail { font-weight: bold; background: #dcdcdc; } td.undecided { background: #eeeeee; font-style: italic; }
.two { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); grid-gap: 0 6mm; align-items: start; }
figure { margin: 3mm 0; break-inside: avoid; }
figure img { max-width: 100%; max-height: 135mm; height: auto; display: block; margin: 0 auto; }
figure.half img { max-width: min(95mm, 100%); margin: 0; }
figcaption, .small, .note { font-size: 8.5pt; color: var(--grey); margin-top: 1mm; }
footer { margin-top: 8mm; border-top: 0.5pt solid var(--ink); padding-top: 1.5mm; font-size: 8.5pt; color: var(--grey); }
@page { size: A4; margin: 13mm 12mm 15mm; @bottom-right { content: counter(page) " / " counter(pages); font-size: 8pt; } }
@media screen and (max-width: 700px) { .two { grid-template-columns: minmax(0, 1fr); } header, .verdict { display: block; }
  header .what { text-align: left; } .verdict .mark { border-right: 0; border-bottom: 1.5pt solid var(--ink); white-space: normal; } }
@media print { .scroll { overflow: visible; } body { margin: 0; padding: 0; max-width: none; font-size: 9.5pt; } .page { break-before: page; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
"""


class Raw(str):
    """Markup that needs no escaping."""


def text(value):
    return value if isinstance(value, Raw) else Raw(escape(str(value)))


def tag(name, *content, **attributes):
    """An element; `kind` stands for class."""
    listed = "".join(' %s="%s"' % ("class" if key == "kind" else key.replace("_", "-"), escape(str(value)))
                     for key, value in attributes.items() if value != "")
    if name == "br":
        return Raw("<br>")
    return Raw("<%s%s>%s</%s>" % (name, listed, "".join(text(part) for part in content), name))


def join(*parts):
    return Raw("\n".join(text(part) for part in parts if part))


def table(names, rows, numeric=(), kind=""):
    """Rows of cells, a cell being a text or (text, class); a row may be preceded by its class: (class, cells). In a window
    too narrow for it the table scrolls, not the page."""
    titles = [tag("th", name, kind="n" if i in numeric else "") for i, name in enumerate(names)]
    head = tag("thead", tag("tr", *titles)) if names else ""
    body = []
    for row in rows:
        row_kind, cells = row if isinstance(row, tuple) else ("", row)
        made = []
        for i, cell in enumerate(cells):
            content, cell_kind = cell if isinstance(cell, tuple) else (cell, "")
            kinds = " ".join(filter(None, ["n" if i in numeric else "", cell_kind]))
            made.append(tag("td", content, kind=kinds))
        body.append(tag("tr", *made, kind=row_kind))
    return tag("div", tag("table", head, tag("tbody", *body), kind=kind), kind="scroll")


def facts(rows):
    """Name and value."""
    return table((), [[name, value] for name, value in rows], numeric=(1,), kind="facts")


def figure(image, caption, alt, kind=""):
    return tag("figure", Raw('<img src="%s" alt="%s">' % (data_uri(image), escape(alt))), tag("figcaption", caption), kind=kind)


def page(title, body):
    """The bytes of the file."""
    return ("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>%s</title>\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>%s</style></head>\n<body>\n%s\n"
            "</body></html>\n" % (escape(title), CSS, body)).encode("utf-8", "replace")
