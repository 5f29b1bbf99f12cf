#!/usr/bin/env python3
"""sweep: the same pictures as single captures, whatever the number of processes; videos; and a cancel in the middle."""

import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from support import NORMALSCOPE, SMALL, CommandTest, png_size


class SweepTest(CommandTest):
    def sweep(self, *arguments, **options):
        return self.assert_done("sweep", *arguments, *SMALL, **options)

    def names(self, folder=None):
        return sorted(p.name for p in (folder or self.folder).iterdir())

    def test_a_pipe_is_refused(self):
        os.mkfifo(self.folder / "m.obj")
        for jobs in ("1", "2"):
            self.assert_fails(3, "sweep", self.folder / "m.obj", "--vary", "camera.azimuth=0:9:2", "--jobs", jobs, "-o", self.folder / "f-%d.png", *SMALL,
                              says="reads its mesh several times")

    def test_the_pictures_are_those_of_capture(self):
        self.sweep("split", "--vary", "stack.0.scale.1=1:3:3", "-o", self.folder / "f-%02d.png")
        self.assertEqual(self.names(), ["f-00.png", "f-01.png", "f-02.png"])
        for name, value in (("f-00.png", 1), ("f-01.png", 2), ("f-02.png", 3)):
            self.assertEqual((self.folder / name).read_bytes(), self.capture("split", "--set", f"stack.0.scale.1={value}"))

    def test_a_picture_does_not_depend_on_those_before_it(self):
        # The interface, with a tab and its memory; and from one surface to another.
        self.sweep("--vary", "surface.resolution=8:32:4", "--tab", "derivation", "-o", self.folder / "%d.png")
        self.assertEqual((self.folder / "3.png").read_bytes(),
                         self.capture("--set", "surface.resolution=32", "--tab", "derivation"))

    def test_processes_draw_the_same(self):
        vary = ("--vary", "camera.azimuth=0:90:7", "--numbers")
        self.sweep(*vary, self.folder / "1.json", "-o", self.folder / "one/")
        self.sweep(*vary, self.folder / "3.json", "-o", self.folder / "three/", "--jobs", 3)
        self.assertEqual(len(self.names(self.folder / "one")), 7)
        for name in self.names(self.folder / "one"):
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "three" / name).read_bytes())
        numbers = [json.loads((self.folder / f"{n}.json").read_text()) for n in (1, 3)]
        self.assertEqual(*numbers)
        self.assertEqual([entry["set"] for entry in numbers[0]], [[f"camera.azimuth={15 * i}"] for i in range(7)])

    def test_two_make_a_grid(self):
        self.sweep("--vary", "stack.0.scale=[1,1,1]:[0.5,2,1]:2", "--vary", "camera.azimuth=0:90:3",
                   "-o", self.folder / "f-%d-%d.png", "--sheet", self.folder / "sheet.png")
        self.assertEqual(self.names(), [f"f-{r}-{c}.png" for r in (0, 1) for c in (0, 1, 2)] + ["sheet.png"])
        self.assertEqual((self.folder / "f-1-2.png").read_bytes(), self.capture("--set", "camera.azimuth=90"))
        self.assertEqual(png_size((self.folder / "sheet.png").read_bytes()), (3 * 160 + 8, 2 * 120 + 4))

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_videos(self):
        for name, start in (("v.gif", b"GIF89a"), ("v.mp4", b""), ("v.webm", b"\x1aE\xdf\xa3")):
            self.assert_done("sweep", "--vary", "camera.azimuth=0:20:3", "-o", self.folder / name, "--size", "81x61")
            video = (self.folder / name).read_bytes()
            self.assertTrue(video.startswith(start))
            self.assert_done("sweep", "--vary", "camera.azimuth=0:20:3", "-o", self.folder / name, "--size", "81x61")
            self.assertEqual((self.folder / name).read_bytes(), video)  # the same bytes each time
        self.assertIn(b"ftyp", (self.folder / "v.mp4").read_bytes()[:16])
        self.assertEqual(self.names(), ["v.gif", "v.mp4", "v.webm"])

    def test_a_video_without_ffmpeg(self):
        self.assert_fails(3, "sweep", "--vary", "camera.azimuth=0:9:2", "-o", self.folder / "v.gif", env={"PATH": "/none"},
                          says=("v.gif", "install the package ffmpeg", "frame-%03d.png"))

    def test_a_number_may_stand_in_a_folders_name(self):
        self.assertEqual(self.assert_done("sweep", "--vary", "camera.azimuth=0:9:2", "-o", self.folder / "turn-%d" / "a.png", *SMALL).decode(),
                         f"2 pictures: {self.folder}/turn-0/a.png to {self.folder}/turn-1/a.png\n")
        self.assertEqual([p.name for p in sorted(self.folder.glob("*/*"))], ["a.png", "a.png"])

    def test_a_folder_with_a_percent_sign_is_taken_as_it_is(self):
        for name in ("feature%2Fx", "50% done", "p%dq"):
            folder = self.folder / name
            self.assert_done("sweep", "--vary", "camera.azimuth=0:9:2", "-o", f"{folder}/", *SMALL)
            self.assertEqual(self.names(folder), ["frame-000.png", "frame-001.png"])
        self.assertEqual(self.names(), ["50% done", "feature%2Fx", "p%dq"])

    def test_a_cancel_leaves_whole_pictures_only(self):
        for jobs, number in (("1", signal.SIGHUP), ("2", signal.SIGINT)):
            out = self.folder / jobs
            child = subprocess.Popen([NORMALSCOPE, "sweep", "--vary", "camera.azimuth=0:360:5000", "-o", f"{out}/", *SMALL,
                                      "--jobs", jobs], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            while not out.exists() or len(self.names(out)) < 3:
                time.sleep(0.02)
            child.send_signal(number)
            stdout, stderr = child.communicate(timeout=60)
            self.assertEqual((child.returncode, stdout), (128 + number, b""))
            self.assertRegex(stderr.decode().splitlines()[-1], r"cancelled after \d+ of 5000 pictures")
            for path in out.iterdir():
                self.assertRegex(path.name, r"\Aframe-\d+\.png\Z")
                self.assertTrue(path.read_bytes().endswith(b"IEND\xaeB`\x82"), path)

    def test_a_cancelled_video_leaves_nothing(self):
        if not shutil.which("ffmpeg"):
            self.skipTest("ffmpeg is not installed")
        child = subprocess.Popen([NORMALSCOPE, "sweep", "--vary", "camera.azimuth=0:360:5000", "-o", self.folder / "v.gif",
                                  *SMALL], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while not self.names():
            time.sleep(0.02)
        child.send_signal(signal.SIGTERM)
        child.communicate(timeout=60)
        self.assertEqual((child.returncode, self.names()), (143, []))

    def test_a_process_that_dies_is_told(self):
        child = subprocess.Popen([NORMALSCOPE, "sweep", "--vary", "camera.azimuth=0:360:5000", "-o", f"{self.folder}/", *SMALL,
                                  "--jobs", "2"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while len(self.names()) < 3:
            time.sleep(0.02)
        with open(f"/proc/{child.pid}/task/{child.pid}/children", encoding="ascii") as file:
            children = file.read().split()
        os.kill(int(children[0]), signal.SIGKILL)
        _, stderr = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 3)
        self.assertIn("a process that draws was ended by a signal (Killed) before it was done", stderr.decode())

    def test_usage(self):
        out = self.folder / "%d.png"
        for vary in ("camera.azimuth", "camera.azimuth=1", "=1:2", "camera.azimuth=a:b", "camera.azimuth=1:2:0",
                     "camera.azimuth=1:2:3:4", "stack.0.scale=[1,1]:[1,1,1]", "camera.azimuth=1:1e999", "x=" + "[" * 9999 + ":1"):
            self.assert_fails(2, "sweep", "--vary", vary, "-o", out, says="--vary")
        self.assert_fails(2, "sweep", "-o", out, says="--vary")
        for name in ("out.png", "%s.png", "%d-%d.png", "%1000d.png", "", "%d.jpg"):
            self.assert_fails(2, "sweep", "--vary", "camera.azimuth=0:1:2", "-o", name and self.folder / name, says="--output")
        self.assert_fails(2, "sweep", "--vary", "camera.azimuth=0:1:1000", "--vary", "camera.elevation=0:1:1000", "-o", out, says="1000000 pictures")
        self.assert_fails(2, "sweep", *("--vary", "camera.azimuth=0:1:2") * 2, "-o", self.folder / "%d-%d.png", says="twice")
        self.assert_fails(2, "sweep", "--vary", "camera.azimuth=0:1:2", "-o", "-", says=("--output -", "folder"))
        self.assert_fails(2, "sweep", *("--vary", "camera.azimuth=0:1:2") * 3, "-o", out, says="at most two")
        self.assert_fails(2, "sweep", "--vary", "camera.azimuth=0:1:2", "-o", out, "--jobs", "0", says="--jobs")
        self.assert_fails(2, "sweep", "--vary", "camera.azimut=0:1:2", "-o", out, says=("--vary camera.azimut", "azimuth"))
        self.assert_fails(2, "sweep", "--vary", "camera.elevation=80:100:3", "-o", out, says="--vary camera.elevation")
        self.assertEqual(self.names(), [])


if __name__ == "__main__":
    unittest.main()
