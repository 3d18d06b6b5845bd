"""What the programs that write a report share."""
import os
import sys

from report import style
from report.files import ReportError, write_together


def write_report(directory, make):
    """Writes the page and the picture that `make` returns as report.html and report.png; returns the exit status."""
    try:
        style.prepare()
        page, picture = make()
        write_together({os.path.join(directory, "report.html"): page, os.path.join(directory, "report.png"): picture})
    except ReportError as error:
        print(error, file=sys.stderr)
        return 1
    return 0
