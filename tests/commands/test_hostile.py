#!/usr/bin/env python3
"""Input made to exhaust time or memory, memory over many pictures, and being killed while writing."""

import os
import shutil
import signal
import subprocess
import time
import unittest
import zlib

from support import NORMALSCOPE, SMALL, CommandTest, chunk, png

ASAN = "asan" in os.path.abspath(NORMALSCOPE)  # whose shadow and quarantine would be measured instead
PLY = "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n" \
      "element face {}\nproperty list {} int vertex_indices\nend_header\n"


def packed(block, times):
    """Compressed, without ever being there as a whole: a child's peak begins with its parent's."""
    packer = zlib.compressobj(1)
    return b"".join([packer.compress(block) for _ in range(times)] + [packer.flush()])


def empty_png(width, height, rows, extra=b""):
    """A picture of zeros, of whose rows only so many are there."""
    start = png(width, height, [], kind=6, extra=extra)
    at = start.index(b"IDAT") - 4
    return start[:at] + chunk(b"IDAT", packed(b"\0" * (4 * width + 1), rows)) + chunk(b"IEND", b"")


class HostileTest(CommandTest):
    def measured(self, *arguments):
        """Exit code, its one line, seconds of processor time, MiB at most."""
        with open(self.folder / "log", "w+b") as log:
            child = subprocess.Popen([NORMALSCOPE, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=log)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            log.seek(0)
            return child.returncode, log.read().decode(), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024

    def refused(self, *arguments, mib=300):
        code, line, seconds, peak = self.measured(*arguments)
        self.assertEqual(code, 3, (arguments, line[:300]))
        self.assertRegex(line, r"\Anormalscope: [^\n]+\n\Z")
        self.assertLess(len(line), 1000)
        if not ASAN:
            self.assertLess(seconds, 5, arguments)
            self.assertLess(peak, mib, arguments)

    def test_meshes(self):
        capture = ("capture", "-o", self.folder / "out.png", *SMALL)
        for name, content in (("m.stl", b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 500),
                              ("v.ply", PLY.format(4_000_000_000, 1, "uchar")), ("f.ply", PLY.format(3, 4_000_000_000, "uchar") + "\0" * 36),
                              ("l.ply", PLY.format(3, 1, "uint").encode() + b"\0" * 36 + b"\xff\xff\xff\xff"),
                              ("i.obj", "v 0 0 0\n" * 3 + "f 1 2 4000000000\n"), ("line.obj", "v " + "1" * 5_000_000),
                              ("star.obj", "".join(f"v {i % 2} {i} 0\n" for i in range(200_000)) + "f " + " ".join(map(str, range(1, 200_001))))):
            self.refused(*capture, self.file(name, content))

    def test_text(self):
        out = ("-o", self.folder / "out.png")
        for text in ("[" * 100_000, '{"a":' * 100_000, '{"surface":{"formula":"' + "(" * 100_000 + '"}}',
                     '{"stack":[' + '{"scale":[1,1,1]},' * 100_000 + "{}]}"):
            self.refused("capture", *out, self.file("s.json", text))
        self.refused("check", self.file("m.json", "[" * 100_000))

    def test_pictures(self):
        small = self.file("small.png", png(1, 1, [[0, 0, 0]]))
        # Of 512 MiB there is at most one copy: it is the largest picture that is read.
        whole = self.file("whole.png", empty_png(16384, 8192, 8192))
        self.assertLess(whole.stat().st_size, 4 << 20)
        code, _, _, peak = self.measured("compare", whole, small)
        self.assertEqual(code, 1)
        if not ASAN:
            self.assertLess(peak, 700)
        self.refused("compare", self.file("large.png", empty_png(16384, 16384, 9)), small)
        text = chunk(b"zTXt", b"a\0\0" + packed(b"\0" * (1 << 20), 256))
        noted = self.file("text.png", empty_png(1, 1, 1, text))
        code, _, _, peak = self.measured("compare", noted, noted)
        self.assertEqual(code, 0)
        if not ASAN:
            self.assertLess(peak, 300)

    @unittest.skipIf(ASAN, "freed memory is kept in quarantine")
    def test_a_thousand_pictures_need_no_more_memory_than_a_few(self):
        child = subprocess.Popen([NORMALSCOPE, "sweep", "--vary", "camera.azimuth=0:360:1000", "-o", f"{self.folder}/", "--size", "64x48"],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        sizes = {}
        while child.poll() is None:
            drawn = sum(1 for _ in self.folder.iterdir())
            with open(f"/proc/{child.pid}/statm", encoding="ascii") as file:
                fields = file.read().split()
            if len(fields) > 1 and int(fields[1]) > 0:
                sizes[drawn] = int(fields[1]) * 4 / 1024
            time.sleep(0.02)
        self.assertEqual(child.returncode, 0)
        early = max(mib for drawn, mib in sizes.items() if 100 <= drawn < 400)
        late = max(mib for drawn, mib in sizes.items() if drawn >= 800)
        self.assertLess(late - early, 3, sizes)

    def test_killed_while_writing(self):
        for delay in (0.0, 0.003, 0.007, 0.011):
            out = self.folder / "frames"
            child = subprocess.Popen([NORMALSCOPE, "sweep", "--vary", "camera.azimuth=0:360:400", "-o", f"{out}/", *SMALL],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while not out.exists() or len(list(out.glob("*.png"))) < 5:
                time.sleep(0.01)
            time.sleep(delay)
            child.send_signal(signal.SIGKILL)
            child.wait()
            for path in out.glob("*.png"):
                self.assertTrue(path.read_bytes().endswith(b"IEND\xaeB`\x82"), path)
            shutil.rmtree(out)


if __name__ == "__main__":
    unittest.main()
