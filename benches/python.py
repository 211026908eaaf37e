#!/usr/bin/env python3
"""What Python asks of a prepared path, beside `sample`: benches/python.py WHEEL

The path of all benchmarks, a million poses; each in turn, the fastest of nine counts, in processor
time, so that other work on the machine does not. Prints a
Markdown table. NumPy and the wheel are installed below target/peers by pip.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or HERE.parent / "target").resolve() / "peers" / "python"
POINTS, POSES, RUNS = 100, 1_000_000, 9


def own_environment(wheel):
    """Starts this script again in an environment that has the wheel."""
    python = TARGET / "bin" / "python"
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", "--clear", TARGET], check=True)
    pip = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, "numpy==2.4.6"], check=True)
    subprocess.run([*pip, "--force-reinstall", "--no-deps", wheel], check=True)
    os.execve(python, [str(python), str(HERE / "python.py")], os.environ)


def main():
    import numpy as np
    import vides

    sys.path.insert(0, str(HERE / "peers"))
    from bench_path import point

    points = [point(i) for i in range(POINTS)]
    path = vides.Path([position for position, *_ in points], frames=POSES)
    tcb = lambda values: dict(zip(("tension", "continuity", "bias"), values))
    for at, (_, own, direction, turning, roll, zoom) in zip(path.points, points):
        at.own, view = tcb(own), at.orientations[0]
        view.offset, view.roll, view.zoom, view.turning = direction, roll, zoom, tcb(turning)
    samples = path.sample()
    rising = np.minimum(samples.frames + 0.5, POSES)
    anywhere = np.random.default_rng(1).permutation(rising)
    rows = (
        ("`path.sample()`", path.sample),
        ("`path.evaluate(frames)`, between frames, rising", lambda: path.evaluate(rising)),
        ("`path.evaluate(frames)`, in no order", lambda: path.evaluate(anywhere)),
        ("`samples.matrices()`", samples.matrices),
        ("`samples.quaternions`", lambda: samples.quaternions),
        ("`path.motion(frames)`", lambda: path.motion(samples.frames)),
    )
    best = [float("inf")] * len(rows)
    for _ in range(RUNS):
        for k, (_, call) in enumerate(rows):
            begin = time.process_time()
            call()
            best[k] = min(best[k], time.process_time() - begin)
    print(f"\n| a million poses of {POINTS} points in Python | ns a pose | ÷ `sample` |\n|---|---:|---:|")
    for (text, _), seconds in zip(rows, best):
        print(f"| {text} | {1e9 * seconds / POSES:.0f} | {seconds / best[0]:.1f} |")


if __name__ == "__main__":
    own_environment(sys.argv[1]) if len(sys.argv) > 1 else main()
