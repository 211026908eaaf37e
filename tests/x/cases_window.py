"""Closing, keyboard, clipboard, files, dragging: what the user does with one window."""

import os
import pathlib
import re
import shutil

from cases_hosts import POSES, hand_over
from harness import Program, check, run, wait
from panel import FIELD, middle, panel_boxes
from run import test


def opened(place, server=None, file="", name="loop_poll", **variables):
    """A host and its one window, drawn."""
    server = server or place.server()
    host = place.told(server, name, **variables)
    host.edit(0, file)
    window = server.new_window()
    return server, host, window


# ---- Closing --------------------------------------------------------------------

def asked_and_refused(server, host, window, close):
    """`close` asks ende(): 0 keeps the window open and usable, 1 lets it go."""
    host.tell("closing 0")
    close()
    host.expect("on_close")
    hand_over(server, window)
    host.expect(f"poses 0 {POSES}")
    check(window in server.windows(), "closed against the host's will")
    host.tell("closing 1")
    close()
    host.expect("on_close")
    server.gone(window)
    words = host.tell("path 0").split()
    check(words[1:3] == ["status", "12"], f"v_editor_get_path after closing: {words}")
    host.tell("close 0", "closed 0")
    host.leave()


@test()
def closing_by_alt_f4(place):
    """Without a window manager the key comes to the window itself."""
    server, host, window = opened(place)
    asked_and_refused(server, host, window, lambda: server.press(window, "alt+F4"))


@test()
def closing_by_ctrl_q(place):
    """The habit of today."""
    server, host, window = opened(place)
    asked_and_refused(server, host, window, lambda: server.press(window, "ctrl+q"))


@test()
def closing_by_menu(place):
    """The last entry of the first menu, by the keyboard."""
    server, host, window = opened(place, LANG="en_GB.UTF-8", LC_ALL=None)

    def menu():
        server.press(window, "alt+d")
        server.xdotool("key", "--delay", "40", "Up", "Return")

    asked_and_refused(server, host, window, menu)


@test()
def closing_by_the_window_manager(place):
    """WM_DELETE_WINDOW, as the close button and Alt-F4 of a window manager send it."""
    server = place.server()
    server.window_manager()
    server, host, window = opened(place, server)
    asked_and_refused(server, host, window, lambda: server.press(window, "alt+F4"))


@test()
def the_title_bar_and_the_window_manager(place):
    """What a window manager wants to know."""
    server = place.server()
    server.window_manager()
    server, host, window = opened(place, server)
    name = os.path.basename(place.binary("loop_poll"))
    check(f'= "{name}", "Vides"' in server.property(window, "WM_CLASS"),
          server.property(window, "WM_CLASS"))
    leader = server.property(window, "WM_CLIENT_LEADER").split()[-1]
    check(int(leader, 16) == window, f"WM_CLIENT_LEADER {leader} of {window:#x}")
    check(leader in server.property(window, "WM_HINTS"), "the group in WM_HINTS")
    check('"VIDES' in server.property(window, "_NET_WM_NAME"), "_NET_WM_NAME")
    check('"VIDES' in server.property(window, "WM_NAME"), "WM_NAME")
    check(server.property(window, "_NET_WM_PID").endswith(f"= {host.pid}"), "_NET_WM_PID")
    protocols = server.property(window, "WM_PROTOCOLS")
    check("WM_DELETE_WINDOW" in protocols and "_NET_WM_PING" in protocols, protocols)
    check("Icon" in server.property(window, "_NET_WM_ICON"), "_NET_WM_ICON")
    check("minimum size" in server.property(window, "WM_NORMAL_HINTS"), "a smallest size")
    server.xdotool("windowsize", "--sync", window, 900, 700)
    wait(lambda: server.geometry(window)[2:] == (900, 700), "the new size")
    server.drawn(window)
    server.xdotool("windowminimize", window)
    wait(lambda: "Iconic" in server.property(window, "WM_STATE"), "an icon")
    host.live()
    server.xdotool("windowmap", "--sync", window)
    server.drawn(window)
    hand_over(server, window)
    host.expect(f"poses 0 {POSES}")
    host.leave()


@test()
def keys_pressed_while_nobody_serves(place):
    """Alt-U and Ctrl-Q come together when the host is back: first the one, then the other."""
    server, host, window = opened(place)
    host.send("sleep 1500")
    server.press(window, "alt+u", "ctrl+q")
    host.expect("slept")
    host.expect(f"poses 0 {POSES}")
    host.expect("on_close")
    server.gone(window)
    host.leave()


@test()
def numbers_typed_while_nobody_serves(place):
    """Three numbers, with Tab from one to the next: each is in its field when the host is
    back, and what a click on another field follows is in the first."""
    server, host, window = opened(place)
    fields = server.seen(window, lambda picture: panel_boxes(picture, FIELD)[0], "the fields")
    server.focus(window)
    host.send("sleep 1500")
    server.click(window, *middle(fields[0]))
    server.xdotool("key", "0", "period", "1", "Tab", "0", "period", "3", "Tab", "0", "period", "5")
    server.click(window, *middle(fields[1]))
    server.xdotool("key", "0", "period", "2", "Return")
    host.expect("slept")
    wait(lambda: host.path()[0] == (0.1, 0.2, 0.5), f"three numbers: {host.path()[0]}")
    host.leave()


# ---- Files, by the keyboard only ----------------------------------------------------

def file_window(server, window, keys):
    """Opens a file window by its keys; what is typed then replaces the proposed name."""
    before = server.drawn(window)
    server.press(window, keys)
    wait(lambda: server.picture(window).differs(before), "a file window")
    server.drawn(window)
    server.xdotool("key", "--delay", "30", "ctrl+a")


def named_file(server, window, keys, name):
    """Opens a file window by its keys, types a name and goes on."""
    file_window(server, window, keys)
    server.type(name)
    server.xdotool("key", "Return")


@test()
def saving_and_loading_by_keyboard(place):
    """What was saved is what the window has; loaded again it is the same."""
    server, host, window = opened(place)
    host.tell(f"save 0 {place.path('host.vid')}", "saved 0")
    named_file(server, window, "ctrl+s", "mine.vid")
    wait(lambda: os.path.exists(place.path("mine.vid")), "the file")
    with open(place.path("mine.vid"), "rb") as mine, open(place.path("host.vid"), "rb") as its:
        check(mine.read() == its.read(), "the window saved something else than it has")
    with open(place.path("other.vid"), "w", encoding="utf-8") as other:
        other.write("version = 1\n" + "".join(
            f"[[point]]\nposition = [{x}, 0.1, 0.2]\n[[point.orientation]]\noffset = [0, 0, -1]\n"
            for x in (-0.5, 0.125, 0.75)))
    named_file(server, window, "ctrl+o", "other.vid")
    wait(lambda: len(host.path()) == 3, "the loaded path")
    check([point[0] for point in host.path()] == [-0.5, 0.125, 0.75], f"{host.path()}")
    host.leave()


@test()
def a_hosts_speeds_stand(place):
    """In a window of v_haupt() a loaded file's are ignored, and the host's are saved."""
    server = place.server()
    host = place.told(server)
    host.tell("speeds 50 60 70 80")
    host.open()
    window = server.new_window()
    with open(place.path("other.vid"), "w", encoding="utf-8") as other:
        other.write("version = 1\n[base_speeds]\nmove_frames = 10.0\nturn_frames = 20.0\n"
                    "zoom_frames = 30.0\nroll_frames = 40.0\n"
                    "[[point]]\nposition = [0, 0, 0]\n[[point]]\nposition = [1, 0, 0]\n")
    named_file(server, window, "ctrl+o", "other.vid")
    wait(lambda: "other" in server.property(window, "_NET_WM_NAME"), "the file's name")
    hand_over(server, window)
    host.expect("rueck 0 51")
    check(host.tell("list 0").startswith("list 0 51 first 0 0 0 last 1 0 0"), host.said[-1])
    named_file(server, window, "ctrl+shift+s", "saved.vid")
    wait(lambda: os.path.exists(place.path("saved.vid")), "the file")
    saved = wait(lambda: open(place.path("saved.vid"), encoding="utf-8").read(), "its text")
    speeds = re.findall(r"^(\w+)_frames = (\S+)$", saved, re.MULTILINE)
    wanted = {"move": 50, "turn": 60, "zoom": 70, "roll": 80}
    check({name: float(value) for name, value in speeds if name in wanted} == wanted, f"{speeds}")
    host.leave()


@test()
def what_the_host_sets_is_one_step(place):
    """v_editor_set_path() replaces the path; one undo has back what was before."""
    server, host, window = opened(place)
    before = host.path()
    with open(place.path("other.vid"), "w", encoding="utf-8") as other:
        other.write("version = 1\n" + "".join(
            f"[[point]]\nposition = [{x}, 0.1, 0.2]\n" for x in (-0.5, 0.125, 0.75)))
    host.tell(f"set 0 {place.path('other.vid')}", "set 0")
    after = host.path()
    check([point[0] for point in after] == [-0.5, 0.125, 0.75], f"{after}")
    server.press(window, "ctrl+z")
    wait(lambda: host.path() == before, "undo to have back what was before")
    server.press(window, "ctrl+shift+z")
    wait(lambda: host.path() == after, "redo to have back what the host set")
    host.leave()


@test()
def two_languages_in_one_process(place):
    """The option `language`: each window has its own, whatever the environment says."""
    server = place.server()
    server.xdotool("mousemove", 1900, 1180)  # where no tooltip comes up
    pictures = {}
    for locale in ("de_DE.UTF-8", "en_GB.UTF-8"):
        host = place.told(server, LC_ALL=locale)
        for command in ("edit 0", "edit-in 1 de", "edit-in 2 en"):
            host.tell(command, "edited 0")
            window = server.new_window()
            pictures[locale[:2], command[-2:]] = server.drawn(window)
            host.tell(f"close {command.split()[1]}", "closed 0")
            server.gone(window)
        host.leave()
    german, english = pictures["de", " 0"], pictures["en", " 0"]
    check(german.differs(english), "German and English look the same")
    for locale in ("de", "en"):
        check(not pictures[locale, "de"].differs(german), f"no German window in {locale}")
        check(not pictures[locale, "en"].differs(english), f"no English window in {locale}")


@test()
def a_broken_file_changes_nothing(place):
    """It is refused; what was open stays."""
    server, host, window = opened(place)
    before = host.path()
    with open(place.path("broken.vid"), "w", encoding="utf-8") as broken:
        broken.write("version = 1\n[[point]]\nposition = [1, 2]\n")
    shown = server.drawn(window)
    named_file(server, window, "ctrl+o", "broken.vid")
    server.xdotool("key", "Escape")
    wait(lambda: server.drawn(window).differs(shown), "a message")
    check(host.path() == before, "the path has changed")
    host.leave()


@test()
def what_is_handed_over_is_what_vides_samples(place):
    """The list of a hand-over, the output file, and `vides sample`: the same lines."""
    pyramid = place.path("pyramid.vid")
    shutil.copy(os.path.join(os.path.dirname(__file__), "../../examples/pyramid.vid"), pyramid)
    command = os.path.join(place.hosts, "../release/vides")
    server = place.server()
    host = place.told(server)
    host.open(3)
    window = server.new_window()
    named_file(server, window, "ctrl+o", "pyramid.vid")
    wait(lambda: "pyramid" in server.property(window, "_NET_WM_NAME"), "the file's name")
    hand_over(server, window)
    count = int(host.expect("rueck 3").split()[2])
    host.tell(f"write 3 {place.path('list.txt')}", f"written {count}")
    sampled = run(command, "sample", pyramid).decode().splitlines()
    with open(place.path("list.txt"), encoding="ascii") as file:
        listed = [re.sub(r"-(0\.0+)\b", r"\1", line) for line in file.read().splitlines()]
    check(len(listed) == len(sampled), f"{len(listed)} and {len(sampled)} lines")
    # The list has floats and whole zooms, so its last digit may be another.
    for ours, its in zip(listed, sampled):
        differences = [abs(float(a) - float(b)) for a, b in zip(ours.split(), its.split())]
        check(max(differences[:9]) < 1.01e-4 and differences[9] <= 0.5, f"{ours}\n{its}")
    server.press(window, "alt+a")
    named_file(server, window, "d", "poses.txt")
    wait(lambda: os.path.exists(place.path("poses.txt")), "the output file")
    wait(lambda: open(place.path("poses.txt"), encoding="ascii").read().splitlines() == sampled,
         "the output file to be what vides sample writes")
    host.leave()


# ---- Numbers ----------------------------------------------------------------------

@test()
def numbers_typed_into_fields(place):
    """With a comma, with a point, in a German window; what is no number changes nothing."""
    server, host, window = opened(place, LC_ALL="de_DE.UTF-8")
    fields = server.seen(window, lambda picture: panel_boxes(picture, FIELD)[0], "the fields")
    check(len(fields) == 3, f"the fields of the position: {fields}")
    for axis, typed, value in ((0, "0,25", 0.25), (1, "-0.125", -0.125), (2, "1", 1.0)):
        server.click(window, *middle(fields[axis]))
        server.xdotool("key", "--delay", "20", "ctrl+a")
        server.type(typed)
        server.xdotool("key", "Return")
        wait(lambda: host.path()[0][axis] == value, f"{typed} to be {value}: {host.path()[0]}")
    before = host.path()
    server.click(window, *middle(fields[0]))
    server.xdotool("key", "--delay", "20", "ctrl+a")
    server.type("1,2,3")
    shown = server.drawn(window)
    server.xdotool("key", "Return")
    wait(lambda: server.drawn(window).differs(shown), "a message")
    check(host.path() == before, "what is no number was taken for one")
    server.press(window, *["ctrl+z"] * 3)
    wait(lambda: host.path()[0] == (-0.6, 0.2, 0.8), "undo of the three")
    host.leave()


# ---- Clipboard ----------------------------------------------------------------------

@test()
def clipboard_both_ways(place):
    """Texts of other programs into a field, and a field's text into other programs."""
    server, host, window = opened(place)
    file_window(server, window, "ctrl+s")
    name = "Flug_über_Köln.vid"
    server.copy(name)
    server.xdotool("key", "ctrl+v")
    server.drawn(window)
    server.copy("something else")
    server.xdotool("key", "--delay", "40", "ctrl+a", "ctrl+c")
    wait(lambda: server.copied() == name, "the copied text")
    server.xdotool("key", "Return")
    wait(lambda: os.path.exists(place.path(name)), "the file of that name")
    host.leave()


@test()
def points_by_the_clipboard(place):
    """Into a text file, from there into another program's window; a text that is none."""
    server, host, window = opened(place)
    server.press(window, "ctrl+a", "ctrl+c")
    text = wait(lambda: "[[point]]" in server.copied() and server.copied(), "the points' text")
    check(text.startswith("version = 1\n") and text.count("[[point]]") == 2, text)
    with open(place.path("pasted.vid"), "w", encoding="utf-8") as file:
        file.write(text)
    other = place.told(server)
    other.edit(0, place.path("pasted.vid"))
    further = server.new_window(window)
    first = host.path()
    check(other.path() == first, f"from the text: {other.path()}")
    server.press(further, "ctrl+v")
    wait(lambda: other.path() == [first[0], *first, first[1]], f"pasted: {other.path()}")
    server.copy("milk, eggs")
    before = server.drawn(further)
    server.press(further, "ctrl+v")
    wait(lambda: server.picture(further).rows != before.rows, "a sentence")
    check(len(other.path()) == 4, "points of no text")
    server.press(further, "ctrl+z")
    wait(lambda: other.path() == first, "one step")
    other.leave()
    host.leave()


@test()
def files_dragged_from_another_program(place):
    """A path is opened, then a mesh is shown, and is in the file that is saved."""
    server = place.server()
    server.window_manager()
    server, host, window = opened(place, server)
    server.place(window, 300, 200)
    flight, mesh = (pathlib.Path(place.path(name)) for name in ("a flight.vid", "k\u00fcste.obj"))
    corners = [(0.1, 0.2, 0.3), (-0.4, 0.5, 0.6), (0.7, -0.8, 0.9)]
    points = "".join(f"[[point]]\nposition = {list(corner)}\n" for corner in corners)
    flight.write_text(f"version = 1\n{points}", encoding="utf-8")
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")

    def drag(file):
        command = [os.path.join(place.hosts, "drags"), file.as_uri()]
        source = Program(place.folder, command, server.env)
        place.programs.append(source)
        source.expect("ready")
        steps = [word for k in range(9) for word in ("mousemove", 30 + 70 * k, 30 + 50 * k)]
        server.xdotool(*steps[:3], "mousedown", 1, *steps[3:], "mouseup", 1)
        source.expect("dropped 1")
        source.kill()

    drag(flight)
    wait(lambda: host.path() == corners, "the path that was dropped")
    drag(mesh)
    saved = flight.read_bytes()
    server.press(window, "ctrl+s")
    wait(lambda: flight.read_bytes() != saved, "the file with the mesh")
    text = flight.read_text(encoding="utf-8")
    check(f'file = "{mesh.name}"\n' in text and text.count("[[point]]") == 3, text)
    host.leave()


@test()
def a_middle_click_pastes_what_is_marked(place):
    """The primary selection: of another program into a field, and of a field elsewhere."""
    server, host, window = opened(place)
    field = server.seen(window, lambda picture: panel_boxes(picture, FIELD)[0][0], "a field")
    server.click(window, *middle(field))
    server.xdotool("key", "--delay", "40", "ctrl+a", "Delete")
    server.drawn(window)
    server.copy("0.375", "primary")
    server.click(window, *middle(field), 2)
    server.drawn(window)
    server.xdotool("key", "Return")
    wait(lambda: host.path()[0][0] == 0.375, f"what was pasted: {host.path()[0]}")
    server.xdotool("mousemove", "--window", window, *map(int, middle(field)),
                   "click", "--repeat", 3, "--delay", 60, 1)
    wait(lambda: server.copied("primary") == "0.375", "what is marked")
    host.leave()


@test()
def a_large_text_comes_in_pieces(place):
    """More than one request carries, both ways."""
    server, host, window = opened(place)
    file_window(server, window, "ctrl+s")
    long = "ab" * 200_000
    server.copy(long)
    server.xdotool("key", "ctrl+v")
    server.drawn(window)
    server.copy("something else")
    server.xdotool("key", "--delay", "40", "ctrl+a", "ctrl+c")
    wait(lambda: server.copied() == long, "the long text")
    host.live()
    host.leave()


# ---- Screens -------------------------------------------------------------------------

def screens(place, *arguments, **options):
    """A window works on such a screen, and looks as on the usual one."""
    usual, special = place.server(), place.server(*arguments, **options)
    pictures = []
    for server in (usual, special):
        _, host, window = opened(place, server)
        pictures.append(server.drawn(window))
        hand_over(server, window)
        host.expect(f"poses 0 {POSES}")
        host.leave()
    one, other = pictures
    check((one.width, one.height) == (other.width, other.height), "another size")
    far = 0
    for y in range(0, one.height, 3):
        for x in range(0, one.width, 3):
            mine, its = one.pixel(x, y), other.pixel(x, y)
            far += any(abs(a - b) > 12 for a, b in zip(mine, its))
    check(far < one.width * one.height / 9 / 500, f"{far} pixels of another colour")


@test()
def a_screen_of_16_bits(place):
    """Five, six and five bits."""
    screens(place, screen="1920x1200x16")


@test()
def a_screen_of_15_bits(place):
    """Three times five."""
    screens(place, screen="1920x1200x15")


@test()
def a_screen_of_30_bits(place):
    """Three times ten."""
    screens(place, screen="1920x1200x30")


@test()
def no_shared_memory(place):
    """Pictures over the connection."""
    screens(place, options=("-extension", "MIT-SHM"))


@test()
def twice_as_many_pixels(place):
    """Xft.dpi of 192: everything twice as large, also when it changes later."""
    usual = place.server()
    _, host, window = opened(place, usual)
    _, _, width, height = usual.geometry(window)
    host.leave()
    server = place.server(screen="3000x2000x24")
    server.resources("Xft.dpi: 192")
    _, host, window = opened(place, server)
    check(server.geometry(window)[2:] == (2 * width, 2 * height), f"{server.geometry(window)}")
    hand_over(server, window)
    host.expect(f"poses 0 {POSES}")
    host.leave()
