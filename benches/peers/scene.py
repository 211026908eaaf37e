#!/usr/bin/env python3
"""OpenUSD's XformCache and NumPy on the scene of ../scene.c; prints JSON."""

import json
import math
import time

import numpy as np
from pxr import Gf, Usd, UsdGeom

NODES, KEYS, POINTS, RUNS = 1000, 11, 100_000, 7


def best(function, times):
    function()
    took = []
    for _ in range(RUNS):
        begin = time.process_time()
        for n in range(times):
            function(n)
        took.append((time.process_time() - begin) / times)
    return min(took)


def usd():
    stage = Usd.Stage.CreateInMemory()
    prims = []
    for i in range(NODES):
        above = prims[(i - 1) // 4].GetPath() if i else "/"
        xform = UsdGeom.Xform.Define(stage, f"{above}/n{i}".replace("//", "/"))
        move, turn, scale = (
            xform.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble),
            xform.AddOrientOp(UsdGeom.XformOp.PrecisionDouble),
            xform.AddScaleOp(UsdGeom.XformOp.PrecisionDouble),
        )
        axis = Gf.Vec3d(1, math.sin(i), math.cos(i)).GetNormalized()
        for k in range(KEYS):
            frame, half = 1 + 10 * k, 0.3 * math.sin(0.3 * i + k)
            move.Set(Gf.Vec3d(*(0.5 * x for x in (math.sin(0.37 * i + 0.9 * k), math.cos(0.23 * i + 0.5 * k),
                                                  math.sin(0.11 * i + 0.7 * k)))), frame)  # fmt: skip
            turn.Set(Gf.Quatd(math.cos(half), axis * math.sin(half)), frame)
            scale.Set(Gf.Vec3d(1 + 0.1 * math.sin(i + k), 1 + 0.1 * math.cos(i + k), 1), frame)
        prims.append(xform.GetPrim())
    cache, matrices = UsdGeom.XformCache(), [None] * NODES

    def all_of(n=0):
        cache.SetTime(1 + (0.37 * n) % 100)
        world = cache.GetLocalToWorldTransform
        for i, prim in enumerate(prims):
            matrices[i] = world(prim)

    took = best(all_of, 50)
    all_of(199)
    places = sum(m[3][0] + 2 * m[3][1] + 3 * m[3][2] for m in matrices)
    version = ".".join(map(str, Usd.GetVersion()[1:]))
    return {"name": f"OpenUSD {version} XformCache, from Python", "nodes_per_second": NODES / took, "places": places}


def numpy():
    index = np.arange(3 * POINTS, dtype=float)
    base = np.sin(0.001 * index).reshape(-1, 3)
    shapes = [base + 0.1 * np.cos(0.002 * index + shape).reshape(-1, 3) for shape in range(2)]
    low, high = base[:, 2].min(), base[:, 2].max()
    out = np.empty_like(base)

    def all_of(_=0):
        morphed = 0.5 * base + 0.3 * shapes[0] + 0.2 * shapes[1]
        turn = np.clip((morphed[:, 2] - low) * (math.pi / 2 / (high - low)), 0, math.pi / 2)
        x, y, c, s = morphed[:, 0], morphed[:, 1], np.cos(turn), np.sin(turn)
        out[:, 0], out[:, 1], out[:, 2] = c * x - s * y, s * x + c * y, morphed[:, 2]

    took = best(all_of, 10)
    points = float((out @ [1.0, 2.0, 3.0]).sum())
    return {"name": f"NumPy {np.__version__}", "vertices_per_second": POINTS / took, "points": points}


if __name__ == "__main__":
    print(json.dumps([usd(), numpy()]))
