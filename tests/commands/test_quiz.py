#!/usr/bin/env python3
"""Quizzes as Moodle XML, read back: well formed, with their pictures, and the right answers are right."""

import base64
import json
import math
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

from support import SMALL, CommandTest, png_size

LESSONS = sorted((pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons").glob("*.json"))
PLACE = re.compile(r"\{1:NUMERICAL:=(-?[\d.]+):([\d.]+)(?:~%0%(-?[\d.]+):[\d.]+#([^}]*))?\}")


def told_number(text):
    return float(text.replace("−", "-"))


def told_vector(text):
    return [told_number(number) for number in text.split(", ")]


def inverse_transpose(m):
    """The cofactors by the determinant."""
    cofactors = [[m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] - m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3]
                  for j in range(3)] for i in range(3)]
    determinant = sum(m[0][j] * cofactors[0][j] for j in range(3))
    return [[c / determinant for c in row] for row in cofactors]


def unit_image(m, v):
    image = [sum(a * b for a, b in zip(row, v)) for row in m]
    return [x / math.hypot(*image) for x in image]


class QuizTest(CommandTest):
    def quiz(self, *arguments):
        """The questions but for categories, as Python's parser reads them; each has its picture."""
        text = self.assert_done("quiz", *arguments, "-o", "-", *SMALL)
        root = ElementTree.fromstring(text)
        self.assertEqual(root.tag, "quiz")
        questions = [q for q in root if q.get("type") != "category"]
        for question in questions:
            asked = question.find("questiontext")
            file = asked.find("file")
            self.assertIn(f'src="@@PLUGINFILE@@/{file.get("name")}"', asked.findtext("text"))
            self.assertEqual(png_size(base64.b64decode(file.text, validate=True)), (160, 120))
        self.assertEqual(len({q.findtext("name/text") for q in questions}), len(questions))
        return questions

    def test_each_lesson(self):
        asked = [(json.loads(lesson.read_text())["lesson"], step["question"])
                 for lesson in LESSONS for step in json.loads(lesson.read_text())["steps"] if "question" in step]
        questions = self.quiz("all")
        self.assertEqual(len(questions), len(asked))
        for question, (lesson, expected) in zip(questions, asked):
            self.assertEqual(question.get("type"), "multichoice")
            self.assertTrue(question.findtext("name/text").startswith(lesson))
            answers = question.findall("answer")
            self.assertEqual([a.get("fraction") == "100" for a in answers], [c.get("right", False) for c in expected["choices"]])
            self.assertEqual({a.get("fraction") for a in answers}, {"0", "100"})
            for answer, choice in zip(answers, expected["choices"]):
                words = re.sub(r"<[^>]*>", "", answer.findtext("feedback/text"))
                self.assertEqual(words.replace("&gt;", ">").replace("&lt;", "<"),
                                 re.sub(r"\b([nv])_(obj|world|naive)", r"\1\2", choice["because"])
                                 .translate(str.maketrans("₃⁻¹ᵀ²", "3−1T2")))

    def test_exercises_are_right(self):
        for seed in (1, 42):
            questions = self.quiz(f"exercises:{seed}")
            self.assertEqual([q.get("type") for q in questions], ["cloze", "cloze", "cloze", "multichoice"] * 3)
            for question in questions:
                text = question.findtext("questiontext/text")
                self.assertTrue(question.findtext("generalfeedback/text"))
                if question.get("type") == "multichoice":
                    self.assertEqual([a.get("fraction") for a in question.findall("answer")].count("100"), 1)
                    continue
                with self.subTest(question.findtext("name/text")):
                    cells = [told_number(cell) for cell in re.findall(r"<td[^>]*>([^<]*)", text)]
                    m = [cells[:3], cells[3:6], cells[6:]]
                    normal = told_vector(re.search(r"= \(([^)]*)\)\. What is", text)[1])
                    places = PLACE.findall(text)
                    self.assertEqual(len(places), 3)
                    right, naive = unit_image(inverse_transpose(m), normal), unit_image(m, normal)
                    for (answer, tolerance, wrong, because), r, n in zip(places, right, naive):
                        self.assertLess(abs(float(answer) - r), 0.005)
                        self.assertEqual(tolerance, "0.02")
                        self.assertEqual(bool(wrong), abs(float(answer) - n) > 0.04, (answer, n))
                        if wrong:
                            self.assertLess(abs(float(wrong) - n), 0.005)
                            self.assertIn("naive rule", because)

    def test_whatever_somebody_wrote(self):
        evil = "\"'><script>]]>&amp;{1:SHORTANSWER:=x}\ufffe/\u0001"
        lesson = self.file("mine.json", json.dumps({"lesson": evil, "steps": [{"caption": evil, "equations": [evil], "question": {
            "ask": evil, "choices": [{"text": evil, "because": evil}, {"text": "b", "right": True, "because": "n_world"}]}}]}))
        question, = self.quiz(lesson)
        text = question.findtext("questiontext/text")
        self.assertNotIn("<script>", text)
        self.assertIn("&lt;script&gt;]]&gt;&amp;amp;", text)
        self.assertEqual([a.get("fraction") for a in question.findall("answer")], ["0", "100"])
        self.assertIn("<i>n</i><sub>world</sub>", question.findall("answer")[1].findtext("feedback/text"))

    def test_errors(self):
        out = self.folder / "quiz.xml"
        mine = self.file("mine.json", json.dumps({"lesson": "Mine", "steps": [{"caption": "a"}]}))
        self.assert_fails(3, "quiz", mine, "-o", out, says=("mine.json", "asks no question"))
        self.assert_fails(3, "quiz", "none", "-o", out, says=(LESSONS[0].stem, "all", "exercises:SEED"))
        self.assert_fails(3, "handout", "none", "-o", self.folder / "a.html", says=(LESSONS[0].stem, "all"))
        self.assert_fails(3, "quiz", "exercises:x", "-o", out, says="whole number")
        self.assert_fails(2, "quiz", LESSONS[0].stem, says="--output")
        self.assert_fails(2, "quiz", mine, "-o", mine, says=("mine.json",))
        self.assert_fails(2, "quiz", LESSONS[0].stem, "-o", out, "--size", "0x0", says="--size")
        self.assert_fails(3, "quiz", LESSONS[0].stem, "-o", self.folder / "none" / "quiz.xml", *SMALL, says="quiz.xml")
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
