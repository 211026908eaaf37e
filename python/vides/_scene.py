"""A scene: cameras, objects and lights on one timeline."""

from __future__ import annotations

import difflib
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple, SupportsFloat

import numpy as np
import numpy.typing as npt

from . import _vides
from ._applied import native_of
from ._arrays import Array, Vector, axis, corners, doubles, frozen, number, str_of, str_or_none, vector
from ._error import Error, Invalid, NoName
from ._files import choices, path_of
from ._objects import Object, given
from ._path import Path
from ._properties import NodeProperties
from ._samples import Samples
from ._shaped import Axis

if TYPE_CHECKING:
    from typing_extensions import Self

Extrapolation = Literal["hold", "repeat", "pingpong", "offset"]

_WIDTHS = {"position": 3, "rotation": 4, "scale": 3, "pivot": 3, "colour": 3, "cone": 2}
"""How many numbers a value of a node has."""

_BLIND = ("group", "object")
"""Kinds of nodes without a viewing direction."""


class Keys(NamedTuple):
    """The keys of one channel of a node."""

    channel: str
    """The channel: ``"position"``, ``"rotation"``, …"""
    interpolation: str
    """The interpolation between keys."""
    frames: Array
    """(k,): the frames of the keys."""
    values: Array
    """(k, m): the values of the keys."""


class State(NamedTuple):
    """A node at a frame.

    ``matrix`` (4, 4) is from node to world coordinates, for column vectors. In a camera's
    coordinates x is left, y up and z *forward*, the convention ``"vides"`` of
    :meth:`Samples.matrices`; for OpenGL's use ``scene.sample(…).poses.matrices("opengl")``.
    ``pose`` (10,) of cameras and lights is a row as in :class:`Samples`; of other nodes it is NaN.
    ``visible`` is whether the node and all its parents are visible. Lights and objects have a
    ``colour`` (linear red, green, blue), lights ``intensity`` and ``cone`` (half angles in degrees).
    """

    matrix: Array
    """(4, 4): from node to world coordinates; a camera's z is forward."""
    pose: Array
    """(10,): for cameras and lights a row as in :class:`Samples`; otherwise NaN."""
    visible: bool
    """Whether the node and all its parents are visible."""
    colour: tuple[float, float, float]
    """For lights and objects: linear red, green, blue."""
    intensity: float
    """For lights."""
    cone: tuple[float, float]
    """For lights: half angles in degrees, inner and outer."""


class Motion(NamedTuple):
    """A node at several frames.

    ``frames`` is (n,). ``matrices`` (n, 4, 4) are from node to world coordinates, for column
    vectors. In a camera's coordinates x is left, y up and z *forward*, the convention ``"vides"``;
    the default of ``poses.matrices()`` is OpenGL's. ``poses`` are :class:`Samples`, NaN unless the
    node is a camera or a light.
    """

    frames: Array
    """(n,)."""
    matrices: Array
    """(n, 4, 4): from node to world coordinates; a camera's z is forward."""
    poses: Samples
    """For a camera or light; otherwise NaN."""


class Node(NodeProperties):
    """A node of a scene, found by its name.

    Its values without keys are attributes: ``position`` (3,), ``rotation`` (4,) w x y z, ``scale``
    (3,), ``pivot`` (3,), ``visible``; of cameras ``zoom`` (mm), ``roll`` (degrees), ``near`` and
    ``far``; of lights and objects ``colour`` (linear red, green, blue); of lights ``intensity``
    and ``cone`` (degrees). ``aim`` and ``parent`` are names of other nodes; assign a name or a node.

    >>> scene = Scene()
    >>> ball = scene.add("ball", "object")
    >>> ball.position = (0, 1, 0)
    >>> ball.position
    array([0., 1., 0.])
    >>> ball.set_keys("position", [1, 50], [[0, 1, 0], [2, 1, 0]], "linear")
    >>> scene.evaluate(25.5)["ball"].matrix[:3, 3]
    array([1., 1., 0.])
    """

    __slots__ = ("_owner", "_name")
    _owner: Scene
    _name: str

    def __init__(self, scene: Scene, name: str) -> None:
        object.__setattr__(self, "_owner", scene)
        object.__setattr__(self, "_name", name)

    @property
    def _at(self) -> int:
        return self._owner._native.find(self._name)

    @property
    def name(self) -> str:
        """Its name; assign an unused one to rename it."""
        return self._name

    @name.setter
    def name(self, name: str) -> None:
        self._owner._native.rename(self._at, str_of(name, "name"))
        object.__setattr__(self, "_name", name)

    @property
    def kind(self) -> str:
        """``"group"``, ``"object"``, ``"camera"``, ``"directional"``, ``"point"`` or ``"spot"``."""
        return self._owner._native.nodes()[self._at][1]

    @property
    def parent(self) -> str | None:
        """The name of its parent; assigning a node or its name keeps the node's place in the world."""
        return self._name_of(self._owner._native.nodes()[self._at][2])

    @parent.setter
    def parent(self, node: Node | str | None) -> None:
        self._set("parent", self._owner._find(node, "parent"))

    @property
    def aim(self) -> str | None:
        """The name of the node at which a camera or light looks; assign a node or its name."""
        return self._name_of(self._owner._native.nodes()[self._at][3])

    @aim.setter
    def aim(self, node: Node | str | None) -> None:
        self._set("aim", self._owner._find(node, "aim"))

    @property
    def pivot(self) -> Array:
        """(3,): the place about which it turns and scales, in its own coordinates; read-only."""
        value: Array = self._get("pivot")
        return value

    @pivot.setter
    def pivot(self, value: npt.ArrayLike) -> None:
        self._put("pivot", value)

    @property
    def near(self) -> float:
        """Cameras: the distance of the near clipping plane, a length greater than 0."""
        value: float = self._get("near")
        return value

    @near.setter
    def near(self, value: SupportsFloat) -> None:
        self._put("near", value)

    @property
    def far(self) -> float:
        """Cameras: the distance of the far clipping plane, greater than :attr:`near`."""
        value: float = self._get("far")
        return value

    @far.setter
    def far(self, value: SupportsFloat) -> None:
        self._put("far", value)

    def _name_of(self, at: int | None) -> str | None:
        return None if at is None else self._owner._native.nodes()[at][0]

    def _set(self, name: str, value: object) -> None:
        self._owner._native.set_rest(self._at, str_of(name, "name"), value)

    def _get(self, name: str) -> Any:
        """A value without keys; several numbers are a read-only array."""
        value = self._owner._native.rest(self._at, str_of(name, "name"))
        if value is None:
            raise self._unknown(name)
        return frozen(value) if isinstance(value, list) else value

    def _put(self, name: str, value: Any) -> None:
        if str_of(name, "name") in _WIDTHS:
            self._set(name, doubles(value, (_WIDTHS[name],), name).tolist())
        elif name != "visible":
            self._set(name, number(value, name))
        elif isinstance(value, (bool, np.bool_)):
            self._set(name, bool(value))
        else:
            raise TypeError(f"visible must be True or False, not {type(value).__name__}")

    def _unknown(self, name: str) -> AttributeError:
        if hasattr(type(self), name):
            return AttributeError(f"{self.kind} {self._name!r} has no {name}", name=name, obj=self)
        return super()._unknown(name)

    def value(self, channel: str, frame: float) -> Array:
        """(m,): the value of a channel at a frame, with or without keys."""
        return np.array(self._owner._native.value(self._at, str_of(channel, "channel"), number(frame, "frame")))

    def set_keys(
        self,
        channel: str,
        frames: npt.ArrayLike,
        values: npt.ArrayLike,
        interpolation: str | None = None,
        *,
        shape: npt.ArrayLike = (),
        before: Extrapolation = "hold",
        after: Extrapolation = "hold",
    ) -> None:
        """Sets the keys of a channel, replacing those that it has.

        ``frames`` (k,) increase; ``values`` are (k, m), or (k,) if m is 1. m is 3 for ``"position"``,
        ``"scale"`` and ``"colour"``, 4 for ``"rotation"`` (w x y z), 2 for ``"cone"``, the number of
        shapes for ``"weights"``, and 1 for ``"zoom"``, ``"roll"``, ``"visible"``, ``"intensity"``
        and ``"aim_weight"``. ``interpolation`` is ``"step"``, ``"linear"``, ``"cubic"``,
        ``"catmull-rom"``, ``"hermite"`` (``shape``: tangents before and after each key, per frame), ``"tcb"``
        (``shape``: tension, continuity, bias of each key) and others; by default the smoothest that
        the channel allows: cubic, catmull-rom for rotations, step for ``"visible"``. ``before`` and
        ``after`` define the values beyond the keys.

        >>> lamp = Scene().add("lamp", "spot")
        >>> lamp.set_keys("rotation", [1, 25, 50], [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
        >>> lamp.keys[0].interpolation
        'catmull-rom'
        """
        at = doubles(frames, (None,), "frames")
        array = np.asanyarray(values)
        if array.ndim == 1:
            array = array[:, np.newaxis]
        numbers = doubles(array, (len(at), None), "values")
        more = doubles(np.asarray(shape, dtype=np.float64).ravel(), (None,), "shape")
        self._owner._native.set_keys(
            self._at,
            str_of(channel, "channel"),
            str_or_none(interpolation, "interpolation"),
            at,
            numbers,
            more,
            str_of(before, "before"),
            str_of(after, "after"),
        )

    def remove_keys(self, channel: str) -> None:
        """Removes the keys of a channel."""
        self._owner._native.remove_keys(self._at, str_of(channel, "channel"))

    @property
    def keys(self) -> list[Keys]:
        """All keys, channel by channel; copies."""
        return [
            Keys(channel, interpolation, np.array(frames), np.array(values).reshape(len(frames), -1))
            for channel, interpolation, frames, values in self._owner._native.tracks(self._at)
        ]

    @property
    def path(self) -> Path | None:
        """The path that it follows, a copy; ``None`` if it follows none. See :meth:`follow`."""
        try:
            return Path._of(self._owner._native.path(self._at))
        except Error as error:
            if error.kind == "argument":
                return None
            raise

    def follow(
        self, path: Path | None, start_frame: float = 1.0, beyond: Extrapolation = "hold"
    ) -> None:
        """Follows a path from a frame on; ``beyond`` is what happens before and after it."""
        native = None if path is None else native_of(path, "path")
        start = number(start_frame, "start_frame")
        self._owner._native.set_path(self._at, native, start, str_of(beyond, "beyond"))

    def set_mesh(self, mesh: Object, lines: npt.ArrayLike = ()) -> None:
        """Gives an object a mesh: a file (OBJ, PLY, STL, glTF), of which saving keeps the name, a mesh of
        trimesh or pyvista, or vertices (n, 3) and triangles (m, 3). ``lines`` (k, 2) are pairs of
        indices of the vertices, which a file has itself."""
        found = given(mesh)
        pairs = corners(lines, 2, "lines")
        if isinstance(found, str):
            if pairs:
                raise TypeError("the mesh of a file has its own lines")
            self._owner._native.load_mesh(self._at, found)
        else:
            self._owner._native.set_mesh(self._at, *found, pairs)

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """(m, 3): indices of an object's points; a copy."""
        return np.array(self._owner._native.triangles(self._at), dtype=np.uint32).reshape(-1, 3)

    def vertices(self, frame: float) -> Array:
        """(n, 3): an object's points at a frame, morphed and deformed, in its own coordinates."""
        return self._owner._native.vertices(self._at, number(frame, "frame"))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Node):
            return NotImplemented
        return other._owner is self._owner and other._name == self._name

    def __hash__(self) -> int:
        return hash((id(self._owner), self._name))

    def __reduce__(self) -> tuple[type[Node], tuple[Scene, str]]:
        return type(self), (self._owner, self._name)

    def __repr__(self) -> str:
        return f"<vides.Node {self._name!r}, {self.kind}>"


class Scene(Mapping[str, Node]):
    """A scene: a tree of named nodes, each with a position, keys or a path.

    >>> scene = Scene()
    >>> camera = scene.add("camera", "camera")
    >>> camera.follow(Path())
    >>> list(scene)
    ['camera']
    >>> scene.sample("camera", 1, 11).poses.positions[0]
    array([-0.6,  0.2,  0.8])
    """

    __slots__ = ("_native", "losses", "__weakref__")

    _native: _vides.Scene
    losses: tuple[str, ...]
    """What could not be imported, including warnings about meshes."""

    def __init__(self) -> None:
        self._native = _vides.Scene()
        self.losses = ()

    @classmethod
    def _of(cls, native: _vides.Scene, losses: Sequence[str] = ()) -> Self:
        scene = cls.__new__(cls)
        scene._native, scene.losses = native, tuple(losses)
        return scene

    @classmethod
    def of_path(cls, path: Path) -> Self:
        """A scene with one camera that follows a path."""
        return cls._of(native_of(path, "path").scene())

    @classmethod
    def load(cls, file: str | os.PathLike[str], format: str | None = None, **options: object) -> Self:
        """The scene in a ``.vid`` file or another program's; see :func:`options`."""
        of = str_or_none(format, "format")
        return cls._of(*_vides.Scene.load(path_of(file), of, choices(options)))

    @classmethod
    def from_str(cls, text: str) -> Self:
        """The scene in the text of a ``.vid`` file; mesh files named in it are not read."""
        return cls._of(_vides.Scene.from_text(str_of(text, "text")))

    def to_str(self) -> str:
        """The text of a ``.vid`` file."""
        return self._native.text()

    def save(self, file: str | os.PathLike[str], format: str | None = None, **options: object) -> list[str]:
        """Writes a ``.vid`` file or another program's; returns what the format cannot hold.

        Formats that prescribe an up axis rotate the world: see :meth:`Path.save`.
        """
        name = path_of(file)
        if format in (None, "vid") and name.endswith(".vid") and not options:
            self._native.save(name)
            return []
        return self._native.export(name, str_or_none(format, "format"), choices(options))

    def copy(self) -> Self:
        """An independent copy."""
        return type(self)._of(self._native.copy(), self.losses)

    __copy__ = copy

    def __deepcopy__(self, memo: object) -> Self:
        return self.copy()

    def __reduce__(self) -> tuple[Any, tuple[str], tuple[None, dict[str, Any]]]:
        return type(self).from_str, (self.to_str(),), (None, {"losses": self.losses})

    def add(self, name: str, kind: str = "group", parent: Node | str | None = None) -> Node:
        """Adds a node: ``"group"``, ``"object"``, ``"camera"``, or a light: ``"directional"``,
        ``"point"`` or ``"spot"``."""
        self._native.add(str_of(name, "name"), str_of(kind, "kind"), self._find(parent, "parent"))
        return Node(self, name)

    def _find(self, node: Node | str | None, what: str) -> int | None:
        """The index of a node, given itself or by its name; ``None`` for ``None``."""
        if isinstance(node, Node):
            if node._owner is not self:
                raise Invalid(f"{what}: node {node.name!r} is of another scene")
            return node._at
        return None if node is None else self._native.find(str_of(node, what))

    def __delitem__(self, node: Node | str) -> None:
        at = self._find(node, "node")
        if at is None:
            raise TypeError("a node must be named")
        self._native.remove(at)

    def __getitem__(self, name: Node | str) -> Node:
        if isinstance(name, Node):
            if name._owner is not self:
                raise NoName(f"node {name.name!r} is of another scene")
            return name
        names = list(self)
        if name not in names:
            near = difflib.get_close_matches(name, names, 1, 0.7) if isinstance(name, str) else []
            meant = f": is {near[0]!r} meant?" if near else f"; nodes are {', '.join(map(repr, names)) or 'none'}"
            raise NoName(f"there is no node {name!r}{meant}")
        return Node(self, name)

    def __iter__(self) -> Iterator[str]:
        return iter([node[0] for node in self._native.nodes()])

    def __len__(self) -> int:
        return len(self._native.nodes())

    @property
    def camera(self) -> str | None:
        """The name of the shown camera; assign a node, its name, or ``None``: the scene chooses one."""
        at = self._native.camera
        return None if at is None else self._native.nodes()[at][0]

    @camera.setter
    def camera(self, node: Node | str | None) -> None:
        self._native.camera = self._find(node, "camera")

    @property
    def frame_range(self) -> tuple[float, float]:
        """The first and the last frame; assign ``None`` to compute them from what moves."""
        return self._native.range

    @frame_range.setter
    def frame_range(self, frames: tuple[float, float] | None) -> None:
        if frames is not None:
            first, last = frames
            frames = number(first, "frame_range[0]"), number(last, "frame_range[1]")
        self._native.range = frames

    @property
    def fps(self) -> float:
        """Frames per second."""
        return self._native.fps

    @fps.setter
    def fps(self, fps: float) -> None:
        self._native.fps = number(fps, "fps")

    @property
    def up(self) -> str:
        """The up axis, ``"y"`` or ``"z"``."""
        return self._native.space()[2]

    def set_space(self, centre: Vector, half_size: float, up: Axis = "y") -> None:
        """Sets the cube in which the scene lies."""
        self._native.set_space(vector(centre, "centre"), number(half_size, "half_size"), axis(up))

    def evaluate(self, frame: float) -> dict[str, State]:
        """All nodes at a frame, by name. In a camera's matrix z is forward: see :class:`State`.

        >>> scene = Scene.of_path(Path())
        >>> scene.evaluate(1)["camera"].pose[:3]
        array([-0.6,  0.2,  0.8])
        """
        matrices, poses, (colours, intensities, cones, visible) = self._native.states(number(frame, "frame"))
        for at, node in enumerate(self._native.nodes()):
            if node[1] in _BLIND:
                poses[at] = np.nan
        return {
            name: State(
                matrices[at].reshape(4, 4),
                poses[at],
                visible[at],
                (colours[at][0], colours[at][1], colours[at][2]),
                intensities[at],
                (cones[at][0], cones[at][1]),
            )
            for at, name in enumerate(self)
        }

    def sample(
        self,
        node: Node | str | None = None,
        first: float | None = None,
        last: float | None = None,
        step: float = 1.0,
    ) -> Motion:
        """A node from frame ``first`` to ``last``, both included; by default the shown camera.

        The matrices of a camera have z forward (convention ``"vides"``); :meth:`Samples.matrices`
        of its poses returns those of OpenGL, OpenCV and ROS.

        >>> motion = Scene.of_path(Path()).sample()
        >>> bool(abs(motion.matrices - motion.poses.matrices("vides")).max() < 1e-12)
        True
        >>> Scene.of_path(Path()).sample(first=1, last=3).matrices.shape
        (3, 4, 4)
        """
        at = self._find(self.camera if node is None else node, "node")
        if at is None:
            raise Invalid("this scene has no camera: name a node")
        start, end = self.frame_range
        start = start if first is None else number(first, "first")
        end = end if last is None else number(last, "last")
        step = number(step, "step")
        if not (np.isfinite([start, end, step]).all() and step > 0 and start <= end):
            raise Invalid(f"frames {start:g} to {end:g} in steps of {step:g}: they must increase", "range")
        many = (end - start) / step
        if many >= 1e7:
            raise Invalid("more than 10000000 frames", "limit")
        count = int(np.floor(many + 1e-9)) + 1
        poses, matrices = np.empty((count, 10)), np.empty((count, 16))
        self._native.sample(at, start, step, poses, matrices)
        if self._native.nodes()[at][1] in _BLIND:
            poses.fill(np.nan)
        frames = start + step * np.arange(count, dtype=np.float64)
        samples = Samples._of(poses, self.fps, frames, self.up)
        return Motion(frames, matrices.reshape(count, 4, 4), samples)

    def path(self) -> Path:
        """The path that the shown camera follows, a copy."""
        return Path._of(self._native.path())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return NotImplemented
        return other is self or other.to_str() == self.to_str()

    __hash__: ClassVar[None] = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        first, last = self.frame_range
        return f"<vides.Scene: {len(self)} nodes, frames {first:g} to {last:g}>"
