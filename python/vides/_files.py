"""Other programs' files."""

from __future__ import annotations

import os
from typing import NamedTuple

from . import _vides
from ._arrays import str_or_none
from ._error import Invalid

class Format(NamedTuple):
    """A file format."""

    name: str
    """The value for ``format=``, ``source_format=`` and ``target_format=``."""
    title: str
    """A title for people."""
    endings: tuple[str, ...]
    """Extensions of file names, without the dot."""
    reads: bool
    """Whether it can be read."""
    writes: bool
    """Whether it can be written."""


def formats() -> list[Format]:
    """All formats that can be read or written.

    >>> [format.name for format in formats() if format.reads and not format.writes]
    ['record3d', 'polycam']
    >>> "nerfstudio" in [format.name for format in formats()]
    True
    """
    return [
        Format(name, title, tuple(endings), reads, writes)
        for name, title, endings, reads, writes in _vides.formats()
    ]


def options() -> dict[str, str]:
    """The options of :func:`convert` and of every ``save`` and ``load``, with their descriptions.

    >>> options()["scale"]
    "Lengths in the file for one of the path's [default: 1]"
    """
    return {name.replace("-", "_"): text for name, _, text in _vides.options()}


def choices(given: dict[str, object]) -> list[tuple[str, str]]:
    """Options as pairs of name and text, for the engine."""
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
            # For example, a number of numpy.
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
    """Converts a file to the format of another program, as ``vides convert`` does.

    By default the formats (:func:`formats`) are recognised by content and name. The options are
    those of the command (:func:`options`), such as ``fps=30``, ``frames=(1, 250)``,
    ``size=(1920, 1080)``, ``scale=0.01``, ``up="z"``, ``as_="path"``, ``tolerance=0.01``.

    Returns what the target cannot hold, a sentence each. ``target`` is replaced only when
    everything is written; it can be a folder only with ``target_format="colmap"``. Writing a format
    that prescribes an up axis (z: ``nerfstudio``, ``transforms``) rotates the world; reading the
    file does not rotate it back.

    >>> import tempfile, pathlib
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder, "flight.vid")
    ...     _ = Path().save(file)
    ...     convert(file, file.with_suffix(".tum"), target_format="tum")
    ['points, speeds and holds become poses, one a frame', 'the field of view is left out']
    """
    return _vides.convert(
        path_of(source),
        path_of(target),
        str_or_none(source_format, "source_format"),
        str_or_none(target_format, "target_format"),
        choices(options),
    )


def path_of(file: str | os.PathLike[str]) -> str:
    """The name of a file as a text."""
    name = os.fspath(file)
    if not isinstance(name, str):
        raise TypeError("a file name must be a text or a pathlib.Path, not bytes")
    if "\0" in name:
        raise Invalid("a file name must not contain NUL")
    return name
