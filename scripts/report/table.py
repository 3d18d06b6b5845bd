"""CSV tables by column name; an empty field is NaN."""
import csv
import io
import math

import numpy as np

from report.files import ReportError, read_text

WRITE_AGAIN = "write it again"


class Table:
    """Columns of one length; those that the file does not have are empty."""

    def __init__(self, path, names, rows):
        self.path, self.names, self.rows = path, names, rows
        self._numbers = {}

    def __len__(self):
        return len(self.rows)

    def has(self, name):
        return name in self.names

    def texts(self, name):
        if name not in self.names:
            return [""] * len(self.rows)
        place = self.names.index(name)
        return [row[place].strip() for _, row in self.rows]

    def numbers(self, name):
        """As an array, NaN where there is none. Do not write into it."""
        if name not in self._numbers:
            self._numbers[name] = self._read_numbers(name)
        return self._numbers[name]

    def _read_numbers(self, name):
        values = np.full(len(self.rows), math.nan)
        for i, text in enumerate(self.texts(name)):
            if not text:
                continue
            try:
                value = float(text)
            except ValueError:
                raise ReportError("%s: line %d: %s is '%.40s', must be a number or empty: %s"
                                  % (self.path, self.rows[i][0], name, text, WRITE_AGAIN))
            values[i] = value if math.isfinite(value) else math.nan
        return values

    def quantity(self, name):
        """Values and their sigmas."""
        return self.numbers(name), self.numbers("sigma_" + name)


def read_table(path, required=(), remedy=WRITE_AGAIN):
    text = read_text(path, remedy)
    try:
        lines = [(number, row) for number, row in enumerate(csv.reader(io.StringIO(text)), 1) if any(row)]
    except csv.Error as error:
        raise ReportError("%s: is no CSV: %s, %s" % (path, error, remedy))
    if not lines:
        raise ReportError("%s: is empty, its first line must name the columns: %s" % (path, remedy))
    names = [name.strip() for name in lines[0][1]]
    missing = [name for name in required if name not in names]
    if missing:
        raise ReportError("%s: line %d: has no column %s, %s" % (path, lines[0][0], ", ".join(missing), remedy))
    for number, row in lines[1:]:
        if len(row) != len(names):
            raise ReportError("%s: line %d: has %d fields, the first line has %d: %s"
                              % (path, number, len(row), len(names), remedy))
    return Table(path, names, lines[1:])


def empty_table(path):
    return Table(path, [], [])
