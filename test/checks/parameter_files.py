#!/usr/bin/python3
"""config/*.yaml and cfg/*.cfg say what the parameter structs say: same names, same defaults."""
import re
import sys

import yaml

from source_tree import Tree, finish

STRIPE = "include/weld_profiler/stripe/stripe_params.h"
SCAN = "include/weld_profiler/scan/scan_params.h"
ENCODER = "include/weld_profiler/stage/encoder_track.h"
WELD = tuple("include/weld_profiler/" + header for header in (
    "weld/weld_params.h", "weld/verdict_params.h", "weld/grinding_params.h", "weld/weld_surface.h", "ros/weld_server.h"))
FILES = (("config/stripe_centre.yaml", (STRIPE,)), ("config/triangulation.yaml", (SCAN, ENCODER)),
         ("config/weld_measurement.yaml", WELD))
KNOBS = (("cfg/StripeCentre.cfg", (STRIPE,)), ("cfg/Triangulation.cfg", (SCAN,)))

DECLARATION = re.compile(r"^\s*(?:double|int|bool|std::string)\s+([^;()]*=[^;()]*);", re.M)
OPTIONAL = re.compile(r"^\s*std::optional<double>\s+(\w+);", re.M)  # 0 in a file stands for none
EMPTY = re.compile(r"^\s*std::string\s+(\w+);", re.M)
VISITED = re.compile(r'\bv(?:isitThickness\(v, |\()"(\w+)",')
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
        defaults.update({name: 0.0 for name in OPTIONAL.findall(text)})
        defaults.update({name: "" for name in EMPTY.findall(text)})
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
