"""The flight of the thesis's chapter 7.5, made in a window of v_haupt() as its text says, by
mouse: what comes of it stands beside examples/pyramid.vid."""

import math
import os
import shutil
import tomllib

from harness import check, wait
from panel import BUTTON, CHOSEN, FIELD, boxes, middle, panel_boxes
from run import test
from space import first_look

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/pyramid.vid")

CORNER = 3
"""The point at which the camera stops, and pans."""

FIRST_ROW, ROW = 83, 22
"""The first row in the list of points, and from one row to the next."""

PRESET = 28
"""From one preset in the menu of the curve to the next."""


class Flight:
    """A window of a host of 1994, and hands at it."""

    def __init__(self, place):
        self.place = place
        self.server = place.server()
        self.host = place.told(self.server, LANG="en_GB.UTF-8", LC_ALL=None)
        self.host.open()
        self.window = self.server.new_window()
        self.server.xdotool("windowsize", self.window, 1380, 980)
        # Without the camera's picture over the space.
        self.server.press(self.window, "F4")
        picture = self.drawn()
        self.space = first_look(picture)
        # + Point and + View, each beside another button.
        found = boxes(picture, BUTTON, 0, 400, 160, picture.height, (60, 20))
        self.adds = [row[0] for row in found if len(row) == 2 and row[0][0] < 12][:2]
        self.file = place.path("flight.vid")

    def drawn(self):
        """The window, with the pointer where it lights nothing."""
        self.server.xdotool("mousemove", "--window", self.window, 600, 15)
        return self.server.drawn(self.window)

    def kept(self, name):
        """A picture for who looks at it."""
        self.drawn().save(self.place.path(f"{name}.png"))

    def click(self, box):
        """Clicks what was found."""
        self.server.click(self.window, *middle(box))

    def is_chosen(self, x, y):
        """Whether what lies there is chosen."""
        pixel = self.server.picture(self.window).pixel(round(x), round(y))
        return all(abs(a - b) < 4 for a, b in zip(pixel, CHOSEN))

    def current(self, number):
        """Waits until a row of the list is the current one."""
        wait(lambda: self.is_chosen(6, FIRST_ROW + ROW * number), f"row {number} to be current")

    def row(self, number):
        """Clicks a row in the list."""
        self.server.click(self.window, 70, FIRST_ROW + ROW * number)
        self.current(number)

    def add(self, view, current):
        """+ Point or + View below the list; then this row is the current one."""
        self.click(self.adds[view])
        self.current(current)

    def number(self, row, column, value):
        """Types a number into a field of the panels."""
        box = panel_boxes(self.drawn(), FIELD)[row][column]
        x, y, width, height = box

        def seen():
            rows = self.server.picture(self.window).rows[y - 3:y + height + 3]
            return [line[4 * x - 12:4 * (x + width) + 12] for line in rows]

        rests = seen()
        self.click(box)
        wait(lambda: seen() != rests, "the field to take the keyboard")
        self.server.xdotool("key", "--delay", "20", "ctrl+a")
        self.server.type(str(value))
        typed = seen()
        self.server.xdotool("key", "Return")
        wait(lambda: seen() != typed, "the number to be taken")

    def preset(self, number):
        """A preset for the current point, from the menu of the curve."""
        def first():
            picture = self.server.picture(self.window)
            found = boxes(picture, CHOSEN, 900, 130, 1200, 300, (200, 16))
            return found and found[0][0]

        self.server.click(self.window, self.server.geometry(self.window)[2] - 40, 120)
        x, y, *_ = wait(first, "the menu of the curve")
        self.server.click(self.window, x + 60, y + 12 + PRESET * number)
        wait(lambda: not first(), "the menu to close")

    def drag(self, start, *places):
        """A point or a tip from place to place: each keeps y (middle button) or z (right button)."""
        for goal in places:
            button = 2 if goal[1] == start[1] else 3
            self.server.drag(self.window, self.space.image(start), self.space.image(goal), button)
            start = goal

    def aim(self, target):
        """The current view looks at a place, by numbers."""
        x, y, *_ = panel_boxes(self.drawn(), BUTTON)[0][0]
        if x < self.server.geometry(self.window)[2] - 200:
            self.server.click(self.window, x + 20, y + 12)
            wait(lambda: self.is_chosen(x + 6, y + 12), "a target")
        for column, value in enumerate(target):
            self.number(3, column, value)

    def squares(self):
        """Where the flat speed curve begins, how wide it is, and its height in the window."""
        picture = self.server.picture(self.window)
        found = boxes(picture, CHOSEN, 0, 400, 640, picture.height - 260, (400, 7))
        return found and (found[0][0][0] + 4.5, found[0][0][2] - 9, found[0][0][1] + 4)

    def speeds(self, wanted, squares):
        """The squares of the speed curve are dragged there, by way of the top."""
        left, width, y = squares
        for k, speed in enumerate(wanted):
            # 132 pixels from 1 to 100.
            x, top, goal = (round(value) for value in
                            (left + width * k / 9, y - 60, y - (speed - 50) * 132 / 99))
            if speed == 50:
                continue

            def at_top(x=x, top=top):
                return self.server.picture(self.window).pixel(x, top)

            def to(row, *words, x=x):
                self.server.xdotool("mousemove", "--window", self.window, x, row, *words)

            empty = at_top()

            def lifted(x=x, top=top):
                # A press and a motion in one picture miss the square: again then.
                to(round(y))
                wait(lambda: not self.is_chosen(x, y), "a square to be meant")
                to(round(y), "mousedown", 1, "sleep", "0.1")
                to(top, "sleep", "0.3")
                if at_top() != empty:
                    return True
                self.server.xdotool("mouseup", 1)
                return False

            wait(lifted, f"speed {k} to be dragged")
            to(goal)
            wait(lambda: at_top() == empty, f"speed {k} to follow")
            self.server.xdotool("mouseup", 1)

    def saved(self):
        """Saves, and gives what the file holds."""
        there = os.path.exists(self.file)
        before = os.stat(self.file).st_mtime_ns if there else 0
        self.server.press(self.window, "ctrl+s")
        if not there:
            self.named(self.file)
        wait(lambda: os.path.exists(self.file) and os.stat(self.file).st_mtime_ns != before,
             "the path to be saved")
        # The dialog that asked for the name is still there for a moment, and takes clicks.
        self.server.drawn(self.window)
        with open(self.file, "rb") as file:
            return tomllib.load(file)

    def named(self, file):
        """Names a file where one is asked for."""
        self.server.drawn(self.window)
        self.server.xdotool("key", "--delay", "20", "ctrl+a")
        self.server.type(file)
        self.server.xdotool("key", "Return")

    def handed_over(self, name):
        """The poses that the host gets."""
        self.server.press(self.window, "alt+u")
        self.host.expect("rueck-end")
        file = self.place.path(name)
        self.host.tell(f"write 0 {file}", "written")
        with open(file, encoding="ascii") as lines:
            return [[float(word) for word in line.split()] for line in lines]


def near(a, b, far, what):
    """Fails unless two places are so near."""
    check(math.dist(a, b) <= far, f"{what}: {a}, not {b}")


@test(first=True)
def the_flight_of_the_manual(place):
    """Each step of chapter 7.5 with the picture that it has there."""
    flight = Flight(place)
    with open(EXAMPLE, "rb") as file:
        example = tomllib.load(file)["point"]
    places = [point["position"] for point in example]
    top = example[0]["orientation"][0]["target"]
    flight.kept("7.2")

    # Abb. 7.3: points are inserted half-way; each has all of the one before, and no tangents.
    begin, end = places[0], places[-1]
    for number in range(1, 5):
        flight.add(0, number)
    flight.kept("7.3")
    points = flight.saved()["point"]
    check(len(points) == 6, f"{len(points)} points")
    shares = [0, 0.5, 0.75, 0.875, 0.9375, 1]
    laid = [[a + (b - a) * share for a, b in zip(begin, end)] for share in shares]
    for point, there in zip(points, laid):
        near(point["position"], there, 1e-9, "a new point")
        check(dict(point, position=begin) == points[0], f"no copy: {point}")

    # Abb. 7.4: they are dragged in the planes; the curve follows.
    for number in range(1, 5):
        x, y, z = places[number]
        along = [x, laid[number][1], z]
        if number == 1:
            # Plane and axes are there as soon as the button goes down (A.3.1).
            flight.row(number)
            before = flight.drawn()
            at = flight.space.image(laid[1])
            flight.server.xdotool("mousemove", "--window", flight.window, *map(round, at))
            hovered = flight.server.drawn(flight.window)
            flight.server.xdotool("mousedown", 2)
            wait(lambda: lines(flight.server.picture(flight.window), hovered) > 800,
                 "the plane and the axes at the press")
            flight.server.drawn(flight.window).save(place.path("A.3.1.png"))
            flight.server.xdotool("mouseup", 2)
            wait(lambda before=before: not flight.drawn().differs(before),
                 "a press alone to change nothing")
        flight.drag(laid[number], along, [x, y, z])
    flight.kept("7.4")
    points = flight.saved()["point"]
    for point, wanted in zip(points, places):
        near(point["position"], wanted, 0.03, "a dragged point")
        check("tangents" not in point, "a point owns tangents")

    # Abb. 7.5: the curve is straight behind the pyramid and has a corner at the right.
    for number, point in enumerate(example):
        if point.get("preset"):
            flight.row(number)
            flight.preset(point["preset"])
    flight.kept("7.5")

    # Abb. 7.6: all look at the top, by numbers; at the corner the camera pans along the foot.
    for number in range(6):
        flight.row(number)
        flight.aim(top)
    flight.row(CORNER)
    views = [view["target"] for view in example[CORNER]["orientation"]]
    flight.add(1, CORNER + 1)
    flight.drag(views[0], [views[1][0], views[0][1], views[1][2]], views[1])
    flight.add(1, CORNER + 2)
    flight.drag(views[1], views[2])
    flight.add(1, CORNER + 3)
    flight.aim(views[3])
    for number in (CORNER, CORNER + 3):
        flight.row(number)
        flight.number(-1, 0, 12)
    flight.kept("7.6")

    # Abb. 7.7: the speeds; after the pan the camera sets off slowly.
    flight.row(0)
    flight.server.press(flight.window, "F3")
    squares = wait(flight.squares, "the speed curve")
    rows = iter(range(9))
    for point in example:
        for view in point["orientation"]:
            row = next(rows)
            if "speed_curve" in view:
                flight.row(row)
                flight.speeds(view["speed_curve"], squares)
    flight.row(CORNER + 3)
    flight.kept("7.7")
    flight.server.press(flight.window, "F3")
    flight.kept("7.8")

    # What came of it, beside the example.
    points = flight.saved()["point"]
    for number, (made, wanted) in enumerate(zip(points, example, strict=True)):
        near(made["position"], wanted["position"], 0.03, f"point {number}")
        check(made.get("preset", 0) == wanted.get("preset", 0), f"preset of point {number}")
        check("tangents" not in made, f"point {number} owns tangents")
        pairs = zip(made["orientation"], wanted["orientation"], strict=True)
        for at, (view, its) in enumerate(pairs):
            where = f"view {at} of point {number}"
            near(view["target"], its["target"], 0.03, where)
            check(view.get("hold_frames") == its.get("hold_frames"), f"hold of {where}")
            constant = [50.0] * 10
            both = zip(view.get("speed_curve", constant), its.get("speed_curve", constant))
            apart = max(abs(a - b) for a, b in both)
            check(apart <= 1, f"speeds of {where}: {view.get('speed_curve')}")
    made = flight.handed_over("made.txt")
    shutil.copy(EXAMPLE, place.path("pyramid.vid"))
    flight.server.press(flight.window, "ctrl+o")
    flight.named(place.path("pyramid.vid"))
    wait(lambda: "pyramid" in flight.server.property(flight.window, "WM_NAME"), "the example")
    wanted = flight.handed_over("wanted.txt")
    check(abs(len(made) - len(wanted)) <= 0.05 * len(wanted),
          f"{len(made)} poses, {len(wanted)} in the example")
    for k, pose in enumerate(wanted):
        # At the same share of the flight, or a little before or after.
        at = round(k * (len(made) - 1) / (len(wanted) - 1))
        beside = made[max(0, at - 12):at + 13]
        far = min(math.dist(pose[:3], other[:3]) for other in beside)
        check(far < 0.04, f"pose {k}: {far:.3f} beside the example")
    flight.host.leave()


def lines(picture, before):
    """Pixels that differ from those of another picture."""
    return sum(
        a[4 * x:4 * x + 3] != b[4 * x:4 * x + 3]
        for a, b in zip(picture.rows, before.rows) if a != b for x in range(picture.width))
