"""The camera pane that a host draws in, and windows that live in the host's own."""

import os

from cases_valgrind import under_valgrind
from harness import check, wait
from run import test

ROUNDS = os.environ.get("VIDES_PANES", "50")
"""Openings and closings of each kind. `make soak` takes 1,000."""

# The plainest of Mesa's drivers: others compile for minutes under valgrind.
PLAIN = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "softpipe"}


def draws(place, rounds, *words, program="pane"):
    """A host draws in panes that come and go."""
    server = place.server(options=("+extension", "GLX"))
    host = place.program(server, program, rounds, *words, ASAN_OPTIONS="detect_leaks=0", **PLAIN)
    # Under valgrind as long as that may take.
    status = host.ends(None if place.wrapper else 20 + float(rounds) * 3)
    check(status == 0, f"exit status {status}; it complained: {host.complained[-4:]}")
    host.expect(f"{rounds} rounds")


for _way in ("glx", "xlib", "direct"):
    for _cut in ((), ("cut",)):
        def _case(place, words=(_way, *_cut)):
            draws(place, ROUNDS, *words)

        def _checked(place, words=(_way, *_cut)):
            draws(place, "8", *words, program="pane_asan")

        _case.__name__ = "_".join(("a_host_that_draws", _way, *_cut))
        _checked.__name__ = "_".join(("sanitized", _case.__name__))
        test(first=True)(_case)
        test(first=True)(_checked)


def a_pane_of_xlib(place):
    """Few rounds, for valgrind."""
    draws(place, "4", "xlib", "cut")


@test(first=True)
def valgrind_and_a_pane(place):
    """Of what it finds only what went through the library counts; not what the
    connection that keeps the panes holds as long as the process lives."""
    under_valgrind(place, a_pane_of_xlib, False, leaks="definite")


@test()
def windows_in_the_hosts_own(place):
    """They fill it, take the keyboard, and end with it; what was unsaved stays."""
    server = place.server()
    host = place.program(server, "embedded")
    host.expect("unsaved")
    folder = os.path.join(server.env["XDG_STATE_HOME"], "vides")
    wait(lambda: os.path.isdir(folder) and os.listdir(folder), "the work file")
    host.process.stdin.write(b"\n")
    host.process.stdin.flush()
    status = host.ends()
    check(status == 0, f"exit status {status}; it complained: {host.complained[-4:]}")
    check(os.listdir(folder), "what was unsaved is gone")
