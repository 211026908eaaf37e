"""Kinds of hosts and of event loops: each opens windows, lives on, gets poses."""

import os
import time
import tomllib

from harness import Program, check, run, wait
from panel import rail_above
from run import BOTH, test

POSES = 121  # of a new path at speed 100: its length is 1.2, and the first pose


def hand_over(server, window):
    """The user hands the poses over."""
    server.press(window, "alt+u")


def press_button(server, host, number):
    """Presses one of the three buttons of the Motif host."""
    _, _, width, height = server.geometry(host)
    server.xdotool("windowraise", host)
    server.click(host, width / 2, height * (2 * number + 1) / 6)


@test(kinds=BOTH)
def the_host_of_1994(place):
    """Its three buttons; the editor beside it; its list, polled and by rueck."""
    server = place.server()
    program = place.program(server, "pyramid_motif")
    host = server.window("^MainTest$")
    server.place(host, 1500, 600)

    press_button(server, host, 1)
    program.expect("no poses yet")
    press_button(server, host, 0)
    window = server.new_window()
    check(program.alive(), "the host has ended")

    press_button(server, host, 1)  # the host's other buttons work meanwhile
    program.expect("no poses yet")
    hand_over(server, window)
    program.expect(f"{POSES} poses came")
    program.expect(f"pose {POSES}: at 0.6")
    press_button(server, host, 1)
    program.expect("pose 1: at -0.6")
    program.expect(f"pose {POSES}: at 0.6")

    press_button(server, host, 0)  # another, on the same list
    second = server.new_window(window)
    hand_over(server, second)
    program.expect(f"{POSES} poses came")
    hand_over(server, window)
    program.expect(f"{POSES} poses came")

    server.press(second, "ctrl+q")
    program.expect("the editor asks")
    server.gone(second)
    check(server.windows() == [window], "the first window went, too")
    hand_over(server, window)
    program.expect(f"{POSES} poses came")
    press_button(server, host, 2)
    check(program.ends() == 0, "its exit status")
    check(not program.complained, f"it complained: {program.complained}")


@test()
def a_host_without_x(place):
    """v_main_loop() runs until the window is closed."""
    server = place.server()
    program = place.program(server, "plain_main_loop")
    window = server.new_window()
    hand_over(server, window)
    server.press(window, "ctrl+q")
    program.expect(f"{POSES}: 0.6")
    check(program.ends() == 0, "its exit status")
    check(not program.complained, f"it complained: {program.complained}")


@test()
def the_host_in_the_readme(place):
    """Shows what it says."""
    server = place.server()
    program = place.program(server, "readme_window")
    window = server.new_window()
    hand_over(server, window)
    program.expect(" 0.6000")
    check(len(program.said) == POSES, f"{len(program.said)} poses")
    server.press(window, "ctrl+q")
    check(program.ends() == 0, "its exit status")
    check(not program.complained, f"it complained: {program.complained}")


@test()
def two_windows_with_lists_of_their_own(place):
    """Each hands over into its own."""
    server = place.server()
    program = place.program(server, "two_windows")
    first = server.new_window()
    windows = [first, server.new_window(first)]
    lengths = {"triangle": 121, "square": 301}
    for window in windows:
        hand_over(server, window)
        name = program.expect("").split(":")[0]
        check(program.said[-1] == f"{name}: {lengths.pop(name)} poses", f"said {program.said}")
    check(not lengths, f"never handed over: {lengths}")
    for window in windows:
        server.press(window, "ctrl+q")
        server.gone(window)
    check(program.ends() == 0, "its exit status")


@test()
def a_loop_over_xlib(place):
    """A host's poll() over its own connection and v_fd()."""
    server = place.server()
    program = place.program(server, "xlib_loop")
    host = server.named("xlib_loop")
    server.place(host, 1500, 600)
    before = server.drawn(host, 1)
    server.click(host, 20, 20)
    window = server.new_window()
    hand_over(server, window)
    wait(lambda: server.picture(host).differs(before), "the number of poses")
    server.press(window, "ctrl+q")
    server.gone(window)
    server.press(host, "q")
    check(program.ends() == 0, "its exit status")


@test()
def a_flight_in_opengl(place):
    """It flies along, and gives its own view."""
    server = place.server(options=("+extension", "GLX"))
    # The plainest of Mesa's drivers: others compile for minutes under valgrind.
    program = place.program(server, "glut_flight", LIBGL_ALWAYS_SOFTWARE="1",
                            GALLIUM_DRIVER="softpipe")
    host = server.named("^glut_flight$")
    server.place(host, 1250, 100)
    window = server.new_window()
    first = wait(lambda: (lambda p: p.colours() > 1 and p)(server.picture(host)), "the pyramid")
    server.press(window, "ctrl+Next")
    wait(lambda: server.picture(host).differs(first), "the other point's view")
    shown = server.drawn(window)
    server.drag(host, (100, 100), (300, 200))
    wait(lambda: server.picture(window).differs(shown), "the ghost to move")
    own = server.drawn(host, 1)
    server.press(window, "ctrl+Prior")
    wait(lambda: server.picture(host).differs(own), "the first point's view")
    server.press(window, "ctrl+Return")  # a third point, with the own view
    wait(lambda: server.picture(window).differs(shown), "the new point")
    server.press(window, "ctrl+z")  # so that nobody asks
    server.drawn(window)
    server.press(window, "ctrl+q")
    server.gone(window)
    wait(lambda: not server.picture(host).differs(own), "its own view again")
    server.press(host, "Escape")
    check(program.ends() == 0, "its exit status")


CAR = (98, 14, 14)
"""Its side that is seen first."""


@test()
def a_scene_in_opengl(place):
    """Draws what it built, which is what examples/car.vid says, at the frame of the editor
    beside it; a key gives the car's way another interpolation, and the editor takes that
    back."""
    server = place.server(options=("+extension", "GLX"))
    software = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "softpipe"}
    saved = place.path("saved.vid")
    check(place.program(server, "glut_scene", "--save", saved).ends() == 0, "it cannot save")
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    with open(saved, "rb") as ours, open(os.path.join(root, "examples/car.vid"), "rb") as file:
        ours, file = tomllib.load(ours), tomllib.load(file)
    for table in ("node", "marker"):
        check(ours[table] == file[table], f"the {table}s of examples/car.vid are others")
    program = place.program(server, "glut_scene", **software)
    host = server.named("^glut_scene$")
    server.place(host, 1250, 100)
    window = server.new_window()
    first = wait(lambda: (lambda p: p.colours() > 5 and p)(server.picture(host)), "the car")
    width, height = server.geometry(window)[2:]
    server.drawn(window)
    server.click(window, width // 2, height - rail_above(height, markers=True))
    wait(lambda: server.picture(host).differs(first), "the car to drive")
    # It fills the camera's picture in the editor, too: the editor paints nothing so red.
    wait(lambda: len(server.picture(window).find(CAR)) > 100, "the car in the camera's picture")
    server.drawn(window)
    driven = server.drawn(host, 1)
    server.press(host, "space")
    server.named("^linear$")
    wait(lambda: server.picture(host).differs(driven), "the car to take another way")
    server.press(window, "ctrl+z")
    wait(lambda: not server.picture(host).differs(driven), "the way to be taken back")
    server.press(host, "Escape")
    check(program.ends() == 0, "its exit status")


SCENE = """version = 1
camera = "second"
[[node]]
name = "first"
kind = "camera"
position = [0.0, 0.0, -5.0]
[[node]]
name = "second"
kind = "camera"
position = [0.0, 0.2, 2.0]
aim = "blue"
[[node]]
name = "blue"
kind = "object"
colour = [0.0, 0.0, 1.0]
[node.mesh]
points = [[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0]]
triangles = [[0, 1, 2]]
[[node.track]]
channel = "position"
interpolation = "linear"
frames = [1.0, 50.0]
values = [[0.0, 0.0, 0.0], [0.0, 0.0, -20.0]]
"""


@test()
def any_scene_in_opengl(place):
    """A file's scene is drawn through the camera that it shows, at the editor's frame."""
    server = place.server(options=("+extension", "GLX"))
    software = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "softpipe"}
    with open(place.path("any.vid"), "w", encoding="utf-8") as file:
        file.write(SCENE)
    program = place.program(server, "glut_scene", place.path("any.vid"), **software)
    host = server.named("^glut_scene$")
    server.place(host, 1250, 100)
    window = server.new_window()

    def blue():
        return len(server.picture(host).find((0, 0, 186)))

    near = wait(blue, "the object")
    check(near > 10000, f"{near} pixels through the shown camera")
    server.drawn(window)
    server.press(window, "space")
    wait(lambda: 0 < blue() < near // 20, "the object to fly away")
    server.press(host, "Escape")
    check(program.ends() == 0, "its exit status")


def serves(place, name, *arguments, before=()):
    """A host's loop runs a window: it comes, hands over, closes."""
    server = place.server()
    host = place.told(server, name, *arguments)
    for line in before:
        host.tell(line, {"announce": "announced 0"}.get(line))
    host.open()
    window = server.new_window()
    hand_over(server, window)
    check(host.expect("rueck 0") == f"rueck 0 {POSES} thread own depth 0", host.said[-1])
    host.live()
    server.press(window, "ctrl+q")
    host.expect("ende thread own")
    server.gone(window)
    host.live()
    host.open(1)  # and again
    server.new_window()
    host.leave()
    check(not host.complained, f"it complained: {host.complained}")


@test()
def a_loop_with_poll(place):
    """v_fd, v_timeout, v_dispatch."""
    serves(place, "loop_poll")


@test(kinds=BOTH)
def xt_default_context(place):
    """XtInitialize and XtMainLoop."""
    serves(place, "loop_xt", "initialize")


@test(kinds=BOTH)
def xt_context_of_the_hosts_own(place):
    """XtAppInitialize and XtAppMainLoop."""
    serves(place, "loop_xt", "app")


@test(kinds=BOTH)
def xt_open_application(place):
    """XtOpenApplication and XtAppMainLoop."""
    serves(place, "loop_xt", "open")


@test(kinds=BOTH)
def xt_two_contexts(place):
    """Two contexts, of which one runs."""
    serves(place, "loop_xt", "two")


@test(kinds=BOTH)
def xt_context_made_after_the_window(place):
    """v_set_app_context() tells of it."""
    server = place.server()
    host = place.told(server, "loop_xt", "late")
    host.open()
    host.tell("context")
    host.tell("announce", "announced 0")
    window = server.new_window()
    hand_over(server, window)
    host.expect(f"rueck 0 {POSES} thread own")
    host.leave()


@test()
def a_host_that_serves_nobody_is_told(place):
    """One hint on standard error, once."""
    server = place.server()
    host = place.told(server, "loop_poll", "none")
    host.open()
    host.tell("sleep 3000", "slept")
    host.open(1)
    host.tell("sleep 1500", "slept")
    host.live()
    host.open(2)
    hints = [line for line in host.complained if line.startswith("vides:")]
    check(len(hints) == 1, f"hints: {host.complained}")
    check("v_dispatch" in hints[0] or "v_main_loop" in hints[0], f"the hint: {hints[0]}")
    host.leave()


@test()
def windows_from_within_rueck(place):
    """v_haupt(), v_dispatch() and v_main_loop() may be called there."""
    server = place.server()
    host = place.told(server)
    host.open()
    window = server.new_window()
    host.tell("within-rueck haupt 1")
    hand_over(server, window)
    host.expect("rueck 0")
    host.expect("haupt")
    host.expect("rueck-end 0")
    second = server.new_window(window)

    host.tell("within-rueck main-loop")
    hand_over(server, second)
    host.expect("rueck 1")
    words = host.expect("main-loop").split(None, 2)
    check(words[1] == "11" and len(words) == 3, f"v_main_loop in a callback: {words}")
    host.tell("within-rueck dispatch")
    hand_over(server, window)
    host.expect("dispatch 2")
    host.expect("rueck-end 0")
    host.tell("within-rueck free 0")
    hand_over(server, window)
    host.expect("freed -1")
    check(host.tell("list 0").endswith("none"), "the list is still there")
    hand_over(server, window)
    host.expect("rueck-end 0")
    check(host.tell("list 0").startswith(f"list 0 {POSES} first -0.6"), host.said[-1])
    host.leave()


@test()
def a_window_closes_its_neighbour_within_a_callback(place):
    """v_editor_close() of itself and of another, from within a callback."""
    server = place.server()
    host = place.told(server)
    host.edit(0)
    first = server.new_window()
    host.edit(1)
    second = server.new_window(first)
    host.tell("within-rueck close 1")
    hand_over(server, first)
    host.expect("closed 0")
    server.gone(second)
    host.tell("within-rueck close 0")
    hand_over(server, first)
    host.expect("closed 0")
    server.gone(first)
    host.live()
    host.leave()


@test()
def the_list_polled_without_functions(place):
    """NULL for rueck and ende; also no list, and nothing at all."""
    server = place.server()
    host = place.told(server)
    host.open(0, "poll")
    window = server.new_window()
    check(host.tell("list 0").endswith("none"), "a list before the hand-over")
    hand_over(server, window)
    wait(lambda: not host.tell("list 0").endswith("none"), "the list")
    check(host.said[-1].startswith(f"list 0 {POSES} first -0.6"), host.said[-1])
    server.press(window, "ctrl+q")
    server.gone(window)
    check(host.tell("list 0").startswith(f"list 0 {POSES}"), "the list went with its window")
    host.tell("free 0", "freed -1")
    host.open(0, "nolist")
    window = server.new_window()
    hand_over(server, window)
    host.expect(f"rueck -1 {POSES}")
    server.press(window, "ctrl+q")
    server.gone(window)
    host.open(0, "bare")
    window = server.new_window()
    hand_over(server, window)  # to nobody
    host.live()
    server.press(window, "ctrl+q")
    server.gone(window)
    host.leave()


@test()
def one_list_for_two_windows(place):
    """Handed over again and again, from both; no element is lost or freed twice."""
    server = place.server()
    host = place.told(server)
    host.open(5)
    first = server.new_window()
    host.tell("speeds 50 50 50 50")
    host.open(5)
    second = server.new_window(first)
    for _ in range(5):
        hand_over(server, first)
        host.expect(f"rueck 5 {POSES}")
        check(host.tell("list 5").startswith(f"list 5 {POSES} first -0.6"), host.said[-1])
        hand_over(server, second)
        host.expect("rueck 5 61")
        check(host.tell("list 5").startswith("list 5 61 first -0.6"), host.said[-1])
    host.leave()


@test(first=True)
def sixty_four_windows(place):
    """At once, in one host; the first and the last hand over."""
    server = place.server()
    host = place.told(server)
    for number in range(64):
        host.open(number)
    wait(lambda: len(server.windows()) == 64, "64 windows")
    windows = server.windows()
    heard = set()
    for window in (windows[0], windows[63], windows[31]):
        server.drawn(window)
        hand_over(server, window)
        heard.add(host.expect("rueck ").split()[1])
    check(len(heard) == 3, f"three windows handed over into the lists {heard}")
    for window in windows[:5]:
        server.press(window, "ctrl+q")
        host.expect("ende")
    wait(lambda: len(server.windows()) == 59, "five windows to close")
    host.live()
    host.leave()


@test()
def what_is_wrong_is_said(place):
    """Bad speeds and wrong numbers: a window nevertheless, and a line."""
    server = place.server()
    host = place.told(server)
    host.tell("speeds 100 -1 100 100")
    words = host.tell("haupt 0")
    check(len(words.split(None, 2)) == 3, "v_last_error() tells nothing of a bad speed")
    wait(lambda: any(line.startswith("vides:") for line in host.complained), "a line of complaint")
    check(len(host.complained) == 1, f"one line: {host.complained}")
    window = server.new_window()
    host.tell("speeds 100 100 100 100")
    host.tell("misnumber 7")
    words = host.tell("haupt 1")
    check("4" in words, f"the wrong number's place: {words}")
    wait(lambda: len(host.complained) == 2, "another line")
    server.new_window(window)
    host.leave()


@test()
def nothing_of_the_process_is_changed(place):
    """Signals, locale, environment, the flags of the streams, the descriptors."""
    import os
    server = place.server()
    host = place.told(server, LC_ALL="de_DE.UTF-8")
    before = host.tell("process")
    host.open()
    window = server.new_window()
    hand_over(server, window)
    host.expect("rueck-end")
    check(host.tell("process") == before, f"{before} became {host.said[-1]}")
    kept_open = []
    folder = f"/proc/{host.pid}/fdinfo"
    for number in os.listdir(folder):
        with open(f"{folder}/{number}", encoding="ascii") as info:
            flags = [int(line.split()[1], 8) for line in info if line.startswith("flags:")][0]
        if int(number) > 2 and not flags & os.O_CLOEXEC:
            kept_open.append(number)
    check(not kept_open, f"descriptors that a child would inherit: {kept_open}")
    threads = os.listdir(f"/proc/{host.pid}/task")
    server.press(window, "ctrl+q")
    server.gone(window)
    check(host.tell("process") == before, f"{before} became {host.said[-1]}")
    check(len(threads) == 1, f"{len(threads)} threads")
    extra = [line for line in host.said
             if line.split()[0] not in ("process", "haupt", "rueck", "rueck-end", "ende")]
    check(not extra, f"on standard output: {extra}")
    host.leave()


def idle(place):
    """A host and its one window, with the pointer over it, at rest."""
    server = place.server()
    host = place.told(server)
    host.open()
    window = server.new_window()
    server.xdotool("mousemove", "--window", window, 500, 400)
    host.idle()
    return server, host, window


@test(at_once=3)
def nobody_is_woken_while_idle(place):
    """An open window that nobody touches costs no wake-up, nor does v_timeout() ask for one."""
    server, host, window = idle(place)
    before = host.switches()
    time.sleep(3)
    check(host.switches() == before, f"{host.switches() - before} wake-ups in 3 s")
    words = host.tell("fd").split()
    check(words[3] == "-1", f"a timer in an idle window: {words}")
    xt = place.told(server, "loop_xt", "app")
    xt.open()
    server.new_window(window)
    xt.idle()
    before = xt.switches()
    time.sleep(3)
    check(xt.switches() == before, f"{xt.switches() - before} wake-ups in 3 s under Xt")
    host.leave()
    xt.leave()


@test()
def the_desktop_wakes_a_window_once_a_change(place):
    """Settings of the desktop are properties of the root window, and so is much that a
    window manager writes there: no picture comes of it."""
    server, host, window = idle(place)
    before, picture = host.turns(), server.picture(window)
    for number in range(40):
        run("xprop", "-root", "-f", "_SOMETHING", "32c", "-set", "_SOMETHING", str(number),
            env=server.env)
    host.idle()
    woken = host.turns() - before
    check(woken <= 40, f"{woken} wake-ups for 40 changes")
    check(not server.picture(window).differs(picture), "another picture")
    host.leave()


@test()
def windows_lie_where_their_files_say(place):
    """With space_up, alone or with a space, and whatever path or scene is set."""
    program = place.program(place.server(), "spaces", place.path("."))
    status = program.ends()
    check(status == 0, f"exit status {status}; it complained: {program.complained}")


@test()
def a_scene_hands_over_what_its_files_have(place):
    """The poses of the shown camera, whichever it is: handed over, exported and by the command."""
    folder = place.path("film")
    command = os.path.join(place.hosts, "../release/vides")
    os.mkdir(folder)
    program = place.program(place.server(), "film", folder)
    status = program.ends()
    check(status == 0, f"exit status {status}; it complained: {program.complained}")
    for camera, name in enumerate(("camera", "by keys", "third")):
        file = os.path.join(folder, f"film-{camera}.vid")
        exported = os.path.join(folder, f"film-{camera}.csv")
        with open(exported, "rb") as lines:
            wanted = lines.read()
        for node in ([], ["--node", name]):
            sampled = run(command, "sample", "--format", "csv", *node, file)
            check(sampled == wanted, f"{node} of {file}")
        check(wanted.splitlines()[1].startswith(b"100.7,"), "as people count")


@test()
def a_settings_manager_that_begins_later(place):
    """What manages the desktop's settings may start after the window: it turns light with
    the desktop. That another manager begins wakes it once, and paints nothing."""
    server, host, window = idle(place)
    picture = server.drawn(window)
    corner = (6, 6)
    check(max(picture.pixel(*corner)) < 0x40, f"not dark at first: {picture.pixel(*corner)}")
    manager = os.path.join(place.hosts, "manager")
    before = host.turns()
    for selection in ("WM_S0", "_NET_SYSTEM_TRAY_S0"):
        run(manager, "-", selection, env=server.env)
    host.idle()
    woken = host.turns() - before
    check(woken <= 2, f"{woken} wake-ups for 2 other managers")
    check(not server.picture(window).differs(picture), "another picture")
    one = Program(place.folder, [manager, "Adwaita"], server.env)
    place.programs.append(one)
    one.expect("begun")
    wait(lambda: min(server.picture(window).pixel(*corner)) > 0xC0, "the window to turn light")
    host.idle()
    before = host.turns()
    time.sleep(2)
    check(host.turns() == before, f"{host.turns() - before} wake-ups in 2 s of rest")
    host.leave()
