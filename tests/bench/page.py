"""The page in a browser: page_bench.mjs prints one line of JSON."""

import json
import os
import pathlib
import statistics
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MIB = 1 << 20


def page(bench, runs):
    build = pathlib.Path(bench.normalscope).resolve().parent
    file, modules = build / "web/normalscope.html", build / "web_tests"
    if not (file.exists() and (modules / "node_modules").exists()):
        bench.row("the page", "not built: ./dev web, ./dev test")
        return
    bench.progress("the page in Chromium")
    environment = {**os.environ, "NORMALSCOPE": bench.normalscope, "NORMALSCOPE_PAGE": str(file), "NORMALSCOPE_MODULES": str(modules)}
    output = subprocess.run(["node", SOURCE / "tests/bench/page_bench.mjs", str(runs)], env=environment, stdout=subprocess.PIPE,
                            check=True, text=True).stdout
    took = json.loads(output.strip().splitlines()[-1])

    def desktop(scene):
        program = bench.capture(scene)
        program.command[program.command.index("--size") + 1] = "960x600"
        return statistics.median(run.seconds for run in bench.turns([program], cold=False)[0])

    for way, goal in (("gzip", 1.4), ("brotli", 1.1)):
        bench.row(f"the page, {way}", f"{took[way] / 1e6:.2f} MB", goal=f"{goal} MB", reached=took[way] <= goal * 1e6)
    for what, key, scene, goal in (("the default scene drawn after navigation", "scene_ms", "slide-scale", 1.0),
                                   ("a traced formula drawn", "formula_ms", "implicit-torus", 2.0),
                                   ("  its first picture", "formula_first_ms", "implicit-torus", 1.0)):
        ours, theirs = took[key] / 1000, desktop(scene)
        bench.row(f"page: {what}", f"{ours:.2f} s", goal=f"{goal} s", reached=ours <= goal)
        bench.row("  against a warm capture by the desktop's program", f"{ours / theirs:.1f}")
    bench.row("page: frames while orbiting, with panel, 960x600", f"{took['frames_per_second']:.0f} / s", goal="30 / s",
              reached=took["frames_per_second"] >= 30)
    bench.row("page: frames in three idle seconds", str(took["idle_frames"]), goal="0", reached=took["idle_frames"] == 0)
    once, twice, thrice = took["heap"]
    bench.row("page: heap after all scenes and lessons", f"{once / MIB:.1f} MiB")
    # Each opening is a step to undo, of a kilobyte or two; the last 500 are kept.
    bench.row("  growth by the second time, and the third", f"{(twice - once) / MIB:.2f}, {(thrice - twice) / MIB:.2f} MiB",
              goal="what can be undone", reached=thrice - twice < 0.2 * MIB)
