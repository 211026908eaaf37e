"""Writes ``vides/_properties.py`` and ``vides/_tools.py`` from the engine's tables:
``python -m tests.tables python/vides`` in ``python``, with the wheel installed."""

import keyword
import re
import sys
import textwrap
from pathlib import Path

from vides import _vides

# What is written by hand, since it is more than a value.
BY_HAND = {("point", "position")}

# Tools that are functions with results of their own; "draw" needs a pointer.
OTHERWISE = {
    "draw": "", "insert": "insert_path", "extract": "__getitem__", "frames": "set_frames", "retime": "retime",
    "steady": "steady", "avoid": "avoid", "picture": "keep_in_picture", "tour": "tour", "fit": "fit",
}  # fmt: skip

# What is read and what may be set, by the kind in the table.
TYPES = {
    "number": ("float", "SupportsFloat"),
    "whole number": ("int", "SupportsIndex"),
    "switch": ("bool", "bool"),
    "text": ("str", "str"),
    "place": ("tuple[float, float, float]", "Vector"),
    "vector": ("tuple[float, float, float]", "Vector"),
    "ten numbers": ("tuple[float, ...]", "npt.ArrayLike"),
    "tension, continuity, bias": ("dict[str, float]", "Mapping[str, float]"),
    "four numbers": ("dict[str, float]", "Mapping[str, float]"),
    "ten of tension, continuity, bias": ("dict[str, dict[str, float]]", "Mapping[str, Mapping[str, float]]"),
}

OWNERS = {
    "path": ("PathProperties", "Properties of a whole path."),
    "point": ("PointProperties", "Properties of a point."),
    "view": ("ViewProperties", "Properties of an orientation."),
    "node": ("NodeProperties", "Values of a node without keys."),
}


def types(owner: str, kind: str, new: str) -> tuple[str, str]:
    """The types of a property when it is read and when it is set."""
    if owner == "node" and kind not in ("number", "switch"):
        return "Array", "npt.ArrayLike"
    if kind.startswith('"'):
        name = f"Literal[{kind}]"
        return name, f"{name} | None"
    read, written = TYPES.get(kind, ("Any", "object"))
    if read == "Any":
        return read, written
    return (read if new else f"{read} | None"), (written if owner == "node" else f"{written} | None")


def documentation(does: str, kind: str, unit: str, span: tuple[float, float] | None, new: str) -> list[str]:
    """Meaning, and kind, unit, range and default."""
    said = "one of " + kind if kind.startswith('"') else kind
    said = said[0].upper() + said[1:]
    said += f", in {unit}" if unit else ""
    said += f", {span[0]:.12g} to {span[1]:.12g}" if span else ""
    default = f"; by default {new}" if new and len(new) < 60 else ""
    lines = textwrap.wrap(does, 95)
    text = textwrap.wrap(f"{said}{default}.", 95)
    return ['        """' + lines[0], *(" " * 8 + line for line in lines[1:]), "",
            *(" " * 8 + line for line in text), '        """']  # fmt: skip


def properties() -> str:
    """The text of ``vides/_properties.py``."""
    out = ['"""Made by tests/tables.py from the engine\'s table of properties: not to be edited."""', "",
           "from __future__ import annotations", "", "from collections.abc import Mapping",
           "from typing import Any, Literal, SupportsFloat, SupportsIndex", "", "import numpy.typing as npt", "",
           "from ._arrays import Array, Vector", "from ._keyed import Keyed"]  # fmt: skip
    for owner, (name, about) in OWNERS.items():
        out += ["", "", f"class {name}(Keyed):", f'    """{about}"""', "", "    __slots__ = ()"]
        for of, key, does, kind, unit, span, new in _vides.keys():
            bare = re.sub("_(mm|degrees|frames)$", "", key)
            if of != owner or (owner, bare) in BY_HAND:
                continue
            read, written = types(owner, kind, new)
            get = "_parts" if kind.startswith(("four", "ten of")) else "_get"
            out += ["", "    @property", f"    def {bare}(self) -> {read}:"]
            out += documentation(does, kind, unit, span, new)
            out += [f'        value: {read} = self.{get}("{bare}")', "        return value", "",
                    f"    @{bare}.setter", f"    def {bare}(self, value: {written}) -> None:",
                    f'        self._put("{bare}", value)']  # fmt: skip
    return "\n".join(out) + "\n"


def argument(row: tuple[str, str, list[str], bool, str, int, float], required: bool) -> tuple[str, str, str]:
    """A parameter with type and default; its name; its line of documentation."""
    name, does, choices, switch, unit, width, default = row
    name += "_" if keyword.iskeyword(name) else ""
    what = f"``{name}``"
    if name in ("first", "last"):
        at = 0 if name == "first" else -1
        return f"{name}: int = {at}", name, f"{what}: {does}, from 0"
    if choices:
        names = ", ".join(f'"{choice}"' for choice in choices)
        chosen = f'"{choices[int(default)]}"'
        return f"{name}: Literal[{names}] = {chosen}", name, f"{what}: {does}: {names}"
    if switch:
        return f"{name}: bool = {bool(default)}", name, f"{what}: {does}"
    if width > 1:
        shape = "(3,)" if width == 3 else "(4, 4, 4, 3)"
        kind = "Vector" if width == 3 else "npt.ArrayLike"
        return f"{name}: {kind}" + ("" if required else " | None = None"), name, f"{what} {shape}: {does}"
    if unit == "lengths":
        return f"{name}: float | None = None", name, f"{what}: {does}, a length"
    kind, number = ("int", f"{default:.0f}") if unit == "count" else ("float", f"{default}")
    counted = "" if unit in ("", "count") else f", in {unit}"
    return f"{name}: {kind} = {number}", name, f"{what}: {does}{counted}"


def method(name: str, does: str, is_move: bool, block: bool, rows: list[tuple[str, str, list[str], bool, str, int, float]]) -> list[str]:
    """A method for a tool."""
    rows = [row for row in rows if not (is_move and row[0] in ("put", "fit"))]
    made = [argument(row, not is_move) for row in rows]
    own = [one for one in made if one[1] not in ("first", "last", "with_targets")]
    shared = [one for one in made if one not in own]
    called = name.replace("-", "_")
    given = ", ".join(f'"{row[0]}": {one[1]}' for row, one in zip(rows, made))
    lines = [one[2] for one in made]
    if is_move:
        head = f"A new path {'that ' * does.startswith('turns')}{does}."
        lines += ["``object``: what it goes round, from which lengths and middle are taken by default; else the "
                  "space of a new path", "``up``: the up axis, by default the object's or ``\"y\"``", "``fps``: frames per second"]  # fmt: skip
        arguments = ["cls", "*", *(one[0] for one in made), "object: Object | None = None", "up: Axis | None = None", "fps: float = 25.0"]
        out = ["", "    @classmethod", f"    def {called}(", *(f"        {one}," for one in arguments), "    ) -> Self:"]
        body = f'        return cls._made("{name}", {{{given}}}, object, up, fps)'
    else:
        head = f"{does[0].upper()}{does[1:].replace(' from a file', '')}, as one undo step."
        arguments = ["self", *(["other: Path"] if block else []), *(one[0] for one in own), *(["*"] if shared else []), *(one[0] for one in shared)]
        out = ["", f"    def {called}(", *(f"        {one}," for one in arguments), "    ) -> None:"]
        body = f'        self._apply("{name}", {{{given}}}' + (", other)" if block else ")")
    listed = [line for one in lines for line in textwrap.wrap(f"- {one}", 95, subsequent_indent="  ")]
    out += [f'        """{head}', *([""] if listed else []), *(" " * 8 + line for line in listed), '        """', body]
    return out


def tools() -> str:
    """The text of ``vides/_tools.py``."""
    out = ['"""Made by tests/tables.py from the engine\'s table of tools: not to be edited."""', "",
           "from __future__ import annotations", "", "from typing import TYPE_CHECKING, Literal", "",
           "import numpy.typing as npt", "", "from ._applied import Applied", "from ._arrays import Vector",
           "from ._objects import Object", "", "if TYPE_CHECKING:", "    from typing_extensions import Self", "",
           "    from ._path import Path", "    from ._shaped import Axis", "", "", "class Tools(Applied):",
           '    """Ready-made moves, which are new paths, and tools, which change a path."""', "", "    __slots__ = ()"]  # fmt: skip
    for name, does, is_move, block, rows in _vides.tools():
        if name not in OTHERWISE:
            out += method(name, does, is_move, block, rows)
    return "\n".join(out) + "\n"


FILES = {"_properties.py": properties, "_tools.py": tools}

if __name__ == "__main__":
    for file, text in FILES.items():
        Path(sys.argv[1], file).write_text(text())
