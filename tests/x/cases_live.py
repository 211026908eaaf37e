"""The host's own picture beside the window: it is told of the flight while that is
planned, gives its view, and serves windows that follow it."""

import math
import os
import statistics
import sys
import time

from harness import Watch, check, run, wait
from run import test
from space import first_look

SELECTED, EDITED, SCRUBBED, PLAYED, RESTED = range(5)


class Views:
    """What `views` of loop_live.c says."""

    def __init__(self, line):
        words = line.split()
        (self.count, self.others, self.changes, self.captures,
         self.handed_over) = map(int, words[1:6])
        self.reason = int(words[7])
        self.frame, *pose = map(float, words[8:])
        self.vrp, self.vpn, self.vup, self.zoom = pose[0:3], pose[3:6], pose[6:9], pose[9]


def views(host):
    """How things stand."""
    return Views(host.tell("views"))


def points(host):
    """The points' positions."""
    values = [float(word) for word in host.tell("points").split()[2:]]
    return [values[i:i + 3] for i in range(0, len(values), 3)]


def rested(host, more_than=0):
    """Waits until the host knows that nothing moves any more."""
    return wait(lambda: (now := views(host)).reason == RESTED and now.count > more_than and now,
                "the host to be told of the rest")


def opened(place, file="", **variables):
    """A window with a host that watches."""
    server = place.server()
    host = place.told(server, "loop_live", **variables)
    check(host.tell(f"live {file}").split()[1] == "0", "v_editor_open")
    window = server.new_window()
    server.xdotool("mousemove", "--window", window, 400, 100)
    return server, host, window, rested(host)


def path_of(place, frames, fps):
    """A file with a straight flight of about so many frames."""
    file = place.path("flight.vid")
    with open(file, "w", encoding="ascii") as out:
        out.write(f"version = 1\nfps = {fps}.0\n[base_speeds]\nmove_frames = {frames}.0\n"
                  "turn_frames = 100.0\nzoom_frames = 100.0\nroll_frames = 100.0\n")
        for x in (-0.5, 0.5):
            out.write(f"[[point]]\nposition = [{x}, 0.0, 0.0]\n"
                      "[[point.orientation]]\ntarget = [0.0, 0.0, -5.0]\n")
    return file


@test()
def a_preview_is_not_the_hosts(place):
    """While a tool is shown the host is told nothing and gets the path without it; OK tells it."""
    server, host, window, now = opened(place, LC_ALL="en_GB.UTF-8")
    before = points(host)
    quiet = server.drawn(window)
    # The first tool: an orbit.
    server.press(window, "alt+o", "Return")
    wait(lambda: server.picture(window).differs(quiet), "the tool")
    server.drawn(window)
    shown = views(host)
    check(shown.changes == now.changes and shown.count == now.count and shown.vrp == now.vrp,
          f"told of a preview: {vars(shown)}")
    check(points(host) == before, "the host has what the tool shows")
    server.press(window, "Return")
    wait(lambda: views(host).changes == now.changes + 1, "OK")
    check(len(points(host)) > len(before), "the orbit")
    host.leave()


@test()
def the_host_is_told_what_is_done(place):
    """Each pose is the path's to the last bit; a row of them ends with a rest."""
    server, host, window, now = opened(place)
    check(now.count == 2 and now.changes == 0, f"at first: {vars(now)}")
    server.press(window, "ctrl+Next")
    now = rested(host, now.count)
    check(now.vrp == points(host)[1], f"another point: {vars(now)}")
    server.press(window, "alt+Insert")
    wait(lambda: views(host).changes == 1, "a change")
    server.press(window, "ctrl+z")
    wait(lambda: views(host).changes == 2, "undo")
    server.press(window, "ctrl+y")
    wait(lambda: views(host).changes == 3, "redo")
    server.press(window, "ctrl+Prior")
    now = rested(host, now.count)

    space = server.seen(window, first_look, "the space")
    at = space.image(points(host)[0])
    to = (at[0] + 60, at[1] - 40)
    host.tell("reset")
    words = server.drag_words(window, at, to, 3, 12, release=False)
    server.xdotool(*words)
    during = wait(lambda: (now := views(host)).count > 0 and now, "the drag")
    check(during.reason == EDITED and during.changes == 3, f"in the drag: {vars(during)}")
    time.sleep(0.3)  # held: that is no rest
    check(views(host).reason == EDITED, "a rest while it is held")
    server.xdotool("mouseup", 3)
    now = rested(host)
    check(now.vrp == points(host)[0], f"the drag's end: {vars(now)}")
    wait(lambda: views(host).changes == 4, "the drag's one change")

    check(host.tell("frame 20.25").split()[1] == "0", "v_editor_set_frame")
    now = rested(host, now.count)
    check(now.frame == 20.25 == float(host.tell("at").split()[2]), f"the frame: {vars(now)}")
    check(host.tell("frame 0.5").split()[1] == "4", "a frame that there is not")
    check(host.tell("select 1 0").split()[1] == "0", "v_editor_select")
    now = rested(host, now.count)
    check(now.vrp == points(host)[1], "the selected point")
    check(host.tell("select 1 9").split()[1] == "4", "a key that there is not")
    check(now.others == 0, f"{now.others} poses are not those of v_path_pose()")
    host.leave()


@test()
def the_host_goes_through_the_history(place):
    """One step at a time, its own and the user's; several of them become one."""
    server, host, window, now = opened(place)
    steps = lambda what: host.tell(what).split()[1]
    first = points(host)
    check(steps("undo") == "3" and steps("redo") == "3", "a step where there is none")
    check(steps("step 0") == "0", "the end of nothing")
    server.press(window, "Insert")
    wait(lambda: len(points(host)) == 3, "a point")
    one_more = points(host)
    check(steps("step 1") == "0", "v_editor_begin_step")
    for count in (4, 5):
        server.press(window, "Insert")
        wait(lambda count=count: len(points(host)) == count, "a point more")
    many = points(host)
    check(steps("step 0") == "0", "v_editor_end_step")
    for _ in range(2):
        check(steps("undo") == "0" and points(host) == one_more, "both taken back")
        check(steps("redo") == "0" and points(host) == many, "both done again")
    server.press(window, "ctrl+z")
    wait(lambda: points(host) == one_more, "both taken back by the user")
    check(steps("undo") == "0" and points(host) == first, "the first one taken back")
    check(host.tell("select 1 0").split()[1] == "0" and host.tell("current") == "current 0 1 0",
          "v_editor_get_selection")
    server.press(window, "ctrl+Prior")
    wait(lambda: host.tell("current") == "current 0 0 0", "what the user has chosen")
    check(host.tell("plays") == "plays 0 0", "it plays already")
    check(host.tell("play 1").split()[1] == "0" and host.tell("plays") == "plays 0 1", "it plays")
    wait(lambda: views(host).reason == PLAYED, "a frame that is played")
    check(host.tell("plays") == "plays 0 1", "it goes on playing")
    check(host.tell("play 0").split()[1] == "0" and host.tell("plays") == "plays 0 0", "it stops")
    rested(host)
    check(host.tell("plays") == "plays 0 0", "it has stopped")
    host.leave()


@test()
def the_hosts_view_is_taken_over(place):
    """By key; to the last digits; what is no view is refused."""
    server, host, window, now = opened(place)
    turn, lean, roll = 2.1, 0.4, 0.7
    view = [math.sin(turn) * math.cos(lean), math.sin(lean), math.cos(turn) * math.cos(lean)]
    right = [math.cos(turn), 0.0, -math.sin(turn)]
    over = [right[1] * view[2] - right[2] * view[1], right[2] * view[0] - right[0] * view[2],
            right[0] * view[1] - right[1] * view[0]]
    over = [-x for x in over] if over[1] < 0 else over
    up = [math.cos(roll) * over[k] + math.sin(roll) * right[k] for k in range(3)]
    numbers = [0.3, 0.5, -0.2] + [7 * x for x in view] + [0.01 * x for x in up] + [42.5]
    words = " ".join(f"{x:.17g}" for x in numbers)
    check(host.tell(f"camera {words}") == "camera 1", "a camera")
    check(host.tell("ghost 1").split()[1] == "0", "v_editor_set_view")
    server.drawn(window)
    for key, count in (("ctrl+Return", 3), ("ctrl+shift+Return", 3)):
        server.press(window, key)
        now = rested(host, now.count)
        check(len(points(host)) == count, f"{key}: {points(host)}")
        check(now.vrp == numbers[:3] and now.zoom == 42.5, f"{key}: {vars(now)}")
        check(math.dist(now.vpn, view) < 1e-12, f"{key}: {now.vpn}, not {view}")
        check(math.dist(now.vup, up) < 1e-12, f"{key}: {now.vup}, not {up}")
        if key == "ctrl+Return":  # back to the first point, to be replaced
            check(host.tell("frame 1").split()[1] == "0", "v_editor_set_frame")
            now = rested(host, now.count)
    check(now.captures == 2, f"asked {now.captures} times")
    check(host.tell("camera 0 0 0 0 0 1 0 0 -2 24") == "camera 1", "a camera")
    check(host.tell("ghost 1").split()[1] == "3", "a view whose up lies along it")
    before = server.drawn(window)
    server.press(window, "ctrl+Return")
    wait(lambda: views(host).captures == 3, "the question")
    wait(lambda: server.picture(window).rows != before.rows, "a sentence")
    check(len(points(host)) == 3, "a point of no view")
    check(host.tell("ghost 0").split()[1] == "0", "no view")
    host.leave()


@test()
def hosts_do_odd_things_in_on_view(place):
    """They change what they are told of, never come back for long, close the window."""
    server, host, window, now = opened(place)
    for word in ("frame", "select", "object"):
        host.tell(f"in-view {word}")
        before = views(host)
        server.press(window, "ctrl+Next")
        check(host.expect("within").split()[1] == "0", word)
        now = rested(host, before.count + 1)
        check(now.count <= before.count + 2 and now.changes == before.changes,
              f"{word}: called for itself: {vars(now)}")
        check(now.others == 0, f"{word}: other poses")
    frame = float(host.tell("at").split()[2])
    check(frame == now.frame, f"told of {now.frame}, is at {frame}")

    # Ten seconds; what is done meanwhile is not lost.
    space = server.seen(window, first_look, "the space")
    for point in (1, 0):
        host.tell(f"select {point} 0")
        now = rested(host, now.count)
    at = space.image(points(host)[0])
    to = (at[0] + 70, at[1] - 30)
    host.tell("in-view sleep")
    server.xdotool(*server.drag_words(window, at, to, 3, 12))
    host.expect("within")
    now = rested(host, now.count)
    check(now.vrp == points(host)[0] and now.others == 0, f"after the sleep: {vars(now)}")
    check(math.dist(space.image(now.vrp), to) < 4, "the drag's end")

    host.tell("in-view close")
    server.press(window, "ctrl+Next")
    check(host.expect("within").split()[1] == "0", "closing")
    server.gone(window)
    host.live()
    host.leave()


@test()
def windows_do_what_the_host_says(place):
    """Title, saving, raising; its Quit asks, and a user may say no."""
    server, host, window, _ = opened(place)
    check(host.tell("title Probe").split()[1] == "0", "v_editor_set_title")
    wait(lambda: "Probe" in server.property(window, "_NET_WM_NAME"), "the title")
    check(host.tell("modified").split()[2] == "0", "nothing is modified")
    check(host.tell("keep").split()[1] == "3", "it has no file")
    server.press(window, "alt+Insert")
    wait(lambda: host.tell("modified").split()[2] == "1", "a modified path")
    check(host.tell("raise").split()[1] == "0", "v_editor_raise")

    before = server.drawn(window)
    host.send("quit 1")
    wait(lambda: server.picture(window).rows != before.rows, "the question")
    server.drawn(window)
    server.press(window, "Escape")
    check(host.expect("quit").split()[1] == "14", "the user said no")
    file = place.path("kept.vid")
    check(host.tell(f"keep {file}").split()[1] == "0" and os.path.exists(file), "saving")
    check(host.tell("modified").split()[2] == "0", "it is saved")
    with open(file, "a", encoding="ascii") as other:
        other.write("# another program\n")
    check(host.tell("keep").split()[1] == "3", "the file has changed")
    check(host.tell("quit 1").split()[1] == "0", "nobody said no")
    server.gone(window)
    check(host.tell("frame 1").split()[1] == "12", "a window that is closed")
    check(host.tell("quit 0").split()[1] == "0", "no windows")
    host.leave()


@test()
def old_hosts_get_the_flight_continuously(place):
    """Not recompiled: the menu is ticked, and every change comes by rueck."""
    server = place.server()
    program = place.program(server, "pyramid_motif")
    host = server.window("^MainTest$")
    server.place(host, 1500, 600)
    _, _, width, height = server.geometry(host)
    server.xdotool("windowraise", host)
    server.click(host, width / 2, height / 6)
    window = server.new_window()
    server.press(window, "alt+a", "l")
    program.expect("121 poses came")
    server.press(window, "alt+Insert")  # changes no pose
    program.expect("121 poses came")
    server.press(window, "ctrl+z")
    program.expect("121 poses came")

    def handed():
        return sum(line.endswith("poses came") for line in list(program.said))

    space = server.seen(window, first_look, "the space")
    at = space.image((-0.6, 0.2, 0.8))
    before = handed()
    server.xdotool(*server.drag_words(window, at, (at[0] - 60, at[1]), 3, 12, release=False))
    wait(lambda: handed() > before, "poses while it is dragged")
    server.xdotool("mouseup", 3)
    server.press(window, "alt+a", "l")
    program.idle()
    before = handed()
    server.press(window, "alt+Insert")
    program.idle()
    check(handed() == before, "poses although it is not ticked")
    check(not program.complained, f"it complained: {program.complained}")


def logged(place, host):
    """Every call of on_view: milliseconds, frame, reason."""
    file = place.path("log")
    host.tell(f"log {file}")
    with open(file, encoding="ascii") as lines:
        return [tuple(map(float, line.split())) for line in lines]


@test(kinds=("shared",), at_once=1)
def playing_keeps_the_clock(place):
    """10 s at 60 frames a second, with a host that takes 10 ms for each."""
    fps, seconds = 60, 10
    server, host, _, _ = opened(place, path_of(place, fps * seconds, fps))
    host.tell("delay 10")
    host.tell("clocked 1")
    host.tell("reset")
    watch, begun = Watch(host.pid), time.monotonic()
    host.tell("play 1")
    time.sleep(seconds)
    rested(host)
    waited = (time.monotonic() - begun - watch.seconds()) / seconds
    calls = logged(place, host)
    played = [(at, frame) for at, frame, reason in calls if reason == PLAYED]
    # Against the first: when each frame should have been there, in frames.
    began, first = played[0]
    late = [(at - began) / 1000 * fps - (frame - first) for at, frame in played]
    over = sum(1 for one in late if one > 2) / len(late)
    taken = (played[-1][0] - began) / 1000
    due = (played[-1][1] - first) / fps
    drift = statistics.median(late[-30:])
    print(f"playing: {len(played)} of {fps * seconds} frames, {100 * over:.1f} % late by more "
          f"than one, last frame {played[-1][1]:g} after {taken:.3f} s instead of {due:.3f} s",
          flush=True)
    # A busy machine makes a picture late now and then; the next is in time again.
    check(over <= 0.05 + waited, f"{100 * over:.1f} % late")
    check(abs(drift) < 2, f"the clock: {drift:.1f} frames late at the end")
    check(calls[-1][2] == RESTED and calls[-1][1] == played[-1][1], f"the end: {calls[-1]}")
    host.leave()


@test(kinds=("shared",), at_once=1)
def a_host_that_takes_200_ms(place):
    """The drag's end is right, and no call of v_dispatch() is long."""
    server, host, window, _ = opened(place)
    space = server.seen(window, first_look, "the space")
    at = space.image(points(host)[0])
    to = (at[0] + 80, at[1] - 50)
    host.tell("delay 200")
    host.tell("reset")
    for step in range(12):
        words = server.drag_words(window, at, to, 3, 12, release=False) if step == 0 else [
            "mousemove", "--window", window, round(to[0]) - step % 2, round(to[1])]
        server.xdotool(*words)
        time.sleep(0.05)
    server.xdotool("mousemove", "--window", window, round(to[0]), round(to[1]), "mouseup", 3)
    now = rested(host)
    words = host.tell("longest").split()
    longest, most = float(words[1]), int(words[3])
    print(f"a host of 200 ms: {now.count} calls, longest v_dispatch {longest:.0f} ms", flush=True)
    check(now.vrp == points(host)[0] and now.others == 0, f"the end: {vars(now)}")
    check(math.dist(space.image(now.vrp), to) < 4, "the drag's end")
    check(most <= 2, f"v_dispatch called the host {most} times")
    host.leave()


class Told:
    """What `told` of stacked.c says of one window."""

    def __init__(self, host, which):
        words = host.tell(f"told {which}").split()[1:]
        (self.views, self.frames, self.changes, self.poses, self.played,
         self.reason) = map(int, words[:6])
        self.frame = float(words[6])


def hears_all(host, which):
    """A window that nobody sees: its host is told of all that is done there, and at once."""
    at_rest = wait(lambda: (now := Told(host, which)).reason == RESTED and now, f"a rest of {which}")
    check(host.tell(f"go {which} 20.25") == "go 0 1 1", f"v_editor_set_frame of {which}")
    check(Told(host, which).frame == 20.25, f"the frame of {which}")
    wait(lambda: Told(host, which).reason == RESTED, f"a rest of {which}")
    check(host.tell(f"alter {which} {0.125 + at_rest.views}") == "alter 0 1 1",
          f"v_editor_set_path of {which}")
    wait(lambda: Told(host, which).reason == RESTED, f"a rest of {which}")
    check(host.tell(f"select {which} 1") == "select 0 1 1", f"v_editor_select of {which}")
    host.tell(f"go {which} 1")
    before = Told(host, which).played
    host.tell(f"play {which} 1")
    wait(lambda: Told(host, which).played >= before + 5, f"playing of {which}")
    host.tell(f"play {which} 0")
    wait(lambda: Told(host, which).reason == RESTED, f"the end of playing of {which}")


@test()
def windows_behind_others_tell_their_host(place):
    """Of three, two are wholly covered; one more is in a parent that is not shown."""
    server = place.server()
    host = place.told(server, "stacked")
    windows = []
    for which in range(3):  # all at one place
        check(host.tell(f"open {which}").split()[1] == "0", "v_editor_open")
        windows.append(server.new_window(*windows))
        server.xdotool("windowraise", windows[-1])
    check(host.tell("open-unseen 3", "open").split()[1] == "0", "v_editor_open")
    places = {server.geometry(window) for window in windows}
    check(len(places) == 1, f"they do not cover each other: {places}")
    for which in range(4):
        hears_all(host, which)

    # The user plays one that lies behind, and another hands its poses over continuously.
    host.tell("go 0 1")
    before = Told(host, 0).played
    server.xdotool("windowfocus", "--sync", windows[0], "key", "F5")
    wait(lambda: Told(host, 0).played >= before + 5, "playing by the user")
    server.xdotool("key", "F5")
    server.xdotool("windowfocus", "--sync", windows[1], "key", "--delay", "100", "alt+a", "l")
    wait(lambda: Told(host, 1).poses > 0, "poses")
    before = Told(host, 1).poses
    host.tell("alter 1 0.75")
    wait(lambda: Told(host, 1).poses > before, "poses after a change")
    host.idle()  # nobody is woken
    host.leave()


@test()
def iconified_windows_tell_their_host(place):
    """And those on another desktop."""
    server = place.server()
    server.window_manager()
    host = place.told(server, "stacked")
    check(host.tell("open 0").split()[1] == "0", "v_editor_open")
    window = server.new_window()
    server.xdotool("windowminimize", "--sync", window)
    wait(lambda: window not in server.windows(), "the icon")
    hears_all(host, 0)
    check(host.tell("open 1").split()[1] == "0", "v_editor_open")
    window = server.new_window()
    server.xdotool("set_desktop_for_window", window, 1)
    wait(lambda: window not in server.windows(), "the other desktop")
    hears_all(host, 1)
    host.idle()
    host.leave()


@test(kinds=("shared",))
def a_host_by_ctypes_is_told(place):
    """It calls v_editor_options_init() itself, not the macro of C."""
    server = place.server()
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "by_ctypes.py")
    said = run(sys.executable, script, env=server.env).decode().splitlines()
    size, told, shorter = (line.split() for line in said)
    check(size[1] == size[3], f"of the options it knows {size[1]} bytes, of {size[3]}")
    check(told[1] == "True", "on_view was not called")
    check(shorter[1] == "5", f"a shorter struct: status {shorter[1]}")


@test()
def a_host_changes_the_scene_while_it_is_dragged(place):
    """The drag ends where it has come to; neither loses what it did, and both are undone step by
    step."""
    server = place.server()
    host = place.told(server, "meanwhile")

    def nodes():
        told = (node.split(":") for node in host.tell("nodes").split()[1:])
        return {name: tuple(map(float, at.split(","))) for name, at in told}

    window = server.new_window()
    at = server.seen(window, first_look, "the space").image((0, 0, 0))
    first = nodes()
    check(first == {"lamp": (0, 0, 0), "old": (0.5, 0, 0), "box": (1, 0, 0)}, first)
    server.click(window, *at)
    server.press(window, "m")
    server.xdotool("mousemove_relative", "--sync", 20, 10)
    dragged = wait(lambda: (now := nodes()) != first and now, "the node to move")
    check(dragged == {**first, "lamp": dragged["lamp"]}, dragged)
    check(host.tell("change", "changed") == "changed 0", "v_editor_set_scene()")
    changed = {"lamp": dragged["lamp"], "box": (1, 1, 0), "host": (0, 0, 0)}
    check(nodes() == changed, f"the host's and the user's: {nodes()}")
    server.xdotool("mousemove_relative", "--sync", 20, 10)
    server.press(window, "Return")
    server.drawn(window)
    check(nodes() == changed, f"after the drag: {nodes()}")
    for before, what in ((dragged, "what the host did"), (first, "the drag")):
        server.press(window, "ctrl+z")
        wait(lambda: nodes() == before, f"{what} to be undone")  # pylint: disable=cell-var-from-loop
    server.press(window, "ctrl+y", "ctrl+y")
    wait(lambda: nodes() == changed, "both to be done again")
    host.send("leave")
    check(host.ends() == 0, f"its exit status; it complained: {host.complained}")
