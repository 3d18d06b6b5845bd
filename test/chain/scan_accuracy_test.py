#!/usr/bin/python3
"""The whole chain on the chiral scenes against the truth, and that wrong placing is seen.

Usage: scan_accuracy_test.py ROOT COMMANDS WORK_FOLDER
"""
import filecmp
import os
import subprocess
import sys
import unittest

ROOT, COMMANDS, WORK = (os.path.abspath(word) for word in sys.argv[1:4])
sys.path.insert(0, os.path.join(ROOT, "scripts"))

import numpy as np  # noqa: E402
import yaml  # noqa: E402
import rosbag  # noqa: E402

from compare_with_truth import Truth, compare, within_limits  # noqa: E402
from scan_file import read_scan  # noqa: E402

PX = 83.3e-6  # a px-equivalent of the default rig [m]
SCENES = ("chiral", "chiral_part_moves", "chiral_tf")


def run(*words):
    return subprocess.run([os.path.join(COMMANDS, words[0])] + list(words[1:]), stderr=subprocess.PIPE, text=True)


def bag_of(scene):
    """The scene's bag, simulated once."""
    bag = os.path.join(WORK, scene + ".bag")
    if not os.path.exists(bag):
        done = run("simulate_scan", "--scene", os.path.join(ROOT, "config/scenes", scene + ".yaml"), "--out", bag)
        assert done.returncode == 0, done.stderr
    return bag


def scan(bag, out, calibration=None, scene=None):
    words = ["scan_bag", "--calibration", calibration or bag + ".truth/calibration.yaml", "--out", os.path.join(WORK, out)]
    if scene == "chiral_tf":
        words += ["--motion", "tf", "--fixed-frame", "world"]
    done = run(*(words + [bag]))
    assert done.returncode == 0, done.stderr
    return os.path.join(WORK, out, "scan.pcd")


def figures(scan_file, bag):
    return compare(read_scan(scan_file), Truth(bag + ".truth/centres.csv"), PX)


class ScanAccuracy(unittest.TestCase):
    def test_every_scene_is_within_the_limits(self):
        for scene in SCENES:
            with self.subTest(scene=scene):
                bag = bag_of(scene)
                result = figures(scan(bag, "good_" + scene, scene=scene), bag)
                print(scene, result)
                self.assertGreater(result["points_compared"], 200000)
                self.assertEqual(list(within_limits(result, PX)), [])

    def test_the_same_bag_gives_the_same_bytes(self):
        bag = bag_of("chiral")
        first = scan(bag, "first")
        second = scan(bag, "second")
        for name in ("scan.pcd", "scan.ply", "summary.json"):
            self.assertTrue(filecmp.cmp(os.path.join(os.path.dirname(first), name),
                                        os.path.join(os.path.dirname(second), name), shallow=False), name)

    def test_the_wrong_sign_of_motion_is_seen(self):
        for scene in SCENES[:2]:
            bag = bag_of(scene)
            with open(bag + ".truth/calibration.yaml") as file:
                calibration = yaml.safe_load(file)
            calibration["stage"]["axis"] = [-value for value in calibration["stage"]["axis"]]
            wrong = os.path.join(WORK, scene + "_wrong_sign.yaml")
            with open(wrong, "w") as file:
                yaml.safe_dump(calibration, file)
            result = figures(scan(bag, "wrong_sign_" + scene, calibration=wrong), bag)
            print("wrong sign,", scene, result)
            # reversing the axis turns the cloud by 180 degrees about z: z and the stage's position stay, x does not
            self.assertGreater(result["rms_x"], 100e-6)
            self.assertTrue(list(within_limits(result, PX)))

    def test_placing_by_time_or_frame_number_is_seen(self):
        """An encoder that pretends constant speed is placing by time; with frames at equal times, by frame number."""
        bag = bag_of("chiral")
        pretended = os.path.join(WORK, "constant_speed.bag")
        with rosbag.Bag(bag) as source:
            samples = [(t.to_sec(), m.position[0]) for topic, m, t in source.read_messages("/profiler/joint_states")]
            begin, end = samples[0], samples[-1]
            speed = (end[1] - begin[1]) / (end[0] - begin[0])
            with rosbag.Bag(pretended, "w") as target:
                for topic, message, t in source.read_messages():
                    if topic == "/profiler/joint_states":
                        message.position = [begin[1] + speed * (message.header.stamp.to_sec() - begin[0])]
                    target.write(topic, message, t)
        for suffix in ("calibration.yaml", "centres.csv"):
            os.makedirs(pretended + ".truth", exist_ok=True)
            link = os.path.join(pretended + ".truth", suffix)
            if not os.path.exists(link):
                os.symlink(os.path.join(bag + ".truth", suffix), link)
        result = figures(scan(pretended, "by_time"), pretended)
        print("placed by time:", result)
        self.assertGreater(result["rms_y"], 100e-6)
        self.assertTrue(list(within_limits(result, PX)))

    def test_the_harsh_preset_is_reported(self):
        bag = os.path.join(WORK, "harsh.bag")
        if not os.path.exists(bag):
            done = run("simulate_scan", "--preset", "harsh", "--out", bag)
            self.assertEqual(done.returncode, 0, done.stderr)
        words = ["scan_bag", "--calibration", bag + ".truth/calibration.yaml", "--out", os.path.join(WORK, "harsh"),
                 "--max-drop", "1", bag]
        self.assertEqual(run(*words).returncode, 0)
        result = figures(os.path.join(WORK, "harsh", "scan.pcd"), bag)
        print("harsh:", result)
        self.assertTrue(np.isfinite(result["rms_z"]))


if __name__ == "__main__":
    os.makedirs(WORK, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
