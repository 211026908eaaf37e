#!/usr/bin/env python3
"""Holds what `vides convert` writes against the programs that others read it with.

    check.py VIDES [--large] [--paths N] [--only FORMAT,...]   all formats (the large importers too)
    check.py VIDES --checkers [--large]   tries the checkers: with files of plain_writers.py in place of
                                          VIDES's, right ones and ones with a fault that must be found

Every file is written from a random path (paths.py) or from examples/car.vid, read by the real importer,
and each frame is compared with what `vides sample` says; then it comes in again with
`--as keys` and is sampled. Each importer starts once for all files.
"""

import argparse
import contextlib
import json
import os
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import paths  # noqa: E402
import plain_readers  # noqa: E402
import plain_writers  # noqa: E402
import turns  # noqa: E402

ROOT = HERE.parents[1]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target").resolve() / "formats"

POSITION, ANGLE, FOV = 1e-6, 0.01, 0.001


@dataclass
class Flight:
    """A document, and what VIDES itself says of its shown camera."""

    name: str
    file: Path
    up: str
    fps: float
    poses: turns.Poses
    camera: str = "camera"


@dataclass
class Format:
    """How a file is called, and what of a pose it holds."""

    name: str
    file: str
    upright: str = ""  # the axis that is upright in every such file; "" as in the document
    fov: bool = True
    rate: bool = True  # whether a rate is in it, or what comes to one
    back: bool = True  # whether VIDES reads it
    importers: list = field(default_factory=list)  # pairs of a name and how it is called
    options: tuple = ()

    def way(self, flight):
        return "" if self.upright in ("", flight.up) else flight.up + self.upright


@dataclass
class Importer:
    """A program of others, started once for many files."""

    name: str
    command: list
    upright: str = ""  # the axis that it has upright itself, whatever the file says
    large: bool = False
    environment: dict = field(default_factory=dict)
    precise: bool = True

    def run(self, jobs, scratch):
        path = scratch / f"{self.name}.jobs.json"
        path.write_text(json.dumps(jobs))
        environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"} | self.environment
        done = subprocess.run([*map(str, self.command), str(path)], capture_output=True, text=True, env=environment, timeout=3600)
        (scratch / f"{self.name}.log").write_text(done.stderr)
        if done.returncode:
            raise RuntimeError(f"ended with {done.returncode}: {done.stderr.strip()[-400:]}")
        return json.loads(done.stdout)


def importer(name, program, script, **rest):
    return Importer(name, [*program, HERE / "importers" / script], **rest)


SMALL = [TARGET / "small" / "bin" / "python"]
NODE = ["node"]


def formats():
    # Modules are looked for from where the script lies: it is run from a copy beside them.
    three = Importer("three.js", ["node", TARGET / "node" / "three.mjs"])
    usd = importer("usd-core", SMALL, "usd.py")
    evo = importer("evo", SMALL, "evo_.py")
    colmap = importer("pycolmap", SMALL, "colmap.py")
    blenders = [
        importer(f"bpy {name}", [TARGET / f"bpy-{name}" / "bin" / "python"], "blender.py", upright="z", large=True)
        for name in ("new", "old")
    ]
    vtk = importer("vtk", [TARGET / "vtk" / "bin" / "python"], "vtk_.py", large=True)
    paraview = importer("pvpython", [sys.executable, str(HERE / "on_a_screen.py"), "pvpython", "--force-offscreen-rendering"], "paraview_.py", large=True)
    nerfstudio = importer(
        "nerfstudio", ["/usr/bin/python3"], "nerfstudio_.py", large=True,
        environment={"PYTHONPATH": str(TARGET / "nerfstudio")},
    )  # fmt: skip
    plain = Importer("definition", [])
    return [
        Format("glb", "flight.glb", "y", importers=[three, *blenders]),
        Format("gltf", "flight.gltf", "y", importers=[three, blenders[0]]),
        Format("usda", "flight.usda", importers=[usd]),
        Format("blender", "flight.py", "z", back=False, importers=blenders, options=("--to", "blender")),
        Format("paraview", "flight.py", importers=[paraview], options=("--to", "paraview")),
        Format("vtk", "flight.py", back=False, importers=[vtk], options=("--to", "vtk")),
        Format("nerfstudio", "camera_path.json", "z", importers=[nerfstudio]),
        Format("transforms", "transforms.json", "z", rate=False, importers=[plain]),
        Format("instant-ngp", "base_cam.json", "z", rate=False, importers=[plain]),
        Format("cameras", "cameras.json", rate=False, importers=[plain]),
        Format("tum", "flight.tum", fov=False, rate=False, importers=[evo], options=("--to", "tum")),
        Format("euroc", "flight.csv", fov=False, rate=False, importers=[evo], options=("--to", "euroc")),
        Format("kitti", "flight.kitti", fov=False, rate=False, importers=[evo], options=("--to", "kitti")),
        Format("matrices", "flight.npy", fov=False, rate=False, importers=[plain]),
        Format("open3d", "camera_trajectory.json", rate=False, importers=[plain]),
        Format("colmap", "model", rate=False, importers=[colmap], options=("--to", "colmap")),
        Format("osg", "flight.path", fov=False, rate=False, importers=[plain], options=("--to", "osg")),
        Format("chan", "flight.chan", rate=False, importers=[plain]),
        Format("csv", "flight.csv", importers=[plain]),
        Format("json", "flight.json", importers=[plain]),
        Format("ascii", "flight.txt", rate=False, importers=[plain]),
    ]


# ---- Comparing -------------------------------------------------------------------


def degrees_between(a, b):
    """By the tangent of half the angle, which is exact for small ones."""
    a, b = turns.unit(a), turns.unit(b)
    return np.degrees(2 * np.arctan2(np.linalg.norm(a - b, axis=-1), np.linalg.norm(a + b, axis=-1)))


FAULTS = ("position", "view", "up", "fov", "frame", "count", "axis")


@dataclass
class Worst:
    """The largest differences over all files, and where they were."""

    position: float = 0.0
    angle: float = 0.0
    fov: float = 0.0
    files: int = 0
    frames: int = 0
    bad: list = field(default_factory=list)

    def compare(self, name, wanted, found, fov=True):
        self.files += 1
        if len(found.position) != len(wanted.position):
            self.bad.append(f"{name}: {len(found.position)} frames in place of {len(wanted.position)}")
            return
        self.frames += len(wanted.position)
        diagonal = np.linalg.norm(np.ptp(wanted.position, axis=0))
        away = np.linalg.norm(found.position - wanted.position, axis=-1) / (diagonal or 1)
        turned = np.maximum(degrees_between(found.view, wanted.view), degrees_between(found.up, wanted.up))
        kinds = [("position", away, POSITION), ("angle", turned, ANGLE)]
        if fov:
            if found.fov is None:
                self.bad.append(f"{name}: no field of view")
                return
            kinds.append(("fov", np.abs(found.fov - wanted.fov), FOV))
        for kind, values, most in kinds:
            # NaN is worse than any number.
            values = np.nan_to_num(values, nan=np.inf)
            worst = float(values.max(initial=0))
            setattr(self, kind, max(getattr(self, kind), worst))
            if worst > most:
                self.bad.append(f"{name}: {kind} {worst:.3g} at frame {int(values.argmax()) + 1} of {len(values)}")

    def say(self, what, fov=True):
        figures = f"position {self.position:.1e}  angle {self.angle:.1e}°"
        figures += f"  fov {self.fov:.1e}°" if fov else ""
        verdict = "ok" if not self.bad else "FAILED"
        print(f"{what:<26}{verdict:<8}{self.files} files, {self.frames} frames  {figures}", flush=True)
        for line in self.bad[:3]:
            print(f"    {line}")
        if len(self.bad) > 3:
            print(f"    and {len(self.bad) - 3} more")
        return not self.bad


# ---- VIDES -------------------------------------------------------------------------


def vides(program, *words):
    done = subprocess.run([str(program), *map(str, words)], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"vides {words[0]} ended with {done.returncode}: {done.stderr.strip()[-300:]}")
    return done


def sample(program, file, node=None):
    words = ["sample", file, "--format", "json", *(["--node", node] if node else [])]
    found = json.loads(vides(program, *words).stdout)
    entries = found.get("poses") or found["states"]
    rows = np.array([[*e["vrp"], *e["vpn"], *e["vup"], e["zoom"]] for e in entries], float)
    return found, plain_readers.ten(rows)


def sample_shown(program, file):
    """The shown camera of a document that was read: a path, or a scene's camera with keys."""
    try:
        return sample(program, file)
    except RuntimeError as error:
        names = re.findall(r'\[\[node\]\]\nname = "(.*)"\nkind = "camera"', Path(file).read_text())
        if not names:
            raise error
        return sample(program, file, names[0])


def flights(program, count, scratch):
    result = []
    for seed in range(count):
        file = scratch / f"flight{seed}.vid"
        file.write_text(paths.flight(seed))
        said, poses = sample(program, file)
        result.append(Flight(f"flight {seed}", file, said["space"]["up"], said["fps"], poses))
    car = ROOT / "examples" / "car.vid"
    said, poses = sample(program, car, "camera")
    result.append(Flight("car", car, "y", said["fps"], poses))
    return result


# ---- One format ---------------------------------------------------------------------


class Writer:
    """Writes by `vides convert`."""

    def __init__(self, program):
        self.program = program

    def __call__(self, form, flight, out):
        vides(self.program, "convert", flight.file, out, *form.options)


class PlainWriter:
    """Writes by plain_writers.py, with a fault if one is asked for."""

    def __init__(self, fault):
        self.fault = fault

    def __call__(self, form, flight, out):
        write = plain_writers.WRITERS.get(form.name)
        if write is None:
            raise LookupError("no plain writer")
        poses = flight.poses.turned(form.way(flight))
        place, view, up, fov = poses.position.copy(), poses.view.copy(), poses.up.copy(), poses.fov.copy()
        last = len(place) - 1
        if self.fault == "position":
            place[last] += 3e-6 * np.linalg.norm(np.ptp(place, axis=0))
        elif self.fault == "view":
            view[last] += np.radians(0.02) * up[last]
        elif self.fault == "up":
            up[last] += np.radians(0.02) * np.cross(view[last], up[last])
        elif self.fault == "fov":
            fov[last] += 0.002 if fov[last] < 90 else -0.002
        elif self.fault == "frame":
            place, view, up, fov = (np.concatenate([v[:1], v[:-1]]) for v in (place, view, up, fov))
        elif self.fault == "count":
            place, view, up, fov = (v[:-1] for v in (place, view, up, fov))
        elif self.fault == "axis":
            place, view, up = (turns.turn(v, "yz") for v in (place, view, up))
        poses = turns.Poses(place, view, up, fov)
        write(poses, flight.fps, out, **({"up": flight.up} if form.name == "usda" else {}))


def job(form, flight, out):
    count = len(flight.poses.position)
    times = (np.arange(count) / flight.fps).astype(np.float32).astype(float).tolist()
    return {
        "file": str(out), "format": form.name, "camera": flight.camera, "count": count, "fps": flight.fps, "times": times,
    }  # fmt: skip


def by_definition(form, out):
    name = {"json": "json_", "instant-ngp": "instant_ngp"}.get(form.name, form.name)
    read = getattr(plain_readers, name)
    found = read(out)
    return found if isinstance(found, tuple) else (found, None)


def claims(form, flight, result):
    """What else an importer tells of a file: its rate, range and upright axis."""
    count = len(flight.poses.position)
    near = 1e-6 * flight.fps
    # Blender takes its rate and range from scripts only.
    if form.name in ("usda", "nerfstudio", "blender") and abs(result.get("fps", 0) - flight.fps) > near:
        yield f"{result.get('fps')} frames per second in place of {flight.fps}"
    if form.name in ("usda", "blender") and result["last"] - result["first"] != count - 1:
        yield f"range {result['first']} to {result['last']} for {count} frames"
    if form.name == "usda" and result["up"] != flight.up:
        yield f"{result['up']} upright in place of {flight.up}"
    if "times" in result and len(result["times"]) == count:
        most = np.abs(np.array(result["times"]) - np.arange(count) / flight.fps).max()
        if most > 1e-6:
            yield f"times are {most:.3g} s off"
    if form.name in ("glb", "gltf") and "duration" in result:
        if abs(result["duration"] - (count - 1) / flight.fps) > 1e-6 * max(1, count / flight.fps):
            yield f"lasts {result['duration']} s in place of {(count - 1) / flight.fps}"
    yield from result.get("warnings", [])


def through(form, program, written, scratch):
    """One importer over all files of a format."""
    worst = Worst()
    if program.command:
        results = program.run([job(form, flight, out) for flight, out in written], scratch)
    else:
        results = []
        for flight, out in written:
            try:
                poses, times = by_definition(form, out)
                results.append({"poses": poses} | ({} if times is None else {"times": times.tolist()}))
            except Exception as error:
                results.append({"error": f"{type(error).__name__}: {error}"})
    for (flight, out), result in zip(written, results, strict=True):
        if "error" in result:
            worst.bad.append(f"{flight.name}: {result['error']}")
            continue
        found = result.get("poses") or turns.Poses.of(result["frames"])
        wanted = flight.poses.turned(form.way(flight))
        # From the program's axes into the file's.
        upright = form.upright or flight.up
        if program.upright and program.upright != upright:
            found = found.turned(program.upright + upright)
        if form.name == "ascii":
            # Four decimals, as the thesis has them.
            wanted = turns.Poses(*(np.round(v, 4) for v in (wanted.position, wanted.view, wanted.up)), wanted.fov)
            wanted.fov = np.degrees(2 * np.arctan(12 / np.round(12 / np.tan(np.radians(wanted.fov) / 2), 4)))
        worst.compare(flight.name, wanted, found, form.fov)
        worst.bad += [f"{flight.name}: {line}" for line in claims(form, flight, result)]
    return worst


def back_again(form, program, written):
    worst = Worst()
    for flight, out in written:
        back = out.parent / f"{out.name}.back.vid"
        words = ["convert", out, back, "--from", form.name, "--as", "keys"]
        if not form.rate:
            words += ["--fps", flight.fps]
        try:
            vides(program, *words)
            _, found = sample_shown(program, back)
        except (RuntimeError, ValueError, KeyError) as error:
            worst.bad.append(f"{flight.name}: {error}")
            continue
        wanted = flight.poses.turned(form.way(flight))
        if form.name == "ascii":
            wanted, _ = by_definition(form, out)
        if not form.fov:
            wanted = turns.Poses(wanted.position, wanted.view, wanted.up, np.full(len(wanted.position), np.degrees(2 * np.arctan(0.5))))
        worst.compare(flight.name, wanted, found)
    return worst


def validate(written, scratch):
    """The Khronos validator: no error, no warning."""
    program = Importer("validator", ["node", TARGET / "node" / "validate.mjs"])
    bad = []
    infos = set()
    for (flight, _), result in zip(written, program.run([{"file": str(out)} for _, out in written], scratch), strict=True):
        if "error" in result:
            bad.append(f"{flight.name}: {result['error']}")
        elif result["errors"] or result["warnings"]:
            bad += [f"{flight.name}: {line}" for line in result["messages"][:2]]
        infos |= {line.split()[1] for line in result.get("messages", []) if line.startswith("info")}
    return bad, infos


class Count:
    def __init__(self):
        self.passed = self.failed = 0

    def note(self, right):
        self.passed += right
        self.failed += not right

    def failure(self, what, words):
        print(f"{what:<26}FAILED  {words}", flush=True)
        self.note(False)


def check(form, options, everything, write, count, scratch):
    folder = scratch / form.name
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for flight in everything:
        place = folder / flight.name.replace(" ", "")
        place.mkdir(exist_ok=True)
        try:
            write(form, flight, place / form.file)
        except LookupError:
            return
        except RuntimeError as error:
            count.failure(form.name, f"{flight.name}: {error}")
            return
        written.append((flight, place / form.file))
    if form.name in ("glb", "gltf"):
        try:
            bad, infos = validate(written, scratch)
        except RuntimeError as error:
            bad, infos = [str(error)], set()
        print(f"{form.name + ' by validator':<26}{'FAILED' if bad else 'ok':<8}{len(written)} files  infos: {', '.join(sorted(infos)) or 'none'}")
        for line in bad[:4]:
            print(f"    {line}")
        count.note(not bad)
    for program in form.importers:
        if program.large and not options.large:
            continue
        what = f"{form.name} by {program.name}"
        try:
            count.note(through(form, program, written, scratch).say(what, form.fov))
        except (RuntimeError, OSError, ValueError, subprocess.TimeoutExpired) as error:
            count.failure(what, error)
    if form.back and isinstance(write, Writer):
        count.note(back_again(form, options.vides, written).say(f"{form.name} back"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vides", type=Path)
    parser.add_argument("--large", action="store_true")
    parser.add_argument("--paths", type=int, default=40)
    parser.add_argument("--only", default="")
    parser.add_argument("--checkers", action="store_true")
    options = parser.parse_args()
    only = {name for name in options.only.split(",") if name}
    chosen = [form for form in formats() if not only or form.name in only]
    scratch = TARGET / ("plain" if options.checkers else "files")
    scratch.mkdir(parents=True, exist_ok=True)
    everything = flights(options.vides, options.paths, scratch)
    count = Count()
    for form in chosen:
        check(form, options, everything, PlainWriter(None) if options.checkers else Writer(options.vides), count, scratch)
    for fault in FAULTS if options.checkers else ():
        find(fault, chosen, options, everything[:2], count, scratch)
    print(f"{count.passed} passed, {count.failed} failed")
    return 1 if count.failed or not count.passed else 0


def find(fault, chosen, options, some, count, scratch):
    """Every importer must say that a file with a fault is wrong."""
    overlooked = []
    for form in chosen:
        if form.name not in plain_writers.WRITERS or (fault == "fov" and not form.fov):
            continue
        each = Count()
        with open(os.devnull, "w") as nowhere, contextlib.redirect_stdout(nowhere):
            check(form, options, some, PlainWriter(fault), each, scratch / fault)
        # The validator does not see where a camera is.
        if each.passed - (form.name in ("glb", "gltf")):
            overlooked.append(form.name)
    count.note(not overlooked)
    print(f"a fault of {fault:<15}{'OVERLOOKED by ' + ', '.join(overlooked) if overlooked else 'found'}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
