"""vtk_flight: flies VTK's camera along the camera path, by Python's own ctypes.

The picture follows the editor beside it: what is dragged, scrubbed or played there is seen
here at once. The mouse leads the camera here as it always does in VTK; the editor shows
that as a ghost and takes it over into the path (Ctrl-Enter). Q ends the program.
"""

import ctypes
import math
from ctypes import (CFUNCTYPE, POINTER, c_char_p, c_double, c_int, c_size_t, c_uint, c_ulong,
                    c_void_p)

import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
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


OnView = CFUNCTYPE(None, c_void_p, POINTER(Pose), c_double, c_int, c_void_p)
OnCapture = CFUNCTYPE(c_int, c_void_p, POINTER(Pose), c_void_p)


class Options(ctypes.Structure):
    """V_EDITOR_OPTIONS."""
    _fields_ = [("size", c_size_t), ("title", c_char_p), ("file", c_char_p), ("path", c_void_p),
                ("object", POINTER(Mesh)), ("frames", c_double * 4), ("display", c_char_p),
                ("language", c_char_p), ("on_poses", c_void_p), ("on_close", c_void_p),
                ("user", c_void_p), ("space_centre", c_double * 3), ("space_half_size", c_double),
                ("space_up", c_int), ("on_view", OnView), ("on_change", c_void_p),
                ("on_capture", OnCapture), ("on_pane", c_void_p), ("host_name", c_char_p),
                ("parent", c_ulong), ("transient_for", c_ulong), ("application", c_char_p),
                ("hand_over_saves", c_int), ("on_frame", c_void_p), ("view", c_void_p),
                ("on_gone", c_void_p)]


vides = ctypes.CDLL("libvides.so.1")
vides.v_last_error.restype = c_char_p
vides.v_editor_open.argtypes = [POINTER(Options), POINTER(c_void_p)]
vides.v_editor_set_view.argtypes = [c_void_p, POINTER(Pose)]


def mesh(data):
    """The borders of the faces of a vtkPolyData, which the editor shows."""
    xyz = [x for i in range(data.GetNumberOfPoints()) for x in data.GetPoint(i)]
    ends = [cell.GetPointId((i + end) % cell.GetNumberOfPoints())
            for cell in map(data.GetCell, range(data.GetNumberOfCells()))
            for i in range(cell.GetNumberOfPoints()) for end in (0, 1)]
    return Mesh(size=ctypes.sizeof(Mesh), xyz=(c_double * len(xyz))(*xyz), points=len(xyz) // 3,
                lines=(c_uint * len(ends))(*ends), line_ends=len(ends))


# A house of 12 by 8 by 5 metres; the editor's space is in metres, too, and z is up.
house, mapper, actor = vtkCubeSource(), vtkPolyDataMapper(), vtkActor()
house.SetBounds(0, 12, 0, 8, 0, 5)
house.Update()
mapper.SetInputConnection(house.GetOutputPort())
actor.SetMapper(mapper)
actor.GetProperty().SetRepresentationToWireframe()
actor.GetProperty().LightingOff()
renderer, window, interactor = vtkRenderer(), vtkRenderWindow(), vtkRenderWindowInteractor()
renderer.AddActor(actor)
window.AddRenderer(renderer)
window.SetSize(480, 320)
window.SetWindowName("vtk_flight")
interactor.SetRenderWindow(window)
interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
camera = renderer.GetActiveCamera()


@OnView
def on_view(_editor, pose, frame, _reason, _user):
    """The camera in the editor has moved: this picture shows the same moment."""
    pose = pose.contents
    camera.SetPosition(pose.vrp)
    away = math.dist(pose.vrp, actor.GetCenter())  # about there the mouse turns the camera
    camera.SetFocalPoint([at + away * along for at, along in zip(pose.vrp, pose.vpn)])
    camera.SetViewUp(pose.vup)
    # The zoom is the focal length, in mm, of a camera with a picture 24 mm high.
    camera.SetViewAngle(math.degrees(2.0 * math.atan(12.0 / pose.zoom)))
    renderer.ResetCameraClippingRange()
    window.SetWindowName(f"vtk_flight: frame {frame:g}")
    window.Render()


def own_view():
    """VTK's camera. Its vectors may have any length."""
    zoom = 12.0 / math.tan(math.radians(camera.GetViewAngle()) / 2.0)
    return Pose(camera.GetPosition(), camera.GetDirectionOfProjection(), camera.GetViewUp(), zoom)


@OnCapture
def on_capture(_editor, pose, _user):
    """"Take over the view"."""
    pose[0] = own_view()
    return 1


options = Options(size=ctypes.sizeof(Options), title=b"vtk_flight", host_name=b"VTK",
                  object=ctypes.pointer(mesh(house.GetOutput())), on_view=on_view,
                  on_capture=on_capture, space_centre=(c_double * 3)(*actor.GetCenter()),
                  space_half_size=actor.GetLength(), space_up=2)  # V_UP_Z
editor = c_void_p()
interactor.Initialize()
if vides.v_editor_open(options, editor) != 0:
    raise SystemExit(vides.v_last_error().decode())
interactor.GetInteractorStyle().AddObserver(
    "InteractionEvent", lambda style, event: vides.v_editor_set_view(editor, own_view()))
interactor.AddObserver("TimerEvent", lambda caller, event: vides.v_dispatch())
interactor.CreateRepeatingTimer(10)  # milliseconds
interactor.Start()
