#!/usr/bin/env python3
"""explain: its three formats. NORMALSCOPE_UPDATE_SNAPSHOTS=1 rewrites the snapshot of the text."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from support import CommandTest

SNAPSHOTS = pathlib.Path(__file__).parent / "snapshots"
FORMATS = ("text", "json", "latex")
SCENES = ("slide-scale", "flattened", "reflection", "rotation", "shear", "identity", "bug-w-one", "implicit-torus",
          "implicit-cone", "implicit-gyroid")


def stack(*entries):
    return "stack=" + json.dumps(entries)


# What lectures leave out, and what nobody would think of.
HARD = {
    "rank 1": stack({"scale": [1, 0, 0]}),
    "rank 0": stack({"scale": [0, 0, 0]}),
    "mirror": stack({"scale": [-1, 2, 1]}),
    "badly scaled": stack({"scale": [1e8, 1, 1e-8]}, {"rotate": {"axis": [1, 2, 3], "degrees": 30}}),
    "tiny": stack(*[{"scale": [1e-9] * 3}] * 5),
    "nearly singular": stack({"matrix": [[1, 1, 0, 0], [1, 1.00000001, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}),
    "not affine": stack({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -0.2, 1]]}),
    "no w at all": stack({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0]]}),
    "a hundred": stack(*[{"rotate": {"axis": [0, 0.6, 0.8], "degrees": 3.6}}] * 100),
    "empty": stack(),
}


class ExplainTest(CommandTest):
    def explain(self, *arguments):
        text = self.assert_done("explain", *arguments).decode()
        self.assertTrue(text.endswith("\n"))
        return text

    def test_text_is_as_in_the_snapshot(self):
        for scene in ("slide-scale", "implicit-torus", "implicit-cone"):
            with self.subTest(scene):
                snapshot = SNAPSHOTS / f"explain-{scene}.txt"
                # Of a surface by formula only what its formula adds: the derivation is the same.
                text = self.explain(scene)
                if scene.startswith("implicit-"):
                    text = text[text.index("── The normal is"):text.index("── Why the inverse")]
                if os.environ.get("NORMALSCOPE_UPDATE_SNAPSHOTS"):
                    snapshot.write_text(text)
                self.assertEqual(text, snapshot.read_text())

    def test_defaults(self):
        self.assertEqual(self.explain(), self.explain("slide-scale", "--format", "text"))
        self.assertEqual(self.explain("--set", "rule=naive"), self.explain())

    def test_text_fits_a_terminal(self):
        for scene in SCENES:
            for line in self.explain(scene).splitlines():
                self.assertLessEqual(len(line), 100, scene)
                self.assertEqual(line, line.rstrip(), scene)

    def test_json_has_the_keys_of_the_numbers(self):
        for scene in SCENES:
            explained = json.loads(self.explain(scene, "--format", "json"))
            numbers = self.numbers(scene)
            self.assertLessEqual(set(numbers), set(explained))
            self.assertIsNone(explained["renderer"])
            self.assertIsNone(explained["context"])
            for key in ("M", "determinant", "rank", "condition", "normal_matrix", "error_degrees"):
                self.assertEqual(explained[key], numbers[key], (scene, key))
            self.assertEqual(set(explained["probe"]), set(numbers["probe"]))

    def test_json_has_every_step(self):
        explained = json.loads(self.explain("--format", "json"))
        steps = explained["derivation"]
        self.assertEqual([step["state"] for step in steps], ["holds"] * 10)
        self.assertEqual(steps[-1]["line"], "n_world = (M₃⁻¹)ᵀ n_obj")
        for step in steps:
            self.assertLessEqual(step["residual"]["largest"], step["residual"]["rounding"])
        self.assertAlmostEqual(explained["claims"]["worst_degrees"], 61.928, 3)
        self.assertEqual([row["class"] for row in explained["classes"] if row["contains_M"]], ["uneven scale"])

    def test_json_stops_where_there_is_no_inverse(self):
        explained = json.loads(self.explain("flattened", "--format", "json"))
        self.assertEqual([step["state"] for step in explained["derivation"]], ["holds"] * 7 + ["fails"] + ["no-value"] * 2)
        self.assertEqual(explained["n_world_by"], "cofactor")
        self.assertIsNone(explained["check"]["inverse-transpose"]["n_world"])

    def test_hard_maps(self):
        for name, setting in HARD.items():
            for form in FORMATS:
                with self.subTest(name, format=form):
                    text = self.explain("--set", setting, "--format", form)
                    self.assertNotRegex(text, r"(?i)(?<![a-z])(nan|inf|infinity)(?![a-z])")
                    if form == "json":
                        json.loads(text)
                    else:
                        self.assertIsNone(re.search(r"(^|[ (\[])-0($|[ )\]])", text, re.M), text)

    def test_a_mesh(self):
        mesh = self.file("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertIn("n_obj", self.explain(mesh, "--set", "stack.0={\"scale\":[1,2,1]}"))

    def test_what_is_wrong(self):
        for form in ("html", "", "TEXT", "text,json"):
            self.assert_fails(2, "explain", "--format", form, says=("--format", "text, json or latex"))
        self.assert_fails(2, "explain", "--format", says="--format")
        self.assert_fails(2, "explain", "--fromat", "json", says="did you mean --format?")
        self.assert_fails(2, "explain", "split", "shear", says="shear")
        self.assert_fails(2, "explain", "--set", "rule", says=("--set", "PATH=VALUE"))
        self.assert_fails(2, "explian", says="did you mean explain?")
        self.assert_fails(2, "explian", "shear", "--format", "json", says=("explian", "did you mean explain?"))
        self.assert_fails(3, "explain", "no-such-scene", says="no-such-scene")
        self.assert_fails(3, "explain", self.folder / "missing.json", says="missing.json")
        self.assert_fails(3, "explain", self.file("broken.json", "{"), says="broken.json")
        self.assert_fails(2, "explain", "--set", "rule=sideways", says=("rule", "cofactor"))

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no full device to write to")
    def test_a_result_that_cannot_be_printed(self):
        with open("/dev/full", "wb") as full:
            self.assert_fails(3, "explain", stdout=full)

    def test_a_fragment_is_for_a_document_of_ones_own(self):
        text = self.explain("shear", "--format", "latex", "--fragment")
        self.assertIn("\\begin{align*}", text)
        self.assertNotIn("documentclass", text)
        self.assert_fails(2, "explain", "--fragment", says=("--format latex",))

    @unittest.skipUnless(shutil.which("pdflatex"), "pdflatex is not installed")
    def test_latex_compiles(self):
        cases = {scene: (scene,) for scene in SCENES} | {name: ("--set", setting) for name, setting in HARD.items()}
        cases["odd words"] = ("--set", "about=50% of {a_b} & #1^2~\\ é 日 (M⁻¹)ᵀ \"q\" <|>")
        for name, arguments in cases.items():
            with self.subTest(name):
                (self.folder / "out.tex").write_text(self.explain(*arguments, "--format", "latex"))
                done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "out.tex"], cwd=self.folder,
                                      stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, timeout=120, check=False)
                self.assertEqual(done.returncode, 0, done.stdout.decode(errors="replace")[-2000:])
                self.assertTrue((self.folder / "out.pdf").stat().st_size > 0)


if __name__ == "__main__":
    unittest.main()
