"""What the checks share: the package's files, and how findings are reported."""
import os
import sys

CPP = (".h", ".cpp")


class Tree:
    """A checkout of the package."""

    def __init__(self, root):
        self.root = os.path.abspath(root)

    def files(self, folders, endings):
        """Paths relative to the root, sorted."""
        found = []
        for folder in folders:
            for place, _, names in os.walk(os.path.join(self.root, folder)):
                found += [os.path.relpath(os.path.join(place, name), self.root) for name in names
                          if name.endswith(tuple(endings))]
        return sorted(found)

    def read(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as file:
            return file.read()

    def lines(self, path):
        """(number from 1, text) of each line."""
        return list(enumerate(self.read(path).splitlines(), 1))


def room_of(path):
    """The room a file lies in: src/ROOM/... or include/weld_profiler/ROOM/...; None elsewhere."""
    parts = path.split("/")
    if parts[0] == "src" and len(parts) > 2:
        return parts[1]
    if parts[:2] == ["include", "weld_profiler"] and len(parts) > 3:
        return parts[2]
    return None


def finish(what, findings, looked_at, least):
    """Prints findings; the exit status. A check that looked at too little has found nothing by accident."""
    if looked_at < least:
        findings = findings + ["%s: looked at %d, expected at least %d" % (what, looked_at, least)]
    for finding in findings:
        print(finding, file=sys.stderr)
    print("%s: %d looked at, %d findings" % (what, looked_at, len(findings)))
    return 1 if findings else 0
