#!/usr/bin/env python3
"""--numbers: every key, the values that theory gives, and null for what does not exist."""

import math
import unittest

from support import CommandTest, close_to

RULES = ["naive", "inverse-transpose", "cofactor"]
KEYS = ["program", "renderer", "gl_version", "context", "mistake", "power", "M", "affine", "determinant", "rank", "condition", "normal_matrix", "error_degrees", "worst_dot", "surface", "probe", "pinned", "flat"]
PROBE_KEYS = ["point_object", "point_world", "n_object", "n_world", "tangents_object", "tangents_world", "polygon_object", "polygon_world", "dots", "f", "gradient"]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def times(matrix, vector):
    return [dot(row, vector) for row in matrix]


def worst_error(ratio):
    """In degrees, of the naive rule under a map whose largest stretch is `ratio` times its smallest."""
    return math.degrees(math.atan(ratio) - math.atan(1 / ratio))


def scaled(*factors):
    return "--set", f"stack=[{{\"scale\":{list(factors)}}}]"


class NumbersTest(CommandTest):
    def test_the_keys(self):
        numbers = self.numbers()
        self.assertEqual(list(numbers), KEYS)
        self.assertEqual(list(numbers["normal_matrix"]), RULES)
        self.assertEqual(list(numbers["error_degrees"]), ["worst", "mean", "bound", "at"])
        self.assertEqual(list(numbers["probe"]), PROBE_KEYS)
        self.assertEqual(list(numbers["probe"]["n_world"]), RULES)
        self.assertEqual(list(numbers["probe"]["dots"]), RULES)
        self.assertIn("llvmpipe", numbers["renderer"])
        self.assertRegex(numbers["gl_version"], r"\A\d+\.\d+ .*Mesa")
        self.assertEqual("normalscope " + numbers["program"], self.assert_done("--version").decode().strip())

    def test_the_running_example(self):
        numbers = self.numbers("slide-scale")
        close_to(self, numbers["M"], [[0.5, 0, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        close_to(self, numbers["determinant"], 1)
        self.assertEqual(numbers["rank"], 3)
        close_to(self, numbers["condition"], 4)
        close_to(self, numbers["normal_matrix"]["naive"], [[0.5, 0, 0], [0, 2, 0], [0, 0, 1]])
        close_to(self, numbers["normal_matrix"]["inverse-transpose"], [[2, 0, 0], [0, 0.5, 0], [0, 0, 1]])
        close_to(self, numbers["normal_matrix"]["cofactor"], [[2, 0, 0], [0, 0.5, 0], [0, 0, 1]])
        error = numbers["error_degrees"]
        close_to(self, error["bound"], 61.928, 3)
        self.assertLessEqual(error["worst"], error["bound"] + 1e-9)
        self.assertGreater(error["worst"], error["bound"] - 0.5)
        self.assertTrue(0 < error["mean"] < error["worst"])
        close_to(self, [abs(x) for x in error["at"]], [math.cos(math.radians(d)) for d in (45, 45, 90)], 1)

    def test_pinned_points(self):
        points = [[0.6, 0.8, 0], [1, 0, 0], [0, 1, 0]]
        for surface in ("surface={\"shape\":\"sphere\"}", "surface={\"formula\":\"x^2+y^2+z^2=1\"}"):
            pinned = self.numbers("slide-scale", "--set", surface, "--set", f"pinned={points}")["pinned"]
            for row, point in zip(pinned, points, strict=True):
                close_to(self, row["point_object"], point, 2)
                close_to(self, row["point_world"], [point[0] / 2, 2 * point[1], point[2]], 2)
            close_to(self, [row["error_degrees"] for row in pinned][1:], [0, 0], 1)
            self.assertGreater(pinned[0]["error_degrees"], 55)
        self.assertEqual(self.numbers()["pinned"], [])

    def test_a_polygon(self):
        probe = self.numbers("slide-scale", "--set", "surface={\"shape\":\"cube\"}", "--set", "show.polygon=true", "--set", "probe=[0.3,1,0.2]")["probe"]
        self.assertEqual(len(probe["polygon_object"]), 4)
        for before, after in zip(probe["polygon_object"], probe["polygon_world"], strict=True):
            close_to(self, [abs(x) for x in before], [1, 1, 1])
            close_to(self, after, [before[0] / 2, 2 * before[1], before[2]])
        a, b, c, _ = probe["polygon_object"]
        close_to(self, probe["tangents_object"], [[q - p for p, q in zip(a, b)], [q - p for p, q in zip(b, c)]])
        self.assertIsNone(self.numbers()["probe"]["polygon_object"])

    def test_between_the_two_rules(self):
        for power, bound in (1, 61.928), (0, 36.870), (-1, 0):
            numbers = self.numbers("slide-scale", "--set", f"power={power}")
            self.assertEqual(numbers["power"], power)
            close_to(self, numbers["normal_matrix"]["naive"], [[0.5**power, 0, 0], [0, 2**power, 0], [0, 0, 1]])
            close_to(self, numbers["error_degrees"]["bound"], bound, 3)
            self.assertLessEqual(numbers["error_degrees"]["worst"], bound + 1e-3)
            off = max(abs(d) for d in numbers["probe"]["dots"]["naive"])
            (self.assertLess if power == -1 else self.assertGreater)(off, 1e-9)
        close_to(self, numbers["probe"]["n_world"]["naive"], numbers["probe"]["n_world"]["inverse-transpose"])

    def test_between_the_two_rules_without_an_inverse(self):
        numbers = self.numbers("flattened", "--set", "power=-0.5", "--set", "rule=naive")
        self.assertIsNone(numbers["normal_matrix"]["naive"])
        self.assertIsNone(numbers["probe"]["n_world"]["naive"])
        self.assertIsNotNone(self.numbers("flattened", "--set", "power=0")["probe"]["n_world"]["naive"])

    def test_another_mistake_is_not_bent(self):
        numbers = self.numbers("slide-scale", "--set", "power=-1", "--set", "mistake=not-transposed")
        self.assertEqual(numbers["power"], 1)
        close_to(self, numbers["error_degrees"]["bound"], 61.928, 3)

    def test_the_bound(self):
        close_to(self, self.numbers(*scaled(1, 2, 1))["error_degrees"]["bound"], 36.870, 3)
        for factors in ((1, 3, 1), (0.25, 0.5, 5), (-1, 2, 1), (-2, -2, 0.1)):
            sizes = [abs(f) for f in factors]
            close_to(self, self.numbers(*scaled(*factors))["error_degrees"]["bound"], worst_error(max(sizes) / min(sizes)))

    def test_rigid_and_uniform_maps_have_no_error(self):
        for scene in ("identity", "rotation", "uniform"):
            error = self.numbers(scene)["error_degrees"]
            close_to(self, [error["worst"], error["mean"], error["bound"]], [0, 0, 0], 5)

    def test_the_probe_is_what_theory_says(self):
        for scene in ("slide-scale", "shear", "rotation", "reflection", "split"):
            with self.subTest(scene):
                numbers = self.numbers(scene)
                probe, matrix = numbers["probe"], numbers["M"]
                close_to(self, probe["point_world"], times(matrix, probe["point_object"] + [1])[:3])
                close_to(self, dot(probe["n_object"], probe["n_object"]), 1)
                for at_home, in_world in zip(probe["tangents_object"], probe["tangents_world"]):
                    close_to(self, dot(at_home, probe["n_object"]), 0)
                    close_to(self, in_world, times(matrix, at_home + [0])[:3])
                for rule in RULES:
                    normal = probe["n_world"][rule]
                    close_to(self, normal, times(numbers["normal_matrix"][rule], probe["n_object"]))
                    close_to(self, probe["dots"][rule], [dot(normal, t) for t in probe["tangents_world"]])
                close_to(self, probe["dots"]["inverse-transpose"] + probe["dots"]["cofactor"], [0, 0, 0, 0])

    def test_the_naive_rule_is_wrong_where_the_scale_is_uneven(self):
        dots = self.numbers("slide-scale", "--set", "probe=[0.6,0.8,0]")["probe"]["dots"]
        self.assertGreater(max(map(abs, dots["naive"])), 0.1)

    def test_the_probe_lies_where_it_is_put(self):
        probe = self.numbers("identity", "--set", "probe=[0,5,0]")["probe"]
        close_to(self, probe["point_object"], [0, 1, 0], 2)
        close_to(self, probe["n_object"], [0, 1, 0], 2)

    def test_a_shape_is_no_formula(self):
        probe = self.numbers()["probe"]
        self.assertIsNone(probe["f"])
        self.assertIsNone(probe["gradient"])

    def test_a_reflection(self):
        numbers = self.numbers(*scaled(-1, 1, 1))
        close_to(self, numbers["determinant"], -1)
        normals = numbers["probe"]["n_world"]
        close_to(self, normals["cofactor"], [-x for x in normals["inverse-transpose"]])

    def test_rank_2(self):
        numbers = self.numbers(*scaled(1, 1, 0))
        self.assertEqual((numbers["rank"], numbers["determinant"], numbers["condition"]), (2, 0, None))
        self.assertIsNone(numbers["normal_matrix"]["inverse-transpose"])
        close_to(self, numbers["normal_matrix"]["cofactor"], [[0, 0, 0], [0, 0, 0], [0, 0, 1]])
        self.assertEqual(numbers["error_degrees"], {"worst": None, "mean": None, "bound": None, "at": None})
        self.assertIsNone(numbers["probe"]["n_world"]["inverse-transpose"])
        self.assertIsNone(numbers["probe"]["dots"]["inverse-transpose"])
        close_to(self, numbers["probe"]["dots"]["cofactor"], [0, 0])

    def test_the_worst_dot_of_the_whole_surface(self):
        dots = self.numbers()["worst_dot"]
        self.assertLess(abs(dots["inverse-transpose"]), 1e-12)
        self.assertLess(abs(dots["cofactor"]), 1e-12)
        # sin 61.928°, but for the tangents that are looked at
        self.assertGreater(dots["naive"], 0.7)
        self.assertLess(dots["naive"], 0.8824)
        self.assertIsNone(self.numbers(*scaled(1, 1, 0))["worst_dot"]["inverse-transpose"])
        nothing = self.numbers("slide-scale", "--set", "surface.formula=x^2+y^2+z^2+1", notes=["No zero of f"])
        self.assertEqual(nothing["surface"]["triangles"], 0)
        self.assertEqual(nothing["worst_dot"], {"naive": None, "inverse-transpose": None, "cofactor": None})

    def test_ranks_1_and_0(self):
        for factors, rank in (((1, 0, 0), 1), ((0, 0, 0), 0)):
            numbers = self.numbers(*scaled(*factors))
            self.assertEqual((numbers["rank"], numbers["determinant"], numbers["condition"]), (rank, 0, None))
            close_to(self, numbers["normal_matrix"]["cofactor"], [[0, 0, 0]] * 3)
            self.assertIsNone(numbers["error_degrees"]["bound"])

    def test_extreme_scales(self):
        for factors in ((1e9, 1e-9, 1), (1e-9, 1e-9, 1e-9), (-1e9, 1e9, 1e9)):
            self.numbers(*scaled(*factors))


if __name__ == "__main__":
    unittest.main()
