#!/usr/bin/env python3
"""Scenes beside other libraries, one core each, all in one run: benches/scene.py

The processor's time counts, so that other work on the machine does not. Prints a
Markdown table. Peers are installed below target/peers by npm and pip.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target").resolve()
THREE, PYTHON = "three@0.187.0", ["usd-core==26.11", "numpy==2.4.6"]
THREADS = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "PXR_WORK_THREAD_LIMIT"), "1")


def run(*command, **options):
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, text=True,
                          env={**os.environ, **THREADS}, **options).stdout  # fmt: skip


def installed(folder, wanted, *commands):
    stamp = folder / "installed.txt"
    if not (stamp.exists() and stamp.read_text() == wanted):
        folder.mkdir(parents=True, exist_ok=True)
        for command in commands:
            run(*command, cwd=folder)
        stamp.write_text(wanted)
    return folder


def main():
    program, library = TARGET / "scene", TARGET / "c" / "libvides.a"
    run(os.environ.get("CC", "cc"), "-O2", f"-I{ROOT / 'include'}", "-o", program, HERE / "scene.c", library, "-lm")
    modules = installed(TARGET / "peers" / "three", THREE, ["npm", "install", "--silent", "--prefix", ".", THREE])
    python = TARGET / "peers" / "scene"
    pip = [python / "bin" / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *PYTHON]
    installed(python, " ".join(PYTHON), [sys.executable, "-m", "venv", "--clear", "."], pip)

    own = {key: float(value) for key, value in map(str.split, run(program).splitlines())}
    module = modules / "node_modules" / "three" / "build" / "three.module.js"
    three, many = (json.loads(run("node", HERE / "peers" / "scene.mjs", module, nodes, keys))
                   for nodes, keys in ((1000, 11), (100000, 6)))  # fmt: skip
    usd, numpy = json.loads(run(python / "bin" / "python", HERE / "peers" / "scene.py"))
    # The same everywhere, or the ratios mean nothing. three.js keeps keys as floats.
    for peer, key, near in ((three, "nodes_places", 1e-3), (many, "many_places", 1), (usd, "nodes_places", 1e-3), (numpy, "points", 1e-5)):
        found = peer[key.split("_")[-1]]
        if abs(found - own[key]) > near:
            sys.exit(f"{peer['name']} has another scene: {found} and {own[key]}")
    rows = [["", "millions a second", "ours"], ["---", "---:", "---:"]]
    for key, text, peers in (("nodes_per_second", "states of 1,000 nodes", (three, usd)),
                             ("many_per_second", "states of 100,000 nodes", (many,)),
                             ("nodes_sampled_per_second", "states of one node, five levels deep", ()),
                             ("vertices_per_second", "points with two shapes and a twist", (numpy,))):  # fmt: skip
        rows.append([text, f"{own[key] / 1e6:.2f}", ""])
        for peer in peers:
            speed = peer[key.replace("many", "nodes")]
            rows.append([peer["name"], f"{speed / 1e6:.2f}", f"{own[key] / speed:.1f}×"])
    print("\n".join("| " + " | ".join(row) + " |" for row in rows))


if __name__ == "__main__":
    main()
