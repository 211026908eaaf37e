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
[-0.6108557238607547,