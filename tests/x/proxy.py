"""A way to an X server on which some of its extensions are not to be found.

No server can do without the keyboard extension any more, and only a way over
the network is without the shared memory. Clients ask for an extension by its
name; here the name is made another one, of the same length, on the way.
"""

import os
import selectors
import socket
import threading


class Proxy:
    """Listens on a display of its own and hands everything on."""

    def __init__(self, server, hidden):
        self.hidden = [name.encode() for name in hidden]
        self.behind = f"/tmp/.X11-unix/X{server.name[1:]}"
        self.asked = set()
        self.listener = socket.socket(socket.AF_UNIX)
        number = 1000 + os.getpid() % 10_000
        while True:
            self.path = f"/tmp/.X11-unix/X{number}"
            try:
                self.listener.bind(self.path)
                break
            except OSError:
                number += 1
        self.listener.listen()
        self.name = f":{number}"
        threading.Thread(target=self._accept, daemon=True).start()

    def end(self):
        """Listens no longer."""
        self.listener.close()
        os.unlink(self.path)

    def _accept(self):
        while True:
            try:
                client, _ = self.listener.accept()
            except OSError:
                return
            server = socket.socket(socket.AF_UNIX)
            server.connect(self.behind)
            threading.Thread(target=self._carry, args=(client, server), daemon=True).start()

    def _carry(self, client, server):
        with selectors.DefaultSelector() as waiting, client, server:
            waiting.register(client, selectors.EVENT_READ, server)
            waiting.register(server, selectors.EVENT_READ, client)
            while True:
                for key, _ in waiting.select():
                    try:
                        data = key.fileobj.recv(1 << 16)
                        if not data:
                            return
                        if key.fileobj is client:
                            data = self._without(data)
                        key.data.sendall(data)
                    except OSError:
                        return

    def _without(self, data):
        for name in self.hidden:
            if name in data:
                self.asked.add(name.decode())
                data = data.replace(name, b"?" * len(name))
        return data
