#!/usr/bin/env python3
"""glTF files that others made: VIDES reads them as three.js does.

    others.py VIDES

The files of others.json come from packages (install.sh). Each is brought in by `vides convert`, every
node is sampled by `vides sample --node`, and its world matrices are compared with those of
three.js at the same times, a hundred of them where something moves, to 1e-5 of the largest entry.
Cameras and lights, which look along another axis here, are compared by place, view and up.
"""

import argparse
import hashlib
import json
import math
import struct
import sys
import tomllib
from pathlib import Path

import numpy as np

import check

MOST = 1e-5
TIMES = 100


def document(file):
    data = file.read_bytes()
    if data[:4] == b"glTF":
        data = data[20 : 20 + struct.unpack_from("<I", data, 12)[0]]
    return json.loads(data)


def duration(gltf):
    """Seconds of the first animation."""
    accessors = gltf.get("accessors", [])
    inputs = [sampler["input"] for animation in gltf.get("animations", [])[:1] for sampler in animation["samplers"]]
    return max((accessors[at]["max"][0] for at in inputs), default=0.0)


def reachable(gltf):
    """Nodes of the scene that is shown."""
    scenes = gltf.get("scenes", [])
    found, open_ = set(), list(scenes[gltf.get("scene", 0)].get("nodes", [])) if scenes else []
    while open_:
        at = open_.pop()
        found.add(at)
        open_ += gltf["nodes"][at].get("children", [])
    return sorted(found)


def states(program, file, name):
    """Of a node at all frames: matrices (n, 16), or of cameras and lights place, view and up (n, 9)."""
    said = json.loads(check.vides(program, "sample", file, "--node", name, "--format", "json").stdout)
    entries = said.get("states") or said["poses"]
    if "matrix" in entries[0]:
        return np.array([entry["matrix"] for entry in entries])
    return np.array([[*entry["vrp"], *entry["vpn"], *entry["vup"]] for entry in entries])


def seen(matrices):
    """Place, view and up of a camera of glTF with these matrices, column by column."""
    axes = [-matrices[:, 8:11], matrices[:, 4:7]]
    return np.hstack([matrices[:, 12:15], *(axis / np.linalg.norm(axis, axis=-1, keepdims=True) for axis in axes)])


def difference(found, wanted):
    """The largest difference, in parts of the largest entry."""
    if found.shape[1] == 9:
        wanted = seen(wanted)
    if found.shape != wanted.shape:
        return math.inf
    return float(np.abs(found - wanted).max() / np.abs(wanted).max())


def compare(program, model, file, three, scratch):
    """What is wrong of one file, how many nodes there were, and the worst difference."""
    gltf = document(file)
    nodes = reachable(gltf)
    fps = math.ceil(TIMES / duration(gltf)) if duration(gltf) else 25
    vid = scratch / f"{model['name'].replace(' ', '_')}.vid"
    check.vides(program, "convert", file, vid, "--fps", fps)
    names = [node["name"] for node in tomllib.loads(vid.read_text()).get("node", [])]
    sampled = {name: states(program, vid, name) for name in names}
    count = max((len(value) for value in sampled.values()), default=0)
    if duration(gltf) and count < TIMES:
        return [f"{count} frames of {duration(gltf)} s at {fps} a second"], len(nodes), math.inf
    times = [n / fps for n in range(count)]
    result = three.run([{"file": str(file), "times": times, "matrices": True, "animation": 0}], scratch)[0]
    if "error" in result:
        return [f"three.js: {result['error'].splitlines()[0]}"], len(nodes), math.inf
    frames = np.array(result["frames"])
    given = [node.get("name") for node in gltf["nodes"]]
    bad, worst = [], 0.0
    free = dict(sampled)
    # Nodes with a name of their own first; those without one take whatever is left and alike.
    for at in sorted(nodes, key=lambda at: given.count(given[at]) != 1 or not given[at]):
        wanted = frames[:, at]
        own = given[at] and given.count(given[at]) == 1
        candidates = [given[at]] if own and given[at] in free else list(free)
        best = min(candidates, key=lambda name: difference(free[name], wanted), default=None)
        away = math.inf if best is None else difference(free.pop(best), wanted)
        worst = max(worst, away)
        if away > MOST:
            bad.append(f"node {at} {given[at]!r}: {away:.3g}" + (f" as {best!r}" if best else ", none like it"))
    return bad, len(nodes), worst


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vides", type=Path)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    scratch = check.TARGET / "others-read"
    scratch.mkdir(parents=True, exist_ok=True)
    three = check.Importer("three.js", ["node", check.TARGET / "node" / "three.mjs"])
    count = check.Count()
    for model in json.loads((check.HERE / "others.json").read_text()):
        if options.only and model["name"] != options.only:
            continue
        file = check.TARGET / "others" / model["path"]
        try:
            if hashlib.sha256(file.read_bytes()).hexdigest() != model["sha256"]:
                raise RuntimeError("not the file that it was")
            bad, nodes, worst = compare(options.vides, model, file, three, scratch)
        except (RuntimeError, OSError, KeyError, ValueError) as error:
            count.failure(model["name"], error)
            continue
        print(f"{model['name']:<26}{'FAILED' if bad else 'ok':<8}{nodes} nodes  {worst:.1e} of the largest entry", flush=True)
        for line in bad[:3]:
            print(f"    {line}")
        count.note(not bad)
    print(f"{count.passed} passed, {count.failed} failed")
    return 1 if count.failed or not count.passed else 0


if __name__ == "__main__":
    sys.exit(main())
