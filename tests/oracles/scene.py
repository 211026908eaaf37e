"""Reference values for scenes: tracks, trees, deformations, morphing.

    pip install numpy==2.4.6 scipy==1.17.1 splines==0.3.3
    python3 tests/oracles/scene.py > tests/oracles/scene.toml

From libraries that know nothing of this one, and from the formulas of glTF and
of the lecture as they are printed. Every number is printed with the digits that
give it back to the last bit.
"""

import math

import numpy as np
import splines
import splines.quaternion
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

RANDOM = np.random.default_rng(1995)


def toml(value):
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (int, np.integer)):
        return str(value)
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return "[" + ", ".join(toml(element) for element in value) + "]"


def case(kind, **fields):
    print(f"\n[[{kind}]]")
    for name, value in fields.items():
        print(f"{name} = {toml(value)}")


def frames_of(count):
    """Key frames whose distances differ up to twentyfold."""
    return np.cumsum(RANDOM.uniform(0.5, 10.0, count)) - 7.0


def wanted(keys, count=15):
    inside = np.sort(RANDOM.uniform(keys[0], keys[-1], count))
    return np.concatenate(([keys[0]], inside, [keys[-1]]))


# ---- numbers ----

def hermite(keys, values, tangents, frame):
    """glTF 2.0, appendix C.5: cubic spline interpolation, one tangent a side."""
    i = min(np.searchsorted(keys, frame, side="right") - 1, len(keys) - 2)
    td = keys[i + 1] - keys[i]
    t = (frame - keys[i]) / td
    b, a = tangents[i, 1], tangents[i + 1, 0]
    return (
        (2 * t**3 - 3 * t**2 + 1) * values[i]
        + td * (t**3 - 2 * t**2 + t) * b
        + (-2 * t**3 + 3 * t**2) * values[i + 1]
        + td * (t**3 - t**2) * a
    )


def between(keys, values, frame, share):
    i = min(np.searchsorted(keys, frame, side="right") - 1, len(keys) - 2)
    u = share((frame - keys[i]) / (keys[i + 1] - keys[i]))
    return (1 - u) * values[i] + u * values[i + 1]


def kochanek_bartels(keys, values, tcb):
    """The library's, with the slopes of parabolas at the ends."""
    first, last = CubicParabola(keys[:3], values[:3]), CubicParabola(keys[-3:], values[-3:])
    ends = ((1 - tcb[0][0]) * first.slope(0), (1 - tcb[-1][0]) * last.slope(2))
    return splines.KochanekBartels(
        values.tolist(), grid=keys.tolist(), tcb=tcb[1:-1].tolist(),
        endconditions=tuple(tuple(end) for end in ends),
    )


class CubicParabola:
    """The parabola through three points, by Lagrange's polynomials."""

    def __init__(self, t, p):
        self.t, self.p = t, p

    def slope(self, at):
        t, p, total = self.t, self.p, 0.0
        for i in range(3):
            j, k = [m for m in range(3) if m != i]
            total = total + p[i] * ((t[at] - t[j]) + (t[at] - t[k])) / (
                (t[i] - t[j]) * (t[i] - t[k])
            )
        return total


def numbers():
    shares = {
        "linear": lambda u: u,
        "ramp": lambda u: 3 * u**2 - 2 * u**3,
        "sine": lambda u: 0.5 * math.sin(u * math.pi - math.pi / 2) + 0.5,
        "parabolic": lambda u: 2 * u**2 if u <= 0.5 else 1 - 2 * (1 - u) ** 2,
        "step": lambda u: 0.0 if u < 1 else 1.0,
    }
    for name, share in shares.items():
        for _ in range(3):
            keys = frames_of(RANDOM.integers(2, 8))
            values = RANDOM.uniform(-5, 5, (len(keys), 3))
            at = wanted(keys)
            case("track", interpolation=name, frames=keys, values=values, shape=[],
                 at=at, want=[between(keys, values, f, share) for f in at])
    for _ in range(6):
        keys = frames_of(RANDOM.integers(3, 9))
        values = RANDOM.uniform(-5, 5, (len(keys), 3))
        at = wanted(keys)
        zero = np.zeros((len(keys), 3))
        curve = kochanek_bartels(keys, values, zero)
        case("track", interpolation="catmull-rom", frames=keys, values=values, shape=[],
             at=at, want=[curve.evaluate(f) for f in at])
        tcb = RANDOM.uniform(-1, 1, (len(keys), 3))
        curve = kochanek_bartels(keys, values, tcb)
        case("track", interpolation="tcb", frames=keys, values=values, shape=tcb,
             at=at, want=[curve.evaluate(f) for f in at])
        tangents = RANDOM.uniform(-2, 2, (len(keys), 2, 3))
        case("track", interpolation="hermite", frames=keys, values=values,
             shape=tangents.reshape(len(keys), 6),
             at=at, want=[hermite(keys, values, tangents, f) for f in at])
        case("track", interpolation="cubic", frames=keys, values=values, shape=[],
             at=at, want=CubicSpline(keys, values, bc_type="natural")(at))
        values[-1] = values[0]
        at = np.concatenate((at, at + (keys[-1] - keys[0]), at - 3 * (keys[-1] - keys[0])))
        curve = CubicSpline(keys, values, bc_type="periodic")
        case("track", interpolation="cubic", frames=keys, values=values, shape=[],
             beyond="repeat", at=at, want=curve(at, extrapolate="periodic"))


# ---- rotations, w x y z ----

def wxyz(rotation):
    return np.roll(rotation.as_quat(), 1, axis=-1)


def rotations():
    for _ in range(5):
        keys = frames_of(RANDOM.integers(2, 8))
        turns = Rotation.random(len(keys), rng=RANDOM)
        at = wanted(keys)
        case("rotation", interpolation="linear", frames=keys, values=wxyz(turns), shape=[],
             at=at, want=wxyz(Slerp(keys, turns)(np.clip(at, keys[0], keys[-1]))))
        tangents = RANDOM.uniform(-0.2, 0.2, (len(keys), 2, 4))
        raw = wxyz(turns)
        want = np.array([hermite(keys, raw, tangents, f) for f in at])
        want /= np.linalg.norm(want, axis=1)[:, None]
        case("rotation", interpolation="hermite", frames=keys, values=raw,
             shape=tangents.reshape(len(keys), 8), at=at, want=want)
        angles = RANDOM.uniform(-900, 900, (len(keys), 3))
        want = [between(keys, angles, f, lambda u: u) for f in at]
        case("rotation", interpolation="euler-linear", frames=keys, values=angles, shape=[],
             at=at, want=wxyz(Rotation.from_euler("YXZ", want, degrees=True)))
    for name in ["catmull-rom", "tcb"] * 4:
        count = int(RANDOM.integers(5, 9))
        keys = frames_of(count)
        turns = [Rotation.random(rng=RANDOM)]
        for _ in range(count - 1):
            axis = RANDOM.normal(size=3)
            angle = RANDOM.uniform(0.1, 2.5)
            turn = Rotation.from_rotvec(axis / np.linalg.norm(axis) * angle)
            turns.append(turn * turns[-1])
        raw = wxyz(Rotation.concatenate(turns))
        tcb = RANDOM.uniform(-0.5, 0.5, (count, 3)) if name == "tcb" else np.zeros((count, 3))
        unit = [splines.quaternion.UnitQuaternion.from_unit_xyzw((*q[1:], q[0])) for q in raw]
        curve = splines.quaternion.KochanekBartels(
            unit, grid=keys.tolist(), tcb=tcb[1:-1].tolist())
        # The library has other ends: only the sections that do not touch them.
        at = np.sort(RANDOM.uniform(keys[1], keys[-2], 15))
        want = []
        for f in at:
            x, y, z, w = curve.evaluate(f).xyzw
            want.append([w, x, y, z])
        case("rotation", interpolation=name, frames=keys, values=raw,
             shape=tcb if name == "tcb" else [], at=at, want=want)


# ---- trees ----

class Numbers:
    """splitmix64: the test makes the same trees."""

    def __init__(self, seed):
        self.state = seed

    def whole(self):
        mask = (1 << 64) - 1
        self.state = (self.state + 0x9E3779B97F4A7C15) & mask
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return z ^ (z >> 31)

    def real(self, low, high):
        return low + (high - low) * ((self.whole() >> 11) / (1 << 53))

    def vector(self, low, high):
        return np.array([self.real(low, high) for _ in range(3)])


def translation(v):
    matrix = np.eye(4)
    matrix[:3, 3] = v
    return matrix


def trees():
    """The image of (1, 2, 3) under the last node's world matrix."""
    rows = []
    for seed in range(1000):
        random = Numbers(seed)
        count = 1 + random.whole() % 64
        worlds = []
        for at in range(count):
            # Deep trees: mostly the node before.
            parent = at - 1 - (random.whole() % 2 if at > 1 else 0) if at else -1
            position, pivot = random.vector(-2, 2), random.vector(-1, 1)
            w = random.real(-1, 1)
            quaternion = np.concatenate((random.vector(-1, 1), [w]))
            scale = random.vector(0.6, 1.5)
            for k in range(3):
                if random.whole() % 4 == 0:
                    scale[k] = -scale[k]
            turn = np.eye(4)
            turn[:3, :3] = Rotation.from_quat(quaternion).as_matrix()
            local = (translation(position) @ translation(pivot) @ turn
                     @ np.diag([*scale, 1]) @ translation(-pivot))
            worlds.append(worlds[parent] @ local if parent >= 0 else local)
        rows.append((worlds[-1] @ np.array([1.0, 2.0, 3.0, 1.0]))[:3])
    print("\n[trees]\nimages = [")
    for row in rows:
        print(f"  {toml(row)},")
    print("]")


# ---- deformations, as the lecture has them, and morphing ----

def deformed(low, high, points, change):
    """In coordinates from -1 to 1 and back."""
    flat = high == low
    size = np.where(flat, 1.0, high - low)
    uvw = np.where(flat, 0.0, (2 * points - (low + high)) / size)
    new = np.array([change(p.copy()) for p in uvw])
    back = (1 - new) / 2 * low + (1 + new) / 2 * high
    return np.where(flat, points, back)


def clip(x):
    return min(max(x, -1.0), 1.0)


def deformations():
    def emit(kind, parameters, change, inside=False, flat=False):
        low = RANDOM.uniform(-3, 0, 3)
        high = low + RANDOM.uniform(0.5, 4, 3)
        if flat:
            high[1] = low[1]
        margin = 0.0 if inside else 0.3
        points = RANDOM.uniform(low - margin, high + margin, (12, 3))
        case("deformation", deformation=kind, parameters=parameters, low=low, high=high,
             points=points, want=deformed(low, high, points, change))

    for axis in range(3):
        a, b = (axis + 1) % 3, (axis + 2) % 3
        for flat in (False, True):
            amount = RANDOM.uniform(-1, 3)

            def bulge(p):
                r = 1 + (amount - 1) * (1 - clip(p[axis]) ** 2)
                p[a], p[b] = r * p[a], r * p[b]
                return p

            emit("taper", [axis, amount], bulge, flat=flat)
            r0, r1 = RANDOM.uniform(0, 2, 2)

            def taper(p):
                u = clip(p[axis])
                r = (1 - u) / 2 * r0 + (1 + u) / 2 * r1
                p[a], p[b] = r * p[a], r * p[b]
                return p

            emit("taper", [axis, r0, r1], taper, flat=flat)
            angle = RANDOM.uniform(-400, 400)

            def twist(p):
                phi = math.radians(angle) * (clip(p[axis]) + 1) / 2
                c, s = math.cos(phi), math.sin(phi)
                p[a], p[b] = c * p[a] - s * p[b], s * p[a] + c * p[b]
                return p

            emit("twist", [axis, angle], twist, flat=flat)

            def bend(p):
                """An arc of radius 2/angle about a centre above the middle."""
                theta = math.radians(angle)
                radius = 2 / theta
                u, v = clip(p[a]), p[b]
                phi = theta * u / 2
                beyond = p[a] - u
                p[a] = (radius - v) * math.sin(phi) + beyond * math.cos(phi)
                p[b] = radius - (radius - v) * math.cos(phi) + beyond * math.sin(phi)
                return p

            emit("bend", [axis, angle], bend, flat=flat)
            for first in (a, b):
                u0, v0 = RANDOM.uniform(-2, 2, 2)
                low, high = RANDOM.uniform(-180, 180, 2)

                def polar(p):
                    u = clip(p[axis])
                    phi = math.radians((1 - u) / 2 * low + (1 + u) / 2 * high)
                    r = p[first] - v0
                    p[axis], p[first] = r * math.cos(phi) + u0, r * math.sin(phi) + v0
                    return p

                emit("bend", [axis, first, u0, v0, low, high], polar, flat=flat)
    for flat in (False, True):
        lattice = RANDOM.uniform(-1.5, 1.5, (4, 4, 4, 3))  # k, j, i

        def free_form(p):
            if max(abs(p)) > 1:
                return p
            t = (p + 1) / 2
            basis = [[math.comb(3, n) * (1 - x) ** (3 - n) * x**n for n in range(4)] for x in t]
            return np.einsum("i,j,k,kjia->a", *map(np.array, basis), lattice)

        emit("free-form", lattice.ravel(), free_form, inside=True, flat=flat)

    for shapes in range(1, 4):
        base = RANDOM.uniform(-1, 1, (7, 3))
        others = RANDOM.uniform(-1, 1, (shapes, 7, 3))
        weights = RANDOM.uniform(-1, 1.5, shapes)
        want = (1 - weights.sum()) * base + np.tensordot(weights, others, 1)
        case("morph", base=base, shapes=others, weights=weights, want=want)


print("# Made by scene.py beside it.")
numbers()
rotations()
deformations()
trees()
