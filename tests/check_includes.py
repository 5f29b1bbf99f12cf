#!/usr/bin/env python3
"""Holds app/ against the table of rooms in docs/architecture.md, and exits with 1 where they differ.

Each folder of app/ is a room, and a row of the table names the rooms and the libraries that its files may include.
Beyond that, CMakeLists.txt must link each room to just these rooms, no files may include each other in a circle (a .cpp
and its .h count as one), a test stands in the folder of tests/ that has its room's name, and a comment that names a file
names one that is there.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
APP = ROOT / "app"
TESTS = ROOT / "tests"
TABLE = ROOT / "docs" / "architecture.md"

# What may not be included everywhere, by the word that the table has for it.
LIBRARIES = {
    "the system": r"(unistd|fcntl|poll|signal|spawn|xlocale|dlfcn|pthread|csignal|termios|windows|shellapi|io|process)(\.h)?$|sys/",
    "threads": r"(thread|future|mutex|shared_mutex|condition_variable|stop_token|semaphore|latch|barrier)$",
    "JSON": r"nlohmann/",
    "CLI11": r"CLI/",
    "PNG": r"png\.h$",
    "zlib": r"zlib\.h$",
    "GL": r"(glad|GL|GLES\d?)/",
    "EGL": r"(EGL|KHR)/",
    "GLFW": r"GLFW/",
    "Emscripten": r"emscripten",
    "ImGui": r"(imgui|imstb)(?!_impl)",
    "ImGui backends": r"imgui_impl",
    "assets": r"embedded\.h$",
}

PATH = re.compile(r"(?<![\w./-])((\w+)/[\w./-]+\.(?:h|cpp|vert|frag|glsl|md|py|mjs|cmake))\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')
ROW = re.compile(r"^\| `([^`]+)` \|[^|]*\|([^|]*)\|([^|]*)\|")


def table():
    """Each room's name, the rooms that it may include, and the libraries."""
    rooms = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        if row := ROW.match(line):
            libraries = {name.strip() for name in row[3].split(",")} - {""}
            rooms[row[1]] = (re.findall(r"`([^`]+)`", row[2]), libraries)
    return rooms


def closure(rooms, room):
    """All that a room may include: what its row names, what that may include in turn, and itself."""
    found, todo = set(), [room]
    while todo:
        if (name := todo.pop()) not in found:
            found.add(name)
            todo += rooms[name][0] if name in rooms else []
    return found


def table_faults(rooms):
    for room, (uses, libraries) in rooms.items():
        for name in [room, *uses]:
            if name not in rooms or not (APP / name).exists():
                yield f"{TABLE.name}: there is no room {name}"
        for name in libraries - LIBRARIES.keys():
            yield f"{TABLE.name}: {room}: {pathlib.Path(__file__).name} does not know '{name}'"
    linked = re.findall(r"^room\(([^\s)]+)([^)]*)\)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)
    linked = {name: sorted(uses.split()) for name, uses in linked}
    for room in sorted(rooms.keys() | linked.keys()):
        said = sorted(rooms[room][0]) if room in rooms else None
        if room != "main.cpp" and linked.get(room) != said:
            yield f"CMakeLists.txt: room({room}) links {linked.get(room)}, and {TABLE.name} has {said}"


def pair_faults(files):
    """What each system does in its own way stands in a file for each, and nowhere else."""
    for file in files:
        where = file.relative_to(ROOT)
        if re.search(r"^\s*#.*\b(_WIN32|__APPLE__|__linux__)\b", file.read_text(encoding="utf-8"), re.M):
            yield f"{where}: asks for the system; let CMake choose between a ..._posix.cpp and a ..._windows.cpp"
        for this, other in (("_posix", "_windows"), ("_windows", "_posix"), ("_macos", "_posix")):
            if file.stem.endswith(this) and file.suffix == ".cpp" and not (
                    file.parent / (file.stem.removesuffix(this) + other + ".cpp")).exists():
                yield f"{where}: there is no such file for the other system"


def room_of(file):
    return file.name if file.parent == APP else str(file.parent.relative_to(APP))


def includes(file):
    """Line number, whether in quotes, and header."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if found := INCLUDE.match(line):
            yield number, found[1] == '"', found[2]


def include_faults(rooms, files):
    for file in files:
        room = room_of(file)
        where = file.relative_to(ROOT)
        if room not in rooms:
            yield f"{where}: {room} is not a room of {TABLE.name}"
            continue
        allowed = closure(rooms, room)
        for number, ours, header in includes(file):
            if not ours:
                for name, pattern in LIBRARIES.items():
                    if re.match(pattern, header) and name not in rooms[room][1]:
                        yield f"{where}:{number}: must not include {header}: {room} may not use {name}"
            elif not (APP / header).exists():
                yield f"{where}:{number}: write the path of {header} from app/"
            elif room_of(APP / header) not in allowed:
                yield f"{where}:{number}: must not include {header}: {room} may include {', '.join(sorted(allowed))}"


def path_faults():
    """A comment that names a file of the program's, from app/ or from the root, names one that is there."""
    tops = {folder.name for base in (ROOT, APP) for folder in base.iterdir() if folder.is_dir()} - {"build"}
    sources = [file for top in ("app", "shaders", "tests", "cmake") for file in sorted((ROOT / top).rglob("*.*"))]
    for file in [file for file in sources if re.search(r"\.(h|cpp|py|mjs|js|vert|frag|glsl|cmake|in)$", file.name)]:
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            comment = re.search(r"//.*|^\s*# .*|$", line)[0]
            for path, top in PATH.findall(comment):
                if top in tops and not (APP / path).exists() and not (ROOT / path).exists():
                    yield f"{file.relative_to(ROOT)}:{number}: there is no {path}"


def test_faults(rooms):
    for file in sorted(TESTS.rglob("*_test.cpp")):
        if (room := str(file.parent.relative_to(TESTS))) not in rooms:
            yield f"{file.relative_to(ROOT)}: tests are laid out as app/ is, and {TABLE.name} has no room {room}"


def circles(files):
    """The strongly connected parts of more than one unit, by Tarjan's algorithm."""
    graph = {}
    for file in files:
        unit = file.relative_to(APP).with_suffix("")
        graph.setdefault(unit, set()).update(
            pathlib.Path(header).with_suffix("") for _, ours, header in includes(file) if ours)
    index, low, stack = {}, {}, []

    def visit(unit):
        index[unit] = low[unit] = len(index)
        stack.append(unit)
        for other in sorted(graph.get(unit, set()) - {unit}):
            if other not in index:
                yield from visit(other)
            if other in stack:
                low[unit] = min(low[unit], low[other])
        if low[unit] == index[unit]:
            part = stack[stack.index(unit):]
            del stack[stack.index(unit):]
            if len(part) > 1:
                yield part

    for unit in sorted(graph):
        if unit not in index:
            yield from visit(unit)


def main():
    rooms = table()
    files = sorted(file for file in APP.rglob("*") if file.suffix in {".h", ".cpp"})
    faults = [*table_faults(rooms), *include_faults(rooms, files), *test_faults(rooms), *pair_faults(files)]
    faults += path_faults()
    faults += [f"a circle of includes: {', '.join(map(str, part))}" for part in circles(files)]
    print("\n".join(faults) or f"{len(files)} files in {len(rooms)} rooms")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
