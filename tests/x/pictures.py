"""Makes the README's pictures of the window: pictures.py HOSTS_FOLDER DOCS_FOLDER

Dark and light, at one and at two pixels a point: the flight around the pyramid,
seen in the middle of it.
"""

import os
import sys
import tempfile

from harness import Server, Told

PYRAMID = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/pyramid.vid")


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


def main():
    """See the top."""
    hosts, docs = map(os.path.abspath, sys.argv[1:3])
    for theme in ("dark", "light"):
        for scale in (1, 2):
            name = f"window-{theme}{'-2x' if scale == 2 else ''}.png"
            take(hosts, theme, scale, os.path.join(docs, name))
            print(name)


if __name__ == "__main__":
    main()
