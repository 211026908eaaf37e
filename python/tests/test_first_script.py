"""The page for a first script runs from top to bottom."""

import pathlib
import re

import pytest


def test_the_page_runs(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = (pathlib.Path(__file__).parent.parent / "first-script.md").read_text(encoding="utf-8")
    programs = re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    assert len(programs) == 3
    monkeypatch.chdir(tmp_path)
    known: dict[str, object] = {}
    for program in programs:
        exec(program, known)  # noqa: S102
    assert (tmp_path / "orbit.vid").stat().st_size > 0
    assert (tmp_path / "orbit.html").stat().st_size > 0
