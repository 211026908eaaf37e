"""Retime against toppra and ruckig: retime.py VIDES FOLDER [COUNT]

VIDES is the command. For each random path (tcb, 3 to 8 points) its time with limits of speed and
acceleration is held against that of toppra on the same curve, with a grid of 1,000 and the norm of
the acceleration as 240 half-spaces; and the poses that it gives, at 20 places a frame, against the
limits. So is the time of random straight lines with a limit of the jerk, too, against ruckig, and
without one against the trapezoid. Ends with status 1 if a path takes more than 1.02 of toppra's
time and a frame a section, a line more than 1.05 of ruckig's and a frame, or more than a frame
above the trapezoid; if a limit is broken by more than 0.1 %; or if it all takes longer than toppra.
"""

import pathlib
import re
import subprocess
import sys
import time

import numpy as np
import ruckig
import toppra
import toppra.algorithm
import toppra.constraint

toppra.setup_logging("ERROR")
vides, folder = sys.argv[1], pathlib.Path(sys.argv[2])
count = int(sys.argv[3]) if len(sys.argv) > 3 else 50
folder.mkdir(parents=True, exist_ok=True)
FPS, SPEED, ACCELERATION, GRID = 25.0, 0.8, 1.5, 1000


class Hermite:
    """Kochanek and Bartels with t = c = b = 0, at the ends a parabola through three points."""

    def __init__(self, points):
        p = self.points = np.array(points)
        m = np.zeros_like(p)
        m[1:-1] = (p[2:] - p[:-2]) / 2
        m[0] = (-3 * p[0] + 4 * p[1] - p[2]) / 2
        m[-1] = (3 * p[-1] - 4 * p[-2] + p[-3]) / 2
        self.tangents = m
        self.dof = 3
        self.path_interval = np.array([0.0, len(p) - 1.0])
        self.duration = len(p) - 1.0

    @property
    def waypoints(self):
        return np.arange(len(self.points)), self.points

    def __call__(self, s, order=0):
        s = np.asarray(s, dtype=float)
        k = np.clip(s.astype(int), 0, len(self.points) - 2)
        t = (s - k)[..., None]
        p, q = self.points[k], self.points[k + 1]
        m, n = self.tangents[k], self.tangents[k + 1]
        a, b = 2 * p - 2 * q + m + n, 3 * q - 3 * p - 2 * m - n
        return [
            ((a * t + b) * t + m) * t + p,
            (3 * a * t + 2 * b) * t + m,
            6 * a * t + 2 * b,
        ][order]


def directions(number):
    """Evenly spread unit vectors, and their opposites."""
    k = np.arange(number // 2) + 0.5
    z, turn = 1 - k / (number // 2), np.pi * (1 + 5**0.5) * k
    r = np.sqrt(1 - z * z)
    half = np.stack([r * np.cos(turn), r * np.sin(turn), z], axis=1)
    return np.concatenate([half, -half])


F = directions(240)
G = np.full(len(F), ACCELERATION)


def others(path):
    """toppra's seconds, and how long it took to find them."""
    grid = np.linspace(0, path.duration, GRID + 1)

    def fastest(s):
        tangent = np.abs(path(s, 1))
        most = SPEED * tangent / np.linalg.norm(tangent) + 1e-9
        return np.stack([-most, most], axis=1)

    constraints = [
        toppra.constraint.JointVelocityConstraintVarying(fastest),
        toppra.constraint.SecondOrderConstraint(lambda q, v, a: a, lambda q: F, lambda q: G, 3),
    ]
    begin = time.perf_counter()
    instance = toppra.algorithm.TOPPRA(constraints, path, gridpoints=grid, solver_wrapper="seidel")
    _, rate, _ = instance.compute_parameterization(0, 0)
    took = time.perf_counter() - begin
    steps = 2 * np.diff(grid) / (rate[1:] + rate[:-1])
    return steps.sum(), took


def retimed(points, limits):
    """Seconds, the places at 20 places a frame, and how long it took; none where it is refused."""
    file, out = folder / "in.vid", folder / "out.vid"
    text = f"version = 1\nfps = {FPS}\n"
    for point in points:
        text += f"[[point]]\nposition = {[float(x) for x in point]}\n[[point.orientation]]\noffset = [0, 0, -1]\n"
    file.write_text(text)
    limits = {"turning": "off", "zoom": "off", "turning-acceleration": "off", **limits}
    options = [f"--limit={kind}={limit}" for kind, limit in limits.items()]
    begin = time.perf_counter()
    done = subprocess.run([vides, "retime", file, "-o", out, *options], capture_output=True, text=True)
    took = time.perf_counter() - begin
    if done.returncode:
        print(done.stderr.strip())
        return None
    # The same poses, and 19 between each two of them.
    finer = re.sub(r"(?m)^frames = (\d+)", lambda found: f"frames = {STEPS * int(found[1])}", out.read_text())
    out.write_text(finer)
    poses = subprocess.run([vides, "sample", "--digits", "14", out], capture_output=True, text=True, check=True).stdout
    place = np.array([line.split()[:3] for line in poses.splitlines()], dtype=float)
    # From rest to rest: without the frame of the last pose.
    return float(done.stderr.split()[-2]) - 1 / FPS, place, took


def peaks(place):
    """The greatest speed and acceleration between places, and the greatest third difference over
    frames, at rest before and behind."""
    def most(step, order):
        ends = [np.repeat(place[:1], 3 * step, 0), place, np.repeat(place[-1:], 3 * step, 0)]
        found = np.concatenate(ends) if order == 3 else place
        for _ in range(order):
            found = found[step:] - found[:-step]
        return np.linalg.norm(found, axis=1).max() * (FPS * STEPS / step) ** order

    return most(1, 1), most(1, 2), most(STEPS, 3)


def trapezoid(length, speed, acceleration):
    if length > speed**2 / acceleration:
        return length / speed + speed / acceleration
    return 2 * (length / acceleration) ** 0.5


def shortest(length, speed, acceleration, jerk):
    """ruckig's seconds."""
    wanted = ruckig.InputParameter(1)
    wanted.current_position, wanted.target_position = [0.0], [length]
    wanted.max_velocity, wanted.max_acceleration, wanted.max_jerk = [speed], [acceleration], [jerk]
    found = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(wanted, found)
    return found.duration


STEPS = 20
random = np.random.default_rng(7)
faults, shares, ours_took, theirs_took, worst = 0, [], 0.0, 0.0, [0.0, 0.0]
for number in range(count):
    points = random.uniform(-1, 1, (int(random.integers(3, 9)), 3))
    made = retimed(points, {"speed": SPEED, "acceleration": ACCELERATION})
    if made is None:
        faults += 1
        continue
    seconds, place, took = made
    ours_took += took
    known, took = others(Hermite(points))
    theirs_took += took
    speed, bend, _ = peaks(place)
    speed, bend = speed / SPEED, bend / ACCELERATION
    worst = [max(worst[0], speed), max(worst[1], bend)]
    most = 1.02 * known + (len(points) - 1) / FPS
    shares.append(seconds / known)
    if not seconds <= most or max(speed, bend) > 1.001:
        print(f"path {number}: {seconds} s, toppra {known:.3f} s, at most {most:.3f}; speed {speed:.4f}, "
              f"acceleration {bend:.4f} of the limits")
        faults += 1
print(f"{count} paths, {faults} faults; {np.mean(shares):.4f} of toppra's time in the mean, {max(shares):.4f} at most; "
      f"speed up to {worst[0]:.5f}, acceleration up to {worst[1]:.5f} of the limits; "
      f"{ours_took:.2f} s with starting and files, toppra {theirs_took:.2f} s")
faults += ours_took > theirs_took

lines, beyond, worst = 0, [], 0.0
for number in range(2 * count):
    length = random.uniform(0.1, 2)
    low, high = np.log([[0.05, 0.1, 0.3], [2, 4, 20]])
    speed, acceleration, jerk = (float(x) for x in np.exp(random.uniform(low, high)))
    way = random.normal(size=3)
    way *= length / 2 / np.linalg.norm(way)
    limits = {"speed": speed, "acceleration": acceleration}
    made, plain = retimed([-way, way], {**limits, "jerk": jerk}), retimed([-way, way], limits)
    if made is None or plain is None:
        lines += 1
        continue
    known, straight = shortest(length, speed, acceleration, jerk), trapezoid(length, speed, acceleration)
    found = [peak / limit for peak, limit in zip(peaks(made[1]), (speed, acceleration, jerk), strict=True)]
    beyond.append(made[0] / known)
    worst = max(worst, found[2])
    if made[0] > 1.05 * known + 1 / FPS or max(found) > 1.001 or plain[0] > straight + 1.0 / FPS:
        print(f"line {number}: {made[0]} s, ruckig {known:.3f} s; {plain[0]} s, trapezoid {straight:.3f} s; "
              f"{np.round(found, 4)} of the limits")
        lines += 1
print(f"{2 * count} lines, {lines} faults; {np.mean(beyond):.4f} of ruckig's time in the mean, {max(beyond):.4f} at most; "
      f"jerk up to {worst:.5f} of the limit")
sys.exit(faults + lines > 0)
