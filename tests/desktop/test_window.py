#!/usr/bin/env python3
"""What needs a real window; all else is tested without one, in tests/viewer."""

import json
import shutil
import subprocess
import unittest

from support import GROUND, LIGHT, NORMALSCOPE, PANEL, SIZE, STRIP, Window, WindowTest, png_size, until
from x11 import Display


class InputTest(WindowTest):
    def test_keys_mouse_and_wheel_arrive(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.key("n", "ctrl+z", "c")
        self.assertEqual(window.scene(), before | {"rule": "cofactor"})
        window.drag(GROUND, (GROUND[0] + 50, GROUND[1] - 30))
        window.wheel(2)
        window.do("keydown", "shift")
        window.drag(GROUND, (GROUND[0] + 50, GROUND[1]))
        window.do("keyup", "shift")
        after = window.scene()
        self.assertAlmostEqual(after["camera"]["azimuth"], before["camera"]["azimuth"] - 20)
        self.assertAlmostEqual(after["camera"]["elevation"], before["camera"]["elevation"] - 12)
        self.assertAlmostEqual(after["camera"]["zoom"], before["camera"]["zoom"] * 1.12 ** 2)
        self.assertNotEqual(after["light"], before["light"])

    def test_a_press_counts_where_the_pointer_has_always_been(self):
        self.window(*LIGHT).point(GROUND)
        window = self.window(*LIGHT)
        window.do("mousedown", 1)
        window.point((GROUND[0] + 50, GROUND[1]))
        window.do("mouseup", 1)
        self.assertAlmostEqual(window.scene()["camera"]["azimuth"], 10)

    def test_keys_follow_the_letters_that_are_printed(self):
        # By their places the first would quit, and the second do nothing: French A is where Q is, German Z where Y is.
        self.addCleanup(subprocess.run, ["setxkbmap", "us"], check=True)
        for layout in ("fr", "de"):
            subprocess.run(["setxkbmap", layout], check=True)
            window = self.window(*LIGHT)
            before = window.scene()
            window.key("n", "ctrl+a", "m", "ctrl+z")
            self.assertEqual(window.scene(), before, layout)
            window.key("n")
            with_words = png_size(window.picture())
            window.key("ctrl+minus")  # a smaller panel leaves more
            self.assertGreater(png_size(window.picture())[0], with_words[0], layout)
            self.assert_closes(window)  # by Ctrl+Q

    def test_a_file_is_dropped(self):
        file = self.folder / "dropped here.json"
        file.write_text('{"normalscope": 1, "rule": "naive"}')
        window = self.window(*LIGHT)
        display = Display()
        self.addCleanup(display.close)
        display.drop(int(window.id), file)
        window.wait_for_title("dropped here.json")
        self.assertEqual(window.scene()["rule"], "naive")


class DrawingTest(WindowTest):
    def test_drawing_appears_and_changes(self):
        display = Display()
        self.addCleanup(display.close)
        window = self.window(*LIGHT)
        light = display.pixels(int(window.id), *SIZE)
        self.assertGreater(len({row[x:x + 4] for row in light for x in range(0, len(row), 4)}), 100)
        window.key("t")
        dark = display.pixels(int(window.id), *SIZE)
        self.assertLess(sum(map(sum, dark)), sum(map(sum, light)) / 2)

    def test_the_picture_is_what_capture_makes(self):
        size = (1280, 720)  # for which words are as large in a capture as in a window
        window = self.window("split", *LIGHT, "--set", "theme=dark", size=size)
        window.key("Tab")
        picture = window.picture()
        self.assertEqual(png_size(picture), size)
        (self.folder / "saved.png").write_bytes(picture)
        (self.folder / "scene.json").write_text(json.dumps(window.scene()))
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
        command = subprocess.run(["xclip", "-o", "-selection", "clipboard"], capture_output=True, text=True, timeout=60,
                                 check=True).stdout
        (self.folder / "saved.png").write_bytes(window.picture())
        done = subprocess.run(command.replace("normalscope", str(NORMALSCOPE), 1) + " --expect saved.png", shell=True,
                              cwd=self.folder, check=False, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""), done)

    def test_a_link_through_the_clipboard(self):
        window = self.window("shear", *LIGHT)
        first = window.scene()
        window.key("ctrl+l", "n", "r", "v")
        self.assertNotEqual(window.scene(), first)
        window.key("ctrl+v")
        until(lambda: window.scene() == first, "the linked scene")


class WorkTest(WindowTest):
    def test_work_is_offered_again_after_a_kill(self):
        window = Window(self.folder, *LIGHT)  # which comes to no good end
        self.addCleanup(window.kill)
        window.key("c")
        until(lambda: list((self.folder / "config" / "normalscope").glob("unsaved-*")), "the scene to be kept")
        window.kill()
        window = self.window(*LIGHT)
        window.key("Return")
        self.assertEqual(window.scene()["rule"], "cofactor")
        self.assert_closes(window)
        window = self.window(*LIGHT)
        self.assertEqual(window.scene()["rule"], "inverse-transpose")


class SizeTest(WindowTest):
    def assert_size(self, window, size):
        until(lambda: window.geometry() == size, f"the window to be {size}")
        window.settle()

    def test_resizing(self):
        window = self.window(*LIGHT)
        before = window.scene()
        # Without a window manager nothing keeps to the least size that the program asks for.
        # The sentence above the picture takes as much of its height, where there is room for it: more where it is narrow.
        for size, strip in (((1100, 500), 62), ((PANEL, 300), 0), ((1, 1), 0), ((500, 320), 0), (SIZE, 116)):
            window.resize(size)
            self.assert_size(window, size)
            if size[0] > PANEL:
                self.assertEqual(png_size(window.picture()), (size[0] - PANEL, size[1] - strip))
        self.assertEqual(window.scene(), before)

    def test_full_screen_and_back_and_the_size_is_remembered(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.key("F11")
        self.assert_size(window, (1280, 960))
        self.assertEqual(png_size(window.picture()), (1280 - PANEL, 960 - STRIP))
        window.key("F11")
        self.assert_size(window, SIZE)
        window.key("F5")  # presenting takes the whole screen, too
        self.assert_size(window, (1280, 960))
        window.key("F5")
        self.assert_size(window, SIZE)
        self.assertEqual(window.scene(), before)
        window.resize((1010, 620))
        self.assert_size(window, (1010, 620))
        window.key("F11")  # and its size is remembered all the same
        self.assert_size(window, (1280, 960))
        self.assert_closes(window)
        self.assertEqual(self.window(*LIGHT, size=None).geometry(), (1010, 620))

    def test_on_a_fine_monitor_the_window_is_as_large_each_time(self):
        display = Display()
        self.addCleanup(display.close)
        self.addCleanup(display.set_scale, 1)
        display.set_scale(1.2)
        sizes = []
        for _ in range(3):
            window = self.window(*LIGHT, size=None)
            sizes.append(window.geometry())
            self.assert_closes(window)
        self.assertEqual(len(set(sizes)), 1, sizes)

    def test_the_size_at_first_and_with_damaged_settings(self):
        settings = self.folder / "config" / "normalscope" / "settings.json"
        settings.parent.mkdir(parents=True)
        for text in (None, "{", '{"window_size": [1e99, -1]}'):
            if text:
                settings.write_text(text)
            window = self.window(*LIGHT, size=None)
            self.assertEqual(window.geometry(), (1280, 800), text)
            self.assert_closes(window)


if __name__ == "__main__":
    unittest.main()
