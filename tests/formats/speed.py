#!/usr/bin/env python3
"""How long formats take beside the programs of others; all ratios are of one run.

    speed.py VIDES [frames|mesh]

frames   100,000 frames to .glb, and the same by bpy: keys inserted as arrays, then its exporter.
         Processor time, starting not counted; at most 1/20.
mesh     a mesh of 100 MB of .glb, read by VIDES (`vides info` of a scene that names it, `vides convert`
         of the file itself) and by trimesh, which joins points as VIDES does; no slower, and
         memory at most four times the file.
"""

import argparse
import json
import multiprocessing
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

import check

FRAMES = 100_000
RATIO = 20
MEGABYTES = 100


def measured(*command):
    """Processor seconds and the largest memory in bytes of a process; and what it said."""
    read, write = os.pipe()
    child = subprocess.Popen([str(word) for word in command], stdout=write, stderr=subprocess.PIPE)
    os.close(write)
    with os.fdopen(read) as out:
        said = out.read()
    words = child.stderr.read().decode()
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise RuntimeError(f"{command[0]} ended with {child.returncode}: {words.strip()[-300:]}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024, said


def path(frames):
    """A flight along a corner with that many frames."""
    half = frames // 2
    points = [([0, 0, 3], half - 1, 20), ([1, 1, 2], frames - half, 60), ([2, 0, 3], 0, 30)]
    lines = ["version = 1", "fps = 25.0"]
    for place, count, zoom in points:
        lines += ["[[point]]", f"position = {[float(v) for v in place]}", "[[point.orientation]]"]
        lines += ["target = [0.0, 0.5, 0.0]", f"zoom_mm = {float(zoom)}", *([f"frames = {count}"] if count else [])]
    return "\n".join(lines) + "\n"


BLENDER = """
import json, sys, time, os
import numpy as np
import bpy
from bpy_extras import anim_utils
rows = np.load(sys.argv[1])
n = len(rows)
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
data = bpy.data.cameras.new("camera")
camera = bpy.data.objects.new("camera", data)
scene.collection.objects.link(camera)
scene.camera = camera
camera.rotation_mode = "QUATERNION"
scene.frame_start, scene.frame_end, scene.render.fps = 1, n, 25
start = time.process_time()
def curves_of(owner):
    owner.animation_data_create()
    action = bpy.data.actions.new("flight")
    owner.animation_data.action = action
    if hasattr(action, "fcurves"):
        return action.fcurves
    slot = action.slots.new(owner.id_type, "flight")
    owner.animation_data.action_slot = slot
    return anim_utils.action_ensure_channelbag_for_slot(action, slot).fcurves
frames = np.arange(1, n + 1)
def insert(curves, what, index, values):
    curve = curves.new(what, index=index)
    curve.keyframe_points.add(n)
    curve.keyframe_points.foreach_set("co", np.column_stack([frames, values]).astype(np.float32).ravel())
    curve.keyframe_points.foreach_set("interpolation", np.full(n, 1, np.int32))
    curve.update()
curves = curves_of(camera)
for k in range(3): insert(curves, "location", k, rows[:, k])
for k in range(4): insert(curves, "rotation_quaternion", k, rows[:, 3 + k])
insert(curves_of(data), "lens", 0, rows[:, 7])
inserted = time.process_time()
options = {}
known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
if "export_pointer_animation" in known and sys.argv[3] == "pointer":
    options["export_pointer_animation"] = True
    options["export_animation_mode"] = "SCENE"
bpy.ops.export_scene.gltf(filepath=sys.argv[2], export_format="GLB", export_cameras=True, export_animations=True, **options)
end = time.process_time()
print("\\nRESULT", json.dumps([inserted - start, end - inserted, os.path.getsize(sys.argv[2])]), flush=True)
os._exit(0)
"""


def frames(program, scratch):
    """Whether VIDES is fast enough."""
    long, short = scratch / "long.vid", scratch / "short.vid"
    long.write_text(path(FRAMES))
    short.write_text(path(4))
    said, poses = check.sample(program, long)
    count = len(poses.position)
    out = scratch / "long.glb"
    ours, memory, _ = min(measured(program, "convert", long, out) for _ in range(3))
    start, _, _ = min(measured(program, "convert", short, scratch / "short.glb") for _ in range(3))
    ours -= start
    import turns

    quaternions = turns.one_hemisphere(turns.quaternions(poses.view, poses.up, -1))
    zoom = 12 / np.tan(np.radians(poses.fov) / 2)
    np.save(scratch / "long.npy", np.column_stack([poses.position, quaternions, zoom]))
    script = scratch / "bpy_frames.py"
    script.write_text(BLENDER)
    best = None
    for kind in ("plain", "pointer"):
        theirs = scratch / f"bpy-{kind}.glb"
        _, _, words = measured(check.TARGET / "bpy-new/bin/python", script, scratch / "long.npy", theirs, kind)
        keys, export, size = json.loads(words.rsplit("RESULT", 1)[1])
        print(f"bpy, {kind:<8} keys {keys:.2f} s, export {export:.2f} s, {size / 1e6:.1f} MB")
        best = min(best or keys + export, keys + export)
    ratio = best / ours
    print(f"vides          {ours:.3f} s beside {start:.3f} s to start, {out.stat().st_size / 1e6:.1f} MB, memory {memory / 1e6:.0f} MB")
    print(f"{count} frames: bpy takes {ratio:.0f} times as long; at least {RATIO} is wanted")
    return ratio >= RATIO


def mesh_file(file):
    """A wavy sheet of triangles, of about 100 MB."""
    side = int((MEGABYTES * 1e6 / 36) ** 0.5)
    x, y = np.meshgrid(np.linspace(-1, 1, side, dtype="<f4"), np.linspace(-1, 1, side, dtype="<f4"))
    points = np.stack([x, y, 0.1 * np.sin(7 * x) * np.cos(9 * y)], -1).astype("<f4").reshape(-1, 3)
    at = np.arange(side * side, dtype="<u4").reshape(side, side)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel()
    faces = np.concatenate([np.column_stack([a, b, c]), np.column_stack([b, d, c])]).astype("<u4")
    import struct

    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "sheet", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": points.nbytes + faces.nbytes}],
        "bufferViews": [
            {"buffer": 0, "byteLength": points.nbytes},
            {"buffer": 0, "byteOffset": points.nbytes, "byteLength": faces.nbytes},
        ],
        "accessors": [
            {
                "bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                "min": points.min(0).tolist(), "max": points.max(0).tolist(),
            },
            {"bufferView": 1, "componentType": 5125, "count": faces.size, "type": "SCALAR"},
        ],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    blob = points.tobytes() + faces.tobytes()
    with file.open("wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob)))
        out.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        out.write(struct.pack("<II", len(blob), 0x004E4942) + blob)


TRIMESH = """
import sys, time, json
import trimesh
start = time.process_time()
scene = trimesh.load(sys.argv[1])
mesh = scene.to_mesh() if hasattr(scene, "to_mesh") else scene.dump(concatenate=True)
print(json.dumps([time.process_time() - start, len(mesh.vertices), len(mesh.faces)]))
"""


def mesh(program, scratch):
    """Whether VIDES is as fast and small as wanted."""
    file = scratch / "sheet.glb"
    if not file.exists():
        # In a process of its own: what this one has held counts as its children's largest memory.
        maker = multiprocessing.Process(target=mesh_file, args=(file,))
        maker.start()
        maker.join()
    size = file.stat().st_size
    named = scratch / "sheet.vid"
    named.write_text(
        'version = 1\n[[node]]\nname = "sheet"\nkind = "object"\n[node.mesh]\nfile = "sheet.glb"\n'
        '[[node]]\nname = "camera"\nkind = "camera"\n'
    )
    _, theirs_memory, said = measured(check.TARGET / "small/bin/python", "-c", TRIMESH, file)
    theirs, points, faces = json.loads(said)
    print(f"file            {size / 1e6:.0f} MB, {points} points, {faces} triangles")
    print(f"trimesh         {theirs:.2f} s, memory {theirs_memory / size:.1f} times the file")
    right = True
    for what, words in (("info", ["info", named]), ("convert", ["convert", file, scratch / "from_sheet.vid"])):
        try:
            ours, memory, _ = min(measured(program, *words) for _ in range(2))
        except RuntimeError as error:
            print(f"vides {what:<10}FAILED  {error}")
            right = False
            continue
        print(f"vides {what:<10}{ours:.2f} s, memory {memory / size:.1f} times the file")
        right &= ours <= theirs and memory <= 4 * size
    return right


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vides", type=Path)
    parser.add_argument("what", nargs="?", choices=["frames", "mesh"])
    options = parser.parse_args()
    scratch = check.TARGET / "speed"
    scratch.mkdir(parents=True, exist_ok=True)
    count = check.Count()
    for what in (frames, mesh):
        if options.what in (None, what.__name__):
            try:
                count.note(what(options.vides, scratch))
            except RuntimeError as error:
                count.failure(what.__name__, error)
    print(f"{count.passed} passed, {count.failed} failed")
    return 1 if count.failed else 0


if __name__ == "__main__":
    sys.exit(main())
