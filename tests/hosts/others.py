"""Drives programs of other people's making, patched by others.sh: others.py FOLDER [NAME...]

Each opens the editor when it starts. A point is dragged, the poses are handed over, and
the editor is closed while the program goes on: what is typed into it arrives. A second
time the program is ended with the editor open.
"""

import os
import sys
import time

from run import POSES, Stage, run
from harness import check, wait

PROOF = "proof.txt"
GAP = 1000
"""Milliseconds without a picture; one that waits for its own events shows none at all."""
TYPED = "the host goes on"
EDITED = "and it is used beside the editor"


class Editor:
    """A text editor: NEdit, l3afpad."""

    writes = False  # something all the time

    def __init__(self, command, title, quiet=None):
        self.command, self.title, self.quiet = command, title, quiet or command

    def prepare(self, folder):
        """A file to begin with."""
        with open(os.path.join(folder, PROOF), "w", encoding="ascii") as file:
            file.write("\n")

    def types(self, stage, text):
        """What is typed and saved is in the file."""
        stage.click_host()
        stage.server.focus(stage.host)
        stage.server.type(text)
        stage.server.xdotool("key", "ctrl+s")

    def leaves(self, stage):
        """Its own way out."""
        stage.server.press(stage.host, "ctrl+q")


class Terminal(Editor):
    """xterm, in which a shell runs. What is written there wakes its loop, and so would
    serve the editor by chance: it is used while something is written all the time, and
    left while nothing is."""

    writes = True

    def prepare(self, folder):
        """Nothing."""

    def types(self, stage, text):
        """A command for the shell."""
        stage.server.focus(stage.host)
        stage.server.type(f"echo {text} >{PROOF}\n")

    def leaves(self, stage):
        """The end of its shell."""
        stage.server.focus(stage.host)
        stage.server.type("exit\n")


SHELL = "(while sleep 0.03; do echo $((n += 1)); done) & sh; kill $!"
PROGRAMS = {
    "nedit": Editor(["nedit", PROOF], rf"^{PROOF}"),
    "xterm": Terminal(["xterm", "-T", "host", "-e", "sh", "-c", SHELL], "^host$",
                      ["xterm", "-T", "host", "-e", "sh"]),
    "l3afpad": Editor(["l3afpad", PROOF], rf"{PROOF}"),
}


def arrived(folder, text):
    """It is in the file."""
    def there():
        try:
            with open(os.path.join(folder, PROOF), encoding="ascii") as file:
                return text in file.read()
        except OSError:
            return False

    wait(there, f"{text!r} in the host's file")


def begun(name, programs, folder, quiet=False):
    """The program and its editor, which has handed over."""
    host = PROGRAMS[name]
    host.prepare(folder)
    stage = Stage(folder, programs, host.quiet if quiet else host.command, host.title)
    try:
        window = stage.server.new_window()
        stage.server.place(stage.host, 1230, 500)
        check(stage.hand_over(window) == POSES, "other poses")
    except BaseException:
        stage.end()
        raise
    return host, stage, window


def ended(stage):
    """As it ends by itself."""
    status = stage.program.ends()
    check(status == 0, f"exit status {status}")
    check(not stage.complaints(), f"it complained: {stage.complaints()}")


def used(name, programs, folder):
    """The whole way; the editor goes first."""
    host, stage, window = begun(name, programs, folder)
    server = stage.server
    try:
        pictures, gap = stage.pace(lambda: stage.drag(window))
        if host.writes:
            check(pictures >= 10 and gap <= GAP, f"{pictures} pictures, {gap} ms without one")
        check(stage.hand_over(window) != POSES, "the drag changed nothing")
        host.types(stage, EDITED)
        arrived(folder, EDITED)
        server.press(window, "ctrl+z")
        check(stage.hand_over(window) == POSES, "other poses after undo")
        server.press(window, "ctrl+q")
        server.gone(window)
        host.types(stage, TYPED)
        arrived(folder, TYPED)
        time.sleep(0.3)
        host.leaves(stage)
        ended(stage)
    except Exception:
        server.picture().save(os.path.join(programs, f"failed-{name}.png"))
        raise
    finally:
        stage.end()
    return f"used and left; {pictures} pictures during the drag"


def left(name, programs, folder):
    """The program goes first."""
    host, stage, window = begun(name, programs, folder, quiet=True)
    try:
        stage.drag(window)
        check(stage.hand_over(window) != POSES, "the drag changed nothing")
        host.leaves(stage)
        ended(stage)
        stage.server.gone(window)
    finally:
        stage.end()


def drive(name, programs, folder):
    """One program, both ways."""
    folders = [os.path.join(folder, way) for way in ("used", "left")]
    for one in folders:
        os.mkdir(one)
    said = used(name, programs, folders[0])
    left(name, programs, folders[1])
    return said


if __name__ == "__main__":
    sys.exit(run(PROGRAMS, drive))
