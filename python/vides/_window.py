"""The editor in a window."""

from __future__ import annotations

import os
import select
from collections.abc import Callable

import numpy as np

from . import _vides
from ._arrays import str_or_none
from ._files import path_of
from ._path import Path
from ._samples import Samples

OnView = Callable[[Samples, str], object]
"""Called with one pose, its frame in ``frames``, and the reason: ``"edited"``, ``"scrubbed"``,
``"played"``, ``"selected"``, or ``"rested"`` when nothing moves any more."""

# How often to check for signals that another thread received, in milliseconds.
_SOMETIMES = 100.0


def edit(
    path: Path | str | os.PathLike[str] | None = None,
    on_view: OnView | None = None,
    *,
    title: str | None = None,
) -> Path:
    """Opens the editor's window, and returns the path when the window is closed.

    ``path`` is a path, which follows each of the user's steps (``path.undo()`` undoes one), or a
    ``.vid`` file to read; the default is a new path. ``on_view`` is called with the camera whenever
    the picture changes, at most sixty times a second. An exception in it closes the window and is
    raised here.

    Other threads run meanwhile; Ctrl-C closes the window. Without a display it raises
    :class:`Error` of the kind ``"display"``.
    """
    file: str | None = None
    if path is None:
        path = Path()
    elif not isinstance(path, Path):
        file = path_of(path)
        path = Path.load(file) if os.path.exists(file) else Path()
    if on_view is not None and not callable(on_view):
        raise TypeError("on_view is a function of a pose and a reason")
    fps, up = float(path.fps), path.up

    def view(row: np.ndarray[tuple[int, int], np.dtype[np.float64]], frame: float, reason: str) -> None:
        if on_view is not None:
            on_view(Samples._of(row, fps, np.array([frame]), up), reason)

    window = _vides.Window(path._native, None if on_view is None else view, file, str_or_none(title, "title"))
    try:
        poll = select.poll()
        poll.register(window.fileno(), select.POLLIN)
        while window.serve():
            wait = window.wait()
            poll.poll(_SOMETIMES if wait is None else min(wait, _SOMETIMES))
    finally:
        window.close()
    return path
