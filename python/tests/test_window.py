"""The window, on an X server without a screen, and where there is none."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator

import pytest

import vides

from .conftest import until


def test_without_a_display_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    for display in (None, ":4711", "nonsense"):
        if display is None:
            monkeypatch.delenv("DISPLAY", raising=False)
        else:
            monkeypatch.setenv("DISPLAY", display)
        with pytest.raises(vides.Error) as caught:
            vides.edit(vides.Path())
        assert caught.value.kind == "display" and str(caught.value)
    assert vides.Path().sample().array.shape == (121, 10)
    with pytest.raises(TypeError):
        vides.edit(vides.Path(), on_view=3)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def display() -> Iterator[str]:
    ours, its = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(its), "-screen", "0", "1600x1000x24", "-nolisten", "tcp", "-noreset"],
        pass_fds=[its],
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    os.close(its)
    with os.fdopen(ours) as number:
        yield f":{number.readline().strip()}"
    server.terminate()
    server.wait()


@pytest.fixture
def at(display: str, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("DISPLAY", display)
    return display


def window() -> str:
    """The window, when it is there."""
    search = ["xdotool", "search", "--onlyvisible", "--name", "VIDES"]
    return str(until(lambda: subprocess.run(search, capture_output=True, text=True).stdout.split(), "a window")[-1])


def press(*keys: str) -> None:
    """Keys for the window, when it is there."""
    subprocess.run(["xdotool", "windowfocus", "--sync", window(), "key", *keys], check=True, timeout=120)


def interrupt(after: Callable[[], bool] = lambda: True) -> None:
    """Ctrl-C, when the window is there, and this is true."""

    def begin() -> None:
        window()
        until(after, "what is to be before Ctrl-C")
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=begin, daemon=True).start()


class Done(Exception):
    pass


def test_it_tells_what_the_user_sees_and_ends_by_an_exception(at: str) -> None:
    path = vides.Path()
    told: list[tuple[int, float, str]] = []

    def on_view(samples: vides.Samples, reason: str) -> None:
        told.append((len(samples), float(samples.frames[0]), reason))
        if len(path.points) == 3:
            raise Done

    threading.Thread(target=press, args=("Insert",), daemon=True).start()
    with pytest.raises(Done):
        vides.edit(path, on_view)
    assert told and all(count == 1 for count, _, _ in told)
    # What the user did is in the path, as a step.
    assert len(path.points) == 3
    assert path.undo() and path == vides.Path()


def test_others_run_while_it_is_open(at: str) -> None:
    counted = 0
    stop = threading.Event()

    def count() -> None:
        nonlocal counted
        while not stop.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()

    def on_view(samples: vides.Samples, reason: str) -> None:
        pass

    counts: list[int] = []

    def has_counted() -> bool:
        counts.append(counted)
        return counted > counts[0] + 200

    interrupt(has_counted)
    with pytest.raises(KeyboardInterrupt):
        vides.edit(vides.Path(), on_view)
    stop.set()
    thread.join()
    # And another one opens and closes.
    interrupt()
    with pytest.raises(KeyboardInterrupt):
        vides.edit()


def test_a_closed_window_gives_the_path(at: str) -> None:
    program = """
import vides
path = vides.edit(vides.Path())
print(len(path.points))
"""
    editor = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    press("Insert", "ctrl+q")
    output, _ = editor.communicate(timeout=120)
    assert output == "3\n" and editor.returncode == 0


def test_a_lost_server_is_an_error() -> None:
    ours, its = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(its), "-nolisten", "tcp"], pass_fds=[its], stderr=subprocess.DEVNULL)
    os.close(its)
    with os.fdopen(ours) as number:
        name = f":{number.readline().strip()}"
    def kill() -> None:
        window()
        server.kill()

    old = os.environ.get("DISPLAY")
    os.environ["DISPLAY"] = name
    threading.Thread(target=kill, daemon=True).start()
    try:
        with pytest.raises(vides.Error) as caught:
            vides.edit(vides.Path())
    finally:
        os.environ.pop("DISPLAY")
        if old is not None:
            os.environ["DISPLAY"] = old
        server.wait()
    assert caught.value.kind == "display"
