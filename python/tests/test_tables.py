"""Attributes and tools are those of the engine's tables."""

import inspect
import pydoc
import re
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest

import vides
from vides import _vides

from . import tables

OWNERS = {"path": vides.Path, "point": vides.Point, "view": vides.Orientation, "node": vides.Node}


@pytest.mark.parametrize("name", tables.FILES)
def test_what_is_made_from_the_tables_is_current(name: str) -> None:
    there = File(vides.__file__).with_name(name).read_text()
    assert there == tables.FILES[name](), "python -m tests.tables python/vides makes it anew"


@pytest.mark.parametrize("row", vides.properties(), ids=lambda row: f"{row.owner}.{row.key}")
def test_each_property_is_a_documented_attribute(row: vides.Property) -> None:
    name = re.sub("_(mm|degrees|frames)$", "", row.key)
    member = inspect.getattr_static(OWNERS[row.owner], name)
    assert isinstance(member, property) and member.fset is not None
    text = pydoc.plain(pydoc.render_doc(getattr(OWNERS[row.owner], name)))
    if (row.owner, name) in tables.BY_HAND:
        return
    assert " ".join(row.does.split()) in " ".join(text.split())
    assert row.unit in text
    if row.range is not None:
        assert f"{row.range[0]:.12g} to {row.range[1]:.12g}" in text
    assert name in dir(OWNERS[row.owner])


def test_help_shows_unit_and_range() -> None:
    text = pydoc.plain(pydoc.render_doc(vides.Point.zoom))
    assert "focal length" in text and "in mm, 1 to 2000; by default 24.0" in text


def test_each_tool_is_a_method() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 1], [2, 1, 0], [1, 2, 3]], look_at=(0.5, 0.5, 9), frames=60)
    mesh = np.array([[0, 0, 90], [1, 0, 90], [0, 1, 90], [0, 0, 91]]), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    for name, does, is_move, block, rows in _vides.tools():
        called = tables.OTHERWISE.get(name, name.replace("-", "_"))
        if called == "":
            continue
        method = getattr(vides if called == "tour" else vides.Path, called)
        if name in tables.OTHERWISE:
            assert method.__doc__
            continue
        assert does.split(" from a file")[0][1:] in method.__doc__
        for row in rows:
            placed = is_move and row[0] in ("put", "fit")
            assert placed or f"``{row[0]}" in method.__doc__, row
        if is_move:
            around = method(object=mesh, fps=30)
            assert around.frame_count == 300 and around.fps == 30 and np.isfinite(around.sample().array).all()
            # It lies about the middle of the object, which is far from the space of a new path.
            assert np.linalg.norm(around.sample().positions - [0.5, 0.5, 90.5], axis=1).max() < 4
            assert len(around.object_points) > 0 and method().frame_count > 1
            continue
        twin = path.copy()
        wider = np.linspace(0, 2, 4)
        needed: dict[str, list[Any]] = {
            "move": [(1, 2, 3)],
            "free-form": [np.stack(np.meshgrid(wider, wider, wider, indexing="ij"), axis=-1)],
            "blend": [path],
        }
        method(twin, *needed.get(name, []))
        assert twin.frame_count >= 1
        if name != "blend":
            assert twin != path and twin.undo() and twin == path and not twin.undo(), name


def test_points_of_tools_count_from_0() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]])
    path.move((0, 1, 0), first=1, last=2)
    np.testing.assert_array_equal(path.positions[:, 1], [0, 1, 1, 0])
    path.move((0, 1, 0), first=-1)
    np.testing.assert_array_equal(path.positions[:, 1], [0, 1, 1, 1])
    with pytest.raises(IndexError, match="there is no point 4: there are 4, counted from 0"):
        path.move((0, 1, 0), first=4)
    with pytest.raises(vides.Error, match="2.*1") as raised:
        path.move((0, 1, 0), first=2, last=1)
    assert "3" not in str(raised.value)


def test_a_move_is_where_it_is_put() -> None:
    path = vides.Path.orbit(around=(1, 2, 3), radius=5, height=0, turns=1, seconds=4, fps=50, zoom=35)
    poses = path.sample()
    assert path.frame_count == 200 and (poses.zoom == 35).all()
    np.testing.assert_allclose(np.linalg.norm(poses.positions - [1, 2, 3], axis=1), 5, rtol=1e-6)
    upright = vides.Path.orbit(up="z")
    assert upright.up == "z" and np.ptp(upright.sample().positions[:, 2]) < 1e-9
    crane = vides.Path.crane(radius=2, height=0, end_height=4).sample().positions
    assert crane[-1, 1] - crane[0, 1] == pytest.approx(4)
    dolly = vides.Path.dolly_zoom(around=(0, 0, 0), distance=4, end_distance=2, zoom=60, rise=0).sample()
    np.testing.assert_allclose(dolly.zoom / np.linalg.norm(dolly.positions, axis=1), 15, rtol=1e-9)
