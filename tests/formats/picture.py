#!/usr/bin/env python3
"""One flight in five programs: a marked point of the object is within one pixel of where VIDES has it.

    picture.py VIDES [FILE.vid] [--pictures FOLDER]

At three frames, the points of the object are projected by the cameras of three.js, bpy, VTK and ParaView
as they have them, and by the pose of `vides sample`: x to the right and y down, from the upper left
corner of a picture of 1920 x 1080. With --pictures bpy, VTK and ParaView also draw.
"""

import argparse
import sys
import tomllib
from pathlib import Path

import numpy as np

import check
import turns

WIDTH, HEIGHT = 1920, 1080
PIXELS = 1.0


def projected(poses, at, points):
    """Pixels of points by our own conventions alone."""
    axes = turns.rotation(poses.view[at : at + 1], poses.up[at : at + 1], -1)[0]
    local = (np.asarray(points) - poses.position[at]) @ axes
    scale = HEIGHT / 2 / np.tan(np.radians(poses.fov[at]) / 2)
    x, y, z = local.T
    return np.stack([WIDTH / 2 + scale * x / -z, HEIGHT / 2 - scale * y / -z], -1)


def marked(file):
    """Places on the edges of a document's object."""
    found = tomllib.loads(file.read_text()).get("object", {})
    lines = found.get("polylines") or [found["points"]]
    # Places on the lines, so that there is one in every picture.
    found = []
    for a, b in ((a, b) for line in lines for a, b in zip(line, line[1:])):
        found += [(1 - t) * np.array(a, float) + t * np.array(b, float) for t in np.linspace(0, 1, 21)]
    return np.unique(np.array(found), axis=0)


def seen(poses, frames, points):
    """The point that is in the picture at all frames, nearest to the middle but not in it."""
    pixels = np.array([projected(poses, at, points) for at in frames])
    off = np.abs(pixels - [WIDTH / 2, HEIGHT / 2]) / [WIDTH / 2, HEIGHT / 2]
    ahead = [(points - poses.position[at]) @ poses.view[at] > 0 for at in frames]
    worst = np.where(np.all(ahead, axis=0), off.max(axis=(0, 2)), np.inf)
    worst[worst < 0.02] = np.inf
    return points[int(np.argmin(worst))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vides", type=Path)
    parser.add_argument("file", type=Path, nargs="?", default=check.ROOT / "examples" / "pyramid.vid")
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--checkers", action="store_true", help="with the files of plain_writers.py")
    options = parser.parse_args()
    scratch = check.TARGET / "picture"
    scratch.mkdir(parents=True, exist_ok=True)
    said, poses = check.sample(options.vides, options.file)
    flight = check.Flight("picture", options.file, said["space"]["up"], said["fps"], poses)
    total = len(poses.position)
    frames = [total // 8, total // 2, total - 2]
    point = seen(poses, frames, marked(options.file))
    wanted = np.array([projected(poses, at, [point])[0] for at in frames])
    print(f"point {point.tolist()} at frames {[at + 1 for at in frames]}: {np.round(wanted, 2).tolist()}")
    write = check.PlainWriter(None) if options.checkers else check.Writer(options.vides)
    count = check.Count()
    for form in check.formats():
        if form.name not in ("glb", "blender", "paraview", "vtk"):
            continue
        out = scratch / form.name / form.file
        out.parent.mkdir(exist_ok=True)
        try:
            write(form, flight, out)
        except RuntimeError as error:
            count.failure(form.name, error)
            continue
        for program in form.importers:
            job = check.job(form, flight, out) | {"aspect": WIDTH / HEIGHT, "width": WIDTH, "height": HEIGHT, "frames": frames}
            job["times"] = [job["times"][at] for at in frames]
            # The point in the axes of the program.
            upright = program.upright or form.upright or flight.up
            way = "" if upright == flight.up else flight.up + upright
            job["points"] = [turns.turn(point, way).tolist()]
            if options.pictures and program.large and "old" not in program.name:
                place = (options.pictures / f"{form.name}-{program.name.replace(' ', '-')}").resolve()
                place.mkdir(parents=True, exist_ok=True)
                # VTK writes all of its own accord.
                job["picture"] = str(place if form.name == "vtk" else place / "last.png")
            what = f"{form.name} by {program.name}"
            try:
                result = program.run([job], scratch)[0]
                if "error" in result:
                    raise RuntimeError(result["error"])
                given = result["frames"]
                if len(given) != len(frames):
                    given = [given[at] for at in frames]
                found = np.array([frame["pixels"][0] for frame in given])
            except (RuntimeError, OSError, ValueError, IndexError) as error:
                count.failure(what, error)
                continue
            away = float(np.linalg.norm(found - wanted, axis=-1).max())
            print(f"{what:<26}{'ok' if away <= PIXELS else 'FAILED':<8}{away:.2e} pixels  {np.round(found, 2).tolist()}")
            count.note(away <= PIXELS)
    print(f"{count.passed} passed, {count.failed} failed")
    return 1 if count.failed or not count.passed else 0


if __name__ == "__main__":
    sys.exit(main())
