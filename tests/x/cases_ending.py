"""What becomes of unsaved work when its host ends: nothing is left of it by a host that
ends as it wants to, all of it by one that crashes or is killed."""

import os
import time

from harness import check, wait
from panel import timeline
from run import test

ADD_POINT = (38, 44)
"""The button that adds a point below the list, from the left and above the timeline."""


def add_point(server, window):
    """A click on it."""
    height = server.geometry(window)[3]
    server.click(window, ADD_POINT[0], height - timeline(height) - ADD_POINT[1])


def work(place):
    """The files of unsaved work."""
    return [os.path.join(folder, name) for folder, _, names in os.walk(place.folder)
            for name in names if name.startswith("unsaved-")]


def edited(place, way, name="ending"):
    """A host in whose window something was done and is kept, before it ends."""
    server = place.server()
    host = place.program(server, name, way)
    host.expect("open")
    window = server.new_window()
    add_point(server, window)
    wait(lambda: work(place), "unsaved work to be kept")
    return server, host, window


def end(host):
    """Tells it to end."""
    host.process.stdin.write(b"end\n")
    host.process.stdin.flush()


@test()
def nothing_is_left_by_a_host_that_ends_as_it_wants_to(place):
    """By return, by exit with any status, on any thread, with its display open or not."""
    for way in ("return", "exit", "failure", "other-thread-exits", "closed-display"):
        server, host, _ = edited(place, way)
        end(host)
        status = host.ends()
        check(status == (3 if way == "failure" else 0), f"{way}: status {status}")
        check(not work(place), f"{way}: {work(place)}")
        server.end()
    # The thread with the window goes on while another one ends the program.
    server, host, _ = edited(place, "thread-goes-on")
    check(host.ends() == 0, "it ends")
    check(not work(place), f"thread: {work(place)}")


@test()
def a_change_just_before_the_end_leaves_nothing(place):
    """It has not been written yet when the program ends, and is not afterwards."""
    for way in ("return", "exit", "other-thread-exits"):
        server = place.server()
        host = place.program(server, "ending", way)
        host.expect("open")
        window = server.new_window()
        add_point(server, window)
        time.sleep(0.2)
        check(not work(place), "written too soon for this test")
        end(host)
        check(host.ends() == 0, way)
        check(not work(place), f"{way}: {work(place)}")
        server.end()


@test()
def all_is_left_by_a_host_that_crashes(place):
    """By a signal, by abort, by _exit, in a handler of its own at the end; a thread that
    ends while its program goes on; a child's end is none."""
    for number, way in enumerate(("_exit", "abort", "segv", "term", "crash-in-atexit", "child")):
        server, host, _ = edited(place, way)
        end(host)
        host.ends()
        check(len(work(place)) == 1, f"{number} {way}: {work(place)}")
        os.unlink(work(place)[0])
        server.end()
    server, host, _ = edited(place, "thread-ends")
    end(host)
    host.expect("thread ended")
    check(host.ends() == 0, "it ends")
    check(len(work(place)) == 1, f"thread: {work(place)}")


@test()
def all_is_left_when_xlib_ends_the_host(place):
    """Its server dies, or somebody kills its connection: Xlib calls exit then."""
    for times in range(5):
        server, host, _ = edited(place, "return")
        server.kill()
        check(host.ends() == 1, "Xlib ends it")
        check(len(work(place)) == 1, f"server killed, {times}: {work(place)}")
        os.unlink(work(place)[0])
    server, host, _ = edited(place, "return")
    own = [one for one in server.windows(".*") if one not in server.windows()]
    server.xdotool("windowkill", own[-1])
    status = host.ends()
    check(status == 1, f"Xlib ends it: {status} {host.complained}")
    check(len(work(place)) == 1, f"connection killed: {work(place)}")


@test()
def closing_after_a_hand_over_does_not_ask(place):
    """v_haupt(): the host has the path then."""
    server = place.server()
    host = place.told(server)
    host.open()
    window = server.new_window()
    add_point(server, window)
    wait(lambda: work(place), "unsaved work to be kept")
    check("VIDES*" in server.property(window, "_NET_WM_NAME"), "a star in the title")
    server.press(window, "alt+u")
    wait(lambda: "VIDES*" not in server.property(window, "_NET_WM_NAME"), "no star")
    wait(lambda: not work(place), "nothing unsaved to be kept")
    server.press(window, "ctrl+q")
    server.gone(window)
    host.leave()


@test()
def recovered_work_is_offered_beside_the_work(place):
    """To the same program only, and Alt-U works at once."""
    server, host, window = edited(place, "segv")
    end(host)
    host.ends()
    server.gone(window)
    other = place.told(server)
    other.open()
    window = server.new_window()
    plain = server.picture(window)
    server.press(window, "alt+u")
    other.expect("rueck")
    other.leave()
    server.gone(window)
    again = place.program(server, "ending", "return")
    again.expect("open")
    window = server.new_window()
    picture = server.picture(window)
    picture.save(place.path("offered.png"))
    if folder := os.environ.get("VIDES_SCREENSHOTS"):
        picture.save(os.path.join(folder, f"offered-{place.kind}.png"))
    check(picture.rows != plain.rows, "nothing is offered")
    server.press(window, "alt+u")
    server.press(window, "ctrl+q")
    server.gone(window)
    check(len(work(place)) == 1, "what was offered is still there")
