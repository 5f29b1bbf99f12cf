#!/usr/bin/env python3
"""What is read on screen and in the docs: words that stand for others of the field, or that no native speaker would say."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# What not to say, and what to say instead.
NOT = {
    r"\bupright\b": "perpendicular to the surface",
    r"\b(go|goes|went) by (M\b|M₃|what\b|the (naive|inverse|cofactor|Jacobian))": "sent through M; follows the … rule",
    r"\b[Ww]hoever\b": "anyone who",
    r"\bor it is none\b": "what is wanted, in a sentence",
    r"\b(turn|turns|turned) (the winding|the order|it) (over|round)\b": "reverses",
    r"\bcarry knobs\b": "ends in a knob",
    r"\bfalls? by the normals\b": "the light depends on the normals",
    r"\b(is|are) (gone|flattened) to a point\b": "shrinks to a point",
    r"\bmay change places\b": "can be swapped",
    r"\bin the other order\b": "in reverse order",
}


def in_source(text):
    """Its string literals, those that follow each other as one."""
    text = re.sub(r"^\s*(//|#include).*$|\s//[^\"]*$", "", text, flags=re.M)
    text = re.sub(r'"\s*\n\s*"', "", text)
    return "\n".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', text))


class WordsTest(unittest.TestCase):
    def read(self):
        for pattern in ("app/**/*.cpp", "app/**/*.h"):
            for path in ROOT.glob(pattern):
                yield path, in_source(path.read_text(encoding="utf-8"))
        for pattern in ("assets/lessons/*.json", "assets/scenes/*.json", "assets/*.html", "app/web/*.html", "docs/*.md", "README.md"):
            for path in ROOT.glob(pattern):
                yield path, path.read_text(encoding="utf-8")

    def test_what_is_said_is_what_one_would_say(self):
        read = 0
        for path, text in self.read():
            read += len(text)
            for wrong, better in NOT.items():
                found = re.search(wrong, text)
                with self.subTest(path=path.name, wrong=wrong):
                    self.assertIsNone(found, f"{path.relative_to(ROOT)}: “{found and found.group()}”: rather “{better}”")
        self.assertGreater(read, 100_000)


if __name__ == "__main__":
    unittest.main()
