"""Hosts with loops of their own over Xt, and what is said to a host that does wrong:
nothing freezes, and nothing happens without a word."""

import contextlib
import os
import time

from harness import Watch, check, wait
from run import BOTH, test

PATIENCE = 2.0
"""Seconds within which the hint is promised."""


def vides_said(program):
    """The library's lines on a program's standard error."""
    return [line for line in program.complained if line.startswith("vides:")]


def gap(host):
    """By how many milliseconds rounds came late in all, the longest time between two,
    and the events for no window till now."""
    words = host.tell("gap").split()
    return float(words[1]), float(words[3]), int(words[5])


def dragging(server, window, seconds):
    """The view is turned for so long, and nothing else touched."""
    server.xdotool("mousemove", "--window", window, 500, 400, "mousedown", 3)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        words = []
        for step in range(100):
            words += ["mousemove", "--window", window, 450 + step, 350 + step % 50, "sleep", "0.008"]
        server.xdotool(*words)
    server.xdotool("mouseup", 3)


def goes_on(place, way, draws=True, seconds=5):
    """A host goes on drawing while the editor is used; gives the events that it got."""
    server = place.server()
    host = place.told(server, "loop_pending", way)
    host.open()
    window = server.new_window()
    if not draws:
        host.tell("tick")
    before = server.picture(window)
    gap(host)
    watch, begun = Watch(host.pid), time.monotonic()
    dragging(server, window, seconds)
    stalled, longest, events = gap(host)
    waited = 1000 * (time.monotonic() - begun - watch.seconds())
    # A busy machine makes a picture late now and then; a loop that sleeps is late always.
    check(stalled - waited <= 100 * seconds,
          f"{way}: {stalled} ms of {seconds} s were stalls, the longest of {longest} ms")
    check(server.picture(window).differs(before), "the view was not turned")
    server.press(window, "alt+u")
    host.expect("rueck 0")
    host.live()
    check(not host.complained, f"it complained: {host.complained}")
    return server, host, window, events


def freezes_never(place, way):
    """A host that asks XtAppPending goes on, and an idle window gives it nothing to do."""
    _, host, _, _ = goes_on(place, way)
    time.sleep(1)
    before = gap(host)[-1]
    time.sleep(3)
    events = gap(host)[-1]
    check(events == before, f"{events - before} events of an idle window in 3 s")
    threads = os.listdir(f"/proc/{host.pid}/task")
    check(len(threads) == 1, f"{len(threads)} threads when the host is known")
    host.leave()


@test(at_once=3)
def xt_pending_and_next_event(place):
    """XtAppPending, XtAppNextEvent, XtDispatchEvent."""
    freezes_never(place, "next")


@test(at_once=3)
def xt_pending_and_process_event(place):
    """XtAppPending, XtAppProcessEvent."""
    freezes_never(place, "process")


@test(at_once=3)
def xt_pending_in_a_threaded_toolkit(place):
    """After XtToolkitThreadInitialize."""
    freezes_never(place, "threads")


@test(at_once=3)
def xt_pending_on_two_displays(place):
    """Two displays in one context."""
    freezes_never(place, "displays")


def sleeps_in_xt(place, way):
    """A host that sleeps in Xt goes on as well, and is given no event more."""
    server, host, window, _ = goes_on(place, way, draws=False, seconds=5)
    before = gap(host)[-1]
    server.xdotool("mousemove", "--window", window, 300, 300)
    dragging(server, window, 2)
    events = gap(host)[-1] - before
    check(events <= 3, f"{events} events for no window")
    host.leave()


@test(at_once=3)
def xt_next_event_alone(place):
    """XtAppNextEvent and XtDispatchEvent, as XtAppMainLoop has them."""
    sleeps_in_xt(place, "blocked")


@test(at_once=3)
def xt_process_event_alone(place):
    """XtAppProcessEvent without XtAppPending."""
    sleeps_in_xt(place, "one")


@test(at_once=3)
def xt_hosts_have_one_thread(place):
    """Whoever sleeps in Xt is known at once: no thread looks on, and no timer ticks."""
    server = place.server()
    for way in ("blocked", "one"):
        host = place.told(server, "loop_pending", way)
        windows = server.windows()
        host.open()
        window = server.new_window(*windows)
        server.xdotool("mousemove", "--window", window, 500, 400)
        server.xdotool("mousemove", "--window", window, 510, 400)
        wait(lambda pid=host.pid: len(os.listdir(f"/proc/{pid}/task")) == 1, "one thread")
        host.idle()
        before = host.switches()
        time.sleep(2)
        check(host.switches() == before, f"{host.switches() - before} wake-ups in 2 s")
        host.leave()


@test(kinds=BOTH)
def a_select_over_x_alone_is_told(place):
    """A host whose select() does not see Xt's inputs: one hint, soon, that names the cure."""
    server = place.server()
    host = place.told(server, "loop_pending", "select")
    host.open()
    window = wait(server.windows, "a window")[0]
    # While it is awake for events of its own, it serves the window, too.
    host.idle()
    watch = Watch(host.pid)
    server.xdotool("mousemove", "--window", window, 500, 400)
    wait(lambda: vides_said(host), "a hint")
    waited = watch.seconds()
    check(waited < PATIENCE, f"the hint came after {waited:.2f} s")
    said = vides_said(host)[0]
    check("v_fd()" in said and "v_dispatch()" in said and "select()" in said, said)
    server.press(window, "alt+u")
    time.sleep(2.5)
    host.live()
    host.leave()
    check(len(vides_said(host)) == 1, f"hints: {host.complained}")


@test()
def a_host_that_opens_in_a_procedure_is_not_told(place):
    """Xt serves a window that is opened in a timeout or a work procedure as any other."""
    server = place.server()
    hosts = [(place.told(server, "loop_xt", "app"), way) for way in ("timeout", "work") * 4]
    for host, way in hosts:
        host.tell(way, "opened 0")
    wait(lambda: len(server.windows()) == len(hosts), "all windows")
    time.sleep(PATIENCE + 0.5)
    for host, way in hosts:
        check(not host.complained, f"{way}: it complained: {host.complained}")
        host.leave()


@test(kinds=BOTH)
def a_busy_host_is_not_told(place):
    """A host that computes for a while, or sits in its own callback, serves later."""
    server = place.server()
    host = place.told(server, "loop_pending", "next")
    host.open()
    window = server.new_window()
    host.tell("compute 4000", "computing")
    server.press(window, "alt+u")
    host.expect("computed")
    host.expect("rueck 0")
    host.tell("within-rueck sleep 3000")
    server.press(window, "alt+u")
    host.expect("slept")
    host.live()
    check(not host.complained, f"it complained: {host.complained}")
    host.leave()


@test(kinds=BOTH)
def a_host_that_knows_v_fd_is_not_watched(place):
    """Who calls v_fd() or v_dispatch() has no need of a hint, nor of a thread."""
    server = place.server()
    host = place.told(server, "loop_pending", "select")
    host.tell("fd")
    host.open()
    wait(server.windows, "a window")
    names = threads(host)
    check("vides lookout" not in names, f"{names}")
    # What connected may still be about to end.
    wait(lambda: len(threads(host)) == 1, "one thread")
    time.sleep(2.5)
    check(not host.complained, f"it complained: {host.complained}")
    host.leave()


def threads(host):
    """The names of a host's threads."""
    names = []
    for task in os.listdir(f"/proc/{host.pid}/task"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            with open(f"/proc/{host.pid}/task/{task}/comm", encoding="utf-8") as name:
                names.append(name.read().strip())
    return names


def ended(place, *how):
    """Runs thread_ends; what it said and what the library did."""
    server = place.server()
    program = place.program(server, "thread_ends", *how)
    check(program.ends() == 0, f"its exit status; it complained: {program.complained}")
    return program


@test(kinds=BOTH)
def a_thread_that_ends_takes_its_window_along(place):
    """That is said, and the handle knows why."""
    program = ended(place)
    words = program.expect("get_path")
    check(words.startswith("get_path 12 ") and "the thread that opened it has ended" in words, words)
    words = program.expect("strerror")
    check("user" not in words, words)
    check(program.expect("close") == "close 0 ", "v_editor_close()")
    wait(lambda: vides_said(program), "a word")
    said = vides_said(program)
    check(len(said) == 1 and "thread" in said[0] and "has ended" in said[0], f"said: {said}")


@test(kinds=BOTH)
def a_thread_that_ends_with_two_windows(place):
    """One line for both."""
    program = ended(place, "two")
    wait(lambda: vides_said(program), "a word")
    said = vides_said(program)
    check(len(said) == 1 and "2 windows" in said[0], f"said: {said}")


@test(kinds=BOTH)
def a_program_that_ends_says_nothing(place):
    """Though its windows go with the thread that calls exit()."""
    program = ended(place, "exit")
    time.sleep(0.2)
    check(not program.complained, f"it complained: {program.complained}")


def throws(place, callback, key):
    """The program ends, and says why before."""
    server = place.server()
    program = place.program(server, "throws", callback)
    if key:
        server.press(server.new_window(), key)
    program.expect(f"caught within {callback}")
    status = program.ends()
    check(status == 134, f"exit status {status}")
    wait(lambda: len(program.complained) >= 2, "two words")
    said = vides_said(program)
    check(len(said) == 1 and f"{callback}()" in said[0] and "exception" in said[0], f"said: {said}")
    check(program.complained[0] == said[0], f"first: {program.complained}")
    check(any("runtime_error" in line for line in program.complained[1:]),
          f"nothing of the exception: {program.complained}")
    check("ust" not in "".join(program.complained).replace("must", ""), f"{program.complained}")


for _callback, _key in (("rueck", "alt+u"), ("ende", "ctrl+q"),
                        ("on_poses", "alt+u"), ("on_close", "ctrl+q"), ("interpolation", None)):
    def _case(place, callback=_callback, key=_key):
        throws(place, callback, key)

    _case.__name__ = f"an_exception_out_of_{_callback}"
    test(kinds=BOTH)(_case)
