#!/usr/bin/env python3
"""compare: exit code 0 or 1 with one line of result, and the picture of the difference."""

import json
import pathlib
import resource
import struct
import unittest
import zlib

from support import SMALL, CommandTest, chunk, png, png_size, run


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
        # However near the limit, it reads as beyond it.
        self.assertIn("a share of 0.25, 0.249999 allowed", self.compare(actual, expected, "--share", "0.249999")[1])
        three, limit = [0] * 300, str(100 / 300 - 1e-7)
        self.assertIn(f"a share of 0.3333333, {100 / 300 - 1e-7:.9g} allowed",
                      self.compare(grey(*[99] * 100, *three[100:]), grey(*three), "--share", limit)[1])

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

    def test_json(self):
        done = run("compare", self.file("a.png", grey(0, 0, 9, 99)), self.file("b.png", grey(0, 0, 0, 0)), "--json")
        result = json.loads(done.stdout)
        self.assertEqual((done.returncode, result["agree"]), (1, False))
        self.assertEqual(result["size"], {"actual": [4, 1], "expected": [4, 1]})
        self.assertEqual(result["pixels"], {"beyond": 2, "share": 0.5})
        self.assertEqual(result["channels"], {"most": [99, 99, 99, 0], "mean": [27, 27, 27, 0]})
        self.assertEqual(result["worst"], {"at": [3, 0], "by": 99})
        self.assertAlmostEqual(result["perceived"]["most"], 99)
        done = run("compare", self.file("a.png", grey(0)), self.file("b.png", grey(0, 0)), "--json")
        self.assertEqual((done.returncode, json.loads(done.stdout)["pixels"]), (1, None))

    def test_what_smooths_an_edge_is_forgiven(self):
        def edge(between):  # a slanted edge from black to white, its smoothed pixels `between`
            return png(40, 40, [sum(([v] * 3 for v in [0] * (10 + y // 2) + [between] + [255] * (29 - y // 2)), []) for y in range(40)])
        self.assertFalse(self.agree(edge(90), edge(170)))
        self.assertTrue(self.agree(edge(90), edge(170), "--perceptual", "--share", "0"))
        # But not what is another shape, or another colour of a plain area; and a hue counts as it is seen.
        self.assertFalse(self.agree(png(40, 40, [[0] * 60 + [255] * 60] * 40), png(40, 40, [[0] * 66 + [255] * 54] * 40), "--perceptual"))
        self.assertFalse(self.agree(grey(*[9] * 9), grey(*[19] * 9), "--perceptual"))
        self.assertTrue(self.agree(png(9, 1, [[0, 0, 12] * 9]), png(9, 1, [[0, 0, 0] * 9]), "--perceptual", "--tolerance", "6"))
        # Transparent black against transparent white, and half-transparent white on what is not white.
        self.assertTrue(self.agree(png(1, 1, [[0, 0, 0, 0]], kind=6), png(1, 1, [[255] * 3 + [0]], kind=6), "--perceptual"))
        self.assertFalse(self.agree(png(1, 1, [[255] * 3 + [99]], kind=6), png(1, 1, [[255] * 4], kind=6), "--perceptual"))

    def test_capture_and_compare_in_one_step(self):
        out, reference = self.folder / "out.png", self.file("reference.png", self.capture("split"))
        step = ("capture", "-o", out, *SMALL, "--expect", reference)
        self.assertRegex(self.assert_done(*step, "split").decode(), r"\Aagree: .*out.png: 160x120, every pixel is the same\n\Z")
        self.assertEqual(sorted(self.folder.glob("out.*")), [out])
        done = run(*step, "split", "--set", "theme=dark")
        self.assertEqual((done.returncode, done.stderr), (1, b""))
        self.assertRegex(done.stdout.decode(), r"\Adiffer: .*pixels[^\n]*\n\Z")
        self.assertEqual((self.folder / "out.expected.png").read_bytes(), reference.read_bytes())
        self.assertEqual(png_size((self.folder / "out.difference.png").read_bytes()), (3 * 160 + 16, 120))
        self.assert_done(*step, "split", "--set", "theme=dark", "--tolerance", "255")
        self.assertEqual(sorted(self.folder.glob("out.*")), [out])  # nothing tells any longer of a failure
        self.assertEqual(run(*step[:2], "/dev/null", *step[3:], "shear").returncode, 1)
        self.assertEqual(list(pathlib.Path("/dev").glob("null.*")), [])
        self.assert_fails(3, *step[:-1], self.folder / "none.png", says=("none.png", f"look at {out} and copy it there"))
        self.assert_fails(2, *step[:2], "-", *step[3:], says="--expect")
        self.assert_fails(2, *step[:-2], "--tolerance", "3", says="--expect")

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
                decode = () if name == "hollow" else ("--diff", self.folder / "d.png")  # or sizes that differ would do
                other = self.file("other.png", cases["hollow"] + b"\0") if name == "hollow" else good
                self.assert_fails(3, "compare", bad, other, *decode, says=bad)
                self.assert_fails(3, "compare", other, bad, *decode, says=other if name == "hollow" else bad)
        self.assert_fails(3, "compare", good, self.folder / "none.png", says=("none.png", "No such file"))
        self.assert_fails(3, "compare", self.folder, good, says=(self.folder, "folder"))

    def test_no_pixel_is_decoded_for_what_the_files_say(self):
        whole = png(64, 64, [bytes(range(192))] * 64)
        damaged = whole[:60] + bytes([whole[60] ^ 255]) + whole[61:]
        self.assertEqual(self.compare(damaged, damaged), (True, "agree: 64x64, every pixel is the same\n"))
        self.assertEqual(self.compare(damaged, grey(1, 2)), (False, "differ: the size is 64x64, expected 2x1\n"))
        self.assert_fails(3, "compare", self.file("a.png", damaged), self.file("b.png", whole), says=("a.png", "damaged"))
        # Whatever else is the same is no picture.
        for content in (b"", b"hello", whole[:20], png(0, 0, [])):
            same = self.file("a.png", content)
            self.assert_fails(3, "compare", same, same, says="a.png")

    def test_a_picture_of_100_million_pixels(self):
        rows = zlib.compress((b"\0" + b"\7" * 3 * 12500) * 8000, 1)
        head = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 12500, 8000, 8, 2, 0, 0, 0))
        large = self.file("large.png", head + chunk(b"IDAT", rows) + chunk(b"IEND", b""))
        other = self.file("other.png", head + chunk(b"tEXt", b"a\0b") + chunk(b"IDAT", rows) + chunk(b"IEND", b""))

        def half_a_gibibyte():  # by rows: a whole one of them is 400 MB
            resource.setrlimit(resource.RLIMIT_AS, (1 << 29, 1 << 29))
        done = run("compare", large, other, preexec_fn=half_a_gibibyte)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"agree: 12500x8000, every pixel is the same\n", b""))
        row = b"\0" + b"\7" * 3 * 12500
        changed = zlib.compress(row * 7001 + row[:16] + b"\x2f" + row[17:] + row * 998, 1)
        differs = self.file("differs.png", head + chunk(b"IDAT", changed) + chunk(b"IEND", b""))
        done = run("compare", large, differs, "--share", "0", preexec_fn=half_a_gibibyte)
        self.assertEqual((done.returncode, done.stderr), (1, b""))
        self.assertIn(b"differ: 1 of 12500x8000 pixels", done.stdout)
        self.assertIn(b"most 40 at 5,7001; most by channel 40 0 0 0", done.stdout)
        damaged = self.file("damaged.png", head + chunk(b"IDAT", changed[:len(changed) // 2]) + chunk(b"IEND", b""))
        self.assert_fails(3, "compare", large, damaged, says=("damaged.png", "damaged"))
        self.assert_fails(3, "compare", large, other, "--perceptual", says=("--perceptual", "12500x8000"))
        self.assert_fails(3, "compare", large, other, "--diff", self.folder / "d.png", says=("--diff", "12500x8000"))

    def test_a_difference_that_cannot_be_written(self):
        good = self.file("good.png", grey(1))
        self.assert_fails(3, "compare", good, good, "--diff", "/dev/full", says=("/dev/full", "No space left"))
        self.assert_fails(3, "compare", good, good, "--diff", self.folder / "none" / "d.png", says="none")


if __name__ == "__main__":
    unittest.main()
