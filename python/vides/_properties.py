"""Made by tests/tables.py from the engine's table of properties: not to be edited."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, SupportsFloat, SupportsIndex

import numpy.typing as npt

from ._arrays import Array, Vector
from ._keyed import Keyed


class PathProperties(Keyed):
    """Properties of a whole path."""

    __slots__ = ()

    @property
    def title(self) -> str:
        """One line, at most 256 bytes.

        Text; by default "".
        """
        value: str = self._get("title")
        return value

    @title.setter
    def title(self, value: str | None) -> None:
        self._put("title", value)

    @property
    def comment(self) -> str:
        """Any lines, at most 65536 bytes.

        Text; by default "".
        """
        value: str = self._get("comment")
        return value

    @comment.setter
    def comment(self, value: str | None) -> None:
        self._put("comment", value)

    @property
    def fps(self) -> float:
        """Frames per second; greater than 0, at most 100000.

        Number; by default 25.0.
        """
        value: float = self._get("fps")
        return value

    @fps.setter
    def fps(self, value: SupportsFloat | None) -> None:
        self._put("fps", value)

    @property
    def first_frame(self) -> int:
        """Number of the first frame in the user's film.

        Whole number, -2147483648 to 2147483647; by default 1.
        """
        value: int = self._get("first_frame")
        return value

    @first_frame.setter
    def first_frame(self, value: SupportsIndex | None) -> None:
        self._put("first_frame", value)

    @property
    def closed(self) -> bool:
        """Whether one more segment leads from the last point to the first.

        Switch; by default false.
        """
        value: bool = self._get("closed")
        return value

    @closed.setter
    def closed(self, value: bool | None) -> None:
        self._put("closed", value)

    @property
    def curve(self) -> Literal["tcb", "centripetal", "chordal", "cubic", "linear"]:
        """How the curve leads through the points.

        One of "tcb", "centripetal", "chordal", "cubic", "linear"; by default "tcb".
        """
        value: Literal["tcb", "centripetal", "chordal", "cubic", "linear"] = self._get("curve")
        return value

    @curve.setter
    def curve(self, value: Literal["tcb", "centripetal", "chordal", "cubic", "linear"] | None) -> None:
        self._put("curve", value)

    @property
    def orientation_mode(self) -> Literal["tcb", "barry-goldman", "slerp"]:
        """How the camera turns.

        One of "tcb", "barry-goldman", "slerp"; by default "tcb".
        """
        value: Literal["tcb", "barry-goldman", "slerp"] = self._get("orientation_mode")
        return value

    @orientation_mode.setter
    def orientation_mode(self, value: Literal["tcb", "barry-goldman", "slerp"] | None) -> None:
        self._put("orientation_mode", value)

    @property
    def zoom_mode(self) -> Literal["smooth", "linear"]:
        """How the zoom runs.

        One of "smooth", "linear"; by default "smooth".
        """
        value: Literal["smooth", "linear"] = self._get("zoom_mode")
        return value

    @zoom_mode.setter
    def zoom_mode(self, value: Literal["smooth", "linear"] | None) -> None:
        self._put("zoom_mode", value)

    @property
    def base_speeds(self) -> dict[str, float]:
        """The base speeds.

        Four numbers.
        """
        value: dict[str, float] = self._parts("base_speeds")
        return value

    @base_speeds.setter
    def base_speeds(self, value: Mapping[str, float] | None) -> None:
        self._put("base_speeds", value)

    @property
    def presets(self) -> dict[str, dict[str, float]]:
        """The ten presets for tension, continuity and bias.

        Ten of tension, continuity, bias.
        """
        value: dict[str, dict[str, float]] = self._parts("presets")
        return value

    @presets.setter
    def presets(self, value: Mapping[str, Mapping[str, float]] | None) -> None:
        self._put("presets", value)


class PointProperties(Keyed):
    """Properties of a point."""

    __slots__ = ()

    @property
    def name(self) -> str | None:
        """A name for people; the engine does not read it.

        Text.
        """
        value: str | None = self._get("name")
        return value

    @name.setter
    def name(self, value: str | None) -> None:
        self._put("name", value)

    @property
    def preset(self) -> int:
        """Shape of the curve through this point: the number of a preset, or its own.

        Whole number, 0 to 9; by default 0.
        """
        value: int = self._get("preset")
        return value

    @preset.setter
    def preset(self, value: SupportsIndex | None) -> None:
        self._put("preset", value)

    @property
    def own(self) -> dict[str, float] | None:
        """Shape of the curve through this point: the number of a preset, or its own.

        Tension, continuity, bias.
        """
        value: dict[str, float] | None = self._get("own")
        return value

    @own.setter
    def own(self, value: Mapping[str, float] | None) -> None:
        self._put("own", value)

    @property
    def tangents(self) -> Any:
        """Tangents of its own, in place of those by the curve's kind and shape.

        Two vectors, before and after, in lengths.
        """
        value: Any = self._get("tangents")
        return value

    @tangents.setter
    def tangents(self, value: object) -> None:
        self._put("tangents", value)

    @property
    def keeps_motion(self) -> bool:
        """Whether these came of an insertion that keeps the motion: they are removed when the point or
        one beside it moves.

        Switch; by default false.
        """
        value: bool = self._get("keeps_motion")
        return value

    @keeps_motion.setter
    def keeps_motion(self, value: bool | None) -> None:
        self._put("keeps_motion", value)


class ViewProperties(Keyed):
    """Properties of an orientation."""

    __slots__ = ()

    @property
    def target(self) -> tuple[float, float, float] | None:
        """What the camera looks at.

        Place.
        """
        value: tuple[float, float, float] | None = self._get("target")
        return value

    @target.setter
    def target(self, value: Vector | None) -> None:
        self._put("target", value)

    @property
    def offset(self) -> tuple[float, float, float]:
        """What the camera looks at.

        Vector; by default [0.0, 0.0, -0.4].
        """
        value: tuple[float, float, float] = self._get("offset")
        return value

    @offset.setter
    def offset(self, value: Vector | None) -> None:
        self._put("offset", value)

    @property
    def roll(self) -> float:
        """Degrees in (−180, 180]: turns VUP about VPN.

        Number, in degrees; by default 0.0.
        """
        value: float = self._get("roll")
        return value

    @roll.setter
    def roll(self, value: SupportsFloat | None) -> None:
        self._put("roll", value)

    @property
    def zoom(self) -> float:
        """The focal length of a camera with a picture of 36×24 mm.

        Number, in mm, 1 to 2000; by default 24.0.
        """
        value: float = self._get("zoom")
        return value

    @zoom.setter
    def zoom(self, value: SupportsFloat | None) -> None:
        self._put("zoom", value)

    @property
    def turning(self) -> dict[str, float]:
        """Tension, continuity and bias of the turning.

        Tension, continuity, bias; by default { tension = 0.0, continuity = 0.0, bias = 0.0 }.
        """
        value: dict[str, float] = self._get("turning")
        return value

    @turning.setter
    def turning(self, value: Mapping[str, float] | None) -> None:
        self._put("turning", value)

    @property
    def hold(self) -> int:
        """Frames that the camera rests here before it goes on.

        Whole number, in frames, 0 to 1000000; by default 0.
        """
        value: int = self._get("hold")
        return value

    @hold.setter
    def hold(self, value: SupportsIndex | None) -> None:
        self._put("hold", value)

    @property
    def speed_curve(self) -> tuple[float, ...]:
        """The speed curve of the section that begins here, each 1…100.

        Ten numbers.
        """
        value: tuple[float, ...] = self._get("speed_curve")
        return value

    @speed_curve.setter
    def speed_curve(self, value: npt.ArrayLike | None) -> None:
        self._put("speed_curve", value)

    @property
    def ahead(self) -> float | None:
        """Looks along the way, not at its target: along the tangent (0), or so far ahead on the curve.

        Number, in lengths.
        """
        value: float | None = self._get("ahead")
        return value

    @ahead.setter
    def ahead(self, value: SupportsFloat | None) -> None:
        self._put("ahead", value)

    @property
    def up(self) -> Literal["axis", "minimal", "frenet", "y", "z"]:
        """Which way is up before the roll.

        One of "axis", "minimal", "frenet", "y", "z"; by default "axis".
        """
        value: Literal["axis", "minimal", "frenet", "y", "z"] = self._get("up")
        return value

    @up.setter
    def up(self, value: Literal["axis", "minimal", "frenet", "y", "z"] | None) -> None:
        self._put("up", value)

    @property
    def up_point(self) -> tuple[float, float, float] | None:
        """Which way is up before the roll.

        Place.
        """
        value: tuple[float, float, float] | None = self._get("up_point")
        return value

    @up_point.setter
    def up_point(self, value: Vector | None) -> None:
        self._put("up_point", value)

    @property
    def up_path(self) -> Any:
        """Which way is up before the roll.

        List of places with tangents.
        """
        value: Any = self._get("up_path")
        return value

    @up_path.setter
    def up_path(self, value: object) -> None:
        self._put("up_path", value)

    @property
    def frames(self) -> int:
        """Frames of the section that begins here, whatever its length; 0: by length.

        Whole number, in frames, 0 to 99999999; by default 0.
        """
        value: int = self._get("frames")
        return value

    @frames.setter
    def frames(self, value: SupportsIndex | None) -> None:
        self._put("frames", value)

    @property
    def locked(self) -> bool:
        """Whether that section keeps its frames where a whole is brought to a number of frames.

        Switch; by default false.
        """
        value: bool = self._get("locked")
        return value

    @locked.setter
    def locked(self, value: bool | None) -> None:
        self._put("locked", value)

    @property
    def curve_time(self) -> float | None:
        """Curve time of the section that begins here, in frames at speed 50, whatever its frames and its
        pace; none: as they have it.

        Number, in frames.
        """
        value: float | None = self._get("curve_time")
        return value

    @curve_time.setter
    def curve_time(self, value: SupportsFloat | None) -> None:
        self._put("curve_time", value)

    @property
    def ease(self) -> Any:
        """How the section that begins here goes through its time.

        Kind, rise, fall, cruise.
        """
        value: Any = self._get("ease")
        return value

    @ease.setter
    def ease(self, value: object) -> None:
        self._put("ease", value)

    @property
    def distance(self) -> Any:
        """How the section that begins here goes through its time.

        List of time and way.
        """
        value: Any = self._get("distance")
        return value

    @distance.setter
    def distance(self, value: object) -> None:
        self._put("distance", value)

    @property
    def pace_part(self) -> Any:
        """How the section that begins here goes through its time.

        Part of a pace.
        """
        value: Any = self._get("pace_part")
        return value

    @pace_part.setter
    def pace_part(self, value: object) -> None:
        self._put("pace_part", value)

    @property
    def velocity(self) -> Any:
        """Angular velocities, in place of those by tension, continuity and bias.

        Two vectors, reach and leave.
        """
        value: Any = self._get("velocity")
        return value

    @velocity.setter
    def velocity(self, value: object) -> None:
        self._put("velocity", value)

    @property
    def turning_part(self) -> Any:
        """How the section that begins here turns, if it is a part of a divided one; in the mode tcb.

        Part of a turning.
        """
        value: Any = self._get("turning_part")
        return value

    @turning_part.setter
    def turning_part(self, value: object) -> None:
        self._put("turning_part", value)

    @property
    def roll_slope(self) -> float | None:
        """Slope of the roll in tracked sections: degrees for each frame at speed 50.

        Number, in degrees.
        """
        value: float | None = self._get("roll_slope")
        return value

    @roll_slope.setter
    def roll_slope(self, value: SupportsFloat | None) -> None:
        self._put("roll_slope", value)

    @property
    def zoom_slope(self) -> float | None:
        """Slope of the zoom: mm for each frame at speed 50.

        Number, in mm.
        """
        value: float | None = self._get("zoom_slope")
        return value

    @zoom_slope.setter
    def zoom_slope(self, value: SupportsFloat | None) -> None:
        self._put("zoom_slope", value)


class NodeProperties(Keyed):
    """Values of a node without keys."""

    __slots__ = ()

    @property
    def position(self) -> Array:
        """In the parent's coordinates.

        Place, in lengths; by default [0.0, 0.0, 0.0].
        """
        value: Array = self._get("position")
        return value

    @position.setter
    def position(self, value: npt.ArrayLike) -> None:
        self._put("position", value)

    @property
    def rotation(self) -> Array:
        """Of any length but zero.

        Quaternion, w first; by default [1.0, 0.0, 0.0, 0.0].
        """
        value: Array = self._get("rotation")
        return value

    @rotation.setter
    def rotation(self, value: npt.ArrayLike) -> None:
        self._put("rotation", value)

    @property
    def scale(self) -> Array:
        """Factors along its own axes; negative ones mirror.

        Place; by default [1.0, 1.0, 1.0].
        """
        value: Array = self._get("scale")
        return value

    @scale.setter
    def scale(self, value: npt.ArrayLike) -> None:
        self._put("scale", value)

    @property
    def colour(self) -> Array:
        """Lights and objects: linear red, green, blue, each ≥ 0.

        Red, green, blue; by default [1.0, 1.0, 1.0].
        """
        value: Array = self._get("colour")
        return value

    @colour.setter
    def colour(self, value: npt.ArrayLike) -> None:
        self._put("colour", value)

    @property
    def cone(self) -> Array:
        """Lights: half angles, inner and outer, 0…90.

        Inner and outer angle, in degrees; by default [20.0, 30.0].
        """
        value: Array = self._get("cone")
        return value

    @cone.setter
    def cone(self, value: npt.ArrayLike) -> None:
        self._put("cone", value)

    @property
    def zoom(self) -> float:
        """Cameras: focal length, 1…2000.

        Number, in mm, 1 to 2000; by default 24.0.
        """
        value: float = self._get("zoom")
        return value

    @zoom.setter
    def zoom(self, value: SupportsFloat) -> None:
        self._put("zoom", value)

    @property
    def roll(self) -> float:
        """Cameras: turns up about the view.

        Number, in degrees; by default 0.0.
        """
        value: float = self._get("roll")
        return value

    @roll.setter
    def roll(self, value: SupportsFloat) -> None:
        self._put("roll", value)

    @property
    def intensity(self) -> float:
        """Lights: ≥ 0.

        Number, 0 to 1000000000; by default 1.0.
        """
        value: float = self._get("intensity")
        return value

    @intensity.setter
    def intensity(self, value: SupportsFloat) -> None:
        self._put("intensity", value)

    @property
    def aim_weight(self) -> float:
        """How far it turns to what it aims at.

        Number, 0 to 1; by default 1.0.
        """
        value: float = self._get("aim_weight")
        return value

    @aim_weight.setter
    def aim_weight(self, value: SupportsFloat) -> None:
        self._put("aim_weight", value)

    @property
    def visible(self) -> bool:
        """Hidden nodes hide their children.

        Switch; by default true.
        """
        value: bool = self._get("visible")
        return value

    @visible.setter
    def visible(self, value: bool) -> None:
        self._put("visible", value)
