"""What a new user does in an hour, played by mouse and keyboard in `vides edit`; each
task with a picture, its number of actions, and a look at the file that came of it:
tasks.py VIDES FOLDER MESH

An action is a click, a drag, a key with what is held, or a number typed with Enter.
"""

import contextlib
import csv
import io
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time

from harness import Failure, Program, Server, check, wait
from panel import BUTTON, FIELD, PANEL, boxes, graph, middle, panel_boxes, rail_of, timeline
from space import first_look

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

class Hand:
    """Hands that count."""

    def __init__(self, server, window, folder, vides):
        self.server, self.window = server, window
        self.folder, self.vides = folder, vides
        self.actions = 0
        self.file = os.path.join(folder, "flight.vid")

    def keys(self, *keys):
        """Presses keys, each an action."""
        self.actions += len(keys)
        self.server.press(self.window, *keys)

    def click(self, box, button=1):
        """Clicks what was found."""
        self.actions += 1
        self.server.click(self.window, *middle(box), button)

    def drag(self, start, end, button):
        """Drags from place to place."""
        self.actions += 1
        self.server.drag(self.window, start, end, button)

    def number(self, box, value):
        """Types a number into a field."""
        self.server.click(self.window, *middle(box))
        self.server.xdotool("key", "--delay", "20", "ctrl+a")
        self.typed(value)

    def typed(self, text):
        """Types a text with Enter."""
        self.actions += 1
        self.server.type(str(text))
        self.server.xdotool("key", "Return")

    def away(self):
        """The pointer where it covers and lights nothing."""
        width, _ = self.server.geometry(self.window)[2:]
        self.server.xdotool("mousemove", "--window", self.window, width - PANEL - 90, 20)

    def panel(self, colour):
        """Buttons or fields in the panels, as rows from the top."""
        self.away()
        return panel_boxes(self.server.drawn(self.window), colour)

    def bar(self):
        """Fields above the timeline: frame, last frame, second, duration, rate."""
        self.away()
        picture = self.server.drawn(self.window)
        top = picture.height - timeline(picture.height)
        return boxes(picture, FIELD, 0, top, picture.width, top + 32)[0]

    def saved(self):
        """Saves, and gives the poses; does not count."""
        before = os.stat(self.file).st_mtime_ns
        self.server.press(self.window, "ctrl+s")
        wait(lambda: os.stat(self.file).st_mtime_ns != before, "the path to be saved")
        return self.poses()

    def poses(self):
        """The poses of the file, each a list of ten numbers."""
        text = subprocess.run([self.vides, "sample", self.file, "--format", "csv"],
                              check=True, capture_output=True, text=True).stdout
        rows = list(csv.DictReader(line for line in io.StringIO(text)
                                   if not line.startswith("#")))
        names = [name for name in rows[0] if name not in ("frame", "seconds", "time")]
        return [[float(row[name]) for name in names] for row in rows]


def distance(a, b):
    """Of two places."""
    return math.dist(a[:3], b[:3])


def looks_at(pose, target):
    """The angle between the view and the way to a target, in degrees."""
    way = [target[k] - pose[k] for k in range(3)]
    length = math.hypot(*way)
    cosine = sum(way[k] * pose[3 + k] for k in range(3)) / length
    return math.degrees(math.acos(min(1.0, cosine)))


def points(hand):
    """Six points around a loaded object, all looking at its top."""
    space = first_look(hand.server.drawn(hand.window))
    hand.keys("ctrl+i", "4")
    for number in range(1, 5):
        begin = [PLACES[0][k] + (PLACES[5][k] - PLACES[0][k]) * number / 5 for k in range(3)]
        goal = PLACES[number]
        along = (goal[0], begin[1], goal[2])
        hand.drag(space.image(begin), space.image(along), 2)
        hand.drag(space.image(along), space.image(goal), 3)
    hand.away()
    # A right click on the top; the second entry aims all.
    top = [(TOP[k] - CENTRE[k]) / HALF for k in range(3)]
    x, y = map(round, space.image(top))
    hand.click((x, y, 0, 0), 3)
    hand.server.drawn(hand.window)
    hand.click((x + 60, y + 42, 0, 0))
    hand.server.press(hand.window, "ctrl+s")
    hand.server.xdotool("key", "--delay", "20", "ctrl+a")
    hand.server.type(hand.file)
    hand.server.xdotool("key", "Return")
    wait(lambda: os.path.exists(hand.file), "the path")
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
    hand.keys("ctrl+Page_Up", "ctrl+Page_Up", "alt+Insert")
    hand.number(hand.panel(FIELD)[3][0], -0.4)
    hand.number(hand.panel(FIELD)[-1][0], 12)
    poses = hand.saved()
    check(len(poses) > before, "no frames for the look")
    rests = sum(distance(a, b) < 1e-9 for a, b in zip(poses, poses[1:]))
    check(rests > 12, f"{rests} frames of rest")


def slow_start(hand):
    """The flight begins slowly."""
    before = hand.poses()
    hand.away()
    picture = hand.server.drawn(hand.window)
    # A right click on the first section in the row of keys; the second entry above it.
    x, y = rail_of(picture)[0] + 20, picture.height - 4 - graph(picture.height) - 12
    hand.click((x, y, 0, 0), 3)
    hand.server.drawn(hand.window)
    hand.click((x + 30, y - 110, 0, 0))
    poses = hand.saved()
    check(distance(*poses[:2]) < 0.1 * distance(*before[:2]), "the start is not slow")


def zoom(hand):
    """At the end the camera has zoomed in."""
    hand.keys("ctrl+Page_Up")
    hand.number(hand.panel(FIELD)[-2][0], 48)
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
    hand.keys("alt+a", "d")
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
    hand.keys("alt+b", "g")
    poses = hand.saved()
    step = max(distance(a, b) for a, b in zip(poses, poses[1:]))
    check(distance(poses[-1], poses[0]) <= step * 1.001, "it is open")
    hand.server.press(hand.window, "alt+b", "g")
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
    hand.number(hand.panel(FIELD)[4][0], 7)
    hand.actions = counted
    hand.keys("ctrl+c", "ctrl+Page_Down", "ctrl+v")
    hand.saved()
    with open(hand.file, encoding="utf-8") as file:
        rolls = file.read().count("roll_degrees = 7.0")
    check(rolls == 2, f"{rolls} views are rolled")


def seconds(hand):
    """Exactly 12 seconds at 30 frames a second."""
    hand.number(hand.bar()[4], 30)
    hand.number(hand.bar()[3], 12)
    poses = hand.saved()
    check(len(poses) == 12 * 30, f"{len(poses)} poses")


def ahead(hand):
    """The camera looks along its way."""
    hand.click(hand.panel(BUTTON)[0][-1])
    hand.saved()
    with open(hand.file, encoding="utf-8") as file:
        check("ahead" in file.read(), "nothing looks ahead")


def move(hand):
    """The whole path is moved."""
    before = hand.poses()
    hand.server.focus(hand.window)
    hand.keys("ctrl+a", "m", "x")
    hand.typed(0.05)
    after = hand.saved()
    for a, b in zip(before, after):
        check(math.dist((a[0] + 0.05, a[1], a[2]), b[:3]) < 1e-6, f"{a[:3]} -> {b[:3]}")


TASKS = (points, look, slow_start, zoom, play, camera, save, poses, undo, closed, insert,
         copy, seconds, ahead, move)


def pause(words):
    """A drag's words with a frame's time before each of them."""
    slow = []
    for word in words:
        slow += ["sleep", "0.05"] * (word in ("mousemove", "mouseup")) + [word]
    return slow


def tour(hand):
    """From the file of an object to a flight of 30 seconds around it, by mouse alone."""
    server, window = hand.server, hand.window

    def panel(colour, row):
        picture = server.picture(window)
        found = panel_boxes(picture, colour)
        return found[row][-1] if len(found) > max(row, 0) else None

    def words():
        # What the tool's panel says of the flight, above its fields.
        return [row[-4 * PANEL:] for row in server.picture(window).rows[60:106]]

    def flies():
        # The playhead moves, and the words stay.
        def now():
            picture = server.picture(window)
            return words(), picture.rows[picture.height - 60:]

        seen = [now()]
        for _ in range(3):
            time.sleep(0.3)
            seen.append(now())
        return (seen[0][0] == seen[-1][0]
                and all(a[1] != b[1] for a, b in zip(seen, seen[1:])))

    picture = server.drawn(window)
    bottom = picture.height - timeline(picture.height)
    ways = boxes(picture, BUTTON, 160, bottom - 90, picture.width - PANEL, bottom, (80, 50))
    hand.click(ways[-1][3])
    server.drawn(window)
    # The list is the largest field, the object its first row.
    picture = server.drawn(window)
    fields = boxes(picture, FIELD, 300, 150, picture.width - 300, bottom, (300, 200))
    x, y = fields[0][0][:2]
    hand.actions += 1
    server.xdotool("mousemove", "--window", window, x + 40, y + 16,
                   "click", "--repeat", 2, "--delay", 80, 1)
    wait(flies, "a tour", 120)
    server.picture().save(os.path.join(hand.folder, "tour-60.png"))
    before = words()
    x, y = middle(panel(FIELD, 0))
    # A twentieth of a second for each pixel, the first that are moved but lift the number.
    hand.actions += 1
    words_of_drag = server.drag_words(window, (x, y), (x - 625, y), 1, 25)
    server.xdotool(*pause(words_of_drag))
    wait(lambda: words() != before and flies(), "a tour of another length", 120)
    server.picture().save(os.path.join(hand.folder, "tour-30.png"))
    hand.click(panel(BUTTON, -1))
    check(hand.actions <= 5, f"{hand.actions} actions")
    server.press(window, "F5", "ctrl+s")
    server.drawn(window)
    server.xdotool("key", "--delay", "20", "ctrl+a")
    server.type(hand.file)
    server.xdotool("key", "Return")
    wait(lambda: os.path.exists(hand.file), "the path")
    count = len(hand.poses())
    check(abs(count - 30 * 25) <= 40, f"{count} poses")
    told = subprocess.run([hand.vides, "check", hand.file], capture_output=True, text=True)
    check(told.returncode == 0, f"{told.stdout}{told.stderr}")


@contextlib.contextmanager
def window_for(vides, folder, *arguments, beside=()):
    """Hands at a window of its own, which begins in a folder with copies of these files alone."""
    with tempfile.TemporaryDirectory(prefix="vides-tasks-") as work:
        server = Server(work, screen="1300x900x24")
        server.env["LC_ALL"] = "C.UTF-8"
        place = os.path.join(work, "beside")
        os.makedirs(place)
        for file in beside:
            shutil.copy(file, place)
        program = Program(place, [vides, "edit", *arguments], server.env)
        try:
            yield Hand(server, server.new_window(), folder, vides)
        except (Failure, IndexError):
            server.picture().save(os.path.join(folder, "failed.png"))
            raise
        finally:
            program.kill()
            server.end()


def by_mouse(vides, folder, mesh):
    """The tour, in a window that begins with nothing."""
    with window_for(vides, folder, beside=[mesh]) as hand:
        hand.file = os.path.join(folder, "tour.vid")
        tour(hand)
        print(f"  tour-30.png: {hand.actions} actions. {tour.__doc__}", flush=True)


def tasks(vides, folder):
    """All of them."""
    shape = os.path.join(folder, "pyramid.obj")
    with open(shape, "w", encoding="ascii") as out:
        out.write(OBJECT)
    with window_for(vides, folder, "--object", shape) as hand:
        for number, task in enumerate(TASKS, 1):
            hand.actions = 0
            task(hand)
            hand.away()
            hand.server.drawn(hand.window)
            name = f"{number}-{task.__name__}.png"
            hand.server.picture().save(os.path.join(folder, name))
            print(f"  {name}: {hand.actions} actions. {task.__doc__}", flush=True)
            if task is camera:
                hand.server.press(hand.window, "b")


if __name__ == "__main__":
    try:
        vides, folder, mesh = map(os.path.abspath, sys.argv[1:4])
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        by_mouse(vides, folder, mesh)
        tasks(vides, folder)
    except Failure as failure:
        sys.exit(f"tasks: {failure}")
