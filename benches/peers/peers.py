#!/usr/bin/env python3
"""Poses per second of other libraries on the path of our own benchmark.

    python3 benches/peers/peers.py [--json] [--poses N] [--points N] [--runs N]

100 points with position, orientation and zoom become 1,000,000 poses (position,
view direction, up, zoom: ten doubles each) in memory touched before. One core;
the best of several runs; preparation is not counted.

Neither peer spaces its poses evenly along the curve, has tension, continuity
and bias for the turning, or keeps a speed; they are given equal steps of their
own parameter, which is less work than ours. Both are called the fastest way
that they offer:

vtk    four vtkKochanekSpline and a vtkQuaternionInterpolator (spline). They
       give one value a call and have no batch form, so the calls are made from
       a C loop (vtk_loop.c) straight into VTK's compiled functions. Without a
       C compiler: from Python. What the Python calls cost is shown apart.
scipy  CubicSpline over four columns and Rotation's Slerp, both vectorised, then
       the two columns of the rotation matrix; in blocks that stay in the cache
       or in one go, whichever is faster.

The packages of requirements.txt go into a virtual environment under target/
by themselves.
"""

import argparse
import ctypes
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR") or HERE.parent.parent / "target").resolve() / "peers"


def own_environment():
    """Starts this script again in its own environment, made if it is missing."""
    python = TARGET / "venv" / "bin" / "python"
    stamp, wanted = TARGET / "venv" / "installed.txt", (HERE / "requirements.txt").read_text()
    if not (stamp.exists() and stamp.read_text() == wanted):
        subprocess.run([sys.executable, "-m", "venv", "--clear", TARGET / "venv"], check=True)
        subprocess.run(
            [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", HERE / "requirements.txt"],
            check=True,
        )
        stamp.write_text(wanted)
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    os.execve(python, [str(python), *sys.argv], {**os.environ, **threads, "VIDES_PEERS": "1"})


def best(runs, function):
    """Seconds of the fastest run; the first one, which warms up, does not count."""
    function()
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def compiled_loop():
    compiler = shutil.which(os.environ.get("CC", "cc"))
    if compiler is None:
        return None
    library = TARGET / "vtk_loop.so"
    subprocess.run(
        [compiler, "-O2", "-shared", "-fPIC", "-o", library, HERE / "vtk_loop.c"], check=True
    )
    return ctypes.CDLL(str(library))


def vtk_peer(points, poses, runs, out):
    import numpy as np
    from vtkmodules import vtkCommonComputationalGeometry as geometry
    from vtkmodules import vtkCommonMath as math_module

    splines = [geometry.vtkKochanekSpline() for _ in range(4)]
    turning = math_module.vtkQuaternionInterpolator()
    turning.SetInterpolationTypeToSpline()
    for i, (position, _, _, _, zoom, q) in enumerate(points):
        for spline, value in zip(splines, (*position, zoom)):
            spline.AddPoint(i, value)
        turning.AddQuaternion(i, list(q))
    last = len(points) - 1
    for spline in splines:
        spline.Compute()

    few = max(1, poses // 20)
    q = [0.0] * 4

    def from_python():
        x, y, z, zoom = (s.Evaluate for s in splines)
        turn = turning.InterpolateQuaternion
        for k in range(few):
            t = last * k / few
            x(t), y(t), z(t), zoom(t), turn(t, q)

    results = {}
    results["vtk, called from Python (poses without vpn and vup)"] = few / best(runs, from_python)

    loop = compiled_loop()
    if loop is not None:
        folder = Path(geometry.__file__).parent

        def function(library, symbol):
            found = getattr(ctypes.CDLL(str(folder / library)), symbol)
            return ctypes.cast(found, ctypes.c_void_p)

        def address(thing):  # "_000055d0c0ffee00_p_vtkKochanekSpline"
            return ctypes.c_void_p(int(thing.__this__.split("_")[1], 16))

        evaluate = function("libvtkCommonComputationalGeometry.so", "_ZN17vtkKochanekSpline8EvaluateEd")
        interpolate = function(
            "libvtkCommonMath.so", "_ZN25vtkQuaternionInterpolator21InterpolateQuaternionEdPd"
        )
        call = loop.vtk_poses
        call.restype = None
        call.argtypes = [ctypes.c_void_p] * 7 + [ctypes.c_double, ctypes.c_size_t, ctypes.c_void_p]
        arguments = [evaluate, interpolate, *map(address, splines), address(turning), last]
        speeds = []
        for search in ("LinearSearch", "BinarySearch"):
            kinds = math_module.vtkQuaternionInterpolator
            turning.SetSearchMethod(getattr(kinds, search))
            speeds.append(poses / best(runs, lambda: call(*arguments, poses, out.ctypes.data)))
        results["vtk, called from C"] = max(speeds)
        # The compiled functions are the ones that Python calls, and do the same.
        for k in range(0, poses, max(1, poses // 97)):
            t = last / (poses - 1) * k
            expected = [s.Evaluate(t) for s in splines]
            assert np.allclose(out[k][[0, 1, 2, 9]], expected, rtol=0, atol=1e-12)
            turning.InterpolateQuaternion(t, q)
            w, x, y, z = q
            assert np.allclose(out[k][3:6], (2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z))
    return results


def scipy_peer(points, poses, runs, out):
    import numpy as np
    from scipy.interpolate import CubicSpline
    from scipy.spatial.transform import Rotation, Slerp

    times = np.arange(len(points), dtype=float)
    curve = CubicSpline(times, [(*position, zoom) for position, _, _, _, zoom, _ in points])
    turning = Slerp(times, Rotation.from_quat([q for *_, q in points], scalar_first=True))
    when = np.linspace(0, len(points) - 1, poses)

    def block(size):
        for k in range(0, poses, size):
            t, rows = when[k : k + size], out[k : k + size]
            columns = curve(t)
            rows[:, :3], rows[:, 9] = columns[:, :3], columns[:, 3]
            axes = turning(t).as_matrix()
            rows[:, 3:6], rows[:, 6:9] = axes[:, :, 2], axes[:, :, 1]

    return {
        "scipy, vectorised": max(poses / best(runs, lambda size=size: block(size)) for size in (4096, 65536, poses))
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--poses", type=int, default=1_000_000)
    parser.add_argument("--points", type=int, default=100)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()

    import numpy as np

    from bench_path import point, quaternion

    points = []
    for i in range(options.points):
        p = point(i)
        points.append((*p, quaternion(p[2], p[4])))
    points = [(position, tcb, direction, turning, zoom, q) for position, tcb, direction, turning, _, zoom, q in points]
    out = np.ones((options.poses, 10))
    results = {}
    for peer in (vtk_peer, scipy_peer):
        results.update(peer(points, options.poses, options.runs, out))
    if options.json:
        print(json.dumps(results))
    else:
        for name, speed in results.items():
            print(f"{name:52} {speed / 1e6:8.3f} million poses a second")


if __name__ == "__main__":
    if os.environ.get("VIDES_PEERS") != "1":
        own_environment()
    main()
