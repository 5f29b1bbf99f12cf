"""What the window tests share: the real window, driven by xdotool, and where its scene appears in it."""

import functools
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import time
import unittest

NORMALSCOPE = pathlib.Path(os.environ.get("NORMALSCOPE", "build/normalscope")).resolve()
PATIENCE = 60.0  # seconds until a test gives up; nothing takes as long but on a machine that is very busy

PANEL = 388  # the panel's width
STRIP = 56  # the height of the sentence above a wide picture
SIZE = (640, 460)  # smaller than the program's own, so that frames take little time
# A scene that is quickly drawn, for tests to which that makes no difference.
LIGHT = [word for setting in ("surface.resolution=24", "view=single", "arrows.limit=12", "show.grid=false", "show.ghost=false")
         for word in ("--set", setting)]
GROUND = (PANEL + (SIZE[0] - PANEL) // 2, SIZE[1] - 15)  # nothing else at the picture's lower edge


def until(condition, what):
    """Waits for a condition, and returns its value."""
    end = time.monotonic() + PATIENCE
    while not (value := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"still waiting for {what}")
        time.sleep(0.003)
    return value


def xdotool(*words):
    done = subprocess.run(["xdotool", *map(str, words)], capture_output=True, timeout=PATIENCE, check=False, text=True)
    if done.stderr:
        raise AssertionError(f"{done.args}: {done.stderr}")
    return done.stdout


def png_size(png):
    return struct.unpack(">II", png[16:24])


# ---- The window

class Window:
    """A window of the program's, its home and its working folder in `folder`, with these settings from before."""

    def __init__(self, folder, *arguments, size=SIZE, **settings):
        self.folder, self.size = folder, size
        config = folder / "config" / "normalscope"
        if size:
            config.mkdir(parents=True, exist_ok=True)
            (config / "settings.json").write_text(json.dumps({"window_size": size, **settings}))
        self.stderr = folder / "stderr"
        with open(self.stderr, "wb") as stderr:
            self.process = subprocess.Popen(
                [NORMALSCOPE, *map(str, arguments)], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                stderr=stderr, env={**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config")})
        self.processes = [self.process.pid, *self.display_server()]
        self.id = until(self.find, "the window").strip()
        self.settle()

    @staticmethod
    def display_server():
        number = re.search(r":(\d+)", os.environ.get("DISPLAY", ""))
        try:
            return [int(pathlib.Path(f"/tmp/.X{number[1]}-lock").read_text())]
        except (OSError, TypeError, ValueError):
            return []

    def find(self):
        self.check()
        return xdotool("search", "--onlyvisible", "--pid", self.process.pid)

    def check(self):
        if self.process.poll() is not None:
            raise AssertionError(f"the program ended with {self.process.returncode}: {self.stderr.read_text()}")

    def work_done(self):
        """How often the threads of program and display have gone to sleep so far; None while one is awake."""
        self.check()
        sleeps = 0
        try:
            for process in self.processes:
                for thread in os.listdir(f"/proc/{process}/task"):
                    with open(f"/proc/{process}/task/{thread}/status", encoding="ascii", errors="replace") as file:
                        state, _, rest = file.read().partition("\nState:\t")[2].partition("\n")
                    if not state.startswith("S"):
                        return None
                    sleeps += int(rest.partition("\nvoluntary_ctxt_switches:")[2].partition("\n")[0])
        except OSError:  # a thread has just ended
            return None
        return sleeps

    def settle(self):
        """Waits until the program has answered all that was sent to it, which is when it and the display sleep."""
        # One look is not enough: a thread looked at before may have been woken by one looked at since. But whoever ran
        # between two looks has either not gone to sleep again, or has done so once more.
        last = None
        def asleep():
            nonlocal last
            before, last = last, self.work_done()
            return last is not None and last == before
        until(asleep, "the window to come to rest")

    def do(self, *words):
        """Sends what xdotool makes of these words, and waits for the answer."""
        xdotool(*words, "getmouselocation")  # whatever asks the display for something: then it has got all before that
        self.settle()

    def key(self, *keys):
        """One after the other, faster than anyone; yet GLFW takes the same key in the same millisecond for one press."""
        self.do("key", "--delay", 5, *keys)

    def type(self, text):
        xdotool("type", "--delay", 0, "--", text)  # all that follows is text
        self.do()

    def point(self, at):
        self.do("mousemove", "--window", self.id, *at)

    def drag(self, start, end):
        self.point(start)
        self.do("mousedown", 1, "mousemove", "--window", self.id, *end, "mouseup", 1)

    def wheel(self, steps):
        self.do("click", "--delay", 0, "--repeat", abs(steps), 4 if steps > 0 else 5)

    def title(self):
        return xdotool("getwindowname", self.id).strip()

    def wait_for_title(self, name):
        """Until a file has been opened: a large one is read in the background."""
        until(lambda: self.check() or self.title().startswith(name), f"{name} in the title")
        self.settle()

    def resize(self, size):
        self.size = size
        self.do("windowsize", self.id, *size)

    def save(self, key, name):
        """Saves by the key that asks for a name, and returns what has been saved."""
        self.key(key)
        self.type(name)
        self.key("Return")
        file = self.folder / name
        until(lambda: self.check() or file.exists(), name)
        content = file.read_bytes()
        file.unlink()
        return content

    def scene(self):
        """What the program says that its scene is."""
        return json.loads(self.save("ctrl+shift+s", "scene.json"))

    def geometry(self):
        lines = xdotool("getwindowgeometry", "--shell", self.id)
        values = dict(line.split("=") for line in lines.split())
        return int(values["WIDTH"]), int(values["HEIGHT"])

    def picture(self):
        """The picture that it saves."""
        return self.save("ctrl+p", "normalscope.png")

    def close(self):
        """Closes it as the user does; returns what it printed and how it ended."""
        if self.process.poll() is None:
            xdotool("key", "ctrl+q")
            try:
                self.settle()  # it may ask whether to save the scene
                xdotool("key", "d")
            except AssertionError:
                pass  # it has ended
        try:
            self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.kill()
        return self.stderr.read_text(), self.process.returncode

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()


def leaves_a_picture(test):
    """A test that fails leaves behind what the screen looked like, where there is a tool for that."""
    @functools.wraps(test)
    def wrapped(self):
        try:
            test(self)
        except unittest.SkipTest:
            raise
        except BaseException:
            tool = shutil.which("import")
            if tool:
                folder = NORMALSCOPE.parent / "window-tests"
                folder.mkdir(exist_ok=True)
                picture = folder / f"{self.id()}.png"
                subprocess.run([tool, "-window", "root", picture], timeout=PATIENCE, check=False)
                print("the screen at that time:", picture)
            raise
    return wrapped


class WindowTest(unittest.TestCase):
    """Each test has a folder of its own; its windows must come to a good end and say nothing on the way."""

    def __init_subclass__(cls):
        for name, test in list(vars(cls).items()):
            if name.startswith("test_"):
                setattr(cls, name, leaves_a_picture(test))

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="normalscope-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def window(self, *arguments, **options):
        window = Window(self.folder, *arguments, **options)
        self.addCleanup(window.kill)
        self.addCleanup(self.assert_closes, window)
        return window

    def assert_closes(self, window):
        self.assertEqual(window.close(), ("", 0))
