"""The pyramid example of the thesis (7.5), played on the Motif host with mouse
and keyboard, in English and in German; then the same flight beside a program that
flies along, and a scene beside one that draws it:
demo.py PYRAMID_MOTIF GLUT_FLIGHT GLUT_SCENE FLIGHT FOLDER [short]

Leaves a picture of each step and the poses in the folders FOLDER/en and
FOLDER/de. The poses must be the same. FOLDER/glut.png shows both programs at the
same moment of the flight, FOLDER/scene.png both at the same frame of the scene. Short: only
in English, and the latter.
"""

import concurrent.futures
import os
import shutil
import sys
import tempfile

from harness import Failure, Program, Server, check, wait
from panel import BUTTON, FIELD, PANEL, boxes, circles, middle, panel_boxes, rail_above, timeline
from space import first_look

START = [(-0.6, 0.2, 0.8), (0.6, 0.2, 0.8)]
FLIGHT = [(-0.6, 0.2, 0.8), (-0.85, 0.3, 0.1), (-0.7, 0.35, -0.65),
          (0.75, 0.35, -0.65), (0.85, 0.3, 0.1), (0.6, 0.2, 0.8)]
SUMMIT = (0.0, 0.5, 0.0)
CORNER = 3
"""The point at which the camera stands and pans."""
AWAY = 60, 560
"""In the window, below the rows of the list: over a row, its help would come up and
cover a part of the space before that is measured."""


class Player:
    """Hands that know the window."""

    def __init__(self, server, program, folder):
        self.server, self.program, self.folder = server, program, folder
        self.host = self.window = None
        self.step = 0
        self.current = 0

    def shot(self, what):
        """A picture of the whole screen."""
        self.server.drawn(self.window or self.host, 1)
        self.step += 1
        name = f"{self.step}-{what}.png"
        self.server.picture().save(os.path.join(self.folder, name))
        print(f"  {os.path.basename(self.folder)}/{name}", flush=True)

    def press_host(self, number):
        """One of the three buttons of the host."""
        _, _, width, height = self.server.geometry(self.host)
        self.server.click(self.host, width / 2, height * (2 * number + 1) / 6)

    def found(self, colour, row, column):
        """One of them, as soon as it is there: under the pointer it has another
        colour, until the window has seen the pointer go."""
        return self.server.seen(self.window, lambda picture: panel_boxes(picture, colour)[row][column],
                                f"row {row}, column {column} of the panels")

    def button(self, row, column):
        """Clicks a button in the panels, counted as they stand there."""
        self.click(self.found(BUTTON, row, column))
        self.away()

    def press(self, key):
        """Presses a key in the window."""
        self.server.press(self.window, key)
        self.away()

    def number(self, row, column, value):
        """Types a number into a field in the panels."""
        self.click(self.found(FIELD, row, column))
        self.server.xdotool("key", "--delay", "20", "ctrl+a")
        self.server.type(f"{value:g}")
        self.server.xdotool("key", "Return")
        self.away()

    def away(self):
        """The pointer where it covers and lights nothing."""
        self.server.xdotool("mousemove", "--window", self.window, *AWAY)

    def click(self, box):
        """Clicks what was found."""
        self.server.click(self.window, *middle(box))


def go_to(player, number):
    """Makes a point, counted from 0, the current one."""
    while player.current != number:
        player.press("ctrl+Page_Down")
        player.current = (player.current + 1) % len(FLIGHT)


def place_points(player):
    """Abbildungen 7.3 and 7.4: four more points, then each to its place by the
    mouse: along the ground with the middle button, then up with the right one."""
    space = player.server.seen(player.window, first_look, "the space")
    player.press("ctrl+i")
    player.shot("how-many")
    player.server.xdotool("key", "4")
    player.away()
    player.shot("four-more-points")
    player.current = 1  # the first of the new ones
    for number in range(1, 5):
        begin = [START[0][k] + (START[1][k] - START[0][k]) * number / 5 for k in range(3)]
        goal = FLIGHT[number]
        along = (goal[0], begin[1], goal[2])
        for start, end, button in ((begin, along, 2), (along, goal, 3)):
            player.server.drag(player.window, space.image(start), space.image(end), button)
        player.away()
        player.server.drawn(player.window)
        go_to(player, number + 1)
    player.shot("points-placed")


def shape(player, at, preset):
    """Abbildung 7.5: gives a point a preset of the curve's shape."""
    go_to(player, at)
    player.press("F2")

    def choices(picture):
        found = circles(picture, 0, 34, picture.width - PANEL, picture.height)
        return len(found) > 10 and found

    player.click(player.server.seen(player.window, choices, "the presets")[preset])
    if preset == 5:
        player.shot("shape-of-the-curve")

    def okay(picture):
        """The last of two buttons, beside the list, which has buttons as well."""
        rows = boxes(picture, BUTTON, 150, 34, picture.width - PANEL,
                     picture.height - timeline(picture.height))
        return [row for row in rows if len(row) > 1][-1][-1]

    player.click(player.server.seen(player.window, okay, "OK"))
    player.away()
    wait(lambda: not choices(player.server.drawn(player.window)), "the window to close")


def slow_start(player):
    """Abbildung 7.7: after the pan the camera sets off slowly."""
    go_to(player, CORNER)
    for _ in range(3):
        player.press("ctrl+shift+Page_Down")
    player.press("F3")

    def shapes(picture):
        found = boxes(picture, BUTTON, 0, 34, picture.width - PANEL,
                      picture.height - timeline(picture.height))
        return [row for row in found if len(row) >= 5][0][1]

    player.click(player.server.seen(player.window, shapes, "the shapes"))
    player.shot("speed-curve")
    player.server.xdotool("key", "Escape")
    player.away()


def aim(player, target):
    """Gives the current orientation a target in the world, by numbers."""
    for axis in range(3):
        player.number(3, axis, target[axis])


def aim_all(player):
    """Abbildung 7.6: everything looks at the summit; at the corner the camera pans."""
    for number in range(len(FLIGHT)):
        go_to(player, number)
        player.button(0, 0)
        aim(player, SUMMIT)
        if number == CORNER:
            for target in ((-0.3, 0.0, -0.3), (0.3, 0.0, 0.3), SUMMIT):
                player.press("alt+Insert")
                aim(player, target)
            player.shot("looking")


def play(server, program, folder):
    """The whole of it."""
    player = Player(server, program, folder)
    player.host = server.window("^MainTest$")
    server.place(player.host, 1240, 60)
    player.press_host(0)
    player.window = server.new_window()
    player.away()
    player.shot("window")
    place_points(player)
    shape(player, 2, 2)
    shape(player, CORNER, 5)
    aim_all(player)
    slow_start(player)
    player.shot("flight")
    server.press(player.window, "alt+u")
    line = program.expect("")
    wait(lambda: program.said and program.said[-1].startswith(f"pose {line.split()[0]}:"),
         "all poses")
    player.shot("handed-over")
    count = int(line.split()[0])
    with open(os.path.join(folder, "poses.txt"), "w", encoding="ascii") as out:
        out.write("\n".join(program.said[1:count + 1]) + "\n")
    print(f"  {os.path.basename(folder)}/poses.txt: {count} poses, as the host got them")
    player.press_host(1)
    program.expect("pose 1:")
    server.press(player.window, "ctrl+s")
    player.shot("saving")
    server.xdotool("key", "--delay", "20", "ctrl+a")
    server.type(os.path.join(folder, "flight.vid"))
    server.xdotool("key", "Return")
    wait(lambda: os.path.exists(os.path.join(folder, "flight.vid")), "the saved path")
    print(f"  {os.path.basename(folder)}/flight.vid: the path, as the window saved it")
    server.press(player.window, "alt+F4")
    program.expect("the editor asks")
    player.window = None
    player.press_host(2)
    check(program.ends() == 0, "the host's exit status")


def demo(binary, folder, locale):
    """In one language."""
    # The window would ask before it writes over an earlier flight.
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    with tempfile.TemporaryDirectory(prefix="vides-demo-") as work:
        server = Server(work, screen="1400x860x24")
        server.env["LC_ALL"] = locale
        program = Program(work, [binary], server.env, terminal=True)
        try:
            play(server, program, folder)
        except Failure:
            server.picture().save(os.path.join(folder, "failed.png"))
            raise
        finally:
            program.kill()
            server.end()
    with open(os.path.join(folder, "poses.txt"), encoding="ascii") as poses:
        return poses.read()


def beside(command, name, folder, picture, about, orbits):
    """The editor and a program with a picture of its own, at the same moment."""
    with tempfile.TemporaryDirectory(prefix="vides-demo-") as work:
        server = Server(work, screen="1840x860x24", options=("+extension", "GLX"))
        server.env.update(LIBGL_ALWAYS_SOFTWARE="1", LC_ALL="C.UTF-8")
        program = Program(work, command, server.env)
        try:
            host = server.named(f"^{name}$")
            server.place(host, 1220, 40)
            window = server.new_window()
            if orbits:
                # Its own camera goes round the object.
                server.drag(host, (100, 60), (150, 120))
            width, height = server.geometry(window)[2:]
            server.drawn(window)
            before = server.drawn(host, 1)
            # The playhead is put in the middle.
            server.click(window, width // 2, height - rail_above(height, markers=not orbits))
            wait(lambda: server.picture(host).differs(before), "the host to follow")
            server.xdotool("mousemove", "--window", window, *AWAY)
            server.drawn(host, 1)
            server.drawn(window)
            server.picture().save(os.path.join(folder, picture))
            print(f"  {picture}: {about}", flush=True)
        finally:
            program.kill()
            server.end()


def main():
    """See the top."""
    binary, glut, scene, flight, folder = map(os.path.abspath, sys.argv[1:6])
    languages = [("en", "en_GB.UTF-8"), ("de", "de_DE.UTF-8")][:1 if sys.argv[6:] else 2]
    # Side by side: most of the time is waiting.
    with concurrent.futures.ThreadPoolExecutor() as pool:
        flights = list(pool.map(
            lambda one: demo(binary, os.path.join(folder, one[0]), one[1]), languages))
    check(flights[0] == flights[-1], "the flight depends on the language")
    beside([glut, flight], "glut_flight", folder, "glut.png",
           "a program of today beside the editor, at the same moment", orbits=True)
    beside([scene], "glut_scene", folder, "scene.png",
           "a scene in the editor, drawn by a program at the same frame, in its picture too",
           orbits=False)


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"demo: {failure}")
