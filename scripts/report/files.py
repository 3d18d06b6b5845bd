"""Files in and out: errors of one line, JSON records whose types are checked, files that appear together or not at all."""
import contextlib
import errno
import json
import math
import os
import signal


class ReportError(Exception):
    """One line: file, cause, remedy."""


def read_text(path, remedy):
    try:
        with open(path, encoding="utf-8-sig") as file:
            return file.read()
    except OSError as error:
        raise ReportError("%s: cannot be read: %s, %s" % (path, error.strerror, remedy))
    except UnicodeDecodeError:
        raise ReportError("%s: is no UTF-8 text, %s" % (path, remedy))


def read_json(path, remedy):
    """The object in a JSON file."""
    try:
        content = json.loads(read_text(path, remedy))
    except (ValueError, RecursionError) as error:
        raise ReportError("%s: is no JSON: %s, %s" % (path, " ".join(str(error).split()), remedy))
    if not isinstance(content, dict):
        raise ReportError("%s: holds no JSON object, %s" % (path, remedy))
    return Record(path, "", content)


class Record:
    """A JSON object. What is missing or null is NaN, empty text, an empty record or list; a wrong type is an error."""

    def __init__(self, path, place, content):
        self.path, self.place, self.content = path, place, content

    def __bool__(self):
        return bool(self.content)

    def _refuse(self, key, expected):
        raise ReportError("%s: %s%s is %.40r, must be %s: write the file again"
                          % (self.path, self.place, key, self.content[key], expected))

    def number(self, key):
        value = self.content.get(key)
        if value is None:
            return math.nan
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            self._refuse(key, "a number or null")
        try:
            value = float(value)
        except OverflowError:
            return math.nan
        return value if math.isfinite(value) else math.nan

    def text(self, key):
        value = self.content.get(key)
        if value is None:
            return ""
        if not isinstance(value, str):
            self._refuse(key, "a text")
        return value

    def flag(self, key):
        value = self.content.get(key)
        if value is not None and not isinstance(value, bool):
            self._refuse(key, "true or false")
        return bool(value)

    def record(self, key):
        value = self.content.get(key)
        if value is not None and not isinstance(value, dict):
            self._refuse(key, "an object")
        return Record(self.path, self.place + key + ".", value or {})

    def quantity(self, key):
        """(value, sigma); a bare number has no sigma."""
        if isinstance(self.content.get(key), (int, float)):
            return self.number(key), math.nan
        both = self.record(key)
        return both.number("value"), both.number("sigma")

    def _list(self, key):
        value = self.content.get(key)
        if value is not None and not isinstance(value, list):
            self._refuse(key, "a list")
        return value or []

    def records(self, key):
        values = self._list(key)
        if not all(isinstance(value, dict) for value in values):
            self._refuse(key, "a list of objects")
        return [Record(self.path, "%s%s[%d]." % (self.place, key, i), value) for i, value in enumerate(values)]

    def texts(self, key):
        values = self._list(key)
        if not all(isinstance(value, str) for value in values):
            self._refuse(key, "a list of texts")
        return values

    def numbers(self, key, count):
        """So many numbers, NaN where there are none."""
        values = self._list(key)
        if values and len(values) != count:
            self._refuse(key, "a list of %d numbers" % count)
        place = Record(self.path, self.place + key, {"[%d]" % i: value for i, value in enumerate(values)})
        return [place.number("[%d]" % i) for i in range(count)]

    def keys(self):
        return list(self.content)


@contextlib.contextmanager
def uninterrupted():
    """SIGINT and SIGTERM within come as KeyboardInterrupt at the end. By handlers, not by a mask: a mask is this thread's
    alone, and numpy has others that would take the signal."""
    came = []
    handlers = {}
    for number in (signal.SIGINT, signal.SIGTERM):
        if signal.getsignal(number) != signal.SIG_IGN:
            handlers[number] = signal.signal(number, lambda *_: came.append(True))
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    if came:
        raise KeyboardInterrupt


def write_together(contents):
    """Writes {path: bytes}; files of an earlier run stay as they were if any cannot be written. An interrupt comes when all
    are there."""
    with uninterrupted():
        _write_together(contents)


def _write_together(contents):
    made = []
    try:
        for path, content in contents.items():
            temporary = "%s.%d.part" % (path, os.getpid())
            made.append(temporary)
            with open(temporary, "wb") as file:
                file.write(content)
        for path in contents:
            if os.path.isdir(path):  # seen before the first file is replaced
                raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        for path, temporary in zip(contents, list(made)):
            os.replace(temporary, path)
            made.remove(temporary)
    except OSError as error:
        raise ReportError("%s: cannot be written: %s, free the place or give another folder" % (path, error.strerror))
    finally:
        for temporary in made:
            if os.path.exists(temporary):
                os.remove(temporary)
