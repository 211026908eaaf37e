"""The path of all benchmarks, by the same formulas as `benches/engine.rs`
and `benches/list.c`: a wobbling curve in the cube, a camera that turns and rolls
steadily, a zoom that breathes, and all the curve parameters at work."""

import math


def point(i):
    """Support point i: position, tcb, view direction, turning tcb, roll, zoom."""
    position = (
        0.8 * math.sin(0.37 * i),
        0.6 * math.sin(0.23 * i + 1.0),
        0.8 * math.cos(0.31 * i),
    )
    tcb = (
        0.4 * math.sin(1.3 * i),
        0.3 * math.sin(1.7 * i + 1.0),
        0.4 * math.sin(2.1 * i + 2.0),
    )
    yaw = 0.21 * i + 0.3 * math.sin(0.7 * i)
    direction = (math.sin(yaw), 0.4 * math.sin(0.29 * i), math.cos(yaw))
    turning = (
        0.3 * math.sin(1.9 * i),
        0.3 * math.sin(2.3 * i + 1.0),
        0.3 * math.sin(2.9 * i + 2.0),
    )
    roll = 20.0 * math.sin(0.41 * i)
    zoom = 50.0 + 30.0 * math.sin(0.17 * i)
    return position, tcb, direction, turning, roll, zoom


def quaternion(direction, roll):
    """(w, x, y, z) of yaw about y, pitch about x, roll about z."""
    x, y, z = direction
    yaw, pitch = math.atan2(x, z) / 2, -math.atan2(y, math.hypot(x, z)) / 2
    roll = math.radians(roll) / 2
    cy, sy, cp, sp = math.cos(yaw), math.sin(yaw), math.cos(pitch), math.sin(pitch)
    cr, sr = math.cos(roll), math.sin(roll)
    w, x, y, z = cy * cp, cy * sp, sy * cp, -sy * sp
    return w * cr - z * sr, x * cr + y * sr, y * cr - x * sr, z * cr + w * sr
