#!/usr/bin/python3
"""package.xml, CHANGELOG.rst, nodelet_plugins.xml and scripts/packages.txt fit each other and the sources."""
import re
import sys
import xml.etree.ElementTree as xml

from source_tree import Tree, finish

VERSION = re.compile(r"^\d+\.\d+\.\d+$")
RELEASE = re.compile(r"^(\d+\.\d+\.\d+) \(\d{4}-\d{2}-\d{2}\)$", re.M)


def version_findings(tree):
    version = xml.fromstring(tree.read("package.xml")).findtext("version", "").strip()
    if not VERSION.match(version):
        return ["package.xml: version '%s', must be MAJOR.MINOR.PATCH" % version]
    released = RELEASE.findall(tree.read("CHANGELOG.rst"))
    if released and released[0] != version:
        return ["package.xml: version %s, CHANGELOG.rst's newest release is %s" % (version, released[0])]
    return []


def plugin_findings(tree):
    """Each nodelet of the plugin file is exported by a source, and the other way round."""
    library = xml.fromstring(tree.read("nodelet_plugins.xml"))
    listed = {node.get("type") for node in library.iter("class")}
    exported = set()
    for path in tree.files(["src/nodelets"], [".cpp"]):
        exported |= set(re.findall(r"PLUGINLIB_EXPORT_CLASS\(\s*([\w:]+)", tree.read(path)))
    found = ["nodelet_plugins.xml: no source exports %s" % name for name in sorted(listed - exported)]
    found += ["src/nodelets: %s is not in nodelet_plugins.xml" % name for name in sorted(exported - listed)]
    return found


def package_list_findings(tree):
    seen = set()
    found = []
    for number, line in tree.lines("scripts/packages.txt"):
        for name in line.split("#")[0].split():
            if not re.match(r"^[a-z0-9][a-z0-9+.-]+$", name):
                found.append("scripts/packages.txt:%d: '%s' is no package name" % (number, name))
            if name in seen:
                found.append("scripts/packages.txt:%d: %s stands there twice" % (number, name))
            seen.add(name)
    return found


def main(root):
    tree = Tree(root)
    findings = version_findings(tree) + plugin_findings(tree) + package_list_findings(tree)
    return finish("package files", findings, 3, 3)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
