#!/usr/bin/python3
"""Each check must fail when what it guards is broken, and pass on a sound tree. Trees are made up in a temporary folder."""
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(HERE))


class CheckCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = self.folder.name

    def write(self, path, text):
        path = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)

    def copy(self, *paths):
        for path in paths:
            with open(os.path.join(REPOSITORY, path)) as file:
                self.write(path, file.read())

    def edit(self, path, old, new):
        with open(os.path.join(self.root, path)) as file:
            text = file.read()
        self.assertIn(old, text)
        self.write(path, text.replace(old, new, 1))

    def run_check(self, name, *arguments):
        run = subprocess.run([sys.executable, "-B", os.path.join(HERE, name + ".py"), self.root] + list(arguments),
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        return run.returncode, run.stdout

    def assert_passes(self, name, *arguments):
        code, text = self.run_check(name, *arguments)
        self.assertEqual(code, 0, text)

    def assert_fails(self, name, reason, *arguments):
        code, text = self.run_check(name, *arguments)
        self.assertEqual(code, 1, text)
        self.assertIn(reason, text)


class IncludeRules(CheckCase):
    def setUp(self):
        super().setUp()
        for number in range(20):
            self.write("include/weld_profiler/core/filler%d.h" % number, "#include <vector>\n")
        self.write("include/weld_profiler/geometry/calibration.h", "#include <array>\n")
        self.write("include/weld_profiler/stripe/stripe_params.h", '#include "weld_profiler/core/filler1.h"\n')

    def test_passes_on_a_sound_tree(self):
        self.write("src/simulation/rig.cpp", '#include "weld_profiler/geometry/calibration.h"\n#include <Eigen/Core>\n')
        self.write("src/nodelets/a.cpp", '#include <ros/ros.h>\n#include "weld_profiler/simulation/rig.h"\n')
        self.assert_passes("include_rules")

    def refused(self, path, line, reason):
        self.write(path, "#pragma once\n%s\n" % line)
        self.assert_fails("include_rules", reason)

    def test_a_ros_header_in_a_room_without_ros(self):
        self.refused("src/stripe/a.cpp", "#include <ros/time.h>", "src/stripe/a.cpp:2: ros/time.h")

    def test_a_message_in_a_room_without_ros(self):
        self.refused("src/scan/a.cpp", '  # include "sensor_msgs/Image.h"', "is no header that scan may use")

    def test_a_generated_message_in_a_room_without_ros(self):
        self.refused("src/scan/a.cpp", '#include "weld_profiler/StripeProfile.h"', "generated ROS header")

    def test_stripe_with_geometry(self):
        self.refused("src/stripe/a.cpp", '#include "weld_profiler/geometry/calibration.h"', "stripe must not include geometry")

    def test_geometry_with_stripe(self):
        self.refused("src/geometry/a.cpp", '#include "weld_profiler/stripe/stripe_params.h"',
                     "geometry must not include stripe")

    def test_stripe_with_metres(self):
        self.refused("src/stripe/a.cpp", '#include "weld_profiler/core/profile.h"', "no metres")

    def test_core_including_upward(self):
        self.refused("include/weld_profiler/core/a.h", '#include "weld_profiler/scan/export.h"', "core must not include scan")

    def test_a_room_including_nodelets(self):
        self.write("src/nodelets/load_guard.h", "#pragma once\n")
        self.write("src/stripe/a.cpp", '#include "nodelets/load_guard.h"\n')
        self.assert_fails("include_rules", "stripe must not include nodelets")

    def test_simulation_with_what_it_makes_the_truth_for(self):
        for header in ("geometry/triangulator.h", "geometry/scan_frame.h", "stripe/stripe_stage.h", "scan/export.h"):
            self.refused("src/simulation/a.cpp", '#include "weld_profiler/%s"' % header, "simulation must not include")

    def test_simulation_with_opencv(self):
        self.refused("src/simulation/a.cpp", "#include <opencv2/calib3d.hpp>", "is no header that simulation may use")

    def test_a_chain_of_rooms_through_a_private_header(self):
        self.write("src/geometry/private.h", "#pragma once\n")
        self.refused("src/stripe/a.cpp", '#include "../geometry/private.h"', "stripe must not include geometry")

    def test_an_unknown_room(self):
        self.refused("src/misc/a.cpp", "#include <vector>", "lies in no known room")

    def test_a_tree_with_nothing_in_it(self):
        with tempfile.TemporaryDirectory() as self.root:
            self.assert_fails("include_rules", "expected at least")


class OldInterfaces(CheckCase):
    def setUp(self):
        super().setUp()
        for number in range(30):
            self.write("src/core/filler%d.cpp" % number, "// cv::stackBlur in a comment is none\n")
        self.write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.13)\n")

    def test_passes_on_a_sound_tree(self):
        self.assert_passes("old_interfaces")

    def test_each_newer_interface_is_found(self):
        for line in ("cv::stackBlur(a, b, size);", "boost::shared_ptr<pcl::PointCloud<T>> c;", "pcl::Indices i;",
                     "#include <pcl/memory.h>", "Eigen::Vector<double, 3> v;", "#include <span>", "name.starts_with(x);",
                     "auto v = std::from_chars(a, b, value);"):
            self.write("src/core/a.cpp", line + "\n")
            self.assert_fails("old_interfaces", "src/core/a.cpp:1")

    def test_newer_cmake_and_native_code(self):
        for line in ("cmake_minimum_required(VERSION 3.20)", "add_compile_options(-march=native)", "cmake_path(SET a b)"):
            self.write("CMakeLists.txt", line + "\n")
            self.assert_fails("old_interfaces", "CMakeLists.txt:1")


class HeadersAlone(CheckCase):
    def setUp(self):
        super().setUp()
        for number in range(15):
            self.write("include/weld_profiler/core/filler%d.h" % number, "#pragma once\n#include <vector>\n")

    def test_passes_on_a_sound_tree(self):
        self.assert_passes("headers_alone", "c++")

    def test_a_header_that_lacks_an_include(self):
        self.write("include/weld_profiler/core/a.h", "#pragma once\ninline std::string name();\n")
        self.assert_fails("headers_alone", "core/a.h does not compile alone", "c++")

    def test_a_header_without_a_guard(self):
        self.write("include/weld_profiler/core/a.h", "struct A {};\n")
        self.assert_fails("headers_alone", "redefinition", "c++")


class LaunchFiles(CheckCase):
    def test_an_argument_without_doc(self):
        self.write("launch/scan.launch", '<launch><arg name="rate" default="1"/></launch>\n')
        self.assert_fails("launch_files", "argument 'rate' has no doc")

    def test_broken_xml(self):
        self.write("launch/scan.launch", "<launch><arg></launch>\n")
        self.assert_fails("launch_files", "is no XML")


class ParameterFiles(CheckCase):
    def setUp(self):
        super().setUp()
        self.copy("include/weld_profiler/stripe/stripe_params.h", "include/weld_profiler/scan/scan_params.h",
                  "include/weld_profiler/stage/encoder_track.h", "config/stripe_centre.yaml",
                  "config/triangulation.yaml", "cfg/StripeCentre.cfg", "cfg/Triangulation.cfg",
                  "config/weld_measurement.yaml", *("include/weld_profiler/" + header for header in (
                      "weld/weld_params.h", "weld/verdict_params.h", "weld/grinding_params.h", "weld/weld_surface.h",
                      "ros/weld_server.h")))

    def test_passes_on_this_tree(self):
        self.assert_passes("parameter_files")

    def test_another_default(self):
        self.edit("config/stripe_centre.yaml", "max_gap_px: 20", "max_gap_px: 21")
        self.assert_fails("parameter_files", "max_gap_px is 21.0")

    def test_a_name_that_is_no_field(self):
        self.edit("config/triangulation.yaml", "pitch: ", "pich: ")
        self.assert_fails("parameter_files", "'pich' is no field")

    def test_another_default_of_a_knob(self):
        self.edit("cfg/Triangulation.cfg", '"distance", edit_method', '"time", edit_method')
        self.assert_fails("parameter_files", "trigger is 'time'")


class PackageFiles(CheckCase):
    def setUp(self):
        super().setUp()
        self.copy("package.xml", "CHANGELOG.rst", "nodelet_plugins.xml", "scripts/packages.txt")
        with open(os.path.join(self.root, "nodelet_plugins.xml")) as file:
            types = [part.split('"')[0] for part in file.read().split(' type="')[1:]]
        self.assertGreater(len(types), 0)
        self.write("src/nodelets/all.cpp", "".join("PLUGINLIB_EXPORT_CLASS(%s, nodelet::Nodelet)\n" % name for name in types))

    def test_passes_on_this_tree(self):
        self.assert_passes("package_files")

    def test_a_nodelet_that_nobody_exports(self):
        self.write("src/nodelets/all.cpp", "")
        self.assert_fails("package_files", "no source exports weld_profiler::")

    def test_a_version_that_is_none(self):
        self.write("package.xml", "<package><version>1.0</version></package>")
        self.assert_fails("package_files", "MAJOR.MINOR.PATCH")

    def test_a_package_listed_twice(self):
        self.write("scripts/packages.txt", "cmake\ncmake\n")
        self.assert_fails("package_files", "cmake stands there twice")


if __name__ == "__main__":
    unittest.main()
