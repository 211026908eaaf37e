"""Finding buttons and fields in a picture of the window, as an eye does: by
their colour and their place, not by numbers of pixels written down once.
"""

BUTTON = (0x2B, 0x30, 0x3A)
"""A button at rest, in the dark theme."""

FIELD = (0x12, 0x15, 0x1A)
"""What can be typed into, and the circle of a choice."""

PANEL = 262
"""Width of the panels, in pixels."""

DONE, REST = (0x58, 0xAE, 0xFF), (0x69, 0x73, 0x82)
"""The ruler's rail before and behind the playhead, in the dark theme."""

CHOSEN = (0x58, 0xAE, 0xFF)
"""The circle of the choice that is taken, and words that lead elsewhere."""


def boxes(picture, colour, left, top, right, bottom, least=(14, 14), tolerance=3):
    """Rectangles of one colour within an area, as rows from the top, each from
    the left: (x, y, width, height). Texts inside them do no harm."""
    wanted = bytes((colour[2], colour[1], colour[0]))
    open_boxes, done = [], []
    for y in range(top, min(bottom, picture.height)):
        runs = _runs(picture.rows[y], wanted, left, min(right, picture.width), tolerance)
        going = []
        for start, end in runs:
            for box in open_boxes:
                if start < box[2] and end > box[0]:
                    box[0], box[2], box[3] = min(box[0], start), max(box[2], end), y
                    going.append(box)
                    break
            else:
                going.append([start, y, end, y])
        for box in open_boxes:
            if not any(box is other for other in going):
                if box[3] < y - 3:
                    done.append(box)
                else:
                    going.append(box)
        unique = []
        for box in going:
            if not any(box is other for other in unique):
                unique.append(box)
        open_boxes = unique
    found = [(x, y, right - x, bottom - y + 1) for x, y, right, bottom in done + open_boxes
             if right - x >= least[0] and bottom - y + 1 >= least[1]]
    rows = []
    for box in sorted(found, key=lambda box: box[1] + box[3] / 2):
        middle = box[1] + box[3] / 2
        if rows and abs(rows[-1][0][1] + rows[-1][0][3] / 2 - middle) < 6:
            rows[-1].append(box)
        else:
            rows.append([box])
    return [sorted(row) for row in rows]


def panel_boxes(picture, colour):
    """Rectangles of one colour in the panels at the right edge of the window."""
    bottom = picture.height - timeline(picture.height)
    return boxes(picture, colour, picture.width - PANEL, 34, picture.width, bottom)


def _runs(row, wanted, left, right, tolerance):
    """Stretches of about this colour, gaps of less than 3 pixels bridged."""
    runs, start, last = [], None, None
    for x in range(left, right):
        at = 4 * x
        if (abs(row[at] - wanted[0]) <= tolerance and abs(row[at + 1] - wanted[1]) <= tolerance
                and abs(row[at + 2] - wanted[2]) <= tolerance):
            if start is None:
                start = x
            last = x
        elif start is not None and x - last > 2:
            if last - start >= 4:
                runs.append((start, last + 1))
            start = None
    if start is not None and last - start >= 4:
        runs.append((start, last + 1))
    return runs


def circles(picture, left, top, right, bottom):
    """The circles of choices within an area, from the top. The dot in the one that is
    taken may part it."""
    found = []
    for colour in (FIELD, CHOSEN):
        for row in boxes(picture, colour, left, top, right, bottom, least=(4, 3)):
            found += [box for box in row if box[2] <= 18 and box[3] <= 18]
    rows = []
    for box in sorted(found, key=lambda box: box[1]):
        if rows and box[1] < rows[-1][1] + 16:
            x, y, width, height = rows[-1]
            end = max(x + width, box[0] + box[2]), max(y + height, box[1] + box[3])
            x = min(x, box[0])
            rows[-1] = (x, y, end[0] - x, end[1] - y)
        else:
            rows.append(box)
    return [box for box in rows if box[2] >= 9 and box[3] >= 9]


def middle(box):
    """Where to click it."""
    x, y, width, height = box
    return x + width / 2, y + height / 2


def rail_above(height, markers=False):
    """How far above the lower edge of a window of this height the rail of the ruler runs:
    below it are the keys, the graph if there is room for it, and perhaps the names of markers."""
    return 4 + graph(height) + 24 + 7 + (16 if markers else 0)


def graph(height):
    """How high the graph is in a window of this height."""
    return 0 if height < 660 else round(min(max((height - 580) * 0.45, 56), 160))


def timeline(height):
    """How high the timeline is, from its buttons down to its graph."""
    return 32 + 25 + 24 + graph(height) + 4


def rail_of(picture):
    """Where the rail of the ruler runs: left, right, middle."""
    rows = {}
    row = picture.height - rail_above(picture.height)
    for colour in (DONE, REST):
        for x, y in picture.find(colour, 6):
            if abs(y - row) < 6:
                rows.setdefault(y, []).append(x)
    runs = {}
    for y, places in rows.items():
        places.sort()
        # The playhead has a narrow border, else there is no gap.
        breaks = [i for i in range(1, len(places)) if places[i] - places[i - 1] > 6]
        parts = zip([0] + breaks, breaks + [len(places)])
        runs[y] = max(((places[i], places[k - 1]) for i, k in parts), key=lambda run: run[1] - run[0])
    longest = max(end - start for start, end in runs.values())
    rail = [y for y, (start, end) in runs.items() if end - start > longest - 4]
    return *runs[rail[0]], (min(rail) + max(rail)) // 2
