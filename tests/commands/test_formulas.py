#!/usr/bin/env python3
"""Surfaces by formula: what is refused and how, and what is said of what is drawn."""

import json
import math
import unittest

from support import CommandTest, close_to, run


def setting(formula):
    return ("--set", "surface.formula=" + formula)


class FormulaTest(CommandTest):
    def explained(self, *arguments):
        text = self.assert_done("explain", "--format", "json", *arguments).decode()
        return json.loads(text, parse_constant=lambda name: self.fail(name))

    def refused(self, surface, says):
        self.assert_fails(3, "explain", self.scene(surface=surface), says=says)

    def told(self, formula):
        """The one line that a capture says of it."""
        done = run("capture", *setting(formula), "-o", self.folder / "p.png", "--size", "64x64")
        self.assertEqual((done.returncode, done.stderr.count(b"\n")), (0, 1))
        return done.stderr.decode()

    def test_what_is_no_formula(self):
        for formula, column in (("x^2+", 5), ("(x+y", 5), ("x+y)", 4), ("", 1), ("1/0", 2), ("log(-1)", 1), ("2 3", 3),
                                ("foo(x)", 1), ("x;y", 2), ("x=y=z", 4), ("x^2+y^2+(z", 11)):
            with self.subTest(formula):
                says = f"surface.formula: column {column}: "
                self.refused({"formula": formula}, says)
                self.assert_fails(2, "explain", *setting(formula), says=says)

    def test_what_is_too_long(self):
        self.refused({"formula": "x+" * 5000 + "y"}, "10000 characters")
        self.refused({"formula": "(" * 10_000 + "x" + ")" * 10_000}, "10000 characters")
        self.assertEqual(self.explained(*setting("x+" * 4999 + "y"))["formula"]["f"], "4999x + y")
        self.assertEqual(self.explained(*setting("(" * 4999 + "x" + ")" * 4999))["formula"]["f"], "x")
        self.explained(*setting("sin(" * 1200 + "x" + ")" * 1200))

    def test_a_formula_in_place_of_a_file(self):
        self.assert_fails(3, "explain", "x^2+y^2-1", says="--set 'surface.formula=x^2+y^2-1'")
        self.assert_fails(3, "explain", "no/such/file", says="slide-scale")

    def test_functions_that_everyone_writes(self):
        explained = self.explained(*setting("z = log10(x^2 + y^2);"), "--set", "surface.clip=box", "--set", "probe=[2,0,0.6]")
        close_to(self, explained["gradient"]["normal"], [-0.39848, 0, 0.91718], 5)
        for formula in ("foo(x)", "ab(x)", "1 + log3(x)", "sin2(x)", "floor2(x)"):
            with self.subTest(formula):
                self.refused({"formula": formula}, ("log10", "heaviside"))

    def test_a_pole_is_no_surface(self):
        scale = ("--set", 'stack=[{"scale":[0.5,2,1]}]')
        plane = self.numbers(*setting("x/(x^2+y^2+z^2-1)"), *scale)
        self.assertAlmostEqual(plane["error_degrees"]["worst"], 0)
        nothing = self.numbers(*setting("1/(x^2+y^2+z^2-1)"), *scale, notes=("No zero",))
        self.assertIsNone(nothing["probe"])

    def test_keys(self):
        self.refused({"formula": "a x", "parameters": {"b": 1}}, ("surface.parameters.b", "it has a"))
        self.refused({"formula": "x", "parameters": {"a": 1}}, ("surface.parameters.a", "no parameters"))
        self.refused({"formula": "a x", "parameters": {"a": "1"}}, "surface.parameters.a")
        self.refused({"formula": "a x", "parameters": {"alpha": 1}}, "surface.parameters.alpha")
        self.refused({"formula": "x", "bound": 0}, "surface.bound")
        self.refused({"formula": "x", "clip": "torus"}, ("surface.clip", "ball", "box"))
        self.refused({"formula": 3}, "surface.formula")
        self.refused({"formula": "x", "shape": "sphere"}, "surface")

    def test_setting(self):
        self.assertEqual(self.explained(*setting("x^2+y^2-z^2"))["formula"]["df/dz"], "-2z")
        torus = self.explained("implicit-torus", "--set", "surface.parameters.b=0.25")
        self.assertEqual(torus["formula"]["parameters"], {"a": 1, "b": 0.25})
        # Another formula keeps the parameters that it has as well.
        self.assertEqual(self.explained("implicit-torus", "--set", "surface.parameters.a=0.5",
                                        *setting("ax + cy"))["formula"]["parameters"], {"a": 0.5, "c": 1})

    def test_what_has_little_to_show(self):
        for formula, says in (("x^2+y^2+z^2+1", "No zero"), ("1/x", "No zero"), ("sqrt(-1-x^2)", "No zero"), ("7", "No zero"),
                              ("x-x", "0 everywhere"), ("(x-0.3)^2", "touches 0"), ("x^1e9", "touches 0"),
                              ("max(0, x^2+y^2+z^2-1)", "0 throughout")):
            with self.subTest(formula):
                explained = self.explained(*setting(formula))
                self.assertIn(says, " ".join(explained["notes"]))
                self.assertIn(says, self.told(formula))
        for formula, says in (("x^2+y^2", ("as at (0, 0, ", "never negative", "line")),
                              ("(x-0.5)^2+y^2+z^2", ("at (0.5, 0, 0)", "never negative", "point")),
                              ("-(x^2+y^2-1)^2-z^2", ("up to 0", "never positive", "line")),
                              ("x^2+y^2+z^2-1e-9", "too small"), ("sqrt(1-x^2-y^2-z^2)", "stops being defined"), ("x^2+y^2+z^2+1e-8", "No zero")):
            with self.subTest(formula):
                for word in (says,) if isinstance(says, str) else says:
                    self.assertIn(word, self.told(formula))
        for formula in ("x^y^z", "tan(20x)", "log(x)", "exp(1e3 x) - 1"):
            self.explained(*setting(formula))
            done = run("capture", *setting(formula), "-o", self.folder / "p.png", "--size", "64x64")
            self.assertEqual(done.returncode, 0)
        self.assertIn("triangles", " ".join(self.explained("implicit-torus", "--set", "stack.0.scale=[1,0,1]")["notes"]))

    def test_the_gradient_at_the_probe(self):
        explained = self.explained("implicit-sphere", "--set", "probe=[0.48,0.6,0.64]")
        gradient = explained["gradient"]
        close_to(self, gradient["gradient"], [0.96, 1.2, 1.28])
        close_to(self, gradient["normal"], [0.48, 0.6, 0.64])
        self.assertAlmostEqual(gradient["length"], 2)
        self.assertLess(gradient["differences"]["degrees_off"], 1e-9)  # exact for a square, but for rounding
        self.assertTrue(0.01 < gradient["polygon"]["degrees_off"] < 5)
        close_to(self, explained["probe"]["gradient"], gradient["gradient"])

    def test_no_normal_where_the_gradient_is_zero(self):
        for scene, point, *settings in (
                ("implicit-cone", (0, 0, 0)), ("implicit-ding-dong", (0, 0, 0)), ("implicit-whitney-umbrella", (0, 1, 0)),
                ("implicit-cayley-cubic", (0.5, 0.5, -0.5)), ("implicit-cayley-cubic", (-0.5, -0.5, -0.5)),
                ("implicit-heart", (math.cos(0.7), 0, 2 / 3 * math.sin(0.7))),
                ("implicit-torus", (0, 0, 0), "--set", "surface.parameters.b=1"),
                ("implicit-hyperboloid-two-sheets", (0, 0, 0), "--set", "surface.parameters.a=0")):
            with self.subTest(scene, point=point):
                explained = self.explained(scene, *settings, "--set", f"probe={list(point)}")
                close_to(self, explained["probe"]["point_object"], list(point), 6)
                self.assertIsNone(explained["gradient"]["normal"])
                self.assertNotIn("borrowed_from", explained["probe"])
                lent = self.explained(scene, *settings, "--set", f"probe={list(point)}", "--set", 'borrow={"azimuth":40}')
                self.assertEqual(len(lent["probe"]["borrowed_from"]), 3)
                self.assertIn("there is no normal", " ".join(explained["notes"]))

    def test_every_scene_of_the_gallery(self):
        for line in self.assert_done("scenes").decode().splitlines():
            scene = line.split()[0]
            if not scene.startswith("implicit-"):
                continue
            with self.subTest(scene):
                explained = self.explained(scene)
                self.assertEqual([note for note in explained["notes"] if "no normal" not in note], [])
                self.assertLess(abs(explained["gradient"]["f"]), 1e-12 * max(1, explained["gradient"]["length"]))


if __name__ == "__main__":
    unittest.main()
