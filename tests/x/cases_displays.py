"""On which display a window opens: the host's own, then that of the environment."""

import os
import shutil

from harness import check, run
from run import BOTH, test


def two_servers(place, options=()):
    """The second is that of the environment; each client may use both."""
    here, environments = place.server(options=options), place.server()
    run("xauth", "-q", "-f", environments.authority, "merge", here.authority)
    return here, environments


def opens_both(place, here, host, *others):
    """By v_haupt() and by v_editor_open()."""
    host.open()
    first = here.new_window()
    host.edit(1)
    second = here.new_window(first)
    for other in others:
        check(not other.windows(), f"a window on {other.name}")
    host.leave()
    here.gone(first)
    here.gone(second)


@test(kinds=BOTH)
def a_window_opens_on_the_display_of_xt(place):
    """Given to the program by -display, with another DISPLAY, with none, over TCP."""
    for options, name in (((), "{}"), (("-listen", "tcp"), "127.0.0.1{}")):
        here, other = two_servers(place, options)
        name = name.format(here.name)
        for display in (other.name, None):
            for way in ("initialize", "app", "open"):
                host = place.told(other, "loop_xt", way, "-display", name, DISPLAY=display)
                opens_both(place, here, host, other)


@test(kinds=BOTH)
def the_host_of_1994_opens_on_its_own_display(place):
    """The first line of the thesis's program: prog -display NAME."""
    server = place.server()
    program = place.program(server, "pyramid_motif", "-display", server.name, DISPLAY=None)
    host = server.window("^MainTest$")
    _, _, width, height = server.geometry(host)
    server.click(host, width / 2, height / 6)
    server.new_window()
    check(program.alive() and not program.complained, f"it complained: {program.complained}")


@test()
def the_display_of_the_newest_context_counts(place):
    """One that ended does not; one that is given does before all; without Xt it is DISPLAY."""
    here, other = two_servers(place)
    host = place.told(other, "loop_xt", "two", here.name)
    host.open(0)
    first = here.new_window()
    check(host.tell(f"third {other.name}") == "third 1", "a third context")
    host.edit(1)
    window = other.new_window()
    host.tell("end-third")
    host.edit(2)
    second = here.new_window(first)
    check(other.windows() == [window], "a window on the display of a context that ended")
    host.tell(f"edit-on 3 {other.name}", "edited 0")
    other.new_window(window)
    check(sorted(here.windows()) == sorted([first, second]), "a window on Xt's display")
    host.leave()
    for server, gone in ((other, window), (here, first), (here, second)):
        server.gone(gone)
    late = place.told(other, "loop_xt", "late", "-display", here.name)
    late.open()
    late.tell("context")
    late.open(1)
    other.new_window()
    here.new_window()
    late.leave()


@test(kinds=BOTH)
def the_authority_is_found_where_xlib_finds_it(place):
    """In the user's home if XAUTHORITY does not say another file."""
    server = place.server()
    shutil.move(server.authority, os.path.join(server.folder, ".Xauthority"))
    host = place.told(server, "loop_xt", "app", "-display", server.name, DISPLAY=None,
                      XAUTHORITY=None)
    server.env.pop("XAUTHORITY")
    opens_both(place, server, host)
