"""What the scripts for VTK show: each is run whole, and where it would write a picture the camera is noted.

With `picture` in the job everything is drawn and written as the script has it.
"""

import math
import os
import sys
import tempfile

import common
import vtkmodules.all as vtk

seen, windows, quick, wanted = [], [], [True], []


# The class behind vtkRenderWindow depends on the display.
Real = type(vtk.vtkRenderWindow())


@Real.override
class Window(Real):
    def Render(self):
        if not quick[0]:
            super().Render()


@vtk.vtkWindowToImageFilter.override
class Grab(vtk.vtkWindowToImageFilter):
    def SetInput(self, window):
        windows.append(window)
        super().SetInput(window)

    def Update(self, *rest):
        if not quick[0]:
            super().Update(*rest)

    def Modified(self):
        if not quick[0]:
            super().Modified()


def note():
    window = windows[-1]
    renderer = window.GetRenderers().GetFirstRenderer()
    camera = renderer.GetActiveCamera()
    width, height = window.GetSize()
    matrix = camera.GetModelViewTransformMatrix()
    away = [[matrix.GetElement(row, column) for column in range(4)] for row in range(4)]
    # The inverse of a turn and a shift: the transpose, and the place that goes to 0.
    turn = [[away[column][row] for column in range(3)] for row in range(3)]
    place = camera.GetPosition()
    frame = common.frame([[*turn[row], place[row]] for row in range(3)], -1)
    projection = camera.GetProjectionTransformMatrix(width / height, -1, 1)
    frame["fov"] = math.degrees(2 * math.atan(1 / projection.GetElement(1, 1)))
    if wanted:
        whole = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
        frame["pixels"] = []
        for point in wanted:
            x, y, _, w = whole.MultiplyPoint([*point, 1])
            frame["pixels"].append([(x / w + 1) / 2 * width, (1 - y / w) / 2 * height])
    seen.append(frame)


@vtk.vtkPNGWriter.override
class Writer(vtk.vtkPNGWriter):
    def Write(self):
        note()
        if not quick[0]:
            super().Write()


def work(job):
    seen.clear()
    windows.clear()
    wanted[:] = job.get("points", [])
    quick[0] = not job.get("picture")
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(job.get("picture") or folder)
        sys.argv = [job["file"], "."]
        try:
            with open(job["file"], encoding="utf-8") as file:
                program = compile(file.read(), job["file"], "exec")
            exec(program, {"__name__": "__main__", "__file__": job["file"]})
        finally:
            os.chdir(before)
    return {"frames": list(seen)}


common.run(work)
