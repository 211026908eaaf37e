"""A camera flight for ParaView, written by VIDES.

Run it in ParaView (View > Python Shell > Run Script, or as a macro) or by pvpython: the active
view's camera flies when the animation is played. The object is shown if the flight has one.
`vides convert` reads this file again, by its data alone.
"""

import json
import math

from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

# A frame: position, view direction, up, focal length in mm of a picture 24 mm high, distance of the
# focal point.
# ---- data, JSON: nothing of it is run ----
DATA = r'''
{
"title": "Around the pyramid",
"camera": "camera",
"unit": "",
"up": "y",
"half_size": 1.0,
"fps": 25.0,
"first_frame": 1,
"size": [1920, 1080],
"object": {
"points": [
[0.3, 0.0, 0.3],
[0.3, 0.0, -0.3],
[-0.3, 0.0, -0.3],
[-0.3, 0.0, 0.3],
[0.3, 0.0, 0.3],
[0.0, 0.5, 0.0],
[0.3, 0.0, -0.3],
[-0.3, 0.0, -0.3],
[0.0, 0.5, 0.0],
[-0.3, 0.0, 0.3]],
"lines": [
[0, 1],
[1, 2],
[2, 3],
[3, 4],
[4, 5],
[5, 6],
[7, 8],
[8, 9]],
"triangles": []
},
"frames": [
[-0.6, 0.2, 0.8, 0.5746957711326908, 0.2873478855663454, -0.7662610281769211, -0.17240873133980722, 0.9578262852211513, 0.22987830845307633, 24.0, 1.044030650891055],
[-0.6054501685311959, 0.20151846675194, 0.7917765533201963, 0.5819024172137609, 0.2868727018642599, -0.7609820167164805, -0.1742561281790743, 0.9579687118716872, 0.2278831912777653, 24.0, 1.0404668388046665],
[-0.6108557238607547, 0.20303365278349453, 0.7835231096457472, 0.5890952206148568, 0.2863875199908474, -0.755611679000679, -0.17608504010462803, 0.9581138702646423, 0.22585807547630335, 24.0, 1.0369388555269314]
]
}
'''
# ---- end of data ----

# With more frames a table does the same in less time and memory.
MOST_KEYS = 1000

# ParaView runs this beside the animation, with ROWS and VIEW filled in. All its scripts share their
# names, so max and min may be those of numpy.
TABLE = """
from paraview import simple as vides_simple

vides_rows = ROWS


def start_cue(self):
    pass


def tick(self):
    start, end = self.GetStartTime(), self.GetEndTime()
    share = (self.GetAnimationTime() - start) / (end - start) if end > start else 0
    row = vides_rows[int(share * (len(vides_rows) - 1) + 0.5)]
    views = [view for view in vides_simple.GetRenderViews() if view.GetGlobalID() == VIEW]
    view = views[0] if views else vides_simple.GetActiveView()
    view.CameraPosition, view.CameraFocalPoint = row[0:3], row[3:6]
    view.CameraViewUp, view.CameraViewAngle = row[6:9], row[9]


def end_cue(self):
    pass
"""


def rows_of(frames):
    """Position, focal point, up and vertical angle of view in degrees."""
    for row in frames:
        position, view, up, (zoom, distance) = row[0:3], row[3:6], row[6:9], row[9:11]
        focal_point = [place + distance * part for place, part in zip(position, view)]
        yield [*position, *focal_point, *up, 2 * math.degrees(math.atan(12 / zoom))]


def key_frame(row, time):
    key = simple.CameraKeyFrame()
    key.KeyTime = time
    key.Position, key.FocalPoint, key.ViewUp, key.ViewAngle = row[0:3], row[3:6], row[6:9], row[9]
    return key


def fly_by_keys(rows, view):
    cue = simple.GetCameraTrack(view=view)
    cue.Mode = "Interpolate Camera"
    # Of one frame the second key is the same.
    last = max(len(rows) - 1, 1)
    keys = rows if len(rows) > 1 else 2 * rows
    cue.KeyFrames = [key_frame(row, n / last) for n, row in enumerate(keys)]


def fly_by_table(rows, view, scene):
    cue = simple.PythonAnimationCue()
    cue.Script = TABLE.replace("ROWS", repr(rows), 1).replace("VIEW", str(view.GetGlobalID()), 1)
    scene.Cues.append(cue)


def show_object(shape, view):
    """Points that belong to no line and no triangle are drawn as points."""
    source = simple.TrivialProducer(registrationName="object")
    producer = source.GetClientSideObject()
    if producer is None:
        # The data lie with a server.
        simple.Delete(source)
        return
    places = vtkPoints()
    places.SetDataTypeToDouble()
    for point in shape["points"]:
        places.InsertNextPoint(point)
    data = vtkPolyData()
    data.SetPoints(places)
    used = {corner for kind in ("lines", "triangles") for cell in shape[kind] for corner in cell}
    alone = [[corner] for corner in range(len(shape["points"])) if corner not in used]
    kinds = ((alone, data.SetVerts), (shape["lines"], data.SetLines), (shape["triangles"], data.SetPolys))
    for cells, set_cells in kinds:
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), cell)
        set_cells(array)
    producer.SetOutput(data)
    source.UpdatePipeline()
    simple.Show(source, view)


def frame_seconds(fps):
    """A frame's time with so few bits that ParaView, which adds it up, meets the end exactly."""
    part, power = math.frexp(1 / fps)
    return math.ldexp(round(math.ldexp(part, 32)), power - 32)


def main():
    flight = json.loads(DATA)
    rows = list(rows_of(flight["frames"]))
    simple._DisableFirstRenderCameraReset()
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = flight["size"]
    view.CameraParallelProjection = 0
    if "object" in flight:
        show_object(flight["object"], view)
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = len(rows)
    # Data with times of their own keep them: the flight is as long as they are.
    if len(simple.GetTimeKeeper().TimestepValues or []) < 2:
        scene.StartTime = 0.0
        scene.EndTime = max(len(rows) - 1, 1) * frame_seconds(flight["fps"])
    if len(rows) <= MOST_KEYS:
        fly_by_keys(rows, view)
    else:
        fly_by_table(rows, view, scene)
    scene.GoToFirst()


main()
