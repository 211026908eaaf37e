"""Servers that are not there, refuse, hang and die: the host lives."""

import os
import signal
import time

from cases_hosts import POSES, hand_over
from harness import Watch, check, run, wait
from proxy import Proxy
from run import test

MIDDLE = (600, 400)
"""Somewhere in the movement window."""


def told_why(host, line="haupt 0"):
    """A window cannot be opened: said once on standard error and by v_last_error()."""
    before = len(host.complained)
    words = host.tell(line, "haupt").split(None, 2)
    check(len(words) == 3, "v_last_error() says nothing")
    wait(lambda: len(host.complained) > before, "a line on standard error")
    check(host.complained[before].startswith("vides:"), host.complained[before])
    host.live()


@test()
def no_display(place):
    """DISPLAY unset, empty, wrong, nonsense."""
    for display in (None, "", ":987", "nonsense", ":-1", "no.such.host.invalid:0", "/no/such:0"):
        host = place.told(None, DISPLAY=display)
        told_why(host)
        words = host.tell("edit 0", "edited").split(None, 3)
        check(words[1] == "10", f"v_editor_open on {display!r}: {words}")
        check(host.tell("dispatch", "dispatch").startswith("dispatch 0"), host.said[-1])
        check(host.tell("main-loop").startswith("main-loop 0"), host.said[-1])
        host.leave()


@test()
def no_display_and_bad_speeds(place):
    """Both are told: a line each on standard error, and both by v_last_error()."""
    host = place.told(None, DISPLAY=None)
    host.tell("speeds 100 -1 100 0")
    said = host.tell("haupt 0")
    wait(lambda: len(host.complained) >= 2, "two lines on standard error")
    host.live()
    check(len(host.complained) == 2, f"two lines: {host.complained}")
    display, speeds = host.complained
    check(display.startswith("vides: DISPLAY is not set"), display)
    check(speeds.startswith("vides:") and "orient_speed is -1" in speeds
          and "winkel_speed is 0" in speeds, speeds)
    for line in (display, speeds):
        check(line.removeprefix("vides: ") in said, f"v_last_error() tells only {said}")
    host.leave()


@test()
def without_the_cookie(place):
    """The server refuses."""
    server = place.server(cookie=False)
    host = place.told(server)
    told_why(host)
    host = place.told(server, XAUTHORITY="/dev/null")
    told_why(host)
    host.leave()


@test()
def an_authority_that_is_no_file(place):
    """A pipe, a device without an end, a file larger than the disk: refused in time."""
    server = place.server()
    os.mkfifo(place.path("pipe"))
    with open(place.path("large"), "wb") as large:
        large.truncate(1 << 40)
    for authority in (place.path("pipe"), "/dev/zero", place.path("large"), place.folder):
        host = place.told(server, XAUTHORITY=authority)
        start = time.monotonic()
        told_why(host)
        took = time.monotonic() - start
        check(took < 4, f"{authority} held the host for {took:.1f} s")
        host.leave()


@test()
def each_reply_is_an_error_in_turn(place):
    """v_editor_open() answers in time, with a window or a reason."""
    server = place.server()
    proxy = Proxy(server, (), 0)
    try:
        env = dict(server.env, DISPLAY=proxy.name)
        run("xauth", "-q", "-f", server.authority, "add", proxy.name, ".", server.key)
        host = place.told(server, DISPLAY=env["DISPLAY"], XAUTHORITY=env["XAUTHORITY"])
        opened = 0
        for at in range(1, 76):
            proxy.error_at = at
            start = time.monotonic()
            status = host.tell("edit 0", "edited", 20).split()[1]
            took = time.monotonic() - start
            check(took < 4, f"reply {at} held the host for {took:.1f} s")
            check(status in ("0", "10"), f"reply {at}: {status}")
            if status == "0":
                opened += 1
                host.tell("close 0", "closed 0")
        check(20 < opened < 75, f"{opened} of 75 windows")
        host.leave()
    finally:
        proxy.end()


@test()
def without_standard_streams(place):
    """A host that has closed them prints into nothing of the library's."""
    server = place.server()
    host = place.program(server, "standard")
    for what in ("open", "served", "saved", "closed"):
        said = host.expect(what)
        check(said == f"{what} 0 taken 0", said)


@test()
def another_display_by_name(place):
    """v_editor_open() on a server that the environment does not name."""
    here, there = place.server(), place.server()
    host = place.told(here, XAUTHORITY=there.authority)
    words = host.tell(f"edit-on 0 {there.name}", "edited").split(None, 3)
    check(words[1] == "0", f"{words}")
    there.new_window()
    check(not here.windows(), "a window on the wrong server")
    host.leave()


def dies(place, name, *arguments, prepare):
    """The server goes while `prepare` has made something happen."""
    server = place.server()
    host = place.told(server, name, *arguments)
    host.edit(0)
    window = server.new_window()
    prepare(server, host, window)
    server.kill()
    host.live()
    wait(lambda: host.tell("dispatch", "dispatch").startswith("dispatch 0"), "no open window")
    words = host.tell("path 0").split(None, 3)
    check(words[1] == "status" and words[2] in ("10", "12"), f"v_editor_get_path: {words}")
    host.tell("close 0", "closed 0")
    told_why(host)
    other = place.server()
    words = host.tell(f"edit-on 1 {other.name}", "edited").split()
    host.live()
    host.leave()


@test()
def server_killed_while_idle(place):
    """The windows are gone; everything else goes on."""
    dies(place, "loop_poll", prepare=lambda server, host, window: host.idle())


@test()
def server_killed_while_drawing(place):
    """In the middle of turning the view."""
    def turning(server, _host, window):
        server.xdotool(*server.drag_words(window, MIDDLE, (700, 450), steps=40, release=False))
    dies(place, "loop_poll", prepare=turning)


@test()
def server_killed_many_times_while_dragging(place):
    """At other moments each time, with movements still coming in."""
    import subprocess
    import time
    for number in range(6):
        server = place.server()
        host = place.told(server)
        host.edit(0)
        window = server.new_window()
        words = server.drag_words(window, MIDDLE, (800, 500), steps=400, release=False)
        with subprocess.Popen(["xdotool", *map(str, words)], env=server.env,
                              stderr=subprocess.DEVNULL) as hand:
            time.sleep(0.01 + 0.02 * number)
            server.kill()
            hand.wait()
        host.live()
        host.leave()


@test()
def server_killed_within_rueck(place):
    """The call returns, the host goes on in its callback."""
    for extra in ((), ("haupt 1",)):
        server = place.server()
        host = place.told(server)
        host.open()
        window = server.new_window()
        pid = server.process.pid
        host.tell(f"within-rueck kill {pid} {int(signal.SIGKILL)}")
        server.xdotool("windowfocus", "--sync", window, "key", "alt+u", fail=False)
        host.expect(f"rueck 0 {POSES}")
        host.expect("kill 0")
        host.expect("rueck-end 0")
        server.process.wait()
        host.live()
        check(host.tell("list 0").startswith(f"list 0 {POSES}"), "the list went with the server")
        for line in extra:
            told_why(host, line)
        host.leave()


@test()
def server_killed_under_motif_leaves_xlibs_way(place):
    """Xlib ends its own program (exit status 1): not ours to change, and no signal."""
    server = place.server()
    program = place.program(server, "pyramid_motif")
    host = server.window("^MainTest$")
    server.place(host, 1500, 600)
    _, _, width, height = server.geometry(host)
    server.click(host, width / 2, height / 6)
    server.new_window()
    server.kill()
    check(program.ends() == 1, f"exit status {program.process.returncode}")


@test(first=True)
def server_stopped_for_twenty_seconds(place):
    """The host goes on answering, the window comes back."""
    import time
    server = place.server()
    host = place.told(server)
    host.edit(0)
    window = server.new_window()
    server.pause()
    end = time.monotonic() + 20
    longest = 0.0
    while time.monotonic() < end:
        watch = Watch(host.pid)
        host.live()
        longest = max(longest, watch.seconds())
        time.sleep(0.2)
    check(longest < 2, f"a call took {longest:.1f} s while nothing was asked of the server")
    server.resume()
    hand_over(server, window)
    host.expect(f"poses 0 {POSES}")
    host.leave()


@test(first=True)
def opening_on_a_stopped_server(place):
    """v_haupt() gives up after a stated time and says so."""
    server = place.server()
    host = place.told(server)
    host.live()
    server.pause()
    told_why(host)
    server.resume()
    host.open(1)
    server.new_window()
    host.leave()


@test()
def a_window_killed_by_its_server(place):
    """xkill: the connection of one window ends, another stays."""
    server = place.server()
    host = place.told(server)
    host.edit(0)
    first = server.new_window()
    host.edit(1)
    second = server.new_window(first)
    server.xdotool("windowkill", first)
    server.gone(first)
    wait(lambda: host.tell("dispatch", "dispatch").startswith("dispatch 1"), "one window")
    hand_over(server, second)
    host.expect(f"poses 1 {POSES}")
    host.leave()
