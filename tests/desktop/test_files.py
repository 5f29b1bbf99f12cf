#!/usr/bin/env python3
"""Opening and saving, by the window's own dialog."""

import json
import pathlib
import shutil
import subprocess
import unittest

from support import LIGHT, MIDDLE, NORMALSCOPE, PANEL, SIZE, WindowTest, png_size, until

TETRAHEDRON = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"
SPOT = pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "meshes" / "spot.obj"


class FilesTest(WindowTest):
    def file(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())

    def test_a_mesh_is_opened_into_the_scene(self):
        self.file("t.obj", TETRAHEDRON)
        window = self.window(*LIGHT)
        before = window.scene()
        window.open("t.obj")
        window.wait_for_title("t.obj")
        after = window.scene()
        self.assertEqual(after["surface"], {"mesh": "t.obj"})
        self.assertEqual([after[key] for key in ("stack", "rule", "view")], [before[key] for key in ("stack", "rule", "view")])
        self.assert_undo(window, before, after)

    def test_a_large_mesh(self):
        if not SPOT.exists():
            self.skipTest(f"there is no {SPOT}")
        window = self.window(*LIGHT)
        window.open(SPOT)
        window.wait_for_title("spot.obj")
        scene = window.scene()
        self.assertEqual((self.folder / scene["surface"]["mesh"]).resolve(), SPOT.resolve())
        for y in (-25, 0, 25):  # one of which is on the cow
            window.click((MIDDLE[0], SIZE[1] // 2 + y))
        self.assertNotEqual(window.scene()["probe"], scene["probe"])
        self.assertEqual(png_size(window.picture()), (SIZE[0] - PANEL, SIZE[1]))

    def test_a_scene_is_opened(self):
        window = self.window("shear", *LIGHT)
        saved = window.scene()
        self.file("s.json", json.dumps(saved))
        window.key("n", "r", "v")
        self.assertNotEqual(window.scene(), saved)
        window.open("s.json")
        window.wait_for_title("s.json")
        self.assertEqual(window.scene(), saved)

    def test_saving_by_a_path(self):
        (self.folder / "deep").mkdir()
        window = self.window(*LIGHT)
        for path, file in ((self.folder / "deep" / "one.json", "deep/one.json"), ("deep/two", "deep/two.json")):
            window.key("ctrl+s")
            window.type(path)
            window.key("Return")
            until((self.folder / file).exists, file)

    def test_files_that_are_none_leave_the_scene_as_it_was(self):
        self.file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n")
        self.file("b.stl", bytes(range(256)) * 3)
        self.file("c.json", '{"normalscope": 1, "colour": "red"}')
        self.file("d.json", '{"normalscope": 1, "surface": {"mesh": "none.obj"}}')
        self.file("e", "nothing")
        self.file("g.json", '{"normalscope": 1, "rule": "naive"}')
        window = self.window(*LIGHT)
        before = window.scene()
        title = window.title()
        for name in ("a.obj", "b.stl", "c.json", "d.json", "e"):
            window.open(name)
        window.open("f")  # there is none: the dialog says so, and stays
        window.key("Escape")
        self.assertEqual(window.scene(), before)
        self.assertEqual(window.title(), title)
        window.open("g.json")
        window.wait_for_title("g.json")
        self.assertEqual(window.scene()["rule"], "naive")

    def test_nothing_is_overwritten_unasked(self):
        self.file("o.json", "old")
        window = self.window(*LIGHT)
        window.key("ctrl+s")
        window.type("o.json")
        window.key("Return")
        self.assertEqual((self.folder / "o.json").read_text(), "old")
        window.key("Return")  # yes, do
        window.wait_for_title("o.json")
        self.assertEqual(json.loads((self.folder / "o.json").read_text())["normalscope"], 1)

    def test_saving_goes_back_to_the_file(self):
        (self.folder / "deep").mkdir()
        self.file("deep/s.json", '{"normalscope": 1, "rule": "naive"}')
        window = self.window("deep/s.json", *LIGHT)
        window.key("c", "ctrl+s")
        window.key("Return")
        window.key("Return")  # yes, overwrite it
        until(lambda: json.loads((self.folder / "deep/s.json").read_text())["rule"] == "cofactor", "the scene")
        self.assert_closes(window)  # of two windows, the keys go to whichever has the focus
        # A lesson would lose its steps.
        lesson = '{"normalscope": 1, "lesson": "L", "about": "l", "steps": [{"caption": "A sphere.", "scene": {"stack": []}}]}'
        self.file("lesson.json", lesson)
        window = self.window("lesson.json", *LIGHT)
        window.key("ctrl+s")
        window.key("Return")
        until((self.folder / "scene.json").exists, "the scene")
        self.assertEqual((self.folder / "lesson.json").read_text(), lesson)

    def test_a_folder_that_does_not_exist(self):
        window = self.window(*LIGHT)
        window.key("ctrl+s")
        window.type("none/scene.json")
        window.key("Return", "Escape")
        self.assertFalse((self.folder / "none").exists())

    def test_the_picture_is_what_capture_makes(self):
        size = (1280, 720)  # for which words are as large in a capture as in a window
        window = self.window("split", *LIGHT, "--set", "theme=dark", size=size)
        window.key("Tab")
        picture = window.picture()
        self.assertEqual(png_size(picture), size)
        self.file("saved.png", picture)
        self.file("scene.json", json.dumps(window.scene()))
        for command in ("capture scene.json -o captured.png --size 1280x720",
                        "compare saved.png captured.png --tolerance 3 --share 0.001"):
            done = subprocess.run([NORMALSCOPE, *command.split()], cwd=self.folder, check=False, capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, b""), done)

    @unittest.skipUnless(shutil.which("xclip"), "xclip is not installed")
    def test_the_copied_command_draws_the_same(self):
        window = self.window("shear", *LIGHT)
        window.key("n", "v", "Tab", "2")
        window.drag((300, 200), (350, 230))
        window.key("ctrl+c")
        command = subprocess.run(["xclip", "-o", "-selection", "clipboard"], capture_output=True, text=True, timeout=60, check=True).stdout
        self.assertRegex(command, r"\Anormalscope capture shear -o picture.png --size 640x460 --scale 1 ")
        self.assertIn("--set rule=", command)
        self.file("saved.png", window.picture())
        done = subprocess.run(command.replace("normalscope", str(NORMALSCOPE), 1) + " --expect saved.png", shell=True,
                              cwd=self.folder, check=False, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""), done)


if __name__ == "__main__":
    unittest.main()
