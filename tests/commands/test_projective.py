#!/usr/bin/env python3
"""Matrices that are not affine: every number is held against the image of the tangent plane."""

import json
import math
import unittest

from support import CommandTest

BENT = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0.3, 1]]
NOTE = "drawn as triangles"
RULES = ("naive", "inverse-transpose", "cofactor")


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class ProjectiveTest(CommandTest):
    def bent(self, **keys):
        return self.scene(surface={"formula": "x^2+y^2+z^2-1"}, stack=[{"matrix": BENT}], probe=[0.5, 0.5, 0.7], **keys)

    def test_numbers(self):
        n = self.numbers(self.bent(), notes=[NOTE])
        self.assertEqual(len(n["surface"]["notes"]), 1)
        self.assertIs(n["affine"], False)
        probe = n["probe"]
        for value, right in zip(unit(probe["true_normal"]), (0.40868, 0.40878, 0.81601)):
            self.assertAlmostEqual(value, right, delta=2e-4)
        self.assertAlmostEqual(n["error_degrees"]["worst"], math.degrees(math.asin(0.3)), delta=0.01)
        self.assertIsNone(n["error_degrees"]["bound"])
        for rule in RULES:
            off = math.degrees(math.acos(dot(unit(probe["n_world"][rule]), unit(probe["true_normal"]))))
            self.assertAlmostEqual(off, 9.98, delta=5e-3)
            self.assertGreater(n["worst_dot"][rule], 0.15)
        # The tangents are sent through the Jacobian: perpendicular to the true normal, and not to what M3 makes of it.
        for tangent in probe["tangents_world"]:
            self.assertAlmostEqual(dot(tangent, unit(probe["true_normal"])), 0, delta=1e-12)
        found = sorted(abs(d) for d in probe["dots"]["naive"])
        self.assertEqual([round(d, 3) for d in found], [0.084, 0.119])

    def test_an_affine_map_says_so(self):
        n = self.numbers("slide-scale")
        self.assertIs(n["affine"], True)
        self.assertNotIn("true_normal", n["probe"])
        self.assertAlmostEqual(n["error_degrees"]["bound"], 61.928, delta=1e-3)

    def test_a_common_factor_changes_nothing(self):
        plain, scaled = ([[f * v for v in row] for row in ([0.5, 0, 0, 1], [0, 2, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1])]
                         for f in (1, 4))
        numbers = [self.numbers(self.scene(stack=[{"matrix": m}])) for m in (plain, scaled)]
        self.assertEqual(numbers[0], numbers[1])

    def test_explain(self):
        scene = self.bent()
        text = self.assert_done("explain", scene).decode()
        self.assertIn("M is not affine", text)
        self.assertIn("here the argument stops", " ".join(text.split()))
        self.assertNotIn("is off by as much as", text)
        data = json.loads(self.assert_done("explain", scene, "--format", "json"))
        states = {step["id"]: step["state"] for step in data["derivation"]}
        self.assertEqual([states[i] for i in ("given", "wanted", "tangent", "rule")], ["holds", "holds", "fails", "fails"])
        for rule in RULES:
            self.assertAlmostEqual(data["check"][rule]["degrees_off"], 9.98, delta=5e-3)
        self.assertIsNone(data["n_world_by"])
        self.assertIsNone(data["claims"]["worst_degrees"])
        self.assertIsNone(data["decomposition"]["worst"])
        latex = self.assert_done("explain", scene, "--format", "latex").decode()
        self.assertIn("not affine", latex)

    def test_pictures_of_everything(self):
        for keys in ({}, {"color": "error"}, {"color": "normals"}, {"view": "split"}, {"slice": {"axis": "z", "at": 0}},
                     {"view": "single", "show": {"stretch_axes": True}}):
            with self.subTest(keys):
                self.capture(self.bent(**keys), notes=[NOTE])
        self.assert_done("capture", self.bent(), "-o", self.folder / "bent.svg", notes=[NOTE])
        # Half of it beyond infinity; without an inverse; nowhere at all.
        nowhere = ["No point of the surface has an image under M"]
        for row, notes in (([0, 0, 2, 1], []), ([0, 0, 1, 0], []), ([0, 0, 0, 0], nowhere)):
            with self.subTest(row):
                n = self.numbers(self.scene(stack=[{"matrix": BENT[:3] + [row]}]), notes=notes)
                self.assertIsNone(n["error_degrees"]["bound"])
                self.assertNotIn("NaN", json.dumps(n))


if __name__ == "__main__":
    unittest.main()
