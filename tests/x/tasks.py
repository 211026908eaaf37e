"""What a new user does in an hour, played by mouse and keyboard in `vides edit`; each
task with a picture, its number of actions, and a look at the file that came of it:
tasks.py VIDES FOLDER MESH

An action is a click, a drag, a key with what is held, or a number typed with Enter.
"""

import contextlib
import math
import os
import shutil
import subprocess
import sys

import tasks_time
from hands import Hand, distance, looks_at, window_for
from harness import Failure, Program, check, wait
from panel import BUTTON, FIELD, PANEL, middle, panel_boxes
from space import first_look
from tasks_time import CENTRE, HALF, OBJECT, PLACES, TOP, flight, in_list, in_row, key_frames

def points(hand):
    """Six points around a loaded object, all looking at its top."""
    space = hand.server.seen(hand.window, first_look, "the space")
    hand.keys("ctrl+i", "4")
    for number in range(1, 5):
        begin = [PLACES[0][k] + (PLACES[5][k] - PLACES[0][k]) * number / 5 for k in range(3)]
        goal = PLACES[number]
        along = (goal[0], begin[1], goal[2])
        hand.drag(space.image(begin), space.image(along), 2)
        hand.drag(space.image(along), space.image(goal), 3)
    hand.away()
    # Over the top, which lights up, the key aims all there.
    top = [(TOP[k] - CENTRE[k]) / HALF for k in range(3)]
    x, y = map(round, space.image(top))
    hand.server.xdotool("mousemove", "--window", hand.window, x, y)
    hand.server.drawn(hand.window)
    hand.keys("F7")
    hand.save_first()
    poses = hand.poses()
    for flat in PLACES:
        place = [CENTRE[k] + HALF * flat[k] for k in range(3)]
        nearest = min(poses, key=lambda pose, place=place: math.dist(pose[:3], place))
        check(math.dist(nearest[:3], place) < 0.02, f"no point at {place}")
    worst = max(looks_at(pose, TOP) for pose in poses)
    check(worst < 1.0, f"a view {worst:.2f}° beside the top")


def look(hand):
    """The camera stops at the third point and looks elsewhere."""
    before = len(hand.poses())
    frames, count = key_frames(hand)
    # A copy of a key beside itself is a rest.
    ends = (in_row(hand, frame, count) for frame in (frames[2], frames[2] + 20))
    hand.slide(*ends, key="ctrl")
    hand.keys("alt+Insert")
    hand.number(hand.panel(FIELD, 3, 0), -0.4)
    poses = hand.saved()
    check(len(poses) > before, "no frames for the look")
    rests = sum(distance(a, b) < 1e-9 for a, b in zip(poses, poses[1:]))
    check(rests > 12, f"{rests} frames of rest")
    still = sum(a == b for a, b in zip(poses, poses[1:]))
    check(still >= 12, f"{still} frames of rest without a turn")


def slow_start(hand):
    """The flight begins slowly."""
    before = hand.poses()
    # A right click on the first section in the row of keys; the second entry above it.
    x, y = in_row(hand, 0, 2)
    x += 20
    hand.click((x, y, 0, 0), 3)
    hand.server.drawn(hand.window)
    hand.click((x + 30, y - 110, 0, 0))
    poses = hand.saved()
    check(distance(*poses[:2]) < 0.1 * distance(*before[:2]), "the start is not slow")


def zoom(hand):
    """At the end the camera has zoomed in."""
    hand.keys("ctrl+Page_Up")
    hand.number(hand.panel(FIELD, -2, 0), 48)
    poses = hand.saved()
    check(poses[-1][9] == 48 and poses[0][9] == 24, f"zoom {poses[0][9]}, {poses[-1][9]}")


def play(hand):
    """The flight is played."""
    before = hand.server.drawn(hand.window)
    hand.keys("F5")
    wait(lambda: hand.server.picture(hand.window).differs(before), "a moving picture")
    hand.server.press(hand.window, "F5")


def camera(hand):
    """The camera's picture beside the space, and back."""
    before = hand.server.drawn(hand.window)
    hand.server.focus(hand.window)
    hand.keys("b")
    wait(lambda: hand.server.picture(hand.window).differs(before), "the large picture")


def save(hand):
    """What was done stands in the file."""
    before = os.stat(hand.file).st_mtime_ns
    hand.keys("ctrl+s")
    wait(lambda: os.stat(hand.file).st_mtime_ns != before, "the path to be saved")


def poses(hand):
    """All poses as CSV."""
    file = os.path.join(hand.folder, "poses.csv")
    hand.keys("ctrl+e")
    hand.server.xdotool("key", "--delay", "20", "ctrl+a")
    hand.typed(file)
    wait(lambda: os.path.exists(file), "the poses")
    with open(file, encoding="ascii") as lines:
        count = sum(not line.startswith("#") for line in lines) - 1
    check(count == len(hand.poses()), f"{count} poses")


def undo(hand):
    """A point is deleted, is there again, is gone, is there."""
    whole = hand.poses()
    hand.server.press(hand.window, "ctrl+Page_Down", "ctrl+Page_Down", "Delete")
    check(hand.saved() != whole, "nothing was deleted")
    hand.keys("ctrl+z")
    check(hand.saved() == whole, "undo is not exact")
    hand.keys("ctrl+y")
    check(hand.saved() != whole, "nothing was done again")
    hand.server.press(hand.window, "ctrl+z")
    check(hand.saved() == whole, "undo is not exact")


def closed(hand):
    """The path is closed: its last pose is beside the first."""
    before = hand.poses()
    hand.keys("ctrl+l")
    poses = hand.saved()
    step = max(distance(a, b) for a, b in zip(poses, poses[1:]))
    check(distance(poses[-1], poses[0]) <= step * 1.001, "it is open")
    hand.server.press(hand.window, "ctrl+l")
    check(hand.saved() == before, "opened it is not what it was")


def insert(hand):
    """A point in the middle of a way, and the flight stays as it is."""
    before = hand.poses()
    hand.keys("Insert")
    after = hand.saved()
    check(len(after) == len(before), f"{len(after)} frames, not {len(before)}")
    worst = max(map(distance, before, after))
    check(worst < 1e-6, f"{worst} beside the path")
    turned = max(sum(a[3 + k] * b[3 + k] for k in range(3)) < math.cos(math.radians(0.1))
                 for a, b in zip(before, after))
    check(not turned, "a view was turned")


def copy(hand):
    """A view is copied to another point."""
    counted = hand.actions
    hand.number(hand.panel(FIELD, 4, 0), 7)
    hand.actions = counted
    hand.keys("ctrl+c", "ctrl+Page_Down", "ctrl+v")
    hand.saved()
    with open(hand.file, encoding="utf-8") as file:
        rolls = file.read().count("roll_degrees = 7.0")
    check(rolls == 2, f"{rolls} views are rolled")


def seconds(hand):
    """Exactly 12 seconds at 30 frames a second."""
    hand.number(hand.bar(4), 30)
    hand.number(hand.bar(3), 12)
    poses = hand.saved()
    check(len(poses) == 12 * 30, f"{len(poses)} poses")


def ahead(hand):
    """The camera looks along its way."""
    hand.click(hand.panel(BUTTON, 0, -1))
    hand.saved()
    with open(hand.file, encoding="utf-8") as file:
        check("ahead" in file.read(), "nothing looks ahead")


def move(hand):
    """The whole path is moved."""
    before = hand.poses()
    hand.server.click(hand.window, *in_list(hand, 0)[:2])
    hand.keys("ctrl+a")
    # What is changed of one is changed of all.
    hand.number(hand.panel(FIELD, 0, 0), CENTRE[0] + HALF * PLACES[0][0] + 0.05)
    after = hand.saved()
    for a, b in zip(before, after):
        check(math.dist((a[0] + 0.05, a[1], a[2]), b[:3]) < 1e-6, f"{a[:3]} -> {b[:3]}")


TASKS = ((points, 12, 11), (look, 4, 3), (slow_start, 3, 2), (zoom, 2, 2), (play, 1, 1),
         (camera, 1, 1), (save, 1, 1), (poses, 3, 2), (undo, 2, 2), (closed, 2, 1), (insert, 1, 1),
         (copy, 3, 3), (seconds, 2, 2), (ahead, 1, 1), (move, 2, 2))
"""With the actions in the window before the desk, by its shortest way, and in this one."""

OTHERS = ((tasks_time.slow, 4, 2), (tasks_time.key, 1, 1), (tasks_time.view, 3, 2),
          (tasks_time.copy, 4, 4), (tasks_time.cure, 3, 2), (tasks_time.orbit, 6, 4))


def tour(hand):
    """From the file of an object to a flight of 30 seconds around it, by mouse alone."""
    server, window = hand.server, hand.window

    def panel(colour, row):
        # Not still: a flight is shown.
        def found():
            rows = panel_boxes(server.picture(window), colour)
            return rows[row][-1] if len(rows) > max(row, 0) else None

        return wait(found, f"row {row} of the panels")

    def words():
        # What the tool's panel says of the flight, above its fields.
        return [row[-4 * PANEL:] for row in server.picture(window).rows[60:106]]

    moved = []

    def flies():
        # The playhead moves on, and the words stay.
        picture = server.picture(window)
        now = words(), picture.rows[picture.height - 60:]
        if moved and moved[-1][0] != now[0]:
            moved.clear()
        if not moved or moved[-1][1] != now[1]:
            moved.append(now)
        return len(moved) > 3

    hand.click(hand.way(3))
    hand.first_file()
    wait(flies, "a tour", 120)
    server.picture().save(os.path.join(hand.folder, "tour-60.png"))
    before = words()
    moved.clear()
    x, y = middle(panel(FIELD, 0))
    # A twentieth of a second for each pixel, the first that are moved but lift the number.
    hand.slide((x, y), (x - 625, y), steps=25)
    wait(lambda: words() != before and flies(), "a tour of another length", 120)
    server.picture().save(os.path.join(hand.folder, "tour-30.png"))
    hand.click(panel(BUTTON, -1))
    check(hand.actions <= 5, f"{hand.actions} actions")
    server.press(window, "F5")
    hand.save_first()
    count = len(hand.poses())
    check(abs(count - 30 * 25) <= 40, f"{count} poses")
    told = subprocess.run([hand.vides, "--trust", "check", hand.file], capture_output=True, text=True)
    check(told.returncode == 0, f"{told.stdout}{told.stderr}")


def by_mouse(vides, folder, mesh):
    """The tour, in a window that begins with nothing."""
    with window_for(vides, folder, beside=[mesh]) as hand:
        hand.file = os.path.join(folder, "tour.vid")
        tour(hand)
        print(f"  tour-30.png: {hand.actions} actions. {tour.__doc__}", flush=True)


def done(hand, number, task, most):
    """What a task has come to: its picture, and whether it took no more actions than it should."""
    hand.away()
    hand.server.drawn(hand.window)
    name = f"{number}-{task.__name__}.png"
    hand.server.picture().save(os.path.join(hand.folder, name))
    print(f"  {name}: {hand.actions} actions. {task.__doc__}", flush=True)
    check(hand.actions <= most, f"{task.__name__}: {hand.actions} actions, not {most}")


def tasks(vides, folder, shape):
    """All of a flight that is begun and finished."""
    with window_for(vides, folder, "--object", shape) as hand:
        for number, (task, _, most) in enumerate(TASKS, 1):
            hand.actions = 0
            task(hand)
            done(hand, number, task, most)
            if task is camera:
                hand.server.press(hand.window, "b")


def others(vides, folder, shape):
    """The others, each in a window of its own."""
    for number, (task, _, most) in enumerate(OTHERS, len(TASKS) + 1):
        empty = task is tasks_time.orbit
        places = list(PLACES)
        if task is tasks_time.cure:
            places[2] = tasks_time.NEAR
        file = os.path.join(folder, f"{task.__name__}.vid")
        opened = [] if empty else [flight(file, places)]
        with window_for(vides, folder, *opened, beside=[shape]) as hand:
            hand.file = file
            with contextlib.ExitStack() as stack:
                more = []
                if task is tasks_time.copy:
                    more = [stack.enter_context(beside(hand))]
                task(hand, *more)
                done(hand, number, task, most)


@contextlib.contextmanager
def beside(hand):
    """Hands at another window with a path of two points, beside the first."""
    file = flight(os.path.join(hand.folder, "other.vid"), PLACES[:2])
    program = Program(hand.folder, [hand.vides, "edit", file], hand.server.env)
    try:
        other = Hand(hand.server, hand.server.new_window(hand.window), hand.folder, hand.vides)
        other.file = file
        yield other
    finally:
        program.kill()


def table():
    """The actions of each task, and how many take fewer."""
    rows = TASKS + OTHERS
    for task, before, after in rows:
        print(f"  {task.__doc__} {before}, now {after}")
        check(after <= before, f"{task.__name__} takes more actions than before")
    fewer = sum(after < before for _, before, after in rows)
    print(f"  {fewer} of {len(rows)} tasks take fewer actions than before.")


if __name__ == "__main__":
    try:
        vides, folder, mesh = map(os.path.abspath, sys.argv[1:4])
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        shape = os.path.join(folder, "pyramid.obj")
        with open(shape, "w", encoding="ascii") as out:
            out.write(OBJECT)
        by_mouse(vides, folder, mesh)
        tasks(vides, folder, shape)
        others(vides, folder, shape)
        table()
    except Failure as failure:
        sys.exit(f"tasks: {failure}")
