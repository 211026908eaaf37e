#!/usr/bin/env python3
"""A slow, plain camera-path engine in 40-digit arithmetic.

It is written from the definitions alone (Kochanek and Bartels 1984; Barry and
Goldman 1988; Fritsch and Carlson 1980; thesis chapters 3-5) and shares no code
with the library, so that the two can be held against each other. Nothing here
is fast; every number is what the definition says, to some 25 digits.

    pip install mpmath gmpy2
    python3 tests/oracles/reference.py          # writes tests/oracles/reference/*.txt

`tests/reference.rs` builds every case with the library and compares.
"""

import sys

from mpmath import mp, mpf

mp.dps = 40
PI = mp.pi

# ------------------------------------------------------------------ vectors


def vec(v):
    return tuple(mpf(x) for x in v)


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def mul(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return mp.fsum(x * y for x, y in zip(a, b))


def norm(a):
    return mp.sqrt(dot(a, a))


def unit(a):
    return mul(a, 1 / norm(a))


def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def angle(a, b):
    """Angle between unit vectors of any dimension."""
    return 2 * mp.atan2(norm(sub(a, b)), norm(add(a, b)))


# -------------------------------------------------------------- quaternions
# (w, x, y, z)


def qmul(a, b):
    w = a[0] * b[0] - dot(a[1:], b[1:])
    v = add(add(mul(b[1:], a[0]), mul(a[1:], b[0])), cross(a[1:], b[1:]))
    return (w,) + v


def qconj(a):
    return (a[0], -a[1], -a[2], -a[3])


def qneg(a):
    return tuple(-x for x in a)


def qexp(v):
    """exp of a pure quaternion: half the rotation angle is |v|."""
    n = norm(v)
    if n == 0:
        return (mpf(1), mpf(0), mpf(0), mpf(0))
    return (mp.cos(n),) + mul(v, mp.sin(n) / n)


def qlog(q):
    """log of a unit quaternion, angle in [0, pi]."""
    n = norm(q[1:])
    if n == 0:
        if q[0] < 0:
            raise ValueError("log of -1 has no axis")
        return (mpf(0),) * 3
    return mul(q[1:], mp.atan2(n, q[0]) / n)


def slerp(a, b, t):
    """The raw one: no look at signs, any t."""
    theta = angle(a, b)
    if theta == 0:
        return a
    s = mp.sin(theta)
    return add(mul(a, mp.sin((1 - t) * theta) / s), mul(b, mp.sin(t * theta) / s))


def rotate(q, v):
    return qmul(qmul(q, (mpf(0),) + tuple(v)), qconj(q))[1:]


def axis_q(axis, a):
    q = [mp.cos(a / 2), mpf(0), mpf(0), mpf(0)]
    q[1 + axis] = mp.sin(a / 2)
    return tuple(q)


POLE = mpf("1e-12")


def yaw_pitch(n):
    h = mp.hypot(n[0], n[2])
    yaw = mpf(0) if h < POLE else mp.atan2(n[0], n[2])
    return yaw, -mp.atan2(n[1], h)


def view_q(n, roll, yaw=None):
    """Quaternion of a unit view direction and a roll in radians."""
    own_yaw, pitch = yaw_pitch(n)
    yaw = own_yaw if yaw is None else yaw
    return qmul(qmul(axis_q(1, yaw), axis_q(0, pitch)), axis_q(2, roll))


# Ups by a fixed axis: "y" is the upright one, and where it is "z" all of a view's rules
# hold for the axes y, z, x in place of x, y, z.

TO_Z = (mpf(1) / 2, mpf(-1) / 2, mpf(-1) / 2, mpf(-1) / 2)


def levelled(up, v):
    return (v[1], v[2], v[0]) if up == "z" else v


def worldly(up, v):
    return (v[2], v[0], v[1]) if up == "z" else v


def level_q(up, n, roll, yaw=None):
    q = view_q(levelled(up, n), roll, yaw)
    return qmul(qconj(TO_Z), q) if up == "z" else q


def vpn_vup(q):
    q = unit(q)
    return rotate(q, (0, 0, 1)), rotate(q, (0, 1, 0))


# ----------------------------------------------------- position and distance


class Segment:
    """A cubic with its arc length. coefficients: P = c0 + c1 t + c2 t^2 + c3 t^3."""

    def __init__(self, p0, p1, r0, r1):
        d = sub(p1, p0)
        self.c = (
            p0,
            r0,
            sub(mul(d, 3), add(mul(r0, 2), r1)),
            sub(add(r0, r1), mul(d, 2)),
        )
        self.ends = (p0, p1)
        self.size = max(norm(d), norm(r0), norm(r1))
        self._knots()

    def point(self, t):
        c = self.c
        return tuple(((c[3][k] * t + c[2][k]) * t + c[1][k]) * t + c[0][k] for k in range(3))

    def derivative(self, t, order=1):
        _, c1, c2, c3 = self.c
        if order == 1:
            return tuple((3 * c3[k] * t + 2 * c2[k]) * t + c1[k] for k in range(3))
        if order == 2:
            return tuple(6 * c3[k] * t + 2 * c2[k] for k in range(3))
        return tuple(6 * c3[k] for k in range(3))

    def speed(self, t):
        return norm(self.derivative(t))

    def _minima(self):
        """Where |P'|^2, a quartic, is stationary; and the real parts of its
        roots, near which the root of it is hardly smooth."""
        if self.size == 0:
            return []
        _, c1, c2, c3 = (mul(c, 1 / self.size) for c in self.c)
        a, b, c = mul(c3, 3), mul(c2, 2), c1
        quartic = [dot(a, a), 2 * dot(a, b), dot(b, b) + 2 * dot(a, c), 2 * dot(b, c), dot(c, c)]
        slope = [4 * quartic[0], 3 * quartic[1], 2 * quartic[2], quartic[3]]
        found = []
        for poly in (slope, quartic):
            poly = list(poly)
            while poly and abs(poly[0]) < mpf("1e-35"):
                poly.pop(0)
            if len(poly) > 1:
                try:
                    roots = mp.polyroots(poly, maxsteps=2000, extraprec=400)
                except mp.NoConvergence:
                    roots = mp.polyroots(poly, maxsteps=20000, extraprec=4000)
                found += [mp.re(r) for r in roots]
        return found

    def _knots(self):
        inner = sorted(t for t in self._minima() if mpf("1e-25") < t < 1 - mpf("1e-25"))
        knots = [mpf(0)]
        for t in inner + [mpf(1)]:
            if t - knots[-1] > mpf("1e-12") or t == 1:
                knots.append(t)
        fine = [knots[0]]
        for a, b in zip(knots, knots[1:]):
            fine += [a + (b - a) * k / 4 for k in (1, 2, 3)] + [b]
        self.knots = fine
        self.s = [mpf(0)]
        for a, b in zip(fine, fine[1:]):
            self.s.append(self.s[-1] + self._integral(a, b))
        self.length = self.s[-1]

    def _integral(self, a, b):
        """Adaptive tanh-sinh: halves until the two answers agree to 1e-25 of the size."""
        if a == b or self.size == 0:
            return mpf(0)
        value, error = mp.quad(self.speed, [a, b], error=True)
        if error <= mpf("1e-27") * self.size or abs(b - a) < mpf("1e-20"):
            return value
        m = (a + b) / 2
        return self._integral(a, m) + self._integral(m, b)

    def parameter(self, s):
        """t with arc length s: Newton within a bracket, bisection where it fails."""
        if s <= 0:
            return mpf(0)
        if s >= self.length:
            return mpf(1)
        k = max(i for i in range(len(self.s) - 1) if self.s[i] <= s)
        low, high, base = self.knots[k], self.knots[k + 1], self.knots[k]
        rest = s - self.s[k]
        piece = self.s[k + 1] - self.s[k]
        if piece == 0:
            return low
        t = low + (high - low) * rest / piece
        for _ in range(300):
            miss = self._integral(base, t) - rest
            if abs(miss) <= mpf("1e-28") * self.size:
                return t
            if miss > 0:
                high = t
            else:
                low = t
            v = self.speed(t)
            step = t - miss / v if v > 0 else low
            t = step if low < step < high else (low + high) / 2
            if high - low < mpf("1e-36"):
                return t
        raise ArithmeticError("the inverse of the arc length did not converge")

    def at_length(self, s):
        return self.point(self.parameter(s))

    def tangent(self, end):
        """Unit direction of travel at the start (0) or the end (1): of the first
        derivative that is not zero, seen from inside."""
        t = mpf(end)
        for order in (1, 2, 3):
            d = self.derivative(t, order)
            if norm(d) > mpf("1e-25") * self.size:
                sign = -1 if end == 1 and order == 2 else 1
                return mul(unit(d), sign)
        raise ArithmeticError("a curve without length has no tangent")


def position_curve(points, tcbs, closed):
    """Kochanek and Bartels, uniform; quadratic ends; neighbours wrap if closed."""
    n = len(points)
    out, into = [None] * n, [None] * n
    for i in range(n):
        t, c, b = tcbs[i]
        if closed or 0 < i < n - 1:
            before = sub(points[i], points[i - 1])
            after = sub(points[(i + 1) % n], points[i])
            out[i] = add(
                mul(before, (1 - t) * (1 + c) * (1 + b) / 2), mul(after, (1 - t) * (1 - c) * (1 - b) / 2)
            )
            into[i] = add(
                mul(before, (1 - t) * (1 - c) * (1 + b) / 2), mul(after, (1 - t) * (1 + c) * (1 - b) / 2)
            )
        elif n == 2:
            out[i] = into[i] = mul(sub(points[1], points[0]), 1 - t)
        elif i == 0:
            p0, p1, p2 = points[:3]
            out[i] = mul(sub(sub(mul(p1, 4), mul(p0, 3)), p2), (1 - t) / 2)
        else:
            p2, p1, p0 = points[-3:]
            into[i] = mul(add(sub(mul(p0, 3), mul(p1, 4)), p2), (1 - t) / 2)
    count = n if closed else n - 1
    return [Segment(points[i], points[(i + 1) % n], out[i], into[(i + 1) % n]) for i in range(count)]


# --------------------------------------------------------------- speed curve


class SpeedCurve:
    """`before` and `after` are facing speeds or None; `start` and `end` the slopes at joints, or None."""

    def __init__(self, v, before, after, start=None, end=None):
        self.v = v = [mpf(x) for x in v]
        h = self.h = mpf(1) / 9
        m = [mpf(0)] * 10
        for j in range(1, 9):
            m[j] = (v[j + 1] - v[j - 1]) / (2 * h)
        m[0] = (-3 * v[0] + 4 * v[1] - v[2]) / (2 * h) if before is None else (v[1] - before) / (2 * h)
        m[9] = (3 * v[9] - 4 * v[8] + v[7]) / (2 * h) if after is None else (after - v[8]) / (2 * h)
        m[0] = m[0] if start is None else start
        m[9] = m[9] if end is None else end
        for j in range(10):
            low, high = (1 - v[j]) * 3 / h, (100 - v[j]) * 3 / h
            if j < 9:  # v + m h/3
                m[j] = min(max(m[j], low), high)
            if j > 0:  # v - m h/3
                m[j] = min(max(m[j], -high), -low)
        self.m = m
        self.cumulative = [mpf(0)]
        for j in range(9):
            self.cumulative.append(self.cumulative[-1] + self._part(j, mpf(1)))
        self.mean = self.cumulative[9]

    def _part(self, j, x):
        """Integral over the first x of interval j, term by term."""
        v0, v1, m0, m1 = self.v[j], self.v[j + 1], self.m[j] * self.h, self.m[j + 1] * self.h
        c2 = 3 * (v1 - v0) - 2 * m0 - m1
        c3 = 2 * (v0 - v1) + m0 + m1
        return self.h * (v0 * x + m0 * x**2 / 2 + c2 * x**3 / 3 + c3 * x**4 / 4)

    def fraction(self, u):
        if u >= 1:
            return mpf(1)
        j = int(mp.floor(u * 9))
        return (self.cumulative[j] + self._part(j, u * 9 - j)) / self.mean


class Joint:
    """The change of the speed per frame at the instant between two sections whose facing speeds are
    equal: that of the parabola through the values around it, at the frames at which they would be
    were the ten of either section joined by straight lines; no larger than 3/2 of a step beside it."""

    def __init__(self, before, after):
        far, at, near = before.speeds[8], before.speeds[9], after.speeds[1]
        left, right = before.straight / 9, after.straight / 9
        # Lagrange's polynomial through (-left, far), (0, at), (right, near), derived at 0.
        parabola = (
            -far * right / (left * (left + right))
            + at * (right - left) / (left * right)
            + near * left / (right * (left + right))
        )
        steps = [(at - far) / left, (near - at) / right]
        if steps[0] * steps[1] <= 0:
            self.acceleration = mpf(0)
        else:
            most = 3 * min(abs(step) for step in steps) / 2
            self.acceleration = min(max(parabola, -most), most)


# ------------------------------------------------------------ monotone cubic

def sign(x):
    return (x > 0) - (x < 0)


def monotone_slopes(h, d, cyclic):
    """Slopes of the monotone cubic over intervals of widths h and secants d
    (Fritsch and Carlson 1980): three-point slopes, also at the ends. Each
    interval asks for its pair to be drawn into the circle of radius 3 secants;
    a slope follows the stricter of the two that ask."""
    n = len(h)
    if cyclic:
        m = [(h[i] * d[i - 1] + h[i - 1] * d[i]) / (h[i - 1] + h[i]) for i in range(n)]
        turns = [sign(d[i - 1]) * sign(d[i]) <= 0 for i in range(n)]
    elif n == 1:
        return [d[0], d[0]]
    else:
        m = [((2 * h[0] + h[1]) * d[0] - h[0] * d[1]) / (h[0] + h[1])]
        m += [(h[i] * d[i - 1] + h[i - 1] * d[i]) / (h[i - 1] + h[i]) for i in range(1, n)]
        m += [((2 * h[-1] + h[-2]) * d[-1] - h[-1] * d[-2]) / (h[-1] + h[-2])]
        turns = [sign(m[0]) * sign(d[0]) <= 0]
        turns += [sign(d[i - 1]) * sign(d[i]) <= 0 for i in range(1, n)]
        turns += [sign(m[-1]) * sign(d[-1]) <= 0]
    m = [mpf(0) if turn else slope for slope, turn in zip(m, turns)]
    draw = [mpf(1)] * len(m)
    for i in range(n):
        j = (i + 1) % len(m)
        reach = mp.hypot(m[i], m[j]) / abs(d[i]) if d[i] != 0 else 0  # then both are 0
        if reach > 3:
            draw[i], draw[j] = min(draw[i], 3 / reach), min(draw[j], 3 / reach)
    return [slope * factor for slope, factor in zip(m, draw)]


def hermite(y0, y1, m0, m1, h, x):
    return (
        y0 * (1 + 2 * x) * (1 - x) ** 2
        + y1 * x * x * (3 - 2 * x)
        + h * m0 * x * (1 - x) ** 2
        + h * m1 * x * x * (x - 1)
    )


# --------------------------------------------------------------------- path


def wrap(degrees):
    """Into (-180, 180]."""
    d = degrees - 360 * mp.floor(degrees / 360)
    return d - 360 if d > 180 else d


class Key:
    def __init__(self, point, index, position, o):
        self.point, self.index, self.position, self.o = point, index, position, o
        self.absolute = o["absolute"]
        target = vec(o["target"])
        self.target = target
        self.view = unit(sub(target, position) if self.absolute else target)
        self.roll = mpf(o["roll"])
        self.zoom = mpf(o["zoom"])
        self.tcb = vec(o["tcb"])
        self.hold = o["hold"]
        self.zoom_slope = None if o["zoom_slope"] is None else mpf(o["zoom_slope"])
        self.up = o["up"]
        self.q = level_q(self.up, self.view, mp.radians(self.roll))


class Section:
    pass


def half_turn_sign(r):
    """The first component of the rotation vector (w, x, y, z) in the camera
    frame that is not zero, in the order y, x, z, shall be positive."""
    for k in (2, 1, 3):
        if abs(r[k]) > mpf("1e-12"):
            return 1 if r[k] > 0 else -1
    raise ArithmeticError("no rotation in a half turn")


class Path:
    def __init__(self, case):
        self.case = case
        self.closed = case["closed"]
        self.mode = case["orientation_mode"]
        points = case["points"]
        self.positions = [vec(p["position"]) for p in points]
        tcbs = [vec(p["tcb"] if p["tcb"] is not None else case["presets"][p["preset"]]) for p in points]
        self.segments = position_curve(self.positions, tcbs, self.closed)
        raw = [
            Key(i, k, self.positions[i], o)
            for i, p in enumerate(points)
            for k, o in enumerate(p["orientations"])
        ]
        self.raw_sections(raw)
        self.merge(raw)
        self.speeds_and_times()
        self.zoom_slopes()
        self.relative_rotations()
        self.classify()
        self.rolls()
        if self.mode == "tcb":
            self.velocities()
        self.layout()

    # ---- what changes

    def raw_sections(self, raw):
        count = len(raw) if self.closed else len(raw) - 1
        move, turn, zoom, roll = (mpf(s) for s in self.case["speeds"])
        self.raw = []
        for i in range(count):
            a, b = raw[i], raw[(i + 1) % len(raw)]
            s = Section()
            s.start, s.end = a, b
            s.moves = a.point != b.point
            s.segment = self.segments[a.point] if s.moves else None
            length = s.segment.length if s.moves else mpf(0)
            if a.up == b.up:
                d_roll = abs(wrap(b.roll - a.roll))
            else:
                d_roll = mp.degrees(angle(vpn_vup(a.q)[1], vpn_vup(b.q)[1]))
            if length > mpf("1e-9"):
                s.change, s.amount, s.base = "position", length, move
            elif angle(a.view, b.view) > mpf("1e-9"):
                theta = angle(a.q, b.q)
                s.change, s.amount, s.base = "view", min(theta, PI - theta) / (PI / 2), turn
            elif d_roll > mpf("1e-9"):
                s.change, s.amount, s.base = "roll", d_roll / 90, roll
            elif abs(a.zoom - b.zoom) > mpf("1e-9"):
                s.change, s.amount, s.base = "zoom", abs(a.zoom - b.zoom) / 99, zoom
            else:
                s.change, s.amount, s.base = "nothing", mpf(0), mpf(0)
            s.frames = 0
            self.raw.append(s)

    def merge(self, raw):
        """Keys between which nothing changes are one, with the later one's
        properties. Over the seam of a closed path the later one is the first."""
        self.sections = [s for s in self.raw if s.change != "nothing"]
        if not self.sections:
            self.keys = [raw[0] if self.closed else raw[-1]]
            return
        self.keys = [s.start for s in self.sections]
        if self.closed:
            # Whatever is merged over the seam begins with the last of the group,
            # which is the start of the first section with frames.
            pass
        else:
            self.keys.append(raw[-1])
        n = len(self.keys)
        for i, s in enumerate(self.sections):
            s.a, s.b = i, (i + 1) % n

    def speeds_and_times(self):
        n = len(self.sections)
        for s in self.sections:
            s.speeds = [mpf(x) for x in s.start.o["speeds"]]
            s.work = s.amount * s.base * 50
            lines = [(a + b) / 2 for a, b in zip(s.speeds, s.speeds[1:])]
            s.straight = s.work / (mp.fsum(lines) / 9)
        # joints[i] is between section i and the next.
        joints = [None] * n
        for i in range(n if self.closed else n - 1):
            s, t = self.sections[i], self.sections[(i + 1) % n]
            if s.speeds[9] == t.speeds[0] and t.start.o["hold"] == 0:
                joints[i] = Joint(s, t)
        self.times = [mpf(0)]
        for i, s in enumerate(self.sections):
            before = after = None
            if self.closed or i > 0:
                before = self.sections[i - 1].speeds[9]
            if self.closed or i < n - 1:
                after = self.sections[(i + 1) % n].speeds[0]
            exact = self.frames_of(s, before, after, joints[i - 1], joints[i])
            assert abs(exact - mp.floor(exact) - 0.5) > mpf("1e-6"), ("rounding tie", self.case["name"], i)
            s.frames = max(1, int(mp.floor(exact + mpf(0.5))))
            s.dt = s.frames * s.curve.mean / 50
            self.times.append(self.times[-1] + s.dt)

    def frames_of(self, s, before, after, start, end):
        """The frames of a section, whose curve has the slopes at its joints if it lasts so long."""

        def left(frames):
            slopes = [None if joint is None else joint.acceleration * frames for joint in (start, end)]
            s.curve = SpeedCurve(s.speeds, before, after, *slopes)
            return s.work - frames * s.curve.mean

        if start is None and end is None:
            left(mpf(0))
            return s.work / s.curve.mean
        low, high = s.straight / 2, 2 * s.straight
        assert left(low) > 0 > left(high)
        for _ in range(140):
            middle = (low + high) / 2
            low, high = (middle, high) if left(middle) > 0 else (low, middle)
        assert all(joint is None or abs(m - joint.acceleration * high) < mpf("1e-30")
                   for joint, m in ((start, s.curve.m[0]), (end, s.curve.m[9]))), "clipped"  # fmt: skip
        return high

    # ---- zoom

    def zoom_slopes(self):
        keys, n = self.keys, len(self.sections)
        if not n or self.case["zoom_mode"] == "linear":
            return
        h = [s.dt for s in self.sections]
        d = [(keys[s.b].zoom - keys[s.a].zoom) / s.dt for s in self.sections]
        self.zoom_m = monotone_slopes(h, d, self.closed)
        # An own slope is cut until the Bezier points beside its key are zooms.
        low, high = mpf(1), mpf(2000)
        for s in self.sections:
            for at, side in ((s.a, s.dt / 3), (s.b, -s.dt / 3)):
                key = keys[at]
                if key.zoom_slope is not None:
                    ends = [(low - key.zoom) / side, (high - key.zoom) / side]
                    key.zoom_slope = min(max(key.zoom_slope, min(ends)), max(ends))
                    self.zoom_m[at] = key.zoom_slope

    def zoom(self, s, f):
        a, b = self.keys[s.a], self.keys[s.b]
        if self.case["zoom_mode"] == "linear":
            return a.zoom + f * (b.zoom - a.zoom)
        return hermite(a.zoom, b.zoom, self.zoom_m[s.a], self.zoom_m[s.b], s.dt, f)

    # ---- orientation

    def relative_rotations(self):
        """For each section the rotation r = +-q_a^-1 q_b with the sign that the
        chain of keys takes; the chain itself is then a product of them."""
        for s in self.sections:
            a, b = self.keys[s.a], self.keys[s.b]
            r = qmul(qconj(a.q), b.q)
            if abs(r[0]) <= mpf("1e-12"):
                flip = half_turn_sign(r) < 0
            else:
                flip = r[0] < 0
            s.sign = -1 if flip else 1
            world = qmul(b.q, qconj(a.q))
            s.log = qlog(qneg(world) if flip else world)  # half the rotation
            s.theta = norm(s.log)

    def ends_of(self, s):
        """The section's two keys with signs that suit each other."""
        a, b = self.keys[s.a].q, self.keys[s.b].q
        return a, (qneg(b) if s.sign < 0 else b)

    def classify(self):
        for s in self.sections:
            a, b = self.keys[s.a], self.keys[s.b]
            if a.up != b.up:
                s.kind = "free"
            elif a.absolute and b.absolute and a.target == b.target:
                s.kind = "tracked"
            elif (
                not a.absolute
                and not b.absolute
                and norm(sub(a.view, b.view)) <= mpf("1e-12")
                and a.roll == b.roll
            ):
                s.kind = "kept"
            else:
                s.kind = "free"

    def neighbours(self, i):
        """Sections into and out of key i, or None."""
        n = len(self.sections)
        if self.closed:
            return self.sections[i - 1], self.sections[i % n]
        return (self.sections[i - 1] if i > 0 else None), (self.sections[i] if i < n else None)

    def rolls(self):
        """Unwrapped rolls and their slopes over each run of tracked sections."""
        n = len(self.sections)
        tracked = [s.kind == "tracked" for s in self.sections]
        if self.closed and n and all(tracked):
            h, d, r = [], [], self.keys[0].roll
            for s in self.sections:
                step = wrap(self.keys[s.b].roll - self.keys[s.a].roll)
                s.r0, s.r1 = r, r + step
                r += step
                h.append(s.dt)
                d.append(step / s.dt)
            m = monotone_slopes(h, d, True)
            for s in self.sections:
                s.m0, s.m1 = m[s.a], m[s.b]
            return
        for i in range(n):
            begins = tracked[i] and not (tracked[i - 1] if (i > 0 or self.closed) else False)
            if not begins:
                continue
            run, k = [], i
            while len(run) < n and (k < n or self.closed) and tracked[k % n]:
                run.append(self.sections[k % n])
                k += 1
            y, d = [self.keys[run[0].a].roll], []
            for s in run:
                step = wrap(self.keys[s.b].roll - self.keys[s.a].roll)
                y.append(y[-1] + step)
                d.append(step / s.dt)
            m = monotone_slopes([s.dt for s in run], d, False)
            for j, s in enumerate(run):
                s.r0, s.r1, s.m0, s.m1 = y[j], y[j + 1], m[j], m[j + 1]

    def inner_velocity(self, s, end):
        """Angular velocity (half angles, per curve time) of a tracked or kept
        section at its start (0) or end (1)."""
        if s.kind == "kept":
            return (mpf(0),) * 3
        key = self.keys[s.b if end else s.a]
        n, d = levelled(key.up, key.view), norm(sub(key.target, key.position))
        p = mul(s.segment.tangent(end), s.segment.length / s.dt) if s.change == "position" else (mpf(0),) * 3
        p = levelled(key.up, p)
        dn = mul(sub(p, mul(n, dot(n, p))), -1 / d)
        h2 = n[0] ** 2 + n[2] ** 2
        roll = mp.radians(s.m1 if end else s.m0)
        if norm(p) == 0:
            return worldly(key.up, mul(n, roll / 2))
        if h2 < POLE**2:
            raise ArithmeticError("no yaw velocity at the pole")
        yaw, _ = yaw_pitch(n)
        d_yaw = (n[2] * dn[0] - n[0] * dn[2]) / h2
        d_pitch = -dn[1] / mp.sqrt(h2)
        full = add(
            add((mpf(0), d_yaw, mpf(0)), mul((mp.cos(yaw), mpf(0), -mp.sin(yaw)), d_pitch)), mul(n, roll)
        )
        return worldly(key.up, mul(full, mpf(1) / 2))

    def plain_velocity(self, i, weights):
        into, out = self.neighbours(i)
        w_in, w_out = weights
        return mul(
            add(mul(into.log, w_in * out.dt / into.dt), mul(out.log, w_out * into.dt / out.dt)),
            1 / (into.dt + out.dt),
        )

    def velocities(self):
        """s.w0 and s.w1 of every free section: velocity at its start and end."""
        near = mpf("0.45")
        self.slerp_only = not self.closed and len(self.keys) == 2
        if self.slerp_only:
            return

        def free(s):
            return s is not None and s.kind == "free"

        def smooth(i):
            """Velocity at a key next to an end, at t = c = b = 0."""
            into, out = self.neighbours(i)
            for s, end in ((into, 1), (out, 0)):
                if not free(s):
                    return self.inner_velocity(s, end)
            return self.plain_velocity(i, (1, 1))

        def shrink(w, dt, limit):
            reach = norm(w) * dt / 3
            return limit / reach if reach > limit else mpf(1)

        for i, key in enumerate(self.keys):
            into, out = self.neighbours(i)
            t, c, b = key.tcb
            if free(into) and free(out):
                right = mul(self.plain_velocity(i, ((1 + c) * (1 + b), (1 - c) * (1 - b))), 1 - t)
                left = mul(self.plain_velocity(i, ((1 - c) * (1 + b), (1 + c) * (1 - b))), 1 - t)
                k = min(
                    shrink(left, into.dt, min(into.theta, near * (PI - into.theta))),
                    shrink(right, out.dt, min(out.theta, near * (PI - out.theta))),
                )
                into.w1, out.w0 = mul(left, k), mul(right, k)
            elif free(into) and out is not None:
                w = self.inner_velocity(out, 0)
                into.w1 = mul(w, shrink(w, into.dt, near * (PI - into.theta)))
            elif free(out) and into is not None:
                w = self.inner_velocity(into, 1)
                out.w0 = mul(w, shrink(w, out.dt, near * (PI - out.theta)))
            elif free(out) or free(into):
                s, other = (out, i + 1) if free(out) else (into, i - 1)
                w = mul(sub(mul(s.log, 2 / s.dt), smooth(other)), 1 - t)
                w = mul(w, shrink(w, s.dt, min(s.theta, near * (PI - s.theta))))
                if free(out):
                    s.w0 = w
                else:
                    s.w1 = w

    def free_q(self, s, f):
        q0, q3 = self.ends_of(s)
        if self.mode == "slerp" or (self.mode == "tcb" and self.slerp_only):
            return slerp(q0, q3, f)
        if self.mode == "barry-goldman":
            return self.barry_goldman(s, f)
        row = [
            q0,
            qmul(qexp(mul(s.w0, s.dt / 3)), q0),
            qmul(qexp(mul(s.w1, -s.dt / 3)), q3),
            q3,
        ]
        while len(row) > 1:
            row = [slerp(a, b, f) for a, b in zip(row, row[1:])]
        return row[0]

    def barry_goldman(self, s, f):
        q1, q2 = self.ends_of(s)
        into, _ = self.neighbours(s.a)
        _, out = self.neighbours(s.b) if self.closed else self.neighbours(s.a + 1)
        if into is None:
            q0, h0 = qmul(qmul(q1, qconj(q2)), q1), s.dt
        else:
            q0, h0 = self.keys[into.a].q, into.dt
            if into.sign < 0:
                q0 = qneg(q0)
        if out is None:
            q3, h2 = qmul(qmul(q2, qconj(q1)), q2), s.dt
        else:
            q3, h2 = self.keys[out.b].q, out.dt
            if out.sign * s.sign < 0:
                q3 = qneg(q3)
        t = [-h0, mpf(0), s.dt, s.dt + h2]
        row = [q0, q1, q2, q3]
        x = f * s.dt

        def at(a, b, i, j):
            return slerp(a, b, (x - t[i]) / (t[j] - t[i]))

        a = [at(row[k], row[k + 1], k, k + 1) for k in range(3)]
        b = [at(a[0], a[1], 0, 2), at(a[1], a[2], 1, 3)]
        return at(b[0], b[1], 1, 2)

    def tracked_q(self, s, f, place):
        target, up = self.keys[s.a].target, self.keys[s.a].up
        roll = mp.radians(hermite(s.r0, s.r1, s.m0, s.m1, s.dt, f))
        if s.change != "position":
            return level_q(up, self.keys[s.a].view, roll)
        length = s.segment.length

        def offset(distance):
            return sub(target, s.segment.at_length(distance))

        def last(ok):
            """The last distance before this one at which `ok` held, or None."""
            here = f * length
            step = mpf("1e-13")
            while not ok(offset(max(here - step, 0))):
                if step > here:
                    return None
                step *= 2
            low, high = max(here - step, 0), here
            for _ in range(100):
                m = (low + high) / 2
                if ok(offset(m)):
                    low = m
                else:
                    high = m
            return offset(low)

        def off_pole(v):
            v = levelled(up, unit(v))
            return mp.hypot(v[0], v[2]) >= POLE

        here = sub(target, place)
        if norm(here) < mpf("1e-9"):
            found = last(lambda v: norm(v) >= mpf("1e-9"))
            here = self.keys[s.a].view if found is None else found
        n = unit(here)
        if not off_pole(n):
            found = last(off_pole)
            yaw = yaw_pitch(levelled(up, self.keys[s.a].view if found is None else unit(found)))[0]
            return level_q(up, n, roll, yaw)
        return level_q(up, n, roll)

    # ---- frames

    def layout(self):
        """Where each section begins: the number of the last pose of its start."""
        at = 1 + self.keys[0].hold
        for i, s in enumerate(self.sections):
            s.base_frame = at
            at += s.frames
            if not (self.closed and i == len(self.sections) - 1):
                at += self.keys[s.b].hold
        self.count = at

    def key_pose(self, key):
        n, up = vpn_vup(key.q)
        return key.position + n + up + (key.zoom,)

    def pose(self, frame):
        """frame: 1 to count, fractions too."""
        frame = mpf(frame)
        key = self.keys[0]
        for s in self.sections:
            n = frame - s.base_frame
            if n <= 0:
                break
            if n < s.frames:
                return self.inner_pose(s, n / s.frames)
            key = self.keys[s.b]
        return self.key_pose(key)

    def inner_pose(self, s, u):
        f = s.curve.fraction(u)
        if s.change == "position":
            place = s.segment.at_length(f * s.segment.length)
        else:
            place = self.keys[s.a].position
        if s.kind == "tracked":
            q = self.tracked_q(s, f, place)
        elif s.kind == "kept":
            q = self.keys[s.a].q
        else:
            q = self.free_q(s, f)
        n, up = vpn_vup(q)
        return place + n + up + (self.zoom(s, f),)


# ------------------------------------------------------------------- output


def number(x):
    """The nearest double, shortest text that gives it back."""
    x = float(x)
    text = repr(0.0 if abs(x) < 1e-30 else x)
    return text.removesuffix(".0")


def numbers(*v):
    return " ".join(number(x) for x in v)


def chosen(path, wanted):
    """The first and last frames, those about every key, some in between and
    some between two frames."""
    count = path.count
    if count <= wanted:
        frames = {mpf(k) for k in range(1, count + 1)}
    else:
        frames = {mpf(k) for k in (1, 2, count - 1, count)}
        sections = path.sections
        each = max(3, (wanted - 8) // max(1, len(sections)) - 2)
        for s in sections:
            frames |= {mpf(s.base_frame + k) for k in (0, 1, s.frames - 1, s.frames)}
            for k in range(1, each):
                frames.add(mpf(s.base_frame + (k * s.frames) // each))
    for i, s in enumerate(path.sections):
        if s.frames < 4:
            frames |= {s.base_frame + mpf(k) / 8 for k in range(1, 8 * s.frames)}
        frames.add(s.base_frame + mpf((s.frames * (3 + i % 7)) // 10) + mpf(1 + i % 7) / 8)
    return sorted(f for f in frames if 1 <= f <= count)


def write(case, folder, wanted):
    """One file: a word and its values on each line, first the path, then what
    comes out of it."""
    path = Path(case)
    lines = [
        f"# {case['about']}",
        f"closed {int(case['closed'])}",
        f"orientation_mode {case['orientation_mode']}",
        f"zoom_mode {case['zoom_mode']}",
        f"speeds {numbers(*case['speeds'])}",
    ]
    lines += [f"preset {numbers(*p)}" for p in case["presets"]]
    lines += ["# point: x y z, preset or t c b", "# view: target, roll, zoom, hold, t c b, ten speeds"]
    for p in case["points"]:
        shape = f"preset {p['preset']}" if p["tcb"] is None else f"tcb {numbers(*p['tcb'])}"
        lines.append(f"point {numbers(*p['position'])} {shape}")
        for o in p["orientations"]:
            kind = "absolute" if o["absolute"] else "relative"
            values = numbers(*o["target"], o["roll"], o["zoom"], o["hold"], *o["tcb"], *o["speeds"])
            lines.append(f"view {kind} {values}")
            if o["zoom_slope"] is not None:
                lines.append(f"zoom_slope {number(mpf(o['zoom_slope']))}")
            if o["up"] != "y":
                lines.append(f"up {o['up']}")
    lines += [f"segment {number(s.length)}" for s in path.segments]
    lines.append("# section: what changes, by how much, mean speed, frames")
    for s in path.raw:
        mean = s.curve.mean if s.frames else 0
        lines.append(f"section {s.change} {numbers(s.amount, mean)} {s.frames}")
    lines += [f"frames {path.count}", "# pose: frame, vrp, vpn, vup, zoom"]
    frames = chosen(path, wanted)
    for f in frames:
        label = str(int(f)) if f == int(f) else number(f)
        lines.append(f"pose {label} {numbers(*path.pose(f))}")
    text = "\n".join(lines) + "\n"
    (folder / f"{case['name']}.txt").write_text(text)
    return path.count, len(frames), len(text)


def main():
    import pathlib
    import time

    from reference_cases import cases

    here = pathlib.Path(__file__).resolve().parent
    folder = here / "reference"
    folder.mkdir(exist_ok=True)
    only = set(sys.argv[1:])
    total = 0
    for case in cases():
        if only and case["name"] not in only:
            continue
        begin = time.time()
        count, shown, size = write(case, folder, case["wanted"])
        total += size
        print(f"{case['name']:32} {count:6} frames {shown:5} written {size:7} bytes {time.time() - begin:6.1f} s")
    print(total, "bytes")


if __name__ == "__main__":
    main()
