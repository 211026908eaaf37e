"""The tools of the window: chosen, shown live, taken or left, by keyboard and mouse."""

import math
import os

from cases_window import opened
from harness import Watch, check, spent, wait
from panel import CHOSEN, PANEL
from run import test


@test()
def an_orbit_is_shown_taken_and_undone(place):
    """In both languages, by the keyboard: one step, all of it taken back."""
    for locale, menu in (("de_DE.UTF-8", "alt+w"), ("en_GB.UTF-8", "alt+o")):
        server, host, window = opened(place, LC_ALL=locale)
        before = host.path()
        quiet = server.drawn(window)
        # The first tool of the menu; Escape leaves all as it was.
        server.press(window, menu, "Return")
        wait(lambda: server.picture(window).differs(quiet), "the tool")
        server.drawn(window)
        check(host.path() == before, "the host has what the tool shows")
        server.press(window, "Escape")
        server.drawn(window)
        check(host.path() == before, "it was left, and changed the path")
        server.press(window, menu, "Return")
        server.drawn(window)
        server.press(window, "Return")
        server.drawn(window)
        points = wait(lambda: len(host.path()) > len(before) and host.path(), "an orbit")
        # Around the middle of the space, at the same height and distance.
        first = math.hypot(points[0][0], points[0][2])
        for x, y, z in points:
            check(abs(math.hypot(x, z) - first) < 1e-9 and y == points[0][1], f"{x, y, z}")
        server.press(window, "ctrl+z")
        wait(lambda: host.path() == before, "the path to be as before")
        host.leave()


@test()
def findings_are_listed_and_lead_to_their_frame(place):
    """The last entry of the menu checks the path: of a new one it finds nothing; where
    a point was put outside it is listed, and a click goes there."""
    server, host, window = opened(place, LC_ALL="en_GB.UTF-8")
    server.press(window, "alt+o", "Up", "Return")
    quiet = server.drawn(window)

    def rows():
        # The frames of each, as words in the colour of what is clicked.
        picture = server.drawn(window)
        left = picture.width - PANEL
        return [(x, y) for x, y in picture.find(CHOSEN) if x > left and 100 < y < 620]

    check(not rows(), "findings of a new path")
    # Two views at one point that are equal: one of them would do.
    server.press(window, "alt+Insert")
    wait(lambda: server.picture(window).differs(quiet), "another view")
    found = wait(rows, "a finding")
    before = server.drawn(window)
    server.click(window, *found[len(found) // 2])
    wait(lambda: server.picture(window).differs(before), "the playhead to go there")
    server.press(window, "Escape")
    host.leave()


def ball(file, rings):
    """A mesh of some 2 × rings² triangles."""
    with open(file, "w") as out:
        for i in range(rings + 1):
            for j in range(rings):
                down, round = math.pi * i / rings, 2 * math.pi * j / rings
                out.write(f"v {math.sin(down) * math.cos(round):.6f} {math.cos(down):.6f} "
                          f"{math.sin(down) * math.sin(round):.6f}\n")
        for i in range(rings):
            for j in range(rings):
                a, b = i * rings + j, i * rings + (j + 1) % rings
                out.write(f"f {a + 1} {a + rings + 1} {b + 1}\nf {b + 1} {a + rings + 1} {b + rings + 1}\n")


def workers(host):
    """The signals that are blocked in each thread that works beside the window."""
    found = []
    for task in os.listdir(f"/proc/{host.pid}/task"):
        try:
            with open(f"/proc/{host.pid}/task/{task}/status") as file:
                said = dict(line.rstrip("\n").split(":\t", 1) for line in file if ":\t" in line)
        except (FileNotFoundError, ProcessLookupError):  # it has ended meanwhile
            continue
        if said["Name"] == "vides work":
            found.append(int(said["SigBlk"], 16))
    return found


@test()
def a_tour_is_planned_beside_a_host(place):
    """The host is served meanwhile and takes its signals; closing the window ends the work."""
    ball(place.path("ball.obj"), 500)
    with open(place.path("ball.vid"), "w") as file:
        file.write("""version = 1
[space]
half_size = 2.0
[object]
file = "ball.obj"
[[point]]
position = [-1.9, 0, 0]
orientation = [{ target = [0, 0, 0] }]
[[point]]
position = [0, 1.9, 0]
orientation = [{ target = [0, 0, 0] }]
""")
    server = place.server()
    host = place.told(server, LC_ALL="en_GB.UTF-8")
    host.tell("objectless 1")
    host.edit(0, "ball.vid")
    window = server.new_window()
    before = host.path()
    check(not workers(host), "a thread before there is work")
    for way in ("Escape", "close"):
        server.press(window, "alt+w", *["Up"] * 19, "Return")
        blocked = wait(lambda: workers(host), "a thread")
        # All but those that cannot be blocked and the C library's own two.
        for signal in (1, 2, 3, 10, 12, 13, 14, 15, 17, 20, 28):
            check(blocked[0] >> (signal - 1) & 1, f"signal {signal} would go to the thread")
        watch = Watch(host.pid)
        host.live()
        check(watch.seconds() < 1, f"it answers after {watch.seconds():.1f} s")
        if way == "Escape":
            server.press(window, "Escape")
            wait(lambda: not workers(host), "the thread to end")
            check(host.path() == before, "it was left, and changed the path")
        else:
            before = spent(host.pid)
            host.tell("close 0", "closed 0")
            more = spent(host.pid) - before
            check(more < 5, f"it works for {more:.1f} s more")
            wait(lambda: not workers(host), "the thread to end")
    host.leave()
