#!/usr/bin/env python3
"""The window itself: its size, full screen, what it remembers, and that it rests."""

import time
import unittest

from support import LIGHT, PANEL, SIZE, WindowTest, png_size, until


class WholeWindowTest(WindowTest):
    def assert_size(self, window, size):
        until(lambda: window.geometry() == size, f"the window to be {size}")
        window.settle()

    def test_the_size_at_first(self):
        self.assertEqual(self.window(*LIGHT, size=None).geometry(), (1280, 800))

    def test_resizing(self):
        window = self.window(*LIGHT)
        before = window.scene()
        for size in ((1100, 500), (700, 900), (500, 320), SIZE):
            window.resize(size)
            self.assert_size(window, size)
            self.assertEqual(png_size(window.picture()), (size[0] - PANEL, size[1]))
        self.assertEqual(window.scene(), before)

    def test_no_size_is_too_small(self):
        # Without a window manager nothing keeps to the least size that the program asks for.
        window = self.window(*LIGHT)
        before = window.scene()
        for size in ((PANEL, 300), (100, 60), (1, 1), SIZE):
            window.resize(size)
            self.assert_size(window, size)
        self.assertEqual(window.scene(), before)

    def test_the_size_is_remembered(self):
        window = self.window(*LIGHT)
        window.resize((1010, 620))
        self.assert_size(window, (1010, 620))
        self.assert_closes(window)
        self.assertEqual(self.window(*LIGHT, size=None).geometry(), (1010, 620))

    def test_damaged_settings_are_ignored(self):
        settings = self.folder / "config" / "normalscope" / "settings.json"
        settings.parent.mkdir(parents=True)
        for text in ("{", '{"window_size": "large"}', '{"window_size": [1e99, -1]}'):
            settings.write_text(text)
            window = self.window(*LIGHT, size=None)
            self.assertEqual(window.geometry(), (1280, 800), text)
            self.assert_closes(window)

    def test_full_screen_and_back(self):
        window = self.window(*LIGHT)
        before = window.scene()
        window.key("F11")
        self.assert_size(window, (1280, 960))
        self.assertEqual(png_size(window.picture()), (1280 - PANEL, 960))
        window.key("F11")
        self.assert_size(window, SIZE)
        self.assertEqual(window.scene(), before)
        window.key("F11")  # and its size is remembered all the same
        self.assert_size(window, (1280, 960))
        self.assert_closes(window)
        self.assertEqual(self.window(*LIGHT, size=None).geometry(), SIZE)

    def test_an_idle_window_rests(self):
        window = self.window(*LIGHT)
        window.key("n")
        window.point((73, 79))  # on a button, whose tooltip comes
        time.sleep(1.0)  # and is there
        before, seconds = window.cpu_seconds(), 3.0
        time.sleep(seconds)
        self.assertLessEqual(window.cpu_seconds() - before, 0.02 * seconds)


if __name__ == "__main__":
    unittest.main()
