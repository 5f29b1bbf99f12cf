#!/usr/bin/env python3
"""compare: exit code 0 or 1 with one line of result, and the picture of the difference."""

import unittest

from support import CommandTest, chunk, png, png_size, run


def grey(*values):
    return png(len(values), 1, [sum(([v, v, v] for v in values), [])])


class CompareTest(CommandTest):
    def compare(self, actual, expected, *options):
        done = run("compare", self.file("actual.png", actual), self.file("expected.png", expected), *options)
        self.assertEqual(done.stderr, b"")
        line = done.stdout.decode()
        self.assertRegex(line, r"\A(agree|differ): [^\n]+\n\Z")
        self.assertEqual(line.startswith("differ"), done.returncode == 1)
        self.assertIn(done.returncode, (0, 1))
        return done.returncode == 0, line

    def agree(self, *arguments):
        return self.compare(*arguments)[0]

    def test_the_same(self):
        self.assertTrue(self.agree(grey(1, 2, 3), grey(1, 2, 3), "--tolerance", "0", "--share", "0"))

    def test_the_tolerance(self):
        self.assertTrue(self.agree(grey(10, 13, 7), grey(10, 10, 10)))
        self.assertFalse(self.agree(grey(10, 14), grey(10, 10)))
        self.assertTrue(self.agree(grey(10, 14), grey(10, 10), "--tolerance", "4"))
        self.assertTrue(self.agree(grey(0, 255), grey(255, 0), "--tolerance", "255"))

    def test_the_share(self):
        actual, expected = grey(0, 0, 0, 99), grey(0, 0, 0, 0)
        self.assertTrue(self.agree(actual, expected, "--share", "0.25"))
        self.assertFalse(self.agree(actual, expected, "--share", "0.249"))

    def test_what_it_says(self):
        _, line = self.compare(grey(0, 0, 9, 99), grey(0, 0, 0, 0))
        self.assertIn("2 of 4x1 pixels", line)
        self.assertIn("a share of 0.5", line)
        self.assertIn("most 99 at 3,0", line)
        self.assertIn("mean 27.0000", line)

    def test_sizes_that_differ(self):
        agrees, line = self.compare(grey(0, 0), grey(0, 0, 0))
        self.assertFalse(agrees)
        self.assertIn("2x1", line)
        self.assertIn("3x1", line)

    def test_the_picture_of_the_difference(self):
        diff = self.folder / "diff.png"
        self.assertFalse(self.agree(png(40, 30, [[0] * 120] * 30), png(40, 30, [[0] * 117 + [90] * 3] * 30), "--diff", diff))
        self.assertEqual(png_size(diff.read_bytes()), (3 * 40 + 16, 30))
        self.assertTrue(self.agree(grey(5), grey(5), "--diff", diff))
        self.assertEqual(png_size(diff.read_bytes()), (3 * 1 + 16, 1))
        self.assertFalse(self.agree(png(40, 30, [[0] * 120] * 30), grey(0, 0), "--diff", diff))
        self.assertEqual(png_size(diff.read_bytes()), (3 * 40 + 16, 30))

    def test_the_picture_of_the_difference_on_standard_output(self):
        actual, expected = self.file("a.png", grey(1)), self.file("b.png", grey(99))
        done = run("compare", actual, expected, "--diff", "-")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(png_size(done.stdout), (19, 1))
        self.assertTrue(done.stderr.startswith(b"differ: "))

    def test_every_kind_of_png(self):
        palette = chunk(b"PLTE", bytes([255, 0, 0, 9, 9, 9])) + chunk(b"tRNS", bytes([255, 0]))
        for expected, kinds in (
                (grey(0, 255), (png(2, 1, [[0b01000000]], depth=1, kind=0),
                                png(2, 1, [[0, 255]], kind=0),
                                png(2, 1, [[0, 0, 255, 255]], depth=16, kind=0),
                                png(2, 1, [[0, 255, 255, 255]], kind=4),
                                png(2, 1, [[0] * 6 + [255] * 6], depth=16, kind=2),
                                png(2, 1, [[0, 0, 0, 255] + [255] * 4], kind=6))),
                (png(2, 1, [[255, 0, 0, 255, 7, 7, 7, 0]], kind=6), (png(2, 1, [[0, 1]], kind=3, extra=palette),))):
            for kind in kinds:
                self.assertTrue(self.agree(kind, expected, "--tolerance", "0", "--share", "0"))

    def test_alpha_counts(self):
        self.assertFalse(self.agree(png(1, 1, [[9, 9, 9, 200]], kind=6), png(1, 1, [[9, 9, 9, 255]], kind=6)))

    def test_bad_pictures(self):
        good = self.file("good.png", grey(1, 2, 3))
        whole = png(64, 64, [bytes(range(192))] * 64)
        bomb = png(16384, 16384, [b"\0" * 65536] * 20, kind=6)
        cases = {"empty": b"", "text": b"hello", "signature": whole[:8], "header": whole[:20], "half": whole[:len(whole) // 2],
                 "flipped": whole[:60] + bytes([whole[60] ^ 255]) + whole[61:], "nothing": png(0, 0, []),
                 "noise": whole[:8] + bytes(range(256)) * 4, "huge": png(100000, 100000, [b"\0"]), "bomb": bomb,
                 "hollow": png(16384, 8192, [b"\0"], kind=6)}
        for name, content in cases.items():
            with self.subTest(name):
                bad = self.file(f"{name}.png", content)
                self.assert_fails(3, "compare", bad, good, says=bad)
                self.assert_fails(3, "compare", good, bad, says=bad)
        self.assert_fails(3, "compare", good, self.folder / "none.png", says=("none.png", "No such file"))
        self.assert_fails(3, "compare", self.folder, good, says=(self.folder, "folder"))

    def test_a_difference_that_cannot_be_written(self):
        good = self.file("good.png", grey(1))
        self.assert_fails(3, "compare", good, good, "--diff", "/dev/full", says=("/dev/full", "No space left"))
        self.assert_fails(3, "compare", good, good, "--diff", self.folder / "none" / "d.png", says="none")


if __name__ == "__main__":
    unittest.main()
