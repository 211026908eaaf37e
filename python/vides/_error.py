"""The exceptions of this package."""

from __future__ import annotations

import errno
from typing import Any


class Error(Exception):
    """The call failed and changed nothing.

    Its ``str()`` is one sentence that names the place and the reason. Each error is also one of
    Python's: :class:`Invalid` a ``ValueError``, :class:`NoName` a ``KeyError``, :class:`NoIndex` an
    ``IndexError``, :class:`SystemRefused` an ``OSError``, :class:`NoFile` a
    ``FileNotFoundError``, :class:`NoMemory` a ``MemoryError``, :class:`NoDisplay` a
    ``RuntimeError``. As everywhere in Python, wrong types raise ``TypeError`` and unknown
    attributes ``AttributeError``.

    ``kind`` is ``"argument"``, ``"range"``, ``"limit"`` (too many), ``"memory"``, ``"io"`` (the
    system refused), ``"format"`` (a file's content) or ``"display"`` (no window). ``place`` (a
    file, a point or a key) and ``line`` (of a file, from 1) are ``None`` if unknown.

    >>> path = Path()
    >>> try:
    ...     path.points[1].zoom = 5000
    ... except ValueError as error:
    ...     print(error.kind, "-", error)
    range - zoom: zoom must lie between 1 and 2000
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

    def __reduce__(self) -> tuple[Any, ...]:
        # What is set later, such as errno, is kept.
        return type(self), (str(self), self.kind, self.place, self.line), self.__dict__ | _of_system(self)

    def __setstate__(self, state: dict[str, Any] | None) -> None:
        for name, value in (state or {}).items():
            setattr(self, name, value)


def _of_system(error: BaseException) -> dict[str, Any]:
    if not isinstance(error, OSError):
        return {}
    return {"errno": error.errno, "filename": error.filename}


class Invalid(Error, ValueError):
    """A value that is not allowed, or a file whose content is not."""


class SystemRefused(Error, OSError):
    """An error of the system."""


class NoFile(SystemRefused, FileNotFoundError):
    """A missing file."""


class NoIndex(Error, IndexError):
    """A missing point or orientation."""


class NoName(Error, KeyError):
    """A missing node."""


class NoMemory(Error, MemoryError):
    """Memory ran out."""


class NoDisplay(Error, RuntimeError):
    """No window can be shown."""


_KINDS: dict[str, type[Error]] = {"memory": NoMemory, "display": NoDisplay}
_MISSING: dict[str, type[Error]] = {"index": NoIndex, "name": NoName}


def error_of(
    sentence: str, kind: str, place: str | None, line: int | None, number: int | None, missing: str | None
) -> Error:
    """The exception for an error of the engine; ``number`` is the system's errno."""
    if missing is not None:
        return _MISSING[missing](sentence, kind, place, line)
    if kind != "io":
        return _KINDS.get(kind, Invalid)(sentence, kind, place, line)
    error = (NoFile if number == errno.ENOENT else SystemRefused)(sentence, kind, place, line)
    error.errno, error.filename = number, place
    return error
