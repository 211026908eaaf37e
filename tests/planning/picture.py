"""Objects kept in the picture along random paths: picture.py LIBRARY FOLDER [COUNT]

LIBRARY is libvides.so. Three meshes that others made come from npm into FOLDER. For each of COUNT
random paths around one of them, and by zoom, distance and turning, all vertices of the convex hull
(SciPy's), among which are those that reach farthest, are projected anew by numpy at 20 places a
frame, and all vertices where they reach farthest. Ends with status 1 if one is outside of the picture
less margin, or the tightest place is more than 1 % within it, or another number of frames came back.
"""

import ctypes
import json
import pathlib
import subprocess
import sys
import time

import numpy as np
from scipy.spatial import ConvexHull

library, folder = ctypes.CDLL(sys.argv[1]), pathlib.Path(sys.argv[2])
count = int(sys.argv[3]) if len(sys.argv) > 3 else 60
folder.mkdir(parents=True, exist_ok=True)
MESHES = ["bunny@1.0.1", "teapot@1.0.0", "snowden@1.0.1"]
WAYS = ["zoom", "distance", "view"]
PLACES = 20


class Pose(ctypes.Structure):
    _fields_ = [("numbers", ctypes.c_double * 10)]


class Mesh(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("xyz", ctypes.c_void_p),
        ("points", ctypes.c_size_t),
        ("rgb", ctypes.c_void_p),
        ("lines", ctypes.c_void_p),
        ("line_ends", ctypes.c_size_t),
        ("triangles", ctypes.c_void_p),
        ("corners", ctypes.c_size_t),
    ]


library.v_last_error.restype = ctypes.c_char_p
library.v_path_tool.argtypes = [
    ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_void_p,
]
library.v_path_poses_at.argtypes = [
    ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p,
]
for name in ["v_path_frame_count", "v_path_point_count"]:
    getattr(library, name).argtypes = [ctypes.c_void_p, ctypes.c_void_p]
library.v_path_free.argtypes = [ctypes.c_void_p]


def said(status):
    """None, or the library's sentence."""
    return library.v_last_error().decode() if status else None


def meshes():
    """Vertices and triangles, brought into [-1/2, 1/2]^3."""
    subprocess.run(
        ["npm", "install", "--silent", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", folder, *MESHES],
        check=True,
    )
    for package in MESHES:
        name = package.split("@")[0]
        program = f"const m = require('{name}'); console.log(JSON.stringify([m.positions, m.cells].map((a) => Array.from(a))))"
        text = subprocess.run(["node", "-e", program], cwd=folder, check=True, capture_output=True).stdout
        points, cells = (np.array(numbers).reshape(-1, 3) for numbers in json.loads(text))
        middle, size = (points.min(0) + points.max(0)) / 2, np.ptp(points, axis=0).max()
        points = (points - middle) / size
        used = points[np.unique(cells)]
        yield name, points, cells.astype(np.uint32), (used[ConvexHull(used).vertices], used)


def a_path(random, kind):
    """A file's text, and its handle."""
    lines = ["version = 1", f"closed = {str(random.random() < 0.3).lower()}"]
    common = random.uniform(-0.15, 0.15, 3) if random.random() < 0.6 else None
    for _ in range(random.integers(3, 8)):
        way = random.normal(size=3)
        place = way / np.linalg.norm(way) * random.uniform(1.6, 2.6)
        lines += ["[[point]]", f"position = {place.tolist()}"]
        for _ in range(1 if random.random() < 0.85 else 2):
            seen = random.uniform(-0.15, 0.15, 3)
            lines.append("[[point.orientation]]")
            if common is not None:
                lines.append(f"target = {common.tolist()}")
            elif random.random() < 0.5:
                lines.append(f"target = {seen.tolist()}")
            else:
                lines.append(f"offset = {(seen - place).tolist()}")
            # Turning alone needs a wide angle.
            zoom = random.uniform(11, 13) if kind == 2 else random.uniform(14, 40)
            lines += [f"zoom_mm = {zoom}", f"roll_degrees = {random.uniform(-20, 20)}"]
            if random.random() < 0.2:
                lines.append("hold_frames = 10")
            if random.random() < 0.3:
                lines.append(f"speed_curve = {random.uniform(10, 90, 10).tolist()}")
    text = "\n".join(lines).encode()
    path = ctypes.c_void_p()
    wrong = said(library.v_path_load_from_memory(text, ctypes.c_size_t(len(text)), ctypes.byref(path)))
    assert wrong is None, wrong
    return path


def number(function, path):
    value = ctypes.c_size_t(0)
    assert said(getattr(library, function)(path, ctypes.byref(value))) is None
    return value.value


def reached(poses, points):
    """For each pose the greatest share of the half picture that a place takes; infinite with one behind."""
    found = []
    for part in np.array_split(poses, max(1, len(poses) * len(points) // 1_000_000)):
        eye, view, up, zoom = part[:, :3], part[:, 3:6], part[:, 6:9], part[:, 9]
        right = np.cross(view, up)
        depth = view @ points.T - (view * eye).sum(1)[:, None]
        x = np.abs(right @ points.T - (right * eye).sum(1)[:, None]) / 18
        y = np.abs(up @ points.T - (up * eye).sum(1)[:, None]) / 12
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (np.maximum(x, y) / depth).max(1) * zoom
        found.append(np.where((depth > 0).all(1), share, np.inf))
    return np.concatenate(found)


def share(path, outline):
    """The greatest of all places."""
    last = number("v_path_frame_count", path)
    frames = 1 + np.arange((last - 1) * PLACES + 1) / PLACES
    poses = np.zeros((len(frames), 10))
    assert said(library.v_path_poses_at(path, frames.ctypes.data, len(frames), poses.ctypes.data)) is None
    hull, points = outline
    found = reached(poses, hull)
    # Nothing is beyond the hull.
    some = np.append(np.argsort(found)[-20:], np.arange(0, len(poses), max(1, len(poses) // 100)))
    every = reached(poses[some], points)
    assert (np.isinf(every) == np.isinf(found[some])).all()
    assert np.allclose(np.nan_to_num(every), np.nan_to_num(found[some]), rtol=1e-9)
    return float(found.max())


def main():
    random = np.random.default_rng(32)
    all_meshes = list(meshes())
    bad = 0
    for kind, way in enumerate(WAYS):
        shares, more, refused, seconds = [], [], [], 0.0
        for k in range(count):
            name, points, cells, outline = all_meshes[k % len(all_meshes)]
            path, margin = a_path(random, kind), random.uniform(0, 0.2)
            frames, was = number("v_path_frame_count", path), share(path, outline) / (1 - 2 * margin)
            before = number("v_path_point_count", path) & 0xFFFFFFFF
            mesh = Mesh(ctypes.sizeof(Mesh), points.ctypes.data, len(points), None, None, 0, cells.ctypes.data, cells.size)
            start = time.perf_counter()
            how = f"margin={margin!r}\nwhat={WAYS[kind]}".encode()
            wrong = said(library.v_path_tool(path, b"picture", how, ctypes.byref(mesh)))
            seconds += time.perf_counter() - start
            if wrong:
                refused.append(f"{name} {k}: {wrong}")
            else:
                now = share(path, outline) / (1 - 2 * margin)
                shares.append(now)
                more.append((number("v_path_point_count", path) & 0xFFFFFFFF) - before)
                fits = kind == 2 and was <= 1 and now == was
                if not (0.99 <= now <= 1 or fits) or number("v_path_frame_count", path) != frames:
                    print(f"{way} {name} {k}: {was:.4f} became {now:.6f}")
                    bad += 1
            library.v_path_free(path)
        print(
            f"{way}: {len(shares)} of {count} paths, {bad} bad; the tightest place takes {min(shares):.6f} to "
            f"{max(shares):.6f} of the room; {np.mean(more):.1f} points more in the mean, at most {max(more)}; "
            f"{seconds / count:.2f} s each"
        )
        for line in refused:
            print(f"  refused: {line}")
        bad += 2 * len(refused) > count
    sys.exit(bad > 0)


main()
