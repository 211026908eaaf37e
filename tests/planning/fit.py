"""The fit against SciPy, ground truth and recordings of others: fit.py LIBRARY FOLDER [COUNT]; with a
FILE.svg in place of the folder it only draws the time by the number of poses.

LIBRARY is libvides.so. COUNT recordings are made (300): smooth flights at 10 to 1,000 poses a second,
with jitter, drops, noise (Gaussian, uniform), pauses, gaps, cuts and outliers; then those of evo's
tests, which come from PyPI into FOLDER. Each is fitted with several tolerances and held, at the times
of its poses, against the flight without noise. Ends with status 1 if

- a recording is refused, or has more points than poses;
- a greater tolerance gives more than 1.1 times as many points plus one;
- noise whose greatest deviation is below the tolerance more than doubles the points of the clean flight;
- even turning on an eased way, or eased turning on an even one, gives a point for four poses or fewer;
- more than a third of the poses became points because of noise, and the report names no tolerance
  that halves them, or the one that it names does not;
- the path is farther from the clean flight than 1.1 times SciPy's smoothing spline of equal smoothness;
- 3,000 poses take more than 0.5 s, 100,000 more than 20 s; with 300 recordings, 1,000,000 more than 5 minutes or 1 GB.

Equal smoothness is what SciPy's `splrep` and FITPACK call so: an equal sum of the squares by which a
spline misses the recorded poses. `make_smoothing_spline` gets the one weight for all coordinates with
which it misses them as the path does, the poses of each side of a cut by themselves, and no outlier.
Quaternions are smoothed likewise and then normalised; with noise, the path must also be nearer to the
clean views than 1.1 times SciPy's `RotationSpline` through the recorded poses nearest to its points.
A distance of SciPy's below a tenth of the tolerance counts as that: it is nothing, as the tolerance says. Times are those of
the processor.
"""

import ctypes
import multiprocessing
import pathlib
import re
import resource
import subprocess
import sys
import tarfile
import time

import numpy as np
from scipy.interpolate import make_smoothing_spline
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation, RotationSpline

library, folder = ctypes.CDLL(sys.argv[1]), pathlib.Path(sys.argv[2])
count = int(sys.argv[3]) if len(sys.argv) > 3 else 300
if folder.suffix != ".svg":
    folder.mkdir(parents=True, exist_ok=True)
LENGTH, DEGREES = 0.01, 0.5
LADDER = [0.25, 0.5, 2.0, 4.0, 16.0]
SECONDS = [(60.0, 20.0), (300.0, 10.0), (1000.0, 4.0)]
NOTHING = 0.1
FLIGHTS = ["hand", "line", "rotation", "translation", "reversal", "even pan", "even way"]
EVENTS = ["pause", "gap", "cut", "outliers"]

doubles = np.ctypeslib.ndpointer(dtype=np.float64, flags="C")
pointer = ctypes.c_void_p
library.v_last_error.restype = library.v_last_warning.restype = ctypes.c_char_p
library.v_path_fit_poses.argtypes = [doubles, doubles, ctypes.c_size_t, ctypes.c_char_p, pointer]
library.v_path_poses_at.argtypes = [pointer, doubles, ctypes.c_size_t, doubles]
library.v_path_point_count.argtypes = library.v_path_frame_count.argtypes = [pointer, pointer]
library.v_path_free.argtypes = [pointer]


class Path:
    """What the fit made: its number of points, its poses at the recording's times, its report."""

    def __init__(self, poses, seconds, fps, length, degrees, robust=False):
        made = ctypes.c_void_p()
        options = f"fps={float(fps)!r}\ntolerance={float(length)!r}\nangle={float(degrees)!r}\nrobust={'yes' if robust else 'no'}"
        status = library.v_path_fit_poses(poses, seconds, len(poses), options.encode(), ctypes.byref(made))
        if status:
            raise ValueError(library.v_last_error().decode())
        self.report = library.v_last_warning().decode()
        points, frames = ctypes.c_int(), ctypes.c_size_t()
        library.v_path_point_count(made, ctypes.byref(points))
        library.v_path_frame_count(made, ctypes.byref(frames))
        self.points = points.value
        at = np.minimum(1.0 + (seconds - seconds[0]) * fps, frames.value)
        self.poses = np.empty((len(at), 10))
        library.v_path_poses_at(made, at, len(at), self.poses)
        library.v_path_free(made)


def eased(u):
    return u * u * u * (10 + u * (6 * u - 15))


def waves(size, number, t):
    """Five slow sines, as different as their numbers."""
    k = np.arange(5)
    period, phase = 5.0 + 3.1 * k + 0.7 * number, 1.7 * number + 2.3 * k * k
    return size * np.mean(np.sin(2 * np.pi * np.divide.outer(t, period) + phase), axis=-1)


def flight(kind, t, span):
    """Places and views of the flight without noise."""
    nothing, u = 0 * t, t / span
    place = np.stack([waves(2.5, n, t) for n in (1, 2, 3)], axis=1)
    yaw, pitch = waves(1.2, 4, t), waves(0.3, 5, t)
    if kind == "line":
        place, yaw, pitch = np.outer(t, [0.3, 0.1, 0.0]), nothing + 0.4, nothing + 0.1
    elif kind == "rotation":
        place = nothing[:, None] + [1.0, 2.0, 3.0]
    elif kind == "translation":
        yaw, pitch = nothing + 0.4, nothing + 0.1
    elif kind == "reversal":
        place, yaw, pitch = np.outer(np.sin(0.5 * t), [2.0, 0.0, 0.0]), 0.05 * t, nothing
    elif kind == "even pan":
        place, yaw, pitch = np.outer(eased(u), [2.0, 0.0, 0.0]), 0.05 * t, nothing
    elif kind == "even way":
        place, yaw, pitch = np.outer(t, [0.3, 0.1, 0.0]), eased(u), nothing
    return place, Rotation.from_euler("YX", np.stack([yaw, pitch], axis=1))


def rows(place, turn):
    m = turn.as_matrix()
    return np.concatenate([place, m[:, :, 2], m[:, :, 1], np.full((len(place), 1), 30.0)], axis=1)


def turns(poses):
    view, up = poses[:, 3:6], poses[:, 6:9]
    return Rotation.from_matrix(np.stack([np.cross(up, view), up, view], axis=2))


class Recording:
    """A made one: `clean` and recorded poses, seconds, and what is known of it."""

    def __init__(self, number):
        random = np.random.default_rng(number)
        self.kind = FLIGHTS[number % len(FLIGHTS)]
        self.event = EVENTS[number // 2 % len(EVENTS)] if number % 2 else ""
        self.rate = rate = float(np.exp(random.uniform(np.log(10), np.log(1000))))
        self.span = next(span for most, span in SECONDS if rate <= most)
        self.fps = round(rate, 3) if rate >= 12 and number % 4 < 2 else 25.0
        jitter, drops = [(0, 0), (0.4, 0), (0.4, 0.1)][number % 3]
        steps = np.arange(int(self.span * rate) + 1)
        when = (steps + jitter * random.uniform(-0.5, 0.5, len(steps))) / rate
        stays = random.uniform(size=len(steps)) >= drops
        middle = 0.4 * self.span
        if self.event == "gap":
            stays &= (when < middle) | (when > middle + 0.5)
        stays[[0, -1]] = True
        self.seconds = when = np.ascontiguousarray(when[stays])
        moved = np.where(when > middle, np.maximum(when - 1.0, middle), when) if self.event == "pause" else when
        place, turn = flight(self.kind, moved, self.span)
        self.sides = [slice(None)]
        if self.event == "cut":
            place = place + np.outer(when >= middle, [5.0, 0.0, 0.0])
            self.sides = [slice(0, np.sum(when < middle)), slice(np.sum(when < middle), None)]
        self.clean = rows(place, turn)
        noise = random.standard_normal if number % 5 < 2 else lambda size: random.uniform(-1, 1, size)
        self.noise = ["none", "below", "below", "beyond"][random.integers(4)]
        most = {"none": 0.0, "below": random.uniform(0.2, 0.95), "beyond": random.uniform(1.5, 4.0)}[self.noise]
        self.kind_of_noise = "Gaussian" if number % 5 < 2 else "uniform"

        def off(tolerance):
            """Its greatest deviation is that share of the tolerance."""
            values = noise((len(when), 3))
            return values * (most * tolerance / np.linalg.norm(values, axis=1).max())

        place = place + off(LENGTH)
        turn = Rotation.from_rotvec(off(np.radians(DEGREES))) * turn
        self.good = np.ones(len(when), dtype=bool)
        if self.event == "cut":
            # The path crosses it in a frame, in which it can be on neither side.
            frames, at = (when - when[0]) * self.fps, self.sides[0].stop
            begin = np.floor(frames[at - 1])
            self.good = (frames <= begin) | (frames >= max(begin + 1, np.floor(frames[at])))
        if self.event == "outliers":
            self.good[np.arange(23, len(when) - 5, 97)] = False
            place[~self.good, 1] += 0.7
        self.poses = rows(place, turn)

    def fitted(self, share=1.0, poses=None):
        poses = self.poses if poses is None else poses
        robust = self.event == "outliers"
        return Path(poses, self.seconds, self.fps, share * LENGTH, share * DEGREES, robust)


def norm(parts):
    return np.sqrt(np.mean(np.sum(parts * parts, axis=1)))


def smoothed(recording, values, missed):
    """SciPy's spline that misses the values by so much, at their times."""
    good, t = recording.good, recording.seconds * recording.rate

    def spline(light):
        parts = []
        for side in recording.sides:
            use, at = t[side][good[side]], t[side]
            parts.append(make_smoothing_spline(use, values[side][good[side]], lam=np.exp(light))(at))
        return np.concatenate(parts)

    def much(light):
        return norm((spline(light) - values)[good]) - missed

    # Lighter or heavier nothing changes, or no system of SciPy's can be solved.
    low, high = -14.0, 20.0
    if much(low) >= 0:
        return spline(low)
    return spline(high) if much(high) <= 0 else spline(brentq(much, low, high, xtol=1e-3))


def beside_scipy(recording, path):
    """How many times SciPy's distance from the clean flight the path's is: places, views, knots."""
    good = recording.good
    found = []
    place, clean = path.poses[:, :3], recording.clean[:, :3]
    missed = norm((place - recording.poses[:, :3])[good])
    known = norm((smoothed(recording, recording.poses[:, :3], missed) - clean)[good])
    found.append(norm((place - clean)[good]) / max(known, NOTHING * LENGTH))
    turn, clean, recorded = (turns(poses) for poses in (path.poses, recording.clean, recording.poses))
    quaternions = recorded.as_quat()
    flips = np.sign(np.sum(quaternions[1:] * quaternions[:-1], axis=1))
    quaternions[1:] *= np.cumprod(flips)[:, None]

    def apart(a, b):
        return norm((a * b.inv()).as_rotvec()[good])

    nothing = NOTHING * np.radians(DEGREES)
    missed = 0.5 * apart(turn, recorded)
    known = Rotation.from_quat(smoothed(recording, quaternions, missed))
    off = apart(turn, clean)
    found.append(off / max(apart(known, clean), nothing))
    # As many knots as points, even in the list of poses.
    knots = np.unique(np.linspace(0, good.sum() - 1, max(path.points, 2)).round().astype(int))
    t = recording.seconds
    spline = RotationSpline(t[good][knots], recorded[good][knots])
    found.append(off / max(apart(spline(t), clean), nothing))
    return found


def better(report):
    """The options that a report names, by their names."""
    _, noise, helps = report.partition("Noise of about ")
    named = re.findall(r"(tolerance|angle) of ([-+.e\d]*\d)", helps) if noise else []
    return {name: float(value) for name, value in named}


class Faults(list):
    def demand(self, holds, what):
        if not holds:
            self.append(what)


def ladder(points, faults):
    """Points by tolerance: none of a greater one more than 1.1 times as many plus one."""
    for a, few in points.items():
        for b, many in points.items():
            faults.demand(a >= b or many.points <= 1.1 * few.points + 1,
                          f"{few.points} points with {a:g} tolerances, {many.points} with {b:g}")


def made(number):
    """What there is to say of one made recording."""
    recording, faults = Recording(number), Faults()
    name = (f"{number}: {recording.kind}{' ' if recording.event else ''}{recording.event}, {recording.rate:.0f} Hz, "
            f"noise {recording.noise} {recording.kind_of_noise}, {recording.fps:g} fps")
    try:
        path = recording.fitted()
        points = {1.0: path, **{share: recording.fitted(share) for share in LADDER}}
        clean = recording.fitted(poses=recording.clean).points
        poses, many = len(recording.poses), path.points
        faults.demand(max(path.points for path in points.values()) <= poses, "more points than poses")
        ladder(points, faults)
        if recording.noise == "below":
            faults.demand(many <= 2 * clean, f"{many} points, {clean} without noise")
        if recording.kind.startswith("even") and not recording.event and recording.noise == "none":
            faults.demand(4 * many <= poses, f"{many} points of {poses} poses")
        if recording.noise == "beyond" and 3 * many > poses and poses > 100:
            named = better(path.report)
            faults.demand(named, f"{many} points of {poses} poses, and no tolerance that helps")
            if named:
                again = Path(recording.poses, recording.seconds, recording.fps, named.get("tolerance", LENGTH),
                             named.get("angle", DEGREES), recording.event == "outliers")
                faults.demand(2 * again.points <= many, f"{many} points of {poses} poses, with {named} {again.points}")
        ratios = beside_scipy(recording, path)
        for what, ratio in zip(("places", "views", "views of RotationSpline"), ratios):
            demanded = what != "views of RotationSpline" or recording.noise != "none"
            faults.demand(not demanded or ratio <= 1.1, f"{ratio:.2f} times SciPy's {what}")
    except ValueError as error:
        return name, recording, 0, 0, 0, [np.nan] * 3, [f"refused: {error}"]
    return name, recording, len(recording.poses), many, clean, ratios, list(faults)


def of_others():
    """Recordings of evo's tests, by name: poses and seconds."""
    try:
        subprocess.run([sys.executable, "-m", "pip", "-q", "download", "--no-deps", "--no-binary", ":all:", "-d", folder, "evo"],
                       check=True, capture_output=True)
        archive = tarfile.open(sorted(folder.glob("evo-*.tar.gz"))[-1])
    except (subprocess.CalledProcessError, IndexError):
        print("evo's recordings were not tried: PyPI does not answer")
        return
    stamps = None
    for member in sorted(archive.getmembers(), key=lambda member: "_times" not in member.name):
        name = pathlib.Path(member.name).name
        if "/test/data/" not in member.name or not name.endswith((".txt", ".csv", ".tum")):
            continue
        text = archive.extractfile(member).read().decode().replace(",", " ")
        lines = [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]
        try:
            numbers = np.array(lines, dtype=float)
        except ValueError:
            continue
        if numbers.shape[1] == 1:
            stamps = numbers[:, 0]
        elif numbers.shape[1] == 12:
            m = numbers.reshape(-1, 3, 4)
            if stamps is not None and len(stamps) == len(m):
                yield name, rows(m[:, :, 3], Rotation.from_matrix(m[:, :, :3])), stamps
        elif numbers.shape[1] >= 8:
            order = [5, 6, 7, 4] if name.endswith(".csv") else [4, 5, 6, 7]
            yield name, rows(numbers[:, 1:4], Rotation.from_quat(numbers[:, order])), numbers[:, 0].copy()


def other(name, poses, seconds):
    faults = Faults()
    diagonal = np.linalg.norm(np.ptp(poses[:, :3], axis=0))
    began, points, step = time.process_time(), {}, np.median(np.diff(seconds))
    fps = 1 / step if 1 / 1000 < step < 1 / 12 else 25.0
    fps = 30.0 if step > 1e4 else fps
    for share in [1.0, *LADDER]:
        try:
            path = Path(poses, seconds, fps, share * 1e-3 * diagonal, share * DEGREES)
        except ValueError as error:
            return [f"refused: {error}"]
        points[share] = path
        faults.demand(path.points <= len(poses), f"{path.points} points of {len(poses)} poses")
    ladder(points, faults)
    print(f"{name}: {len(poses)} poses, points { {share: points[share].points for share in sorted(points)} }, {time.process_time() - began:.2f} s"
          f"{' FAULT ' + '; '.join(faults) if faults else ''}")
    return faults


def timed(poses, pipe):
    """A flight by hand with noise in a process of its own: seconds of the processor and memory."""
    t = np.arange(poses) / 30.0
    place, turn = flight("hand", t, t[-1])
    random = np.random.default_rng(poses)
    made = rows(place + 0.3 * LENGTH * random.uniform(-1, 1, place.shape), turn)
    del place, turn
    before, began = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
    path = Path(made, t, 30.0, LENGTH, DEGREES)
    pipe.send((path.points, time.process_time() - began, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, before))


def in_a_process(poses):
    """Points, seconds and memory of so many poses, and the memory before."""
    pipe, end = multiprocessing.Pipe()
    process = multiprocessing.Process(target=timed, args=(poses, end))
    process.start()
    found = pipe.recv()
    process.join()
    return found


def growth(most):
    faults = []
    for poses, seconds in ((3000, 0.5), (10000, 20.0), (100000, 20.0), (1000000, 300.0)):
        if poses > most:
            break
        points, took, memory, before = in_a_process(poses)
        slow = took > seconds or memory > 1e6
        print(f"{poses} poses: {points} points in {took:.2f} s, {memory / 1e3:.0f} MB ({before / 1e3:.0f} before)"
              f"{' FAULT' if slow else ''}")
        faults += [poses] * slow
    return faults


def draw(file):
    """Seconds by the number of poses: linear is as steep as the grey lines."""
    x = lambda poses: 70 + 150 * (np.log10(poses) - 3)
    y = lambda seconds: 250 - 45 * (np.log10(seconds) + 2)
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 560 310" font-family="sans-serif" font-size="13">',
             '<rect width="560" height="310" fill="#fff"/>']
    for k, name in enumerate(("10 ms", "100 ms", "1 s", "10 s", "100 s")):
        parts.append(f'<text x="62" y="{y(10.0 ** (k - 2)) + 4:.0f}" text-anchor="end">{name}</text>'
                     f'<path d="M70 {y(10.0 ** (k - 2)):.0f}H520" stroke="#eee"/>')
    for k in (-5.5, -4.5, -3.5):
        parts.append(f'<path d="M{x(1e3):.0f} {y(10.0 ** (k + 3)):.1f}L{x(1e6):.0f} {y(10.0 ** (k + 6)):.1f}" stroke="#ccc"/>')
    measured = [(10 ** k, in_a_process(10 ** k)) for k in range(3, 7)]
    for poses, (points, took, memory, before) in measured:
        print(f"{poses} poses: {points} points in {took:.2f} s, {memory / 1e3:.0f} MB ({before / 1e3:.0f} before)")
        parts.append(f'<text x="{x(poses):.0f}" y="272" text-anchor="middle">{poses:,}</text>'
                     f'<circle cx="{x(poses):.0f}" cy="{y(took):.1f}" r="3" fill="#1f6fb2"/>')
    line = " ".join(f"{x(poses):.0f},{y(took):.1f}" for poses, (_, took, *_) in measured)
    parts.append(f'<polyline points="{line}" fill="none" stroke="#1f6fb2" stroke-width="2"/>')
    parts.append('<text x="295" y="298" text-anchor="middle">poses</text>')
    file.write_text("\n".join([*parts, "</svg>"]) + "\n")


def table(results):
    print("| kind | recordings | poses | points | without noise | places | views | RotationSpline |")
    print("|---|---|---|---|---|---|---|---|")
    def row(title, chosen):
        if not chosen:
            return
        ratios = np.nanmax([ratios for *_, ratios, _ in chosen], axis=0)
        poses, points, clean = (sum(result[k] for result in chosen) for k in (2, 3, 4))
        print(f"| {title} | {len(chosen)} | {poses} | {points} | {clean} | "
              f"{' | '.join(f'{ratio:.2f}' for ratio in ratios)} |")
    for noise in ("none", "below", "beyond"):
        row(f"noise {noise}", [result for result in results if result[1].noise == noise])
    for kind in FLIGHTS:
        row(kind, [result for result in results if result[1].kind == kind and result[1].noise != "beyond"])
    for event in EVENTS:
        row(event, [result for result in results if result[1].event == event and result[1].noise != "beyond"])


if __name__ == "__main__":
    if folder.suffix == ".svg":
        draw(folder)
        sys.exit()
    results, faults = [], 0
    for number in range(count):
        results.append(result := made(number))
        if result[-1]:
            faults += 1
            print(f"{result[0]}, {result[2]} poses, {result[3]} points, {result[4]} clean: {'; '.join(result[-1])}", flush=True)
    table(results)
    for name, poses, seconds in of_others():
        faults += bool(other(name, poses, seconds))
    faults += len(growth(1000000 if count >= 300 else 100000))
    print(f"{count} recordings made, {faults} faults")
    sys.exit(int(faults > 0))
