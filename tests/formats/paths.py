"""Random camera paths as .vid files: what the checks of the exporters fly along."""

import random

HALVES = (0.05, 1.0, 1.0, 3.0, 250.0)


def triple(values):
    return "[" + ", ".join(repr(float(value)) for value in values) + "]"


def flight(seed):
    """The text of one path; even seeds have y upright, odd ones z."""
    dice = random.Random(f"flight {seed}")
    half = dice.choice(HALVES)
    centre = [dice.uniform(-2, 2) * half for _ in range(3)]

    def place():
        return [middle + dice.uniform(-half, half) for middle in centre]

    fps = dice.choice([24.0, 25.0, 30.0, 29.97, 60.0])
    frames = dice.choice([12.0, 20.0, 40.0])
    lines = [
        "version = 1",
        f'title = "flight {seed}"',
        f"fps = {fps}",
        f"first_frame = {dice.choice([1, 1, 1, 0, 101])}",
        f"closed = {str(dice.random() < 0.3).lower()}",
        f'orientation_mode = "{dice.choice(["tcb", "barry-goldman", "slerp"])}"',
        f'zoom_mode = "{dice.choice(["smooth", "linear"])}"',
        f'curve = "{dice.choice(["tcb", "centripetal", "chordal", "cubic", "linear"])}"',
        "[base_speeds]",
        *(f"{what}_frames = {frames}" for what in ("move", "turn", "zoom", "roll")),
        "[space]",
        f"centre = {triple(centre)}",
        f"half_size = {half!r}",
        f'up = "{"yz"[seed % 2]}"',
    ]
    for _ in range(dice.randint(2, 5)):
        lines += ["[[point]]", f"position = {triple(place())}"]
        for _ in range(dice.choice([1, 1, 2])):
            lines.append("[[point.orientation]]")
            if dice.random() < 0.5:
                lines.append(f"target = {triple(place())}")
            else:
                lines.append(f"offset = {triple([dice.uniform(-half, half) for _ in range(3)])}")
            if dice.random() < 0.7:
                lines.append(f"roll_degrees = {dice.uniform(-179, 180)!r}")
            # From the widest to the narrowest, most as lenses are.
            zoom = dice.choice([dice.uniform(12, 120), 2 ** dice.uniform(0, 10.9)])
            lines.append(f"zoom_mm = {zoom!r}")
            if dice.random() < 0.3:
                lines.append(f"hold_frames = {dice.randint(1, 4)}")
            if dice.random() < 0.3:
                lines.append(f"turning = {{ tension = {dice.uniform(-1, 1)!r}, continuity = 0.0, bias = 0.2 }}")
    return "\n".join(lines) + "\n"
