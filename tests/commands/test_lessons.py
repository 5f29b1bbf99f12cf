#!/usr/bin/env python3
"""Every built-in lesson from end to end: each step is drawn, and its caption's numbers are those of the scene."""

import base64
import html.parser
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time
import unittest

from support import NORMALSCOPE, SMALL, CommandTest, colours, png_pixels, png_size, run

LESSONS = sorted((pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons").glob("*.json"))


def at(numbers, path):
    for key in path.split("."):
        numbers = numbers[int(key)] if isinstance(numbers, list) else numbers[key]
    return numbers


class LessonsTest(CommandTest):
    def test_each_step(self):
        # In their order: numbers without gaps, and letters for what came to stand between two.
        numbers = [lesson.stem.split("-")[0] for lesson in LESSONS]
        self.assertEqual(numbers, ["1", "1b", *map(str, range(2, 9))])
        for lesson, number in zip(LESSONS, numbers):
            self.assertTrue(json.loads(lesson.read_text())["lesson"].startswith(f"{number}. "), lesson)
        said = ""
        for lesson in LESSONS:
            steps = json.loads(lesson.read_text())["steps"]
            self.assertTrue(5 <= len(steps) <= 12, lesson)
            for i, step in enumerate(steps, 1):
                with self.subTest(lesson=lesson.stem, step=i):
                    out = self.folder / "numbers.json"
                    self.assert_done("capture", f"{lesson.stem}#{i}", "-o", self.folder / "a.png", *SMALL, "--numbers", out)
                    numbers = json.loads(out.read_text())
                    for path, value in step.get("numbers", {}).items():
                        self.assertAlmostEqual(at(numbers, path), value, delta=5e-4, msg=path)
                    # An angle with a decimal is a result, and must not be a mere claim.
                    words = step["caption"] + step.get("look_at", "")
                    for angle in re.findall(r"(\d+\.\d)°", words):
                        self.assertIn(float(angle), [round(value, 1) for value in step.get("numbers", {}).values()])
                    said += words
        self.assertIn("61.9°", said)
        self.assertIn("36.9°", said)

    def test_the_list(self):
        text = self.assert_done("lessons").decode()
        self.assertEqual([line.split()[0] for line in text.splitlines()], [lesson.stem for lesson in LESSONS])

    def test_lessons_of_ones_own(self):
        data = self.folder / "data/normalscope/lessons"
        data.mkdir(parents=True)
        env = {"XDG_DATA_HOME": str(self.folder / "data")}
        def lesson(name, about):
            return self.file(name, json.dumps({"lesson": "L", "about": about, "steps": [{"caption": "a"}]}))
        (self.folder / "own").mkdir()
        lesson("data/normalscope/lessons/first.json", "of the user")
        lesson("own/second.json", "of a course")
        self.scene().rename(self.folder / "own/scene.json")
        def listed(*arguments, **options):
            return [line.split()[0] for line in run("lessons", *arguments, env=env, **options).stdout.decode().splitlines()]
        built_in = [lesson.stem for lesson in LESSONS]
        self.assertEqual(listed(), [*built_in, str(data / "first.json")])
        own = self.folder / "own"
        self.assertEqual(listed("--lessons", own), [*built_in, str(own / "second.json"), str(data / "first.json")])
        self.file("own/broken.json", '{"lesson": "B",\n "steps": []}')
        done = run("lessons", "--lessons", own, env=env)
        self.assertEqual((done.returncode, len(done.stdout.splitlines())), (3, len(built_in) + 2))
        self.assertRegex(done.stderr.decode(), r"\Anormalscope: [^\n]*broken.json, line 2: steps: expected [^\n]*\n\Z")
        self.assert_fails(3, "lessons", "--lessons", self.folder / "none", says="--lessons wants one", env=env)
        self.assert_fails(3, "--lessons", self.folder / "none", says="--lessons wants one", env=env)

    def test_lessons_are_checked(self):
        self.assertIn(b"10 steps, all is well", self.assert_done("lessons", "--check", LESSONS[0].stem))
        steps = [{"caption": "a", "scene": {"stack": [{"scale": [1, 2, 1]}]}, "numbers": {"error_degrees.bound": 40, "condition": 2}},
                 {"caption": "word " * 79, "look_at": "word " * 47, "equations": ["x = 1", "y = 2", "z = 3"],
                  "question": {"ask": "word " * 47, "choices": [
                      {"text": "word " * 17, "right": i == 0, "because": "word " * 47} for i in range(5)]}}]
        file = self.file("mine.json", json.dumps({"lesson": "Mine", "steps": steps}))
        result = run("lessons", "--check", file)
        self.assertEqual(result.returncode, 1)
        lines = result.stdout.decode().splitlines()
        self.assertIn("mine.json, step 1: error_degrees.bound is 36.86", lines[0])
        self.assertNotIn("condition", lines[0])
        for line in lines[1:]:
            self.assertRegex(line, r"mine.json, step 2: its words leave the picture less than half of a \d+x\d+ screen")
        self.assertGreater(len(lines), 1)

    def test_errors(self):
        lesson = {"lesson": "Mine", "steps": [{"caption": "a"}, {"caption": "b", "scene": {"colour": "red"}}]}
        file = self.file("mine.json", json.dumps(lesson, indent=1))
        out = self.folder / "out.png"
        self.assert_fails(3, "capture", file, "-o", out, says=("mine.json, line 10, step 2", "scene.colour: unknown key"))
        self.assert_fails(3, "capture", f"{LESSONS[0].stem}#99", "-o", out, says=("steps 1 to",))
        self.assert_fails(3, "handout", "none", "-o", self.folder / "out.html", says=(LESSONS[0].stem,))
        self.assert_fails(2, "handout", LESSONS[0].stem, says=("--output",))
        self.assertFalse(out.exists())

    def test_any_script(self):
        """Letters that the program's own fonts lack come from the machine's, where there are any."""
        def picture(caption, **env):
            lesson = self.file("a.json", json.dumps({"lesson": "a", "steps": [{"caption": caption}]}))
            self.assert_done("capture", f"{lesson}#1", "-o", self.folder / "a.png", "--captions", *SMALL, env=env)
            return (self.folder / "a.png").read_bytes()

        none = self.file("fonts.conf", "<?xml version='1.0'?><fontconfig></fontconfig>")
        for letter in "法नไ":
            self.assertEqual(picture(letter, FONTCONFIG_FILE=str(none)), picture("?"), letter)
            if not shutil.which("fc-list") or not subprocess.check_output(["fc-list", f":charset={ord(letter):x}:outline=True"]):
                continue
            self.assertNotEqual(picture(letter), picture("?"), letter)

    def test_steps_that_are_none(self):
        out = ("-o", self.folder / "out.png")
        mine = self.file("mine.json", json.dumps({"lesson": "Mine", "steps": [{"caption": "a"}, {"caption": "b"}]}))
        for lesson, count in ((LESSONS[0].stem, len(json.loads(LESSONS[0].read_text())["steps"])), (mine, 2)):
            for step in ("0", "x", "99", "", "-1", "1.5", "9" * 40):
                self.assert_fails(3, "capture", f"{lesson}#{step}", *out, says=(f"{lesson}#{step}: ", f"steps 1 to {count}"))
        self.assert_fails(3, "capture", f"{self.scene()}#1", *out, says="is a scene, which has no steps")
        self.assert_fails(3, "capture", f"{self.file('bad.json', '{')}#1", *out, says=("bad.json", "not valid JSON"))
        self.assert_fails(3, "capture", f"{self.folder}/none.json#1", *out, says=("none.json", "No such file"))
        self.assert_done("capture", self.file("a#2.json", self.scene().read_text()), *out, *SMALL)

    def test_a_file_is_read_once(self):
        """A pipe gives its content once: who opens it again waits for ever."""
        lesson = {"lesson": "Mine", "steps": [{"caption": "a"}, {"caption": "b", "scene": {"rule": "naive"}}]}
        pipe, out = self.folder / "pipe.json", self.folder / "out"
        os.mkfifo(pipe)
        for command in (("capture", f"{pipe}#2", "--captions", "-o", f"{out}.png", *SMALL), ("explain", pipe),
                        ("sweep", f"{pipe}#1", "--captions", "--vary", "camera.azimuth=0:9:2", "-o", f"{out}-%d.png", *SMALL),
                        ("handout", pipe, "-o", f"{out}.html", *SMALL)):
            with subprocess.Popen([NORMALSCOPE, *map(str, command)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL) as child:
                pipe.write_text(json.dumps(lesson))
                try:
                    self.assertEqual(child.wait(timeout=100), 0, command)
                finally:
                    child.kill()

    def test_standard_input(self):
        lesson = {"lesson": "Mine", "steps": [{"caption": "a"}, {"caption": "b", "scene": {"rule": "naive"}}]}
        scene = self.scene(rule="naive")
        for given in (scene, self.file("mine.json", json.dumps(lesson))):
            with open(given, "rb") as stdin:
                self.assertEqual(self.capture("-", stdin=stdin), self.capture(given), given)
        for text, says in (("", "empty"), ("{", "standard input: not valid JSON"), ('{"rule": 3}', "standard input: rule")):
            with open(self.file("text", text), "rb") as stdin:
                self.assert_fails(3, "capture", "-", "-o", self.folder / "out.png", stdin=stdin, says=says)

    def test_a_lesson_of_ones_own_finds_its_mesh(self):
        (self.folder / "deep").mkdir()
        self.file("deep/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        file = self.file("deep/mine.json", json.dumps(
            {"lesson": "Mine", "steps": [{"caption": "a", "scene": {"surface": {"mesh": "t.obj"}}}]}))
        self.assert_done("capture", file, "-o", self.folder / "a.png", *SMALL, notes=("t.obj has no normals",))

    def test_the_handout_is_one_page(self):
        lesson = LESSONS[0]
        steps = json.loads(lesson.read_text())["steps"]
        page = self.assert_done("handout", lesson.stem, "-o", "-", "--size", "160x100").decode()
        self.assertEqual(page.count("src=\"data:image/png;base64,"), len(steps))
        self.assertNotRegex(page, r"(src|href)=\"(?!data:)")
        self.assertIn("n</i><sub>naive</sub>", page)
        for step in steps:
            self.assertIn(step["caption"], page)

    def test_handouts_with_answers_and_notes_where_they_are_wanted(self):
        lesson = self.file("mine.json", json.dumps({"lesson": "Mine", "steps": [
            {"caption": "a", "notes": "Ask <first>.", "question": {"ask": "Which?", "choices": [
                {"text": "one", "right": True, "because": "So it is."}, {"text": "two", "because": "No."}]}},
            {"caption": "b"}]}))
        def page(*arguments):
            return self.assert_done("handout", lesson, "-o", "-", *SMALL, *arguments).decode()
        self.assertLess(page().index("Answers"), page().index("So it is."))
        self.assertNotIn("So it is.", page("--answers", "none"))
        inline = page("--answers", "inline")
        self.assertLess(inline.index("So it is."), inline.index("2. b"))
        self.assertNotIn("Ask &lt;", page())
        self.assertIn("Ask &lt;first&gt;.", page("--notes"))
        self.assert_fails(2, "handout", lesson, "-o", "-", "--answers", "some", says=("expected end, inline or none",))

    def test_a_steps_tab_is_shown(self):
        """Below the picture on paper, beside it on a slide; with nothing to press, it is the same whatever was pressed before."""
        def lesson(**keys):
            return self.file("tab.json", json.dumps({"lesson": "Tab", "steps": [{"caption": "a", **keys}, {"caption": "b"}]}))
        for tab in ("derivation", "derivation#3", "derivation:numbers", "stack", "maps", "error", "ray"):
            page = self.assert_done("handout", lesson(tab=tab), "-o", "-", "--size", "320x200").decode()
            pictures = [base64.b64decode(found) for found in re.findall(r'src="data:image/png;base64,([^"]*)"', page)]
            self.assertEqual(len(pictures), 3, tab)
            width, height = png_size(pictures[1])
            self.assertTrue(420 < width < 480 and 60 < height, (tab, width, height))
            self.assertGreater(colours(pictures[1]), 20)
            self.assertEqual(len({pixel for row in png_pixels(pictures[1])[-8:] for pixel in row}), 1, f"{tab} is cut off")
        def slide(name, **keys):
            self.assert_done("slides", lesson(**keys), "-o", self.folder / name, "--size", "320x180")
            return [(self.folder / name / f"0{i}.png").read_bytes() for i in (1, 2)]
        with_tab, without = slide("one", tab="stack"), slide("two")
        self.assertNotEqual(with_tab[0], without[0])
        self.assertEqual(with_tab[1], without[1])
        # Beside a picture, and in a video, all of it is in the picture, too: words stand in as many columns as that takes.
        self.assert_done("slides", lesson(tab="derivation:numbers"), "-o", self.folder / "long", "--size", "960x540")
        self.assert_done("capture", f"{lesson(tab='stack')}#1", "--captions", "-o", self.folder / "captions.png", "--size", "960x540")
        for picture in (self.folder / "long" / "01.png", self.folder / "captions.png"):
            rows = png_pixels(picture.read_bytes())
            right = {pixel for row in rows[-4:] for pixel in row[700:]}
            self.assertEqual(len(right), 1, f"{picture} is cut off")
            self.assertGreater(len({pixel for row in rows for pixel in row[700:]}), 50)

    def test_a_handout_of_all_lessons(self):
        page = self.assert_done("handout", "all", "-o", "-", "--size", "96x60").decode()
        self.assertEqual(page.count("<article>"), len(LESSONS))

    def test_slides(self):
        folder = self.folder / "slides"
        self.assert_done("slides", LESSONS[0].stem, "-o", folder, "--size", "160x90")
        steps = json.loads(LESSONS[0].read_text())["steps"]
        pictures = [f"{i:02}.png" for i in range(1, len(steps) + 1)]
        self.assertEqual(sorted(p.name for p in folder.iterdir()), [*pictures, "index.html"])
        page = (folder / "index.html").read_text()
        for step, picture in zip(steps, pictures):
            self.assertIn(step["caption"], page)
            self.assertIn(f'src="{picture}"', page)
        before = (folder / "01.png").read_bytes()
        self.assert_fails(3, "slides", LESSONS[1].stem, "-o", folder, "--size", "160x90", says=("holds something already",))
        self.assertEqual((folder / "01.png").read_bytes(), before)
        self.assert_fails(3, "slides", LESSONS[1].stem, "-o", folder / "01.png", says=("is a file",))

    def test_slides_that_were_cancelled_leave_nothing(self):
        folder = self.folder / "slides"
        child = subprocess.Popen([NORMALSCOPE, "slides", LESSONS[0].stem, "-o", folder, "--size", "1920x1080"], stderr=subprocess.PIPE)
        while not list(folder.glob("*/01.png")):
            self.assertIsNone(child.poll())
            time.sleep(0.01)
        child.send_signal(signal.SIGINT)
        _, said = child.communicate(timeout=60)
        self.assertEqual((child.returncode, list(folder.iterdir())), (130, []))
        self.assertEqual(said.decode().splitlines()[-1], "normalscope: cancelled; no slides were written")
        self.assert_done("slides", LESSONS[0].stem, "-o", folder, "--size", "160x90")

    def live(self, page, *arguments):
        """A live handout by an installed program, with this text as the program's page."""
        program, share = self.folder / "bin/normalscope", self.folder / "share/normalscope"
        for folder in (program.parent, share):
            folder.mkdir(parents=True, exist_ok=True)
        shutil.copy(NORMALSCOPE, program)
        if page is not None:
            (share / "normalscope.html").write_text(page)
        return subprocess.run([program, "handout", *map(str, arguments), "--live", *SMALL], capture_output=True, check=False)

    def test_live_handouts_hold_the_program_once(self):
        evil = "\"'><script>alert(1)</script>"
        self.file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")
        lesson = self.file("mine.json", json.dumps({"lesson": evil, "about": evil, "steps": [
            {"caption": evil, "scene": {"surface": {"mesh": "t.obj"}}}, {"caption": "b", "scene": {"rule": "naive"}},
            {"caption": "c", "scene": {"surface": {"shape": "cube"}}}]}))
        program = "<!DOCTYPE html>\n<script>const a = '\x01\u0100&amp;\"<!--<script>@FILES@';</script>\n"
        done = self.live(program, lesson, "-o", "-")
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        found = []
        parser = html.parser.HTMLParser()
        parser.handle_starttag = lambda tag, attributes: found.append((tag, dict(attributes)))
        parser.feed(done.stdout.decode())
        tags = [tag for tag, _ in found]
        self.assertEqual((tags.count("img"), tags.count("iframe"), tags.count("script")), (3, 1, 1))
        frame = dict(found)["iframe"]
        self.assertEqual(frame["data-page"], program)
        self.assertEqual(frame["sandbox"], "allow-scripts allow-downloads")
        self.assertEqual(list(json.loads(frame["data-files"])), ["1-t.obj"])
        scenes = [attributes["data-scene"] for tag, attributes in found if tag == "img"]
        self.assertEqual(self.numbers(scenes[2])["M"], self.numbers(lesson.with_name("mine.json#3"))["M"])
        self.assertNotRegex(done.stdout.decode(), r"<[^>]* (src|href)=\"(?!data:)")

    def test_live_handouts_want_the_page(self):
        out = self.folder / "out.html"
        done = self.live(None, LESSONS[0].stem, "-o", out)
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr.decode(), r"\Anormalscope: normalscope\.html: [^\n]*; put it there, or build it by ./dev web\n\Z")
        self.assertFalse(out.exists())
        page = self.folder / "share/normalscope/normalscope.html"
        self.assertEqual(self.live("the program", LESSONS[0].stem, "-o", page).returncode, 2)
        self.assertEqual(page.read_text(), "the program")


def heights_of_lines(pixels):
    """Of the rows of the column of words, at a picture's right, that hold ink, those together; from the lowest up to where the
    ground is no longer that of the lowest."""
    ground = pixels[-1][-2]
    start = max(x for x, pixel in enumerate(pixels[-1]) if pixel != ground) + 1
    lines, height = [], 0
    for row in reversed(pixels):
        if row[-2] != ground:
            break
        if any(sum(abs(a - b) for a, b in zip(pixel, ground)) > 200 for pixel in row[start:]):
            height += 1
        elif height:
            lines.append(height)
            height = 0
    return lines[::-1]


class LettersTest(CommandTest):
    def test_large_enough_for_the_last_row(self):
        # What a lecture shows, measured in the picture. A capital of Open Sans is 0.714 of its size high: 25 pixels where
        # letters are of 36. The title, the caption, the equation, the question, its choices.
        lesson = self.file("h.json", json.dumps({"lesson": "H", "steps": [
            {"caption": "H", "equations": ["H"], "look_at": "H", "question": {"ask": "H", "choices": [
                {"text": "H", "right": True, "because": "H"}, {"text": "H", "because": "H"}]}}]}))
        for size, least in (("1920x1080", 25), ("1024x768", 13)):
            self.assert_done("animate", lesson, "-o", self.folder / f"{size}-%d.png", "--size", size, "--fps", 1, "--seconds", 1)
            lines = heights_of_lines(png_pixels((self.folder / f"{size}-0.png").read_bytes()))
            self.assertGreaterEqual(len(lines), 5, (size, lines))
            self.assertGreaterEqual(min(lines), least - 1, (size, lines))  # an edge's row may be too pale to count


class AnimateTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.lesson = self.file("two.json", json.dumps({"lesson": "Two", "steps": [
            {"caption": "a", "scene": {"stack": [{"scale": [1, 1, 1]}]}},
            {"caption": "b", "scene": {"stack": [{"scale": [1, 3, 1]}]}}]}))
        self.out = self.folder / "out"
        self.out.mkdir()

    def names(self):
        return sorted(path.name for path in self.out.iterdir())

    def test_pictures(self):
        # A second of each step, and 0.9 s between them.
        self.assert_done("animate", self.lesson, "-o", self.out / "%02d.png", *SMALL, "--fps", 10, "--seconds", 1)
        self.assertEqual(self.names(), [f"{i:02}.png" for i in range(28)])
        pictures = [(self.out / name).read_bytes() for name in self.names()]
        self.assertEqual(len(set(pictures[:10])), 1)
        self.assertEqual(len(set(pictures[18:])), 1)
        self.assertEqual(len(set(pictures[9:19])), 10)

    def film(self, *steps, arguments=()):
        """The pictures of these steps, one a second, and their subtitles as (from, to, words)."""
        lesson = self.file("film.json", json.dumps({"lesson": "Film", "steps": steps}))
        subtitles = self.folder / "film.vtt"
        shutil.rmtree(self.out)
        self.assert_done("animate", lesson, "-o", self.out / "%03d.png", *SMALL, "--fps", 1, "--subtitles", subtitles, *arguments)
        found = re.findall(r"^\d+\n(\d\d):(\d\d):(\d\d\.\d{3}) --> (\d\d):(\d\d):(\d\d\.\d{3})\n(.*)\n\n", subtitles.read_text(), re.M)
        seconds = lambda h, m, s: 3600 * int(h) + 60 * int(m) + float(s)
        return ([(self.out / name).read_bytes() for name in self.names()],
                [(seconds(*cue[:3]), seconds(*cue[3:6]), cue[6]) for cue in found])

    def test_a_step_stands_as_long_as_its_words_take_to_read(self):
        words = "word " * 17 + "word."  # 90 characters: 6 s
        pictures, cues = self.film({"caption": words}, {"caption": "a < b."}, {"caption": "c", "seconds": 9})
        self.assertEqual(cues, [(0, 6, words), (6, 9, "a &lt; b."), (9, 18, "c")])
        self.assertEqual(len(pictures), 18)
        self.assertEqual(self.film({"caption": "M_3^{-1} M_3."})[1], [(0, 3, "M₃⁻¹ M₃.")])
        self.assertEqual(self.film({"caption": "One. Two."}, arguments=("--seconds", 2))[1], [(0, 0.889, "One."), (0.889, 2, "Two.")])

    def test_a_path_is_shown_before_a_step_stands(self):
        pictures, cues = self.film({"caption": "a", "scene": {"stack": [{"scale": [1, 1, 1]}]}},
                                   {"caption": "b", "path": {"stack.0.scale.1": [1, 3]}})
        self.assertEqual((len(pictures), cues), (9, [(0, 3, "a"), (6, 9, "b")]))
        self.assertEqual([len(set(pictures[a:b])) for a, b in ((0, 3), (3, 7), (6, 9))], [1, 4, 1])

    def test_a_question_waits_and_is_answered(self):
        question = {"ask": "Which?", "choices": [{"text": "one", "because": "No."}, {"text": "two", "right": True, "because": "So it is."}]}
        pictures, cues = self.film({"caption": "a", "question": question}, {"caption": "b"})
        self.assertEqual(cues[-2:], [(8.857, 11, "So it is."), (11, 14, "b")])
        self.assertEqual([len(set(pictures[a:b])) for a, b in ((0, 8), (8, 11), (0, 11))], [1, 1, 2])

    def test_what_asks_for_a_mouse_is_left_out(self):
        plain = self.film({"caption": "a"})[0]
        self.assertEqual(self.film({"caption": "a", "try": "Drag."})[0], plain)
        self.assertNotEqual(self.film({"caption": "a", "look_at": "Look."})[0], plain)
        self.assertNotIn("Drag.", self.assert_done("handout", self.file("try.json", json.dumps(
            {"lesson": "Try", "steps": [{"caption": "a", "try": "Drag."}]})), "-o", "-", *SMALL).decode())

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_videos(self):
        for name, magic in (("v.gif", b"GIF89a"), ("v.mp4", b"ftyp"), ("v.webm", b"\x1aE\xdf\xa3")):
            self.assert_done("animate", self.lesson, "-o", self.out / name, *SMALL, "--fps", 4, "--seconds", 1)
            self.assertIn(magic, (self.out / name).read_bytes()[:16])
        self.assertEqual(self.names(), ["v.gif", "v.mp4", "v.webm"])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_cancel_leaves_nothing(self):
        # While it draws, and while ffmpeg works.
        for waits_for in ("000000.png", "ffmpeg.log"):
            child = subprocess.Popen([NORMALSCOPE, "animate", self.lesson, "-o", self.out / "v.webm", "--fps", "60",
                                      "--size", "640x480", "--seconds", "3"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            while not list(self.out.glob(f"*/{waits_for}")):
                self.assertIsNone(child.poll())
                time.sleep(0.01)
            child.send_signal(signal.SIGINT)
            _, said = child.communicate(timeout=60)
            self.assertEqual((child.returncode, self.names()), (130, []))
            self.assertEqual(said.decode().splitlines()[-1], "normalscope: cancelled; no video was written")

    def test_errors(self):
        self.assert_fails(2, "animate", self.lesson, "-o", self.out / "v.avi", says="--output")
        self.assert_fails(2, "animate", self.lesson, "-o", self.out / "v.gif", "--fps", 0, says="--fps")
        self.assert_fails(2, "animate", self.lesson, "-o", self.out / "v.gif", "--subtitles", self.out / "v.txt", says=".vtt or .srt")
        self.assert_fails(2, "animate", self.lesson, "-o", self.out / "v.vtt", "--subtitles", self.out / "v.vtt", says="--output")
        self.assert_fails(3, "animate", "none", "-o", self.out / "v.gif", says=LESSONS[0].stem)
        self.assert_fails(3, "animate", self.lesson, "-o", self.out / "v.gif", env={"PATH": "/none"},
                          says="install the package ffmpeg")
        (self.out / "file").write_text("")
        self.assert_fails(3, "animate", self.lesson, "-o", self.out / "file" / "%d.png", says=("file", "a folder is wanted"))
        self.assertEqual(self.names(), ["file"])


class LinksTest(CommandTest):
    def test_a_damaged_link(self):
        for link, words in (("normalscope:1.AAAA", "checksum"), ("normalscope:2.AAAA", "newer version"),
                            ("normalscope:", "cut off")):
            self.assert_fails(3, "capture", link, "-o", self.folder / "a.png", says=("link: ", words))


if __name__ == "__main__":
    unittest.main()
