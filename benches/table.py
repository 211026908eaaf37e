#!/usr/bin/env python3
"""Runs every benchmark and prints the Markdown tables of docs/theory/accuracy-and-speed.md.

    python3 benches/table.py            # all of it, some eight minutes
    python3 benches/table.py --no-peers # without other libraries

Ratios count, not figures: all of one table come from one run on one machine.
The column "baseline" is the same library without its vector code for newer
processors (RUSTFLAGS="--cfg vides_no_simd"), "AVX2" what it chooses by itself
where the processor has AVX2.
"""

import argparse
import json
import math
import os
import platform
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target").resolve()
CARGO, CC = os.environ.get("CARGO", "cargo"), os.environ.get("CC", "cc")


def run(*command, **environment):
    print("+", *command, file=sys.stderr)
    return subprocess.run(
        [str(part) for part in command],
        cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True, env={**os.environ, **environment},
    ).stdout  # fmt: skip


def engine(target, flags, only=""):
    """Seconds of the fastest sample of each benchmark, and elements per run."""
    environment = {"CARGO_TARGET_DIR": str(target), "CRITERION_HOME": str(target / "criterion")}
    if flags:
        environment["RUSTFLAGS"] = f"{os.environ.get('RUSTFLAGS', '')} {flags}".strip()
    run(CARGO, "bench", "--locked", "--bench", "engine", "--", "--noplot", *([only] if only else []), **environment)
    check_inlined(target)
    results = {}
    for file in (target / "criterion").glob("*/*/new/sample.json"):
        name = "/".join(file.parts[-4:-2])
        if not name.startswith(only):
            continue
        data = json.loads(file.read_text())
        seconds = min(t / n for t, n in zip(data["times"], data["iters"])) / 1e9
        about = json.loads((file.parent / "benchmark.json").read_text())
        results[name] = seconds, (about["throughput"] or {}).get("Elements")
    return results


def check_inlined(target):
    """An operation of a vector that is a function to be called costs ten times as much."""
    program = max((target / "release" / "deps").glob("engine-*[0-9a-f]"), key=lambda file: file.stat().st_mtime)
    called = [line for line in run("nm", "-C", program).splitlines() if "core_arch" in line and "::_mm" in line]
    if called:
        sys.exit("Operations of vectors are called:\n" + "\n".join(called))


def list_figures():
    program = TARGET / "list"
    library = TARGET / "c" / "libvides.a"
    if not library.exists():
        run("make", "all")
    run(CC, "-O2", "-Iinclude", "-o", program, HERE / "list.c", library, "-lm")
    lines = run(program).splitlines()
    return {key: float(value) for key, value in (line.split() for line in lines)}


def has_avx2():
    try:
        words = Path("/proc/cpuinfo").read_text().split()
    except OSError:
        return False
    return "avx2" in words and "fma" in words


def processor():
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


def check_paths(engine_poses, listed):
    """The same path everywhere, or the ratios mean nothing."""
    sys.path.insert(0, str(HERE / "peers"))
    from bench_path import point

    total = sum(sum(point(i)[0]) for i in range(100))
    if abs(total - listed["coordinates"]) > 1e-9 or engine_poses != listed["elements"]:
        sys.exit("The benchmarks do not run on the same path.")


# What is drawn: the benchmark of the group `growth`, its name, the place of that, its colour.
CURVES = (
    ("load", "a point of a .vid loaded", "#8e5a2b"),
    ("prepare", "a point prepared", "#1f6fb2"),
    ("fill", "ten poses from point to point", "#2f8f4e"),
    ("evaluate", "the state of a node", "#b3313f"),
)


def draw(results, file):
    """What one of 10, 100, … 100,000 costs: level is linear."""
    counts = [10**k for k in range(1, 6)]
    x = lambda count: 60 + 130 * (math.log10(count) - 1)
    y = lambda ns: 330 - 75 * (math.log10(ns) - 1)
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 400" font-family="sans-serif" font-size="13">',
             '<rect width="640" height="400" fill="#fff"/>']  # fmt: skip
    for k in range(1, 6):
        parts.append(f'<path d="M60 {y(10**k):.0f}H580" stroke="#ddd"/>'
                     f'<text x="52" y="{y(10**k) + 4:.0f}" text-anchor="end">{("10 ns", "100 ns", "1 µs", "10 µs", "100 µs")[k - 1]}</text>')  # fmt: skip
    for count in counts:
        parts.append(f'<text x="{x(count):.0f}" y="352" text-anchor="middle">{count:,}</text>')
    parts.append('<text x="320" y="380" text-anchor="middle">points of the path, nodes of the scene</text>')
    for name, text, colour in CURVES:
        costs = [1e9 * results[f"growth/{name}_{count}"][0] / count for count in counts]
        line = " ".join(f"{x(count):.1f},{y(ns):.1f}" for count, ns in zip(counts, costs))
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>'
                     f'<text x="580" y="{y(costs[-1]) + (18 if name == "prepare" else -8):.0f}" text-anchor="end" fill="{colour}">{text}</text>')  # fmt: skip
        print(f"{text}: " + ", ".join(f"{ns:.0f} ns" for ns in costs), file=sys.stderr)
    file.write_text("\n".join([*parts, "</svg>"]) + "\n")


# What is measured by the triangles of an object, and by the points of a path.
PLANNERS = (
    ("check", "check"), ("avoid", "avoid"), ("zoom", "picture, by zoom"), ("distance", "picture, by distance"),
    ("view", "picture, by view"), ("tour", "tour"), ("inside", "tour inside"), ("tree", "reading the object"),
)  # fmt: skip
OF_POINTS = (
    ("retime", "#8e5a2b"), ("steady", "#1f6fb2"), ("fit", "#2f8f4e"), ("check", "#b3313f"),
    ("distance", "#7a4fa3"), ("avoid", "#555"),
)  # fmt: skip
KINDS = {"smooth": "#1f6fb2", "equal": "#2f8f4e", "degenerate": "#8e5a2b", "overlapping": "#b3313f"}


def planners(file, measured=None):
    """Draws seconds of each planner by the size of what it works on; a line ends where 20 s are not enough."""
    lines = measured or run(CARGO, "bench", "--locked", "--bench", "planners")
    seconds = {}
    for line in lines.splitlines():
        name, kind, count, took = line.split(" ")[:4]
        seconds.setdefault((name, kind), []).append((int(count), float(took)))
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1080 620" font-family="sans-serif" font-size="12">',
             '<rect width="1080" height="620" fill="#fff"/>']  # fmt: skip

    def panel(left, top, width, title, decades, curves):
        x = lambda count: left + width * (math.log10(count) - 1) / (decades - 1)
        y = lambda took: top + 130 - 130 * (math.log10(max(took, 1e-4)) + 4) / 5.5
        parts.append(f'<text x="{left}" y="{top - 8}" font-weight="bold">{title}</text>')
        for took, name in ((1e-3, "1 ms"), (1e-1, "100 ms"), (10, "10 s")):
            parts.append(f'<path d="M{left} {y(took):.0f}h{width}" stroke="#ddd"/>'
                         f'<text x="{left - 4}" y="{y(took) + 4:.0f}" text-anchor="end" font-size="10">{name}</text>')  # fmt: skip
        for k in range(1, decades + 1):
            parts.append(f'<text x="{x(10**k):.0f}" y="{top + 144}" text-anchor="middle" font-size="10">10{"⁰¹²³⁴⁵⁶"[k]}</text>')
        for points, colour in curves:
            done = [(count, took) for count, took in points if took < math.inf]
            line = " ".join(f"{x(count):.1f},{y(took):.1f}" for count, took in done)
            parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
            if len(done) < len(points):
                parts.append(f'<circle cx="{x(done[-1][0]):.1f}" cy="{y(done[-1][1]):.1f}" r="4" fill="none" stroke="{colour}"/>')

    for k, (name, title) in enumerate(PLANNERS):
        curves = [(seconds[name, kind], colour) for kind, colour in KINDS.items() if (name, kind) in seconds]
        panel(60 + 260 * (k % 4), 40 + 195 * (k // 4), 190, title, 6, curves)
    for k, (kind, colour) in enumerate(KINDS.items()):
        parts.append(f'<text x="{60 + 110 * k}" y="412" fill="{colour}">{kind}</text>')
    parts.append('<text x="1030" y="412" text-anchor="end">triangles of the object; a path of 20 points</text>')
    curves = [(seconds[name, "points"], colour) for name, colour in OF_POINTS if (name, "points") in seconds]
    panel(60, 450, 450, "by the points of the path; an object of 2,000 triangles", 4, curves)
    for k, (name, colour) in enumerate(OF_POINTS):
        parts.append(f'<text x="{60 + 75 * k}" y="612" fill="{colour}">{name}</text>')
    aims = (("plain", "#555"), ("ring", "#1f6fb2"), ("chain", "#2f8f4e"), ("hanging", "#b3313f"))
    curves = [(seconds["evaluate", kind], colour) for kind, colour in aims if ("evaluate", kind) in seconds]
    panel(580, 450, 450, "the states of a scene of cameras", 5, curves)
    for k, (kind, colour) in enumerate(aims):
        parts.append(f'<text x="{580 + 90 * k}" y="612" fill="{colour}">{kind}</text>')
    file.write_text("\n".join([*parts, "</svg>"]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--growth", action="store_true", help="only draw docs/theory/growth.svg")
    parser.add_argument("--planners", nargs="?", const="", metavar="MEASURED",
                        help="only draw docs/theory/planners.svg, of a file with lines of the benchmark")  # fmt: skip
    options = parser.parse_args()

    if options.planners is not None:
        lines = Path(options.planners).read_text() if options.planners else None
        return planners(ROOT / "docs" / "theory" / "planners.svg", lines)
    if options.growth:
        return draw(engine(TARGET, "", "growth/"), ROOT / "docs" / "theory" / "growth.svg")
    dispatched = engine(TARGET, "")
    baseline = engine(TARGET / "baseline", "--cfg vides_no_simd", "sample/")
    draw(dispatched, ROOT / "docs" / "theory" / "growth.svg")
    listed = list_figures()
    check_paths(dispatched["sample/100_prepared"][1], listed)
    peers = {} if options.no_peers else json.loads(run(sys.executable, HERE / "peers" / "peers.py", "--json"))

    def rate(results, name):
        seconds, elements = results[name]
        return elements / seconds

    own = "AVX2" if has_avx2() else "this processor"
    print(f"\nMillions of poses a second, one core, {processor()}:\n")
    fast = max(peers.values(), default=None)
    head = ["", "baseline", own] + ([f"{own} ÷ fastest peer"] if fast else []) + ["of bare memory writes"]
    rows = [head, ["---"] + ["---:"] * (len(head) - 1)]
    limit = rate(dispatched, "write/bare")
    for name, text in (
        ("100_prepared", "100 points, prepared before"),
        ("100_with_preparation", "100 points, preparation counted"),
        ("10000_prepared", "10,000 points, prepared before"),
        ("10000_with_preparation", "10,000 points, preparation counted"),
    ):
        a, b = rate(baseline, f"sample/{name}"), rate(dispatched, f"sample/{name}")
        rows.append(
            [text, f"{a / 1e6:.1f}", f"{b / 1e6:.1f}"]
            + ([f"{b / fast:.0f}×"] if fast else [])
            + [f"{100 * b / limit:.0f} %"]
        )
    for name, speed in peers.items():
        rows.append([name, "", f"{speed / 1e6:.2f}", f"{speed / fast:.2f}×", f"{100 * speed / limit:.1f} %"])
    bare = ["bare memory writes (80 bytes a pose)", "", f"{limit / 1e6:.0f}"] + ([""] if fast else []) + ["100 %"]
    rows.append(bare)
    for row in rows:
        print("| " + " | ".join(row) + " |")
    if fast:
        first = rate(baseline, "sample/100_prepared") / fast
        print(f"\nThe baseline alone, 100 points prepared before: {first:.0f}× the fastest peer.")

    print("\n| a prepared path, ns a pose (÷ whole frames in order) | 100 points | 10,000 points |\n|---|---:|---:|")
    for name, text in (
        ("prepared", "whole frames in order"),
        ("between_frames", "between frames, rising"),
        ("anywhere", "between frames, in no order"),
        ("one_by_one", "between frames, in no order, one a call"),
    ):
        pair = ((rate(dispatched, f"sample/{points}_{one}") for one in ("prepared", name)) for points in (100, 10_000))
        print(f"| {text} | " + " | ".join(f"{1e9 / own:.1f} ({whole / own:.1f})" for whole, own in pair) + " |")

    print("\n| | |\n|---|---:|")
    print(f"| `v_path_to_list`, {listed['elements']:,.0f} elements, beyond sampling, beside a C loop that allocates, "
          f"fills and links as many | {listed['ratio']:.2f}× |")  # fmt: skip
    for name, text, unit, scale in (
        ("change/point", "one point of 10,000 moved, frame count asked again", "µs", 1e6),
        ("change/orientation", "one orientation of 10,000 changed, frame count asked again", "µs", 1e6),
        ("file/load_1000", "loading a `.vid` of 1,000 points", "ms", 1e3),
        ("file/load_10000", "loading a `.vid` of 10,000 points", "ms", 1e3),
        ("file/load_keys", "loading a scene of 1,000,000 keys", "ms", 1e3),
        ("file/save_1000", "saving it, 1,000 points, both fsyncs", "ms", 1e3),
        ("file/save_10000", "saving it, 10,000 points, both fsyncs", "ms", 1e3),
    ):
        print(f"| {text} | {dispatched[name][0] * scale:.1f} {unit} |")
    for points in (100, 10_000):
        one, two = (dispatched[f"sample/{points}_{how}"][0] for how in ("prepared", "two_threads"))
        print(f"| two threads on one path of {points:,} points, ÷ one | {one / two:.2f}× |")


if __name__ == "__main__":
    main()
