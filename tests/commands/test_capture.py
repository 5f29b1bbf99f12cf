#!/usr/bin/env python3
"""Pictures: the same bytes every time, --set in all its forms, and every built-in scene."""

import json
import unittest

from support import SMALL, CommandTest, colours, run, words

NAMED_IN_THE_README = {"slide-scale", "split", "identity", "rotation", "uniform", "shear"}


class CaptureTest(CommandTest):
    def scenes(self):
        lines = self.assert_done("scenes").decode().splitlines()
        return {words(line)[0]: " ".join(words(line)[1:]) for line in lines}

    def test_the_scenes_are_listed_with_what_they_show(self):
        scenes = self.scenes()
        self.assertLessEqual(NAMED_IN_THE_README, set(scenes))
        self.assertEqual(list(scenes), sorted(scenes))
        for name, about in scenes.items():
            self.assertGreater(len(about), 10, name)

    def test_each_built_in_scene_can_be_captured(self):
        for name in self.scenes():
            with self.subTest(name):
                self.assertGreater(colours(self.capture(name)), 50)

    def test_the_default_scene(self):
        self.assertEqual(self.capture(), self.capture("slide-scale"))

    def test_the_same_bytes_every_time(self):
        for arguments in (("slide-scale",), ("split", "--panel"), ("error-map", "--samples", "1")):
            with self.subTest(arguments):
                first = self.capture(*arguments)
                for _ in range(3):
                    self.assertEqual(self.capture(*arguments), first)

    def test_the_same_bytes_whatever_the_number_of_threads(self):
        for arguments in (("slide-scale",), ("split", "--panel")):
            with self.subTest(arguments):
                pictures = {self.capture(*arguments, env={"LP_NUM_THREADS": n}) for n in ("0", "1", "2", "8")}
                self.assertEqual(len(pictures), 1)

    def test_the_same_numbers_every_time(self):
        self.assertEqual(self.numbers("split"), self.numbers("split"))

    def test_the_language_does_not_matter(self):
        # Where numbers are written with a comma, ours are not.
        self.assertEqual(self.numbers(env={"LC_ALL": "de_DE.UTF-8"}), self.numbers())

    # ---- --set

    def test_set_is_the_same_as_a_scene_file(self):
        scene = self.scene(surface={"shape": "torus"}, stack=[{"scale": [1, 3, 1]}, {"rotate": {"axis": [0, 0, 1], "degrees": 30}}],
                           rule="naive", camera={"zoom": 0.5}, theme="dark")
        set_so = self.capture(
            "identity", "--set", "surface.shape=torus", "--set", "stack=[]", "--set", 'stack.0={"scale":[1,3,1]}',
            "--set", 'stack.1.rotate={"axis":[0,0,1]}', "--set", "stack.1.rotate.degrees=30", "--set", "rule=naive",
            "--set", 'view="overlay"', "--set", "camera.zoom=5e-1", "--set", "theme=dark")
        self.assertEqual(set_so, self.capture(scene))

    def test_set_before_and_after_the_file(self):
        after = self.capture("split", "--set", "theme=dark")
        self.assertEqual(self.capture("--set", "theme=dark", "split"), after)
        self.assertEqual(self.capture("--set=theme=dark", "split"), after)
        self.assertNotEqual(self.capture("split"), after)

    def test_the_last_set_counts(self):
        self.assertEqual(self.capture("--set", "rule=naive", "--set", "rule=cofactor"), self.capture("--set", "rule=cofactor"))

    def test_set_on_a_mesh(self):
        mesh = self.file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        numbers = self.numbers(mesh, "--set", "stack.0.scale=[1,2,1]", notes=("m.obj has no normals",))
        self.assertEqual(numbers["M"][1], [0, 2, 0, 0])

    def test_notes(self):
        mesh, out = self.file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), self.folder / "out.png"
        numbers = self.numbers(mesh, notes=("m.obj has no normals",))["surface"]
        self.assertEqual((numbers["triangles"], numbers["vertices"]), (1, 3))
        self.assertRegex(numbers["notes"][0], "m.obj has no normals: computed")
        for options, code in (((), 0), (("--fail-on-note",), 1)):
            for command in (("capture", mesh, "-o", out), ("capture", mesh, "-o", out, "--expect", out.with_suffix(".ref")),
                            ("sweep", mesh, "--vary", "camera.azimuth=0:9:2", "-o", self.folder / "f-%d.png")):
                if "--expect" in command:
                    (self.folder / "out.ref").write_bytes(out.read_bytes())
                done = run(*command, *SMALL, *options)
                self.assertEqual((done.returncode, done.stderr.count(b"\n")), (code, 1), command)
                self.assertIn(numbers["notes"][0].encode(), done.stderr)
                self.assertTrue(out.exists())
        self.assertEqual(self.numbers("split")["surface"]["notes"], [])
        self.assert_done("capture", "split", "--fail-on-note", "-o", out, *SMALL)

    def test_set_to_what_a_scene_does_not_allow(self):
        out = self.folder / "out.png"
        for setting, says in (
                ("rule=right", "naive, inverse-transpose, cofactor"),
                ("colour=red", "did you mean color"),
                ("stack.0.scale=[1,2]", "stack.0.scale"),
                ("stack.0.scale.7=1", "stack.0.scale.7"),
                ("stack.9.scale=[1,1,1]", "stack.9"),
                ("stack.x.scale=[1,1,1]", "stack.x"),
                ("stack.0.scale=[1,NaN,1]", "stack.0.scale"),
                ("stack.0.scale=[1,1e999,1]", "stack.0.scale"),
                ("camera.zoom.x=1", "camera.zoom"),
                ("camera..zoom=1", "camera."),
                ("arrows.show=[\"naive\",\"none\"]", "arrows.show.1"),
                ("surface.resolution=2", "surface.resolution"),
                ("normalscope=2", "normalscope"),
                ("rule=" + "x" * 100_000, "rule")):
            with self.subTest(setting[:40]):
                self.assert_fails(2, "capture", "-o", out, "--set", setting, says=("--set", says))
        self.assertFalse(out.exists())

    def test_a_saved_scene_of_every_key(self):
        keys = {"about": "…", "light": {"azimuth": 10, "elevation": 80}, "color": "error", "probe": [0, 1, 0],
                "arrows": {"at": "faces", "every": 3, "length": 0.2, "limit": 50, "show": ["naive", "object"]},
                "show": {"ghost": False, "grid": False, "axes": False, "tangent_plane": False, "probe": False, "legend": False}}
        picture = self.capture(self.scene(**keys))
        settings = sum((["--set", f"{key}={json.dumps(value)}"] for key, value in keys.items()), [])
        self.assertEqual(self.capture("identity", "--set", "stack=[]", *settings), picture)


if __name__ == "__main__":
    unittest.main()
