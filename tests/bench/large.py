"""Figures of what is large: meshes, formulas, pictures to compare and lists of checks."""

import json
import pathlib
import shutil
import statistics
import struct
import subprocess
import zlib

MIB = 1024  # KiB, as getrusage counts


def took(bench, what, program, goal, runs=3, mib=None):
    """The program's time, and its memory where there is a goal for it."""
    bench.progress(what)
    results = [program.run() for _ in range(runs)]
    seconds = statistics.median(run.seconds for run in results)
    bench.row(what, f"{seconds:.2f} s", goal=f"{goal} s", reached=seconds <= goal)
    bench.row("  processor time", f"{statistics.median(run.processor for run in results):.2f} s")
    if mib:
        peak = max(run.kib for run in results) / MIB
        bench.row("  peak memory", f"{peak:.0f} MiB", goal=f"{mib} MiB", reached=peak <= mib)


def vector_picture(bench, goal):
    program = bench.capture("--set", "surface.shape=sphere", "--set", "surface.resolution=512")
    program.picture = bench.folder / "ours.svg"
    program.command[program.command.index("-o") + 1] = str(program.picture)
    took(bench, "capture -o s.svg of a sphere at resolution 512", program, goal)


def turning(bench, mesh, goal):
    """mesh_bench prints one line of JSON: {"triangles": 1000000, "probe_ms": 0.03, "click_ms": 0.04, …}."""
    bench.progress("turning a large mesh")
    program = pathlib.Path(bench.normalscope).parent / "mesh_bench"
    output = subprocess.run([program, mesh], env=bench.ours, stdout=subprocess.PIPE, check=True, text=True).stdout
    ms = json.loads(output.strip().splitlines()[-1])
    for what, key in (("a click", "click_ms"), ("a frame's probe", "probe_ms")):
        bench.row(f"{what} on {ms['triangles']:,} triangles", f"{ms[key]:.2f} ms", goal=f"{goal} ms", reached=ms[key] <= goal)
    bench.row("  by looking at all of them", f"{ms['probe_by_all_ms']:.1f} ms")
    bench.row("  their tree, once, in the background", f"{ms['tree_ms']:.0f} ms")


def long_header(bench, elements, goal):
    mesh = bench.folder / "header.ply"
    mesh.write_text("ply\nformat ascii 1.0\n" + "".join(f"element e{i} 1\nproperty int a\n" for i in range(elements)) +
                    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + "1\n" * elements +
                    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", encoding="ascii")
    program = bench.capture(mesh)
    program.command[program.command.index("--size") + 1] = "64x36"
    took(bench, f"a PLY with {elements:,} elements in its header", program, goal)


def long_formulas(bench, sines_goal, longest_goal):
    sines = "+".join(f"sin({1 + 0.37 * i:.2f}*x+{0.21 * i:.2f}*y-{0.11 * i:.2f}*z)" for i in range(30))
    sum_of_many, product = "x^2+y^2+z^2-1", "(x+0.5)"
    for i in range(1, 1000):
        if len(sum_of_many) < 9900:
            sum_of_many += f"+0.0{i % 9 + 1}*sin({i % 13 + 1}*x+{i % 7}*y)*cos({i % 11}*z)"
        if len(product) < 9900:
            product += f"*(x*{i % 7 + 1}-y+{i * 0.01:.2f})"
    for what, formula, goal in (("a formula of 30 sines", sines, sines_goal), ("of 10,000 characters, a sum", sum_of_many, longest_goal),
                                ("of 10,000 characters, a product", product + "-0.1", longest_goal)):
        took(bench, what, bench.capture("--set", "surface=" + json.dumps({"formula": formula})), goal)


def write_picture(path, width, height, seed):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    row = bytes((7 * i + 13 * (i // 64)) % 256 for i in range(3 * width))
    deflate = zlib.compressobj(1)
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        for y in range(height):
            turned = bytearray(row[3 * (y % 200):] + row[:3 * (y % 200)])
            if y % 1000 == 7:
                turned[100] = (turned[100] + 40 * seed) % 256
            if data := deflate.compress(b"\0" + turned):
                out.write(chunk(b"IDAT", data))
        out.write(chunk(b"IDAT", deflate.flush()) + chunk(b"IEND", b""))
    return path


def comparing(bench, goal, mib):
    pictures = [write_picture(bench.folder / f"{name}.png", 16384, 8192, seed) for seed, name in enumerate(("actual", "expected"))]
    program = bench.capture()
    program.command, program.picture = [bench.normalscope, "compare", *map(str, pictures)], bench.folder / "compare.txt"
    program.keeps_picture = True
    program.picture.touch()  # compare leaves none
    took(bench, "comparing two PNGs of 134 million pixels", program, goal, mib=mib)
    for picture in pictures:
        picture.unlink()


def checking(bench, count, goal, mib):
    folder = bench.folder / "checks"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    scenes = ("slide-scale", "shear", "reflection", "error-map", "stretch-axes")
    checks = [{"name": f"{i}", "scene": scenes[i % 5], "set": [f"camera.azimuth={i % 360}"], "reference": f"references/{i}.png"}
              for i in range(count)]
    manifest = folder / "checks.json"
    manifest.write_text(json.dumps({"normalscope_check": 1, "size": "640x360", "checks": checks}), encoding="utf-8")
    command = [bench.normalscope, "check", str(manifest), "--jobs", "2", "--results", str(folder / "results")]
    bench.progress("the references of the checks")
    subprocess.run([*command, "--update"], env=bench.ours, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, check=True)
    program = bench.capture()
    program.command, program.picture = [*command, "--junit", str(folder / "junit.xml")], folder / "junit.xml"
    took(bench, f"check of {count} pictures, 640x360, 2 jobs", program, goal, runs=1, mib=mib)
