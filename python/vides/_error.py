"""The exceptions of this package."""

from __future__ import annotations

import errno


class Error(Exception):
    """The call failed and changed nothing.

    Its ``str()`` is one sentence that names the place and the reason. As everywhere in Python,
    wrong types raise ``TypeError``, indices beyond a sequence ``IndexError``, and unknown
    attributes ``AttributeError``. An error of the system is also an ``OSError``, a missing file
    also a ``FileNotFoundError``, a point that was removed also an ``IndexError``.

    ``kind`` is ``"argument"``, ``"range"``, ``"limit"`` (too many), ``"memory"``, ``"io"`` (the
    system refused), ``"format"`` (a file's content) or ``"display"`` (no window). ``place`` (a
    file, a point or a key) and ``line`` (of a file, from 1) are ``None`` if unknown.

    >>> path = Path()
    >>> try:
    ...     path.points[1].zoom = 5000
    ... except Error as error:
    ...     print(error.kind, "-", error)
    argument - zoom: zoom must lie between 1 and 2000
    """

    kind: str
    """The kind of error, one of the names above."""

    place: str | None
    """Where: file, point and key, as far as known, separated by ``": "``."""

    line: int | None
    """The line of a file, counted from 1."""

    def __init__(
        self,
        sentence: str,
        kind: str = "argument",
        place: str | None = None,
        line: int | None = None,
    ) -> None:
        # Arguments in the sentence may contain line breaks.
        super().__init__(" ".join(sentence.splitlines()))
        self.kind = kind
        self.place = place
        self.line = line

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[type[Error], tuple[str, str, str | None, int | None]]:
        return type(self), (str(self), self.kind, self.place, self.line)


class SystemRefused(Error, OSError):
    """An error of the system."""


class NoFile(SystemRefused, FileNotFoundError):
    """A missing file."""


class NoIndex(Error, IndexError):
    """A missing point or orientation."""


def error_of(
    sentence: str, kind: str, place: str | None, line: int | None, number: int | None, no_index: bool
) -> Error:
    """The exception for an error of the engine; ``number`` is the system's errno."""
    if no_index:
        return NoIndex(sentence, kind, place, line)
    if kind != "io":
        return Error(sentence, kind, place, line)
    error = (NoFile if number == errno.ENOENT else SystemRefused)(sentence, kind, place, line)
    error.errno, error.filename = number, place
    return error
