"""A way to an X server on which some of its extensions are not to be found, or a reply is an
error.

No server can do without the keyboard extension any more, and only a way over
the network is without the shared memory. Clients ask for an extension by its
name; here the name is made another one, of the same length, on the way.
"""

import os
import selectors
import socket
import threading


class Answers:
    """The server's packets of one connection; the reply with this number becomes an error."""

    def __init__(self, error_at):
        self.error_at, self.number, self.rest = error_at, 0, b""

    def changed(self, data):
        """The whole packets of what has come by now."""
        self.rest += data
        out = b""
        while True:
            head = 32 if self.number else 8
            if len(self.rest) < head:
                return out
            if not self.number:
                length = head + 4 * int.from_bytes(self.rest[6:8], "little")
            elif self.rest[0] == 1:
                length = head + 4 * int.from_bytes(self.rest[4:8], "little")
            else:
                length = head
            if len(self.rest) < length:
                return out
            packet, self.rest = self.rest[:length], self.rest[length:]
            if self.number == self.error_at and packet[0] == 1:
                packet = bytes((0, 11)) + packet[2:4] + bytes(28)
            self.number += 1
            out += packet


class Proxy:
    """Listens on a display of its own and hands everything on."""

    def __init__(self, server, hidden, error_at=None):
        self.hidden = [name.encode() for name in hidden]
        self.behind = f"/tmp/.X11-unix/X{server.name[1:]}"
        self.asked = set()
        self.error_at = error_at
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
            answers = Answers(self.error_at)
            while True:
                for key, _ in waiting.select():
                    try:
                        data = key.fileobj.recv(1 << 16)
                        if not data:
                            return
                        if key.fileobj is client:
                            data = self._without(data)
                        elif self.error_at is not None:
                            data = answers.changed(data)
                        key.data.sendall(data)
                    except OSError:
                        return

    def _without(self, data):
        for name in self.hidden:
            if name in data:
                self.asked.add(name.decode())
                data = data.replace(name, b"?" * len(name))
        return data
