#!/usr/bin/env python3
"""Where the picture and the numbers go, and what happens where they cannot."""

import json
import os
import resource
import shutil
import unittest

from support import SMALL, CommandTest, colours, png_size, run


def little_space():
    """For the child: no file may become longer than this."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))


class OutputTest(CommandTest):
    def test_the_picture_has_the_size(self):
        for size in ((1, 1), (1, 300), (300, 1), (17, 33), (641, 361)):
            path = self.folder / "out.png"
            self.assertEqual(self.assert_done("capture", "-o", path, "--size", "%dx%d" % size), b"")
            self.assertEqual(png_size(path.read_bytes()), size)

    def test_the_default_size(self):
        path = self.folder / "out.png"
        self.assert_done("capture", "-o", path)
        self.assertEqual(png_size(path.read_bytes()), (1280, 720))

    def test_something_is_drawn(self):
        self.assertGreater(colours(self.capture()), 100)
        self.assertNotEqual(self.capture(), self.capture("--panel"))
        self.assertNotEqual(self.capture("--samples", "1"), self.capture("--samples", "4"))

    def test_samples(self):
        for samples in ("1", "2", "4"):
            self.capture("--samples", samples)

    def test_standard_output(self):
        picture = self.capture()
        self.assertEqual(self.assert_done("capture", "-o", "-", *SMALL), picture)
        text = self.assert_done("capture", "-o", self.folder / "out.png", "--numbers", "-", *SMALL)
        self.assertEqual(json.loads(text)["rank"], 3)

    def test_standard_output_into_a_file(self):
        picture = self.capture()
        path = self.folder / "redirected.png"
        with open(path, "wb") as file:
            self.assert_done("capture", "-o", "-", *SMALL, stdout=file)
        self.assertEqual(path.read_bytes(), picture)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["picture.png", "redirected.png"])

    def test_an_existing_picture_is_replaced(self):
        path = self.file("out.png", "old")
        self.assert_done("capture", "-o", path, *SMALL)
        self.assertEqual(png_size(path.read_bytes()), (160, 120))

    def test_a_folder_that_does_not_exist(self):
        for option in ("--output", "--numbers"):
            path = self.folder / "none" / "out"
            arguments = {"--output": self.folder / "out.png", option: path}
            self.assert_fails(3, "capture", *SMALL, *sum(arguments.items(), ()), says=(path, self.folder / "none"))

    def test_a_folder_in_place_of_a_file(self):
        self.assert_fails(3, "capture", "-o", self.folder, *SMALL, says=(self.folder, "folder"))

    def test_a_full_disk(self):
        self.assert_fails(3, "capture", "-o", "/dev/full", *SMALL, says=("/dev/full", "No space left"))
        self.assert_fails(3, "capture", "-o", self.folder / "out.png", "--numbers", "/dev/full", *SMALL,
                          says=("/dev/full", "No space left"))
        with open("/dev/full", "wb") as full:
            self.assert_fails(3, "capture", "-o", "-", *SMALL, stdout=full, says="No space left")

    def test_a_full_disk_keeps_the_old_picture(self):
        path = self.file("out.png", "old")
        self.assert_fails(3, "capture", "-o", path, *SMALL, preexec_fn=little_space, says=(path, "cannot be written"))
        self.assertEqual(path.read_text(), "old")
        self.assertEqual(list(self.folder.iterdir()), [path])

    def test_what_is_private_stays_so(self):
        path = self.folder / "a.png"
        path.write_text("old")
        path.chmod(0o600)
        self.assert_done("capture", "-o", path, *SMALL)
        self.assertEqual(path.stat().st_mode & 0o777, 0o600)
        self.assertTrue(path.read_bytes().startswith(b"\x89PNG"))

    @unittest.skipIf(os.geteuid() == 0, "the superuser writes anywhere")
    def test_what_is_write_protected_stays(self):
        path = self.folder / "a.png"
        path.write_text("old")
        path.chmod(0o400)
        self.assert_fails(3, "capture", "-o", path, *SMALL, says=(path, "cannot be written: Permission denied"))
        self.assertEqual(path.read_text(), "old")

    def test_a_full_disk_leaves_nothing_half_done(self):
        checks = self.folder.with_suffix(".json")
        checks.write_text('{"normalscope_check": 1, "checks": [{"scene": "split", "size": "160x120", "numbers": {"rank": 2}}]}')
        self.addCleanup(checks.unlink)
        out = self.folder / "out"
        results = ("--results", self.folder / "results")
        for file, command in (("out", ("handout", "2-gradients", *SMALL, "-o", out)),
                              ("out.svg", ("capture", "-o", f"{out}.svg")),
                              ("out-0.png", ("sweep", "--vary", "camera.azimuth=0:9:3", *SMALL, "-o", f"{out}-%d.png")),
                              ("out-", ("sweep", "--vary", "camera.azimuth=0:9:3", *SMALL, "-o", f"{out}-%d.png", "--jobs", "2")),
                              ("out.gif", ("sweep", "--vary", "camera.azimuth=0:9:3", *SMALL, "-o", f"{out}.gif")),
                              ("out.mp4", ("animate", "2-gradients", *SMALL, "-o", f"{out}.mp4"))):
            if file.endswith(("gif", "mp4")) and not shutil.which("ffmpeg"):
                continue
            with self.subTest(command):
                self.assert_fails(3, *command, preexec_fn=little_space, says=(self.folder / file, ": cannot be written"))
                self.assertEqual(list(self.folder.iterdir()), [])
        # What was found is said all the same.
        for report in ((), ("--report", out)):
            done = run("check", checks, *results, *report, preexec_fn=little_space)
            self.assertIn(b"fail: split: rank is 3, expected 2; ", done.stdout)
            self.assertIn(b"cannot be written", done.stderr if report else done.stdout)
            self.assertEqual(done.returncode, 3 if report else 1)

    def test_a_link_stays_a_link(self):
        real, link = self.file("real.png", "old"), self.folder / "link.png"
        link.symlink_to("real.png")
        self.assert_done("capture", "-o", link, *SMALL)
        self.assertTrue(link.is_symlink())
        self.assertEqual(png_size(real.read_bytes()), (160, 120))

    def test_a_result_that_cannot_be_printed(self):
        picture = self.file("picture.png", self.capture())
        with open("/dev/full", "wb") as full:
            self.assert_fails(3, "compare", picture, picture, stdout=full, says="standard output")


if __name__ == "__main__":
    unittest.main()
