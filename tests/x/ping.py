"""Asks a window whether it has seen all that came before: `_NET_WM_PING`, as a window manager
does. The X protocol in a few lines, since Xlib ends a program whose server goes.
"""

import select
import socket
import struct
import time

SUBSTRUCTURE_NOTIFY = 1 << 19


class Pinger:
    """A client of a server, that knows its cookie and asks windows."""

    def __init__(self, display, key):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(f"/tmp/.X11-unix/X{display.lstrip(':')}")
        name, data = b"MIT-MAGIC-COOKIE-1", bytes.fromhex(key)
        self.socket.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, len(name), len(data))
                            + _padded(name) + _padded(data))
        answer = self._read(8)
        setup = self._read(4 * struct.unpack("<H", answer[6:])[0])
        if answer[0] != 1:
            raise OSError(setup)
        vendor, formats = struct.unpack("<H", setup[16:18])[0], setup[21]
        self.root = struct.unpack_from("<I", setup, 32 + vendor + -vendor % 4 + 8 * formats)[0]
        self.protocols, self.ping = self._atom(b"WM_PROTOCOLS"), self._atom(b"_NET_WM_PING")
        self.count = 0
        # The root window is told what is answered.
        self._send(struct.pack("<BxHIII", 2, 4, self.root, 1 << 11, SUBSTRUCTURE_NOTIFY))

    def close(self):
        """It is no client any more."""
        self.socket.close()

    def answered(self, window, seconds):
        """Whether a window has answered within this time; one that is gone or answers no such
        question has no need to."""
        self._send(struct.pack("<BxHIIIII", 20, 6, window, self.protocols, 4, 0, 64))
        reply = self._reply(time.monotonic() + seconds)
        if reply is None or self.ping not in struct.unpack(f"<{len(reply[32:]) // 4}I", reply[32:]):
            return True
        self.count += 1
        data = self.ping, self.count, window
        self._send(struct.pack("<BxHII", 25, 11, window, 0)
                   + struct.pack("<BBHII5I", 33, 32, 0, window, self.protocols, *data, 0, 0))
        end = time.monotonic() + seconds
        while (event := self._event(end)) is not None:
            code = event[0] & 0x7F
            if code == 0:  # the window is gone
                return True
            if code == 33 and struct.unpack_from("<3I", event, 12) == data:
                return True
            if code == 17 and struct.unpack_from("<I", event, 8)[0] == window:  # destroyed
                return True
        return False

    def _atom(self, name):
        self._send(struct.pack("<BxHHxx", 16, 2 + (len(name) + 3) // 4, len(name)) + _padded(name))
        return struct.unpack_from("<I", self._reply(time.monotonic() + 60), 8)[0]

    def _send(self, request):
        self.socket.sendall(request)

    def _reply(self, end):
        """The next reply; None is an error."""
        while (event := self._event(end)) is not None:
            if event[0] in (0, 1):
                return event if event[0] == 1 else None
        raise TimeoutError("the X server does not answer")

    def _event(self, end):
        """What the server says next, whole; None if nothing till then."""
        if not select.select([self.socket], [], [], max(0.0, end - time.monotonic()))[0]:
            return None
        event = self._read(32)
        if event[0] & 0x7F in (1, 35):  # a reply, or an event of any length
            event += self._read(4 * struct.unpack_from("<I", event, 4)[0])
        return event

    def _read(self, count):
        data = b""
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            if not more:
                raise ConnectionResetError("the X server has gone")
            data += more
        return data


def _padded(text):
    """As long as the protocol has it."""
    return text + bytes(-len(text) % 4)
