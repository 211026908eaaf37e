"""How fast windows open, and what they take: measure.py HOSTS_FOLDER [soak [TIMES]]

Without `soak` it prints times and memory; machines differ, so it asserts
nothing. With it, it opens and closes windows thousands of times and fails if
the host's memory or descriptors, or what the server holds, grow.
"""

import math
import os
import statistics
import sys
import tempfile
import time

from harness import (Failure, Program, Server, Told, check, private, wait, wait_for_rest,
                     written)
from space import first_look

WINDOWS = 32
TIMES = 30
MOTIONS = 300
# Seconds between motions: a usual mouse tells about a hundred times a second
# where it is, others several times as often. In long pauses the processor's
# caches go to others.
BETWEEN = ("0.008", "0.001")
# Setup files, and what is to be seen then.
SHOWN = {
    "version = 1\n": "everything shown",
    "version = 1\n[shown]\nribbon = false\ncameras = false\nnumbers = false\n":
        "curve, crosses and arrows shown",
}


def spread(values, unit):
    """The smallest and the middle one."""
    return f"min {min(values):.1f}, median {statistics.median(values):.1f} {unit}"


def times(folder, hosts, kind):
    """v_haupt() and the first picture, each time a host of its own: the first
    window is the slow one."""
    returned, shown, second = [], [], []
    for _ in range(TIMES):
        server = Server(tempfile.mkdtemp(dir=folder), screen="1300x900x24")
        watcher = host = None
        try:
            watcher = Program(folder, [os.path.join(hosts, "first_picture")], server.env)
            watcher.expect("ready")
            host = Told(folder, [os.path.join(hosts, f"loop_poll-{kind}")], server.env)
            host.live()
            words = host.tell("stamp", "stamp").split()
            start = float(words[1])
            returned.append(float(host.tell("haupt 0").split()[1]) / 1000)
            shown.append((float(watcher.expect("")) - start) / 1000)
            second.append(float(host.tell("haupt 1").split()[1]) / 1000)
            host.leave()
        finally:
            for program in (watcher, host):
                if program:
                    program.kill()
            server.end()
    print(f"{kind}: v_haupt() returns, first window of a process: {spread(returned, 'ms')}")
    print(f"{kind}: v_haupt() returns, second window: {spread(second, 'ms')}")
    print(f"{kind}: from the call to the first picture: {spread(shown, 'ms')}")


def memory(folder, hosts, kind):
    """What windows take of a host's own memory."""
    server = Server(tempfile.mkdtemp(dir=folder), screen="1300x900x24")
    host = Told(folder, [os.path.join(hosts, f"loop_poll-{kind}")], server.env)
    try:
        host.live()
        empty = private(host.pid)
        host.open(0)
        server.drawn(server.window())
        one = private(host.pid)
        for number in range(1, WINDOWS):
            host.open(number)
        wait(lambda: len(server.windows()) == WINDOWS, "all windows")
        host.idle()
        all_of_them = private(host.pid)
        print(f"{kind}: private memory: first window {(one - empty) / 1024:.1f} MB, "
              f"each further one {(all_of_them - one) / (WINDOWS - 1) / 1024:.2f} MB")
    finally:
        host.kill()
        server.end()


def spiral(file, count):
    """Writes a path of so many points; the first one lies free."""
    with open(file, "w", encoding="ascii") as out:
        out.write("version = 1\n")
        for number in range(count):
            turn = number * 20 / count
            size = 0.3 + 0.5 * number / count
            at = ((-0.9, 0.6, 0.5) if number == 0 else
                  (size * math.cos(turn), 0.8 * math.sin(0.7 * turn), size * math.sin(turn)))
            out.write(f"[[point]]\nposition = {list(at)}\n[[point.orientation]]\n"
                      "target = [0.0, 0.05, 0.0]\n")


def drags(folder, hosts, kind, shown):
    """The host's own time for each motion while a point is dragged: input,
    path, picture, hand-over to the server."""
    for count in (2, 100, 1000, 10_000):
        file = os.path.join(folder, f"{count}.vid")
        spiral(file, count)
        server = Server(tempfile.mkdtemp(dir=folder), screen="1300x900x24")
        setup = os.path.join(server.env["XDG_CONFIG_HOME"], "vides")
        os.makedirs(setup)
        with open(os.path.join(setup, "setup.toml"), "w", encoding="ascii") as out:
            out.write(shown)
        host = Told(folder, [os.path.join(hosts, f"loop_poll-{kind}")], server.env)
        try:
            host.edit(0, file)
            window = server.window()
            start = server.seen(window, first_look, "the space").image((-0.9, 0.6, 0.5))
            words = server.drag_words(window, start, (start[0] - 20, start[1] - 20), 2, 5, False)
            server.xdotool(*words)
            before = host.path()[0]
            for between in BETWEEN:
                words = []
                for step in range(MOTIONS):
                    words += ["mousemove", "--window", window, round(start[0]) - 21 - step % 50,
                              round(start[1]) - 21 - step % 37, "sleep", between]
                host.idle()
                spent = processor(host.pid)
                begun = time.monotonic()
                server.xdotool(*words)
                rate = MOTIONS / (time.monotonic() - begun)
                host.idle()
                spent = processor(host.pid) - spent
                check(host.path()[0] != before, "the point stayed where it was")
                print(f"{kind}: dragging one of {count} points, {SHOWN[shown]}, "
                      f"{rate:.0f} motions a second: {spent / MOTIONS:.2f} ms a motion")
        finally:
            host.kill()
            server.end()


def processor(pid):
    """Time that a process has had of a processor, in ms."""
    with open(f"/proc/{pid}/schedstat", encoding="ascii") as file:
        return int(file.read().split()[0]) / 1e6


def soak(folder, hosts, kind, count, what):
    """Opens and closes, or opens, edits, hands over and closes; nothing may grow."""
    server = Server(tempfile.mkdtemp(dir=folder), screen="1300x900x24")
    if what == "closed":
        command, done, host = "cycle ", "cycled", "loop_poll"
    else:
        command, done, host = "", "worked", "work"
    host = Told(folder, [os.path.join(hosts, f"{host}-{kind}")], server.env)

    def held(choose):
        # What malloc keeps goes up and down by some hundred kB.
        memory = []
        for _ in range(5):
            host.tell(f"{command}{max(count // 50, 20)}", done, 3600)
            memory.append(written(host.pid))
        # On a busy machine the server is behind.
        wait_for_rest(server.process.pid, 1.0)
        return (choose(memory), len(os.listdir(f"/proc/{host.pid}/fd")),
                written(server.process.pid), len(server.windows(".", visible=False)))

    try:
        before = held(max)
        words = host.tell(f"{command}{count}", done, 7200).split(None, 2)
        check(int(words[1]) == count, f"only {words[1:]}")
        after = held(min)
        names = ("host's memory, kB", "host's descriptors", "server's memory, kB", "windows")
        for name, old, new in zip(names, before, after):
            print(f"{kind}: {count} windows opened and {what}: {name}: {old} -> {new}", flush=True)
        check(after[0] - before[0] < 512, "the host's memory grows")
        check(after[1] == before[1], "descriptors stay open")
        check(after[2] - before[2] < 2048, "the server's memory grows")
        check(after[3] == before[3], "windows stay on the server")
    finally:
        host.kill()
        server.end()


def main():
    """See the top."""
    hosts = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix="vides-x-") as folder:
        if sys.argv[2:3] == ["soak"]:
            times_each = int(sys.argv[3]) if len(sys.argv) > 3 else 10_000
            for kind in ("archive", "shared"):
                soak(folder, hosts, kind, times_each, "closed")
                soak(folder, hosts, kind, times_each, "edited, handed over, closed")
            return
        for kind in ("archive", "shared"):
            times(folder, hosts, kind)
            memory(folder, hosts, kind)
            for shown in SHOWN:
                drags(folder, hosts, kind, shown)


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"measure: {failure}")
