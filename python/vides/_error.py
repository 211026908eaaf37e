"""What the functions of this package raise."""

from __future__ import annotations


class Error(Exception):
    """Something cannot be done; nothing was changed.

    ``str()`` of it is one sentence that names the place and the reason. Wrong types raise
    ``TypeError``, numbers beyond a sequence ``IndexError``, unknown attributes
    ``AttributeError``, as everywhere in Python.

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

    def __reduce__(self) -> tuple[type[Error], tuple[str, str, str | None, int | None]]:
        return type(self), (str(self), self.kind, self.place, self.line)
