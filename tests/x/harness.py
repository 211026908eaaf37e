"""Servers, hosts and hands: what the tests under an X server need.

Every test has servers and folders of its own, so that tests can run side by
side. Nothing here sleeps and hopes: `wait` asks until something is true, and
fails when it does not become true in time.
"""

import contextlib
import os
import queue
import secrets
import signal
import subprocess
import threading
import time

from picture import Picture
from ping import Pinger

LIMIT = 120.0
"""Seconds after which waiting has failed. Long, since machines may be busy."""

_patience = threading.local()


@contextlib.contextmanager
def patience(seconds):
    """This thread waits so long, for programs that are made slow on purpose."""
    _patience.seconds = seconds
    try:
        yield
    finally:
        del _patience.seconds


def _limit(seconds):
    """Seconds to wait, if none are given."""
    return getattr(_patience, "seconds", LIMIT) if seconds is None else seconds


class Failure(Exception):
    """A test's claim is not true."""


def check(truth, what):
    """Fails unless it is true."""
    if not truth:
        raise Failure(what)


def wait(condition, what, seconds=None):
    """Asks again and again until `condition` gives something true, and gives that back."""
    seconds = _limit(seconds)
    end = time.monotonic() + seconds
    pause = 0.005
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise Failure(f"not within {seconds:g} s: {what}")
        time.sleep(pause)
        pause = min(0.1, pause * 1.5)


def run(*command, env=None, stdin=None, fail=True):
    """Runs a command to its end and gives back what it wrote."""
    done = subprocess.run(command, env=env, input=stdin, capture_output=True,
                          timeout=_limit(None))
    if fail and done.returncode != 0:
        raise Failure(f"{' '.join(command)}: {done.stderr.decode(errors='replace').strip()}")
    return done.stdout


class Watch:
    """How long something takes, without what the machine let it wait for a processor: what
    a process promises, however busy others keep the machine."""

    def __init__(self, pid):
        self.pid = pid
        self.begun = self._now()

    def _now(self):
        waited = 0
        for schedule in (f"/proc/{self.pid}/schedstat", "/proc/thread-self/schedstat"):
            with open(schedule, encoding="ascii") as file:
                waited += int(file.read().split()[1])
        return time.monotonic() - 1e-9 * waited

    def seconds(self):
        """Since it was made."""
        return max(0.0, self._now() - self.begun)


class Server:
    """An X server of its own, with a cookie that clients must show. Keys do not
    repeat: on a busy machine one that xdotool presses may stay down for long."""

    def __init__(self, folder, screen="1920x1200x24", options=(), cookie=True):
        self.folder = folder
        self.authority = os.path.join(folder, "Xauthority")
        self.key = key = secrets.token_hex(16)
        secret = os.path.join(folder, "server-cookie")
        run("xauth", "-q", "-f", secret, "add", ":0", ".", key)
        ours, its = os.pipe()
        with open(os.path.join(folder, "server.log"), "wb") as log:
            self.process = subprocess.Popen(
                ["Xvfb", "-displayfd", str(its), "-auth", secret, "-screen", "0", screen,
                 *(() if "-listen" in options else ("-nolisten", "tcp")), "-noreset", "-r",
                 *options],
                pass_fds=[its], stdout=log, stderr=log, start_new_session=True)
        os.close(its)
        with os.fdopen(ours) as number:
            self.name = f":{number.readline().strip()}"
        check(self.name != ":", "Xvfb does not start")
        self.env = clean_environment(folder)
        self.env["DISPLAY"] = self.name
        self.env["XAUTHORITY"] = self.authority
        if cookie:
            run("xauth", "-q", "-f", self.authority, "add", self.name, ".", key)
        self.helpers, self.pinger = [], None
        self.untrusts = False
        # Not in the middle, where it would light what a window shows there.
        if cookie:
            width, height = screen.split("x")[:2]
            self.xdotool("mousemove", int(width) - 1, int(height) - 1)

    def untrusted(self):
        """The environment of a client whom the server does not trust, as `ssh -X` has it. Its
        windows cannot be asked whether they have been served."""
        self.untrusts = True
        env = dict(self.env, XAUTHORITY=os.path.join(self.folder, "untrusted"))
        run("xauth", "-q", "-f", env["XAUTHORITY"], "generate", self.name, ".", "untrusted",
            "timeout", "0", env=self.env)
        return env

    def by_tcp(self):
        """The environment of a client that comes by way of the network. Needs `-listen tcp`."""
        env = dict(self.env, DISPLAY=f"127.0.0.1{self.name}")
        run("xauth", "-q", "-f", self.authority, "add", env["DISPLAY"], ".", self.key)
        return env

    # ---- its life

    def kill(self):
        """Ends it at once, as a crash does."""
        self.process.kill()
        self.process.wait()

    def pause(self):
        """It answers nobody from now on."""
        self.process.send_signal(signal.SIGSTOP)

    def resume(self):
        """It answers again."""
        self.process.send_signal(signal.SIGCONT)

    def end(self):
        """Ends it and what runs on it."""
        if self.pinger:
            self.pinger.close()
        for helper in self.helpers:
            helper.kill()
            helper.wait()
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGCONT)
            self.process.terminate()
            try:
                self.process.wait(5)
            except subprocess.TimeoutExpired:
                self.kill()
        # A killed server leaves them behind; another may have taken them over.
        number = self.name[1:]
        lock = f"/tmp/.X{number}-lock"
        try:
            with open(lock, encoding="ascii") as owner:
                if int(owner.read()) == self.process.pid:
                    os.unlink(f"/tmp/.X11-unix/X{number}")
                    os.unlink(lock)
        except (OSError, ValueError):
            pass

    def window_manager(self):
        """Starts one, and waits until it manages."""
        with open(os.path.join(self.folder, "openbox.log"), "wb") as log:
            self.helpers.append(subprocess.Popen(
                ["openbox", "--sm-disable"], env=self.env, stdout=log, stderr=log))
        wait(lambda: b"window id" in run("xprop", "-root", "_NET_SUPPORTING_WM_CHECK",
                                         env=self.env), "a window manager")
        # It says so before it listens; a window that comes in between is lost.
        wait_for_rest(self.helpers[-1].pid, 0.3)

    def resources(self, text):
        """Sets X resources, such as `Xft.dpi: 192`."""
        run("xrdb", "-merge", "-", env=self.env, stdin=text.encode() + b"\n")

    def copy(self, text, selection="clipboard"):
        """Another program owns the clipboard from now on; it goes on in the background."""
        subprocess.run(["xclip", "-selection", selection, "-i"], env=self.env, input=text.encode(),
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=_limit(None),
                       check=True)

    def copied(self, selection="clipboard"):
        """What another program finds in the clipboard; nothing, if it is not told all of it: it
        waits for ever for an owner that has given up. Whoever waits for a text asks again."""
        return run("timeout", "30", "xclip", "-selection", selection, "-o", env=self.env,
                   fail=False).decode(errors="replace")

    # ---- hands and eyes

    def xdotool(self, *arguments, fail=True):
        """Moves, presses, types, finds."""
        words = [str(word) for word in arguments]
        return run("xdotool", *words, env=self.env, fail=fail).decode().strip()

    def windows(self, kind="^vides$", visible=True):
        """The windows of a WM_CLASS, oldest first."""
        shown = ["--onlyvisible"] if visible else []
        found = self.xdotool("search", *shown, "--class", kind, fail=False)
        return sorted(int(line) for line in found.split())

    def window(self, kind="^vides$", number=0):
        """The window of a WM_CLASS, waited for."""
        found = wait(lambda: self.windows(kind)[number:], f"a window of class {kind}")
        return found[0]

    def new_window(self, *known):
        """An editor window beside those known, waited for until it is drawn."""
        found = wait(lambda: [one for one in self.windows() if one not in known],
                     "a further window" if known else "a window")
        self.drawn(found[0])
        return found[0]

    def gone(self, window):
        """Waits until a window is there no more."""
        wait(lambda: window not in self.windows(), "the window to close")

    def named(self, name):
        """The visible window with this title."""
        found = wait(lambda: self.xdotool("search", "--onlyvisible", "--name", name, fail=False),
                     f"a window named {name}")
        return int(found.split()[-1])

    def geometry(self, window):
        """Left, top, width, height."""
        text = self.xdotool("getwindowgeometry", "--shell", window)
        values = dict(line.split("=") for line in text.splitlines())
        return tuple(int(values[name]) for name in ("X", "Y", "WIDTH", "HEIGHT"))

    def place(self, window, x, y):
        """Moves a window, and waits until it is there."""
        self.xdotool("windowmove", window, x, y)
        wait(lambda: abs(self.geometry(window)[0] - x) < 40, "the window to move")

    def property(self, window, name):
        """A property as xprop prints it."""
        return run("xprop", "-id", str(window), name, env=self.env).decode().strip()

    def focus(self, window):
        """Gives a window the keyboard, and waits until it has it."""
        self.xdotool("windowraise", window, "windowfocus", "--sync", window)

    def press(self, window, *keys):
        """Presses keys in a window."""
        self.focus(window)
        self.xdotool("key", "--delay", "20", *keys)

    def type(self, text):
        """Types a text where the keyboard is."""
        self.xdotool("type", "--delay", "20", "--", text)

    def click(self, window, x, y, button=1):
        """Clicks at a place in a window."""
        self.xdotool("mousemove", "--window", window, int(x), int(y), "click", button)

    def drag(self, window, start, end, button=1, steps=8):
        """Presses, moves in steps, lets go."""
        self.xdotool(*self.drag_words(window, start, end, button, steps))

    @staticmethod
    def drag_words(window, start, end, button=1, steps=8, release=True):
        """The same as xdotool's words."""
        words = ["mousemove", "--window", window, round(start[0]), round(start[1]),
                 "mousedown", button]
        for step in range(1, steps + 1):
            x = start[0] + (end[0] - start[0]) * step / steps
            y = start[1] + (end[1] - start[1]) * step / steps
            words += ["mousemove", "--window", window, round(x), round(y)]
        return words + (["mouseup", button] if release else [])

    def picture(self, window=None):
        """What is to be seen: of the whole screen, or where a window lies."""
        area = None
        if window is not None:
            x, y, width, height = self.geometry(window)
            area = max(x, 0), max(y, 0), width + min(x, 0), height + min(y, 0)
        return Picture.of_xwd(run("xwd", "-root", "-silent", env=self.env), area)

    def served(self, window):
        """Waits until a window has seen all that was sent to it, and has done what it had to do
        for that. Windows that cannot be asked are left alone."""
        if self.untrusts:
            return
        self.pinger = self.pinger or Pinger(self.name, self.key)
        for _ in range(2):  # what it does comes after its answer
            check(self.pinger.answered(window, _limit(None)), "the window does not answer")

    def seen(self, window, look, what):
        """What `look` finds in a picture of a window, as soon as it finds it."""
        def found():
            picture = self.drawn(window)
            try:
                return look(picture)
            except (IndexError, ValueError):
                return None

        return wait(found, what)

    def drawn(self, window, colours=8):
        """Waits until a window shows something, and goes on to show the same; gives that."""
        last = []

        def same():
            self.served(window)
            picture = self.picture(window)
            known = last and last[0].rows == picture.rows
            last[:] = [picture]
            return known and picture.colours() > colours

        wait(same, "something drawn")
        return last[0]


def switches(pid):
    """How often the threads of a process have gone to sleep by themselves."""
    total = 0
    for task in os.listdir(f"/proc/{pid}/task"):
        try:
            with open(f"/proc/{pid}/task/{task}/status", encoding="ascii") as status:
                lines = status.readlines()
        except (FileNotFoundError, ProcessLookupError):  # a thread that has just ended
            continue
        total += sum(int(line.split()[1]) for line in lines
                     if line.startswith("voluntary_ctxt_switches:"))
    return total


def spent(pid):
    """Seconds that processors have spent on all threads of a process, ended ones too."""
    with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
        times = stat.read().rpartition(")")[2].split()[11:13]
    return sum(map(int, times)) / os.sysconf("SC_CLK_TCK")


def sleeps(pid):
    """All threads of a process wait for something that is not a processor."""
    for task in os.listdir(f"/proc/{pid}/task"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            with open(f"/proc/{pid}/task/{task}/stat", encoding="utf-8") as stat:
                if stat.read().rpartition(")")[2].split()[0] in "RD":
                    return False
    return True


def private(pid, kind="Private_"):
    """Memory that only this process has, in kB: all of it, or of one kind."""
    with open(f"/proc/{pid}/smaps_rollup", encoding="ascii") as file:
        return sum(int(line.split()[1]) for line in file if line.startswith(kind))


def written(pid):
    """The part of it that the process has written into. Pages of a library's file are
    anybody's: they count as private when the last other process that has them ends."""
    return private(pid, "Private_Dirty")


def wait_for_rest(pid, seconds):
    """Waits until a process has not moved for so long."""
    last = [-1]

    def still():
        before, last[0] = last[0], switches(pid)
        if before != last[0]:
            time.sleep(seconds)
        return before == last[0] and sleeps(pid)

    wait(still, "it to come to rest")


def clean_environment(folder):
    """The environment of a user who has nothing set."""
    kept = {name: value for name, value in os.environ.items()
            if name in ("PATH", "LD_LIBRARY_PATH", "LANG", "LC_ALL", "LOCPATH", "TMPDIR")}
    kept.update(HOME=folder, XDG_CONFIG_HOME=os.path.join(folder, "config"),
                XDG_STATE_HOME=os.path.join(folder, "state"))
    return kept


class Program:
    """A program under test: what it says is read line by line."""

    def __init__(self, folder, command, env, terminal=False):
        self.said, self.complained = [], []
        self.folder = folder
        self._lines = queue.Queue()
        output = subprocess.PIPE
        if terminal:  # so that the program writes line by line
            ours, output = os.openpty()
        self.process = subprocess.Popen(command, env=env, cwd=folder, stdin=subprocess.PIPE,
                                        stdout=output, stderr=subprocess.PIPE)
        if terminal:
            os.close(output)
        source = os.fdopen(ours, "rb") if terminal else self.process.stdout
        for stream, into in ((source, self._heard), (self.process.stderr, self._complaint)):
            threading.Thread(target=self._read, args=(stream, into), daemon=True).start()

    @staticmethod
    def _read(stream, into):
        try:
            for line in stream:
                into(line.decode(errors="replace").rstrip("\r\n"))
        except OSError:  # a terminal ends so
            pass
        into(None)

    def _heard(self, line):
        if line is not None:
            self.said.append(line)
        self._lines.put(line)

    def _complaint(self, line):
        if line is not None:
            self.complained.append(line)

    @property
    def pid(self):
        """Its process."""
        return self.process.pid

    def expect(self, beginning, seconds=None):
        """The next line that begins so; those before it are passed over."""
        seconds = _limit(seconds)
        end = time.monotonic() + seconds
        while True:
            try:
                line = self._lines.get(timeout=max(0.0, end - time.monotonic()))
            except queue.Empty:
                line = None
            if line is None:  # its output has ended, or it takes too long
                raise Failure(
                    f"never said ({seconds:g} s): {beginning!r}; said: {self.said[-6:]}, "
                    f"complained: {self.complained[-4:]}, status: {self.process.poll()}")
            if line.startswith(beginning):
                return line

    def alive(self):
        """It still runs."""
        return self.process.poll() is None

    def ends(self, seconds=None):
        """Waits for its end; gives its exit status, as a shell would."""
        seconds = _limit(seconds)
        try:
            status = self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise Failure(f"it does not end within {seconds:g} s") from None
        return status if status >= 0 else 128 - status

    def kill(self):
        """For tidying up."""
        if self.alive():
            self.process.kill()
        self.process.wait()

    def switches(self):
        """How often its threads have gone to sleep by themselves."""
        return switches(self.pid)

    def idle(self, seconds=1.0):
        """Waits until it has not moved for a while."""
        wait_for_rest(self.pid, seconds)


class Told(Program):
    """The host that does what it is told (host.c)."""

    def __init__(self, folder, command, env):
        super().__init__(folder, command, env)
        self._asked = 0

    def send(self, line):
        """Tells it something."""
        try:
            self.process.stdin.write(line.encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            raise Failure(f"the host has ended with {self.ends()}, "
                          f"complained: {self.complained[-4:]}") from None

    def tell(self, line, answer=None, seconds=None):
        """Tells it something, and waits for the answer."""
        self.send(line)
        return self.expect(answer or line.split()[0], seconds)

    def turns(self):
        """How often the loop of loop_poll.c has been woken, but for asking that."""
        self._asked += 1
        return int(self.tell("turns").split()[1]) - self._asked

    def live(self, seconds=None):
        """It answers."""
        self.tell("ping", "pong", seconds)

    def open(self, number=0, what="haupt"):
        """Opens a window by v_haupt(); fails if that complains."""
        words = self.tell(f"{what} {number}", "haupt").split(None, 2)
        check(len(words) == 2, f"v_haupt: {words[2:]}")

    def edit(self, number=0, file=""):
        """Opens a window by v_editor_open(); fails if that complains."""
        words = self.tell(f"edit {number} {file}", "edited").split(None, 3)
        check(words[1] == "0", f"v_editor_open: {words}")

    def path(self, number=0):
        """The points of a window's path."""
        words = self.tell(f"path {number}", "path").split()
        check(words[1] != "status", f"v_editor_get_path: {words}")
        values = [float(word) for word in words[2:]]
        return [tuple(values[i:i + 3]) for i in range(0, len(values), 3)]

    def leave(self):
        """Ends it, and checks that it ends as it wants to."""
        self.send("exit 0")
        status = self.ends()
        check(status == 0, f"exit status {status}, complained: {self.complained[-4:]}")
