#!/usr/bin/env python3
"""--help and --version at every level. NORMALSCOPE_UPDATE_SNAPSHOTS=1 rewrites the snapshots."""

import os
import pathlib
import unittest

from support import CommandTest

SNAPSHOTS = pathlib.Path(__file__).parent / "snapshots"
COMMANDS = ("", "capture", "sweep", "explain", "scenes", "lessons", "handout", "slides", "quiz", "animate", "compare", "check")


class HelpTest(CommandTest):
    def test_help_is_as_in_the_snapshots(self):
        for command in COMMANDS:
            with self.subTest(command):
                text = self.assert_done(*command.split(), "--help").decode()
                self.assertEqual(text, self.assert_done(*command.split(), "-h").decode())
                self.assertLessEqual(max(map(len, text.splitlines())), 100)
                snapshot = SNAPSHOTS / f"{command or 'normalscope'}.txt"
                if os.environ.get("NORMALSCOPE_UPDATE_SNAPSHOTS"):
                    snapshot.write_text(text)
                self.assertEqual(text, snapshot.read_text())

    def test_help_lists_every_command(self):
        text = self.assert_done("--help").decode()
        for command in COMMANDS:
            self.assertIn(command, text)

    def test_version(self):
        for command in COMMANDS:
            text = self.assert_done(*command.split(), "--version").decode()
            self.assertRegex(text, r"\Anormalscope \d+\.\d+\.\d+\n\Z")

    def test_help_wins_over_what_is_missing(self):
        self.assertIn(b"Usage:", self.assert_done("capture", "split", "--help"))
        self.assertIn(b"Usage:", self.assert_done("compare", "--help"))


if __name__ == "__main__":
    unittest.main()
