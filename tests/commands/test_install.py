#!/usr/bin/env python3
"""What `cmake --install` installs: a program that runs, its manual and completion, and one line an image test for others."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from support import NORMALSCOPE, SMALL, CommandTest, run
from test_docs import broken_links, pages

BUILD = pathlib.Path(NORMALSCOPE).resolve().parent


@unittest.skipUnless(shutil.which("cmake") and (BUILD / "cmake_install.cmake").exists(), "not run from a build folder")
class InstallTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.prefix = self.folder / "prefix"
        self.cmake("cmake", "--install", BUILD, "--prefix", self.prefix)

    def cmake(self, *command, code=0):
        done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout

    def test_the_program_runs(self):
        out = self.folder / "out.png"
        environment = {name: os.environ[name] for name in ("GALLIUM_DRIVER", "LP_NATIVE_VECTOR_WIDTH", "LSAN_OPTIONS") if name in os.environ}
        subprocess.run([self.prefix / "bin/normalscope", "capture", "-o", out, *SMALL], env=environment, check=True)
        self.assertEqual(out.read_bytes(), self.capture())

    @unittest.skipUnless((BUILD / "web/normalscope.html").exists(), "./dev web has not been run")
    def test_live_handouts_find_the_page(self):
        out = self.folder / "live.html"
        subprocess.run([self.prefix / "bin/normalscope", "handout", "2-gradients", "-o", out, "--live", *SMALL], check=True)
        self.assertGreater(out.stat().st_size, (BUILD / "web/normalscope.html").stat().st_size)

    def test_the_pages_find_one_another(self):
        doc = self.prefix / "share/doc/normalscope"
        self.assertIn("scenes.md", [page.name for page in pages(doc)])
        self.assertEqual(list(broken_links(doc)), [])
        self.assertTrue((doc / "LICENSE").exists())

    def test_manual_and_completion_know_every_option(self):
        share = self.prefix / "share"
        texts = [(share / path).read_text().replace("\\-", "-") for path in
                 ("man/man1/normalscope.1", "bash-completion/completions/normalscope", "zsh/vendor-completions/_normalscope")]
        for command in ("capture", "sweep", "check", "compare", "explain"):
            for line in run(command, "--help").stdout.decode().splitlines():
                for word in line.split():
                    if line.startswith("  ") and word.startswith("--") and line.index(word) < 8:
                        for text in texts:
                            self.assertIn(word, text)
        if shutil.which("man"):
            page = subprocess.run(["man", "--warnings", "-l", share / "man/man1/normalscope.1"], capture_output=True, text=True, check=True)
            self.assertEqual(page.stderr, "")
            self.assertIn("EXIT STATUS", page.stdout)
        subprocess.run(["bash", "-n", share / "bash-completion/completions/normalscope"], check=True)

    def test_completion_offers_the_words_that_are_taken(self):
        def offered(*words):
            script = (f"source {self.prefix}/share/bash-completion/completions/normalscope; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
                      "_normalscope; printf '%s\\n' \"${COMPREPLY[@]}\"")
            done = subprocess.run(["bash", "-c", script, "bash", "normalscope", *words], capture_output=True, text=True, check=True,
                                  cwd=self.folder, env={**os.environ, "PATH": f"{self.prefix}/bin:{os.environ['PATH']}"})
            return done.stdout.split()
        for command, option in (("capture", "context"), ("capture", "ground"), ("capture", "tab"), ("capture", "samples"), ("explain", "format")):
            arguments = ["-o", "x.png"] if command == "capture" else []
            says = run(command, *arguments, f"--{option}", "wrong").stderr.decode().rsplit(": ", 1)[1]
            self.assertEqual(sorted(offered(command, f"--{option}", "")), sorted(set(re.findall(r"\w+", says)) - {"expected", "or"}), option)
        self.assertEqual(offered("handout", "2"), ["2-gradients"])
        self.assertEqual(offered("capture", "shea"), ["shear"])
        self.file("a file.json", "{}")
        self.assertEqual(" ".join(offered("capture", "a ")), "a file.json")

    def test_a_project_with_one_line_a_test(self):
        project, build = self.folder / "project", self.folder / "build"
        project.mkdir()
        (project / "CMakeLists.txt").write_text("""cmake_minimum_required(VERSION 3.20)
project(wing LANGUAGES NONE)
enable_testing()
find_package(Normalscope 0.1 REQUIRED)
normalscope_test(good split REFERENCE good.png SIZE 160x120)
normalscope_test(bad split REFERENCE good.png SET theme=dark rule=naive SIZE 160x120 TOLERANCE 9 SHARE 0.2 PERCEPTUAL)
normalscope_test(render/wing "a scene.json" REFERENCE "a reference.png" SIZE 160x120)
normalscope_test("with spaces" "a lesson.json#1" REFERENCE good.png SIZE 160x120 TOLERANCE 255)
normalscope_test(gone gone.json REFERENCE good.png SIZE 160x120)
""")
        (project / "a scene.json").write_text('{"normalscope": 1}')
        (project / "a lesson.json").write_text('{"normalscope": 1, "lesson": "t", "about": "a", "steps": [{"scene": {}, "caption": "c"}]}')
        (project / "a reference.png").write_bytes(self.capture(project / "a scene.json"))
        (project / "good.png").write_bytes(self.capture("split"))
        self.cmake("cmake", "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        report = self.cmake("ctest", "--test-dir", build, "--output-on-failure", code=8)
        self.assertIn("60% tests passed, 2 tests failed out of 5", report)
        self.assertIn("differ: ", report)
        self.assertIn(f"normalscope: {project}/gone.json: ", report)
        self.assertEqual(sorted(p.name for p in (build / "normalscope").iterdir()),
                         ["bad.difference.png", "bad.expected.png", "bad.png", "good.png", "render", "with spaces.png"])
        self.assertEqual([p.name for p in (build / "normalscope/render").iterdir()], ["wing.png"])


if __name__ == "__main__":
    unittest.main()
