"""Figures of many pictures: sweeps, warm captures, the same bytes everywhere, and a great many arrows."""

import itertools
import json
import pathlib
import shutil
import statistics
import subprocess

MIB = 1024  # KiB, as getrusage counts
FRAMES = 100


def sweep(bench, *arguments, frames=FRAMES, size="1280x720"):
    """A sweep as a program to run; its last picture shows that it did what it was asked for."""
    folder = bench.folder / "frames"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()  # for the log
    program = bench.capture()
    program.command = [bench.normalscope, "sweep", *map(str, arguments), "--vary", f"camera.azimuth=0:360:{frames}",
                       "-o", f"{folder}/", "--size", size]
    program.picture = folder / f"frame-{frames - 1:03}.png"
    return program


def sweep_against_f3d(bench, mesh, goal):
    """f3d starts anew for each picture: ten of its runs, before and after the sweep, stand for a hundred."""
    if not bench.theirs:
        return
    bench.progress("100 captures in one sweep")
    cache = {"MESA_SHADER_CACHE_DIR": str(bench.folder / "shaders-many")}
    theirs = bench.f3d(mesh)
    theirs.command = ["640,360" if word == "1280,720" else word for word in theirs.command]
    ours = sweep(bench, mesh, size="640x360")
    theirs.run(**cache)
    runs = [theirs.run(**cache) for _ in range(5)]
    one = ours.run(**cache)
    runs += [theirs.run(**cache) for _ in range(5)]
    for what, of in (("100 captures in one sweep, 640x360", lambda r: r.seconds), ("  processor time", lambda r: r.processor)):
        hundred = FRAMES * statistics.median(of(run) for run in runs)
        ratio = hundred / of(one)
        bench.row(what, f"{of(one):.2f} s", f"{hundred:.1f} s", f"1/{ratio:.1f}", f"1/{goal}", ratio >= goal)


def warm_capture(bench, goal):
    """What one more picture costs, PNG included: 50 of them are what two sweeps differ by."""
    bench.progress("a warm capture")
    costs = []
    for _ in range(3):
        short, long = (sweep(bench, frames=n).run() for n in (30, 80))
        costs.append(((long.seconds - short.seconds) / 50, (long.processor - short.processor) / 50))
    seconds = statistics.median(c[0] for c in costs)
    bench.row("warm capture, 1280x720, 4 samples, PNG", f"{1000 * seconds:.0f} ms", goal=f"{goal} ms", reached=1000 * seconds <= goal)
    bench.row("  processor time", f"{1000 * statistics.median(c[1] for c in costs):.0f} ms")


def same_bytes(bench, scenes, runs):
    """OSMesa against EGL, and whatever the number of threads."""
    bench.progress("the same bytes")

    def picture(*arguments, **environment):
        program = bench.capture(*arguments)
        program.run(**environment)
        return program.picture.read_bytes()

    differ = [s for s in scenes if picture(s, "--context", "osmesa") != picture(s, "--context", "egl")]
    bench.row(f"OSMesa against EGL, {len(scenes)} scenes", "differ: " + " ".join(differ) if differ else "the same bytes",
              goal="the same", reached=not differ)
    pictures = {picture(scene, LP_NUM_THREADS=n) for scene in scenes[:1] for n, _ in itertools.product("0128", range(runs))}
    bench.row(f"0, 1, 2 and 8 threads, {runs} runs each", f"{len(pictures)} picture{'s' if len(pictures) > 1 else ''}", goal="1",
              reached=len(pictures) == 1)


def arrows(bench, mesh, count, seconds, mib=None):
    """What so many arrows add to a capture of a mesh, and the memory of all of it."""
    bench.progress(f"{count:,} arrows")
    show = ("--set", "view=single", "--set", "surface=" + '{"mesh":"' + str(mesh) + '"}', "--set", f"arrows.limit={count}")
    programs = [bench.capture(*show, "--set", f"arrows.show={kinds}") for kinds in ('["inverse-transpose"]', "[]")]
    with_arrows, without = bench.turns(programs, cold=False)
    cost = statistics.median(one.seconds - other.seconds for one, other in zip(with_arrows, without))
    bench.row(f"{count:,} arrows, above the same without", f"{cost:.2f} s", goal=f"{seconds} s", reached=cost <= seconds)
    if mib:
        peak = max(r.kib for r in with_arrows) / MIB
        bench.row("  peak memory", f"{peak:.0f} MiB", goal=f"{mib} MiB", reached=peak <= mib)


def arrow_frames(bench, goals):
    """frame_bench arrows prints one line of JSON, with frames a second by samples for each number of arrows; `goals`: what each is
    to reach with 1 sample and with 4."""
    program = pathlib.Path(bench.normalscope).parent / "frame_bench"
    if not program.exists():
        return
    bench.progress("frames with many arrows")
    output = subprocess.run([program, "arrows"], env=bench.ours, stdout=subprocess.PIPE, check=True, text=True).stdout
    rates = {int(count): of for count, of in json.loads(output.strip().splitlines()[-1]).items() if count.isdigit()}
    for (count, of), goal in zip(rates.items(), goals):
        bench.row(f"frames while orbiting, {count:,} arrows, 1 / 4 samples", f"{of['1']:.0f}, {of['4']:.0f} / s",
                  goal=f"{goal[0]}, {goal[1]} / s", reached=of["1"] >= goal[0] and of["4"] >= goal[1])
