#!/usr/bin/env python3
"""Wrong usage: exit code 2, and one line that names the thing, the reason and what to do."""

import unittest

from support import CommandTest


class UsageTest(CommandTest):
    def capture_fails(self, *arguments, says=()):
        out = self.folder / "out.png"
        self.assert_fails(2, "capture", "-o", out, *arguments, says=says)
        self.assertFalse(out.exists())

    def test_sizes(self):
        for size in ("0x0", "0x720", "1280x0"):
            self.capture_fails("--size", size, says=("--size", size, "at least 1"))
        for size in ("100000x100000", "16385x1", "1x16385", "16384x16384"):
            self.capture_fails("--size", size, says=("--size", size, "16384"))
        for size in ("", "abc", "1280", "1280x", "x720", "12.5x3", "-1280x720", "1280x-720", "1280x720x3", "+1x1",
                     " 1x1", "1x1 ", "0x10x10", "nanxnan", "99999999999999999999x1"):
            self.capture_fails("--size", size, says=("--size", "1280x720"))

    def test_samples(self):
        for samples in ("3", "0", "-4", "8", "four", "4.0", ""):
            self.capture_fails("--samples", samples, says=("--samples", "1, 2 or 4"))

    def test_context(self):
        for kind in ("glx", "OSMesa", ""):
            self.capture_fails("--context", kind, says=("--context", "auto, osmesa or egl"))

    def test_an_option_without_its_value(self):
        for option in ("--size", "--samples", "--context", "--set", "--numbers"):
            self.capture_fails(option, says=option)
        self.assert_fails(2, "capture", "-o", says="--output")
        self.assert_fails(2, "--set", says="--set")
        self.assert_fails(2, "compare", "a.png", "b.png", "--diff", says="--diff")

    def test_an_empty_output(self):
        self.assert_fails(2, "capture", "-o", "", says="--output")
        self.capture_fails("--numbers", "", says="--numbers")

    def test_an_empty_value(self):
        for option in ("--scale", "--tab", "--set", "--expect"):
            self.capture_fails(option, "", says=option)
        self.assert_fails(2, "check", "checks.json", "--only", "", says="--only")
        self.assert_fails(2, "check", "", says="MANIFEST")
        self.assert_fails(2, "lessons", "--lessons", "", says="--lessons")

    def test_a_name_that_says_another_kind_of_file(self):
        for name in ("a.jpg", "a.pdf", "a.html", "a.JSON"):
            self.assert_fails(2, "capture", "-o", name, says=(name, ".png"))
        for name in ("a.png", "a.pdf", "a.xml"):
            self.assert_fails(2, "handout", "all", "-o", name, says=(name, ".html"))
        self.assert_fails(2, "quiz", "all", "-o", "a.html", says=("a.html", ".xml"))
        self.capture_fails("--numbers", "n.svg", says=("n.svg", ".json"))

    def test_what_is_missing(self):
        self.assert_fails(2, "capture", says=("--output", "capture [OPTIONS] -o OUT.png"))
        self.assert_fails(2, "capture", "split", says="--output")
        self.assert_fails(2, "compare", says="ACTUAL")
        self.assert_fails(2, "compare", "actual.png", says="EXPECTED")

    def test_what_is_too_much(self):
        self.assert_fails(2, "split", "shear", says="shear")
        self.capture_fails("split", "shear", says="shear")
        self.assert_fails(2, "scenes", "split", says="split")
        self.assert_fails(2, "compare", "a.png", "b.png", "c.png", says="c.png")

    def test_an_unknown_option_is_answered_with_the_valid_ones(self):
        self.assert_fails(2, "--bogus", says=("--bogus", "--help", "--version", "--set"))
        self.capture_fails("--bogus", says=("--bogus", "--output", "--size", "--samples", "--numbers"))
        self.capture_fails("--sise", "10x10", says="did you mean --size?")
        self.assert_fails(2, "capture", "--ouput", "out.png", says="did you mean --output?")
        self.assert_fails(2, "scenes", "-x", says="-x")
        self.assert_fails(2, "compare", "a.png", "b.png", "--tolerence=3", says="did you mean --tolerance?")

    def test_a_misspelt_command_is_answered_with_the_valid_ones(self):
        self.assert_fails(2, "captrue", says=("did you mean capture?", "scenes", "compare"))
        self.assert_fails(2, "scene", says="did you mean scenes?")

    def test_any_misspelt_name_is_guessed(self):
        self.assert_fails(3, "capture", "shera", "-o", "x.png", says="did you mean shear?")
        self.assert_fails(3, "capture", "gradients", "-o", "x.png", says="did you mean 2-gradients?")
        self.assert_fails(3, "handout", "2-gradint", "-o", "x.html", says="did you mean 2-gradients?")
        self.assert_fails(3, "capture", "sphere", "-o", "x.png", says="did you mean implicit-sphere?")
        self.capture_fails("--set", "show.prboe=1", says="did you mean probe?")

    def test_options_before_their_command(self):
        self.assert_fails(2, "--set", "rule=naive", "capture", "-o", "x.png", says="after the command")
        self.assert_fails(2, "split", "capture", "-o", "x.png", says="after the command")

    def test_settings_that_are_none(self):
        for setting in ("rule", "=naive", ""):
            self.capture_fails("--set", setting, says=("--set", "PATH=VALUE"))

    def test_comparing(self):
        for tolerance in ("-1", "256", "x", "1.5", "", "nan"):
            self.assert_fails(2, "compare", "a.png", "b.png", "--tolerance", tolerance, says=("--tolerance", "0 to 255"))
        for share in ("-0.1", "1.1", "x", "", "nan", "inf", "0.1%"):
            self.assert_fails(2, "compare", "a.png", "b.png", "--share", share, says=("--share", "0 to 1"))

    def test_two_outputs_in_one_place(self):
        out = self.folder / "out.png"
        self.capture_fails("--numbers", out, says="--numbers")
        self.assert_fails(2, "capture", "-o", "-", "--numbers", "-", says="--numbers")


if __name__ == "__main__":
    unittest.main()
