#!/usr/bin/env python3
"""make_ico.py RSVG_CONVERT ICON.svg ICON.ico: the icon in the sizes that Windows shows, each as a PNG within the .ico."""

import pathlib
import struct
import subprocess
import sys

SIZES = (16, 20, 24, 32, 40, 48, 64, 256)


def main():
    converter, drawing, icon = sys.argv[1:]
    pictures = [subprocess.run([converter, "-w", str(size), "-h", str(size), drawing], check=True,
                               stdout=subprocess.PIPE).stdout for size in SIZES]
    header = struct.pack("<HHH", 0, 1, len(SIZES))
    offset = len(header) + 16 * len(SIZES)
    for size, picture in zip(SIZES, pictures):
        side = size % 256  # which stands for 256 by 0
        header += struct.pack("<BBBBHHII", side, side, 0, 0, 1, 32, len(picture), offset)
        offset += len(picture)
    path = pathlib.Path(icon)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(header + b"".join(pictures))


if __name__ == "__main__":
    main()
