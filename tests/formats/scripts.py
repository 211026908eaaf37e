#!/usr/bin/env python3
"""Tries what `vides convert` writes for Blender, ParaView and VTK where check.py's paths do not lead.

    scripts.py VIDES

Flights of 1, 3 and 1,200 frames, both axes upright, texts that try to become code, objects with
points, lines and triangles. The code of every script must be that of every other, whatever the
document holds; then Blender, ParaView and VTK run it, and each frame is compared.
"""

import argparse
import ast
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import check  # noqa: E402

# A text that ends whatever string it stands in, and leaves a file behind if it is run.
TRAP = "open('caught', 'w')"
HOSTILE = f"'''+{TRAP}+r'''\"\"\"\\' {TRAP} #</script><!-- {{}} %s \\u0027\\N{{DIGIT ONE}} \u2028\U0001f600 ROWS VIEW SHAPE \\"

DOCUMENT = """version = 1
title = {title}
fps = {fps}
first_frame = {first}
[base_speeds]
move_frames = {speed}
turn_frames = {speed}
zoom_frames = {speed}
roll_frames = {speed}
[space]
centre = [0.0, 0.0, 0.0]
half_size = 1.0
up = "{up}"
unit = {title}
[object]
points = [[-0.2, 0.0, 0.0], [0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3], [0.0, 0.0, -0.3]]
triangles = [[0, 1, 2]]
lines = [[2, 3]]
[[point]]
position = [-0.9, -0.3, 0.8]
[[point.orientation]]
target = [0.0, 0.1, 0.2]
[[point]]
position = [0.7, 0.5, -0.6]
[[point.orientation]]
target = [0.0, 0.1, 0.2]
zoom_mm = 90.0
roll_degrees = 170.0
[[point.orientation]]
offset = [0.1, -0.4, 0.3]
zoom_mm = 2.0
"""


def text(value):
    """As TOML has it: JSON, but for characters beyond 16 bits."""
    return '"' + "".join(c if c.isascii() and c not in '"\\' else f"\\U{ord(c):08x}" for c in value) + '"'


# Name, so many frames from the first on, axis, number of the first frame, rate, title.
CASES = [
    ("one frame", 1, "y", 1, 25.0, "one"),
    ("three frames", 3, "z", 0, 24.0, "three"),
    ("1,200 frames", 1200, "y", 101, 29.97, "long"),
    ("1,200 frames, z", 1200, "z", 1, 0.5, "long"),
    ("before frame 0", 40, "y", -7, 59.94, "early"),
    ("hostile", 20, "z", 1, 48.0, HOSTILE),
]


def flight(program, case, scratch):
    """A document, the poses of its first frames, and the option that chooses them."""
    name, frames, up, first, fps, title = case
    file = scratch / f"{name.replace(' ', '')}.vid"
    body = DOCUMENT.format(title=text(title), fps=fps, first=first, up=up, speed=20 + frames)
    file.write_text(body, encoding="utf-8")
    said, poses = check.sample(program, file)
    assert said["title"] == title and len(poses.position) >= frames, said["title"]
    some = (poses.position, poses.view, poses.up, poses.fov)
    poses = check.turns.Poses(*(values[:frames] for values in some))
    return check.Flight(name, file, up, fps, poses), ("--frames", f"{first}..{first + frames - 1}")


def parts(script):
    """The code of a script without its data, as Python parses it, and the data."""
    tree = ast.parse(script.read_text(encoding="ascii"))
    data = [node for node in tree.body if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "DATA"]
    (data,) = data
    value, data.value = ast.literal_eval(data.value), ast.Constant(None)
    return ast.dump(tree), json.loads(value)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vides", type=Path)
    options = parser.parse_args()
    scratch = check.TARGET / "scripts"
    scratch.mkdir(parents=True, exist_ok=True)
    flights = [flight(options.vides, case, scratch) for case in CASES]
    titles = {case[0]: case[5] for case in CASES}
    count = check.Count()
    for form in check.formats():
        if form.name not in ("blender", "paraview", "vtk"):
            continue
        written, codes, bad = [], set(), []
        for one, frames in flights:
            out = scratch / f"{form.name}-{one.file.stem}.py"
            check.vides(options.vides, "convert", one.file, out, "--to", form.name, "--size", "96x54", *frames)
            code, data = parts(out)
            codes.add(code)
            if data["title"] != titles[one.name] or data["unit"] != titles[one.name]:
                bad.append(f"{one.name}: {data['title']!r}")
            written.append((one, out))
        right = len(codes) == 1 and not bad
        print(f"{form.name + ' code':<26}{'ok' if right else 'FAILED':<8}{len(written)} files  {' '.join(bad)}")
        count.note(right)
        for importer in form.importers:
            try:
                worst = check.through(form, importer, written, scratch)
            except (RuntimeError, OSError, ValueError) as error:
                count.failure(f"{form.name} by {importer.name}", error)
                continue
            count.note(worst.say(f"{form.name} by {importer.name}"))
        if form.back:
            count.note(check.back_again(form, options.vides, written).say(f"{form.name} back"))
    caught = [place for place in (Path("caught"), scratch / "caught", HERE / "caught") if place.exists()]
    count.note(not caught)
    print(f"{count.passed} passed, {count.failed} failed")
    return 1 if count.failed else 0


if __name__ == "__main__":
    sys.exit(main())
