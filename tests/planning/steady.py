"""Steady against SciPy and against noise of known power: steady.py VIDES FOLDER [COUNT]

VIDES is the command. Smooth flights (sums of slow sines in place and view) of a minute at 25 frames a
second get white noise, become paths by `vides fit` with a tolerance far below the noise, and are made
steady. What is left of the noise is held against the transfer of the filter (the cardinal smoothing
spline, in closed form), its mean against that of as much noise, the lag by the peak of the
correlation with the smooth flight, and the places against SciPy's `make_smoothing_spline` of the
same poses. Ends with status 1 if a flight keeps more than the transfer and three deviations of what
so many values tell of it, drifts by more than three, lags by more than 0.05 frames, is farther from
SciPy's spline than a tenth of what was taken out, or misses an end.
"""

import pathlib
import subprocess
import sys

import numpy as np
from scipy.interpolate import make_smoothing_spline
from scipy.spatial.transform import Rotation

vides, folder = sys.argv[1], pathlib.Path(sys.argv[2])
count = int(sys.argv[3]) if len(sys.argv) > 3 else 12
folder.mkdir(parents=True, exist_ok=True)
FPS, FRAMES = 25.0, 1500
random = np.random.default_rng(5)
time = np.arange(FRAMES) / FPS
inner = slice(60, FRAMES - 60)


def slow(size):
    """Sines of 12 to 30 s, as a function of seconds."""
    period, phase, part = random.uniform(12, 30, 4), random.uniform(0, 7, 4), random.uniform(0.5, 1, 4)
    return lambda t: size * sum(p * np.sin(2 * np.pi * t / d + f) for p, d, f in zip(part, period, phase)) / 2


def run(*arguments):
    return subprocess.run([vides, *arguments], capture_output=True, text=True, check=True)


def read(file):
    lines = run("sample", "--digits", "14", file).stdout.splitlines()
    rows = np.array([line.split()[:9] for line in lines], dtype=float)
    view, up = rows[:, 3:6], rows[:, 6:9]
    frames = np.stack([np.cross(up, view), up, view], axis=2)
    return rows[:, :3], Rotation.from_matrix(frames)


def transfer(seconds):
    """The filter's at a grid of frequencies from 0 to half a wave a frame."""
    w = np.pi * (np.arange(20000) + 0.5) / 20000
    light = (seconds * FPS / (2 * np.pi)) ** 4
    return 1 / (1 + light * (2 * np.sin(w / 2)) ** 4 * 3 / (2 + np.cos(w)))


def lag(moved, smooth):
    """The shift, in frames, at which the smooth flight fits best: parabola through three."""
    miss = [np.sum((moved - smooth(time + shift / FPS))[inner] ** 2) for shift in (-0.5, 0.0, 0.5)]
    return 0.25 * (miss[0] - miss[2]) / (miss[0] - 2 * miss[1] + miss[2])


faults, worst = 0, np.zeros(6)
for number in range(count):
    seconds, noise, turning = random.uniform(0.5, 1.5), random.uniform(0.003, 0.01), random.uniform(0.003, 0.01)
    place, angle = [slow(2.0) for _ in range(3)], [slow(0.6) for _ in range(3)]
    smooth = lambda t: np.stack([part(t) for part in place], axis=1)
    turn = lambda t: Rotation.from_euler("YXZ", np.stack([part(t) for part in angle], axis=1))
    noisy = smooth(time) + noise * random.standard_normal((FRAMES, 3))
    turned = Rotation.from_rotvec(turning * random.standard_normal((FRAMES, 3))) * turn(time)
    m = turned.as_matrix()
    rows = np.concatenate([noisy, m[:, :, 2], m[:, :, 1], np.full((FRAMES, 1), 30.0)], axis=1)
    poses, shaken, out = folder / "poses.txt", folder / "shaken.vid", folder / "steady.vid"
    np.savetxt(poses, rows, fmt="%.15g")
    run("fit", poses, "--tolerance", str(noise / 50), "--angle", str(np.degrees(turning) / 50), "-o", shaken)
    said = run("steady", shaken, "-o", out, "--period", str(seconds)).stderr
    points = int(said.split(" points")[0].split()[-1])
    was, was_turned = read(shaken)
    made, made_turned = read(out)
    through = np.mean(transfer(seconds) ** 2)
    values = (inner.stop - inner.start) * np.mean(transfer(seconds) ** 2) ** 2 / np.mean(transfer(seconds) ** 4)
    left = made - smooth(time)
    left_turned = (made_turned * turn(time).inv()).as_rotvec()
    found = []
    for rest, power in ((left, noise), (left_turned, turning)):
        share = np.mean(rest[inner] ** 2) / (power**2 * through)
        drift = np.linalg.norm(rest[inner].mean(axis=0)) / (power * np.sqrt(3 / (inner.stop - inner.start)))
        found += [(share - 1) * np.sqrt(3 * values / 2), drift]
    late = abs(lag(made, smooth))
    weights = np.ones(FRAMES)
    weights[[0, -1]] = 1e9
    light = (seconds * FPS / (2 * np.pi)) ** 4
    known = np.stack([make_smoothing_spline(np.arange(FRAMES), x, weights, light)(np.arange(FRAMES)) for x in was.T], axis=1)
    apart = np.linalg.norm(made - known, axis=1)[inner].max() / np.linalg.norm(made - was, axis=1).max()
    ends = max(np.abs(made - was)[[0, -1]].max(), (made_turned * was_turned.inv()).magnitude()[[0, -1]].max())
    bad = max(found) > 3 or late > 0.05 or apart > 0.1 + 1e-3 or ends > 1e-6
    faults += bad
    worst = np.maximum(worst, [found[0], found[2], max(found[1], found[3]), late, apart, ends])
    print(f"{number}: {seconds:.2f} s, {points} points of {FRAMES} poses; rest {found[0]:+.2f} and {found[2]:+.2f} deviations "
          f"from the transfer, drift {found[1]:.2f} and {found[3]:.2f}, lag {late:.4f} frames, "
          f"SciPy {apart:.3f} of what was taken out{' FAULT' if bad else ''}")
print(f"{count} flights, {faults} faults; at most {worst[0]:+.2f} and {worst[1]:+.2f} deviations above the transfer, "
      f"drift {worst[2]:.2f}, lag {worst[3]:.4f} frames, {worst[4]:.3f} from SciPy, ends {worst[5]:.1e}")
sys.exit(int(faults > 0))
