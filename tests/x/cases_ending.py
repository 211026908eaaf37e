"""What becomes of a window and its unsaved work when host, user or server end it: the work stays
for the next start unless it was handed over, saved or discarded."""

import os

from harness import check, wait
from panel import timeline
from run import BOTH, test

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


def is_kept(place, way):
    """There is one file of unsaved work, which the next turn must not find."""
    check(len(work(place)) == 1, f"{way}: {work(place)}")
    os.unlink(work(place)[0])


@test(kinds=BOTH)
def unsaved_work_stays_however_its_host_ends(place):
    """By return, by exit with any status, on any thread, with its display open or not."""
    for way in ("return", "exit", "failure", "other-thread-exits", "closed-display"):
        server, host, _ = edited(place, way)
        end(host)
        status = host.ends()
        check(status == (3 if way == "failure" else 0), f"{way}: status {status}")
        is_kept(place, way)
        server.end()
    # The thread with the window goes on while another one ends the program.
    server, host, _ = edited(place, "thread-goes-on")
    end(host)
    check(host.ends() == 0, "it ends")
    is_kept(place, "thread")


@test()
def a_change_just_before_the_end_stays(place):
    """It has not been written yet when the program ends on the window's own thread."""
    for way in ("return", "exit"):
        server = place.server()
        host = place.program(server, "ending", way)
        host.expect("open")
        window = server.new_window()
        shown = server.drawn(window)
        add_point(server, window)
        wait(lambda: server.picture(window).differs(shown), "the point")
        end(host)
        check(host.ends() == 0, way)
        is_kept(place, way)
        server.end()


@test()
def nothing_is_left_of_what_was_kept_or_discarded(place):
    """Handed over, saved, kept by the host itself, discarded by the user or undone."""
    def hand_over(server, host, window):
        server.press(window, "alt+u")
        host.expect("poses 0")

    def save(server, host, window):
        server.press(window, "ctrl+s")
        wait(lambda: host.tell("modified 0") == "modified 0 0", "it to be saved")

    def mark(_server, host, _window):
        check(host.tell("mark-saved 0") == "mark-saved 0", host.said[-1])
        check(host.tell("modified 0") == "modified 0 0", "it is modified")

    def discard(server, host, window):
        ask(server, window, lambda: server.press(window, "ctrl+q"))
        server.press(window, "shift+Tab", "Return")
        host.expect("gone 0 0")
        server.gone(window)

    def undo(server, host, window):
        server.press(window, "ctrl+z")
        wait(lambda: host.tell("modified 0") == "modified 0 0", "it to be undone")

    for way in (hand_over, save, mark, discard, undo):
        for end_by in ("exit 0", "close 0"):
            server = place.server()
            host = place.told(server)
            host.edit(0, "file.vid" if way is save else "")
            window = server.new_window()
            add_point(server, window)
            wait(lambda: work(place), "unsaved work to be kept")
            way(server, host, window)
            host.send(end_by)
            if end_by == "close 0":
                host.expect("closed 0")
                host.send("exit 0")
            check(host.ends() == 0, "it ends")
            check(not work(place), f"{way.__name__}, {end_by}: {work(place)}")
            server.end()


@test()
def what_the_host_closes_unsaved_is_kept(place):
    """By v_editor_close() and by v_editors_close(0); a hand-over to a file's host saves nothing."""
    for end_by in ("close 0", "quit 0"):
        for file in ("", "file.vid"):
            server = place.server()
            host = place.told(server)
            host.edit(0, file)
            window = server.new_window()
            add_point(server, window)
            wait(lambda: host.tell("modified 0") == "modified 0 1", "a modified path")
            if file:
                server.press(window, "alt+u")
                host.expect("poses 0")
            host.tell(end_by, f"{end_by.replace('close', 'closed').split()[0]} 0")
            is_kept(place, f"{end_by} {file}")
            host.leave()
            server.end()


def ask(server, window, how):
    """The question about unsaved work is on the screen."""
    before = server.drawn(window)
    how()
    wait(lambda: server.picture(window).differs(before), "the question")
    server.drawn(window)


@test()
def an_xt_host_goes_on_while_its_editor_asks(place):
    """Its inputs are served; a second call asks nobody; then Escape, then Discard. A loop that
    reads its own inputs beside Xt goes on after the answer."""
    for loop, way, inputs in (
            ("loop_xt", "initialize", True), ("loop_xt", "app", True), ("loop_xt", "two", True),
            ("loop_pending", "one", True), ("loop_pending", "next", False),
            ("loop_pending", "threads", False)):
        server = place.server()
        host = place.told(server, loop, way)
        host.open()
        window = server.new_window()
        add_point(server, window)
        wait(lambda: work(place), "unsaved work to be kept")
        ask(server, window, lambda: host.send("quit 1"))
        if inputs:
            host.live()
            asked = server.picture(window)
            host.tell("quit 1", "quit 11")
            check(not server.drawn(window).differs(asked), "another question")
        server.press(window, "Escape")
        host.expect("quit 14")
        host.live()
        ask(server, window, lambda: host.send("quit 1"))
        server.press(window, "shift+Tab", "Return")
        host.expect("quit 0")
        server.gone(window)
        check(not work(place), f"{work(place)}")
        host.leave()
        server.end()


@test()
def a_motif_host_quits_as_the_documents_say(place):
    """By its button and by its window's close: no answer but Discard ends it."""
    server = place.server()
    server.window_manager()
    host = place.program(server, "quits")
    own = server.window("^Quits$")
    server.place(own, 1700, 900)
    _, _, width, height = server.geometry(own)

    def press(number):
        server.xdotool("windowraise", own)
        server.click(own, width / 2, height * (2 * number + 1) / 6)

    def goes_on():
        press(1)
        host.expect("pressed")

    press(0)
    window = server.new_window()
    add_point(server, window)
    wait(lambda: work(place), "unsaved work to be kept")
    for leave in (lambda: press(2), lambda: server.press(own, "alt+F4")):
        ask(server, window, leave)
        goes_on()
        leave()
        goes_on()
        server.press(window, "Escape")
        host.expect("it stays")
        check(host.alive() and server.windows() == [window], "it has ended")
        goes_on()
    ask(server, window, lambda: press(2))
    server.press(window, "shift+Tab", "Return")
    check(host.ends() == 0, "its exit status")
    check(host.said.count("it stays") == 2, f"asked twice: {host.said}")
    check(not work(place), f"{work(place)}")


@test()
def a_host_learns_that_its_editor_has_gone(place):
    """Once, with the reason, and may free the handle there; not if it closed the window."""
    server = place.server()
    host = place.told(server)
    ends = {"user": 0, "all": 1, "destroyed": 2, "killed": 3, "own": None, "server": 3}
    for number, (way, reason) in enumerate(ends.items()):
        host.edit(number)
        window = server.new_window()
        host.tell(f"within-gone close {number}", "within-gone")
        if way == "user":
            server.press(window, "ctrl+q")
        elif way == "all":
            host.send("quit 0")
        elif way == "destroyed":
            server.xdotool("windowclose", window)
        elif way == "killed":
            server.xdotool("windowkill", window)
        elif way == "own":
            host.tell(f"close {number}", "closed 0")
            host.tell("within-gone ", "within-gone")
        else:
            server.kill()
        if reason is not None:
            host.expect(f"gone {number} {reason} thread own")
            host.expect("closed 0")
    told = [line for line in host.said if line.startswith("gone")]
    check(len(told) == len(ends) - 1, f"told {told}")
    host.leave()


@test(kinds=BOTH)
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


@test(kinds=BOTH)
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


@test(kinds=BOTH)
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


@test(kinds=BOTH)
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
