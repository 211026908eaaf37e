"""What the tests share."""

import os
import signal
import time
from collections.abc import Callable, Iterator
from typing import TypeVar
from pathlib import Path as File

import pytest

MANY = bool(os.environ.get("VIDES_MANY"))
"""Whether the tests take their time: `make check-packages`."""


T = TypeVar("T")


def until(ask: Callable[[], T], what: str, seconds: float = 120.0) -> T:
    """Asks again and again until there is an answer: no test waits for a time. Long, since
    machines may be busy."""
    end = time.monotonic() + seconds
    while not (answer := ask()):
        assert time.monotonic() < end, f"waited too long for {what}"
        time.sleep(0.01)
    return answer


@pytest.fixture(autouse=True, scope="session")
def _ctrl_c() -> None:
    """What a shell begins in the background ignores Ctrl-C, and so would Python."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def _folder(tmp_path: File, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Files that are written by the way lie in a folder that goes."""
    monkeypatch.chdir(tmp_path)
    for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
        monkeypatch.setenv(name, str(tmp_path))
    yield
