#!/usr/bin/env python3
"""Makes one page of a program that emscripten has made, and of what is around it.

    make_page.py PAGE ENGINE.js PAGE.html STYLE.css SCRIPT.js...

In PAGE.html, a line @style@, @program@ or @scripts@ stands for what comes there. The program's bytes, one letter each, are a
string in a script: compressed on their way they are hardly longer than by themselves, which base64 is by a half.
"""

import pathlib
import sys


def as_string(data):
    """A JavaScript string whose letters are the bytes plus one: HTML allows no NUL."""
    escapes = {ord("\n"): "\\n", ord("\r"): "\\r", ord("'"): "\\'", ord("\\"): "\\\\"}
    text = "".join(escapes.get(byte + 1, chr(byte + 1)) for byte in data)
    return "'" + text.replace("</", "<\\/").replace("<!", "\\x3c!") + "'"


def main():
    page, engine, html, style, *scripts = map(pathlib.Path, sys.argv[1:])
    program = f"const engineText = {as_string(engine.with_suffix('.wasm').read_bytes())};\n"
    parts = {
        "@style@": style.read_text(encoding="utf-8"),
        "@program@": program + engine.read_text(encoding="utf-8").replace("</", "<\\/"),
        "@scripts@": "\n".join(script.read_text(encoding="utf-8") for script in scripts),
    }
    lines = html.read_text(encoding="utf-8").split("\n")
    text = "\n".join(parts.get(line.strip(), line) for line in lines)
    page.write_bytes(text.encode("utf-8"))


if __name__ == "__main__":
    main()
