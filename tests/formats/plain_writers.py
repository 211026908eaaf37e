"""Poses in other formats, as docs/reference/formats.md tells: what the checkers themselves are tried with.

Nothing here is VIDES; `check.py --self` writes with it, so that a checker that is wrong, or an
importer that does otherwise than was thought, is seen before any exporter is.
"""

import json
import struct

import numpy as np

import turns


def gltf(poses, fps, path):
    """A camera node with one LINEAR key a frame, its field of view by KHR_animation_pointer."""
    count = len(poses.position)
    times = (np.arange(count) / fps).astype("<f4")
    turn = turns.quaternions(poses.view, poses.up, looks=-1)
    turn = turns.one_hemisphere(turn)[:, [1, 2, 3, 0]].astype("<f4")
    place = poses.position.astype("<f4")
    angle = np.radians(poses.fov).astype("<f4")
    blob, views, accessors = b"", [], []
    for data, kind in ((times, "SCALAR"), (place, "VEC3"), (turn, "VEC4"), (angle, "SCALAR")):
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": data.nbytes})
        accessor = {"bufferView": len(views) - 1, "componentType": 5126, "count": count, "type": kind}
        if not accessors:
            accessor |= {"min": [float(data.min())], "max": [float(data.max())]}
        accessors.append(accessor)
        blob += data.tobytes()
    pointer = {"pointer": "/cameras/0/perspective/yfov"}
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_animation_pointer"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "camera", "camera": 0, "translation": place[0].tolist(), "rotation": turn[0].tolist()}],
        "cameras": [
            {
                "name": "camera",
                "type": "perspective",
                "perspective": {"yfov": float(angle[0]), "aspectRatio": 16 / 9, "znear": 0.01, "zfar": 1000.0},
            }
        ],
        "animations": [
            {
                "name": "flight",
                "samplers": [{"input": 0, "output": n, "interpolation": "LINEAR"} for n in (1, 2, 3)],
                "channels": [
                    {"sampler": 0, "target": {"node": 0, "path": "translation"}},
                    {"sampler": 1, "target": {"node": 0, "path": "rotation"}},
                    {"sampler": 2, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": pointer}}},
                ],
            }
        ],
        "buffers": [{"byteLength": len(blob)}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    parts = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(parts)) + parts)


def usda(poses, fps, path, up="y"):
    """A camera with the operations of a VIDES node, a key a frame from 1."""
    turn = turns.one_hemisphere(turns.quaternions(poses.view, poses.up, looks=-1))
    zoom = 12 / np.tan(np.radians(poses.fov) / 2)

    def samples(values):
        return "".join(f"\n            {n + 1}: {value}," for n, value in enumerate(values)) + "\n        "

    def row(values):
        return "(" + ", ".join(repr(float(value)) for value in values) + ")"

    count = len(turn)
    path.write_text(
        f'''#usda 1.0
(
    defaultPrim = "flight"
    startTimeCode = 1
    endTimeCode = {count}
    timeCodesPerSecond = {fps}
    framesPerSecond = {fps}
    metersPerUnit = 1
    upAxis = "{up.upper()}"
)

def Xform "flight"
{{
    def Camera "camera"
    {{
        float2 clippingRange = (0.01, 1000)
        float focalLength = 24
        float focalLength.timeSamples = {{{samples(repr(float(z) / 100) for z in zoom)}}}
        float horizontalAperture = {0.24 * 16 / 9}
        float verticalAperture = 0.24
        token projection = "perspective"
        quatd xformOp:orient.timeSamples = {{{samples(map(row, turn))}}}
        double3 xformOp:translate.timeSamples = {{{samples(map(row, poses.position))}}}
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]
    }}
}}
'''
    )


def matrices(poses, looks=-1):
    """Camera to world, 4 by 4: columns x right, y up, −z forward, or by `looks` = 1 y down, z forward."""
    result = np.tile(np.eye(4), (len(poses.position), 1, 1))
    result[:, :3, :3] = turns.rotation(poses.view, poses.up, looks)
    result[:, :3, 3] = poses.position
    return result


def nerfstudio(poses, fps, path):
    entries = [
        {"camera_to_world": matrix.ravel().tolist(), "fov": float(fov), "aspect": 16 / 9}
        for matrix, fov in zip(matrices(poses), poses.fov)
    ]
    path.write_text(
        json.dumps(
            {
                "camera_type": "perspective",
                "render_width": 1920,
                "render_height": 1080,
                "fps": fps,
                "seconds": len(entries) / fps,
                "is_cycle": False,
                "smoothness_value": 0.0,
                "camera_path": entries,
                "keyframes": [],
            }
        )
    )


def transforms(poses, fps, path):
    entries = []
    for matrix, fov in zip(matrices(poses), poses.fov):
        focal = 540 / np.tan(np.radians(fov) / 2)
        entries.append({"transform_matrix": matrix.tolist(), "fl_x": focal, "fl_y": focal})
    path.write_text(json.dumps({"w": 1920, "h": 1080, "cx": 960, "cy": 540, "frames": entries}))


def cameras(poses, fps, path):
    entries = []
    for n, (matrix, fov) in enumerate(zip(matrices(poses, 1), poses.fov)):
        focal = 540 / np.tan(np.radians(fov) / 2)
        entries.append(
            {
                "id": n,
                "img_name": f"{n + 1:05}",
                "width": 1920,
                "height": 1080,
                "position": matrix[:3, 3].tolist(),
                "rotation": matrix[:3, :3].tolist(),
                "fx": focal,
                "fy": focal,
            }
        )
    path.write_text(json.dumps(entries))


def tum(poses, fps, path):
    turn = turns.quaternions(poses.view, poses.up, looks=1)
    rows = np.column_stack([np.arange(len(turn)) / fps, poses.position, turn[:, [1, 2, 3, 0]]])
    path.write_text("".join(" ".join(map(repr, row)) + "\n" for row in rows.tolist()))


def osg(poses, fps, path):
    turn = turns.quaternions(poses.view, poses.up, looks=-1)
    rows = np.column_stack([np.arange(len(turn)) / fps, poses.position, turn[:, [1, 2, 3, 0]]])
    path.write_text("".join(" ".join(map(repr, row)) + "\n" for row in rows.tolist()))


def kitti(poses, fps, path):
    rows = matrices(poses, 1)[:, :3].reshape(-1, 12)
    path.write_text("".join(" ".join(map(repr, row)) + "\n" for row in rows.tolist()))


def numpy_(poses, fps, path):
    np.save(path, matrices(poses, 1))


def open3d(poses, fps, path):
    entries = []
    for matrix, fov in zip(matrices(poses, 1), poses.fov):
        focal = float(540 / np.tan(np.radians(fov) / 2))
        intrinsic = [focal, 0, 0, 0, focal, 0, 959.5, 539.5, 1]
        entries.append(
            {
                "class_name": "PinholeCameraParameters",
                "extrinsic": np.linalg.inv(matrix).T.ravel().tolist(),
                "intrinsic": {"width": 1920, "height": 1080, "intrinsic_matrix": intrinsic},
            }
        )
    path.write_text(json.dumps({"class_name": "PinholeCameraTrajectory", "parameters": entries}))


def instant_ngp(poses, fps, path):
    keys = []
    for n, (matrix, fov) in enumerate(zip(matrices(poses), poses.fov), 1):
        # As nerf_matrix_to_ngp() of its source does it.
        matrix = matrix[:3] * [1, -1, -1, 1]
        matrix[:, 3] = matrix[:, 3] * 0.33 + 0.5
        matrix = matrix[[1, 2, 0]]
        w, x, y, z = turns.of_matrices(matrix[None, :, :3])[0].tolist()
        key = {"R": [x, y, z, w], "T": matrix[:, 3].tolist(), "fov": float(fov), "timestamp": n / fps}
        keys.append(key | {"slice": 0, "scale": 1, "aperture_size": 0})
    path.write_text(json.dumps({"loop": False, "time": 0, "spline_order": 1, "path": keys}))


def colmap(poses, fps, path):
    path.mkdir(exist_ok=True)
    cameras, images = ["# cameras"], ["# images"]
    for n, (matrix, fov) in enumerate(zip(matrices(poses, 1), poses.fov), 1):
        focal = float(540 / np.tan(np.radians(fov) / 2))
        cameras.append(f"{n} PINHOLE 1920 1080 {focal!r} {focal!r} 960 540")
        away = np.linalg.inv(matrix)
        turn = turns.of_matrices(away[None, :3, :3])[0]
        words = " ".join(map(repr, [*turn.tolist(), *away[:3, 3].tolist()]))
        images += [f"{n} {words} {n} {n:05}.png", ""]
    (path / "cameras.txt").write_text("\n".join(cameras) + "\n")
    (path / "images.txt").write_text("\n".join(images) + "\n")
    (path / "points3D.txt").write_text("# points\n")


def chan(poses, fps, path):
    angles = np.degrees(turns.euler(turns.rotation(poses.view, poses.up, -1), "zxy"))
    rows = np.column_stack([poses.position, angles, poses.fov])
    path.write_text("".join(f"{n} " + " ".join(map(repr, row)) + "\n" for n, row in enumerate(rows.tolist(), 1)))


def csv(poses, fps, path):
    zoom = 12 / np.tan(np.radians(poses.fov) / 2)
    rows = np.column_stack([poses.position, poses.view, poses.up, zoom]).tolist()
    lines = ["frame,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom,seconds"]
    lines += [f"{n + 1}," + ",".join(map(repr, row)) + f",{n / fps!r}" for n, row in enumerate(rows)]
    path.write_text("\n".join(lines) + "\n")


def script(head):
    """A script with its poses as data, as each of the three programs wants them."""

    def write(poses, fps, path):
        rows = np.column_stack([poses.position, poses.view, poses.up, poses.fov]).tolist()
        path.write_text(f"POSES = {rows!r}\nFPS = {fps!r}\n{head}")

    return write


BLENDER = """
import bpy, math
from mathutils import Matrix, Vector
scene = bpy.context.scene
data = bpy.data.cameras.new("camera")
camera = bpy.data.objects.new("camera", data)
scene.collection.objects.link(camera)
scene.camera = camera
scene.frame_start, scene.frame_end = 1, len(POSES)
scene.render.fps = round(FPS)
scene.render.fps_base = round(FPS) / FPS
scene.render.resolution_x, scene.render.resolution_y = 1920, 1080
data.sensor_fit, data.sensor_height = "VERTICAL", 24
camera.rotation_mode = "QUATERNION"
last = None
for n, row in enumerate(POSES, 1):
    view, up = Vector(row[3:6]), Vector(row[6:9])
    right = view.cross(up)
    turn = Matrix((right, up, -view)).transposed().to_quaternion()
    if last is not None and turn.dot(last) < 0:
        turn.negate()
    last = turn
    camera.location, camera.rotation_quaternion = row[:3], turn
    data.lens = 12 / math.tan(math.radians(row[9]) / 2)
    camera.keyframe_insert("location", frame=n)
    camera.keyframe_insert("rotation_quaternion", frame=n)
    data.keyframe_insert("lens", frame=n)
"""

VTK = """
import vtk
window, renderer = vtk.vtkRenderWindow(), vtk.vtkRenderer()
window.SetOffScreenRendering(1)
window.SetSize(1920, 1080)
window.AddRenderer(renderer)
camera = renderer.GetActiveCamera()
for n, row in enumerate(POSES):
    camera.SetPosition(row[:3])
    camera.SetFocalPoint([a + b for a, b in zip(row[:3], row[3:6])])
    camera.SetViewUp(row[6:9])
    camera.SetViewAngle(row[9])
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(f"{n:05}.png")
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
"""

PARAVIEW = """
from paraview.simple import *
view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1920, 1080]
scene = GetAnimationScene()
scene.PlayMode = "Sequence"
scene.NumberOfFrames = len(POSES)
scene.StartTime, scene.EndTime = 0.0, len(POSES) - 1.0
cue = GetCameraTrack(view=view)
cue.Mode = "Interpolate Camera"
frames = []
for n, row in enumerate(POSES):
    key = CameraKeyFrame()
    key.KeyTime = n / (len(POSES) - 1)
    key.Position = row[:3]
    key.FocalPoint = [a + b for a, b in zip(row[:3], row[3:6])]
    key.ViewUp = row[6:9]
    key.ViewAngle = row[9]
    frames.append(key)
cue.KeyFrames = frames
"""

WRITERS = {
    "glb": gltf, "usda": usda, "nerfstudio": nerfstudio, "transforms": transforms, "cameras": cameras,
    "tum": tum, "kitti": kitti, "matrices": numpy_, "open3d": open3d,
    "instant-ngp": instant_ngp, "colmap": colmap, "osg": osg, "chan": chan, "csv": csv,
    "blender": script(BLENDER), "vtk": script(VTK), "paraview": script(PARAVIEW),
}  # fmt: skip
