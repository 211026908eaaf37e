"""The C examples under valgrind: what is ours reads and writes what it may, and
leaves nothing behind.

Xlib, Xt, Motif and Mesa have faults and leaks of their own, which are not looked
at: of those hosts only what goes through the library counts.
"""

import os
import re

import cases_hosts
from harness import check, patience
from run import test

FRAME = re.compile(r"(?:at|by) 0x[0-9A-F]+: (.*)")


def errors(folder):
    """What valgrind found, each as lines; a stack is in them."""
    found = []
    for name in sorted(os.listdir(folder)):
        if not name.startswith("valgrind."):
            continue
        with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as log:
            text = re.sub(r"(?m)^==\d+== ?", "", log.read())
        found += [block for block in text.split("\n\n") if FRAME.search(block)]
    return found


def is_ours(error):
    """It went through the library: the shared one by its file, the archive by its names."""
    return any("libvides.so" in frame or "vides" in frame.split(" (")[0]
               or frame.startswith("v_") for frame in FRAME.findall(error))


def under_valgrind(place, story, all_of_them, leaks="definite,possible"):
    """Plays a test of cases_hosts under valgrind."""
    logs = place.path("valgrind.%p")
    place.wrapper = ("valgrind", "-q", "--fair-sched=yes", f"--log-file={logs}",
                     "--leak-check=full", f"--errors-for-leak-kinds={leaks}", f"--show-leak-kinds={leaks}")
    with patience(600):
        story(place)
    logged = [name for name in os.listdir(place.folder) if name.startswith("valgrind.")]
    check(logged, "valgrind did not run")
    found = [error for error in errors(place.folder) if all_of_them or is_ours(error)]
    check(not found, f"{len(found)} errors, the first: {found[:1]}")


def without_a_window(place):
    """headless.c."""
    with open(place.path("flight.vid"), "w", encoding="ascii") as file:
        file.write("version = 1\n" + "".join(
            f"[[point]]\nposition = [{x}, 0.2, 0.1]\n[[point.orientation]]\n"
            "target = [0.0, 0.0, 2.0]\n" for x in (-0.5, 0.0, 0.5)))
    program = place.program(None, "headless", "flight.vid")
    check(program.ends() == 0, f"its exit status; it complained: {program.complained}")


# Each with whether all that is found counts, since nothing but the library is at
# work there.
EXAMPLES = (
    (cases_hosts.the_host_of_1994, False),
    (cases_hosts.a_loop_over_xlib, False),
    (cases_hosts.a_flight_in_opengl, False),
    (cases_hosts.a_host_without_x, True),
    (cases_hosts.two_windows_with_lists_of_their_own, True),
    (without_a_window, True),
)

for _story, _all in EXAMPLES:
    def _case(place, story=_story, all_of_them=_all):
        under_valgrind(place, story, all_of_them)

    _case.__name__ = f"valgrind_and_{_story.__name__}"
    test(first=True)(_case)
