"""Drives hosts that fly along: each shows in its own picture what the camera in the editor
sees, and its own camera can be taken over into the path."""

import os
import re
import time

from harness import Failure, check, run, wait
from panel import rail_of
from picture import Picture
from space import first_look
from view import difference, filled, sample

SUMMITS = [(0.3, 0.0, 0.3), (0.3, 0.0, -0.3), (-0.3, 0.0, -0.3), (-0.3, 0.0, 0.3), (0.0, 0.5, 0.0)]
PYRAMID = [(SUMMITS[a], SUMMITS[b]) for a, b in
           ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4))]
CORNERS = [(x, y, z) for x in (0.0, 12.0) for y in (0.0, 8.0) for z in (0.0, 5.0)]
HOUSE = [(a, b) for a in CORNERS for b in CORNERS
         if a < b and sum(i != k for i, k in zip(a, b)) == 1]
POSES = 121
"""Of a new path at speed 100: its length is 1.2, and the first pose."""
START = (-0.6, 0.2, 0.8)
"""The first point of a new path, in half sizes of the space as it is seen."""


class Flight:
    """A host and the editor beside it."""

    def __init__(self, stage, edges, height=None):
        self.stage, self.server, self.edges = stage, stage.server, edges
        self.height = height  # of its own picture, from the top; None: all of it
        self.window = self.server.new_window()
        if height is None:
            self.server.place(self.window, 10, 10)
        self.server.drawn(self.window)
        self.file = os.path.join(stage.folder, "flight.vid")
        self.poses = {}

    def save(self):
        """Saves the path, and samples it by the command."""
        before = os.path.exists(self.file) and os.stat(self.file).st_ino
        self.server.press(self.window, "ctrl+s")
        if not before:
            self.server.drawn(self.window)
            self.server.xdotool("key", "--delay", "20", "ctrl+a")
            self.server.type(self.file)
            self.server.xdotool("key", "Return")
        wait(lambda: os.path.exists(self.file) and os.stat(self.file).st_ino != before,
             "the saved path")
        self.poses = sample(self.stage.vides, self.file)

    def frame(self):
        """That of which the host's title tells, or None."""
        title = self.server.xdotool("getwindowname", self.stage.host)
        found = re.search(r": frame ([\d.]+)$", title)
        return found and float(found.group(1))

    def shows(self, frame=None):
        """Waits until the host tells of a frame, of any if none is given, and shows what the
        camera sees then. Gives its pose."""
        said = []

        def same():
            at = self.frame()
            if at is None or frame not in (None, at):
                said[:] = [f"of frame {at}, not {frame}"]
                return None
            pose = self.poses[round(at)]
            said[:] = [difference(self.picture(), pose, self.edges)]
            return pose if said == [None] else None

        try:
            return wait(same, "the picture")
        except Failure:
            raise Failure(f"the host's picture: {said[0]}") from None

    def picture(self):
        """What the host itself shows."""
        whole = self.server.picture(self.stage.host)
        rows = whole.rows[:self.height]
        return Picture(whole.width, len(rows), rows)

    def during(self, moves, button):
        """The mouse goes from place to place with a button down. Gives how often the host
        draws meanwhile; halfway it must have followed."""
        before = self.picture()
        words = [["mousemove", "--window", self.window, *place, "sleep", 0.03] for place in moves]
        half = len(words) // 2

        def follow():
            self.server.xdotool(*words[0], "mousedown", button, *sum(words[1:half], []))
            wait(lambda: self.picture().differs(before), "it to follow")
            self.server.xdotool(*sum(words[half:], []), "mouseup", button)

        return self.stage.pace(follow)[0]

    def scrub(self):
        """The playhead along the bar."""
        left, right, row = self.server.seen(self.window, rail_of, "the rail")
        step = (right - left) // 50
        return self.during([(left + at * step, row) for at in range(5, 40)], 1)

    def drag(self):
        """The first point, where it is seen."""
        space = self.server.seen(self.window, first_look, "the space")
        x, y = map(round, space.image(START))
        return self.during([(x + step, y - step // 2) for step in range(40)], 3)

    def lead(self, x, y):
        """The host's own camera, by the mouse from the picture's middle."""
        _, _, width, height = self.server.geometry(self.stage.host)
        self.server.drag(self.stage.host, (width / 2, height / 2),
                         (width / 2 + x, height / 2 + y), steps=10)
        return self.server.drawn(self.stage.host, 1)


def modal(flight, key):
    """A dialog of the host's own is open: it flies along nevertheless."""
    server, host = flight.server, flight.stage.host
    known = set(server.windows("."))
    server.press(host, key)
    wait(lambda: set(server.windows(".")) - known, "the host's dialog")
    dialog = max(set(server.windows(".")) - known)
    server.place(dialog, 20, 1000)  # beside what it shows
    before = flight.frame()
    server.press(flight.window, "ctrl+Next")
    wait(lambda: flight.frame() != before, "it to fly along during the host's dialog")
    flight.shows()
    server.press(dialog, "Escape")
    wait(lambda: dialog not in server.windows("."), "the host's dialog to go")
    server.press(flight.window, "ctrl+Prior")
    flight.shows(before)


def fly(stage, host):
    """One host, from beginning to end. Gives what is to be said of it."""
    flight = Flight(stage, host.edges)
    server, window = flight.server, flight.window
    flight.save()
    flight.shows(1)
    last = len(flight.poses)

    scrubbed = flight.scrub()
    check(scrubbed >= 10, f"{scrubbed} pictures while the user scrubs")
    scrubbed_to = flight.shows()
    check(scrubbed_to.frame not in (1, last), f"scrubbed to {scrubbed_to.frame}")

    for other in (last, 1):  # round and round
        server.press(window, "ctrl+Prior")
        before = flight.shows(other)
    dragged = flight.drag()
    check(dragged >= 10, f"{dragged} pictures during a drag")
    flight.save()
    check(flight.shows(1).vrp != before.vrp, "the drag changed nothing")
    check(len(flight.poses) != last, "the way is as long as before")
    last = len(flight.poses)

    played, _ = stage.pace(lambda: (server.press(window, "F5"), flight.shows(last)))
    check(played >= 20, f"{played} pictures while it plays")
    if host.modal:
        modal(flight, host.modal)

    flight.lead(20, 30)
    shown = server.drawn(window)
    own = flight.lead(40, 25)
    wait(lambda: server.picture(window).differs(shown), "the ghost")
    flight.save()
    server.press(window, "ctrl+Return")
    wait(lambda: flight.frame() not in (1, last), "the new point")
    flight.save()
    taken = flight.shows()
    reason = difference(own, taken, host.edges)
    check(not reason, f"it took over another view: {reason}")

    server.press(window, "ctrl+q")
    server.gone(window)
    before = server.drawn(stage.host, 1)
    flight.lead(-40, 10)
    check(server.picture(stage.host).differs(before), "the host stands still without the editor")
    leave(stage, host)
    return f"{scrubbed} pictures while scrubbed, {dragged} dragged, {played} played"


def leave(stage, host):
    """The host ends by its key."""
    stage.server.press(stage.host, host.leave)
    check(stage.program.ends() == 0, "its exit status")
    check(not stage.complaints(), f"it complained: {stage.complaints()}")


def end_first(stage, host):
    """The host ends while the editor is open."""
    window = stage.server.new_window()
    leave(stage, host)
    stage.server.gone(window)


def embedded(stage, _host):
    """The editor in a window of GTK 3, whose line tells the camera."""
    server, program = stage.server, stage.program
    flight = Flight(stage, None, 40)

    def told():
        """The camera of which the host told last is that of the path. Gives the frame."""
        line = [line for line in program.said if line.startswith("Frame")][-1]
        numbers = [float(word) for word in re.findall(r"-?\d+(?:\.\d+)?", line)]
        pose = flight.poses[round(numbers[0])]
        wanted = [pose.frame, *pose.vrp, pose.zoom]
        return all(abs(a - b) < 0.0006 for a, b in zip(numbers, wanted)) and pose.frame

    flight.save()
    wait(lambda: told() == 1, "the first frame")
    flight.scrub()
    wait(lambda: told() not in (False, 1, len(flight.poses)), "another frame")
    scrubbed_to = told()
    server.press(flight.window, "F5")
    wait(lambda: told() == len(flight.poses), "the last frame")
    typing(stage, flight)
    check(not stage.complaints(), f"it complained: {stage.complaints()}")
    return f"scrubbed to {scrubbed_to}, played to {told()}; the keyboard goes where one clicks"


def typing(stage, flight):
    """Who of the two is clicked has the keyboard, and keeps it."""
    server, program = stage.server, stage.program

    def entry(more, whole):
        server.click(stage.host, 60, 20)
        time.sleep(0.4)  # as long as the editor might take it again
        server.type(more)
        server.xdotool("key", "Return")
        program.expect(f"named {whole}")

    def editor(*keys):
        server.click(flight.window, 500, 100)
        time.sleep(0.4)
        server.xdotool("key", "--delay", "20", *keys, "alt+u")
        program.expect(f"{POSES} poses")

    entry("ab", "ab")
    editor()
    entry("cd", "abcd")
    editor("alt+s", "Escape")  # a dialog of its own
    entry("e", "abcde")
    editor()


def managed(stage, _host):
    """The same with a window manager, which gives the keyboard to windows; it closes this one."""
    flight = Flight(stage, None, 40)
    typing(stage, flight)
    stage.server.xdotool("key", "alt+F4")  # the editor's, which closes
    stage.server.gone(flight.window)
    return None


def pane(stage, _host):
    """The host draws in the editor's camera pane what the camera sees."""
    server, program = stage.server, stage.program
    flight = Flight(stage, None)
    flight.save()

    def child():
        """The host's window in the pane, or None."""
        tree = run("xwininfo", "-id", str(flight.window), "-tree", env=server.env).decode()
        inner = re.findall(r"^ {8,}(0x[0-9a-f]+) ", tree, re.M)
        return inner and int(inner[0], 16)

    def shows(frame):
        def same():
            return not filled(server.picture(stage.host), flight.poses[frame], SUMMITS)
        wait(same, f"frame {frame} in the pane", 20)

    stage.host = wait(child, "the host's window in the pane")
    shows(1)
    server.press(flight.window, "ctrl+Next")
    shows(len(flight.poses))
    scrubbed = flight.scrub()
    server.press(flight.window, "F4")
    wait(lambda: not child(), "the pane to close")
    server.press(flight.window, "F4")
    stage.host = wait(child, "another window in the pane")
    for frame in (len(flight.poses), 1):  # round and round
        server.press(flight.window, "ctrl+Prior")
        shows(frame)
    dragged = flight.drag()
    flight.save()
    shows(1)
    server.press(flight.window, "ctrl+q")
    check(program.ends() == 0, "its exit status")
    check(not stage.complaints(), f"it complained: {stage.complaints()}")
    return f"{scrubbed} pictures while scrubbed, {dragged} dragged"
