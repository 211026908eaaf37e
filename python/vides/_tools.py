"""Made by tests/tables.py from the engine's table of tools: not to be edited."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy.typing as npt

from ._applied import Applied
from ._arrays import Vector
from ._objects import Object

if TYPE_CHECKING:
    from typing_extensions import Self

    from ._path import Path
    from ._shaped import Axis


class Tools(Applied):
    """Ready-made moves, which are new paths, and tools, which change a path."""

    __slots__ = ()

    @classmethod
    def orbit(
        cls,
        *,
        around: Vector | None = None,
        radius: float | None = None,
        height: float | None = None,
        from_: float = 0.0,
        turns: float = 1.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path on a circle round a target.

        - ``around`` (3,): the place in the middle of the view
        - ``radius``: distance from the axis, a length
        - ``height``: how far above the target the camera is, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``turns``: number of turns; negative: clockwise from above
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("orbit", {"around": around, "radius": radius, "height": height, "from": from_, "turns": turns, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def spiral(
        cls,
        *,
        around: Vector | None = None,
        radius: float | None = None,
        height: float | None = None,
        from_: float = 0.0,
        turns: float = 1.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        end_radius: float | None = None,
        end_height: float | None = None,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path round a target with another radius and height at the end.

        - ``around`` (3,): the place in the middle of the view
        - ``radius``: distance from the axis, a length
        - ``height``: how far above the target the camera is, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``turns``: number of turns; negative: clockwise from above
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``end_radius``: the radius at the end, a length
        - ``end_height``: the height at the end, a length
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("spiral", {"around": around, "radius": radius, "height": height, "from": from_, "turns": turns, "zoom": zoom, "seconds": seconds, "end_radius": end_radius, "end_height": end_height}, object, up, fps)

    @classmethod
    def arc(
        cls,
        *,
        around: Vector | None = None,
        radius: float | None = None,
        height: float | None = None,
        from_: float = -45.0,
        to: float = 45.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path on a part of a circle, from one heading to another.

        - ``around`` (3,): the place in the middle of the view
        - ``radius``: distance from the axis, a length
        - ``height``: how far above the target the camera is, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``to``: heading at which it ends, in degrees
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("arc", {"around": around, "radius": radius, "height": height, "from": from_, "to": to, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def flyby(
        cls,
        *,
        around: Vector | None = None,
        distance: float | None = None,
        height: float | None = None,
        from_: float = 0.0,
        length: float | None = None,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path straight past a target that stays in view.

        - ``around`` (3,): the place in the middle of the view
        - ``distance``: least distance, seen from above, a length
        - ``height``: how far above the target the camera is, a length
        - ``from_``: heading of the camera when it is nearest, in degrees
        - ``length``: length of the path, a length
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("flyby", {"around": around, "distance": distance, "height": height, "from": from_, "length": length, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def approach(
        cls,
        *,
        around: Vector | None = None,
        distance: float | None = None,
        end_distance: float | None = None,
        from_: float = 0.0,
        rise: float = 15.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path straight towards a target.

        - ``around`` (3,): the place in the middle of the view
        - ``distance``: how far from the target it begins, a length
        - ``end_distance``: how far from the target it ends, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``rise``: how steeply the camera is above the target, in degrees
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("approach", {"around": around, "distance": distance, "end_distance": end_distance, "from": from_, "rise": rise, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def dolly_zoom(
        cls,
        *,
        around: Vector | None = None,
        distance: float | None = None,
        end_distance: float | None = None,
        from_: float = 0.0,
        rise: float = 15.0,
        zoom: float = 60.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path towards a target that keeps its size in the picture.

        - ``around`` (3,): the place in the middle of the view
        - ``distance``: how far from the target it begins, a length
        - ``end_distance``: how far from the target it ends, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``rise``: how steeply the camera is above the target, in degrees
        - ``zoom``: focal length at the beginning, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("dolly-zoom", {"around": around, "distance": distance, "end_distance": end_distance, "from": from_, "rise": rise, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def crane(
        cls,
        *,
        around: Vector | None = None,
        radius: float | None = None,
        height: float | None = None,
        end_height: float | None = None,
        from_: float = 0.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path straight up or down beside a target that stays in view.

        - ``around`` (3,): the place in the middle of the view
        - ``radius``: distance from the axis, a length
        - ``height``: how far above the target it begins, a length
        - ``end_height``: how far above the target it ends, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("crane", {"around": around, "radius": radius, "height": height, "end_height": end_height, "from": from_, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def pan(
        cls,
        *,
        at: Vector | None = None,
        from_: float = -45.0,
        to: float = 45.0,
        tilt: float = 0.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path that turns on the spot.

        - ``at`` (3,): where the camera stands
        - ``from_``: heading of the first view, in degrees
        - ``to``: heading of the last view, in degrees
        - ``tilt``: how far it looks up, in degrees
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("pan", {"at": at, "from": from_, "to": to, "tilt": tilt, "zoom": zoom, "seconds": seconds}, object, up, fps)

    @classmethod
    def figure_eight(
        cls,
        *,
        around: Vector | None = None,
        radius: float | None = None,
        height: float | None = None,
        width: float | None = None,
        from_: float = 0.0,
        zoom: float = 24.0,
        seconds: float = 10.0,
        object: Object | None = None,
        up: Axis | None = None,
        fps: float = 25.0,
    ) -> Self:
        """A new path on an eight that lies before the target.

        - ``around`` (3,): the place in the middle of the view
        - ``radius``: how far from the axis it crosses itself, a length
        - ``height``: how far above the target the camera is, a length
        - ``width``: how wide it is, twice as wide as deep, a length
        - ``from_``: heading at which the camera begins, in degrees
        - ``zoom``: focal length, in mm
        - ``seconds``: duration; 0: by its length, in seconds
        - ``object``: what it goes round, from which lengths and middle are taken by default; else the
          space of a new path
        - ``up``: the up axis, by default the object's or ``"y"``
        - ``fps``: frames per second
        """
        return cls._made("figure-eight", {"around": around, "radius": radius, "height": height, "width": width, "from": from_, "zoom": zoom, "seconds": seconds}, object, up, fps)

    def move(
        self,
        by: Vector,
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Moves points, as one undo step.

        - ``by`` (3,): by how much
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("move", {"by": by, "first": first, "last": last, "with_targets": with_targets})

    def turn(
        self,
        axis: Literal["x", "y", "z"] = "y",
        angle: float = 90.0,
        about: Literal["middle", "origin", "point", "target"] = "middle",
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Rotates points about an axis, as one undo step.

        - ``axis``: the axis: "x", "y", "z"
        - ``angle``: by which angle, in degrees
        - ``about``: the fixed point: "middle", "origin", "point", "target"
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("turn", {"axis": axis, "angle": angle, "about": about, "first": first, "last": last, "with_targets": with_targets})

    def scale(
        self,
        factor: float = 0.5,
        about: Literal["middle", "origin", "point", "target"] = "middle",
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Scales points, as one undo step.

        - ``factor``: by which factor
        - ``about``: the fixed point: "middle", "origin", "point", "target"
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("scale", {"factor": factor, "about": about, "first": first, "last": last, "with_targets": with_targets})

    def mirror(
        self,
        axis: Literal["x", "y", "z"] = "x",
        about: Literal["middle", "origin", "point", "target"] = "middle",
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Mirrors points along an axis, as one undo step.

        - ``axis``: the axis: "x", "y", "z"
        - ``about``: the fixed point: "middle", "origin", "point", "target"
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("mirror", {"axis": axis, "about": about, "first": first, "last": last, "with_targets": with_targets})

    def taper(
        self,
        axis: Literal["x", "y", "z"] = "y",
        r0: float = 1.0,
        r1: float = 0.5,
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Makes one end of the points' box narrower, as one undo step.

        - ``axis``: the axis: "x", "y", "z"
        - ``r0``: how wide it is at one end
        - ``r1``: how wide it is at the other
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("taper", {"axis": axis, "r0": r0, "r1": r1, "first": first, "last": last, "with_targets": with_targets})

    def bulge(
        self,
        axis: Literal["x", "y", "z"] = "y",
        a: float = 2.0,
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Makes the middle of the points' box wider, as one undo step.

        - ``axis``: the axis: "x", "y", "z"
        - ``a``: how wide it is in the middle
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("bulge", {"axis": axis, "a": a, "first": first, "last": last, "with_targets": with_targets})

    def twist(
        self,
        axis: Literal["x", "y", "z"] = "y",
        angle: float = 90.0,
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Twists the points' box about an axis, as one undo step.

        - ``axis``: the axis: "x", "y", "z"
        - ``angle``: by which angle, in degrees
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("twist", {"axis": axis, "angle": angle, "first": first, "last": last, "with_targets": with_targets})

    def bend(
        self,
        axis: Literal["x", "y", "z"] = "y",
        angle: float = 90.0,
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Bends the points' box along an axis, as one undo step.

        - ``axis``: the axis: "x", "y", "z"
        - ``angle``: by which angle, in degrees
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("bend", {"axis": axis, "angle": angle, "first": first, "last": last, "with_targets": with_targets})

    def free_form(
        self,
        lattice: npt.ArrayLike,
        *,
        first: int = 0,
        last: int = -1,
        with_targets: bool = False,
    ) -> None:
        """Deforms the points' box by 4 × 4 × 4 control points, as one undo step.

        - ``lattice`` (4, 4, 4, 3): one of 4 × 4 × 4 squares, and where it is in the box
        - ``first``: the first of the points, from 0
        - ``last``: the last of the points, from 0
        - ``with_targets``: what the cameras see moves with it
        """
        self._apply("free-form", {"lattice": lattice, "first": first, "last": last, "with_targets": with_targets})

    def blend(
        self,
        other: Path,
        weight: float = 0.5,
    ) -> None:
        """Blends the path with another path, as one undo step.

        - ``weight``: how much of the other path
        """
        self._apply("blend", {"weight": weight}, other)

    def reverse(
        self,
    ) -> None:
        """Reverses the path, as one undo step.
        """
        self._apply("reverse", {})

    def repeat(
        self,
        times: int = 2,
    ) -> None:
        """Repeats the path, as one undo step.

        - ``times``: how often
        """
        self._apply("repeat", {"times": times})
