#!/usr/bin/env python3
"""Lessons, exercises, presenting and links in the window, by keyboard alone."""

import json
import pathlib
import unittest

from support import LIGHT, SIZE, WindowTest, until

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons"


class LessonsTest(WindowTest):
    def settings(self):
        return json.loads((self.folder / "config" / "normalscope" / "settings.json").read_text())

    def wait_for(self, window, what, condition):
        """Until the scene is so: a step moves for most of a second."""
        until(lambda: condition(window.scene()), what)
        window.settle()

    def test_a_lesson_by_the_keys_of_a_remote_control(self):
        steps = json.loads((LESSONS / "3-when-naive-is-right.json").read_text())["steps"]
        window = self.window("3-when-naive-is-right")
        window.wait_for_title("3-when-naive-is-right")
        stacks = [step["scene"]["stack"] for step in steps[:3]]
        self.wait_for(window, "the first step", lambda scene: scene["stack"] == stacks[0])
        window.key("Next")
        self.wait_for(window, "the second step", lambda scene: scene["stack"] == stacks[1])
        window.key("Right")
        self.wait_for(window, "the third step", lambda scene: scene["stack"] == stacks[2])
        window.key("Prior")
        self.wait_for(window, "the second step again", lambda scene: scene["stack"] == stacks[1])
        # Play, and come back.
        window.key("r")
        self.assertEqual(window.scene()["stack"], [{"scale": [1, 1, 1]}])
        window.key("Home")
        self.wait_for(window, "the step as it was", lambda scene: scene["stack"] == stacks[1])
        window.close()
        self.assertEqual(self.settings()["lessons"], {"3-when-naive-is-right": 1})

    def test_progress_is_kept(self):
        steps = json.loads((LESSONS / "3-when-naive-is-right.json").read_text())["steps"]
        window = self.window("3-when-naive-is-right")
        window.key("Next", "Next", "Next")
        self.wait_for(window, "the fourth step", lambda scene: scene["stack"] == steps[3]["scene"]["stack"])
        window.close()
        again = self.window("3-when-naive-is-right", size=None)
        self.wait_for(again, "the fourth step again", lambda scene: scene["stack"] == steps[3]["scene"]["stack"])

    def test_a_bad_lesson_leaves_the_scene_as_it_was(self):
        (self.folder / "bad.json").write_text('{"lesson": "Bad", "steps": [{"caption": "a", "scene": {"colour": 1}}]}')
        window = self.window(*LIGHT)
        before = window.scene()
        window.open("bad.json")
        self.assertEqual(window.scene(), before)

    def test_presenting(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.key("F5")
        until(lambda: window.geometry() == (1280, 960), "the full screen")
        window.settle()
        window.key("n")  # the same keys as ever
        window.key("b")
        window.key("i")  # whatever it is otherwise, it ends the black screen, and does nothing else
        window.key("ctrl+equal", "ctrl+equal")
        window.key("F5")
        until(lambda: window.geometry() == SIZE, "the window")
        window.settle()
        self.assertEqual(window.scene()["rule"], "naive")
        self.assertEqual(window.scene()["theme"], before["theme"])
        window.close()
        self.assertAlmostEqual(self.settings()["presenter_scale"], 1.21, delta=1e-6)

    def test_a_link_through_the_clipboard(self):
        window = self.window("shear", *LIGHT)
        first = window.scene()
        window.key("ctrl+l")
        window.key("n", "r", "v")
        self.assertNotEqual(window.scene(), first)
        window.key("ctrl+v")
        self.wait_for(window, "the linked scene", lambda scene: scene == first)

    def test_an_exercise(self):
        window = self.window("exercises:42")
        window.wait_for_title("exercises:42")
        before = window.scene()
        self.assertEqual(before["arrows"]["show"], ["object"])
        window.key(*["Left"] * 3, "Up", "Return")
        self.assertEqual(window.scene()["arrows"]["show"], ["object", "naive", "inverse-transpose"])
        window.key("Next")
        self.assertEqual(window.scene()["arrows"]["show"], ["object"])
        self.assertNotEqual(window.scene()["stack"], before["stack"])

    def test_exercises_give_the_scene_back(self):
        window = self.window("exercises:42", *LIGHT)
        window.wait_for_title("exercises:42")
        window.key("Return")  # the arrow has not been moved: asked once, that is no answer
        self.assertEqual(window.scene()["arrows"]["show"], ["object"])
        window.key("Return")
        self.assertEqual(window.scene()["arrows"]["show"], ["object", "naive", "inverse-transpose"])
        window.key("ctrl+z", "Escape")
        window.wait_for_title("Normalscope")
        before = window.scene()
        self.assertEqual(before["arrows"]["limit"], 12)
        self.assertEqual(before["stack"], [{"scale": [0.5, 2, 1]}])
        window.key("n", "ctrl+z")
        self.assertEqual(window.scene(), before)

    def test_a_mesh_opened_in_an_exercise_has_the_earlier_scene(self):
        (self.folder / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        window = self.window("exercises:42", *LIGHT)
        window.wait_for_title("exercises:42")
        window.open("a.obj")
        window.wait_for_title("a.obj")
        scene = window.scene()
        self.assertEqual(scene["arrows"]["limit"], 12)
        self.assertEqual(scene["surface"], {"mesh": "a.obj"})
        window.key("Return", "Return")
        self.assertEqual(window.scene(), scene)
        window.key("ctrl+z")
        self.assertEqual(window.scene()["surface"]["shape"], "sphere")

    def test_after_a_lesson_the_next(self):
        window = self.window("3-when-naive-is-right#7")
        window.wait_for_title("3-when-naive-is-right")
        window.key("Next")
        self.assertTrue(window.title().startswith("3-when-naive-is-right"))
        window.key("Next")
        window.wait_for_title("4-derivation")


if __name__ == "__main__":
    unittest.main()
