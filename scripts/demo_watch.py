#!/usr/bin/python3
"""Watches one scan of a running head from its first profile to its last, then saves it.

Leaves in the output directory scan.pcd, frame.png (a frame with its centres drawn on it) and figures.json (what the
diagnostics of triangulation say: balance of frames, ages). Exit status: 0 good, 1 the scan did not come to an end.
"""
import argparse
import json
import os
import sys
import threading
import time

import numpy as np
import rospy
from matplotlib.image import imsave
from sensor_msgs.msg import Image, PointCloud2
from weld_profiler.srv import SaveScan

from plain_messages import Trigger, subscribe


class WatchError(Exception):
    """One line: what did not happen, and where to look."""


class Watch:
    """What came in so far. Times are the computer's, not ROS's: a stopped clock must not stop the waiting."""

    def __init__(self, frame_shown):
        self._lock = threading.Lock()
        self._frame_shown = frame_shown
        self.frames_drawn = 0
        self.frame = None
        self.profiles = 0
        self.last_profile = None
        self.scan_shape = None
        self.diagnostics = {}
        self.diagnosed = 0.0
        self._subscribers = [
            rospy.Subscriber("stripe_image", Image, self._on_frame, queue_size=1, buff_size=1 << 24),
            rospy.Subscriber("profile_points", PointCloud2, self._on_profile, queue_size=100, buff_size=1 << 22),
            rospy.Subscriber("scan_points", PointCloud2, self._on_scan, queue_size=1, buff_size=1 << 24),
            subscribe("/diagnostics", self._on_diagnostics, queue_size=100),
        ]

    def _on_frame(self, message):
        with self._lock:
            self.frames_drawn += 1
            if self.frames_drawn <= self._frame_shown:
                self.frame = message

    def _on_profile(self, message):
        with self._lock:
            self.profiles += 1
            self.last_profile = time.monotonic()

    def _on_scan(self, message):
        with self._lock:
            self.scan_shape = (message.height, message.width)

    def _on_diagnostics(self, message):
        for status in message.status:
            if "triangulation" in status.name and any(value.key == "frames in" for value in status.values):
                with self._lock:
                    self.diagnostics = {value.key: value.value for value in status.values}
                    self.diagnosed = time.monotonic()


def wait_for(what, condition, seconds):
    """@raises WatchError when it does not come true in time."""
    deadline = time.monotonic() + seconds
    while not condition():
        if rospy.is_shutdown():
            raise WatchError("stopped while waiting for %s" % what)
        if time.monotonic() > deadline:
            raise WatchError("no %s within %g s, see what the launch printed" % (what, seconds))
        time.sleep(0.05)


def image_array(message):
    """An RGB or grey array of a drawn frame."""
    channels = {"mono8": 1, "rgb8": 3, "bgr8": 3}.get(message.encoding)
    if channels is None:
        raise WatchError("stripe_image has encoding %s, must be mono8, rgb8 or bgr8" % message.encoding)
    pixels = np.frombuffer(message.data, np.uint8).reshape(message.height, message.step)
    pixels = pixels[:, :message.width * channels].reshape(message.height, message.width, channels)
    if message.encoding == "bgr8":
        pixels = pixels[..., ::-1]
    return np.repeat(pixels, 3, axis=2) if channels == 1 else pixels


def around_the_stripe(picture, margin=120):
    """The rows that something was drawn on, and some more: the rest of the frame is dark. The whole if nothing was."""
    drawn = np.flatnonzero((np.ptp(picture.astype(int), axis=2) > 60).any(axis=1))
    return picture[max(drawn[0] - margin, 0):drawn[-1] + margin] if drawn.size else picture


def call(name, service, *arguments):
    try:
        answer = rospy.ServiceProxy(name, service)(*arguments)
    except rospy.ServiceException as error:
        raise WatchError("%s: %s" % (rospy.resolve_name(name), error))
    if not answer.success:
        raise WatchError("%s: %s" % (rospy.resolve_name(name), answer.message))
    return answer.message


def run(output, quiet_seconds, frame_shown):
    watch = Watch(frame_shown)
    wait_for("profile", lambda: watch.profiles > 0, 300)
    wait_for("end of the scan", lambda: time.monotonic() - watch.last_profile > quiet_seconds, 900)
    call("stop_scan", Trigger)
    stopped = time.monotonic()
    wait_for("cloud on scan_points", lambda: watch.scan_shape is not None, 30)
    call("save_scan", SaveScan, os.path.join(output, "scan.pcd"), "pcd")
    # two reports later, every frame is in the balance
    wait_for("diagnostics of triangulation", lambda: watch.diagnosed > stopped + 2.0, 30)
    if watch.frame is None:
        raise WatchError("no message on %s" % rospy.resolve_name("stripe_image"))
    picture = around_the_stripe(image_array(watch.frame))
    imsave(os.path.join(output, "frame.png"), np.ascontiguousarray(picture))
    with open(os.path.join(output, "figures.json"), "w") as file:
        json.dump(watch.diagnostics, file, indent=2)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", help="directory to write to")
    parser.add_argument("--quiet-seconds", type=float, default=3.0, help="the scan is over after so long without a profile")
    parser.add_argument("--frame-shown", type=int, default=100, help="which drawn frame is kept")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("demo_watch", anonymous=True, disable_signals=True)
    try:
        run(os.path.abspath(arguments.output), arguments.quiet_seconds, arguments.frame_shown)
    except WatchError as error:
        print("demo_watch: %s" % error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
