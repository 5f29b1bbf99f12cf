#!/usr/bin/env python3
"""make_icon.py RSVG_CONVERT ICON.svg ICON.ico|ICON.icns: the icon in the sizes that Windows or a Mac shows, each as a PNG."""

import pathlib
import struct
import subprocess
import sys

ICO_SIZES = (16, 20, 24, 32, 40, 48, 64, 256)
ICNS_SIZES = {"icp4": 16, "icp5": 32, "ic11": 32, "ic12": 64, "ic07": 128, "ic13": 256, "ic08": 256, "ic14": 512, "ic09": 512,
              "ic10": 1024}


def ico(picture):
    pictures = [picture(size) for size in ICO_SIZES]
    header = struct.pack("<HHH", 0, 1, len(pictures))
    offset = len(header) + 16 * len(pictures)
    for size, data in zip(ICO_SIZES, pictures):
        side = size % 256  # which stands for 256 by 0
        header += struct.pack("<BBBBHHII", side, side, 0, 0, 1, 32, len(data), offset)
        offset += len(data)
    return header + b"".join(pictures)


def icns(picture):
    parts = [(kind.encode(), picture(size)) for kind, size in ICNS_SIZES.items()]
    body = b"".join(kind + struct.pack(">I", 8 + len(data)) + data for kind, data in parts)
    return b"icns" + struct.pack(">I", 8 + len(body)) + body


def main():
    converter, drawing, name = sys.argv[1:]

    def picture(size):
        return subprocess.run([converter, "-w", str(size), "-h", str(size), drawing], check=True,
                              stdout=subprocess.PIPE).stdout

    path = pathlib.Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes((icns if path.suffix == ".icns" else ico)(picture))


if __name__ == "__main__":
    main()
