"""The movement window's projection as seen from outside, for tests that drag in it.

A parallel projection: the movement space is rotated about y, then tilted, then
scaled. Written from that sentence alone; where its middle lies and how large it
is are measured, by where dragged points come to lie.
"""

import math

ROTATION, TILT = 28.0, 20.0
"""Of a new window, in degrees."""

CUBE = (0x4D, 0x54, 0x5F)
"""Colour of the cube's edges in the dark theme."""


def directions(rotation=ROTATION, tilt=TILT):
    """What a unit along x, y, z is on a screen (right, down), at size 1."""
    turn, lean = math.radians(rotation), math.radians(tilt)
    images = []
    for x, y, z in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
        right = x * math.cos(turn) + z * math.sin(turn)
        deep = -x * math.sin(turn) + z * math.cos(turn)  # towards the viewer
        up = y * math.cos(lean) - deep * math.sin(lean)
        images.append((right, -up))
    return images


class Space:
    """Where points of the movement space are seen in a window."""

    def __init__(self, scale, middle, axes=None):
        self.scale, self.middle, self.axes = scale, middle, axes or directions()

    def flat(self, point):
        """Before scaling and shifting."""
        return tuple(sum(point[i] * self.axes[i][k] for i in range(3)) for k in (0, 1))

    def image(self, point):
        """Pixels in the window."""
        flat = self.flat(point)
        return tuple(self.middle[k] + self.scale * flat[k] for k in (0, 1))

    def fitted(self, pairs):
        """With middle and scale so that these points are seen at these pixels,
        by least squares: [(point, pixel), ...]."""
        flats = [self.flat(point) for point, _ in pairs]
        count = len(pairs)
        mean = [sum(flat[k] for flat in flats) / count for k in (0, 1)]
        seen = [sum(pixel[k] for _, pixel in pairs) / count for k in (0, 1)]
        above = sum((flats[i][k] - mean[k]) * (pairs[i][1][k] - seen[k])
                    for i in range(count) for k in (0, 1))
        below = sum((flat[k] - mean[k]) ** 2 for flat in flats for k in (0, 1))
        scale = above / below
        return Space(scale, tuple(seen[k] - scale * mean[k] for k in (0, 1)), self.axes)


def first_look(picture):
    """The space, to a pixel or so, from where the edges of the cube are seen.

    The edges along y are upright, and thinner than the rail of the slider beside
    the space. The leftmost and the rightmost of them are never hidden; the leftmost
    runs through (-1, 0, -1), the rightmost through (1, 0, 1). Something may lie over the ends of the right one.
    """
    columns = {}
    # Beside the space, in a wide window, is the list of points.
    left = 150 if picture.width >= 1100 else 0
    for x, y in picture.find(CUBE, 8):
        if x >= left:
            columns.setdefault(x, []).append(y)
    upright = []
    for x, rows in columns.items():
        start = last = rows[0]
        for y in rows[1:] + [None]:
            if y is None or y - last > 4:
                if last - start > 150:
                    upright.append((x, start, last))
                start = y
            last = y
    seen = {x for x, _, _ in upright}
    wide = {x + k for x in seen if {x + 1, x + 2, x + 3} <= seen for k in range(4)}
    upright = [run for run in upright if run[0] not in wide]
    left, right = min(upright), max(upright)
    return Space(1.0, (0.0, 0.0)).fitted([
        ((-1, 1, -1), (left[0], left[1])), ((-1, -1, -1), (left[0], left[2])),
        ((1, 0, 1), (right[0], (left[1] + left[2]) / 2 + _fall(left, right)))])


def _fall(left, right):
    """How much lower the middle of the right edge is seen than that of the left."""
    space = Space(1.0, (0.0, 0.0))
    a, b = space.flat((-1, 0, -1)), space.flat((1, 0, 1))
    return (right[0] - left[0]) * (b[1] - a[1]) / (b[0] - a[0])
