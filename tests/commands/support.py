"""What the command tests share: running the program, and files to give it."""

import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

NORMALSCOPE = os.environ.get("NORMALSCOPE", "build/normalscope")
SMALL = ("--size", "160x120")


PROGRESS = re.compile(r"^\d+ of \d+ \w+, \d+ (?:s|min) left\n", re.MULTILINE)  # a slow machine is told
MESH_NOTE = re.compile(r"^normalscope: [^:\n]+\.(?:obj|ply|stl)\b[^\n]*\n", re.MULTILINE | re.IGNORECASE)  # most have no normals


def run(*arguments, env=None, **options):
    """The finished program. `env` adds to the environment, None as a value removes from it."""
    environment = dict(os.environ)
    for name, value in (env or {}).items():
        if value is None:
            environment.pop(name, None)
        else:
            environment[name] = value
    options.setdefault("stdin", subprocess.DEVNULL)
    options.setdefault("stdout", subprocess.PIPE)
    return subprocess.run(
        [NORMALSCOPE, *map(str, arguments)],
        env=environment, stderr=subprocess.PIPE, timeout=300, check=False, **options)


class CommandTest(unittest.TestCase):
    """Each test has a folder of its own, self.folder."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="normalscope-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def file(self, name, content):
        """A file in the test's folder."""
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def scene(self, **keys):
        return self.file("scene.json", json.dumps({"normalscope": 1, **keys}))

    def assert_done(self, *arguments, notes=(), **options):
        """What it prints. On stderr must be a line for each of the `notes`, which holds those words, and no other."""
        done = run(*arguments, **options)
        lines = PROGRESS.sub("", done.stderr.decode()).splitlines()
        self.assertEqual((done.returncode, len(lines)), (0, len(notes)), (arguments, lines))
        for line, note in zip(lines, notes):
            self.assertTrue(line.startswith("normalscope: ") and note in line, (line, note))
        return done.stdout or b""

    def assert_fails(self, code, *arguments, says=(), lacks=None, **options):
        """It exits with `code` and says why in one line of stderr, which holds every one of the words `says`, and not `lacks`."""
        done = run(*arguments, **options)
        line = done.stderr.decode()
        self.assertEqual(done.returncode, code, (arguments, line))
        self.assertEqual(done.stdout or b"", b"", arguments)
        self.assertRegex(line, r"\Anormalscope: [^\n]+\n\Z", arguments)
        self.assertLess(len(line), 600, arguments)
        for word in says if isinstance(says, tuple) else (says,):
            self.assertIn(str(word), line)
        if lacks:
            self.assertNotIn(lacks, line)
        # What does not exist is said in words; only what the user wrote may be repeated.
        for argument in filter(None, map(str, arguments)):
            line = line.replace(argument, "")
        self.assertNotRegex(line, r"\b(nan|-?inf)\b")

    def capture(self, *arguments, **options):
        """The small picture of a scene as bytes."""
        path = self.folder / "picture.png"
        self.assert_done("capture", *arguments, "-o", path, *SMALL, **options)
        return path.read_bytes()

    def numbers(self, *arguments, **options):
        """What --numbers says of a scene."""
        path = self.folder / "numbers.json"
        self.capture(*arguments, "--numbers", path, **options)
        text = path.read_text()
        self.assertNotRegex(text, r"(?i)\b(nan|inf|infinity)\b")
        return json.loads(text)


def close_to(test, actual, expected, places=9):
    """Numbers, or arrays of them, that agree but for rounding."""
    if isinstance(expected, (list, tuple)):
        test.assertEqual(len(actual), len(expected))
        for a, e in zip(actual, expected):
            close_to(test, a, e, places)
    else:
        test.assertAlmostEqual(actual, expected, places)


def png_size(picture):
    assert picture.startswith(b"\x89PNG\r\n\x1a\n")
    return struct.unpack(">II", picture[16:24])


def png(width, height, rows, depth=8, kind=2, extra=b""):
    """A PNG of the given bytes a row; `kind` is PNG's colour type, `extra` holds chunks to put before the pixels."""
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", pixels) + chunk(b"IEND", b""))


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def colours(picture):
    """How many different bytes the rows of a PNG hold: a rough measure of whether anything was drawn."""
    data, at = b"", 8
    while at < len(picture):
        size, name = struct.unpack(">I4s", picture[at:at + 8])
        if name == b"IDAT":
            data += picture[at + 8:at + 8 + size]
        at += 12 + size
    return len(set(zlib.decompress(data)))


def png_pixels(picture):
    """Rows of RGBA pixels, of a PNG with 8 bits a channel in RGB or RGBA."""
    data, at = b"", 8
    while at < len(picture):
        size, name = struct.unpack(">I4s", picture[at:at + 8])
        content = picture[at + 8:at + 8 + size]
        if name == b"IHDR":
            width, height, depth, kind = struct.unpack(">IIBB", content[:10])
        if name == b"IDAT":
            data += content
        at += 12 + size
    assert depth == 8 and kind in (2, 6)
    channels = 3 if kind == 2 else 4
    data, stride, rows, above = zlib.decompress(data), channels * width, [], bytes(channels * width)
    for y in range(height):
        kind_of_row, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = row[i - channels] if i >= channels else 0
            b, c = above[i], above[i - channels] if i >= channels else 0
            p = a + b - c
            paeth = min((a, b, c), key=lambda v: abs(p - v))  # the first of equals, as PNG wants it
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind_of_row]) & 255
        rows.append([(*row[x:x + 3], row[x + 3] if channels == 4 else 255) for x in range(0, stride, channels)])
        above = bytes(row)
    return rows


def words(text):
    return re.split(r"\s+", text.strip())
