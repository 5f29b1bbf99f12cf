#!/usr/bin/env python3
"""No run writes over what it reads, nor twice over one file, whatever the file is called: else a picture would be judged
by itself. It is refused before anything is drawn or written."""

import json
import os
import pathlib
import shutil
import subprocess
import unittest

from support import SMALL, CommandTest, run

INPUTS = pathlib.Path(__file__).parent / "inputs" / "checks"


class OverwritingTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.reference = self.file("reference.png", self.capture("split"))
        (self.folder / "picture.png").unlink()
        self.scene_file = self.file("scene.json", '{"normalscope": 1}')
        self.mesh = self.file("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

    def content(self):
        """Every file's bytes, and every folder's and link's name."""
        return {p: p.read_bytes() if p.is_file() else None for p in self.folder.rglob("*")}

    def assert_refused(self, code, *command, says=()):
        before = self.content()
        self.assert_fails(code, *command, says=says)
        self.assertEqual(self.content(), before, command)

    def names(self):
        """Names by which the reference goes."""
        (self.folder / "there").mkdir()
        (self.folder / "there/deep").mkdir()
        link, chain, hard, folder = (self.folder / name for name in ("link.png", "chain.png", "hard.png", "here"))
        link.symlink_to("reference.png")
        chain.symlink_to(link)
        os.link(self.reference, hard)
        folder.symlink_to(self.folder / "there/deep")  # so that here/../.. is not what it looks like
        return (self.reference, link, chain, hard, self.folder / "there/../reference.png", folder / "../../reference.png",
                f"{self.folder}/./reference.png", os.path.relpath(self.reference))

    def test_a_reference_is_not_written_over(self):
        for name in self.names():
            for expect, output in ((self.reference, name), (name, self.reference)):
                self.assert_refused(2, "capture", "shear", *SMALL, "-o", output, "--expect", expect,
                                    says=("--output", "--expect", "same file"))
            self.assert_refused(2, "capture", "shear", *SMALL, "-o", self.folder / "o.png", "--expect", self.reference,
                                "--numbers", name, says="--numbers")
            self.assert_refused(2, "compare", self.reference, self.scene_file, "--diff", name, says=("--diff", "ACTUAL"))
            self.assert_refused(2, "compare", self.scene_file, self.reference, "--diff", name, says=("--diff", "EXPECTED"))

    def test_a_reference_that_is_not_there_yet(self):
        new, dangling = self.folder / "new.png", self.folder / "dangling.png"
        dangling.symlink_to("new.png")
        for output in (new, dangling, self.folder / "none/../new.png"):
            self.assert_refused(2, "capture", *SMALL, "-o", output, "--expect", new, says="same file")

    def test_what_a_failure_leaves_is_an_output_too(self):
        for name in ("o.expected.png", "o.difference.png"):
            self.assert_refused(2, "capture", *SMALL, "-o", self.folder / "o.png", "--expect", self.reference,
                                "--numbers", self.folder / name, says=(name, "--numbers"))
        shutil.copy(self.reference, self.folder / "o.difference.png")
        self.assert_refused(2, "capture", *SMALL, "-o", self.folder / "o.png", "--expect", self.folder / "o.difference.png")
        # OUT.expected.png may be the reference itself: then there is no need for a copy.
        kept = shutil.copy(self.reference, self.folder / "o.expected.png")
        done = run("capture", "shear", *SMALL, "-o", self.folder / "o.png", "--expect", kept)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(pathlib.Path(kept).read_bytes(), self.reference.read_bytes())

    def test_scenes_and_meshes_are_not_written_over(self):
        lesson = self.file("lesson.json", json.dumps({"normalscope": 1, "lesson": "t", "about": "a", "steps": [
            {"scene": {"surface": {"mesh": "mesh.obj"}}, "caption": "c"}]}))
        scene = self.file("with.json", '{"normalscope": 1, "surface": {"mesh": "mesh.obj"}}')
        for arguments, files in ((("capture", self.scene_file), (self.scene_file,)), (("capture", self.mesh), (self.mesh,)),
                                 (("capture", scene), (self.mesh,)), (("capture", f"{lesson}#1"), (lesson, self.mesh)),
                                 (("capture", "--set", f"surface.mesh={self.mesh}"), (self.mesh,)),
                                 (("handout", lesson), (lesson, self.mesh))):
            for file in files:
                self.assert_refused(2, *arguments, "-o", file, says=file)
                (self.folder / "alias").unlink(missing_ok=True)
                (self.folder / "alias").symlink_to(file)  # whose name says nothing of what it holds
                self.assert_refused(2, *arguments, "-o", self.folder / "alias", says=(file, "same file"))
        (self.folder / "f-3.png").symlink_to("scene.json")
        (self.folder / "g-3.png").symlink_to("lesson.json")
        sweep = ("sweep", self.scene_file, "--vary", "camera.azimuth=0:90:5", *SMALL)
        self.assert_refused(2, *sweep, "-o", self.folder / "f-%d.png", says=(self.scene_file, "f-3.png"))
        self.assert_refused(2, *sweep, "-o", f"{self.folder}/v-%d.png", "--numbers", self.scene_file, says=self.scene_file)
        self.assert_refused(2, "animate", lesson, "-o", self.folder / "g-%d.png", *SMALL, says=(lesson, "g-3.png"))

    def test_no_two_outputs_are_one(self):
        out = self.folder / "f-1.png"
        self.assert_refused(2, "capture", *SMALL, "-o", out, "--numbers", self.folder / "none/../f-1.png", says="--numbers")
        sweep = ("sweep", "--vary", "camera.azimuth=0:90:3", *SMALL, "-o", self.folder / "f-%d.png")
        self.assert_refused(2, *sweep, "--sheet", out, says=("--sheet", "--output"))
        self.assert_refused(2, *sweep, "--numbers", out, says="--numbers")
        self.assert_refused(2, "sweep", "--vary", "camera.azimuth=0:90:12", "--vary", "camera.elevation=0:9:12", *SMALL, "-o",
                            self.folder / "f-%d%d.png", says="f-110.png")
        with open(out, "wb") as file:
            self.assert_fails(2, "capture", *SMALL, "-o", out, "--numbers", "-", stdout=file, says="standard output")
        self.assert_done("capture", *SMALL, "-o", "/dev/null", "--numbers", "/dev/null")

    def checks(self, *checks):
        return self.file("checks.json", json.dumps({"normalscope_check": 1, "size": "64x64", "checks": checks}))

    def test_manifests_whose_checks_meet_in_one_file(self):
        for name, both in (("collide", ("a/b", "a-b")), ("collide-expected", ("x.expected", "x")), ("shared-reference", ("a", "b"))):
            manifest = self.file(f"{name}.json", (INPUTS / f"{name}.json").read_text())
            for more in ((), ("--update",), ("--only", "x"), ("--shard", "1/2")):
                self.assert_refused(3, "check", manifest, "--results", self.folder / "results", *more,
                                    says=(manifest, *(f"check {n})" for n in both)))
        (self.folder / "r").mkdir()
        self.file("r/one.png", self.reference.read_bytes())
        (self.folder / "r/two.png").symlink_to("one.png")
        for other in ("r/one.png", "r/../r/one.png", "r/two.png", "./r/one.png"):
            manifest = self.checks({"name": "a", "scene": "shear", "reference": "r/one.png"},
                                   {"name": "b", "scene": "split", "reference": other})
            self.assert_refused(3, "check", manifest, "--update", says=("check a", "check b"))

    def test_folders_that_take_any_case(self):
        """As those of Windows and macOS do. Names that are not there yet are one as well, in any alphabet."""
        image, folder = self.folder / "image", self.folder / "caseless"
        tools = ("mkntfs", "lowntfs-3g", "fusermount")
        if not all(map(shutil.which, tools)) or not os.access("/dev/fuse", os.W_OK):
            self.skipTest(f"there is no {', '.join(tools)}, or no /dev/fuse")
        image.write_bytes(bytes(16 << 20))
        folder.mkdir()
        subprocess.run(["mkntfs", "-F", "-q", image], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if subprocess.run(["lowntfs-3g", "-o", "ignore_case", image, folder], stderr=subprocess.DEVNULL, check=False).returncode:
            self.skipTest("nothing can be mounted here")
        self.addCleanup(subprocess.run, ["fusermount", "-u", "-z", folder], check=True)
        (folder / "reference.png").write_bytes(self.reference.read_bytes())
        for name in ("REFERENCE.png", "Reference.PNG"):
            self.assert_fails(2, "capture", *SMALL, "-o", folder / name, "--expect", folder / "reference.png", says="same file")
        for one, other in (("new.png", "NEW.png"), ("Ön.png", "öN.png"), ("Ж/a.png", "ж/A.png"), ("A/B/c", "a/b/c")):
            self.assert_fails(2, "capture", *SMALL, "-o", folder / one, "--numbers", folder / other, says="same file")
        for a, b in (("A.png", "a.png"), ("É/x.png", "é/X.png")):
            manifest = folder / "checks.json"
            manifest.write_text(json.dumps({"normalscope_check": 1, "size": "64x64", "checks": [
                {"name": "one", "scene": "shear", "reference": a}, {"name": "two", "scene": "split", "reference": b}]}))
            self.assert_fails(3, "check", manifest, "--update", says=("check one", "check two"))
        # Elsewhere they are two.
        self.assert_done("capture", *SMALL, "-o", self.folder / "new.png", "--numbers", self.folder / "NEW.png")

    def test_results_do_not_go_over_references_nor_anything_that_is_read(self):
        mesh = self.file("wing.png.obj", self.mesh.read_text())
        manifest = self.checks({"name": "reference", "scene": "shear", "reference": "reference.png"},
                               {"name": "other", "scene": "split", "reference": "reference.difference.png"},
                               {"name": "wing", "scene": "wing.png.obj", "numbers": {"rank": 3}})
        for more in ((), ("--only", "other"), ("--update",)):
            self.assert_refused(3, "check", manifest, "--results", self.folder, *more, says=("reference.png", "check reference"))
        for option in ("--junit", "--report"):
            for file in (self.reference, mesh, manifest):
                self.assert_refused(2, "check", manifest, option, file, says=(option, file))
            (self.folder / "alias").unlink(missing_ok=True)
            (self.folder / "alias").symlink_to(self.reference)  # whose name says nothing of what it holds
            self.assert_refused(3, "check", manifest, option, self.folder / "alias", says=(option, self.reference, "same file"))
        self.assert_refused(2, "check", manifest, "--junit", self.folder / "x", "--report", f"{self.folder}/./x", says="--report")
        self.assertFalse((self.folder / "results").exists())


if __name__ == "__main__":
    unittest.main()
