"""What the functions of this package raise."""

from __future__ import annotations

import errno


class Error(Exception):
    """Something cannot be done; nothing was changed.

    ``str()`` of it is one sentence that names the place and the reason. Wrong types raise
    ``TypeError``, numbers beyond a sequence ``IndexError``, unknown attributes
    ``AttributeError``, as everywhere in Python. What the system refuses is an ``OSError`` too, a
    missing file a ``FileNotFoundError``, a point that is no longer there an ``IndexError``.

    ``kind`` is ``"argument"``, ``"range"``, ``"limit"`` (too many), ``"memory"``, ``"io"`` (the
    system refused), ``"format"`` (a file's content) or ``"display"`` (no window); ``place`` is a
    file, a point or a key, ``line`` a line of a file from 1; ``None`` where there is none.

    >>> path = Path()
    >>> try:
    ...     path.points[1].zoom = 5000
    ... except Error as error:
    ...     print(error.kind, "-", error)
    argument - zoom: zoom must lie between 1 and 2000
    """

    kind: str
    """``"argument"`` (makes no sense), ``"range"``, ``"limit"`` (too many), ``"memory"``, ``"io"``
    (the system refused), ``"format"`` (a file's content) or ``"display"`` (no window)."""

    place: str | None
    """Where: a file, a point, a key, as far as it is known; ``": "`` lies between."""

    line: int | None
    """The line of a file, counted from 1."""

    def __init__(
        self,
        sentence: str,
        kind: str = "argument",
        place: str | None = None,
        line: int | None = None,
    ) -> None:
        # What was given may have lines; the sentence is one.
        super().__init__(" ".join(sentence.splitlines()))
        self.kind = kind
        self.place = place
        self.line = line

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[type[Error], tuple[str, str, str | None, int | None]]:
        return type(self), (str(self), self.kind, self.place, self.line)


class SystemRefused(Error, OSError):
    """What the system refused."""


class NoFile(SystemRefused, FileNotFoundError):
    """A file that is not there."""


class NoIndex(Error, IndexError):
    """A point or an orientation that is not there."""


def error_of(
    sentence: str, kind: str, place: str | None, line: int | None, number: int | None, no_index: bool
) -> Error:
    """The error for what the engine says; ``number`` is the system's."""
    if no_index:
        return NoIndex(sentence, kind, place, line)
    if kind != "io":
        return Error(sentence, kind, place, line)
    error = (NoFile if number == errno.ENOENT else SystemRefused)(sentence, kind, place, line)
    error.errno, error.filename = number, place
    return error
