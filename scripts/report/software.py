"""Which version wrote a file."""
import os
import re

PACKAGE = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "package.xml")


def software(record):
    """As the file states it (`software`), and that of the report's program where its package is beside it."""
    try:
        with open(PACKAGE, encoding="utf-8") as file:
            found = re.search(r"<version>\s*([^<\s]+)\s*</version>", file.read())
    except OSError:
        found = None
    report = "report: weld_profiler %s" % found.group(1) if found else "report: weld_profiler, version not known"
    stated = record.text("software")
    return "measured: %s; %s" % (stated, report) if stated else report
