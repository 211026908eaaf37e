"""What Blender makes of glTF files and of the scripts written for it: jobs as JSON from the file
that is named, what it found on standard output.

A job has `file`, `count` frames and `fps`; the poses of the active camera are asked of the
evaluated scene, its field of view of the projection that Blender itself renders with. Axes are
Blender's, z upright.
"""

import json
import math
import os
import sys
import time

# Blender and its add-ons talk on standard output, which is the result's alone.
results_out = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)

import bpy  # noqa: E402
from bpy_extras.object_utils import world_to_camera_view  # noqa: E402
from mathutils import Vector  # noqa: E402

WIDTH, HEIGHT = 1920, 1080


def at(scene, frame):
    whole = math.floor(frame)
    scene.frame_set(whole, subframe=frame - whole)


def pose(scene, points):
    graph = bpy.context.evaluated_depsgraph_get()
    camera = scene.camera.evaluated_get(graph)
    matrix = camera.matrix_world
    render = scene.render
    projection = camera.calc_matrix_camera(graph, x=render.resolution_x, y=render.resolution_y)
    frame = {
        "position": list(matrix.translation),
        "view": list(-matrix.col[2].xyz.normalized()),
        "up": list(matrix.col[1].xyz.normalized()),
        "fov": math.degrees(2 * math.atan(1 / projection[1][1])),
    }
    if points:
        seen = [world_to_camera_view(scene, camera, Vector(point)) for point in points]
        frame["pixels"] = [[s.x * render.resolution_x, (1 - s.y) * render.resolution_y] for s in seen]
    return frame


def camera_of(job):
    cameras = [thing for thing in bpy.data.objects if thing.type == "CAMERA"]
    named = [c for c in cameras if job.get("camera") in (c.name, c.parent and c.parent.name)]
    return (named or cameras)[0]


def load(job):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    if job["file"].endswith(".py"):
        with open(job["file"], encoding="utf-8") as file:
            program = compile(file.read(), job["file"], "exec")
        exec(program, {"__name__": "__main__", "__file__": job["file"]})
        scene = bpy.context.scene
        return scene, scene.frame_start, 1
    # Its glTF importer counts frames by the whole rate that the scene has, without its base; a
    # rate that is not whole leaves keys between frames.
    scene.render.fps, scene.render.fps_base = max(1, round(job["fps"])), 1
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    bpy.ops.import_scene.gltf(filepath=job["file"])
    scene.camera = camera_of(job)
    return scene, 0, scene.render.fps / job["fps"]


def frames_of(job):
    scene, first, step = load(job)
    start = time.process_time()
    frames = []
    for n in job.get("frames", range(job["count"])):
        at(scene, first + n * step)
        frames.append(pose(scene, job.get("points")))
    if job.get("picture"):
        scene.render.filepath = job["picture"]
        scene.render.engine = "CYCLES"
        scene.cycles.samples = 1
        bpy.ops.render.render(write_still=True)
    return {
        "frames": frames,
        "fps": scene.render.fps / scene.render.fps_base,
        "first": scene.frame_start,
        "last": scene.frame_end,
        "seconds": time.process_time() - start,
    }


def main():
    with open(sys.argv[1]) as file:
        jobs = json.load(file)
    results = []
    for job in jobs:
        try:
            results.append(frames_of(job))
        except Exception as error:
            results.append({"error": f"{type(error).__name__}: {error}"})
    json.dump(results, results_out)
    results_out.close()
    # Blender's own way out sometimes crashes as a module.
    os._exit(0)


main()
