#!/usr/bin/env python3
"""scripts/tidy_file says why a clang-tidy failed: run with clang-tidies that are made up.

    tidy_file_test.py ROOT
"""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv.pop(1)


class TidyFile(unittest.TestCase):
    def tidy(self, script):
        """Runs scripts/tidy_file with this for a clang-tidy."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "clang-tidy")
            with open(path, "w") as file:
                file.write("#!/bin/bash\n" + script)
            os.chmod(path, 0o755)
            environment = dict(os.environ, PATH=folder + ":/usr/bin:/bin")
            return subprocess.run([os.path.join(ROOT, "scripts", "tidy_file"), "build", "src/some.cpp"],
                                  env=environment, capture_output=True, text=True, timeout=60)

    def test_a_clean_file_says_nothing(self):
        done = self.tidy('echo "12 warnings generated." >&2')
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_what_it_found_stays_on_standard_output(self):
        done = self.tidy('echo "some.cpp:1:1: error: bad"; echo "1 warning generated." >&2; exit 1')
        self.assertEqual(done.returncode, 1)
        self.assertIn("error: bad", done.stdout)
        self.assertIn("clang-tidy of src/some.cpp ended with status 1\n1 warning generated.\n", done.stderr)

    def test_a_killed_one_is_told_by_its_signal(self):
        done = self.tidy("kill -KILL $$")
        self.assertEqual(done.returncode, 1)
        self.assertIn("clang-tidy of src/some.cpp was killed by signal 9 (SIGKILL); is the memory full?", done.stderr)
        done = self.tidy('echo "Stack dump:" >&2; kill -SEGV $$')
        self.assertIn("killed by signal 11 (SIGSEGV)\nStack dump:\n", done.stderr)
        self.assertNotIn("memory", done.stderr)

    def test_only_the_end_of_what_it_wrote_is_shown(self):
        done = self.tidy("for i in $(seq 100); do echo line $i >&2; done; exit 2")
        self.assertIn("ended with status 2\nline 86\n", done.stderr)
        self.assertTrue(done.stderr.endswith("line 100\n"), done.stderr)

    def test_without_a_clang_tidy_it_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("bash", "mktemp", "rm", "tail"):
                os.symlink("/bin/" + name, os.path.join(folder, name))
            done = subprocess.run([os.path.join(ROOT, "scripts", "tidy_file"), "build", "src/some.cpp"],
                                  env={"PATH": folder}, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("command not found", done.stderr)


class Lint(unittest.TestCase):
    def test_goes_by_tidy_file(self):
        with open(os.path.join(ROOT, "scripts", "lint")) as file:
            self.assertIn('"$root/scripts/tidy_file" "$build" "${built[@]}"', file.read())


unittest.main()
