#!/usr/bin/python3
"""config/*.yaml and cfg/*.cfg say what the parameter structs say: same names, same defaults."""
import re
import sys

import yaml

from source_tree import Tree, finish

STRIPE = "include/weld_profiler/stripe/stripe_params.h"
SCAN = "include/weld_profiler/scan/scan_params.h"
ENCODER = "include/weld_profiler/stage/encoder_track.h"
FILES = (("config/stripe_centre.yaml", (STRIPE,)), ("config/triangulation.yaml", (SCAN, ENCODER)))
KNOBS = (("cfg/StripeCentre.cfg", (STRIPE,)), ("cfg/Triangulation.cfg", (SCAN,)))

DECLARATION = re.compile(r"^\s*(?:double|int|bool|std::string)\s+([^;()]*=[^;()]*);", re.M)
VISITED = re.compile(r'\bv\("(\w+)",')
KNOB = re.compile(r'^gen\.add\("(\w+)",\s*\w+,\s*\d+,\s*"[^"]*",\s*([^,)]+)', re.M)


def value(text):
    """A default as C++, Python or YAML writes it."""
    text = text.strip()
    if text in ("true", "True"):
        return True
    if text in ("false", "False"):
        return False
    if text.startswith('"'):
        return text.strip('"')
    return float(text)


def fields(tree, headers):
    """{name: default} of the fields that the headers' structs offer to visitors."""
    found = {}
    for header in headers:
        text = tree.read(header)
        defaults = {}
        for declaration in DECLARATION.findall(text):
            for part in declaration.split(","):
                name, default = part.split("=", 1)
                defaults[name.strip()] = value(default)
        found.update({name: defaults[name] for name in VISITED.findall(text) if name in defaults})
    return found


def compare(path, given, known, complete):
    found = ["%s: '%s' is no field of the parameter struct" % (path, name) for name in given if name not in known]
    if complete:
        found += ["%s: has no '%s'" % (path, name) for name in known if name not in given]
    for name in given:
        if name in known and given[name] != known[name]:
            found.append("%s: %s is %r, the struct's default is %r" % (path, name, given[name], known[name]))
    return found


def main(root):
    tree = Tree(root)
    findings = []
    looked_at = 0
    for path, headers in FILES:
        given = {name: float(item) if isinstance(item, (int, float)) and not isinstance(item, bool) else item
                 for name, item in yaml.safe_load(tree.read(path)).items()}
        findings += compare(path, given, fields(tree, headers), complete=True)
        looked_at += len(given)
    for path, headers in KNOBS:
        given = {name: value(default) for name, default in KNOB.findall(tree.read(path))}
        findings += compare(path, given, fields(tree, headers), complete=False)
        looked_at += len(given)
    return finish("parameter files", findings, looked_at, 40)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
