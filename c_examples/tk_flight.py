"""tk_flight: flies the camera path in a window of Tk, by Python's own ctypes.

A click into the window opens an editor. The poses that the user hands over (Alt-U)
are played, 25 a second, round and round. Escape ends the program.
"""

import ctypes
import tkinter
from ctypes import POINTER, c_float, c_int, c_ushort

FRAME = 40  # milliseconds
WIDTH, HEIGHT = 480, 320


class Vector(ctypes.Structure):
    """V_PUNKT."""
    _fields_ = [("x", c_float), ("y", c_float), ("z", c_float)]


class Pose(ctypes.Structure):
    """V_KAMERAPAR, one element of a list closed to a ring."""


Pose._fields_ = [("VRP", Vector), ("VPN", Vector), ("VUP", Vector), ("zoom", c_int),
                 ("prev", POINTER(Pose)), ("next", POINTER(Pose)), ("number", c_int)]


class Corner(ctypes.Structure):
    """V_OBJEKT_LISTE."""
    _fields_ = [("pos", Vector), ("draw", c_ushort), ("number", c_int)]


Rueck = ctypes.CFUNCTYPE(None, POINTER(Pose), c_int)
Ende = ctypes.CFUNCTYPE(c_int)

vides = ctypes.CDLL("libvides.so.1")
vides.v_haupt.argtypes = [c_float, c_float, c_float, c_float, POINTER(Pose), c_int,
                          POINTER(Corner), Rueck, Ende]
vides.v_haupt.restype = None

# What both show: from point to point a line, unless draw is 0.
PYRAMID = (Corner * 10)(*(
    Corner(Vector(x, y, z), draw, number) for number, (x, y, z, draw) in enumerate([
        (0.3, 0.0, 0.3, 0), (0.3, 0.0, -0.3, 1), (-0.3, 0.0, -0.3, 1), (-0.3, 0.0, 0.3, 1),
        (0.3, 0.0, 0.3, 1), (0.0, 0.5, 0.0, 1), (0.3, 0.0, -0.3, 1), (-0.3, 0.0, -0.3, 0),
        (0.0, 0.5, 0.0, 1), (-0.3, 0.0, 0.3, 1)], 1)))


def seen(pose, point):
    """Where a camera sees a point: right and down from the picture's middle, in half
    heights of the picture, and the distance. The zoom is a focal length in mm of a
    camera with a picture 24 mm high."""
    d, u = pose.VPN, pose.VUP
    x, y, z = point.x - pose.VRP.x, point.y - pose.VRP.y, point.z - pose.VRP.z
    depth = (x * d.x + y * d.y + z * d.z) * 12.0 / pose.zoom or 1e-9
    return ((x * (d.y * u.z - d.z * u.y) + y * (d.z * u.x - d.x * u.z)
             + z * (d.x * u.y - d.y * u.x)) / depth,
            -(x * u.x + y * u.y + z * u.z) / depth, depth)


class Flight:
    """The window and what it shows."""

    def __init__(self):
        self.top = tkinter.Tk()
        self.top.title("tk_flight")
        self.canvas = tkinter.Canvas(self.top, width=WIDTH, height=HEIGHT, background="white")
        self.canvas.pack()
        self.canvas.bind("<Button-1>", self.edit)
        self.top.bind("<Escape>", lambda event: self.top.destroy())
        self.poses = Pose(number=-1)  # no poses yet; the library keeps its address
        self.now = None
        # ctypes forgets a function that nobody holds: it must live as long as the window.
        self.rueck, self.ende = Rueck(self.take), Ende()
        self.top.createfilehandler(vides.v_fd(), tkinter.READABLE,
                                   lambda fd, mask: vides.v_dispatch())
        self.tick()

    def edit(self, _event):
        """Opens an editor."""
        vides.v_haupt(100, 100, 100, 100, self.poses, len(PYRAMID), PYRAMID,
                      self.rueck, self.ende)

    def take(self, poses, count):
        """The list stays as it is until the next call."""
        self.now = poses.contents
        print(count, "poses", flush=True)

    def tick(self):
        """The next picture."""
        self.canvas.delete("all")
        if self.now:
            corners = [seen(self.now, corner.pos) for corner in PYRAMID]
            for before, here, corner in zip(corners, corners[1:], PYRAMID[1:]):
                if corner.draw and before[2] > 0.01 and here[2] > 0.01:
                    self.canvas.create_line(*((size + value * HEIGHT) / 2 for end in (before, here)
                                              for size, value in zip((WIDTH, HEIGHT), end)))
            self.now = self.now.next.contents
        self.top.after(FRAME, self.tick)


if __name__ == "__main__":
    Flight().top.mainloop()
