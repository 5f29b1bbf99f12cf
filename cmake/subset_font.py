#!/usr/bin/env python3
"""Leaves of a font what is drawn of it: nothing reads its hints, its kerning, or shapes that no letter stands for.

    subset_font.py FONT OUT FONTS.CPP [TEXT...]

A program keeps all the letters of OpenSans-Regular and DejaVuSans, which set what people write, and of the others those that the
interface bakes (the ranges in FONTS.CPP). A page, which is given TEXTs, would be for the most part fonts: it keeps the baked ones,
those of the texts that the program brings along, and of OpenSans-Regular all of Latin with its accents and Greek. Others are drawn
by the browser.
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


def kept(font, source, texts):
    letters = set(baked(pathlib.Path(source).read_text(encoding="utf-8")))
    assert {0x20, 0x2212, ord("Z")} <= letters, f"{source}: the ranges of letters are not written as they were"
    sets_all = "Semibold" not in font
    if sets_all and not texts:
        return "*"
    for text in texts:
        letters.update(map(ord, pathlib.Path(text).read_text(encoding="utf-8")))
    if "OpenSans-Regular" in font:
        letters.update(PEOPLES)
    if "DejaVu" in font:
        letters = {letter for letter in letters if letter > 0x7E}
    return ",".join(f"{letter:x}" for letter in sorted(letters))


def main():
    font, out, source, *texts = sys.argv[1:]
    subprocess.run(["pyftsubset", font, f"--output-file={out}", f"--unicodes={kept(font, source, texts)}", "--no-hinting",
                    "--layout-features=", "--name-IDs=", "--notdef-outline", "--drop-tables+=FFTM,kern"], check=True)


if __name__ == "__main__":
    main()
