"""Other programs' files."""

from __future__ import annotations

import os
from typing import NamedTuple

from . import _vides
from ._error import Error

class Format(NamedTuple):
    """A file format."""

    name: str
    """What ``format=``, ``source_format=`` and ``target_format=`` take."""
    title: str
    """In words."""
    endings: tuple[str, ...]
    """Endings of file names, without the dot."""
    reads: bool
    """Whether it is read."""
    writes: bool
    """Whether it is written."""


def formats() -> list[Format]:
    """All formats, in and out.

    >>> [format.name for format in formats() if format.reads and not format.writes]
    []
    >>> "nerfstudio" in [format.name for format in formats()]
    True
    """
    return [
        Format(name, title, tuple(endings), reads, writes)
        for name, title, endings, reads, writes in _vides.formats()
    ]


def options() -> dict[str, str]:
    """The options of :func:`convert` and of every ``save`` and ``load``, with what they do.

    >>> options()["scale"]
    "Lengths in the file for one of the path's [default: 1]"
    """
    return {name.replace("-", "_"): text for name, _, text in _vides.options()}


def choices(given: dict[str, object]) -> list[tuple[str, str]]:
    """Options as the engine takes them: names and texts."""
    return [
        (name.rstrip("_").replace("_", "-"), _text(name.rstrip("_"), value))
        for name, value in given.items()
        if value is not None
    ]


def _text(name: str, value: object) -> str:
    between = {"frames": "..", "size": "x"}.get(name)
    if between is not None and isinstance(value, (tuple, list)):
        return between.join(str(part) for part in value)
    if isinstance(value, bool) or not isinstance(value, (str, int, float)):
        try:
            # Numbers of numpy.
            value = float(value)  # type: ignore[arg-type]
        except (TypeError, ValueError):
            kind = type(value).__name__
            raise TypeError(f"{name} takes a number or a text, not {kind}") from None
    return str(value)


def convert(
    source: str | os.PathLike[str],
    target: str | os.PathLike[str],
    source_format: str | None = None,
    target_format: str | None = None,
    **options: object,
) -> list[str]:
    """Makes another program's file of one, as the command ``vides convert``.

    The formats are found by content and name unless they are given (:func:`formats`); the options
    are those of the command (:func:`options`), as ``fps=30``, ``frames=(1, 250)``,
    ``size=(1920, 1080)``, ``scale=0.01``, ``up="z"``, ``as_="path"``, ``tolerance=0.01``.

    Returns what the target cannot hold, a sentence each. ``target`` is replaced only when it is
    whole; a folder only with ``target_format="colmap"``. Where a format has an upright axis of its
    own (z: ``nerfstudio``, ``transforms``), the world is turned on writing, and stays so when the
    file is read again.

    >>> import tempfile, pathlib
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder, "flight.vid")
    ...     _ = Path().save(file)
    ...     convert(file, file.with_suffix(".tum"), target_format="tum")
    ['points, speeds and holds become poses, one a frame', 'the field of view is left out']
    """
    return _vides.convert(
        os.fspath(source), os.fspath(target), source_format, target_format, choices(options)
    )


def path_of(file: str | os.PathLike[str]) -> str:
    """A file's name as a text."""
    name = os.fspath(file)
    if not isinstance(name, str):
        raise TypeError("a file is named by a text or a pathlib.Path, not by bytes")
    if "\0" in name:
        raise Error("a file's name has no NUL in it")
    return name
