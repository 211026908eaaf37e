#!/usr/bin/env python3
"""Holds `.usda` files against OpenUSD itself (PyPI `usd-core`), out and in.

    openusd.py VIDES [--paths N] [--scenes N]

Out: random paths (paths.py), random scenes and the examples; every node at every time code as
`Usd.Stage`, `UsdGeom.Camera` and its `GfCamera` have it, no word on standard error, no complaint of
`UsdValidation`. In again: the same document. In: stages that `usd-core` writes, node by node.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pxr
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdValidation, Vt

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import paths  # noqa: E402

ROOT = HERE.parents[1]

POSITION, ANGLE, FOV = 1e-6, 0.01, 0.001
worst = dict.fromkeys(("position", "angle", "fov", "lens", "matrix", "position back", "angle back", "fov back", "matrix in"), 0.0)
faults = []


def note(what, value, limit, where):
    value = float(value)
    worst[what] = max(worst[what], value)
    if not value <= limit:
        faults.append(f"{where}: {what} {value:.3e}, allowed {limit}")


class Quiet:
    """Standard error of C++ too; what was said is a fault."""

    def __init__(self, where):
        self.where = where

    def __enter__(self):
        self.file, self.old = tempfile.TemporaryFile(), os.dup(2)
        os.dup2(self.file.fileno(), 2)

    def __exit__(self, *_):
        os.dup2(self.old, 2)
        os.close(self.old)
        self.file.seek(0)
        if said := self.file.read().decode(errors="replace").strip():
            faults.append(f"{self.where}: OpenUSD said: {said[:300]}")


class Vides:
    def __init__(self, program, scratch):
        self.program, self.scratch = program, scratch

    def run(self, source, target, *options):
        return subprocess.run([*self.program, "convert", source, target, *options], capture_output=True, text=True)

    def convert(self, source, target, *options):
        done = self.run(source, target, *options)
        if done.returncode:
            raise SystemExit(f"{source} to {target} {options}: {done.stderr}")
        return done.stderr

    def sampled(self, source, *options):
        target = self.scratch / "sampled.json"
        self.convert(source, target, "--to", "json", *options)
        return json.loads(target.read_text())


def rows(matrix):
    """Column vectors, 4 × 4."""
    return np.array(matrix).T


def angle(a, b):
    """Degrees; exact for small ones."""
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    return np.degrees(2 * np.arctan2(np.linalg.norm(a - b), np.linalg.norm(a + b)))


def nodes_of(file):
    """Names and kinds, as the file lists them."""
    nodes, name = [], None
    for line in Path(file).read_text().splitlines():
        if line == "[[node]]":
            name = None
        elif line.startswith("name = ") and name is None:
            name = json.loads(line[7:])
        elif line.startswith("kind = ") and name is not None:
            nodes.append((name, json.loads(line[7:])))
    return nodes or [("camera", "camera")]


def prim_of(stage, name, kind):
    found = [p for p in stage.Traverse() if name in (p.GetDisplayName(), p.GetDisplayName() or p.GetName())]
    looks = {"camera": UsdGeom.Camera, "light": None}
    if kind in looks:
        def is_it(p):
            return p.IsA(UsdGeom.Camera) if kind == "camera" else p.HasAPI(UsdLux.LightAPI)
        for prim in found:
            for each in (prim, *prim.GetChildren()):
                if is_it(each) and (each == prim or each.GetCustomDataByKey("vides") == "looks"):
                    return each
    return found[0]


def compare_pose(prim, code, pose, size, where, scale=1.0, turn=None, ours=True):
    matrix = rows(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(code))
    place, view, up = (np.array(pose[k]) for k in ("vrp", "vpn", "vup"))
    if turn is not None:
        place, view, up = turn @ place, turn @ view, turn @ up
    note("position", np.abs(matrix[:3, 3] - place * scale).max() / (size * scale), POSITION, where)
    note("angle", angle(-matrix[:3, 2], view), ANGLE, where)
    note("angle", angle(matrix[:3, 1], up), ANGLE, where)
    if prim.IsA(UsdGeom.Camera):
        seen = UsdGeom.Camera(prim).GetCamera(code)
        fov = np.degrees(2 * np.arctan(12 / pose["zoom"]))
        note("fov", abs(seen.GetFieldOfView(Gf.Camera.FOVVertical) - fov), FOV, where)
        tenths = 100 * UsdGeom.GetStageMetersPerUnit(prim.GetStage())
        note("lens", abs(seen.focalLength * tenths / pose["zoom"] - 1) if scale == 1 and ours else 0, 1e-6, where)
        # What GfCamera itself makes of it.
        note("position", np.abs(rows(seen.transform)[:3, 3] - place * scale).max() / (size * scale), POSITION, where)


def shears(prim, code):
    """Whether it or one that it is in does: told, and left out."""
    while prim and prim.IsA(UsdGeom.Xformable):
        axes = rows(UsdGeom.Xformable(prim).GetLocalTransformation(code))[:3, :3]
        axes = axes / np.linalg.norm(axes, axis=0)
        if np.abs(axes.T @ axes - np.eye(3)).max() > 1e-7:
            return True
        prim = prim.GetParent()
    return False


def validate(stage, where):
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    for error in UsdValidation.ValidationContext(validators).Validate(stage):
        faults.append(f"{where}: {error.GetName()}: {error.GetMessage()}")


def frames_agree(vides, file, usda, options=(), scale=1.0, turn=None):
    where = f"{Path(file).name} {' '.join(options)}"
    with Quiet(where):
        stage = Usd.Stage.Open(str(usda))
        validate(stage, where)
    own = [o for o in options if o not in ("--scale", str(scale), "--up", "y", "z")]
    for name, kind in nodes_of(file):
        told = vides.sampled(file, "--node", name, *own)
        prim = prim_of(stage, name, kind)
        first = stage.GetStartTimeCode()
        states = told.get("poses") or told["states"]
        if stage.GetEndTimeCode() != first + len(states) - 1 or first != told["first_frame"]:
            faults.append(f"{where}: frames {first} to {stage.GetEndTimeCode()}, wanted {told['first_frame']}, {len(states)}")
        if stage.GetTimeCodesPerSecond() != told["fps"]:
            faults.append(f"{where}: rate {stage.GetTimeCodesPerSecond()}")
        places = np.array([s["vrp"] if "vrp" in s else s["matrix"][12:15] for s in states])
        size = max(np.linalg.norm(np.ptp(places, axis=0)), np.abs(places).max(), 1e-9)
        for n, state in enumerate(states):
            at = f"{where}: {name}, frame {n}"
            if "vrp" in state:
                compare_pose(prim, first + n, state, size, at, scale, turn)
                continue
            matrix = rows(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(first + n))
            wanted = np.array(state["matrix"]).reshape(4, 4).T
            if turn is not None:
                wanted[:3] = turn @ wanted[:3]
            wanted[:3, 3] *= scale
            note("matrix", np.abs(matrix - wanted).max() / np.abs(wanted).max(), 1e-6, at)
            seen = UsdGeom.Imageable(prim).ComputeVisibility(first + n) != "invisible"
            if seen != state["visible"]:
                faults.append(f"{at}: visible {seen}")


def comes_back(vides, file, usda):
    """What is read of our own file is sampled as the document is."""
    told = vides.convert(usda, vides.scratch / "back.vid")
    stage = Usd.Stage.Open(str(usda))
    for name, kind in nodes_of(file):
        prim = prim_of(stage, name, kind)
        was, is_ = (vides.sampled(f, "--node", name) for f in (file, usda))
        where = f"{Path(file).name}: {name} back"
        for key in ("title", "kind", "fps", "first_frame", "frame_count"):
            if key in was and was[key] != is_[key]:
                faults.append(f"{where}: {key} {is_[key]!r}, was {was[key]!r}")
        for n, (a, b) in enumerate(zip(was.get("poses", was.get("states")), is_.get("poses", is_.get("states")))):
            at = f"{where}, frame {n}"
            if "shear" in told and shears(prim, stage.GetStartTimeCode() + n):
                continue
            if "vrp" in a:
                note("position back", np.abs(np.subtract(a["vrp"], b["vrp"])).max() / max(1, np.abs(a["vrp"]).max()), POSITION, at)
                for key in ("vpn", "vup"):
                    note("angle back", angle(np.array(a[key]), np.array(b[key])), ANGLE, at)
                note("fov back", abs(a["zoom"] - b["zoom"]) / a["zoom"], 1e-6, at)
            else:
                big = np.abs(a["matrix"]).max()
                note("matrix", np.abs(np.subtract(a["matrix"], b["matrix"])).max() / big, 1e-6, at)


def is_read(vides, file):
    """Files that come with usd-core hold schemas, and no camera."""
    done = vides.run(file, vides.scratch / "schema.vid")
    if done.returncode and "has no camera" not in done.stderr:
        faults.append(f"{file.name}: {done.stderr}")


INTERPOLATIONS = ("step", "linear", "ramp", "catmull-rom", "cubic", "euler-linear")


def track(dice, channel, make, after=None):
    by = dice.choice([i for i in INTERPOLATIONS if i != "euler-linear" and (i != "cubic" or channel != "rotation")])
    if channel == "rotation" and dice.random() < 0.2:
        by, make = "euler-linear", lambda: [dice.uniform(-400, 400) for _ in range(3)]
    if channel == "visible":
        by = "step"
    frames = sorted(dice.sample(range(1, 40), dice.randint(1, 5)))
    lines = ["[[node.track]]", f'channel = "{channel}"', f'interpolation = "{by}"']
    if dice.random() < 0.3:
        lines.append(f'after = "{dice.choice(["repeat", "pingpong"])}"')
    return [*lines, f"frames = {[float(f) for f in frames]}", f"values = {[make() for _ in frames]}".replace("[True]", "[1.0]")]


def scene(seed):
    """The text of a random scene."""
    dice = random.Random(f"scene {seed}")
    number = lambda far=2.0: dice.uniform(-far, far)  # noqa: E731
    vector = lambda far=2.0: [number(far) for _ in range(3)]  # noqa: E731
    turn = lambda: [number() for _ in range(4)]  # noqa: E731
    factors = lambda: [dice.choice([-1, 1]) * dice.uniform(0.3, 2) for _ in range(3)]  # noqa: E731
    lines = ["version = 1", f'title = "scene \\"{seed}\\""', f"fps = {dice.choice([24.0, 25.0, 30.0])}", f"first_frame = {dice.choice([1, 0, 101])}"]
    lines += ["[space]", f'up = "{"yz"[seed % 2]}"']
    names = []
    for n in range(dice.randint(4, 9)):
        kind = "camera" if n == 0 else dice.choice(["group", "object", "light", "camera"])
        name = f"{kind} {n}{dice.choice(['', ' é', '.x'])}"
        lines += ["[[node]]", f'name = "{name}"', f'kind = "{kind}"']
        if names and dice.random() < 0.7:
            lines.append(f'parent = "{dice.choice(names)}"')
        if kind in ("camera", "light") and names and dice.random() < 0.4:
            lines.append(f'aim = "{dice.choice(names)}"')
        lines += [f"position = {vector()}", f"rotation = {turn()}"]
        if dice.random() < 0.25:
            lines.append(f"scale = {factors()}")
        if kind in ("group", "object") and dice.random() < 0.5:
            lines.append(f"pivot = {vector(1.0)}")
        if kind == "camera":
            lines.append(f"zoom_mm = {2 ** dice.uniform(0, 10)}")
            if dice.random() < 0.5:
                lines.append(f"roll_degrees = {number(180)}")
        if kind == "light":
            lines.append(f'light = "{dice.choice(["directional", "point", "spot"])}"')
        if kind == "object":
            lines += ["[node.mesh]", f"points = {[vector(0.3) for _ in range(6)]}"]
            if dice.random() < 0.6:
                lines.append("triangles = [[0, 1, 2], [2, 3, 4], [5, 4, 3]]")
            if dice.random() < 0.5:
                lines.append("lines = [[0, 1], [1, 2], [4, 5]]")
        for channel, make, share in (
            ("position", vector, 0.5), ("rotation", turn, 0.5), ("scale", factors, 0.15),
            ("visible", lambda: [float(dice.random() < 0.5)], 0.3),
            ("zoom", lambda: [dice.uniform(1, 100)], 0.5 * (kind == "camera")),
            ("roll", lambda: [number(180)], 0.3 * (kind == "camera")),
            ("colour", lambda: [dice.random() for _ in range(3)], 0.3 * (kind in ("light", "object"))),
            ("intensity", lambda: [dice.uniform(0, 9)], 0.5 * (kind == "light")),
        ):  # fmt: skip
            if dice.random() < share:
                lines += track(dice, channel, make)
        names.append(name)
    return "\n".join(lines) + "\n"


def foreign(seed, file):
    """A stage as usd-core writes it; gives the matrices of its prims at times."""
    dice = random.Random(f"foreign {seed}")
    stage = Usd.Stage.CreateNew(str(file))
    UsdGeom.SetStageUpAxis(stage, dice.choice(["Y", "Z"]))
    UsdGeom.SetStageMetersPerUnit(stage, dice.choice([1.0, 0.01, 0.001]))
    first = dice.choice([0, 1, 101])
    stage.SetStartTimeCode(first)
    stage.SetEndTimeCode(first + 12)
    stage.SetTimeCodesPerSecond(dice.choice([24, 30]))
    prims, number = [], lambda far=2.0: dice.uniform(-far, far)
    for n in range(dice.randint(3, 8)):
        kind = UsdGeom.Camera if n == 0 else dice.choice([UsdGeom.Xform, UsdGeom.Camera, UsdGeom.Mesh, UsdGeom.Points])
        # Nothing below geometry, as the validators want it.
        parents = [p for p in prims if p.GetTypeName() == "Xform"]
        parent = dice.choice(parents).GetPath() if parents and dice.random() < 0.7 else Sdf.Path.absoluteRootPath
        it = kind.Define(stage, parent.AppendChild(f"prim{n}"))
        moves = dice.random() < 0.6
        for _ in range(dice.randint(0, 4)):
            precision = dice.choice([UsdGeom.XformOp.PrecisionDouble, UsdGeom.XformOp.PrecisionFloat])
            names = [a.GetOpName() for a in it.GetOrderedXformOps()]
            kinds = ["Translate", "Scale", "RotateX", "RotateY", "RotateZ", "RotateXYZ", "RotateZXY", "RotateYZX", "Orient", "Transform"]
            op = dice.choice([k for k in kinds if kind is not UsdGeom.Camera or k not in ("Scale", "Transform")])
            if op == "Scale" and any("scale" in n or "transform" in n for n in names):
                continue
            if op == "Scale" and moves:
                continue
            add = getattr(it, f"Add{op}Op")
            made = add(opSuffix=f"s{len(names)}") if op == "Transform" else add(precision, f"s{len(names)}")
            if not made:
                continue

            def value():
                if op == "Transform":
                    turn = Gf.Rotation(Gf.Vec3d(number(), number(), number() + 3), number(90))
                    return Gf.Matrix4d(turn, Gf.Vec3d(number(), number(), number()))
                if op == "Orient":
                    q = Gf.Quatd(number(), number(), number(), number() + 3).GetNormalized()
                    return q if precision == UsdGeom.XformOp.PrecisionDouble else Gf.Quatf(q)
                if op in ("RotateX", "RotateY", "RotateZ"):
                    return number(200)
                if op == "Scale":
                    same = dice.uniform(0.5, 2)
                    v = [same] * 3
                else:
                    v = [number(200 if op.startswith("Rotate") else 2) for _ in range(3)]
                return Gf.Vec3d(*v) if precision == UsdGeom.XformOp.PrecisionDouble else Gf.Vec3f(*v)

            if moves and dice.random() < 0.7:
                for time in sorted(dice.sample(range(13), dice.randint(1, 4))):
                    made.Set(value(), first + time)
            else:
                made.Set(value())
        if kind is UsdGeom.Camera:
            for time in (0, 5, 12):
                it.GetFocalLengthAttr().Set(dice.uniform(10, 80), first + time)
            it.GetVerticalApertureAttr().Set(dice.uniform(10, 30))
        if kind is UsdGeom.Mesh:
            it.GetPointsAttr().Set(Vt.Vec3fArray([Gf.Vec3f(number(), number(), number()) for _ in range(5)]))
            it.GetFaceVertexCountsAttr().Set([5])
            it.GetFaceVertexIndicesAttr().Set([0, 1, 2, 3, 4])
        if kind is UsdGeom.Points:
            it.GetPointsAttr().Set(Vt.Vec3fArray([Gf.Vec3f(number(), number(), number()) for _ in range(3)]))
        prims.append(it.GetPrim())
    stage.Save()
    return stage, prims


def is_one(prim):
    """The only child of a place, without operations, is one node with it."""
    alone = prim.GetParent().IsA(UsdGeom.Xform) and len(prim.GetParent().GetChildren()) == 1
    return alone and not prim.IsA(UsdGeom.Xform) and not UsdGeom.Xformable(prim).GetOrderedXformOps()


def comes_in(vides, seed):
    file = vides.scratch / f"foreign {seed}.usda"
    stage, prims = foreign(seed, file)
    first = stage.GetStartTimeCode()
    losses, compared = vides.convert(file, vides.scratch / "in.vid"), 0
    for prim in prims:
        if any(p.GetParent() == prim for p in prims if is_one(p)):
            continue
        told = vides.sampled(file, "--node", prim.GetParent().GetName() if is_one(prim) else prim.GetName())
        if told["fps"] != stage.GetTimeCodesPerSecond():
            faults.append(f"{file.name}: rate {told['fps']}")
        states = told.get("poses") or told["states"]
        for n, state in enumerate(states):
            code = told["first_frame"] + n
            if not first <= code <= first + 12:
                continue
            where = f"{file.name}: {prim.GetName()}, time code {code}"
            if "shear" in losses and shears(prim, code):
                continue
            compared += 1
            if "vrp" in state:
                compare_pose(prim, code, state, 1.0, where, ours=False)
                continue
            matrix = rows(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(code))
            wanted = np.array(state["matrix"]).reshape(4, 4).T
            note("matrix in", np.abs(matrix - wanted).max() / np.abs(matrix).max(), 1e-6, where)
    return compared


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("vides", nargs="+")
    parser.add_argument("--paths", type=int, default=40)
    parser.add_argument("--scenes", type=int, default=40)
    parser.add_argument("--foreign", type=int, default=40)
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        vides = Vides(chosen.vides, Path(scratch))
        files = [ROOT / "examples/car.vid", ROOT / "examples/pyramid.vid"]
        for make, count in ((paths.flight, chosen.paths), (scene, chosen.scenes)):
            for seed in range(count):
                files.append(Path(scratch) / f"{make.__name__} {seed}.vid")
                files[-1].write_text(make(seed))
        usda = Path(scratch) / "out.usda"
        for file in files:
            vides.convert(file, usda)
            frames_agree(vides, file, usda)
            comes_back(vides, file, usda)
        turn = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], float)
        for file in files[:2] + files[-6::2]:
            # From y to z or back, and a hundred times as large; then at another rate.
            up = "y" if 'up = "z"' in file.read_text() else "z"
            vides.convert(file, usda, "--up", up, "--scale", "100.0")
            frames_agree(vides, file, usda, ("--up", up, "--scale", "100.0"), 100.0, turn if up == "z" else turn.T)
            vides.convert(file, usda, "--fps", "60")
            frames_agree(vides, file, usda, ("--fps", "60"))
        compared = sum(comes_in(vides, seed) for seed in range(chosen.foreign))
        schemas = list(Path(pxr.__file__).parent.rglob("*.usda"))
        for file in schemas:
            is_read(vides, file)
        print(f"{len(files)} documents out and back, {chosen.foreign} stages in ({compared} states), {len(schemas)} schemas; at most " + ", ".join(f"{k} {v:.1e}" for k, v in worst.items()))
    for fault in faults[:20]:
        print(fault)
    if faults:
        raise SystemExit(f"{len(faults)} faults")


main()
