#!/usr/bin/env python3
"""color=normals: each pixel is n·½ + ½ of the normal that is seen there, to one step of 255."""

import math
import unittest

from support import CommandTest, png_pixels, run

SIZE = 160
BARE = [a for key in ("ghost", "grid", "axes", "tangent_plane", "probe", "legend") for a in ("--set", f"show.{key}=false")]
DISTANCE = 2.6 / math.sin(math.radians(15.0))  # of the eye at zoom 1


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def seen(radii, x, y):
    """Where the ray through a pixel's middle, from (0, 0, d), meets an ellipsoid; None within a pixel of its rim."""
    tangent = math.tan(math.radians(15.0)) / (SIZE / 2)

    def hit(px, py):
        d = ((px - SIZE / 2) * tangent, -(py - SIZE / 2) * tangent, -1.0)
        a = sum((v / r) ** 2 for v, r in zip(d, radii))
        b = d[2] * DISTANCE / radii[2] ** 2
        c = (DISTANCE / radii[2]) ** 2 - 1.0
        root = b * b - a * c
        if root < 0:
            return None
        t = (-b - math.sqrt(root)) / a
        return [t * d[0], t * d[1], DISTANCE + t * d[2]]

    around = [hit(x + 0.5 + i, y + 0.5 + j) for i in (-1.5, 0, 1.5) for j in (-1.5, 0, 1.5)]
    return around[4] if all(around) else None


class NormalsAsColoursTest(CommandTest):
    def check(self, picture, radii, normal, left=0):
        rows = png_pixels(picture)
        counted = 0
        for y in range(0, SIZE, 3):
            for x in range(0, SIZE, 3):
                p = seen(radii, x, y)
                if p is None:
                    continue
                n = unit(normal(p))
                for channel in range(3):
                    self.assertAlmostEqual(rows[y][x + left][channel], 255 * (0.5 * n[channel] + 0.5), delta=1.02,
                                           msg=(x, y, channel))
                counted += 1
        self.assertGreater(counted, 150)

    def draw(self, *arguments, width=SIZE, surface="surface.shape=sphere"):
        path = self.folder / "normals.png"
        self.assert_done("capture", "slide-scale", "--set", "color=normals", "--set", "arrows.show=[]", *BARE,
                         "--set", 'camera={"azimuth":0,"elevation":0,"zoom":1}', "--set", surface, *arguments,
                         "--size", f"{width}x{SIZE}", "-o", path)
        return path.read_bytes()

    SURFACES = ('surface={"shape":"sphere","resolution":256}', 'surface={"formula":"x^2+y^2+z^2-1"}')

    def test_a_sphere(self):
        for surface in self.SURFACES:
            with self.subTest(surface):
                self.check(self.draw("--set", "stack=[]", "--set", "view=single", surface=surface), (1, 1, 1), lambda p: p)

    def test_by_each_rule_single_and_split(self):
        radii = (0.5, 2.0, 1.0)
        right = lambda p: [v / r / r for v, r in zip(p, radii)]
        naive = lambda p: p  # M of the object's normal, which is the object's point
        for surface in self.SURFACES:
            for rule, normal in (("inverse-transpose", right), ("cofactor", right), ("naive", naive)):
                with self.subTest((surface, rule)):
                    self.check(self.draw("--set", f"rule={rule}", "--set", "view=single", surface=surface), radii, normal)
            with self.subTest((surface, "split")):
                both = self.draw("--set", "view=split", width=2 * SIZE, surface=surface)
                self.check(both, radii, naive)
                self.check(both, radii, right, left=SIZE)

    def test_a_reflection_turns_nothing_outside_in(self):
        for rule in ("inverse-transpose", "cofactor"):
            with self.subTest(rule):
                picture = self.draw("--set", "stack=[{\"scale\":[-1,1,1]}]", "--set", f"rule={rule}", "--set", "view=single")
                self.check(picture, (1, 1, 1), lambda p: p)

    def test_an_svg_says_that_it_cannot_hold_them(self):
        for color in ("normals", "error"):
            done = run("capture", "--set", f"color={color}", "-o", self.folder / "normals.svg")
            self.assertEqual(done.returncode, 0)
            self.assertRegex(done.stderr.decode(), rf"\Anormalscope: [^\n]*SVG[^\n]*color={color}[^\n]*\n\Z")

    def test_the_inside_of_what_is_open_faces_the_eye(self):
        for surface in ('surface={"shape":"plane"}', 'surface={"formula":"y","bound":1}'):
            for elevation, green in ((90, 255), (-90, 0)):
                with self.subTest((surface, elevation)):
                    rows = png_pixels(self.draw("--set", "stack=[]", "--set", "view=single", "--set",
                                               f"camera.elevation={elevation}", surface=surface))
                    r, g, b = rows[SIZE // 2][SIZE // 2][:3]
                    self.assertAlmostEqual(g, green, delta=1)
                    self.assertAlmostEqual(r, 127.5, delta=1)
                    self.assertAlmostEqual(b, 127.5, delta=1)


if __name__ == "__main__":
    unittest.main()
