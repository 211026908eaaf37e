"""The tools of the window: chosen, shown live, taken or left, by keyboard and mouse."""

import math

from cases_window import opened
from harness import check, wait
from panel import BUTTON, PANEL, boxes
from run import test


@test()
def an_orbit_is_shown_taken_and_undone(place):
    """In both languages, by the keyboard: one step, all of it taken back."""
    for locale, menu in (("de_DE.UTF-8", "alt+w"), ("en_GB.UTF-8", "alt+t")):
        server, host, window = opened(place, LC_ALL=locale)
        before = host.path()
        quiet = server.drawn(window)
        # The first tool of the menu; Escape leaves all as it was.
        server.press(window, menu, "Return")
        wait(lambda: server.picture(window).differs(quiet), "the tool")
        server.drawn(window)
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
    server.press(window, "alt+t", "Up", "Return")
    quiet = server.drawn(window)

    def rows():
        # The frames of each, one below the other.
        picture = server.drawn(window)
        left, right = picture.width - PANEL, picture.width - PANEL / 2
        return boxes(picture, BUTTON, left, 100, int(right), 620, least=(80, 14))

    check(not rows(), "findings of a new path")
    # Two views at one point that are equal: one of them would do.
    server.press(window, "alt+Insert")
    wait(lambda: server.picture(window).differs(quiet), "another view")
    found = wait(rows, "a finding")
    before = server.drawn(window)
    x, y, width, height = found[0][0]
    server.click(window, x + width / 2, y + height / 2)
    wait(lambda: server.picture(window).differs(before), "the playhead to go there")
    server.press(window, "Escape")
    host.leave()
