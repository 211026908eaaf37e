#!/usr/bin/env python3
"""Lists of poses that others write come in; angles of `.chan` files are scipy's in every order.

    pose_lists.py VIDES [FLIGHTS]

pycolmap writes models, as text and `.bin`, with cameras of every model that has a field of view; evo writes
TUM and KITTI; scipy gives the quaternions of OSG files and the angles of `.chan` files. `vides convert`
makes CSV files of them with `--as keys`, which must have the poses that went in.
"""

import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pycolmap
from evo.core.trajectory import PosePath3D, PoseTrajectory3D
from evo.tools import file_interface
from scipy.spatial.transform import Rotation

ORDERS = ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx")
HALF_FILM = 12.0


class Flight:
    """Random cameras: matrices to the world, x right, y down, z forward; vertical fields of view."""

    def __init__(self, seed, count=40):
        dice = np.random.default_rng(seed)
        self.rotations = Rotation.random(count, random_state=seed)
        self.places = dice.uniform(-1, 1, (count, 3)) * dice.choice([0.05, 1.0, 250.0])
        self.fields = dice.uniform(1, 160, count)
        self.matrices = np.tile(np.eye(4), (count, 1, 1))
        self.matrices[:, :3, :3] = self.rotations.as_matrix()
        self.matrices[:, :3, 3] = self.places

    def __len__(self):
        return len(self.places)

    def looking_back(self):
        """The same cameras with y up, looking along -z."""
        return self.rotations * Rotation.from_quat([1, 0, 0, 0])


def convert(program, source, target, *options):
    run = subprocess.run([program, "convert", source, target, *options], capture_output=True, text=True, check=False)
    if run.returncode:
        raise SystemExit(run.stderr)
    return run.stderr


class Worst:
    """The largest differences so far."""

    def __init__(self):
        self.values = {}

    def see(self, name, found, bound):
        worst, _ = self.values.get(name, (0.0, bound))
        self.values[name] = (max(worst, float(found)), bound)

    def tell(self):
        failed = False
        for name, (worst, bound) in self.values.items():
            good = worst <= bound
            failed |= not good
            print(f"{'ok' if good else 'FAILED'}: {name}: {worst:.2e} (at most {bound:.0e})")
        return failed


def apart(a, b):
    """Degrees between unit vectors, row by row."""
    return np.degrees(2 * np.arcsin(np.clip(np.linalg.norm(a - b, axis=1) / 2, 0, 1))).max()


def compare(worst, name, flight, table, fields=True):
    """A table of `vides` against a flight."""
    rows = np.loadtxt(table, delimiter=",", skiprows=1, ndmin=2)
    if len(rows) != len(flight):
        raise SystemExit(f"{name}: {len(rows)} poses of {len(flight)}")
    size = np.linalg.norm(np.ptp(flight.places, axis=0))
    worst.see(f"{name}, position/diagonal", np.abs(rows[:, 1:4] - flight.places).max() / size, 1e-6)
    axes = flight.rotations.as_matrix()
    worst.see(f"{name}, view, degrees", apart(rows[:, 4:7], axes[:, :, 2]), 0.01)
    worst.see(f"{name}, up, degrees", apart(rows[:, 7:10], -axes[:, :, 1]), 0.01)
    if fields:
        found = np.degrees(2 * np.arctan(HALF_FILM / rows[:, 10]))
        worst.see(f"{name}, field of view, degrees", np.abs(found - flight.fields).max(), 1e-3)


def model_of(flight, dice):
    """A model as pycolmap makes it, and how many of its cameras bend lines."""
    kinds = [name for name in pycolmap.CameraModelId.__members__ if name not in ("INVALID", "EQUIRECTANGULAR")]
    model = pycolmap.Reconstruction()
    bent = 0
    order = list(range(len(flight)))
    dice.shuffle(order)
    for at in order:
        kind = kinds[at % len(kinds)]
        height = dice.choice([480, 1080])
        camera = pycolmap.Camera.create_from_model_name(at + 1, kind, 100.0, 2 * height, height)
        focal = height / 2 / math.tan(math.radians(flight.fields[at]) / 2)
        values = camera.params.copy()
        for index in camera.focal_length_idxs():
            values[index] = focal
        extra = list(camera.extra_params_idxs())
        for index in extra:
            values[index] = dice.uniform(0.01, 0.1)
        camera.params = values
        bent += bool(extra) or "FISHEYE" in kind
        model.add_camera_with_trivial_rig(camera)
        image = pycolmap.Image()
        image.image_id, image.camera_id = at + 1, at + 1
        # Numbers without zeros before them, so that their order is not that of texts.
        image.name = f"shot {at + 1}.png"
        image.points2D = [pycolmap.Point2D(np.array([dice.random(), 2.0])) for _ in range(dice.choice([0, 3]))]
        away = np.linalg.inv(flight.matrices[at])
        model.add_image_with_trivial_frame(image, pycolmap.Rigid3d(away[:3]))
    for _ in range(20):
        model.add_point3D(np.array([dice.uniform(-1, 1) for _ in range(3)]), pycolmap.Track(), np.zeros(3, np.uint8))
    return model, bent


def colmap(program, worst, flight, folder, dice):
    model, bent = model_of(flight, dice)
    for kind, write in (("text", model.write_text), ("binary", model.write_binary)):
        place = folder / kind
        place.mkdir()
        write(place)
        table = folder / f"{kind}.csv"
        said = convert(program, place, table, "--as", "keys")
        if f"the distortion of {bent} cameras" not in said:
            raise SystemExit(f"COLMAP, {kind}: {bent} cameras bend lines, told was: {said}")
        compare(worst, f"COLMAP's {kind}", flight, table)
        # And out again, for COLMAP.
        again = folder / f"{kind} again"
        convert(program, place, again, "--as", "keys", "--to", "colmap")
        images = sorted(pycolmap.Reconstruction(again).images.values(), key=lambda image: image.name)
        ours = np.array([image.cam_from_world().inverse().matrix() for image in images])
        found = np.abs(ours - flight.matrices[:, :3]).max() / max(1, np.abs(flight.places).max())
        worst.see(f"COLMAP's {kind} in and out, entries of matrices", found, 1e-6)


def evo(program, worst, flight, folder):
    times = np.cumsum(np.full(len(flight), 0.04)) + 1305031102.0
    path = PoseTrajectory3D(poses_se3=list(flight.matrices), timestamps=times)
    file_interface.write_tum_trajectory_file(folder / "evo.tum", path)
    file_interface.write_kitti_poses_file(folder / "evo.txt", PosePath3D(poses_se3=list(flight.matrices)))
    # Seconds of today, whose rounding is 6e-6 of a frame.
    for name, title in (("evo.tum", "TUM"), ("evo.txt", "KITTI")):
        table = folder / f"{name}.csv"
        convert(program, folder / name, table, "--as", "keys")
        compare(worst, f"evo's {title}", flight, table, fields=False)


def turns(program, worst, flight, folder):
    back = flight.looking_back()
    rows = np.column_stack([np.arange(len(flight)) * 0.04, flight.places, back.as_quat()])
    np.savetxt(folder / "a.path", rows, fmt="%.17g")
    convert(program, folder / "a.path", folder / "a.csv", "--as", "keys")
    compare(worst, "OSG", flight, folder / "a.csv", fields=False)
    for order in ORDERS:
        choice = ("--rotation-order", order)
        # Small letters are scipy's turns about the axes of the world, the first first.
        found = back.as_euler(order, degrees=True)
        angles = np.empty_like(found)
        for at, axis in enumerate(order):
            angles[:, "xyz".index(axis)] = found[:, at]
        rows = np.column_stack([np.arange(len(flight)) + 1, flight.places, angles, flight.fields])
        np.savetxt(folder / f"{order}.chan", rows, fmt=["%d"] + 7 * ["%.17g"])
        convert(program, folder / f"{order}.chan", folder / f"{order}.csv", "--as", "keys", *choice)
        compare(worst, f"chan {order}", flight, folder / f"{order}.csv")
        # Out: scipy makes the same rotations of our angles.
        convert(program, folder / f"{order}.chan", folder / f"{order} out.chan", "--as", "keys", *choice)
        ours = np.loadtxt(folder / f"{order} out.chan")
        again = Rotation.from_euler(order, ours[:, ["xyz".index(axis) + 4 for axis in order]], degrees=True)
        off = np.degrees((again * back.inv()).magnitude()).max()
        worst.see(f"chan {order} out, degrees", off, 0.01)
        worst.see(f"chan {order} out, largest step, degrees", np.abs(np.diff(ours[:, 4:7], axis=0)).max(), 180.0)


def main():
    program = str(Path(sys.argv[1]).resolve())
    worst = Worst()
    for seed in range(int(sys.argv[2]) if len(sys.argv) > 2 else 5):
        flight = Flight(seed)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            colmap(program, worst, flight, folder, random.Random(seed))
            evo(program, worst, flight, folder)
            turns(program, worst, flight, folder)
    sys.exit(worst.tell())


main()
