#!/usr/bin/env python3
"""Typing a formula: the picture follows what can be read, and what is typed in one go is one step to undo."""

import time
import unittest

from support import LIGHT, WindowTest

SMALL = ("--set", "arrows.limit=12", "--set", "view=single", "--set", "show.grid=false")


class FormulaTest(WindowTest):
    def type_formula(self, window, text):
        window.key("ctrl+f")
        window.key("ctrl+a")
        window.type(text)

    def test_a_formula_is_typed(self):
        window = self.window("implicit-sphere", *SMALL)
        before = window.scene()
        self.type_formula(window, "x^2+y^2+2z^2-a")
        window.key("Return")
        after = window.scene()
        self.assertEqual(after["surface"], {"formula": "x^2+y^2+2z^2-a", "parameters": {"a": 1}, "bound": 1.2, "clip": "ball"})
        self.assert_undo(window, before, after)

    def test_the_last_good_formula_stays(self):
        window = self.window("implicit-sphere", *SMALL)
        before = window.scene()
        picture = window.picture()
        self.type_formula(window, "x^")
        window.key("Return")
        # "x" can be read, and what follows it cannot.
        self.assertEqual(window.scene()["surface"]["formula"], "x")
        self.assertNotEqual(window.picture(), picture)
        window.key("ctrl+z")
        self.assertEqual(window.scene(), before)
        self.assertEqual(window.picture(), picture)

    def test_a_pause_makes_a_step(self):
        window = self.window("implicit-sphere", *SMALL)
        before = window.scene()
        self.type_formula(window, "x+y")
        time.sleep(1.5)
        window.settle()
        window.type("+z")
        window.key("Return")
        self.assertEqual(window.scene()["surface"]["formula"], "x+y+z")
        window.key("ctrl+z")
        self.assertEqual(window.scene()["surface"]["formula"], "x+y")
        window.key("ctrl+z")
        self.assertEqual(window.scene(), before)

    def test_a_shape_gives_way_to_a_formula(self):
        window = self.window(*LIGHT)
        before = window.scene()
        self.type_formula(window, "y - x z")
        window.key("Return")
        after = window.scene()
        self.assertEqual(after["surface"]["formula"], "y - x z")
        self.assertEqual({**after, "surface": None}, {**before, "surface": None})


if __name__ == "__main__":
    unittest.main()
