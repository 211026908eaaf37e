"""A camera flight for VTK 9 (`pip install vtk`), written by VIDES.

    python FILE           plays it in a window: Space stops and goes on, Left and Right step,
                          Home goes to the first picture, Q ends
    python FILE FOLDER    writes every picture there: 00001.png, 00002.png, ...

In a program of your own: import it, then pose(n) gives pose n, and set_pose(camera, n) moves a
vtkCamera there. They are counted from 1.
"""

import json
import math
import os
import sys
import time

import vtk

# A frame: position, view direction, up, focal length in mm of a picture 24 mm high.
# ---- data, JSON: nothing of it is run ----
DATA = r'''
{}
'''
# ---- end of data ----

FLIGHT = json.loads(DATA)
COUNT = len(FLIGHT["frames"])

# Whether the way of the camera is drawn.
SHOW_PATH = True
BACKGROUND, OBJECT_COLOUR, PATH_COLOUR = (0.1, 0.11, 0.13), (0.85, 0.85, 0.82), (0.95, 0.6, 0.2)


def pose(n):
    """Position, view direction, up and vertical angle of view in degrees of pose n, from 1 to COUNT."""
    if not 1 <= n <= COUNT:
        raise IndexError(f"there are poses 1 to {COUNT}, not {n}")
    row = FLIGHT["frames"][n - 1]
    return row[0:3], row[3:6], row[6:9], 2 * math.degrees(math.atan(12 / row[9]))


def set_pose(camera, n):
    """Moves a vtkCamera to pose n; what it turns about stays as far away as the flight is wide."""
    position, view, up, angle = pose(n)
    distance = FLIGHT["half_size"]
    camera.SetPosition(position)
    camera.SetFocalPoint([place + distance * part for place, part in zip(position, view)])
    camera.SetViewUp(up)
    camera.SetUseHorizontalViewAngle(False)
    camera.SetViewAngle(angle)


def poly_data(points, lines=(), triangles=()):
    """Points that belong to no line and no triangle are drawn as points."""
    places = vtk.vtkPoints()
    places.SetDataTypeToDouble()
    for point in points:
        places.InsertNextPoint(point)
    used = {corner for cells in (lines, triangles) for cell in cells for corner in cell}
    alone = [[corner] for corner in range(len(points)) if corner not in used]
    result = vtk.vtkPolyData()
    result.SetPoints(places)
    for cells, set_cells in ((alone, result.SetVerts), (lines, result.SetLines), (triangles, result.SetPolys)):
        array = vtk.vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), cell)
        set_cells(array)
    return result


def actor(data, colour, width):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    look = result.GetProperty()
    look.SetColor(colour)
    look.SetAmbient(0.2)
    look.SetLineWidth(width)
    look.SetPointSize(2 * width)
    return result


def scene():
    """A renderer with the object and the path."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(BACKGROUND)
    if "object" in FLIGHT:
        shape = FLIGHT["object"]
        data = poly_data(shape["points"], shape["lines"], shape["triangles"])
        renderer.AddActor(actor(data, OBJECT_COLOUR, 2))
    if SHOW_PATH:
        places = [row[0:3] for row in FLIGHT["frames"]]
        data = poly_data(places, [[n, n + 1] for n in range(COUNT - 1)])
        renderer.AddActor(actor(data, PATH_COLOUR, 1))
    return renderer


def show(renderer, n):
    set_pose(renderer.GetActiveCamera(), n)
    renderer.ResetCameraClippingRange()


def window_of(renderer):
    window = vtk.vtkRenderWindow()
    window.SetWindowName(FLIGHT["title"] or FLIGHT["camera"])
    window.AddRenderer(renderer)
    return window


def write_pictures(folder):
    renderer = scene()
    window = window_of(renderer)
    window.SetOffScreenRendering(True)
    window.SetSize(FLIGHT["size"])
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    os.makedirs(folder, exist_ok=True)
    for n in range(1, COUNT + 1):
        show(renderer, n)
        window.Render()
        grab.Modified()
        writer.SetFileName(os.path.join(folder, f"{n:05}.png"))
        writer.Write()


class Player:
    """Shows the poses in time: pictures are left out where drawing takes too long."""

    def __init__(self, renderer, window):
        self.renderer, self.window = renderer, window
        self.n, self.plays = 1, True
        self.start = time.monotonic()

    def go_to(self, n):
        self.n = min(max(n, 1), COUNT)
        self.start = time.monotonic() - (self.n - 1) / FLIGHT["fps"]
        self.draw()

    def draw(self):
        show(self.renderer, self.n)
        self.window.Render()

    def on_timer(self, *_):
        if self.plays:
            passed = (time.monotonic() - self.start) * FLIGHT["fps"]
            self.n = int(passed) % COUNT + 1
            self.draw()

    def on_key(self, interactor, _):
        key = interactor.GetKeySym()
        if key == "space":
            self.plays = not self.plays
            self.go_to(self.n)
        elif key in ("Left", "Right", "Home"):
            self.plays = False
            self.go_to({"Left": self.n - 1, "Right": self.n + 1, "Home": 1}[key])


def play():
    renderer = scene()
    window = window_of(renderer)
    width, height = FLIGHT["size"]
    smaller = min(1, 1280 / width, 720 / height)
    window.SetSize(max(round(width * smaller), 1), max(round(height * smaller), 1))
    interactor = vtk.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtk.vtkInteractorStyleTrackballCamera())
    player = Player(renderer, window)
    player.draw()
    interactor.Initialize()
    interactor.AddObserver("TimerEvent", player.on_timer)
    interactor.AddObserver("KeyPressEvent", player.on_key)
    interactor.CreateRepeatingTimer(max(round(1000 / FLIGHT["fps"]), 1))
    player.go_to(1)
    interactor.Start()


if __name__ == "__main__":
    if len(sys.argv) > 1:
        write_pictures(sys.argv[1])
    else:
        play()
