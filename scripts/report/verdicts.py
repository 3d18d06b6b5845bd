"""How a verdict is worded: the same everywhere it is shown, and never without what it rests on."""
import math

from report.numbers import IMPERFECTIONS, readable
from report.style import LEVELS

UNVERIFIED = "rests on limits that were not verified"


def _why_undecided(folder):
    """Something that was not measured, a limit too near, or a weld too little of which was seen: each leaves it open."""
    missing = folder.record.record("verdict").texts("waits_for")
    if missing:
        return "It waits for what was not measured: %s." % ", ".join(name.replace("_", " ") for name in missing)
    table = folder.verdict
    near = seen = False
    for decision, margin, sigma, own in zip(table.texts("decision"), table.numbers("margin_mm"), table.numbers("sigma_margin_mm"),
                                            table.numbers("sigma_mm")):
        if decision != "undecided" or not math.isfinite(margin):
            continue
        sigma = sigma if math.isfinite(sigma) else own
        near, seen = near or abs(margin) <= 2 * sigma, seen or margin > 2 * sigma
    if seen and not near:
        return "Too little of the weld was measured to say that it passes."
    near_limit = "A limit lies within two standard deviations of what was measured"
    return near_limit + (", and too little of the weld was measured." if seen else ".")


def _failed(folder, level):
    """What decided against a level, `undercut, surface pore`; empty if that is not told."""
    table, names = folder.verdict, []
    for imperfection, of, decision in zip(table.texts("imperfection"), table.texts("level"), table.texts("decision")):
        name = IMPERFECTIONS.get(imperfection, readable(imperfection))
        if (of, decision) == (level, "fail") and imperfection != "weld" and name not in names:
            names.append(name)
    return ", ".join(names)


def judged_in_part(folder):
    """Limits that need the plate's thickness were not judged for want of it, so that no level is met as a whole."""
    verdict = folder.record.record("verdict")
    if "lacks_thickness" not in verdict.keys():  # of an earlier version, which judged after the built-in table
        return not math.isfinite(verdict.number("thickness"))
    return bool(verdict.texts("lacks_thickness"))


def _judged(folder):
    """What was judged at all: `excess weld metal`."""
    table, names = folder.verdict, []
    for imperfection, decision in zip(table.texts("imperfection"), table.texts("decision")):
        name = IMPERFECTIONS.get(imperfection, readable(imperfection))
        if decision in ("pass", "fail", "undecided") and imperfection != "weld" and name not in names:
            names.append(name)
    return ", ".join(names)


def _missing(folder):
    """What the measuring says it lacked; which limits were not verified is said elsewhere."""
    record = folder.record
    parts = record.text("reason").split("; ") + record.record("verdict").texts("notes")
    for name in IMPERFECTIONS:
        parts = [part.replace(name, IMPERFECTIONS[name]) if "_" in name else part for part in parts]
    return [(part if "_" in part.split(" ")[0] else part[0].upper() + part[1:]) + "."
            for part in parts if part and not part.startswith("limits not checked")]


class Verdict:
    """`mark`: large; `why`: sentences; `missing`: sentences on what was not measured; `kind`: level, fail, undecided or none."""

    def __init__(self, folder):
        record = folder.record.record("verdict")
        overall, asked = record.text("overall"), record.text("asked")
        self.unverified = record.flag("unverified") and bool(overall)
        self.levels = {level: record.record("levels").text(level) for level in LEVELS}
        self.kind = {"fail": "fail", "undecided": "undecided"}.get(overall, "level" if overall in LEVELS else "none")
        self.missing = []
        if not folder.has_weld():
            self.kind, self.mark = "none", "NO WELD"
            self.why = [folder.record.text("reason") or "no weld was recognised in this scan"]
            self.unverified = False
            return
        decision = record.text("asked_decision")
        fails = asked in LEVELS and decision == "fail"
        worst = "" if fails and asked == "D" else _failed(folder, "D")
        best = {"fail": "Not even level D is met%s." % (": " + worst if worst else ""),
                "undecided": self._open(folder, asked in LEVELS and decision in ("pass", "fail")),
                "": "Nothing was measured that decides, or nothing is judged."}
        self.mark = {"fail": "FAILS", "undecided": "UNDECIDED", "": "NOT JUDGED"}.get(overall, "LEVEL " + overall)
        part = judged_in_part(folder)
        met = "Level %s is the best level met" % overall
        self.why = [best.get(overall, "%s by what was judged, which is only: %s." % (met, _judged(folder) or "not told")
                             if part else met + ".")]
        if asked and decision in ("pass", "fail", "undecided"):
            self.mark = "LEVEL %s %s" % (asked, {"pass": "MET", "fail": "NOT MET", "undecided": "UNDECIDED"}[decision])
            self.kind = {"pass": "level"}.get(decision, decision)
        if part and (self.kind == "level" or self.levels.get(asked) == "pass"):
            self.kind, self.mark = "none", "NOT FULLY JUDGED"
        if asked:
            because = _failed(folder, asked) if fails else ""
            self.why.insert(0, "Asked for: level %s%s." % (asked, ", which fails by " + because if because else ""))
        known = ["%s %s" % (level, readable(decision)) for level, decision in self.levels.items() if decision]
        if known:
            self.why.append("Levels: " + ", ".join(known) + ".")
        if record.text("limits"):
            self.why.append("Limits: %s." % record.text("limits"))
        self.missing = _missing(folder)

    def _open(self, folder, asked_is_decided):
        """Why the best level is not known, and beside a decision on the level asked for, which levels that leaves open."""
        why = _why_undecided(folder)
        left = [level for level in LEVELS if self.levels[level] == "undecided"]
        if not asked_is_decided or not left:
            return why
        return "Level %s is undecided: %s" % (" and ".join(left), why[0].lower() + why[1:])

    def beside(self, folder):
        """What the measured numbers are not about: a sentence, or empty."""
        others = len(folder.record.records("other_beads"))
        return "" if not others else "%s seen, not measured." % (
            "Another bead beside it was" if others == 1 else "%d other beads or pieces beside it were" % others)
