#!/usr/bin/env python3
"""Where the window's driver is too old, or the display has no OpenGL, as remote ones: one line, and the page in place of it."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from support import NORMALSCOPE, PATIENCE


class OldDriverTest(unittest.TestCase):
    def assert_says(self, *command, says, **variables):
        done = subprocess.run([*map(str, command), "shear"], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
                              timeout=PATIENCE, env={**os.environ, **variables})
        self.assertEqual((done.returncode, done.stdout), (4, ""), done.stderr)
        self.assertRegex(done.stderr, r"\Anormalscope: no window: [^\n]+; OpenGL 3\.3 is needed[^\n]+\n\Z")
        for words in says:
            self.assertIn(words, done.stderr)

    def test_opengl_below_3_3(self):
        for version in ("2.1", "3.0", "3.2"):
            self.assert_says(NORMALSCOPE, says=("remote desktops", "LIBGL_ALWAYS_SOFTWARE=1"), MESA_GL_VERSION_OVERRIDE=version)

    def test_no_opengl(self):
        end, its_end = os.pipe()
        with open(end, "rb") as number, subprocess.Popen(["Xvfb", "-displayfd", str(its_end), "-extension", "GLX"],
                                                         pass_fds=[its_end], stderr=subprocess.DEVNULL) as server:
            os.close(its_end)
            try:
                self.assert_says(NORMALSCOPE, says=("GLX",), DISPLAY=":" + number.readline().decode().strip())
            finally:
                server.terminate()

    def test_the_page_is_offered(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copy(NORMALSCOPE, folder)
            (folder / "normalscope.html").write_text("a page")
            self.assert_says(folder / NORMALSCOPE.name, says=(f"or open {folder}/normalscope.html in a browser",),
                             MESA_GL_VERSION_OVERRIDE="3.0")


if __name__ == "__main__":
    unittest.main()
