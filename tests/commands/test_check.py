#!/usr/bin/env python3
"""check: a manifest of scenes against references and numbers, with its reports; --update; and manifests that are none."""

import base64
import itertools
import json
import os
import pathlib
import re
import resource
import signal
import socket
import subprocess
import unittest
import xml.etree.ElementTree
import zlib

from support import NORMALSCOPE, PROGRESS, CommandTest, png_size, run

INPUTS = pathlib.Path(__file__).parent / "inputs" / "checks"

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
        self.assertEqual(list((self.folder / "results").iterdir()), [])  # what the update took was its own
        (self.folder / "results").rmdir()

        self.manifest({**scene, "set": ["theme=dark"]}, {"name": "numbers", "scene": "slide-scale", "numbers": {"rank": 2}})
        code, lines = self.check("--jobs", "2")
        self.assertEqual(code, 1)
        lines = sorted(lines[:2], key=lambda line: "numbers" in line)  # they come as they are done
        self.assertRegex(lines[0], r"\Afail: split: \d+ of 160x120 pixels")
        self.assertEqual(lines[1], "fail: numbers: rank is 3, expected 2")
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
                      {"scene": "gone.obj", "reference": "gone.png"})
        junit, report = self.folder / "junit.xml", self.folder / "report.html"
        code, lines = self.check("--junit", junit, "--report", report)
        self.assertEqual((code, lines[-1]), (1, "1 of 3 checks pass"))
        suite = xml.etree.ElementTree.parse(junit).getroot()[0]
        self.assertEqual([suite.get(key) for key in ("tests", "failures", "errors")], ["3", "1", "1"])
        self.assertEqual([case.get("name") for case in suite], ["split", "a </script> & b", "gone"])
        self.assertEqual([[child.tag for child in case] for case in suite], [[], ["failure", "system-out"], ["error"]])
        self.assertEqual((suite.get("skipped"), suite.get("hostname")), ("0", socket.gethostname()))
        self.assertRegex(suite.get("timestamp"), r"\A\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\Z")
        for case, line in ((suite[1], lines[1]), (suite[2], lines[2])):
            self.assertTrue(line.endswith(case[0].text))
            self.assertEqual(case[0].get("message"), case[0].text)
        self.assertEqual((suite[1][0].get("type"), suite[2][0].get("type")), ("PictureDiffers", "Error"))
        attached = re.findall(r"\[\[ATTACHMENT\|(.*)\]\]", suite[1][1].text)
        self.assertEqual([os.path.abspath(a) for a in attached],
                         [str(self.folder / "results" / f"a <-script> & b{kind}.png") for kind in (".difference", ".expected", "")])
        self.assertFalse(any(os.path.isabs(a) for a in attached if not a.startswith("..")))
        html = report.read_text()
        self.assertEqual(html.count("</script>"), 2)
        self.assertNotRegex(html, r"(src|href)=\"?http")
        data = json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', html, re.S)[1])
        self.assertEqual([c["state"] for c in data["checks"]], ["pass", "fail", "error"])
        self.assertEqual(sorted(data["checks"][1]["pictures"]), ["actual", "difference", "expected"])
        self.assertEqual(list(data["checks"][0]["pictures"]), ["actual"])
        self.manifest({"scene": "split", "size": "1280x720", "numbers": {"rank": 3}})
        self.check("--report", report)
        data = json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', report.read_text(), re.S)[1])
        self.assertEqual(png_size(base64.b64decode(data["checks"][0]["pictures"]["actual"])), (320, 180))

    def test_reports_hold_any_name(self):
        names = ["a\uffff", "\ufffe]]><&\"'", "b\u0001\u001b[31m", "c\nfail: forged: line", "d\u0085\u009b\u2028", "\U0001f600 é", "e\t"]
        self.manifest(*({"name": name, "scene": "shear", "reference": "none.png" if i == 0 else f"none{i}.png"} for i, name in enumerate(names)))
        junit, report = self.folder / "junit.xml", self.folder / "report.html"
        code, lines = self.check("--junit", junit, "--report", report)
        self.assertEqual((code, len(lines)), (1, len(names) + 1))
        for line in lines:
            self.assertNotRegex(line, "[\x00-\x1f\x7f-\x9f\u2028\u2029]")
        cases = xml.etree.ElementTree.parse(junit).getroot()[0]
        self.assertEqual(cases[5].get("name"), names[5])
        data = json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', report.read_text(), re.S)[1])
        self.assertEqual([c["name"] for c in data["checks"]], names)
        manifest = self.file("checks.json", (INPUTS / "junit-ffff.json").read_text())
        self.assertEqual(run("check", manifest, "--junit", junit, "--results", self.folder / "more").returncode, 1)
        self.assertEqual(xml.etree.ElementTree.parse(junit).getroot()[0][0].get("name"), "a\ufffd")

    def test_what_others_left_stays(self):
        self.file("right.png", self.capture("split"))
        (self.folder / "picture.png").unlink()
        (self.folder / "results").mkdir()
        kept = [self.file(f"results/split{kind}.png", kind) for kind in ("", ".expected", ".difference")]
        self.manifest({"scene": "split", "reference": "right.png"})
        self.assertEqual(self.check()[0], 0)
        self.assertEqual([k.read_text() for k in kept], ["", ".expected", ".difference"])
        for k in kept:
            k.unlink()
        self.assertEqual(self.check()[0], 0)
        self.assertTrue((self.folder / "results").is_dir())  # it was there before
        (self.folder / "results").rmdir()
        self.assertEqual(self.check()[0], 0)
        self.assertFalse((self.folder / "results").exists())

    def test_update_takes_no_older_picture(self):
        results = self.folder / "results"
        results.mkdir()
        self.file("results/split.png", self.capture("shear"))
        self.manifest({"scene": "split", "reference": "references/split.png"})
        os.chmod(results, 0o500)
        self.addCleanup(os.chmod, results, 0o700)
        limited = [] if os.access(results, os.W_OK) else None  # the superuser writes anywhere, but finds a full disk

        def little_space():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
        done = run("check", self.folder / "checks.json", "--results", results, "--update",
                   **({} if limited is None else {"preexec_fn": little_space}))
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"cannot be written", done.stdout)
        self.assertFalse((self.folder / "references/split.png").exists())

    def test_shards_share_the_checks(self):
        names = [f"{kind}{i}" for kind, i in itertools.product("ab", range(4))]
        self.manifest(*({"name": name, "scene": "slide-scale", "size": "16x16", "numbers": {"rank": 3}} for name in names))

        def ran(*arguments):
            code, lines = self.check(*arguments)
            self.assertEqual((code, lines[-1]), (0, f"{len(lines) - 1} of {len(lines) - 1} checks pass"))
            return [line.split(": ")[1] for line in lines[:-1]]
        self.assertEqual(ran("--shard", "2/3"), ["a1", "b0", "b3"])
        self.assertEqual(sorted(sum((ran("--shard", f"{k}/5") for k in range(1, 6)), [])), names)
        self.assertEqual(self.check("--only", "b", "--shard", "5/5")[1], ["nothing was checked: shard 5/5 has none of the 4 checks"])
        self.assertEqual(ran("--shard", "1/2", "--only", "b"), ["b0", "b2"])
        self.assertEqual(ran("--shard", "8/9"), ["b3"])
        code, lines = self.check("--shard", "9/9", "--junit", self.folder / "junit.xml")  # as where a matrix is larger than the list
        self.assertEqual((code, lines), (0, ["nothing was checked: shard 9/9 has none of the 8 checks"]))
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "junit.xml").getroot()[0].get("tests"), "0")
        for wrong in ("0/3", "4/3", "1", "1/", "/2", "-1/2", "1/2/3", "a/b", "1/99999", ""):
            self.assert_fails(2, "check", self.folder / "checks.json", "--shard", wrong, says=("--shard", "2/5"))

    def test_notes(self):
        self.file("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.manifest({"scene": "flat.obj", "numbers": {"rank": 3}}, {"scene": "split", "numbers": {"surface.notes": []}})
        code, lines = self.check()
        self.assertEqual(code, 0)
        self.assertRegex(lines[0], r"\Apass: flat: the numbers are as expected; note: .*flat.obj has no normals")
        code, lines = self.check("--fail-on-note")
        self.assertEqual((code, lines[-1]), (1, "1 of 2 checks pass"))
        self.assertRegex(lines[0], r"\Afail: flat: note: .*flat.obj has no normals")
        self.assertEqual(self.check("--fail-on-note", "--update")[0], 1)

    def test_a_link_as_a_scene(self):
        packed = zlib.compress(b'{"stack": [{"scale": [1, 2, 1]}]}')
        link = "normalscope:1." + base64.urlsafe_b64encode(zlib.crc32(packed).to_bytes(4, "big") + packed).decode().rstrip("=")
        self.manifest({"name": "link", "scene": link, "ground": "white", "scale": 2, "numbers": {"determinant": 2}})
        self.assertEqual(self.check(), (0, ["pass: link: the numbers are as expected", "1 of 1 checks pass"]))

    def test_how_far_a_number_may_be_off(self):
        def agrees(value, **scene):
            self.manifest({"scene": "slide-scale", **scene, "numbers": {"determinant": value}})
            return self.check()[0] == 0
        large = {"set": ["stack.0.scale=[100,100,100]"]}  # determinant 1e6
        for value, agree in ((1e6 + 1e-4, True), (1e6 + 1e-2, False), ({"is": 1e6 + 1e-2, "within": 0.1}, True),
                             ({"is": 1e6 + 1e-4, "within": 0}, False), (None, False), ("1000000", False), (True, False)):
            self.assertEqual(agrees(value, **large), agree, value)
        self.assertEqual([agrees(1 + 5e-10), agrees(1 + 2e-9)], [True, False])
        self.manifest({"scene": "slide-scale", "numbers": {"M.0": {"is": [0.5001, 0, 0, 0], "within": 1e-3}, "M.1": [0, 2, 0, 0]}})
        self.assertEqual(self.check()[0], 0)

    def test_manifests_that_are_none(self):
        good = {"scene": "split", "reference": "r.png"}
        for text, says in (("", "JSON"), ("[]", "object"), ("{}", "normalscope_check"), ("[" * 100_000, "levels deep"),
                           ('{"normalscope_check": 1}', "checks"),
                           ('{"normalscope_check": 1, "checks": [{"scene": "split", "set": [], "scene": "shear"}]}',
                            "checks.0.scene: is there twice")):
            self.assert_fails(3, "check", self.file("m.json", text), says=("m.json", says))
        for bad, says in (({"scene": "split"}, "neither"), ({**good, "size": "9"}, "checks.0.size"), ({**good, "shape": 1}, "shape: unknown key"),
                          ({**good, "tolerance": -1}, "tolerance"), ({**good, "set": "rule=naive"}, "set"), ({**good, "panel": 1}, "panel"),
                          ({**good, "numbers": []}, "numbers"), (3, "checks.0"), ({"reference": "r.png"}, "checks.0: lacks the key scene"),
                          ({**good, "scene": ""}, "checks.0.scene: is empty"), ({**good, "reference": ""}, "checks.0.reference: is empty"),
                          ({**good, "numbers": {"rank": {"within": 1}}}, "checks.0.numbers.rank: lacks the key is"),
                          ({**good, "numbers": {"rank": {"is": 1, "whithin": 1}}}, "whithin: unknown key"),
                          ({**good, "numbers": {"rank": {"is": 1, "within": "1"}}}, "rank.within: expected a number"),
                          ({**good, "numbers": {"rank": {"is": 1, "within": -1}}}, "rank.within: -1"),
                          ({**good, "numbers": {"context": {"is": "egl", "within": 1}}}, "context.within: is for numbers, and \"egl\""),
                          ({**good, "numbers": {"rank": {"is": [], "within": 1}}}, "rank.within: is for numbers"),
                          ({**good, "tolerance": "3"}, "tolerance: expected a number"), ({**good, "share": "0.1"}, "share: expected a number"),
                          ({**good, "samples": "4"}, "samples: expected a number"), ({**good, "scale": "2"}, "scale: expected a number"),
                          ({**good, "size": 160}, "size: expected a string"), ({**good, "ground": True}, "ground: expected a string")):
            self.assert_fails(3, "check", self.manifest(bad), says=("checks.json", says))
        for name, says in (("witin", "checks.0.numbers.rank.witin: unknown key"), ("noscene", "checks.0: lacks the key scene"),
                           ("dupkeys", "checks: is there twice")):
            self.assert_fails(3, "check", self.file(f"{name}.json", (INPUTS / f"{name}.json").read_text()), says=(f"{name}.json", says))
        self.assert_fails(3, "check", self.manifest(good, good), says="another name")
        self.assert_fails(2, "check", self.manifest(good), "--only", "none", says="--only none")
        self.assert_fails(2, "check", says="MANIFEST")


class CutShortTest(CommandTest):
    """A run that does not come to its end says what it knows."""

    def setUp(self):
        super().setUp()
        slow = {"scene": "implicit-torus", "size": "1920x1080", "panel": True, "numbers": {"rank": 2}}
        self.checks = self.file("checks.json", json.dumps({"normalscope_check": 1, "checks": [
            {"name": "first", "scene": "slide-scale", "size": "16x16", "numbers": {"rank": 3}},
            *({"name": f"slow {i}", **slow} for i in range(200))]}))
        self.junit, self.report = self.folder / "junit.xml", self.folder / "report.html"

    def start(self, *arguments, **options):
        process = subprocess.Popen([NORMALSCOPE, "check", self.checks, "--results", self.folder / "results", "--junit", self.junit,
                                    "--report", self.report, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        self.assertEqual(process.stdout.readline(), "pass: first: the numbers are as expected\n")  # while others are drawn
        return process

    def assert_reports(self, lines):
        cases = xml.etree.ElementTree.parse(self.junit).getroot()[0]
        states = [next((child.tag for child in case), "pass") for case in cases]
        self.assertEqual(len(states), 201)
        self.assertEqual(states[0], "pass")
        self.assertEqual(states.count("failure"), sum(line.startswith("fail: ") for line in lines))
        self.assertGreater(states.count("skipped"), 0)
        self.assertEqual(cases.get("skipped"), str(states.count("skipped")))
        self.assertRegex(lines[-1], rf"\A1 of 201 checks pass, {states.count('skipped')} were not run\n\Z")
        self.assertIn('"state":"skipped"', self.report.read_text())

    def test_signals(self):
        for number, jobs in ((signal.SIGINT, "1"), (signal.SIGTERM, "2"), (signal.SIGHUP, "1")):
            process = self.start("--jobs", jobs, "--update")
            process.send_signal(number)
            out, err = process.stdout.readlines(), PROGRESS.sub("", process.stderr.read())
            self.assertEqual(process.wait(), 128 + number)
            self.assertRegex(err, r"\Anormalscope: cancelled after \d+ of 201 checks; the others were not run\n\Z")
            self.assert_reports(out)

    def test_a_worker_that_dies(self):
        for number, jobs in ((signal.SIGKILL, "1"), (signal.SIGSEGV, "2"), (signal.SIGTERM, "2")):
            process = self.start("--jobs", jobs)
            workers = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
            self.assertEqual(len(workers), int(jobs))
            os.kill(int(workers[-1]), number)
            out, err = process.stdout.readlines(), PROGRESS.sub("", process.stderr.read())
            self.assertEqual(process.wait(), 3)
            self.assertRegex(err, r"\Anormalscope: a process that draws [^\n]*before it was done; is there enough memory\?\n\Z")
            self.assert_reports(out)

    def test_what_a_worker_has_finished_is_known(self):
        checks = json.loads(self.checks.read_text())
        large = {"name": "large", "scene": "implicit-torus", "size": "6000x6000", "numbers": {"rank": 2}}
        checks["checks"] = [*({**checks["checks"][0], "name": name} for name in ("first", "second", "third")), large]
        self.checks.write_text(json.dumps(checks))
        process = self.start("--jobs", "1")
        self.assertEqual([process.stdout.readline()[:12] for _ in range(2)], ["pass: second", "pass: third:"])
        worker = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
        os.kill(int(worker), signal.SIGKILL)  # while it draws the large one
        self.assertEqual((process.wait(), process.stdout.read()), (3, "3 of 4 checks pass, 1 was not run\n"))

    def test_nobody_reads_the_results(self):
        process = self.start()
        process.stdout.close()
        err = process.stderr.read()
        self.assertEqual(process.wait(), 3)
        self.assertIn("standard output: cannot be written: Broken pipe", err)
        cases = xml.etree.ElementTree.parse(self.junit).getroot()[0]
        self.assertEqual(len(cases), 201)
        self.assertIn("skipped", [next((child.tag for child in case), "pass") for case in cases])

    def test_one_report_that_cannot_be_written_leaves_the_others(self):
        self.file("checks.json", json.dumps({"normalscope_check": 1, "checks": [{"scene": "split", "size": "64x64", "numbers": {"rank": 2}}]}))
        done = run("check", self.checks, "--results", self.folder / "results", "--junit", self.folder / "none/junit.xml", "--report", self.report)
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"fail: split: rank is 3, expected 2\n0 of 1 checks pass\n", done.stdout)
        self.assertTrue(self.report.exists())
        with open("/dev/full", "wb") as full:
            done = run("check", self.checks, "--results", self.folder / "results", "--junit", self.junit, stdout=full)
        self.assertEqual(done.returncode, 3)
        self.assertEqual([child.tag for child in xml.etree.ElementTree.parse(self.junit).getroot()[0][0]], ["failure", "system-out"])

    def test_runs_beside_each_other_keep_their_evidence(self):
        checks = [self.file(f"{name}.json", json.dumps({"normalscope_check": 1, "size": "64x64", "checks": [
            {"name": f"{name}{i}", "scene": "split", "numbers": {"rank": rank}} for i in range(6)]})) for name, rank in (("a", 2), ("b", 3), ("c", 2))]
        runs = [subprocess.Popen([NORMALSCOPE, "check", c, "--results", self.folder / "results"], stdout=subprocess.PIPE) for c in checks]
        for process in runs:
            out = process.communicate()[0]
            self.assertNotIn(b"cannot", out)
        self.assertEqual([process.returncode for process in runs], [1, 0, 1])
        self.assertEqual(sorted(p.name for p in (self.folder / "results").iterdir()),
                         sorted(f"{name}{i}.png" for name in "ac" for i in range(6)))


if __name__ == "__main__":
    unittest.main()
