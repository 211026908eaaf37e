"""Frames of a film, rendered by pyvista."""

from __future__ import annotations

import pathlib
import sys
import time
from typing import Any, Protocol

from ._samples import Samples


class Plotter(Protocol):
    """What is used of ``pyvista.Plotter``."""

    @property
    def camera(self) -> Any: ...
    def reset_camera_clipping_range(self) -> object: ...
    def render(self) -> object: ...
    def screenshot(self, filename: pathlib.Path) -> object: ...


class _Bar:
    """A bar on standard error."""

    def __init__(self, frames: int) -> None:
        self.frames = frames
        self.began = time.monotonic()

    def show(self, done: int) -> None:
        share = done / self.frames
        rest = (time.monotonic() - self.began) * (1 / share - 1)
        full = round(40 * share)
        bar = "#" * full + "-" * (40 - full)
        end = "\n" if done == self.frames else ""
        print(f"\r[{bar}] {done}/{self.frames} frames, {rest:.0f} s left ", end=end, file=sys.stderr, flush=True)


def render(samples: Samples, plotter: Plotter, folder: pathlib.Path, progress: bool) -> list[pathlib.Path]:
    """Writes a picture a pose; returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    bar = _Bar(len(samples)) if progress else None
    written = []
    for number, (frame, pose, fov) in enumerate(zip(samples.frames, samples, samples.fov), 1):
        camera = plotter.camera
        camera.position = pose[0:3]
        camera.focal_point = pose[0:3] + pose[3:6]
        camera.up = pose[6:9]
        camera.view_angle = fov
        plotter.reset_camera_clipping_range()
        plotter.render()
        file = folder / f"{frame:05.0f}.png"
        plotter.screenshot(file)
        written.append(file)
        if bar is not None:
            bar.show(number)
    return written
