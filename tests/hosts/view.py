"""What a camera sees of a wireframe, from the definition alone, and whether a picture shows it."""

import collections
import csv
import io
import math
import struct
import subprocess

PICTURE = 24.0
"""Height of the film in mm: a zoom is a focal length in mm."""
NEAR = 0.01
INK = 60
"""So far from the picture's ground, of 255, lies a line's colour."""
REACH = 2
"""Pixels by which toolkits draw a line elsewhere, or wider."""


class Pose:
    """A row of `vides sample --format csv`."""

    def __init__(self, row):
        numbers = list(map(float, row[1:]))
        self.frame = int(row[0])
        self.vrp, self.vpn, self.vup = numbers[0:3], numbers[3:6], numbers[6:9]
        self.zoom = numbers[9]

    def eye(self, point):
        """A point right of, above and before the camera."""
        f, u = self.vpn, self.vup
        right = (f[1] * u[2] - f[2] * u[1], f[2] * u[0] - f[0] * u[2], f[0] * u[1] - f[1] * u[0])
        way = [a - b for a, b in zip(point, self.vrp)]
        return tuple(sum(a * b for a, b in zip(way, axis)) for axis in (right, u, f))

    def image(self, point, width, height):
        """Pixels from the upper left corner of a picture."""
        x, y, depth = self.eye(point)
        scale = self.zoom / PICTURE * height / depth
        return width / 2 + x * scale, height / 2 - y * scale


def sample(vides, file):
    """The poses of a path by their frames."""
    out = subprocess.run([vides, "sample", file, "--format", "csv"], capture_output=True,
                         text=True, check=True).stdout
    rows = list(csv.reader(io.StringIO(out)))[1:]
    return {pose.frame: pose for pose in map(Pose, rows)}


def ink(picture):
    """The pixels that are not of its ground, the colour that most have."""
    every = collections.Counter()
    rows = [struct.unpack(f"<{picture.width}I", row) for row in picture.rows]
    for row in rows:
        every.update(row)
    ground = every.most_common(1)[0][0]
    lines = {colour for colour in every
             if max(abs((colour >> k & 255) - (ground >> k & 255)) for k in (0, 8, 16)) > INK}
    return {(x, y) for y, row in enumerate(rows) for x, colour in enumerate(row)
            if colour in lines}


def around(place):
    """The pixels that a line through one may touch."""
    return ((place[0] + i, place[1] + k) for i in range(-REACH, REACH + 1)
            for k in range(-REACH, REACH + 1))


def drawn(pose, edges, width, height):
    """The pixels on the edges that a camera sees, each a pair of points before it."""
    places = set()
    for edge in edges:
        if any(pose.eye(end)[2] < NEAR for end in edge):
            raise ValueError("an edge is not before the camera")
        (x, y), (to_x, to_y) = (pose.image(end, width, height) for end in edge)
        steps = max(1, math.ceil(max(abs(to_x - x), abs(to_y - y))))
        for step in range(steps + 1):
            at = (math.floor(x + (to_x - x) * step / steps),
                  math.floor(y + (to_y - y) * step / steps))
            if 0 <= at[0] < width and 0 <= at[1] < height:
                places.add(at)
    return places


def difference(picture, pose, edges):
    """Why a picture is not what a camera sees of edges, or None."""
    seen = ink(picture)
    wanted = drawn(pose, edges, picture.width, picture.height)
    near_wanted = {near for place in wanted for near in around(place)}
    near_seen = {near for place in seen for near in around(place)}
    missing, other = wanted - near_seen, seen - near_wanted
    if missing or other or len(wanted) < 100:
        return (f"frame {pose.frame}: of {len(wanted)} pixels of lines {len(missing)} are missing, "
                f"of {len(seen)} in the picture {len(other)} are elsewhere")
    return None


def filled(picture, pose, points):
    """Why a picture is not what a camera sees of the solid between points, or None: the hull
    of where they are seen, but for its rim."""
    hull = convex([pose.image(point, picture.width, picture.height) for point in points])
    seen = ink(picture)
    wrong, inside = 0, 0
    for y in range(picture.height):
        for x in range(picture.width):
            depth = min(((bx - ax) * (y + 0.5 - ay) - (by - ay) * (x + 0.5 - ax))
                        / math.hypot(bx - ax, by - ay)
                        for (ax, ay), (bx, by) in zip(hull, hull[1:] + hull[:1]))
            inside += depth > REACH
            wrong += abs(depth) > REACH and (depth > 0) != ((x, y) in seen)
    if wrong or inside < 100:
        return f"frame {pose.frame}: {wrong} pixels are wrong; {inside} are within the solid"
    return None


def convex(points):
    """Their hull, round and round, its inside at positive distances (Andrew's chain)."""
    points = sorted(points)

    def half(row):
        chain = []
        for x, y in row:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (y - chain[-2][1])
                                      <= (chain[-1][1] - chain[-2][1]) * (x - chain[-2][0])):
                chain.pop()
            chain.append((x, y))
        return chain[:-1]

    return half(points) + half(points[::-1])
