#!/usr/bin/env python3
"""What needs a window manager, on a display of its own: once there has been one, windows count on it."""

import shutil
import subprocess
import time
import unittest

from support import LIGHT, SIZE, WindowTest, until
from x11 import Display


@unittest.skipUnless(shutil.which("openbox"), "openbox, a window manager, is not installed")
class MaximisedTest(WindowTest):
    def setUp(self):
        super().setUp()
        manager = subprocess.Popen(["openbox", "--sm-disable"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(manager.wait)
        self.addCleanup(manager.terminate)
        self.display = Display()
        self.addCleanup(self.display.close)
        until(lambda: self.display.has_manager(), "the window manager")

    def assert_width(self, window, width):
        until(lambda: window.check() or window.geometry()[0] == width, f"the window to be {width} wide")
        window.settle()

    def test_it_is_remembered_and_so_is_the_size_before_it(self):
        window = self.window(*LIGHT)
        time.sleep(1)  # so that this is a size which somebody wanted
        self.display.maximise(int(window.id), True)
        self.assert_width(window, 1280)
        self.assert_closes(window)
        window = self.window(*LIGHT, size=None)
        self.assert_width(window, 1280)
        self.assertLess(window.geometry()[1], 960)  # it has a title
        for height in ("full screen", "as before"):
            before = window.geometry()
            window.key("F11")
            until(lambda: window.geometry() != before, height)
        self.assert_width(window, 1280)
        self.display.maximise(int(window.id), False)
        self.assert_width(window, SIZE[0])
        self.assertEqual(window.geometry(), SIZE)


if __name__ == "__main__":
    unittest.main()
