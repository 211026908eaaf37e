"""tk_flight: flies the camera path in a window of Tk, by Python's own ctypes.

The picture follows the editor beside it: what is dragged, scrubbed or played there is seen
here at once. Dragging here moves a separate camera around the object; the editor shows it
as a ghost and takes it over into the path (Ctrl-Enter). Escape ends.
"""

import ctypes
import tkinter
from ctypes import (CFUNCTYPE, POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_uint,
                    c_ulong, c_void_p)
from math import cos, sin

WIDTH, HEIGHT = 480, 320


class Pose(ctypes.Structure):
    """V_POSE."""
    _fields_ = [("vrp", c_double * 3), ("vpn", c_double * 3), ("vup", c_double * 3),
                ("zoom", c_double)]


class Mesh(ctypes.Structure):
    """V_MESH."""
    _fields_ = [("size", c_size_t), ("xyz", POINTER(c_double)), ("points", c_size_t),
                ("rgb", c_void_p), ("lines", POINTER(c_uint)), ("line_ends", c_size_t),
                ("triangles", c_void_p), ("corners", c_size_t)]


OnView = CFUNCTYPE(None, c_void_p, POINTER(Pose), c_double, c_int, c_void_p)


class Options(ctypes.Structure):
    """V_EDITOR_OPTIONS."""
    _fields_ = [("size", c_size_t), ("title", c_char_p), ("file", c_char_p), ("path", c_void_p),
                ("object", POINTER(Mesh)), ("frames", c_double * 4), ("display", c_char_p),
                ("language", c_char_p), ("on_poses", c_void_p), ("on_close", c_void_p),
                ("user", c_void_p), ("space_centre", c_double * 3), ("space_half_size", c_double),
                ("space_up", c_int), ("on_view", OnView), ("on_change", c_void_p),
                ("on_capture", c_void_p), ("on_pane", c_void_p), ("host_name", c_char_p),
                ("parent", c_ulong), ("transient_for", c_ulong), ("application", c_char_p),
                ("hand_over_saves", c_int), ("on_frame", c_void_p), ("view", c_void_p),
                ("on_gone", c_void_p)]


vides = ctypes.CDLL("libvides.so.1")
vides.v_last_error.restype = c_char_p
vides.v_editor_set_view.argtypes = [c_void_p, POINTER(Pose)]

# What both show: points, and the lines between them.
XYZ = [(0.3, 0.0, 0.3), (0.3, 0.0, -0.3), (-0.3, 0.0, -0.3), (-0.3, 0.0, 0.3), (0.0, 0.5, 0.0)]
LINES = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)]
PYRAMID = Mesh(size=ctypes.sizeof(Mesh), xyz=(c_double * 15)(*sum(XYZ, ())), points=5,
               lines=(c_uint * 16)(*sum(LINES, ())), line_ends=16)


class Flight:
    """The window and what it shows."""

    def __init__(self):
        self.top = tkinter.Tk()
        self.top.title("tk_flight")
        self.canvas = tkinter.Canvas(self.top, width=WIDTH, height=HEIGHT, background="white")
        self.canvas.pack()
        self.canvas.bind("<B1-Motion>", self.drag)
        self.top.bind("<Escape>", lambda event: self.top.destroy())
        # ctypes frees a function without references: keep one as long as the editor lives.
        self.on_view = OnView(self.follow)
        options = Options(size=ctypes.sizeof(Options), title=b"tk_flight", host_name=b"tk_flight",
                          object=ctypes.pointer(PYRAMID), on_view=self.on_view)
        self.editor = c_void_p()
        if vides.v_editor_open(byref(options), byref(self.editor)) != 0:
            raise SystemExit(vides.v_last_error().decode())
        self.top.createfilehandler(vides.v_fd(), tkinter.READABLE,
                                   lambda fd, mask: vides.v_dispatch())
        self.lead(0.6, 0.4)

    def follow(self, _editor, pose, frame, _reason, _user):
        """The camera in the editor has moved: this picture shows the same moment."""
        self.top.title(f"tk_flight: frame {frame:g}")
        self.draw(pose.contents)

    def drag(self, event):
        """The user leads the own camera."""
        self.lead(0.01 * event.x, 0.005 * event.y)

    def lead(self, turn, lean):
        """The own camera goes about the object, and stands in the editor as a ghost, which
        is what "take over the view" takes."""
        x, y, z = 1.6 * sin(turn) * cos(lean), 1.6 * sin(lean), 1.6 * cos(turn) * cos(lean)
        own = Pose((x, y, z), (-x, 0.2 - y, -z), (0, 1, 0), 30)
        vides.v_editor_set_view(self.editor, own)
        self.draw(own)

    def draw(self, pose):
        """The next picture."""
        self.canvas.delete("all")
        m = (c_double * 16)()
        vides.v_pose_matrix(byref(pose), 0, 0, m)  # V_AXES_OPENGL, from the world
        eye = [[sum(m[4 * k + row] * p[k] for k in range(3)) + m[12 + row] for row in range(3)]
               for p in XYZ]
        # The zoom is a focal length in mm of a camera with a picture 24 mm high.
        scale = pose.zoom / 24 * HEIGHT
        for ends in LINES:
            if all(eye[end][2] < -0.01 for end in ends):
                self.canvas.create_line(*(size / 2 + sign * eye[end][axis] / eye[end][2] * scale
                                          for end in ends
                                          for axis, size, sign in ((0, WIDTH, -1), (1, HEIGHT, 1))))


if __name__ == "__main__":
    Flight().top.mainloop()
