#!/usr/bin/env python3
"""check: a manifest of scenes against references and numbers, with its reports; --update; and manifests that are none."""

import base64
import json
import re
import unittest
import xml.etree.ElementTree
import zlib

from support import CommandTest, png_size, run

BOUND = {"error_degrees.bound": {"is": 61.928, "within": 1e-3}}


class CheckTest(CommandTest):
    def manifest(self, *checks, **usual):
        return self.file("checks.json", json.dumps({"normalscope_check": 1, "size": "160x120", **usual, "checks": checks}))

    def check(self, *arguments):
        done = run("check", self.folder / "checks.json", "--results", self.folder / "results", *arguments)
        self.assertEqual(done.stderr, b"")
        return done.returncode, done.stdout.decode().splitlines()

    def test_from_no_reference_to_a_failure(self):
        scene = {"scene": "split", "reference": "references/split.png"}
        self.manifest(scene, {"name": "numbers", "scene": "slide-scale", "numbers": {**BOUND, "rank": 3}})
        code, lines = self.check()
        self.assertEqual(code, 1)
        self.assertIn("fail: split: there is no reference", lines[0])
        self.assertEqual(lines[1:], ["pass: numbers: the numbers are as expected", "1 of 2 checks pass"])
        code, lines = self.check("--update")
        self.assertEqual((code, lines[-1]), (0, f"updated: {self.folder}/references/split.png"))
        self.assertEqual((self.folder / "references/split.png").read_bytes(), self.capture("split"))
        self.assertEqual(self.check()[0], 0)
        self.assertFalse((self.folder / "results").exists())

        self.manifest({**scene, "set": ["theme=dark"]}, {"name": "numbers", "scene": "slide-scale", "numbers": {"rank": 2}})
        code, lines = self.check("--jobs", "2")
        self.assertEqual(code, 1)
        self.assertRegex(lines[0], r"\Afail: split: \d+ of 160x120 pixels")
        self.assertEqual(lines[1], "fail: numbers: rank is 3, expected 2 within 1e-09")
        self.assertEqual(sorted(p.name for p in (self.folder / "results").iterdir()),
                         ["numbers.png", "split.difference.png", "split.expected.png", "split.png"])
        self.assertEqual(png_size((self.folder / "results/split.difference.png").read_bytes()), (496, 120))
        # An update accepts pictures, never numbers.
        self.assertEqual(self.check("--update")[0], 1)
        self.assertEqual(self.check("--only", "split")[0], 0)

    def test_reports(self):
        self.file("right.png", self.capture("split"))
        self.file("wrong.png", self.capture("shear"))
        self.manifest({"scene": "split", "reference": "right.png"}, {"name": "a </script> & b", "scene": "split", "reference": "wrong.png"},
                      {"scene": "gone.obj", "reference": "right.png"})
        junit, report = self.folder / "junit.xml", self.folder / "report.html"
        code, lines = self.check("--junit", junit, "--report", report)
        self.assertEqual((code, lines[-1]), (1, "1 of 3 checks pass"))
        suite = xml.etree.ElementTree.parse(junit).getroot()[0]
        self.assertEqual([suite.get(key) for key in ("tests", "failures", "errors")], ["3", "1", "1"])
        self.assertEqual([case.get("name") for case in suite], ["split", "a </script> & b", "gone"])
        self.assertEqual([[child.tag for child in case] for case in suite], [[], ["failure"], ["error"]])
        html = report.read_text()
        self.assertEqual(html.count("</script>"), 2)
        self.assertNotRegex(html, r"(src|href)=\"?http")
        data = json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', html, re.S)[1])
        self.assertEqual([c["state"] for c in data["checks"]], ["pass", "fail", "error"])
        self.assertEqual(sorted(data["checks"][1]["pictures"]), ["actual", "difference", "expected"])

    def test_a_link_as_a_scene(self):
        packed = zlib.compress(b'{"stack": [{"scale": [1, 2, 1]}]}')
        link = "normalscope:1." + base64.urlsafe_b64encode(zlib.crc32(packed).to_bytes(4, "big") + packed).decode().rstrip("=")
        self.manifest({"name": "link", "scene": link, "ground": "white", "scale": 2, "numbers": {"determinant": 2}})
        self.assertEqual(self.check(), (0, ["pass: link: the numbers are as expected", "1 of 1 checks pass"]))

    def test_manifests_that_are_none(self):
        good = {"scene": "split", "reference": "r.png"}
        for text, says in (("", "JSON"), ("[]", "object"), ("{}", "normalscope_check"), ("[" * 100_000, "levels deep"),
                           ('{"normalscope_check": 1}', "checks")):
            self.assert_fails(3, "check", self.file("m.json", text), says=("m.json", says))
        for bad, says in (({"scene": "split"}, "neither"), ({**good, "size": "9"}, "checks.0 size"), ({**good, "shape": 1}, "shape: unknown key"),
                          ({**good, "tolerance": -1}, "tolerance"), ({**good, "set": "rule=naive"}, "set"), ({**good, "panel": 1}, "panel"),
                          ({**good, "numbers": []}, "numbers"), (3, "checks.0")):
            self.assert_fails(3, "check", self.manifest(bad), says=("checks.json", says))
        self.assert_fails(3, "check", self.manifest(good, good), says="another name")
        self.assert_fails(2, "check", self.manifest(good), "--only", "none", says="--only none")
        self.assert_fails(2, "check", says="MANIFEST")


if __name__ == "__main__":
    unittest.main()
