#!/usr/bin/python3
"""Launch files: every argument has a doc, and every way to call them loads (files found, expressions valid).

The second half needs the built environment; it starts nothing.
"""
import os
import sys
import tempfile
import xml.etree.ElementTree as xml

from source_tree import Tree, finish

CALLS = (
    ("scan.launch", ["source:=simulated"], {"/profiler/simulated_rig", "/profiler/stripe_centre",
                                            "/profiler/triangulation", "/profiler/manager"}),
    ("scan.launch", ["source:=folder", "images:=/tmp/none", "camera_info_url:=file:///tmp/none.yaml"],
     {"/profiler/camera", "/profiler/stripe_centre", "/profiler/triangulation", "/profiler/manager"}),
    ("scan.launch", ["rviz:=true", "record:=true", "output:=/tmp", "respawn:=true", "namespace:=left"],
     {"/left/simulated_rig", "/left/record", "/left/manager", "/rviz_left"}),
    ("scan.launch", ["motion:=tf", "fixed_frame:=base_link", "record:=true", "method:=svd"],
     {"/profiler/simulated_rig", "/profiler/record"}),
    ("replay.launch", ["bag:=/tmp/none.bag"], {"/play", "/profiler/stripe_centre", "/profiler/triangulation"}),
    ("replay.launch", ["bag:=/tmp/none.bag", "loop:=true", "motion:=tf", "fixed_frame:=world", "rviz:=true"],
     {"/play", "/rviz_profiler"}),
)


def undocumented(tree, path):
    found = []
    try:
        root = xml.fromstring(tree.read(path))
    except xml.ParseError as error:
        return ["%s: is no XML: %s" % (path, error)]
    for argument in root.findall("arg"):
        if not (argument.get("doc") or "").strip():
            found.append("%s: argument '%s' has no doc" % (path, argument.get("name")))
    return found


def unknown_classes(tree, config):
    """Nodelets that a launch file loads and nodelet_plugins.xml does not offer."""
    offered = {node.get("name") for node in xml.fromstring(tree.read("nodelet_plugins.xml")).iter("class")}
    found = []
    for node in config.nodes:
        words = node.args.split()
        if node.package == "nodelet" and words and words[0] == "load" and words[1] not in offered:
            found.append("launch: node %s loads %s, nodelet_plugins.xml has: %s" %
                         (node.name, words[1], ", ".join(sorted(offered))))
    return found


def load(tree, name, arguments, expected):
    import roslaunch.config
    import roslaunch.xmlloader
    config = roslaunch.config.ROSLaunchConfig()
    try:
        roslaunch.xmlloader.XmlLoader(resolve_anon=False).load(
            os.path.join(tree.root, "launch", name), config, argv=arguments, verbose=False)
    except Exception as error:  # roslaunch raises many kinds; each of them is a finding
        return ["launch/%s %s: %s" % (name, " ".join(arguments), error)]
    names = {os.path.join(node.namespace, node.name) for node in config.nodes}
    found = ["launch/%s %s: starts no %s, but %s" % (name, " ".join(arguments), missing, ", ".join(sorted(names)))
             for missing in sorted(expected - names)]
    return found + unknown_classes(tree, config)


def main(root):
    tree = Tree(root)
    paths = tree.files(["launch"], [".launch", ".launch.xml"])
    findings = [finding for path in paths for finding in undocumented(tree, path)]
    if not findings:
        with tempfile.TemporaryDirectory() as home:
            os.environ["ROS_LOG_DIR"] = home
            for name, arguments, expected in CALLS:
                findings += load(tree, name, arguments, expected)
    return finish("launch files", findings, len(paths), 7)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
