#!/usr/bin/env python3
"""Leaves of a font the letters that a page needs: its whole fonts would be most of what is sent.

    subset_font.py FONT OUT FONTS.CPP TEXT...

Kept are the letters that the interface bakes (the ranges in FONTS.CPP), those of the texts that the program brings along, and of
OpenSans-Regular, which sets what people write, all of Latin with its accents and Greek. Others are drawn by the browser.
"""

import pathlib
import re
import subprocess
import sys

PEOPLES = [*range(0xA0, 0x180), 0x192, *range(0x218, 0x21C), *range(0x2C6, 0x2DE), *range(0x384, 0x3CF), *range(0x2010, 0x2045), 0x20AC]
RANGES = re.compile(r"std::array<ImWchar, \d+> k\w+\{([^}]*)\};")


def baked(source):
    for ranges in RANGES.findall(source):
        ends = [ord(end[1]) if end[0] == "'" else int(end, 0) for end in map(str.strip, ranges.split(","))][:-1]
        for first, last in zip(ends[::2], ends[1::2], strict=True):
            yield from range(first, last + 1)


def main():
    font, out, source, *texts = sys.argv[1:]
    letters = set(baked(pathlib.Path(source).read_text(encoding="utf-8")))
    assert {0x20, 0x2212, ord("Z")} <= letters, f"{source}: the ranges of letters are not written as they were"
    for text in texts:
        letters.update(map(ord, pathlib.Path(text).read_text(encoding="utf-8")))
    if "OpenSans-Regular" in font:
        letters.update(PEOPLES)
    if "DejaVu" in font:
        letters = {letter for letter in letters if letter > 0x7E}
    subprocess.run(["pyftsubset", font, f"--output-file={out}", "--unicodes=" + ",".join(f"{letter:x}" for letter in letters),
                    "--no-hinting", "--layout-features=", "--name-IDs=", "--notdef-outline", "--drop-tables+=FFTM,kern"], check=True)


if __name__ == "__main__":
    main()
