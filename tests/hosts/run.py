"""Drives hosts of other toolkits by mouse and keyboard: run.py FOLDER [-compiled] [NAME...]

Each program runs under an X server of its own. A click into its
window opens the editor; then a point is dragged while the host must go on drawing, the
poses are handed over, and the windows are closed both ways. Hosts that fly along are in
flights.py. FOLDER holds the programs
(build.sh); NAME chooses among them, -compiled leaves out those in Python.
"""

import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "x"))

import flights  # noqa: E402
from flights import POSES, START  # noqa: E402
from harness import Failure, Program, Server, check, wait  # noqa: E402
from space import first_look  # noqa: E402

EXAMPLES = os.path.join(HERE, "..", "..", "c_examples")
PYTHON = "/usr/bin/python3"  # the one that Debian's packages are for
GAP = 500
"""Milliseconds for which a host may show the same while the editor is used. On a machine
with nothing else to do it is 50 to 100; one that waits for events of its own shows the
same for as long as the drag takes, some seconds."""
DRAGS = 5
"""So often it may try: other programs hold it up once, what it waits for itself always."""
BAD = re.compile(r"vides|X Error|BadWindow|BadDrawable|BadMatch|Traceback|CRITICAL|Segmentation")


class Host:
    """How one of them is run and ended."""

    def __init__(self, command, title=None, leave="Escape", modal=None, edges=None, drivers=()):
        self.command, self.title, self.leave, self.modal = command, title, leave, modal
        # If it flies along: what it shows, and who drives it on which stage.
        self.edges, self.drivers = edges, drivers


def flight(command, title=None, **how):
    """A host that flies along."""
    how = {"edges": flights.PYRAMID, "drivers": [(flights.fly, {}), (flights.end_first, {})], **how}
    return Host(command, (title or command[0]) + "(: frame 1)?", **how)


HOSTS = {
    "gtk4": flight(["gtk_flight"]),
    "gtk3": Host(["gtk3"], modal="m"),
    "qt5": flight(["qt5_flight"], "qt_flight"),
    "qt6": flight(["qt6_flight"], "qt_flight"),
    "sdl": flight(["sdl_flight"]),
    "tk": flight([PYTHON, os.path.join(EXAMPLES, "tk_flight.py")], "tk_flight"),
    "tk-modal": flight([PYTHON, os.path.join(HERE, "tk_modal.py")], "tk_flight", modal="m"),
    "vtk": flight([PYTHON, os.path.join(EXAMPLES, "vtk_flight.py")], "vtk_flight", leave="q",
                  edges=flights.HOUSE),
    "gtk3-embedded": Host(["gtk_embedded"], drivers=[
        (flights.embedded, {"at": (10, 10)}),
        (flights.managed, {"at": (10, 10), "managed": True})]),
    "pane": Host(["glx_pane"], "VIDES.*", drivers=[(flights.pane, {"at": (10, 10)})]),
    "glut": Host(["glut"]),
    "fltk": Host(["fltk"], modal="m"),
    "wx": Host(["wx"], modal="m"),
    "motif": Host(["motif"], modal="m"),
    "xt-select": Host(["xt_select"]),
    "xt-pending": Host(["xt_select", "pending"]),
    "xt-both": Host(["xt_select", "both"]),
    "fortran": None,
}


class Stage:
    """A server and one program."""

    def __init__(self, folder, programs, command, title, at=(1250, 300), managed=False,
                 **variables):
        self.programs, self.folder, self.program = programs, folder, None
        self.vides = os.environ["VIDES"]  # the command
        self.server = Server(folder, options=("+extension", "GLX"))
        try:
            if managed:
                self.server.window_manager()
            # Without a bus and a configuration; drawn by the processor.
            env = dict(self.server.env, LIBGL_ALWAYS_SOFTWARE="1",
                       GSK_RENDERER="cairo", GDK_BACKEND="x11", QT_QPA_PLATFORM="xcb",
                       SDL_VIDEODRIVER="x11", GTK_A11Y="none", NO_AT_BRIDGE="1",
                       GSETTINGS_BACKEND="memory", XDG_RUNTIME_DIR=folder,
                       PYTHONDONTWRITEBYTECODE="1", LC_ALL="C.UTF-8", **variables)
            binary = os.path.join(programs, command[0])
            self.program = Program(folder, [binary if os.path.exists(binary) else command[0],
                                            *command[1:]], env, terminal=True)
            self.host = self.server.named(title)
            self.server.place(self.host, *at)
        except BaseException:
            self.end()
            raise

    def end(self):
        """Takes everything away."""
        if self.program:
            self.program.kill()
        self.server.end()

    def click_host(self):
        """Into the middle of its window."""
        _, _, width, height = self.server.geometry(self.host)
        self.server.xdotool("windowraise", self.host)
        self.server.click(self.host, width / 2, height / 2)

    def editor(self):
        """A click into the host opens the editor; where it lies shows all of it."""
        self.click_host()
        window = self.server.new_window()
        self.server.place(window, 10, 10)
        self.server.drawn(window)
        return window

    def hand_over(self, window):
        """The user does; how many poses the host says."""
        self.server.press(window, "alt+u")
        while True:
            line = self.program.expect("")
            found = re.search(r"(\d+) poses", line)
            if found:
                return int(found.group(1))

    def drag(self, window):
        """A point, there and back and a bit further, in about two seconds."""
        space = self.server.seen(window, first_look, "the space")
        at = space.image(START)
        words = ["mousemove", "--window", window, round(at[0]), round(at[1]), "mousedown", 3]
        for step in range(60):
            way = 60 * (1 - abs(step - 25) / 30)
            words += ["mousemove", "--window", window, round(at[0] + way), round(at[1] - way / 2),
                      "sleep", 0.03]
        self.server.xdotool(*words, "mouseup", 3)

    def descriptors(self):
        """What the program has open."""
        folder = f"/proc/{self.program.pid}/fd"
        return sorted(os.readlink(f"{folder}/{number}").split(":")[0]
                      for number in os.listdir(folder))

    def pace(self, action):
        """Pictures that the host draws during an action, and the longest gap in ms."""
        watcher = subprocess.Popen([os.path.join(self.programs, "pace"), str(self.host)],
                                   env=self.server.env, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True)
        check(watcher.stdout.readline(), "pace does not start")
        action()
        said = watcher.communicate()[0].split()
        return int(said[0]), int(said[1])

    def complaints(self):
        """What is wrong in what it has written to standard error."""
        return [line for line in self.program.complained if BAD.search(line)]


def drive(name, programs, folder):
    """One host, from beginning to end. Gives what is to be said of it."""
    if name == "fortran":
        return fortran(programs, folder)
    host = HOSTS[name]
    if host.drivers:
        return flies(name, programs, folder)
    stage = Stage(folder, programs, host.command, f"^{host.title or host.command[0]}$")
    server, program = stage.server, stage.program
    try:
        window = stage.editor()
        count = stage.hand_over(window)
        check(count == POSES, f"{count} poses, not {POSES}")
        gaps = []
        while not gaps or gaps[-1] > GAP and len(gaps) < DRAGS:
            pictures, gap = stage.pace(lambda: stage.drag(window))
            gaps.append(gap)
            count = stage.hand_over(window)
            check(count != POSES, "the drag changed nothing")
            server.press(window, "ctrl+z")
            count = stage.hand_over(window)
            check(count == POSES, f"{count} poses after undo")
        check(pictures >= 10 and gaps[-1] <= GAP,
              f"during drags the host drew {pictures} pictures, without one for {gaps} ms")
        if host.modal:  # a dialog of the host's own: it must be there, and the poses come
            known = set(server.windows("."))
            server.press(stage.host, host.modal)
            wait(lambda: set(server.windows(".")) - known, "the host's dialog")
            check(stage.hand_over(window) == POSES, "no poses during the host's dialog")
            dialog = max(set(server.windows(".")) - known)
            server.press(dialog, "Escape")
            wait(lambda: dialog not in server.windows("."), "the host's dialog to go")
        server.press(window, "ctrl+q")
        server.gone(window)
        before = stage.descriptors()
        pictures_alone, _ = stage.pace(lambda: time.sleep(0.5))
        check(pictures_alone > 3, "the host stands still without the editor")
        for _ in range(3):
            window = stage.editor()
            server.press(window, "ctrl+q")
            server.gone(window)
        after = stage.descriptors()
        check(before == after, f"descriptors: {before} became {after}")
        window = stage.editor()
        server.press(stage.host, host.leave)
        status = program.ends()
        check(status == 0, f"exit status {status}")
        server.gone(window)
        check(not stage.complaints(), f"it complained: {stage.complaints()}")
        return f"{pictures} pictures during a drag, the longest gap {gaps[-1]} ms"
    except Exception:
        server.picture().save(os.path.join(programs, f"failed-{name}.png"))
        for line in program.complained[-5:]:
            print(f"    {name}: {line}", flush=True)
        raise
    finally:
        stage.end()


def flies(name, programs, folder):
    """One that flies along, in each of its ways."""
    host, said = HOSTS[name], None
    for driver, where in host.drivers:
        stage = Stage(folder, programs, host.command, f"^{host.title or host.command[0]}$", **where)
        try:
            said = driver(stage, host) or said
        except Exception:
            stage.server.picture().save(os.path.join(programs, f"failed-{name}.png"))
            raise
        finally:
            stage.end()
    return said


def fortran(programs, folder):
    """The host without a window: it waits for the editor, then reads its list."""
    stage = Stage(folder, programs, ["fortran"], "^VIDES")
    try:
        window = stage.server.new_window()
        check(stage.hand_over(window) == POSES, "other poses")
        stage.server.press(window, "ctrl+q")
        for pose in (f"1: {START[0]:8.4f}", f"{POSES}: {-START[0]:8.4f}"):
            stage.program.expect(pose)
        check(stage.program.ends() == 0, "its exit status")
        check(not stage.complaints(), f"it complained: {stage.complaints()}")
        return "its list read"
    finally:
        stage.end()


def attempt(name, driver, programs):
    """Whether one of them passed; says so."""
    folder = tempfile.mkdtemp(prefix="vides-hosts-")
    start = time.monotonic()
    try:
        said = f"ok: {name}: {driver(name, programs, folder)}"
    except Exception as error:  # pylint: disable=broad-except
        at = [f"{os.path.basename(frame.filename)}:{frame.lineno}"
              for frame in traceback.extract_tb(error.__traceback__)[1:]]
        reason = error if isinstance(error, Failure) else repr(error)
        said = f"FAILED: {name}: {reason} ({' '.join(at)})"
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    print(f"hosts: {said} ({time.monotonic() - start:.1f} s)", flush=True)
    return said.startswith("ok")


def run(names, driver):
    """Drives those chosen by the command line, two at a time."""
    programs = os.path.abspath(sys.argv[1])
    words = [word for word in sys.argv[2:] if word != "-compiled"]
    chosen = [name for name in names if not words or name in words]
    if "-compiled" in sys.argv:
        chosen = [name for name in chosen if not names[name] or names[name].command[0] != PYTHON]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        passed = list(pool.map(lambda name: attempt(name, driver, programs), chosen))
    print(f"hosts: {sum(passed)} passed, {len(passed) - sum(passed)} failed")
    return 0 if passed and all(passed) else 1


if __name__ == "__main__":
    sys.exit(run(HOSTS, drive))
