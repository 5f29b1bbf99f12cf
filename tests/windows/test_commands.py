#!/usr/bin/env python3
"""The program for Windows, under Wine: its commands, their exit codes and pictures, beside those of the program for Linux."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

WINE = os.environ.get("WINE", "wine")
EXE = os.environ.get("NORMALSCOPE_EXE", "build/windows/normalscope.exe")
NORMALSCOPE = os.environ.get("NORMALSCOPE", "build/normalscope")
NAME = "räume-面-😀"
SMALL = ("--size", "160x120")


class WindowsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix=NAME)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_exe(self, *arguments, code=0, **options):
        """What it prints, decoded; with its exit code as it should be."""
        options.setdefault("stdin", subprocess.DEVNULL)
        done = subprocess.run([WINE, EXE, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=300, check=False, **options)
        self.assertEqual(done.returncode, code, done.stderr.decode())
        self.errors = done.stderr.decode()
        return done.stdout

    def run_here(self, *arguments):
        subprocess.run([NORMALSCOPE, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL, check=True)

    def assert_close(self, a, b, where=""):
        """But for the last digits, which the C library's sines decide."""
        self.assertIs(type(a), type(b), where)
        if isinstance(a, dict):
            self.assertEqual(a.keys(), b.keys(), where)
            for key in a:
                self.assert_close(a[key], b[key], f"{where}.{key}")
        elif isinstance(a, list):
            self.assertEqual(len(a), len(b), where)
            for i, (one, other) in enumerate(zip(a, b)):
                self.assert_close(one, other, f"{where}.{i}")
        elif isinstance(a, float):
            self.assertAlmostEqual(a, b, delta=1e-9 * max(1.0, abs(a)), msg=where)
        else:
            self.assertEqual(a, b, where)

    def test_it_says_what_it_is(self):
        here = subprocess.run([NORMALSCOPE, "--version"], stdout=subprocess.PIPE, check=True).stdout
        self.assertEqual(self.run_exe("--version"), here)
        self.assertEqual(self.run_exe("--help"), subprocess.run([NORMALSCOPE, "--help"], stdout=subprocess.PIPE, check=True).stdout)

    def test_the_same_numbers(self):
        for scene in ("shear", "reflection", "implicit-torus"):
            self.assertEqual(self.run_exe("explain", scene),
                             subprocess.run([NORMALSCOPE, "explain", scene], stdout=subprocess.PIPE, check=True).stdout)

    def test_the_same_pictures(self):
        for scene in ("shear", "implicit-torus", "3-when-naive-is-right#2"):
            self.run_exe("capture", scene, "-o", "windows.png", "--numbers", "windows.json", *SMALL)
            self.run_here("capture", scene, "-o", "linux.png", "--numbers", "linux.json", *SMALL)
            self.run_here("compare", "windows.png", "linux.png", "--tolerance", "0", "--share", "0")
            windows, linux = (json.loads((self.folder / f"{system}.json").read_text()) for system in ("windows", "linux"))
            self.assertEqual(windows["context"], "hidden-window")
            for numbers in (windows, linux):
                for of_the_driver in ("renderer", "gl_version", "context"):
                    del numbers[of_the_driver]
            self.assert_close(windows, linux)

    def test_a_driver_that_is_too_old(self):
        old = {**os.environ, "MESA_GL_VERSION_OVERRIDE": "3.0"}
        self.run_exe("capture", "-o", "old.png", *SMALL, code=4, env=old)
        self.assertRegex(self.errors, r"(?m)^normalscope: no graphics context: a hidden window: [^;\n]+; OpenGL 3\.3 is needed")
        self.assertIn("opengl32.dll", self.errors)
        for missing in ("OSMesa", "EGL"):
            self.assertNotIn(missing, self.errors)
        self.run_exe("capture", "-o", "old.png", "--context", "osmesa", *SMALL, code=4)
        self.assertRegex(self.errors, r": OSMesa: [^;\n]+; put Mesa's osmesa\.dll beside normalscope\.exe, or use --context auto")

    def test_a_picture_on_standard_output_is_bytes(self):
        picture = self.run_exe("capture", "-o", "-", *SMALL)
        self.assertTrue(picture.startswith(b"\x89PNG\r\n\x1a\n") and picture.endswith(b"IEND\xaeB`\x82"))

    def test_names_that_are_not_ascii(self):
        mesh = self.folder / f"{NAME}.obj"
        mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        scene = self.folder / f"{NAME}.json"
        scene.write_text(json.dumps({"surface": {"mesh": mesh.name}}))
        for file in (mesh, scene):
            self.run_exe("capture", file.name, "-o", f"{NAME}.png", *SMALL)
            self.run_exe("compare", f"{NAME}.png", f"{NAME}.png")
        self.run_exe("capture", "-o", f"{NAME}.svg")
        self.assertTrue((self.folder / f"{NAME}.svg").exists())
        self.run_exe("capture", f"{NAME}-2.json", "-o", "out.png", code=3)
        self.assertIn(f"{NAME}-2.json: cannot be read", self.errors)

    def test_a_scene_from_standard_input(self):
        scene = b'{"surface": {"shape": "sphere"}}'
        expected = self.run_exe("capture", "-", "-o", "-", *SMALL, input=scene, stdin=None)
        self.assertTrue(expected.startswith(b"\x89PNG"))
        self.run_exe("sweep", "-", "--vary", "light.azimuth=-90:90:2", "-o", "out-%02d.png", "--jobs", "2", *SMALL,
                     input=scene, stdin=None)
        self.assertEqual(len(list(self.folder.glob("out-*.png"))), 2)

    def test_checks_by_several_processes(self):
        checks = [{"name": f"{NAME}: {i}?", "scene": scene, "reference": f"{NAME}-{i}.png"}
                  for i, scene in enumerate(("shear", "reflection", "implicit-torus", "uniform"))]
        (self.folder / "manifest.json").write_text(json.dumps({"normalscope_check": 1, "size": "160x120", "checks": checks}))
        self.run_exe("check", "manifest.json", "--jobs", "2", code=1)
        self.run_exe("check", "manifest.json", "--jobs", "2", "--update")
        out = self.run_exe("check", "manifest.json", "--jobs", "2", "--junit", "junit.xml", "--report", "report.html").decode()
        self.assertIn("4 of 4 checks pass", out)
        self.assertIn(f'name="{NAME}: 3?"', (self.folder / "junit.xml").read_text())
        self.run_here("check", "manifest.json")  # which draws the same
        self.assertEqual([file.name for file in self.folder.rglob("*.part*")], [])

    def test_errors(self):
        self.run_exe("capture", "nothing.json", "-o", "out.png", code=3)
        self.run_exe("capture", "-o", "out.jpg", code=2)
        self.run_exe("capture", "-o", "out.png", "--context", "egl", code=4)
        self.assertNotIn("install lib", self.errors)
        self.run_exe("sweep", "--vary", "light.azimuth=-90:90:2", "-o", "out.mp4", code=3)
        self.assertIn("ffmpeg.exe", self.errors)
        self.run_exe("capture", "-o", "no-folder/out.png", code=3)


if __name__ == "__main__":
    unittest.main()
