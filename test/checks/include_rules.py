#!/usr/bin/python3
"""Who may include whom: reads the includes of src/ and include/ (see docs/architecture.md).

On Debian ROS headers lie in /usr/include, so that the build alone does not stop a leak into the rooms that know no ROS.
"""
import os
import re
import sys

from source_tree import CPP, Tree, finish, room_of

# a room: the rooms it may include, beside itself
ROOMS = {
    "core": set(),
    "camera": {"core"},
    "stage": {"core"},
    "stripe": {"core"},
    "geometry": {"core"},
    "scan": {"core", "camera", "stage", "stripe", "geometry"},
    "weld": {"core", "stage", "geometry", "scan"},
    "calibration": {"core", "camera", "stage", "stripe", "geometry"},
    "simulation": {"core"},
    "ros": {"core", "camera", "stage", "stripe", "geometry", "scan", "weld", "calibration"},
}
EVERY_ROOM = set(ROOMS)
ROOMS["nodelets"] = EVERY_ROOM
ROOMS["tools"] = EVERY_ROOM
KNOW_ROS = {"ros", "nodelets", "tools"}

# single headers beside the rooms
ALSO_ALLOWED = {"simulation": {"weld_profiler/geometry/calibration.h"}}
METRES = {"weld_profiler/core/profile.h", "weld_profiler/core/scan.h"}
PIXELS = {"weld_profiler/core/image.h", "weld_profiler/core/frame.h", "weld_profiler/core/stripe.h"}
NEVER = {
    "stripe": (METRES, "stripe knows pixels and no metres"),
    "weld": (PIXELS, "weld knows metres and no pixels"),
}

# what a room without ROS may use of others; a list of the allowed finds a leak that a list of the forbidden misses
LIBRARIES = re.compile(r"^(Eigen|opencv2|pcl|yaml-cpp|arpa|linux|net|netinet|sys)/")
SIMULATION_LIBRARIES = re.compile(r"^(Eigen|yaml-cpp)/")
STANDARD = re.compile(r"^[a-z_0-9]+$")
POSIX = {"dirent.h", "errno.h", "fcntl.h", "glob.h", "math.h", "poll.h", "pthread.h", "signal.h", "stdint.h", "stdio.h",
         "stdlib.h", "string.h", "strings.h", "time.h", "unistd.h"}

# vector instructions, where the compiler finds none by itself
PROCESSOR = {"stripe": {"emmintrin.h", "immintrin.h"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def own_header(tree, path, name):
    """The included file as weld_profiler/ROOM/x.h or src/ROOM/x.h; None for a header of somebody else."""
    if name.startswith("weld_profiler/"):
        return name
    beside = os.path.normpath(os.path.join(os.path.dirname(path), name))
    for candidate in (beside, os.path.join("src", name)):
        if os.path.isfile(os.path.join(tree.root, candidate)):
            return candidate
    return None


def header_room(header):
    parts = header.split("/")
    if parts[0] == "weld_profiler":
        return parts[1] if len(parts) > 2 else None  # weld_profiler/StripeProfile.h: generated, a ROS header
    return room_of(header)


def judge_own(room, header):
    """Why a room must not include a header of this package; None if it may."""
    other = header_room(header)
    if other is None:
        return None if room in KNOW_ROS else "is a generated ROS header, %s knows no ROS" % room
    if room in NEVER and header in NEVER[room][0]:
        return NEVER[room][1]
    if other == room or other in ROOMS[room] or header in ALSO_ALLOWED.get(room, set()):
        return None
    return "%s must not include %s" % (room, other)


def judge_foreign(room, header):
    """Why a room must not include somebody else's header; None if it may."""
    if header in PROCESSOR.get(room, set()):
        return None
    if room in KNOW_ROS or STANDARD.match(header) or header in POSIX:
        return None
    libraries = SIMULATION_LIBRARIES if room == "simulation" else LIBRARIES
    if libraries.match(header):
        return None
    return "is no header that %s may use (ROS stays in ros, nodelets, tools)" % room


def findings_of(tree, path):
    room = room_of(path)
    if room not in ROOMS:
        return ["%s: lies in no known room, must be one of: %s" % (path, ", ".join(sorted(ROOMS)))]
    found = []
    for number, line in tree.lines(path):
        match = INCLUDE.match(line)
        if not match:
            continue
        own = own_header(tree, path, match.group(2))
        reason = judge_own(room, own) if own else judge_foreign(room, match.group(2))
        if reason is None and path.startswith("include/") and own and own.startswith("src/"):
            reason = "is private, a public header must not include it"
        if reason:
            found.append("%s:%d: %s: %s" % (path, number, match.group(2), reason))
    return found


def main(root):
    tree = Tree(root)
    paths = tree.files(["src", "include"], CPP)
    findings = [finding for path in paths for finding in findings_of(tree, path)]
    return finish("include rules", findings, len(paths), 20)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
