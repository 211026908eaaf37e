"""A flight made in the window, as a moving picture for the README and the first pages:
moving_picture.py VIDES OUT.png [STEPS_FOLDER]

Points are put and dragged around a knot and aimed at it; then the flight is shown, frame by frame.
The picture is an APNG with a palette, each frame only what differs from the one before. STEPS_FOLDER
gets a PNG of each step.
"""

import collections
import os
import struct
import sys
import tempfile
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../mk"))

from gallery import grid, knot, write_obj
from hands import window_for
from space import Space

SIZE = 860, 600
SPACE = Space(136.8, (309, 274))
"""Where the space is seen in a window of this size."""
PLACES = [(-0.85, 0.3, 0.1), (-0.7, 0.6, -0.65), (0.75, 0.6, -0.65), (0.85, 0.3, 0.1)]
"""Where the points in the middle are dragged, in half edges of the space."""
TARGET, NUMBERS, FRAME = (650, 234), [(660, 261), (740, 261), (820, 261)], (165, 532)
"""The button of a target, its three numbers, and the field of the frame."""
PICTURES = 20
STEP, SHOWN = 0.9, 0.15
"""Pictures of the flight, and the seconds for which a step and one of them are shown."""


CLEAR = 255
"""In the palette: what the picture before shows."""


class Film:
    """Pictures with their seconds."""

    def __init__(self):
        self.frames = []

    def add(self, picture, seconds):
        """One more, as rows of colours of 5 bits a channel."""
        rows = []
        for row in picture.rows:
            colours = bytes(value & 0xF8 for value in row)
            rows.append(struct.unpack(f"<{picture.width}I", colours))
        self.frames.append(([[c & 0xFFFFFF for c in row] for row in rows], seconds))

    def palette(self):
        """The most frequent colours, and for each colour the number of the nearest of them."""
        count = collections.Counter()
        for rows, _ in self.frames:
            for row in rows:
                count.update(row)
        parts = lambda colour: (colour >> 16 & 255, colour >> 8 & 255, colour & 255)
        chosen = [colour for colour, _ in count.most_common(CLEAR)]
        places = [parts(colour) for colour in chosen]

        def nearest(colour):
            mine = parts(colour)
            return min(range(len(places)), key=lambda k: sum(abs(a - b) for a, b in zip(places[k], mine)))

        number = {colour: k for k, colour in enumerate(chosen)}
        number.update((colour, nearest(colour)) for colour in count if colour not in number)
        return places, number

    def save(self, path):
        """Writes the APNG."""
        places, number = self.palette()
        shown = [[bytes(number[c] for c in row) for row in rows] for rows, _ in self.frames]
        height, width = len(shown[0]), len(shown[0][0])
        with open(path, "wb") as out:
            def chunk(kind, data):
                check = zlib.crc32(kind + data)
                out.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check))

            out.write(b"\x89PNG\r\n\x1a\n")
            chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 3, 0, 0, 0))
            chunk(b"acTL", struct.pack(">2I", len(shown), 0))
            places += [(0, 0, 0)] * (CLEAR + 1 - len(places))
            chunk(b"PLTE", bytes(value for place in places for value in place))
            chunk(b"tRNS", b"\xff" * CLEAR + b"\0")
            order, before = 0, None
            for rows, (_, seconds) in zip(shown, self.frames):
                x, y, part = changed(before, rows)
                chunk(b"fcTL", struct.pack(">5I2H2B", order, len(part[0]), len(part), x, y,
                                           round(1000 * seconds), 1000, 0, 1))
                order += 1
                data = zlib.compress(b"".join(b"\0" + row for row in part), 9)
                if before is None:
                    chunk(b"IDAT", data)
                else:
                    chunk(b"fdAT", struct.pack(">I", order) + data)
                    order += 1
                before = rows
            chunk(b"IEND", b"")


def changed(before, rows):
    """The rectangle that differs: its corner, and its rows, clear where they are the same."""
    if before is None:
        return 0, 0, rows
    differ = [y for y, (a, b) in enumerate(zip(before, rows)) if a != b] or [0]
    top, bottom = differ[0], differ[-1] + 1
    columns = [x for y in differ for x, (a, b) in enumerate(zip(before[y], rows[y])) if a != b] or [0]
    left, right = min(columns), max(columns) + 1
    part = [bytes(CLEAR if a == b else b for a, b in zip(before[y][left:right], rows[y][left:right]))
            for y in range(top, bottom)]
    return left, top, part


def frames(hand):
    """How many frames the flight has."""
    hand.save_first()
    return len(hand.poses())


def main():
    """See the top."""
    vides, out = map(os.path.abspath, sys.argv[1:3])
    steps = os.path.abspath(sys.argv[3]) if sys.argv[3:] else None
    film = Film()
    with tempfile.TemporaryDirectory(prefix="vides-film-") as folder:
        mesh = os.path.join(folder, "knot.obj")
        write_obj(mesh, grid(120, 16, knot))
        with window_for(vides, folder, "--object", mesh) as hand:
            server, window = hand.server, hand.window
            server.xdotool("windowsize", window, *SIZE)

            def step(name):
                server.drawn(window)
                film.add(server.picture(window), STEP)
                if steps:
                    server.picture(window).save(os.path.join(steps, name + ".png"))

            step("1-begin")
            hand.keys("ctrl+i", "4")
            step("2-points")
            for number in range(1, 5):
                begin = -0.6 + 1.2 * number / 5, 0.2, 0.8
                goal = PLACES[number - 1]
                along = goal[0], begin[1], goal[2]
                hand.drag(SPACE.image(begin), SPACE.image(along), 2)
                hand.drag(SPACE.image(along), SPACE.image(goal), 3)
                hand.away()
                step(f"3-drag-{number}")
            server.click(window, *TARGET)
            server.drawn(window)
            for place in NUMBERS:
                hand.number((*place, 0, 0), 0)
            server.drawn(window)
            hand.keys("F7")
            hand.away()
            step("4-aim")
            count = frames(hand)
            for number in range(PICTURES + 1):
                server.click(window, *FRAME)
                server.xdotool("key", "--delay", "20", "ctrl+a")
                hand.typed(1 + round((count - 1) * number / PICTURES))
                hand.away()
                film.add(server.drawn(window), SHOWN)
            step("5-end")
    film.save(out)
    print(f"{out}: {len(film.frames)} pictures, {os.path.getsize(out)} bytes")


if __name__ == "__main__":
    main()
