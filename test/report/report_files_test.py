#!/usr/bin/python3
"""Files that appear together or not at all, whenever the user interrupts."""
import os
import signal
import tempfile
import unittest
from unittest import mock

import report_case  # noqa: F401  (finds the package)
from report.files import write_together


class WriteTogether(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.paths = [os.path.join(self.temporary.name, name) for name in ("page", "picture")]
        self.contents = {path: b"new" for path in self.paths}

    def assert_both_are_there(self):
        self.assertEqual(sorted(os.listdir(self.temporary.name)), ["page", "picture"])
        for path in self.paths:
            with open(path, "rb") as file:
                self.assertEqual(file.read(), b"new")

    def test_a_signal_between_the_files_comes_after_both(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                before = signal.getsignal(number)
                replace = os.replace

                def interrupting(*arguments):
                    os.kill(os.getpid(), number)
                    replace(*arguments)
                with mock.patch("os.replace", interrupting), self.assertRaises(KeyboardInterrupt):
                    write_together(self.contents)
                self.assert_both_are_there()
                self.assertEqual(signal.getsignal(number), before)

    def test_a_signal_that_is_ignored_stays_ignored(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.SIG_IGN))
        replace = os.replace

        def interrupting(*arguments):
            os.kill(os.getpid(), signal.SIGINT)
            replace(*arguments)
        with mock.patch("os.replace", interrupting):
            write_together(self.contents)
        self.assert_both_are_there()


if __name__ == "__main__":
    unittest.main()
