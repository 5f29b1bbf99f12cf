#!/usr/bin/env python3
"""Where a context comes from, and exit code 4 where none can be made."""

import json
import pathlib
import resource
import unittest

from support import SMALL, CommandTest, run

NO_OSMESA = {"NORMALSCOPE_OSMESA_LIBRARY": "/nonexistent"}
NO_EGL = {"NORMALSCOPE_EGL_LIBRARY": "/nonexistent"}
LIBRARIES_SAY = (b"LLVM ERROR: out of memory", b"LLVM ERROR: Unable to allocate section memory!", b"Allocation failed",
                 b"libgcc_s.so.1 must be installed for unwinding to work",  # says the C library, that finds no room to load it
                 b"terminate called after throwing an instance of 'std::bad_alloc'",
                 b"terminate called after throwing an instance of 'St9bad_alloc'",  # nor has it the memory to write the name
                 b"  what():  std::bad_alloc")
NO_DISPLAY = {"DISPLAY": None, "WAYLAND_DISPLAY": None, "WAYLAND_SOCKET": None}


class ContextTest(CommandTest):
    def test_the_numbers_say_which(self):
        self.assertEqual(self.numbers("--context", "osmesa")["context"], "osmesa")
        self.assertEqual(self.numbers()["context"], "osmesa")

    def test_without_osmesa(self):
        self.assert_fails(4, "capture", "-o", self.folder / "out.png", "--context", "osmesa", *SMALL, env=NO_OSMESA,
                          says=("OSMesa", "--context egl"))

    def test_auto_takes_egl_where_there_is_no_osmesa(self):
        self.assertEqual(self.numbers(env=NO_OSMESA)["context"], "egl")

    def test_without_egl(self):
        self.assertEqual(self.numbers(env=NO_EGL)["context"], "osmesa")
        self.assert_fails(4, "capture", "-o", self.folder / "out.png", "--context", "egl", *SMALL, env=NO_EGL,
                          says=("EGL", "--context osmesa"))

    def test_without_both(self):
        self.assert_fails(4, "capture", "-o", self.folder / "out.png", *SMALL, env={**NO_OSMESA, **NO_EGL},
                          says=("OSMesa: ", "EGL: ", "install libosmesa6, or install libegl1"))
        self.assert_fails(4, "sweep", "--vary", "camera.azimuth=0:9:4", "-o", f"{self.folder}/", "--jobs", "2", *SMALL,
                          env={**NO_OSMESA, **NO_EGL}, says="no graphics context")

    def test_a_driver_that_is_too_old(self):
        out = ("capture", "-o", self.folder / "out.png", *SMALL)
        for version in ("2.1", "3.0", "3.2"):
            for old, ways in (((), ("OSMesa: ", "EGL: ")), (("--context", "egl"), ("EGL: ", "or use --context osmesa"))):
                self.assert_fails(4, *out, *old, env={"MESA_GL_VERSION_OVERRIDE": version},
                                  says=(*ways, "OpenGL 3.3 is needed", "virtual machines", "LIBGL_ALWAYS_SOFTWARE=1"), lacks="install lib")
        # What is not there may know more.
        self.assert_fails(4, *out, env={"MESA_GL_VERSION_OVERRIDE": "3.0", **NO_OSMESA}, says=("EGL: it offers no", "install libosmesa6"),
                          lacks="is needed")

    def test_what_the_driver_would_crash_on(self):
        out = ("-o", self.folder / "out.png", *SMALL)
        for variables in ({"GALLIUM_DRIVER": "nope"}, {"LP_NATIVE_VECTOR_WIDTH": "7"}, {"LP_NATIVE_VECTOR_WIDTH": "0"},
                          {"GALLIUM_DRIVER": "zink"}, {"LP_NATIVE_VECTOR_WIDTH": "7", "GALLIUM_DRIVER": "nope"}):
            says = (*(f"{name}={value}" for name, value in variables.items()), "unset")
            for command in (("capture", *out), ("capture", *out, "--context", "osmesa"),
                            ("sweep", "--vary", "camera.azimuth=0:9:4", "-o", self.folder / "f-%d.png", "--jobs", "2", *SMALL),
                            ("handout", "2-gradients", "-o", self.folder / "h.html", *SMALL)):
                self.assert_fails(4, *command, env=variables, says=says)
        # EGL says itself that it has no such driver, and nothing else is said.
        self.assert_fails(4, "capture", *out, "--context", "egl", env={"GALLIUM_DRIVER": "nope"}, says="EGL")
        # On a processor without AVX-512 it crashes, and on some that have it.
        wide = {"LP_NATIVE_VECTOR_WIDTH": "512"}
        has_wide = "avx512f" in pathlib.Path("/proc/cpuinfo").read_text()
        if not has_wide or run("capture", *out, env=wide).returncode != 0:
            self.assert_fails(4, "capture", *out, env=wide, says="LP_NATIVE_VECTOR_WIDTH=512")
        self.assertEqual([p.name for p in self.folder.iterdir() if p.suffix != ".png"], [])

    @unittest.skipUnless("avx2" in pathlib.Path("/proc/cpuinfo").read_text(), "no vectors of 256 bits")
    def test_code_for_wide_vectors_is_not_taken_for_narrow_ones(self):
        kept = self.folder / "kept"
        kept.mkdir()
        for width in ("256", "128", "256"):
            done = run("sweep", "--vary", "camera.azimuth=0:9:3", "-o", self.folder / "f-%d.png", *SMALL,
                       env={"MESA_SHADER_CACHE_DIR": str(kept), "LP_NATIVE_VECTOR_WIDTH": width})
            self.assertEqual((done.returncode, done.stderr), (0, b""), width)
        self.assertEqual(sorted(p.name for p in (kept / "normalscope").iterdir()), ["shaders-128", "shaders-256"])

    def test_a_check_says_what_the_driver_would_crash_on(self):
        checks = self.file("c.json", json.dumps({"normalscope_check": 1, "checks": [{"scene": "split", "numbers": {"rank": 3}}]}))
        done = run("check", checks, "--junit", self.folder / "j.xml", env={"GALLIUM_DRIVER": "nope"})
        self.assertEqual((done.returncode, done.stdout), (4, b"0 of 1 checks pass, 1 was not run\n"))
        self.assertIn(b"GALLIUM_DRIVER=nope", done.stderr)
        self.assertIn("<skipped", (self.folder / "j.xml").read_text())

    def test_variables_that_do_no_harm(self):
        picture = self.capture("split")
        for name, value in (("GALLIUM_DRIVER", ""), ("MESA_SHADER_CACHE_DISABLE", "1"), ("LP_NUM_THREADS", "2"), ("EGL_LOG_LEVEL", "debug")):
            self.assertEqual(self.capture("split", env={name: value}), picture)

    def test_little_memory_is_said(self):
        def little():
            resource.setrlimit(resource.RLIMIT_AS, (600 << 20, 600 << 20))
        self.assert_fails(4, "capture", "--size", "8000x8000", "-o", self.folder / "out.png", preexec_fn=little, says=("out of memory", "smaller size"))

    def test_whatever_memory_there_is(self):
        out = self.folder / "out.png"
        for megabytes in range(50, 850, 50):
            def little():
                resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            done = run("capture", "-o", out, *SMALL, preexec_fn=little, env={"NORMALSCOPE_GL_DEBUG": None})
            self.assertIn(done.returncode, (0, 3, 4), (megabytes, done.stderr))
            # Where a library finds no memory it says so itself, in a line or two that nobody can stop, before we say it.
            ours = [line for line in done.stderr.splitlines() if line not in LIBRARIES_SAY]
            self.assertEqual(len(ours), 0 if done.returncode == 0 else 1, (megabytes, done.stderr))
            self.assertNotIn(b"bad_", done.stderr)

    def test_both_draw_the_same(self):
        for arguments in ((), ("split", "--panel"), ("error-map", "--samples", "1")):
            self.assertEqual(self.capture(*arguments, "--context", "osmesa"), self.capture(*arguments, "--context", "egl"))

    def test_a_display_is_not_needed(self):
        self.capture(env={**NO_DISPLAY, "HOME": None, "XDG_RUNTIME_DIR": None})
        self.capture(env={**NO_DISPLAY, "DISPLAY": ":4711"})

    def test_a_window_needs_a_display(self):
        self.assert_fails(4, env=NO_DISPLAY, says=("display", "capture"))
        self.assert_fails(4, "split", "--set", "rule=naive", env=NO_DISPLAY)
        self.assert_fails(4, env={**NO_DISPLAY, "DISPLAY": ":4711"}, says=":4711")

    def test_a_window_says_first_what_is_wrong_with_its_file(self):
        self.assert_fails(3, "none.json", env=NO_DISPLAY, says="none.json")
        self.assert_fails(2, "--set", "rule=right", env=NO_DISPLAY, says="rule")


if __name__ == "__main__":
    unittest.main()
