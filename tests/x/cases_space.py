"""Dragging in the movement window, across the server: what the pointer does and
what the path then is."""

import math
import random
import signal

from cases_window import opened
from harness import check, wait
from panel import DONE, REST, rail_of
from run import test
from space import first_look

BUTTONS = {1: 0, 2: 1, 3: 2}
"""The coordinate that stays with each button."""



def moved(host, server, window, start, end, button, point):
    """Drags from pixel to pixel; the point's new position."""
    before = host.path()[point]
    server.drag(window, start, end, button, steps=3)
    wait(lambda: host.path()[point] != before, f"point {point} to move")
    server.drawn(window)
    return before, host.path()[point]


def without_object(place):
    """A host and its one window, in which a new path looks in a direction."""
    server = place.server()
    host = place.told(server, "loop_poll")
    host.tell("objectless 1")
    host.edit(0, "")
    return server, host, server.new_window()


def measured(server, host, window):
    """The space to a fraction of a pixel, by two drags."""
    space = server.seen(window, first_look, "the space")
    pairs = []
    for dx, dy in ((60, -40), (-90, 70)):
        at = space.image(host.path()[0])
        to = (round(at[0]) + dx, round(at[1]) + dy)
        _, now = moved(host, server, window, at, to, 3, 0)
        pairs.append((now, to))
        if len(pairs) == 1:  # the first drag begins a few pixels off
            off = [to[k] - space.image(now)[k] for k in (0, 1)]
            space.middle = tuple(space.middle[k] + off[k] for k in (0, 1))
    return space.fitted(pairs)


@test(first=True)
def dragged_points_follow_the_pointer(place):
    """Within half a pixel, in all three planes; the plane's coordinate keeps every bit."""
    server, host, window = opened(place)
    space = measured(server, host, window)
    chance = random.Random(1994)
    for turn in range(24):
        button = 1 + turn % 3
        at = space.image(host.path()[0])
        # To somewhere inside the cube, in that plane.
        goal = list(host.path()[0])
        for k in range(3):
            if k != BUTTONS[button]:
                goal[k] = chance.uniform(-0.9, 0.9)
        to = tuple(round(value) for value in space.image(goal))
        if math.dist(at, to) < 12 or math.dist(to, space.image(host.path()[1])) < 12:
            continue
        before, now = moved(host, server, window, at, to, button, 0)
        fixed = BUTTONS[button]
        check(before[fixed] == now[fixed], f"button {button} moved {before} to {now}")
        seen = space.image(now)
        check(math.dist(seen, to) <= 0.5, f"button {button}: seen at {seen}, pointer at {to}")
        check(all(abs(value) <= 1 for value in now), f"outside: {now}")
    count = len(host.path())
    server.press(window, *["ctrl+z"] * 3)  # each drag is one step
    host.live()
    check(len(host.path()) == count, "undo took a point away")
    host.leave()


@test()
def a_drag_ends_at_the_faces_of_the_cube(place):
    """Then the point leaves the pointer."""
    server, host, window = opened(place)
    space = measured(server, host, window)
    at = space.image(host.path()[0])
    beyond = space.image((3.0, 0.2, host.path()[0][2]))
    before, now = moved(host, server, window, at, beyond, 3, 0)
    check(now[0] == 1.0 and now[2] == before[2], f"{now}")
    host.leave()


@test()
def several_points_are_moved_at_once(place):
    """Two of three, chosen by Shift and a click: by a drag, and by M, X and a number; each
    is one step."""
    server, host, window = opened(place)
    space = measured(server, host, window)
    server.press(window, "Insert")  # one more between the two
    wait(lambda: len(host.path()) == 3, "a point more")
    server.drawn(window)
    first = host.path()

    def moves(act, wanted):
        before = host.path()
        act()
        wait(lambda: host.path() != before, "points to move")
        server.drawn(window)
        now = host.path()
        ways = [[b - a for a, b in zip(*pair)] for pair in zip(before, now)]
        check(math.dist(ways[1], (0, 0, 0)) == 0, f"the one in between moved by {ways[1]}")
        check(math.dist(ways[0], ways[2]) < 1e-12, f"{ways[0]} is not {ways[2]}")
        check(wanted(ways[0]), f"{ways[0]}")

    server.click(window, *space.image(first[0]))
    x, y = space.image(first[2])
    server.xdotool("keydown", "shift", "mousemove", "--window", window, round(x), round(y),
                   "click", 1, "keyup", "shift")
    server.drawn(window)
    at = space.image(first[2])
    to = (round(at[0]) - 20, round(at[1]) - 25)
    moves(lambda: server.drag(window, at, to, 3, steps=3), lambda way: way[2] == 0)
    moves(lambda: server.press(window, "m", "x", "minus", "0", "period", "0", "3", "Return"),
          lambda way: math.dist(way, (-0.03, 0, 0)) < 1e-12)
    server.press(window, "ctrl+z", "ctrl+z")
    wait(lambda: host.path() == first, "both steps to be taken back")
    host.leave()


@test()
def the_tip_of_the_view_is_dragged(place):
    """VPN's tip moves as points do; of a relative one the offset changes, the point stays."""
    server, host, window = without_object(place)
    space = measured(server, host, window)
    position = host.path()[0]
    words = host.tell("orientation 0 0 0").split()
    tip = [position[k] + float(words[3 + k]) for k in range(3)]
    at = space.image(tip)
    to = (round(at[0]) + 50, round(at[1]) - 30)
    server.drag(window, at, to, 3, steps=3)
    wait(lambda: host.tell("orientation 0 0 0").split() != words, "the view to turn")
    server.drawn(window)
    words = host.tell("orientation 0 0 0").split()
    check(host.path()[0] == position, "the point moved, too")
    now = [position[k] + float(words[3 + k]) for k in range(3)]
    check(math.dist(space.image(now), to) <= 0.5, f"{space.image(now)}, pointer at {to}")
    check(math.isclose(now[2], tip[2], abs_tol=1e-15), f"{tip} became {now}")
    host.leave()


@test()
def the_tip_of_up_is_dragged(place):
    """VUP turns until it points to the pointer: roll, and nothing else, changes."""
    server, host, window = without_object(place)
    space = measured(server, host, window)
    position = host.path()[0]
    before = host.tell("orientation 0 0 0").split()
    picture = server.drawn(window)
    green = picture.find((0xA0, 0xF0, 0xB0), 30)
    centre = space.image(position)
    check(green, "no VUP to be seen")
    tip = max(green, key=lambda pixel: math.dist(pixel, centre))
    to = (round(centre[0] + 60), round(centre[1] - 40))
    server.drag(window, tip, to, 1, steps=4)
    wait(lambda: host.tell("orientation 0 0 0").split()[7] != before[7], "the roll to change")
    server.drawn(window)
    after = host.tell("orientation 0 0 0").split()
    check(after[3:6] == before[3:6], "the view moved, too")
    # VPN is (0, 0, -1): roll turns VUP in the plane of x and y.
    roll = math.radians(float(after[7]))
    best = min((math.dist(_direction(space, sign * roll), _unit(to, centre)), sign)
               for sign in (1, -1))
    check(best[0] < math.radians(0.1) + 0.5 / math.dist(to, centre), f"{best}")
    host.leave()


def _unit(to, centre):
    length = math.dist(to, centre)
    return (to[0] - centre[0]) / length, (to[1] - centre[1]) / length


def _direction(space, roll):
    return _unit(space.flat((math.sin(roll), math.cos(roll), 0.0)), (0.0, 0.0))


@test()
def the_view_turns_and_grows(place):
    """Dragging empty space rotates and tilts, the wheel changes the size; the path stays."""
    server, host, window = opened(place)
    path = host.path()
    for what in ("drag", "wheel"):
        before = server.drawn(window)
        _, _, width, height = server.geometry(window)
        if what == "drag":
            server.drag(window, (width * 0.65, height * 0.65), (width * 0.55, height * 0.6))
        else:
            server.click(window, width * 0.6, height * 0.5, 4)
        wait(lambda: server.picture(window).differs(before), f"{what}: another picture")
    check(host.path() == path, "looking changed the path")
    host.leave()


@test()
def clicks_whose_press_and_release_come_together_meet_the_play_bar(place):
    """As a host finds them that was busy meanwhile: all of twenty."""
    server, host, window = opened(place)
    left, right, row = server.seen(window, rail_of, "the rail")
    check(right - left > 150, f"no rail: {left} to {right}")
    for turn in range(20):
        x = round(left + (right - left) * (0.08 + 0.84 * (turn * 7 % 20) / 19))
        host.process.send_signal(signal.SIGSTOP)
        server.click(window, x, row)
        host.process.send_signal(signal.SIGCONT)
        wait(lambda: stands_at(server.picture(window), x, row), f"click {turn + 1} to be met")
    host.leave()


def stands_at(picture, x, row):
    """Whether the playhead does: before it the rail is done, behind it is not."""
    places = (-18, DONE), (18, REST)
    return all(max(abs(a - b) for a, b in zip(picture.pixel(x + by, row), colour)) < 12
               for by, colour in places)
