#!/usr/bin/env python3
"""Where a context comes from, and exit code 4 where none can be made."""

import unittest

from support import SMALL, CommandTest

NO_OSMESA = {"NORMALSCOPE_OSMESA_LIBRARY": "/nonexistent"}
NO_EGL = {"NORMALSCOPE_EGL_LIBRARY": "/nonexistent"}
NO_DISPLAY = {"DISPLAY": None, "WAYLAND_DISPLAY": None, "WAYLAND_SOCKET": None}


class ContextTest(CommandTest):
    def test_the_numbers_say_which(self):
        self.assertEqual(self.numbers("--context", "osmesa")["context"], "osmesa")
        self.assertEqual(self.numbers()["context"], "osmesa")

    def test_without_osmesa(self):
        self.assert_fails(4, "capture", "-o", self.folder / "out.png", "--context", "osmesa", *SMALL, env=NO_OSMESA,
                          says=("OSMesa", "--context egl"))

    def test_auto_takes_egl_where_there_is_no_osmesa(self):
        self.assertEqual(self.numbers(env=NO_OSMESA)["context"], "egl")

    def test_without_egl(self):
        self.assertEqual(self.numbers(env=NO_EGL)["context"], "osmesa")
        self.assert_fails(4, "capture", "-o", self.folder / "out.png", "--context", "egl", *SMALL, env=NO_EGL,
                          says=("EGL", "--context osmesa"))

    def test_without_both(self):
        self.assert_fails(4, "capture", "-o", self.folder / "out.png", *SMALL, env={**NO_OSMESA, **NO_EGL},
                          says=("OSMesa: ", "EGL: ", "install libosmesa6, or libegl1"))
        self.assert_fails(4, "sweep", "--vary", "camera.azimuth=0:9:4", "-o", f"{self.folder}/", "--jobs", "2", *SMALL,
                          env={**NO_OSMESA, **NO_EGL}, says="no graphics context")

    def test_both_draw_the_same(self):
        for arguments in ((), ("split", "--panel"), ("error-map", "--samples", "1")):
            self.assertEqual(self.capture(*arguments, "--context", "osmesa"), self.capture(*arguments, "--context", "egl"))

    def test_a_display_is_not_needed(self):
        self.capture(env={**NO_DISPLAY, "HOME": None, "XDG_RUNTIME_DIR": None})
        self.capture(env={**NO_DISPLAY, "DISPLAY": ":4711"})

    def test_a_window_needs_a_display(self):
        self.assert_fails(4, env=NO_DISPLAY, says=("display", "capture"))
        self.assert_fails(4, "split", "--set", "rule=naive", env=NO_DISPLAY)
        self.assert_fails(4, env={**NO_DISPLAY, "DISPLAY": ":4711"}, says=":4711")

    def test_a_window_says_first_what_is_wrong_with_its_file(self):
        self.assert_fails(3, "none.json", env=NO_DISPLAY, says="none.json")
        self.assert_fails(3, "--set", "rule=right", env=NO_DISPLAY, says="rule")


if __name__ == "__main__":
    unittest.main()
