#!/usr/bin/env python3
"""Two lessons as a lecturer gives them: on the whole screen, by the keys of a remote control alone."""

import json
import time
import unittest

from support import WindowTest, until
from x11 import Display

SCREEN = (1280, 960)
POINTER_SHOWN = 4.5  # seconds, and a little more: by then its ring is gone, and the same is the same to the last pixel


def step(height, **keys):
    return {"caption": f"{height} times as high.", "equations": [f"y' = {height} y"],
            "scene": {"surface": {"shape": "sphere", "resolution": 24}, "stack": [{"scale": [1, height, 1]}],
                      "arrows": {"limit": 12}, "show": {"grid": False, "ghost": False}}, **keys}


class LectureTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.display = Display()
        self.addCleanup(self.display.close)
        question = {"ask": "And its normals?", "choices": [{"text": "higher", "because": "No."},
                                                           {"text": "lower", "right": True, "because": "Yes."}]}
        self.lessons = self.folder / "lessons"
        self.lessons.mkdir()
        for name, steps in (("a", [step(1), step(2, question=question), step(3)]), ("b", [step(0.5), step(1.5, question=question)])):
            (self.lessons / f"{name}.json").write_text(json.dumps({"normalscope": 1, "lesson": name, "steps": steps}))

    def test_two_lessons_by_a_remote_control_alone(self):
        window = self.window(self.lessons / "a.json", "--lessons", self.lessons, motion=False)
        window.key("F5")
        until(lambda: window.check() or window.geometry() == SCREEN, "the whole screen")
        window.settle()
        time.sleep(POINTER_SHOWN)

        def press(*keys):
            window.key(*keys)
            return self.display.pixels(int(window.id), *SCREEN)

        def assert_title(name):
            until(lambda: window.check() or window.title().startswith(name), f"{name} in the title")
        again = press("Home")
        first = press("Home")
        self.assertEqual(first, again)
        asked = press("Next")
        self.assertNotEqual(asked, first)
        answered = press("b")
        self.assertNotEqual(answered, asked)
        last = press("Next")
        self.assertNotEqual(last, answered)
        self.assertEqual(press("Prior"), answered)
        self.assertEqual(press("space"), last)
        self.assertEqual(press("Prior", "Prior"), first)
        self.assertEqual(press("Return", "Return"), last)  # what has been answered is not asked again
        self.assertEqual({byte for row in press("period") for byte in row[0::4] + row[1::4] + row[2::4]}, {0})
        self.assertEqual(press("Next"), last)  # whatever is pressed, people see the picture again

        announced = press("Next")
        self.assertNotEqual(announced, last)
        self.assertEqual(press("Prior"), last)
        press("Next", "Next")
        assert_title("b.json")
        window.settle()
        asked = press("End")
        revealed = press("Next")  # nobody has answered: next shows what is right, and only then goes on
        self.assertNotEqual(revealed, asked)
        self.assertEqual(press("Next"), revealed)  # there is no other lesson
        self.assertEqual(press("Home"), revealed)
        press("Prior", "Prior", "Prior")
        assert_title("a.json")
        window.settle()
        self.assertEqual(press("End"), last)
        self.assert_closes(window)
        settings = json.loads((self.folder / "config" / "normalscope" / "settings.json").read_text())
        self.assertEqual({name[-6:]: at for name, at in settings["lessons"].items()}, {"a.json": 2, "b.json": 0})


if __name__ == "__main__":
    unittest.main()
