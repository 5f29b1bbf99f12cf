#!/usr/bin/env python3
"""Checks who includes whom under app/, and exits with 1 where the architecture forbids it.

The core knows only mathematics; gl, ui, platform and cli know the core, not each other; the files directly in app/
wire them together and may include anything. The linker cannot check this: headers need no linking.
"""

import pathlib
import re
import sys

APP = pathlib.Path(__file__).parent.parent / "app"
TOP = "."  # the files directly in app/

# Our folders that each folder may include, besides its own.
OURS = {"core": set(), "gl": {"core"}, "ui": {"core"}, "platform": {"core"}, "cli": {"core"}}

# The folders that may include a library's headers.
THEIRS = {
    r"(glad|GL|GLES\d?)/": {"gl", "platform", TOP},
    r"(EGL|KHR)/": {"platform", TOP},
    r"GLFW/": {"platform", TOP},
    r"imgui": {"ui", TOP},
    r"CLI/": {"cli", TOP},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')


def complaint(file, folder, header):
    """Why the file, of that folder, may not include the header; None where it may."""
    for pattern, folders in THEIRS.items():
        if re.match(pattern, header) and folder not in folders:
            return f"only {', '.join(sorted(folders - {TOP}))} and the files directly in app/ may"
    if folder == TOP:
        return None
    if ".." in header:
        return "write the path from app/"
    owner = header.split("/")[0]
    if owner in OURS and owner not in OURS[folder] | {folder}:
        return f"{folder} may include only {' and '.join(sorted(OURS[folder] | {folder}))}"
    if "/" not in header and (APP / header).exists() and not (file.parent / header).exists():
        return "the files directly in app/ are on top of all others"
    return None


def main():
    failed = False
    for file in sorted(APP.rglob("*")):
        if file.suffix not in {".h", ".cpp"}:
            continue
        parts = file.relative_to(APP).parts
        folder = parts[0] if len(parts) > 1 else TOP
        if folder != TOP and folder not in OURS:
            print(f"{file}: {folder}/ is not among the folders that {pathlib.Path(__file__).name} knows")
            failed = True
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            reason = found and complaint(file, folder, found[1])
            if reason:
                print(f"{file}:{number}: must not include {found[1]}: {reason}")
                failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
