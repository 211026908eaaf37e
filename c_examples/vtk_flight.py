"""vtk_flight: flies the camera path in a window of VTK, by Python's own ctypes.

A click into the window opens an editor, if none is open. The poses that the user hands
over (Alt-U) are played, 25 a second, round and round. Q ends the program.
"""

import ctypes
import math
from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkRenderWindowInteractor)


class Pose(ctypes.Structure):
    """V_POSE."""
    _fields_ = [("vrp", c_double * 3), ("vpn", c_double * 3), ("vup", c_double * 3),
                ("zoom", c_double)]


class Mesh(ctypes.Structure):
    """V_MESH."""
    _fields_ = [("size", c_size_t), ("xyz", POINTER(c_double)), ("points", c_size_t),
                ("rgb", c_void_p), ("lines", POINTER(c_uint)), ("line_ends", c_size_t),
                ("triangles", c_void_p), ("corners", c_size_t)]


OnPoses = CFUNCTYPE(None, c_void_p, POINTER(Pose), c_size_t, c_void_p)
OnClose = CFUNCTYPE(c_int, c_void_p, c_void_p)


class Options(ctypes.Structure):
    """V_EDITOR_OPTIONS."""
    _fields_ = [("size", c_size_t), ("title", c_char_p), ("file", c_char_p), ("path", c_void_p),
                ("object", POINTER(Mesh)), ("speeds", c_double * 4),
                ("display", c_char_p), ("language", c_char_p), ("on_poses", OnPoses),
                ("on_close", OnClose), ("user", c_void_p)]


vides = ctypes.CDLL("libvides.so.1")
vides.v_last_error.restype = c_char_p
vides.v_editor_open.argtypes = [POINTER(Options), POINTER(c_void_p)]
vides.v_editor_close.argtypes = [c_void_p]


def mesh(data):
    """The borders of the faces of a vtkPolyData, which the editor shows."""
    xyz = [x for i in range(data.GetNumberOfPoints()) for x in data.GetPoint(i)]
    ends = [cell.GetPointId((i + end) % cell.GetNumberOfPoints())
            for cell in map(data.GetCell, range(data.GetNumberOfCells()))
            for i in range(cell.GetNumberOfPoints()) for end in (0, 1)]
    return Mesh(size=ctypes.sizeof(Mesh), xyz=(c_double * len(xyz))(*xyz), points=len(xyz) // 3,
                lines=(c_uint * len(ends))(*ends), line_ends=len(ends))


class Flight:
    """The window and what it shows."""

    def __init__(self):
        cube, mapper, actor = vtkCubeSource(), vtkPolyDataMapper(), vtkActor()
        cube.SetBounds(-0.3, 0.3, 0.0, 0.4, -0.3, 0.3)
        cube.Update()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().SetRepresentationToWireframe()
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.renderer.AddActor(actor)
        self.window.AddRenderer(self.renderer)
        self.window.SetSize(480, 320)
        self.window.SetWindowName("vtk_flight")
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.editor, self.poses, self.now = c_void_p(), [], 0
        # ctypes forgets a function that nobody holds: these must live as long as the editor.
        self.mesh = mesh(cube.GetOutput())
        self.options = Options(size=ctypes.sizeof(Options), title=b"vtk_flight",
                               object=ctypes.pointer(self.mesh), on_poses=OnPoses(self.take),
                               on_close=OnClose(self.closed))

    def run(self):
        """Until the user has enough."""
        self.interactor.Initialize()
        self.interactor.AddObserver("LeftButtonPressEvent", self.edit)
        self.interactor.AddObserver("TimerEvent", self.tick)
        self.interactor.CreateRepeatingTimer(40)  # milliseconds
        self.interactor.Start()
        vides.v_editor_close(self.editor)

    def edit(self, _caller, _event):
        """Opens an editor."""
        if not self.editor and vides.v_editor_open(self.options, self.editor) != 0:
            raise SystemExit(vides.v_last_error().decode())

    def take(self, _editor, poses, count, _user):
        """The poses are the library's and go when this returns: copy them."""
        self.poses, self.now = [Pose.from_buffer_copy(pose) for pose in poses[:count]], 0
        print(count, "poses", flush=True)

    def closed(self, editor, _user):
        """The user closes the window: its handle goes, too."""
        vides.v_editor_close(editor)
        self.editor = c_void_p()
        return 1

    def tick(self, _caller, _event):
        """Serves the editor, then shows the next picture."""
        vides.v_dispatch()
        if self.poses:
            pose, camera = self.poses[self.now], self.renderer.GetActiveCamera()
            camera.SetPosition(pose.vrp)
            camera.SetFocalPoint([at + along for at, along in zip(pose.vrp, pose.vpn)])
            camera.SetViewUp(pose.vup)
            camera.SetViewAngle(math.degrees(2.0 * math.atan(12.0 / pose.zoom)))
            self.renderer.ResetCameraClippingRange()
            self.now = (self.now + 1) % len(self.poses)
        self.window.Render()


if __name__ == "__main__":
    Flight().run()
