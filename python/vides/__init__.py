"""VIDES plans camera paths: a few points in space, each with camera orientations, become every
camera pose in between.

>>> path = Path([[3, 1, 0], [0, 2, 3], [-3, 1, 0]], look_at=(0, 0, 0), frames=250)
>>> path.points[1].zoom = 50
>>> samples = path.sample()
>>> samples.positions.shape, samples.matrices("opengl").shape
((250, 3), (250, 4, 4))

World axes are right-handed; ``path.up`` is the up axis, y or z. Lengths are the world's, angles
are in degrees, zooms in mm of focal length for a picture of 36×24 mm (24: a vertical field of view
of 53°). Points and orientations count from 0, frames from 1.

:class:`Path` is one flight, :class:`Samples` its poses, :class:`Scene` everything that moves with
it; :func:`convert` converts files of other programs, :func:`edit` opens the window.
"""

import inspect as _inspect

from ._error import Error, Invalid, NoDisplay, NoFile, NoIndex, NoMemory, NoName, SystemRefused
from ._files import Format, convert, formats, options
from ._path import Path
from ._planned import Tour, progress, tour
from ._points import Orientation, Orientations, Point, Points, Section
from ._samples import Samples
from ._scene import Keys, Motion, Node, Scene, State
from ._told import SVG, Detour, Finding, FitReport, Framed, Property, Rest, Retimed, Steadied, properties
from ._window import edit

__version__ = "1.0.0"

__all__ = [
    "SVG",
    "Detour",
    "Error",
    "Finding",
    "FitReport",
    "Format",
    "Framed",
    "Invalid",
    "Keys",
    "Motion",
    "NoDisplay",
    "NoFile",
    "NoIndex",
    "NoMemory",
    "NoName",
    "Node",
    "Orientation",
    "Orientations",
    "Path",
    "Point",
    "Points",
    "Property",
    "Rest",
    "Retimed",
    "Samples",
    "Scene",
    "Section",
    "State",
    "Steadied",
    "SystemRefused",
    "Tour",
    "convert",
    "edit",
    "formats",
    "options",
    "progress",
    "properties",
    "tour",
]

# Errors and help show a class by its public name.
for _name in __all__:
    if _inspect.isclass(globals()[_name]):
        globals()[_name].__module__ = __name__
