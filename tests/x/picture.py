"""Pictures of a screen: taken with xwd, looked at, compared, written as PNG.

Nothing but the standard library: what a test says about a picture should not
hang on the version of somebody's image library.
"""

import struct
import zlib


class Picture:
    """Pixels as rows of bytes, four a pixel: blue, green, red, nothing."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    @classmethod
    def of_xwd(cls, data, area=None):
        """The picture in what xwd wrote, of any TrueColor depth, or an area
        (x, y, width, height) of it."""
        header = struct.unpack(">25I", data[:100])
        whole_width, whole_height, order = header[4], header[5], header[7]
        bits, stride, masks = header[11], header[12], header[14:17]
        start = header[0] + header[19] * 12
        x, y, width, height = area or (0, 0, whole_width, whole_height)
        width, height = min(width, whole_width - x), min(height, whole_height - y)
        size = bits // 8
        same = size == 4 and order == 0 and masks == (0xFF0000, 0xFF00, 0xFF)
        pixels = _Pixels(masks)
        rows = []
        for line in range(y, y + height):
            at = start + line * stride + x * size
            row = data[at:at + width * size]
            if size == 3:  # so xwd packs a screen on which windows' visuals differ
                packed, row = row, bytearray(4 * width)
                for i in range(3):
                    row[i::4] = packed[i::3]
                row = bytes(row)
            elif not same:
                kind = ("<>"[order], "H" if size == 2 else "I")
                values = struct.unpack(f"{kind[0]}{width}{kind[1]}", row)
                row = b"".join([pixels[value] for value in values])
            rows.append(row)
        return cls(width, height, rows)

    def pixel(self, x, y):
        """Red, green, blue."""
        blue, green, red = self.rows[y][4 * x:4 * x + 3]
        return red, green, blue

    def colours(self):
        """How many different colours there are."""
        seen = set()
        for row in self.rows:
            seen.update(struct.unpack(f"<{self.width}I", row))
        return len({colour & 0xFFFFFF for colour in seen})

    def find(self, colour, tolerance=24):
        """The places of the pixels that have about this colour."""
        wanted = colour[2], colour[1], colour[0]
        found = []
        for y, row in enumerate(self.rows):
            for x in range(self.width):
                if all(abs(row[4 * x + i] - wanted[i]) <= tolerance for i in range(3)):
                    found.append((x, y))
        return found

    def differs(self, other):
        """The rectangle (x, y, width, height) in which two of one size differ, or None."""
        rows = [y for y in range(self.height) if self._row(y) != other._row(y)]
        if not rows:
            return None
        left, right = self.width, 0
        for y in rows:
            mine, its = self._row(y), other._row(y)
            while left > 0 and mine[:3 * left] != its[:3 * left]:
                left -= 1
            while right < self.width and mine[3 * right:] != its[3 * right:]:
                right += 1
        return left, rows[0], right - left, rows[-1] - rows[0] + 1

    def _row(self, y):
        row = bytearray(self.width * 3)
        for i in range(3):
            row[2 - i::3] = self.rows[y][i::4]
        return bytes(row)

    def save(self, path):
        """Writes a PNG."""
        raw = b"".join(b"\0" + self._row(y) for y in range(self.height))
        with open(path, "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n")
            for kind, data in (
                (b"IHDR", struct.pack(">2I5B", self.width, self.height, 8, 2, 0, 0, 0)),
                (b"IDAT", zlib.compress(raw, 6)),
                (b"IEND", b""),
            ):
                check = zlib.crc32(kind + data)
                out.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check))


class _Pixels(dict):
    """From a pixel's value to its bytes, each computed once."""

    def __init__(self, masks):
        super().__init__()
        self.fields = []
        for mask in reversed(masks):
            shift = (mask & -mask).bit_length() - 1
            self.fields.append((mask, shift, mask >> shift))

    def __missing__(self, value):
        parts = [((value & mask) >> shift) * 255 // most for mask, shift, most in self.fields]
        self[value] = bytes([*parts, 0])
        return self[value]
