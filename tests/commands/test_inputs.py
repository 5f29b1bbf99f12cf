#!/usr/bin/env python3
"""Scenes that once went wrong, each the smallest that showed its fault; what is right is known by other means."""

import math
import pathlib
import unittest

from support import CommandTest, close_to, png_pixels

INPUTS = pathlib.Path(__file__).resolve().parent / "inputs"
BARE = ("--set", "show.probe=false", "--set", "show.axes=false", "--set", "show.legend=false", "--set", "show.grid=false",
        "--set", "arrows.show=[]", "--ground", "white")


def formula(name):
    return INPUTS / "formulas" / f"{name}.json"


class InputsTest(CommandTest):
    def bare(self, *arguments, **options):
        """The rows of pixels of what is drawn of the surface alone, on white."""
        out = self.folder / "bare.png"
        self.assert_done("capture", *arguments, "-o", out, *BARE, **options)
        return png_pixels(out.read_bytes())

    def test_poles(self):
        for text in ("x/(x^2+y^2+z^2-1)", "1/(x^2+y^2-1)", "1/(x^3-x)", "1/(z-0.3)", "tan(x+0.2)"):
            empty = text.startswith("1/")
            numbers = self.numbers(formula("pole-plane"), "--set", f"surface.formula={text}",
                                   **({"notes": ["No zero"]} if empty else {}))
            if empty:
                self.assertIsNone(numbers["probe"], text)
                self.assertIsNone(numbers["error_degrees"]["worst"], text)
                self.assertEqual(numbers["surface"]["triangles"], 0, text)
            else:  # planes that the stretch leaves perpendicular to x
                self.assertAlmostEqual(numbers["error_degrees"]["worst"], 0, 6, text)
                self.assertLess(max(numbers["worst_dot"].values()), 1e-6, text)

    def test_a_pole_alone(self):
        numbers = self.numbers(formula("pole-empty"), notes=["No zero"])
        self.assertIsNone(numbers["probe"])
        rows = self.bare(formula("pole-empty"), "--size", "160x120", notes=["No zero"])
        self.assertEqual({pixel for row in rows for pixel in row}, {(255, 255, 255, 255)})

    def test_log10(self):
        n = self.numbers(formula("log10"), "--set", "probe=[2,0,0.60206]")["probe"]["n_object"]
        slope = 1 / math.log(10)  # of log10(x^2) at x = 2
        close_to(self, [v / n[2] for v in n], [-slope, 0, 1], 4)
        self.assertAlmostEqual(abs(n[0]), 0.3984, delta=2e-4)

    def test_a_thin_sheet(self):
        numbers = self.numbers(formula("thin-sheet"))
        self.assertGreater(numbers["surface"]["triangles"], 100)
        self.assertEqual(numbers["surface"]["notes"], [])
        self.assertIsNotNone(numbers["probe"]["n_object"][0])

    def test_far_and_small(self):
        self.assertEqual(self.numbers(formula("far-small-sphere"))["surface"]["notes"], [])

    def test_squares_that_are_added(self):
        rows = self.bare(formula("sum-of-squares-curve"), "--size", "480x360", notes=["Nothing is drawn"])
        self.assertEqual({pixel for row in rows for pixel in row}, {(255, 255, 255, 255)})

    def test_the_unit_sphere_by_other_means(self):
        camera = ("--set", "camera.zoom=1", "--size", "240x180")
        sphere = self.bare(formula("cancel"), "--set", "surface.formula=x^2+y^2+z^2-1", *camera)
        for name in ("cancel", "gauss-level"):
            rows = self.bare(formula(name), *camera)
            covered = [(a == (255,) * 4) != (b == (255,) * 4)
                       for one, other in zip(rows, sphere) for a, b in zip(one, other)]
            self.assertLess(sum(covered), 20, name)

    def test_nine_degrees(self):
        """Smooth sheets, as exact arithmetic shows: no backs in the middle, and no loose threads beside them."""
        rows = self.bare(formula("nine-degree-singular"), "--size", "700x700")
        backs = [pixel for row in rows[335:385] for pixel in row[300:345] if pixel[0] - pixel[2] > 10]
        self.assertEqual(len(backs), 0)
        self.assertGreater(sum(pixel[0] - pixel[2] > 10 for row in rows for pixel in row), 1000)  # there are some elsewhere
        self.assertEqual({pixel for row in rows[214:234] for pixel in row[596:616]}, {(255, 255, 255, 255)})

    def test_large_and_small(self):
        """A torus has a closed ring around its hole, at any scale."""
        shapes = []
        for scale in (1e-6, 1e-3, 1, 200, 1e6):
            rows = self.bare(INPUTS / "maps" / "far-plane.json", "--size", "160x120",
                             "--set", f"stack.0.scale=[{scale},{scale},{scale}]", "--set", f"camera.zoom={1.5 / scale}")
            middle = [x for x in range(160) if rows[60][x] != (255,) * 4]
            column = [y for y in range(120) if rows[y][80] != (255,) * 4]
            shapes.append((len(middle), len(column)))
            self.assertGreater(column[-1] - column[0] + 1, len(column), scale)  # the hole
        self.assertEqual(len(set(shapes)), 1, shapes)

    def test_projective(self):
        probe = self.numbers(INPUTS / "maps" / "projective.json")["probe"]
        n = probe["true_normal"]
        close_to(self, [v / math.hypot(*n) for v in n], [0.40868, 0.40878, 0.81601], 3)
        self.assertEqual(sorted(round(abs(d), 3) for d in probe["dots"]["inverse-transpose"]), [0.084, 0.119])


if __name__ == "__main__":
    unittest.main()
