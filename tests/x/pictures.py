"""Makes pictures of the window: pictures.py HOSTS_FOLDER DOCS_FOLDER VIDES

For the README, dark and light, at one and at two pixels a point: the flight around the
pyramid, seen in the middle of it. For docs/reference/scene.md: the car of examples/car.vid, and
the keys of its way.
"""

import os
import subprocess
import sys
import tempfile

from harness import Server, Told

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples")
PYRAMID = os.path.join(EXAMPLES, "pyramid.vid")
CAR = os.path.join(EXAMPLES, "car.vid")


def take(hosts, theme, scale, path):
    """One picture."""
    with tempfile.TemporaryDirectory(prefix="vides-x-") as folder:
        server = Server(folder, screen="2500x1700x24")
        host = None
        try:
            if scale != 1:
                server.resources(f"Xft.dpi: {96 * scale}")
            setup = os.path.join(server.env["XDG_CONFIG_HOME"], "vides")
            os.makedirs(setup)
            with open(os.path.join(setup, "setup.toml"), "w", encoding="ascii") as out:
                out.write(f'theme = "{theme}"\n')
            server.env.update(LANG="en_GB.UTF-8")
            host = Told(folder, [os.path.join(hosts, "loop_poll-archive")], server.env)
            host.edit(0, os.path.realpath(PYRAMID))
            window = server.new_window()
            # The corner where the camera pans, in the list.
            server.click(window, 60 * scale, 150 * scale)
            server.drawn(window)
            server.xdotool("mousemove", 2490, 1690)
            server.drawn(window).save(path)
        finally:
            if host:
                host.kill()
            server.end()


def scene(vides, path):
    """The car is selected, and its keys are seen as curves."""
    with tempfile.TemporaryDirectory(prefix="vides-x-") as folder:
        server = Server(folder, screen="2500x1700x24")
        program = None
        try:
            server.env.update(LANG="en_GB.UTF-8")
            program = subprocess.Popen([vides, "edit", os.path.realpath(CAR)], env=server.env)
            window = server.new_window()
            server.drawn(window)
            server.click(window, 60, 112)
            server.drawn(window)
            server.click(window, 128, server.geometry(window)[3] - 176)
            server.drawn(window)
            server.xdotool("mousemove", 2490, 1690)
            server.drawn(window).save(path)
        finally:
            if program:
                program.kill()
                program.wait()
            server.end()


def main():
    """See the top."""
    hosts, docs, vides = map(os.path.abspath, sys.argv[1:4])
    scene(vides, os.path.join(docs, "reference/scene.png"))
    print("scene.png")
    for theme in ("dark", "light"):
        for scale in (1, 2):
            name = f"window-{theme}{'-2x' if scale == 2 else ''}.png"
            take(hosts, theme, scale, os.path.join(docs, "start", name))
            print(name)


if __name__ == "__main__":
    main()
