#!/usr/bin/env python3
"""README and docs show what works: every command in them is run, every scene drawn, and nothing that there is is left out.

A block that cannot run here says why in a comment above it, <!-- not run: … -->. A block of JSON with a file's name behind
`json` is that file, for the commands below it.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest
from dataclasses import dataclass

from support import NORMALSCOPE, SMALL, CommandTest, run

try:
    import yaml
except ImportError:
    yaml = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMANDS = ("capture", "sweep", "explain", "scenes", "lessons", "handout", "slides", "quiz", "animate", "compare", "check")

BLOCK = re.compile(
    r"(?:^ *<!-- not run: (?P<reason>[^\n]+) -->\n)?"
    r"^(?P<indent> *)```(?P<language>\S+)(?: (?P<file>\S+))?\n(?P<body>.*?)^(?P=indent)```$", re.M | re.S)
SPAN = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")

# In place of the program, for commands as they are shown: pictures are small where no size is given, and the window comes
# as far as to say that it has no display.
PROGRAM = """#!/bin/sh
case " $* " in
    *" --size "*) ;;
    " capture "* | " sweep "* | " handout "* | " quiz "* | " animate "*) set -- "$@" --size 160x120 ;;
esac
errors=$(mktemp)
trap 'rm -f "$errors"' EXIT
env -u DISPLAY -u WAYLAND_DISPLAY "$PROGRAM" "$@" 2>"$errors"
code=$?
cat "$errors" >&2
grep -q "^normalscope: no window: " "$errors" && exit 0
exit $code
"""
DEV = """#!/bin/sh
"$ROOT/dev" help | grep -q "^./dev $1 " || { echo "there is no ./dev $1" >&2; exit 1; }
"""


@dataclass
class Block:
    page: str
    line: int
    language: str
    file: str | None
    reason: str | None
    body: str

    def __str__(self):
        return f"{self.page}:{self.line}"


def pages(root=ROOT):
    return sorted([*root.glob("*.md"), *root.glob("docs/*.md")])


def blocks(page):
    text = page.read_text(encoding="utf-8")
    for found in BLOCK.finditer(text):
        body = "\n".join(line.removeprefix(found["indent"]) for line in found["body"].splitlines())
        yield Block(page.name, text.count("\n", 0, found.start("language")) + 1, found["language"], found["file"],
                    found["reason"], body)


def prose(page):
    """The page without its blocks."""
    return BLOCK.sub("", page.read_text(encoding="utf-8"))


def spans(page):
    """What stands between backticks; in a table, \\| is a bar."""
    return [span.replace("\\|", "|") for span in SPAN.findall(prose(page))]


def anchors(page):
    """The names of its headings, as forges make them."""
    headings = re.findall(r"^#+ (.*)$", prose(page), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(root):
    """Links in the pages of this folder to files or headings that there are none of."""
    for page in pages(root):
        for link in LINK.findall(prose(page)):
            if re.match(r"https?:", link):
                continue
            name, _, anchor = link.partition("#")
            target = page.parent / name if name else page
            if not target.exists() or (anchor and anchor not in anchors(target)):
                yield f"{page.relative_to(root)}: {link}"


def words_of(page):
    """Every word in the page's code, between backticks or in a block."""
    text = "\n".join([*spans(page), *(block.body for block in blocks(page))])
    return set(re.findall(r"[\w-]+", text))


class DocsTest(CommandTest):
    def setUp(self):
        super().setUp()
        for name, script in (("bin/normalscope", PROGRAM), ("work/dev", DEV)):
            (self.folder / name).parent.mkdir()
            self.file(name, script).chmod(0o755)
        self.folder /= "work"
        self.environment = {
            **os.environ, "PROGRAM": str(pathlib.Path(NORMALSCOPE).resolve()), "ROOT": str(ROOT),
            "PATH": f"{self.folder.parent / 'bin'}:{os.environ['PATH']}"}

    def shell(self, where, script):
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=self.folder, env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        self.assertEqual(done.returncode, 0, f"{where}:\n{script}\n{done.stdout}")

    def json_block(self, block):
        """A scene is drawn, a part of one as well, and a lesson step by step; a manifest is for the commands below it."""
        value = json.loads(block.body)
        file = self.file(block.file or "block.json", block.body)
        for step in range(len(value.get("steps", []))):
            self.assert_done("capture", f"{file}#{step + 1}", "--captions", "-o", self.folder / "block.png", *SMALL)
        if "checks" not in value and "steps" not in value:
            self.assert_done("capture", file, "-o", self.folder / "block.png", *SMALL)

    def cmake_block(self, block):
        self.file("CMakeLists.txt", "cmake_minimum_required(VERSION 3.20)\nproject(shown LANGUAGES NONE)\nenable_testing()\n"
                  + block.body)
        self.shell(block, f"cmake -S . -B build -DNormalscope_DIR='{ROOT}/cmake' -DNORMALSCOPE_PROGRAM=\"$PROGRAM\"\n"
                          "ctest --test-dir build --output-on-failure")

    def check(self, block):
        if block.language == "json":
            self.json_block(block)
        elif block.language == "sh":
            self.shell(block, block.body)
        elif block.language == "cmake":
            self.cmake_block(block)
        elif block.language == "yaml" and yaml:
            yaml.safe_load(block.body)

    def test_every_block(self):
        for page in pages():
            folder, self.folder = self.folder, self.folder / page.stem
            self.folder.mkdir()
            shutil.copy(folder / "dev", self.folder)
            for block in blocks(page):
                with self.subTest(str(block)):
                    self.assertIn(block.language, ("sh", "json", "cmake", "yaml", "mermaid", "text", "cpp", "html"))
                    if not block.reason and (block.language != "cmake" or shutil.which("cmake")):
                        self.check(block)
            for span in spans(page):
                # Not those that only say where a name goes: FILE, OUT.png, NAME#3, implicit-…
                if re.match(r"(normalscope|\./dev) ", span) and not re.search(r"[A-Z]{2}|[\[…]", span):
                    with self.subTest(f"{page.name}: {span}"):
                        self.shell(page.name, span)
            self.folder = folder

    def test_every_transform_and_surface_in_the_lists(self):
        listed = [span for span in spans(ROOT / "docs/scenes.md") if span.startswith('{"')]
        stack = [span for span in listed if re.match(r'\{"(scale|rotate|translate|shear|matrix)', span)]
        self.assertGreaterEqual(len(stack), 5)
        self.assert_done("capture", "-o", self.folder / "out.png", *SMALL, "--set", f"stack=[{', '.join(stack)}]")
        for key in ("borrow", "slice", "ray"):
            value = re.search(rf"^\| `{key}` \|.*?`(\{{.*?\}})`", prose(ROOT / "docs/scenes.md"), re.M)[1]
            self.assert_done("capture", "implicit-cone", "-o", self.folder / "out.png", *SMALL, "--set", f"{key}={value}")

    def test_links_lead_somewhere(self):
        self.assertEqual(list(broken_links(ROOT)), [])

    def test_the_map_names_what_there_is(self):
        """Each file that the architecture names, and in it whatever stands before: `make_frame` (`…/make_frame.cpp`)."""
        page = prose(ROOT / "docs/architecture.md")
        for name in re.findall(r"`([\w/.-]+(?:/|\.(?:cpp|h|py|md|txt|json|cmake)))`", page):
            self.assertTrue((ROOT / "app" / name).exists() or (ROOT / name).exists(), name)
        for name, file in re.findall(r"`(\w+)`\s+\(`([\w/.]+)`\)", page):
            self.assertRegex((ROOT / "app" / file).read_text(encoding="utf-8"), rf"\b{name}\b", file)


class CompleteTest(CommandTest):
    """What the program knows, the pages tell."""

    def known(self, *arguments):
        """What the program lists when it is given a name that it does not know."""
        message = run(*arguments).stderr.decode()
        found = re.search(r"(?:known(?: here)?:|expected one of) (.*?)(?:, found .*)?$", message)
        self.assertTrue(found, message)
        return set(re.findall(r"[\w-]+", found[1]))

    def assert_told(self, names, page):
        self.assertEqual(sorted(set(names) - words_of(ROOT / "docs" / page)), [], page)

    def test_options(self):
        options = set()
        for command in ("", *COMMANDS):
            text = run(*command.split(), "--help").stdout.decode()
            options |= set(re.findall(r"^  (?:-\w, |    )(--[a-z-]+)", text, re.M))
        page = ROOT / "docs/commands.md"
        table = [option for span in spans(page) for option in re.findall(r"--[a-z-]+", span)]
        self.assertEqual(sorted(set(table)), sorted(options))
        text = run("--help").stdout.decode()
        listed = re.findall(r"^  ([a-z]+) ", re.search(r"^Commands:\n(.*?)\n\n", text, re.M | re.S)[1], re.M)
        self.assertEqual(sorted(listed), sorted(COMMANDS))
        self.assert_told(listed, "commands.md")

    def test_scene_keys(self):
        setting = ("capture", "-o", os.devnull, "--set")
        keys = self.known(*setting, "nope=1")
        self.assert_told(keys, "scenes.md")
        for key in ("arrows", "camera", "light", "show", "borrow", "slice", "ray"):
            self.assert_told(self.known(*setting, f"{key}.nope=1"), "scenes.md")
        for key in ("rule", "mistake", "view", "color", "theme", "surface.shape", "arrows.at"):
            self.assert_told(self.known(*setting, f"{key}=nope"), "scenes.md")

    def test_functions(self):
        message = run("capture", "-o", os.devnull, "--set", "surface.formula=nope(x)").stderr.decode()
        message = run("capture", "-o", os.devnull, "--set", "surface.formula=nope(x)").stderr.decode()
        self.assert_told(re.findall(r"\w+", message.rsplit(": ", 1)[1]), "formulas.md")

    def test_tabs(self):
        tabs = self.known("capture", "-o", os.devnull, "--tab", "nope")
        for page in ("commands.md", "lessons.md"):
            self.assert_told(tabs, page)

    def test_lesson_keys(self):
        def lesson(**keys):
            step = {"caption": "A caption.", **keys}
            return self.file("lesson.json", json.dumps({"normalscope": 1, "lesson": "A lesson", "steps": [step]}))
        capture = ("capture", "-o", os.devnull)
        self.assert_told(self.known(*capture, lesson(nope=1)), "lessons.md")
        self.assert_told(self.known(*capture, lesson(question={"ask": "Why?", "nope": 1, "choices": [
            {"text": "A.", "right": True, "because": "So."}, {"text": "B.", "because": "No."}]})), "lessons.md")

    def test_manifest_keys(self):
        manifest = self.file("checks.json", json.dumps({
            "normalscope_check": 1, "checks": [{"scene": "split", "numbers": {"rank": 3}, "nope": 1}]}))
        self.assert_told(self.known("check", manifest), "continuous-integration.md")

    def test_numbers(self):
        numbers = json.loads(self.assert_done("capture", "implicit-cone", "--set", 'borrow={"azimuth": 0}', "--set", "probe=[0,0,0]",
                                              "-o", self.folder / "out.png", "--numbers", "-", *SMALL))
        self.assert_told(numbers, "commands.md")
        self.assert_told(numbers["probe"], "commands.md")
        self.assert_told(numbers["error_degrees"], "commands.md")


if __name__ == "__main__":
    unittest.main()
