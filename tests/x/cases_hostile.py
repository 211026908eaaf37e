"""Ways to a server that lack something, and other clients that mean it ill."""

import os
import time

from cases_hosts import POSES, hand_over
from cases_window import opened
from harness import Program, Watch, check, private, run, wait
from proxy import Proxy
from run import test

FLOOD = float(os.environ.get("VIDES_FLOOD", "4"))
"""Seconds for which events are sent. `make soak` takes a minute."""


# ---- Ways to a server ------------------------------------------------------------------

def works(place, server, env):
    """Mouse, keyboard and hand-over in a window that is opened with this environment."""
    host = place.told(server, **{name: env[name] for name in ("DISPLAY", "XAUTHORITY")})
    host.edit(0)
    window = server.window()
    before = server.drawn(window)
    server.drag(window, (600, 400), (680, 430))
    wait(lambda: server.picture(window).differs(before), "the view to turn")
    hand_over(server, window)
    host.expect(f"poses 0 {POSES}")
    server.press(window, "alt+F4")
    host.expect("on_close")
    server.gone(window)
    host.leave()


@test()
def a_client_that_is_not_trusted(place):
    """As `ssh -X` connects: two extensions, and nothing of other clients."""
    server = place.server()
    env = server.untrusted()
    known = run("xdpyinfo", "-queryExtensions", env=env).decode()
    check("MIT-SHM" not in known and "XKEYBOARD" not in known, f"trusted: {known[-800:]}")
    works(place, server, env)


@test()
def by_way_of_the_network(place):
    """127.0.0.1:n, where no memory is shared."""
    server = place.server(options=("-listen", "tcp"))
    works(place, server, server.by_tcp())


@test()
def without_the_keyboard_extension(place):
    """The keys of the core protocol."""
    server = place.server()
    proxy = Proxy(server, ("XKEYBOARD", "MIT-SHM"))
    try:
        env = dict(server.env, DISPLAY=proxy.name)
        run("xauth", "-q", "-f", server.authority, "add", proxy.name, ".", server.key)
        works(place, server, env)
        check(proxy.asked == {"XKEYBOARD", "MIT-SHM"}, f"asked for {proxy.asked} only")
    finally:
        proxy.end()


@test()
def a_keyboard_map_that_changes(place):
    """Alt-U is another key on each; with the map of before it would be Alt-F or Alt-G."""
    server, host, window = opened(place)
    for layout in ("us", "dvorak", "us(colemak)", "us"):
        run("setxkbmap", *layout.rstrip(")").replace("(", " -variant ").split(), env=server.env)
        hand_over(server, window)
        host.expect(f"poses 0 {POSES}")
    host.leave()


@test()
def windows_of_one_pixel_and_of_8000(place):
    """Whatever size a window is given, it goes on, and the memory comes back."""
    server, host, window = opened(place)
    usual = private(host.pid)
    for width, height in ((1, 1), (8000, 8000), (1, 8000), (8000, 1), (1200, 800)):
        server.xdotool("windowsize", window, width, height)
        wait(lambda: server.geometry(window)[2:] == (width, height), "the new size")
        host.live()
        hand_over(server, window)
        host.expect(f"poses 0 {POSES}", 120)
    server.drawn(window)
    host.idle()
    check(private(host.pid) < usual + 40_000, f"{usual} kB became {private(host.pid)} kB")
    host.leave()


# ---- Other clients -----------------------------------------------------------------------

def flood(place, server, *words):
    """Starts somebody who means it ill."""
    program = Program(place.folder, [os.path.join(place.hosts, "flood"), *map(str, words)],
                      server.env)
    place.programs.append(program)
    program.expect("ready")
    return program


def another_is_as_usual(server, host, window):
    """Whatever events did in a window that is still there."""
    # xdotool's list is incomplete while windows come and go.
    wait(lambda: window in server.windows(visible=False), "the window")
    host.edit(1)
    others = lambda: [one for one in server.windows(visible=False) if one != window]
    other = wait(others, "another window")[0]
    server.drawn(other)
    hand_over(server, other)
    host.expect(f"poses 1 {POSES}")
    host.tell("close 1", "closed 0")


def lives_through(place, rate, seconds):
    """Events of every kind; the host answers meanwhile, and its other windows
    are served. Gives the host and how many events there were."""
    server, host, window = opened(place)
    host.tell("closing 0")  # some of the keys would close it
    warm = flood(place, server, "events", 1, min(rate, 1000) or 1000)
    warm.expect("done", 120)
    host.live()
    before = private(host.pid)
    sender = flood(place, server, "events", seconds, rate)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        host.live()
        time.sleep(0.02)
    sent = int(sender.expect("done", 120).split()[1])
    host.live()
    another_is_as_usual(server, host, window)
    return host, sent, before


@test(first=True)
def a_thousand_events_a_second(place):
    """Of every kind, from another client."""
    host, sent, before = lives_through(place, 1000, FLOOD)
    check(sent > 500 * FLOOD, f"only {sent} events were sent")
    # It need not come to rest: the keys among them may have begun to play a flight.
    grown = private(host.pid) - before
    check(grown < 20_000, f"{grown} kB more than before")
    host.leave()


def most(pid):
    """The most memory that a process ever had, in kB."""
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        return [int(line.split()[1]) for line in status if line.startswith("VmHWM:")][0]


@test(at_once=1)
def as_many_events_as_go(place):
    """Hundreds of thousands a second of every kind: the host's turns stay short."""
    host, sent, _ = lives_through(place, 0, 2)
    check(most(host.pid) < 150_000, f"{sent} events took up to {most(host.pid)} kB")
    host.leave()


@test(at_once=1)
def events_but_no_answers(place):
    """A client has the server for itself, and sends: what the window asks is not answered.
    That holds the host for a second, now and then; afterwards all is as before."""
    server, host, window = opened(place)
    host.tell("closing 0")  # some of the keys would close it
    sender = flood(place, server, "alone", 9, 1000)
    end = time.monotonic() + 9
    times = []
    while time.monotonic() < end:
        watch = Watch(host.pid)
        host.live()
        times.append(watch.seconds())
        time.sleep(0.02)
    sender.expect("done")
    # Each time again after a rest of five seconds.
    check(max(times) < 2, f"the host did not answer for {max(times):.1f} s")
    check(sum(took > 0.5 for took in times) <= 2, f"held: {sorted(times)[-4:]}")
    host.live()
    another_is_as_usual(server, host, window)
    host.leave()


def pastes(place, kind, said):
    """The user pastes from a clipboard whose owner means it ill."""
    server, host, window = opened(place)
    owner = flood(place, server, kind)
    before = private(host.pid)
    server.press(window, "alt+d")  # a field that takes text: the file window's
    server.press(window, "Escape")
    server.press(window, "alt+l")
    server.press(window, "ctrl+v")
    owner.expect(said)
    for _ in range(20):
        host.live()
        time.sleep(0.05)
    grown = private(host.pid) - before
    check(grown < 60_000, f"{grown} kB for a text without an end")
    server.press(window, "Escape")
    hand_over(server, window)
    host.expect(f"poses 0 {POSES}")
    host.leave()


@test()
def a_clipboard_that_does_not_answer(place):
    """Nobody waits for it."""
    pastes(place, "silent", "asked")


@test()
def a_clipboard_without_an_end(place):
    """Pieces that never end are not taken for ever."""
    pastes(place, "endless", "pieces 200")
