#!/usr/bin/env python3
"""The program for Windows, under Wine: its window, driven by xdotool."""

import json
import os
import pathlib
import subprocess
import tempfile
import time
import unittest

WINE = os.environ.get("WINE", "wine")
EXE = os.environ.get("NORMALSCOPE_EXE", "build/windows/normalscope.exe")
PATIENCE = 120.0  # seconds


def until(condition, what):
    end = time.monotonic() + PATIENCE
    while not (value := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"still waiting for {what}")
        time.sleep(0.05)
    return value


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False,
                          timeout=PATIENCE, text=True).stdout.split()


def own(errors):
    """Without what Wine tells of a fault: in its own services, which write here as well. After one of the program's own it
    would not end with 0."""
    return b"".join(line for line in errors.splitlines(keepends=True) if not line.startswith(b"wine: "))


class WindowTest(unittest.TestCase):
    def test_it_opens_saves_and_closes(self):
        with tempfile.TemporaryDirectory(prefix="räume-") as name:
            folder = pathlib.Path(name)
            (folder / "größe.json").write_text(json.dumps({"surface": {"shape": "sphere", "resolution": 24}}))
            program = subprocess.Popen([WINE, EXE, "größe.json"], cwd=folder, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            try:
                window = until(lambda: xdotool("search", "--onlyvisible", "--name", "Normalscope"), "the window")[0]
                xdotool("windowfocus", "--sync", window)
                time.sleep(1)
                for key in ("i", "ctrl+shift+s"):
                    xdotool("key", key)
                    time.sleep(0.5)
                xdotool("type", "--delay", "50", "saved.json")
                xdotool("key", "Return")
                saved = until(lambda: (folder / "saved.json").exists() and (folder / "saved.json").read_text(), "the scene")
                self.assertEqual(json.loads(saved)["surface"]["shape"], "sphere")
                xdotool("key", "ctrl+c")
                command = until(lambda: subprocess.run(["xclip", "-o", "-selection", "clipboard"], stdout=subprocess.PIPE,
                                                       stderr=subprocess.DEVNULL, check=False).stdout.decode(), "the command")
                self.assertRegex(command, r'^normalscope capture "[A-Z]:\\.*räume-.*\\saved\.json" -o picture\.png ')
                xdotool("key", "ctrl+q")
                out, errors = program.communicate(timeout=PATIENCE)
                self.assertEqual((program.returncode, out, own(errors)), (0, b"", b""))
                users = pathlib.Path(os.environ.get("WINEPREFIX", pathlib.Path.home() / ".wine")) / "drive_c" / "users"
                self.assertTrue(list(users.glob("*/AppData/Roaming/normalscope/settings.json")))
            finally:
                program.kill()
                program.communicate()


if __name__ == "__main__":
    unittest.main()
