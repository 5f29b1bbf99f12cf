#!/usr/bin/env python3
"""Figures for slides and papers: SVG, and pictures without a ground."""

import json
import math
import re
import unittest
import xml.etree.ElementTree as ElementTree

from support import CommandTest, png_pixels, run

SVG = "{http://www.w3.org/2000/svg}"


class FiguresTest(CommandTest):
    def svg(self, *arguments):
        out = self.folder / "out.svg"
        self.assert_done("capture", *arguments, "-o", out)
        return out.read_bytes()

    def test_the_default_scene_is_small_and_sharp(self):
        text = self.svg()
        self.assertLess(len(text), 1 << 20)
        root = ElementTree.fromstring(text)
        self.assertFalse(list(root.iter(f"{SVG}image")))
        words = {word.text for word in root.iter(f"{SVG}text")}
        self.assertLessEqual({"x", "y", "z", "naive  M n", "inverse transpose  (M⁻¹)ᵀ n"}, words)
        self.assertTrue(any(word.endswith("° off") for word in words))
        colours = {path.get("stroke") for path in root.iter(f"{SVG}path")} | {path.get("fill") for path in root.iter(f"{SVG}path")}
        self.assertLessEqual({"#d55e00", "#009e73", "#0072b2"}, colours)

    def test_what_reaches_far_beyond_the_picture_ends_there(self):
        def stack(*factors):
            return "stack=" + json.dumps([{"scale": 3 * [factor]} for factor in factors])

        for name, *settings in (("flat", "camera.zoom=1e8"), ("slide-scale", stack(1e9), "view=overlay"),
                                ("split", "view=flat", "stack=" + json.dumps([{"scale": [1e6, 1e6, 1e-6]}])),
                                ("slide-scale", stack(1e9, 1e9, 1e9), "view=flat")):
            with self.subTest(name, settings=settings):
                text = self.svg(name, *(word for setting in settings for word in ("--set", setting)))
                self.assertLess(len(text), 200_000)
                self.assertNotRegex(text.decode(), r"(?i)\b-?(nan|inf)\b")

    def test_every_kind_of_surface(self):
        for scene in ("split", "reflection", "flattened", "implicit-torus", "identity"):
            root = ElementTree.fromstring(self.svg(scene, "--ground", "transparent"))
            self.assertGreater(len(list(root.iter(f"{SVG}path"))), 3, scene)
            self.assertFalse([rect for rect in root.findall(f"{SVG}rect") if rect.get("width") == "100%"])

    def points(self, root, **attributes):
        """The corners of all paths with these attributes."""
        paths = [path for path in root.iter(f"{SVG}path") if all(path.get(key) == value for key, value in attributes.items())]
        data = " ".join(path.get("d") for path in paths)
        return [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+)[ ,]?(-?[\d.]+)", data)]

    def test_rims(self):
        """A rim is drawn all around, also where one sees it from within."""
        for scene, rim in (("hyperboloid-one-sheet", 0.2), ("cone", 0.18), ("cylinder", 0.17), ("paraboloid", 0.6)):
            root = ElementTree.fromstring(self.svg(f"implicit-{scene}", "--set", "camera.zoom=1.45", "--size", "900x700"))
            dark = self.points(root, stroke="#22262b")
            top, bottom = min(y for _, y in dark), max(y for _, y in dark)
            points = [(x, y) for x, y in dark if y < top + rim * (bottom - top)]
            x0 = 0.5 * (min(x for x, _ in points) + max(x for x, _ in points))
            y0 = 0.5 * (top + max(y for x, y in points if abs(x - x0) < 100))
            angles = {math.floor(12 * math.atan2(y - y0, x - x0) / math.pi) for x, y in points}
            self.assertEqual(len(angles), 24, scene)

    def test_what_stands_behind(self):
        """As much of each axis is drawn as nothing stands before: never all or nothing."""
        root = ElementTree.fromstring(self.svg("implicit-clebsch-cubic", "--set", "camera.zoom=1.45", "--size", "900x700"))
        for colour, low, high in (("#d03a3a", 60, 140), ("#3a62d0", 80, 170)):
            along = [x for x, _ in self.points(root, fill=colour)]
            self.assertTrue(low < max(along) - min(along) < high, (colour, min(along), max(along)))

    def test_kinks(self):
        """A cube by formula is nine edges, and nothing else."""
        root = ElementTree.fromstring(self.svg(
            "identity", "--size", "900x700", "--set", 'surface={"formula": "max(max(abs(x),abs(y)),abs(z))-0.8"}',
            "--set", "show.probe=false"))
        lines = [path.get("d") for path in root.iter(f"{SVG}path") if path.get("stroke") == "#22262b"]
        length = 0
        for line in re.findall(r"M([^M]*)", " ".join(lines)):
            ends = [tuple(map(float, point)) for point in re.findall(r"(-?[\d.]+)[ ,]?(-?[\d.]+)", line)]
            length += sum(math.dist(a, b) for a, b in zip(ends, ends[1:]))
        fill = self.points(root, fill="#d9d8d4")
        around = [max(fill, key=lambda p: p[0] * math.cos(t) + p[1] * math.sin(t)) for t in (k * math.pi / 180 for k in range(361))]
        outline = sum(math.dist(a, b) for a, b in zip(around, around[1:]))
        self.assertTrue(1.3 * outline < length < 1.6 * outline, (length, outline))

    def test_pixels_only(self):
        for option in (["--panel"], ["--captions"], ["--tab", "ray"], ["--expect", self.folder / "a.png"]):
            self.assert_fails(2, "capture", "1-normal-as-a-point#2", "-o", self.folder / "a.svg", *option, says=(option[0], ".png"))

    def test_notes_as_of_pixels(self):
        self.file("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        for ending in ("png", "svg"):
            out = self.folder / f"a.{ending}"
            done = run("capture", self.folder / "flat.obj", "-o", out)
            self.assertEqual((done.returncode, done.stderr.count(b"\n")), (0, 1))
            self.assertIn(b"flat.obj has no normals", done.stderr)
            self.assertEqual(run("capture", self.folder / "flat.obj", "-o", out, "--fail-on-note").returncode, 1)
        done = run("capture", "-o", out, "--set", "color=error", "--numbers", "-")
        self.assertEqual((done.returncode, done.stderr.count(b"color=error is not in it")), (0, 1))

    def test_grounds(self):
        for ground, corner in (("white", (255, 255, 255, 255)), ("transparent", (0, 0, 0, 0))):
            out = self.folder / f"{ground}.png"
            self.assert_done("capture", "identity", "-o", out, "--size", "160x120", "--ground", ground,
                             "--set", "show.legend=false", "--set", "arrows.show=[]")
            pixels = png_pixels(out.read_bytes())
            self.assertEqual(pixels[0][0], corner)
            self.assertEqual(pixels[60][80][3], 255)
        self.assert_fails(2, "capture", "-o", out, "--ground", "grey", says=("transparent",))


if __name__ == "__main__":
    unittest.main()
