"""Hands at a window of `vides edit` that count what they do, and look at the file that came of it.

An action is a click, a drag, a key with what is held, or a number typed with Enter.
"""

import contextlib
import csv
import io
import math
import os
import shutil
import subprocess
import tempfile

from harness import Failure, Program, Server, wait
from panel import BUTTON, FIELD, PANEL, boxes, middle, panel_boxes, timeline


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

    def held(self, key, box):
        """Clicks what was found while a key is held."""
        self.actions += 1
        x, y = middle(box)
        self.server.xdotool("mousemove", "--window", self.window, x, y, "keydown", key,
                            "click", 1, "keyup", key)

    def first_file(self):
        """A double click on the first file that is offered."""
        self.actions += 1
        def files(picture):
            # The list is the largest field.
            bottom = picture.height - timeline(picture.height)
            return boxes(picture, FIELD, 300, 150, picture.width - 300, bottom, (300, 200))[0][0]

        x, y = self.server.seen(self.window, files, "the files")[:2]
        self.server.xdotool("mousemove", "--window", self.window, x + 40, y + 16,
                            "click", "--repeat", 2, "--delay", 80, 1)

    def drag(self, start, end, button):
        """Drags from place to place."""
        self.actions += 1
        self.server.drag(self.window, start, end, button)

    def slide(self, start, end, key=None, steps=8):
        """Drags in as many pictures, perhaps with a key held; it ends where it is let go."""
        self.actions += 1
        moves = [[]]
        for word in self.server.drag_words(self.window, start, end, 1, steps):
            if word in ("mousemove", "mouseup"):
                moves.append([])
            moves[-1].append(word)
        if key:
            self.server.xdotool("keydown", key)
        for move in moves[1:]:
            self.server.xdotool(*move)
            self.server.served(self.window)
        if key:
            self.server.xdotool("keyup", key)

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

    def panel(self, colour, row, column):
        """A button or a field in the panels, in a row from the top."""
        self.away()
        return self.server.seen(self.window, lambda picture: panel_boxes(picture, colour)[row][column],
                                f"row {row}, column {column} of the panels")

    def bar(self, number):
        """A field above the timeline: frame, last frame, second, duration, rate."""
        def field(picture):
            top = picture.height - timeline(picture.height)
            return boxes(picture, FIELD, 0, top, picture.width, top + 32)[0][number]

        self.away()
        return self.server.seen(self.window, field, f"field {number} above the timeline")

    def way(self, number):
        """A way to begin that the empty window offers, or one that goes with a file."""
        def button(picture):
            return boxes(picture, BUTTON, 160, 60, picture.width - PANEL, picture.height,
                         (80, 50))[-1][number]

        return self.server.seen(self.window, button, f"way {number} to begin")

    def save_first(self):
        """Saves for the first time; does not count."""
        self.server.press(self.window, "ctrl+s")
        self.server.drawn(self.window)
        self.server.xdotool("key", "--delay", "20", "ctrl+a")
        self.server.type(self.file)
        self.server.xdotool("key", "Return")
        wait(lambda: os.path.exists(self.file), "the path")

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
        except Failure:
            server.picture().save(os.path.join(folder, "failed.png"))
            raise
        finally:
            program.kill()
            server.end()
