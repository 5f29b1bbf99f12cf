#!/usr/bin/env python3
"""Every built-in lesson from end to end: each step is drawn, and its caption's numbers are those of the scene."""

import json
import pathlib
import re
import unittest

from support import SMALL, CommandTest

LESSONS = sorted((pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons").glob("*.json"))


def at(numbers, path):
    for key in path.split("."):
        numbers = numbers[int(key)] if isinstance(numbers, list) else numbers[key]
    return numbers


class LessonsTest(CommandTest):
    def test_each_step(self):
        self.assertEqual([int(lesson.name[0]) for lesson in LESSONS], list(range(1, len(LESSONS) + 1)))
        said = ""
        for lesson in LESSONS:
            steps = json.loads(lesson.read_text())["steps"]
            self.assertTrue(5 <= len(steps) <= 12, lesson)
            for i, step in enumerate(steps, 1):
                with self.subTest(lesson=lesson.stem, step=i):
                    out = self.folder / "numbers.json"
                    self.assert_done("capture", f"{lesson.stem}#{i}", "-o", self.folder / "a.png", *SMALL, "--numbers", out)
                    numbers = json.loads(out.read_text())
                    for path, value in step.get("numbers", {}).items():
                        self.assertAlmostEqual(at(numbers, path), value, delta=5e-4, msg=path)
                    # A number with three decimals is a result, and must not be a mere claim.
                    words = step["caption"] + step.get("look_at", "")
                    for number in re.findall(r"\d+\.\d{3}", words):
                        self.assertIn(float(number), step["numbers"].values())
                    said += words
        self.assertIn("61.928°", said)
        self.assertIn("36.870°", said)

    def test_the_list(self):
        text = self.assert_done("lessons").decode()
        self.assertEqual([line.split()[0] for line in text.splitlines()], [lesson.stem for lesson in LESSONS])

    def test_errors(self):
        lesson = {"lesson": "Mine", "steps": [{"caption": "a"}, {"caption": "b", "scene": {"colour": "red"}}]}
        file = self.file("mine.json", json.dumps(lesson, indent=1))
        out = self.folder / "out.png"
        self.assert_fails(3, "capture", file, "-o", out, says=("mine.json, line 10, step 2", "scene.colour: unknown key"))
        self.assert_fails(3, "capture", f"{LESSONS[0].stem}#99", "-o", out, says=("steps 1 to",))
        self.assert_fails(3, "handout", "none", "-o", out, says=(LESSONS[0].stem,))
        self.assert_fails(2, "handout", LESSONS[0].stem, says=("--output",))
        self.assertFalse(out.exists())

    def test_a_lesson_of_ones_own_finds_its_mesh(self):
        (self.folder / "deep").mkdir()
        self.file("deep/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        file = self.file("deep/mine.json", json.dumps(
            {"lesson": "Mine", "steps": [{"caption": "a", "scene": {"surface": {"mesh": "t.obj"}}}]}))
        self.assert_done("capture", file, "-o", self.folder / "a.png", *SMALL)

    def test_the_handout_is_one_page(self):
        lesson = LESSONS[0]
        steps = json.loads(lesson.read_text())["steps"]
        page = self.assert_done("handout", lesson.stem, "-o", "-", "--size", "160x100").decode()
        self.assertEqual(page.count("src=\"data:image/png;base64,"), len(steps))
        self.assertNotRegex(page, r"(src|href)=\"(?!data:)")
        self.assertIn("n</i><sub>naive</sub>", page)
        for step in steps:
            self.assertIn(step["caption"], page)


class LinksTest(CommandTest):
    def test_a_damaged_link(self):
        for link, words in (("normalscope:1.AAAA", "checksum"), ("normalscope:2.AAAA", "newer version"),
                            ("normalscope:", "cut off")):
            self.assert_fails(3, "capture", link, "-o", self.folder / "a.png", says=("link: ", words))


if __name__ == "__main__":
    unittest.main()
