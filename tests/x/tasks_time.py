"""Six more tasks, each in a window with a flight of its own: pace and keys in time, a length that is
kept, points between windows, a clearance, an object without a path."""

import os
import subprocess

from hands import distance, looks_at, window_for
from harness import check
from panel import BUTTON, graph, rail_of

OBJECT = """v -0.4 0 -0.4
v 0.4 0 -0.4
v 0.4 0 0.4
v -0.4 0 0.4
v 0 0.5 0
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
"""
TOP = (0.0, 0.5, 0.0)
CENTRE, HALF = (0.0, 0.25, 0.0), 0.44
"""The space around it, in which a new path lies."""
PLACES = [(-0.6, 0.2, 0.8), (-0.85, 0.3, 0.1), (-0.7, 0.35, -0.65),
          (0.75, 0.35, -0.65), (0.85, 0.3, 0.1), (0.6, 0.2, 0.8)]
"""In half sizes of that space."""
NEAR = (-0.23, 0.18, -0.34)
"""A place from which the way on leads through a face."""

FPS = 25


def flight(file, places):
    """Writes a flight by way of such places, all looking at the top; gives the file."""
    with open(file, "w", encoding="ascii") as out:
        print("version = 1\n[space]", file=out)
        print(f"centre = {list(CENTRE)}\nhalf_size = {HALF}", file=out)
        lines = [line.split() for line in OBJECT.splitlines()]
        corners = [[float(word) for word in words] for kind, *words in lines if kind == "v"]
        faces = [[int(word) - 1 for word in words] for kind, *words in lines if kind == "f"]
        print(f"[object]\npoints = {corners}\ntriangles = {faces}", file=out)
        for flat in places:
            place = [CENTRE[k] + HALF * flat[k] for k in range(3)]
            print(f"[[point]]\nposition = {place}\n[[point.orientation]]\ntarget = {list(TOP)}",
                  file=out)
    return file


def key_frames(hand):
    """The frames at which the points of the file are reached, from 0, and how many there are."""
    poses, found = hand.poses(), []
    for place in PLACES:
        at = [CENTRE[k] + HALF * place[k] for k in range(3)]
        found.append(min(range(len(poses)), key=lambda frame, at=at: distance(poses[frame], at)))
    return found, len(poses)


def in_row(hand, frame, count):
    """Where a frame, from 0, is seen in the row of keys."""
    hand.away()
    left, right, _ = hand.server.seen(hand.window, rail_of, "the rail")
    height = hand.server.geometry(hand.window)[3]
    return left + (right - left) * frame / (count - 1), height - 4 - graph(height) - 12


def spot(place):
    """A place as a box to be clicked."""
    return (*map(round, place), 0, 0)


def in_list(hand, point):
    """Where a point is seen in the list, from 0."""
    return spot((70, 84 + 22 * point))


def slow(hand):
    """The flight slows down at a point without a jerk."""
    before = hand.poses()
    frames, count = key_frames(hand)
    hand.click(spot(in_row(hand, sum(frames[3:5]) / 2, count)))
    x, row = in_row(hand, frames[3], count)
    # From the speed 50, in the middle of the graph, to about 10, for both sections that meet there.
    hand.slide((x, row + 68), (x, row + 98))
    after = hand.saved()
    slows(hand, before, after)


def slows(hand, before, after):
    """Fails unless the way of each frame goes down at the point, little by little."""
    at = key_frames(hand)[0][3]
    old, new = ([distance(a, b) for a, b in zip(poses, poses[1:])] for poses in (before, after))
    there, usual = max(new[at - 2:at + 2]), sum(old) / len(old)
    check(there < 0.5 * usual, f"{there} at the point, {usual} before")
    jerk = max(abs(b - a) for a, b in zip(new, new[1:]))
    check(jerk < 0.15 * usual, f"the speed jumps by {jerk} of {usual}")


def key(hand):
    """A key comes two seconds later, and the end stays."""
    frames, count = key_frames(hand)
    start = in_row(hand, frames[2], count)
    hand.slide(start, in_row(hand, frames[2] + 2 * FPS, count))
    hand.saved()
    later, whole = key_frames(hand)
    check(whole == count, f"{whole} frames, not {count}")
    check(later[2] == frames[2] + 2 * FPS, f"from frame {frames[2]} to {later[2]}")
    stay = [at for at in range(6) if at != 2]
    check(all(later[at] == frames[at] for at in stay), f"{frames} -> {later}")


def view(hand):
    """A view is added to 12 seconds, which stay."""
    hand.number(hand.bar(3), 12)
    hand.keys("alt+Insert")
    poses = hand.saved()
    check(len(poses) == 12 * FPS, f"{len(poses)} poses")
    with open(hand.file, encoding="utf-8") as file:
        views = file.read().count("[[point.orientation]]")
    check(views == 7, f"{views} views")


def copy(hand, other):
    """Five points are copied to another window."""
    hand.server.focus(hand.window)
    hand.held("shift", in_list(hand, 4))
    hand.keys("ctrl+c")
    hand.server.focus(other.window)
    other.click(in_list(other, 0))
    other.keys("ctrl+v")
    hand.actions += other.actions
    poses = other.saved()
    for flat in PLACES[:5]:
        place = [CENTRE[k] + HALF * flat[k] for k in range(3)]
        check(min(distance(pose, place) for pose in poses) < 1e-6, f"no point at {place}")


def cure(hand):
    """A way through an object is found, and led around it."""
    check(findings(hand), "the flight is clear from the beginning")
    hand.keys("F8")
    hand.click(hand.panel(BUTTON, 0, -1))
    hand.saved()
    left = findings(hand)
    check(not left, left)


def findings(hand):
    """What a check of the file says of the object."""
    told = subprocess.run([hand.vides, "check", hand.file], capture_output=True, text=True)
    return [line for line in told.stdout.splitlines() if "clearance  " in line or "through  " in line]


def orbit(hand):
    """From an empty window and the file of an object to an orbit around it."""
    server, window = hand.server, hand.window
    hand.keys("ctrl+o")
    hand.first_file()
    hand.click(hand.way(0))
    server.drawn(window)
    hand.keys("Return")
    hand.save_first()
    around(hand.poses())


def around(poses):
    """Fails unless the poses go around the object and look at it."""
    quarters = {(pose[0] > CENTRE[0], pose[2] > CENTRE[2]) for pose in poses}
    check(len(quarters) == 4, f"only {quarters}")
    worst = max(looks_at(pose, CENTRE) for pose in poses)
    check(worst < 25, f"a view {worst:.1f} degrees beside it")
