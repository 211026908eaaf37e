"""The host's own view: with what a window begins, and a host that turns its object."""

from harness import check, wait
from run import test


@test()
def the_first_view_of_a_window(place):
    """A new path looks at the object, or begins with the view of the host's picture, which stays."""
    program = place.program(place.server(), "views", place.path("."))
    check(program.ends() == 0, f"{program.said} {program.complained}")


def motif_flight(place, *how):
    """The program, its window, the editor's, and its own picture at first."""
    server = place.server()
    program = place.program(server, "motif_flight", *how)
    host = server.named("^motif_flight$")
    window = server.new_window()
    if not how:
        server.place(window, 10, 10)
        server.place(host, 1300, 100)
    server.drawn(window)
    return server, program, host, window


def told(server, host):
    """What the host's title says."""
    return server.xdotool("getwindowname", host).strip()


@test(at_once=2)
def a_host_that_turns_its_object(place):
    """Opening leaves its picture, it flies along, and its own view is taken over once."""
    server, program, host, window = motif_flight(place)
    first = wait(lambda: (lambda p: p.colours() > 1 and p)(server.picture(host)), "the pyramid")
    check(told(server, host) == "motif_flight", f"opening moved its picture: {told(server, host)}")
    server.press(window, "ctrl+Next")
    wait(lambda: server.picture(host).differs(first), "the other point's view")
    server.press(window, "ctrl+Prior")
    wait(lambda: told(server, host) == "motif_flight: frame 1", "the first frame")
    wait(lambda: not server.picture(host).differs(first), "the picture with which it began")
    server.press(window, "ctrl+Return")  # the host follows: that view is there already
    server.drawn(window)
    server.drag(host, (200, 150), (230, 160))
    wait(lambda: told(server, host) == "motif_flight: own view", "the own view")
    own = server.drawn(host, 1)
    server.press(window, "ctrl+Return")
    wait(lambda: told(server, host).startswith("motif_flight: frame"), "the new point")
    wait(lambda: not server.picture(host).differs(own), "the own view at the new point")
    server.press(window, "ctrl+z")  # the one step: so that nobody asks
    server.drawn(window)
    server.press(window, "ctrl+q")
    server.gone(window)
    server.press(host, "Escape")
    check(program.ends() == 0, "its exit status")
    check(not program.complained, f"it complained: {program.complained}")


@test(at_once=2)
def an_editor_in_a_motif_widget(place):
    """It is seen there, and served."""
    server, program, host, window = motif_flight(place, "embedded")
    server.press(window, "ctrl+Next")
    wait(lambda: told(server, host).startswith("motif_flight: frame"), "the other point's view")
    server.press(host, "Escape")
    check(program.ends() == 0, "its exit status")
    check(not program.complained, f"it complained: {program.complained}")
