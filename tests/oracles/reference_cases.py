"""The paths that reference.py works out, easy ones first."""

import random

PRESETS = [
    (0, 0, 0), (0.3, 0, 0), (0.6, 0, 0), (-0.3, 0, 0), (-0.6, 0, 0),
    (0, -0.5, 0), (0, 0.5, 0), (0, 0, 0.5), (0, 0, -0.5), (0, 0, 0),
]  # fmt: skip
FLAT = [50] * 10
EASE_IN = [1, 5, 12, 25, 40, 55, 70, 85, 95, 100]
EASE_OUT = EASE_IN[::-1]
WILD = [100, 1, 1, 100, 100, 1, 50, 100, 1, 1]
CLIPPED = [100, 1, 100, 1, 100, 1, 100, 1, 100, 1]


def view(direction=(0, 0, -0.4), at=None, roll=0, zoom=24, tcb=(0, 0, 0), speeds=FLAT, hold=0, slope=None, up="y"):
    """An orientation: `direction` relative, `at` an absolute target."""
    return {
        "absolute": at is not None,
        "target": at if at is not None else direction,
        "roll": roll,
        "zoom": zoom,
        "tcb": tcb,
        "speeds": speeds,
        "hold": hold,
        "zoom_slope": slope,
        "up": up,
    }


def point(position, *orientations, tcb=None, preset=0):
    return {
        "position": position,
        "tcb": tcb,
        "preset": preset,
        "orientations": list(orientations) or [view()],
    }


def path(
    name, about, points, closed=False, mode="tcb", zoom="smooth",
    speeds=(100, 100, 100, 100), presets=PRESETS, wanted=100,
):  # fmt: skip
    return {
        "name": name,
        "about": about,
        "points": points,
        "closed": closed,
        "orientation_mode": mode,
        "zoom_mode": zoom,
        "speeds": speeds,
        "presets": presets,
        "wanted": wanted,
    }


def wander(seed, count, tcb=0.0, turn_tcb=0.0, extra=0.0, targets=0.0, speeds=False):
    """Points and orientations at random, with numbers that are easy to read."""
    r = random.Random(seed)

    def number(low, high):
        return round(r.uniform(low, high), 3)

    def three(size):
        return tuple(number(-size, size) for _ in range(3))

    points = []
    for _ in range(count):
        orientations = []
        for _ in range(1 if r.random() >= extra else r.randint(2, 3)):
            at = three(3) if r.random() < targets else None
            orientations.append(
                view(
                    three(1),
                    at=at,
                    roll=number(-179, 180),
                    zoom=number(1, 100),
                    tcb=three(turn_tcb),
                    speeds=[number(1, 100) for _ in range(10)] if speeds else FLAT,
                )
            )
        points.append(point(three(1), *orientations, tcb=three(tcb)))
    return points


CORNERS = [(-0.8, 0.1, 0.7), (-0.2, 0.6, 0.3), (0.5, -0.3, 0.4), (0.7, 0.4, -0.6), (-0.4, -0.5, -0.7)]
LOOKS = [(0.1, 0, -0.4), (0.3, 0.1, -0.3), (0.4, -0.2, 0.1), (-0.1, 0.2, 0.4), (-0.4, 0, -0.2)]


def tour(tcb=(0, 0, 0), turn=(0, 0, 0), preset=None, **more):
    """Five corners, turning, rolling and zooming gently."""
    return [
        point(
            p,
            view(d, roll=r, zoom=z, tcb=turn, **more),
            tcb=None if preset is not None else tcb,
            preset=preset or 0,
        )
        for p, d, r, z in zip(CORNERS, LOOKS, (0, 10, -20, 5, 30), (24, 35, 50, 28, 20))
    ]


# Cases that come a second time with many frames in a section.
LONG = (
    "tcb_mixed_tcb", "tension_one", "closed", "pans", "speed_extremes", "short_beside_long", "neighbours_170",
    "half_turns", "tracked", "tracked_past", "tracked_over", "tracked_through", "tracked_beside_free_closed",
    "kept_beside_free", "barry_goldman_closed", "slerp_tracked", "runs_back", "cusp", "tiny_and_huge", "zoom_linear",
    "random_1", "random_2",
)  # fmt: skip


def cases():
    for case in short_cases():
        yield case
        if case["name"] in LONG:
            slow = tuple(40 * s for s in case["speeds"])
            yield dict(case, name=f"long_{case['name']}", speeds=slow, wanted=50)


def short_cases():
    yield path(
        "default", "The path that a new window begins with.",
        [point((-0.6, 0.2, 0.8)), point((0.6, 0.2, 0.8))], wanted=130,
    )  # fmt: skip
    yield path(
        "two_points_tension", "Two points: end tangents are (1 - tension) of the chord.",
        [
            point((-0.6, 0.2, 0.8), view((0.2, 0.1, -0.4), zoom=10), tcb=(0.7, 0.3, -0.2)),
            point((0.5, -0.3, 0.1), view((-0.4, 0, 0.1), zoom=80, tcb=(0.5, 0.5, 0.5)), tcb=(-1, 0.5, 0.5)),
        ],
    )  # fmt: skip
    yield path("three_points", "Three points, two sections: both ends quadratic.", tour()[:3])
    yield path("catmull_rom", "Five points with t = c = b = 0.", tour(), wanted=160)
    for name, values in (
        ("tension", (0.6, 0, 0)), ("loose", (-0.8, 0, 0)), ("continuity", (0, 0.7, 0)),
        ("corner", (0, -1, 0)), ("bias", (0, 0, 0.8)), ("mixed_tcb", (0.25, -0.4, -0.6)),
    ):  # fmt: skip
        yield path(f"tcb_{name}", f"Position and turning with t, c, b = {values}.", tour(values, values), wanted=80)
    yield path(
        "tension_one", "Tension 1: every segment starts and ends at rest in its own parameter.",
        tour((1, 0, 0), (1, 0, 0)), wanted=80,
    )  # fmt: skip
    many = [point(p["position"], *p["orientations"], preset=k) for k, p in enumerate(tour() + tour())]
    for k, p in enumerate(many):
        p["position"] = tuple(round(x + 0.11 * k, 2) for x in p["position"])
    yield path("presets", "Every preset once, the last one changed.", many,
               presets=PRESETS[:9] + [(0.2, 0.4, -0.6)], wanted=130)  # fmt: skip

    yield path("closed", "A closed path: neighbours wrap.", tour((0.1, -0.2, 0.3), (0.2, 0.1, -0.3)), closed=True,
               wanted=120)  # fmt: skip
    yield path("closed_two_points", "A closed path of two points: there and straight back.", tour()[:2], closed=True,
               wanted=80)  # fmt: skip
    yield path(
        "closed_round", "Closed, turning round by 90 degrees each: the sign at the seam differs.",
        [
            point((x, 0, z), view((x, 0.1, z), zoom=q))
            for x, z, q in ((1, 0, 20), (0, 1, 40), (-1, 0, 60), (0, -1, 30))
        ],
        closed=True, wanted=120,
    )  # fmt: skip
    seam = tour()
    seam.append(point(seam[0]["position"], view(LOOKS[0], zoom=24, speeds=EASE_IN)))
    yield path(
        "closed_merged_seam", "Closed; the last point has the place and the view of the first: one key.",
        [dict(p, tcb=(1, 0, 0)) for p in seam], closed=True, wanted=80,
    )  # fmt: skip

    yield path(
        "pans", "Several orientations at a point: the camera stands and turns, then goes on.",
        [
            point(CORNERS[0], view(LOOKS[0]), view(LOOKS[2], zoom=60), view(LOOKS[3], roll=40)),
            point(CORNERS[1], view(LOOKS[1], roll=-30)),
            point(CORNERS[2], view(LOOKS[4]), view(LOOKS[0], zoom=12, tcb=(0.3, 0.2, 0.1)), tcb=(0, -0.5, 0)),
            point(CORNERS[3], view(LOOKS[2], roll=15), view(LOOKS[3], zoom=90)),
        ],
        speeds=(60, 80, 120, 50), wanted=150,
    )  # fmt: skip
    yield path(
        "roll_only", "The roll alone changes, the shorter way round.",
        [
            point(CORNERS[0], view(LOOKS[0], roll=170), view(LOOKS[0], roll=-150), view(LOOKS[0], roll=-60)),
            point(CORNERS[1], view(LOOKS[0], roll=-60)),
        ],
        speeds=(100, 100, 100, 70),
    )  # fmt: skip
    yield path(
        "zoom_only", "The zoom alone changes, at one point, three keys that rise, one that falls.",
        [
            point(CORNERS[0], view(zoom=10), view(zoom=15), view(zoom=70), view(zoom=20)),
            point(CORNERS[1], view(zoom=20), view(zoom=22.5)),
        ],
        speeds=(100, 100, 130, 100), wanted=130,
    )  # fmt: skip
    twice = tour()
    twice[1]["orientations"] = [
        view(LOOKS[1], roll=10, zoom=35, speeds=WILD, hold=3, tcb=(1, 0, 0)),
        view(LOOKS[1], roll=10, zoom=35, speeds=EASE_IN, tcb=(0, 0.3, 0)),
    ]
    twice[2]["orientations"] = [
        view(LOOKS[2], roll=-20, zoom=50, tcb=(0, 0, 1), hold=2),
        view(LOOKS[2], roll=-20, zoom=50, speeds=WILD),
        view(LOOKS[2], roll=-20, zoom=50, speeds=EASE_OUT, tcb=(0.5, 0, 0), hold=5),
    ]
    twice[0]["orientations"] *= 2
    twice[4]["orientations"] = [view(LOOKS[4], roll=30, zoom=20), view(LOOKS[4], roll=30, zoom=20, tcb=(0.4, 0, 0))]
    yield path("merged", "Keys between which nothing changes are one, with the later one's properties.", twice)
    yield path(
        "holds", "Rests at the first, an inner and the last key.",
        [
            point(CORNERS[0], view(LOOKS[0], hold=4)),
            point(CORNERS[1], view(LOOKS[1], hold=7), view(LOOKS[2], zoom=50, hold=1)),
            point(CORNERS[2], view(LOOKS[3], hold=3)),
        ],
        speeds=(20, 20, 20, 20), wanted=120,
    )  # fmt: skip
    rests = tour(hold=3)
    yield path("holds_closed", "Rests on a closed path: the arrival counts none.", rests, closed=True,
               speeds=(15, 20, 20, 20), wanted=130)  # fmt: skip

    curves = [EASE_IN, EASE_OUT, WILD, CLIPPED, FLAT]
    fast = tour()
    for p, c in zip(fast, curves):
        p["orientations"][0]["speeds"] = c
    yield path("speed_curves", "Unequal speed curves, some clipped at 1 and 100.", fast, wanted=170)
    yield path("speed_curves_closed", "The same on a closed path.", fast, closed=True, wanted=100)
    ramps = [
        [20 + 30 * k / 9 for k in range(10)], [50 + 30 * k / 9 for k in range(10)], [80] * 10,
        [80, 79, 75, 68, 59, 50, 42, 36, 32, 30], [30, 31, 90, 20, 50, 50, 40, 35, 30, 1], EASE_IN, EASE_OUT,
        [1, 2, 2, 5, 9, 20, 20, 20, 20, 20],
    ]  # fmt: skip
    corners = [(0, 0, 0), (0.4, 0.1, 0), (0.9, 0.3, 0.2), (0.8, 0.7, 0.1), (0.3, 0.6, -0.4), (-0.5, 0.2, -0.3)]
    for closed in (False, True):
        joined = [point(c, view(LOOKS[k % 5], zoom=20 + 5 * k, speeds=ramps[k])) for k, c in enumerate(corners)]
        # Two more at the last point: a joint of a move and a turn, and one at which the camera rests.
        joined[5]["orientations"] += [
            view(LOOKS[1], speeds=ramps[6]), view(LOOKS[2], speeds=ramps[7], hold=2),
            view(LOOKS[3], speeds=ramps[0]),
        ]  # fmt: skip
        yield path(
            "speed_joints_closed" if closed else "speed_joints",
            "Equal facing speeds: the acceleration is continuous.", joined,
            closed=closed, speeds=(170, 120, 100, 100), wanted=150,
        )  # fmt: skip
    yield path(
        "speed_extremes", "100, 1, 1, 100 and the like, looked at closely.",
        [
            point((0, 0, 0), view(LOOKS[0], speeds=[100, 1, 1, 100, 100, 1, 1, 100, 100, 1])),
            point((1, 0, 0), view(LOOKS[1], speeds=CLIPPED[::-1])),
            point((1, 1, 0), view(LOOKS[2])),
        ],
        wanted=180,
    )  # fmt: skip
    yield path(
        "short_beside_long", "Few frames, then many: the limiter at work.",
        [
            point((0, 0, 0), view((0, 0, 1))),
            point((0.1, 0, 0), view((1, 0, 0.02))),
            point((1.1, 0.2, 0), view((0.8, 0, -0.5), roll=3)),
            point((1.2, 0.2, 0), view((-0.6, 0.3, -0.5))),
            point((2.4, 0, 0.3), view((-0.7, 0.2, -0.5))),
        ],
        wanted=120,
    )  # fmt: skip
    yield path(
        "single_frames", "So fast that sections have one frame, or two.",
        tour(), speeds=(1.4, 1.2, 1, 1),
    )  # fmt: skip

    def yawed(degrees, up=0.0):
        import math

        a = math.radians(degrees)
        return (round(math.sin(a), 6), up, round(math.cos(a), 6))

    yield path(
        "neighbours_170", "Neighbours 170 degrees apart, to and fro and round.",
        [
            point((0.1 * k * k, 0.05 * k, 0.3 * k), view(yawed(a, up), roll=r))
            for k, (a, up, r) in enumerate(
                ((0, 0, 0), (170, 0.1, 0), (-20, 0, 0), (150, -0.2, 20), (-40, 0.1, 10), (130, 0, 0))
            )
        ],
        wanted=130,
    )  # fmt: skip
    yield path(
        "half_turns", "Exact half turns about y, about x (with the roll), about z, about y again.",
        [
            point((0, 0, 0), view((0, 0, -1))),
            point((0.5, 0.1, 0), view((0, 0, 1))),
            point((1, 0, 0.2), view((0, 0, -1), roll=180)),
            point((1.5, 0, 0), view((0, 0, -1), roll=0)),
            point((2, 0.3, 0), view((0, 0, 1), roll=0)),
            point((2, 0.6, 0.4), view((0.3, 0.2, 1), roll=20)),
        ],
        wanted=130,
    )  # fmt: skip
    yield path(
        "half_turn_pans", "Half turns in place, closed, all the way round.",
        [
            point((0, 0, 0), view((0, 0, -1)), view((0, 0, 1))),
            point((0.5, 0, 0), view((1, 0, 0)), view((-1, 0, 0))),
        ],
        closed=True, speeds=(50, 40, 50, 50), wanted=100,
    )  # fmt: skip
    yield path(
        "mixed_signs", "Views spread so that neighbouring quaternions differ in sign.",
        [
            point((0.3 * k, 0.1 * (k % 3), 0.2 * (k % 2)), view(yawed(100 * k, 0.2 - 0.1 * (k % 4)), roll=160 - 95 * (k % 4)))
            for k in range(8)
        ],
        wanted=120,
    )  # fmt: skip
    yield path(
        "poles", "Straight up and straight down, with roll, and on to the side.",
        [
            point((0, 0, 0), view((0, 0, 1))),
            point((0.5, 0, 0), view((0, 1, 0), roll=30)),
            point((1, 0.2, 0), view((1, 0.1, 0))),
            point((1.5, 0, 0), view((0, -2, 0))),
            point((2, 0, 0.3), view((0, -1, 0), roll=-120)),
            point((2.3, 0, 0.3), view((0, 0, -1))),
        ],
        wanted=130,
    )  # fmt: skip

    eye = (0, 0.1, 0)
    yield path(
        "tracked", "The whole path looks at one target; the roll goes the shorter way over 180 degrees.",
        [
            point(p, view(at=eye, roll=r, zoom=z))
            for p, r, z in zip(CORNERS, (0, 60, 170, -150, -100), (24, 30, 60, 40, 20))
        ],
        wanted=130,
    )  # fmt: skip
    yield path(
        "tracked_closed", "Closed and tracked all round, rolling once about itself.",
        [point(p, view(at=eye, roll=r)) for p, r in zip(CORNERS, (0, 80, 150, -140, -60))],
        closed=True, wanted=120,
    )  # fmt: skip
    yield path(
        "tracked_past", "Straight past a target, close by.",
        [point((-1, 0, 0), view(at=(0, 0.05, 0.08))), point((1, 0, 0), view(at=(0, 0.05, 0.08), roll=20))],
        wanted=130,
    )  # fmt: skip
    yield path(
        "tracked_over", "Straight over a target: the yaw holds where the view is vertical, then is the other one.",
        [point((-1, 1, 0.5), view(at=(0, 0, 0.5))), point((1, 1, 0.5), view(at=(0, 0, 0.5), roll=20))],
        wanted=90,
    )  # fmt: skip
    yield path(
        "tracked_through", "Straight through the target: the last direction holds there.",
        [point((-1, 0.5, 0), view(at=(0, 0, 0))), point((1, -0.5, 0), view(at=(0, 0, 0)))],
        speeds=(89.44271909999159, 100, 100, 100), wanted=90,
    )  # fmt: skip
    yield path(
        "tracked_pans", "Zoom and roll at one point with the same target.",
        [
            point(
                CORNERS[0],
                view(at=eye, roll=170, zoom=20),
                view(at=eye, roll=-160, zoom=20),
                view(at=eye, roll=-100, zoom=60),
            ),
            point(CORNERS[1], view(at=eye, roll=-90, zoom=40), view(at=eye, roll=-90, zoom=20)),
        ],
        speeds=(60, 100, 90, 70),
    )  # fmt: skip
    beside = [
        point(CORNERS[0], view((0.2, 0.3, -1))),
        point(CORNERS[1], view((0.5, 0.1, -1), roll=10, tcb=(0.5, 0.5, 0.5))),
        point(CORNERS[2], view(at=eye, roll=5, tcb=(0.3, -0.6, 0.4))),
        point(CORNERS[3], view(at=eye, roll=-15, tcb=(0.1, 0.2, 0.3))),
        point(CORNERS[4], view(at=eye, roll=25, tcb=(0.9, 0, 0))),
        point((-0.9, -0.1, 0.1), view((1, 0.2, -0.4))),
        point((-1, 0.4, 0.9), view((0.4, 0.2, -0.9), roll=20)),
    ]
    yield path("tracked_beside_free", "Free sections take over the velocity of the tracked ones.", beside,
               wanted=140)  # fmt: skip
    closed = [dict(p) for p in beside]
    yield path("tracked_beside_free_closed", "The same, closed, with unequal speed curves.",
               [
                   dict(p, tcb=(0.1 * k, -0.1 * k, 0.05 * k),
                        orientations=[dict(p["orientations"][0], speeds=curves[k % 5])])
                   for k, p in enumerate(closed)
               ], closed=True, wanted=120)  # fmt: skip
    yield path(
        "tracked_at_ends", "A tracked section between two free end sections, tension 1 where they meet.",
        [
            point(CORNERS[0], view((0.5, 0.1, -1), tcb=(0.2, 0, 0))),
            point(CORNERS[1], view(at=eye), tcb=(1, 0, 0)),
            point(CORNERS[2], view(at=eye, roll=30), tcb=(1, 0, 0)),
            point(CORNERS[3], view((0.1, 0.2, -1), tcb=(-0.4, 0, 0))),
        ],
    )  # fmt: skip
    yield path(
        "tracked_between", "One free section between two targets, and a tracked one beside a kept one.",
        [
            point(CORNERS[0], view(at=eye)),
            point(CORNERS[1], view(at=eye, roll=-5)),
            point(CORNERS[2], view(at=(0.5, 0.5, 0.6), roll=8)),
            point(CORNERS[3], view(at=(0.5, 0.5, 0.6)), view((0.1, 0, 1)), view((0.1, 0, 1), zoom=50)),
            point(CORNERS[4], view((0.2, 0, 2), zoom=50), view((0, -1, 0.5))),
        ],
        wanted=130,
    )  # fmt: skip
    yield path(
        "kept_beside_free", "Sections that keep their direction; the neighbours come to rest there.",
        [
            point(CORNERS[0], view((0.4, 0.1, -1), roll=5, tcb=(0.2, 0.3, 0.4))),
            point(CORNERS[1], view((1, 0.2, -0.3), roll=12, tcb=(0.5, 0.5, 0.5))),
            point(CORNERS[2], view((2, 0.4, -0.6), roll=12, zoom=60)),
            point(CORNERS[3], view((-0.5, 0.5, 0.5))),
            point(CORNERS[4], view((-0.5, 0.2, 0.9)), view((-0.5, 0.2, 0.9), zoom=40), view((0, 0.2, 0.9))),
        ],
        wanted=120,
    )  # fmt: skip
    yield path(
        "ups_by_z", "Tracked, kept and free sections whose ups are the z axis, and one to the y axis.",
        [
            point(CORNERS[0], view((0.4, 0.1, -1), roll=5), view((0.4, 0.1, -1), roll=5, up="z")),
            point(CORNERS[1], view(at=eye, roll=12, up="z")),
            point(CORNERS[2], view(at=eye, roll=70, zoom=60, up="z")),
            point(CORNERS[3], view(at=eye, roll=-20, up="z"), view((-0.5, 0.5, 0.5), roll=20, up="z")),
            point(CORNERS[4], view((-1, 1, 1), roll=20, up="z"), view((0, 0.2, 0.9), up="y")),
        ],
        wanted=120,
    )  # fmt: skip
    yield path(
        "tracked_over_z", "Straight past a target along z, which is up: the yaw holds there.",
        [
            point((-1, 0.5, 1), view(at=(0, 0.5, 0), up="z")),
            point((1, 0.5, 1), view(at=(0, 0.5, 0), roll=20, up="z")),
        ],
        wanted=90,
    )  # fmt: skip
    for mode in ("barry-goldman", "slerp"):
        tag = mode.replace("-", "_")
        yield path(f"{tag}", f"{mode} through unequal times.", fast, mode=mode)
        yield path(f"{tag}_closed", f"{mode}, closed, with signs that change at the seam.",
                   wander(77, 5, 0.3), closed=True, mode=mode, wanted=80)  # fmt: skip
        yield path(f"{tag}_tracked", f"{mode} beside tracked and kept sections.",
                   beside + [point((-0.8, 0.6, 1), view((0.8, 0.4, -1.8), roll=20))], mode=mode)  # fmt: skip
    yield path("barry_goldman_two", "Barry and Goldman with two keys.", tour()[:2], mode="barry-goldman", wanted=40)

    loop = [
        point((-1, 0, 0), view(LOOKS[0])),
        point((0, 0.2, 0), view(LOOKS[1])),
        point((0, 0.2, 0), view(LOOKS[2], zoom=40)),
        point((1, 0, 0.3), view(LOOKS[3])),
    ]
    yield path("coincident_loop", "Two points at one place with a loop between them.", loop, wanted=110)
    yield path(
        "coincident_still", "Two points at one place, tension 1: no way between them, a pan.",
        [dict(p, tcb=(1, 0, 0)) for p in loop], wanted=110,
    )  # fmt: skip
    yield path(
        "coincident_merged", "Two points at one place, no way and no turn between them: one key.",
        [dict(loop[0]), dict(loop[1], tcb=(1, 0, 0)),
         dict(loop[2], tcb=(1, 0, 0), orientations=[view(LOOKS[1], speeds=EASE_IN, hold=2)]), dict(loop[3])],
        wanted=80,
    )  # fmt: skip
    yield path(
        "runs_back", "Straight lines that run back: collinear points, bias and continuity.",
        [
            point((0, 0, 0), view(LOOKS[0])),
            point((1, 0.5, 0), view(LOOKS[1]), tcb=(-1, 1, 0)),
            point((1.2, 0.6, 0), view(LOOKS[2]), tcb=(-1, 1, 0.5)),
            point((0.4, 0.2, 0), view(LOOKS[3]), tcb=(-0.5, 0.5, 1)),
            point((2, 1, 0), view(LOOKS[4]), tcb=(-1, 0, 0)),
        ],
        wanted=140,
    )  # fmt: skip
    yield path(
        "cusp", "A cusp in the middle of the second segment: the derivative is exactly zero there.",
        [
            point((-0.625, -0.75, 0), view(LOOKS[0])),
            point((0, 0, 0), view(LOOKS[1])),
            point((0.125, 0, 0), view(LOOKS[2])),
            point((0.75, -0.75, 0), view(LOOKS[3])),
        ],
    )  # fmt: skip
    yield path(
        "tiny_and_huge", "Segments of 1e-6 and of 1e6 in one path.",
        [
            point((0, 0, 0), view(LOOKS[0])),
            point((1e-6, 5e-7, 0), view(LOOKS[1]), tcb=(1, 0, 0)),
            point((2e-6, 0, 1e-6), view(LOOKS[2]), tcb=(0, -1, 0)),
            point((1e6, 2e5, -3e5), view(LOOKS[3]), tcb=(0, -1, 0)),
            point((1e6, 4e5, 5e5), view(LOOKS[4])),
        ],
        speeds=(2e-5, 100, 100, 100), wanted=90,
    )  # fmt: skip
    yield path("zoom_linear", "Zoom in straight lines.", fast, zoom="linear")
    yield path(
        "zoom_smooth", "Zoom that rises, stays, falls, turns, over unequal times.",
        [
            point((x, 0, 0), view(zoom=z, speeds=c))
            for x, z, c in (
                (0, 10, FLAT), (0.3, 20, EASE_IN), (1.3, 90, FLAT), (1.5, 90, EASE_OUT), (1.7, 30, FLAT),
                (2.7, 100, FLAT), (2.8, 1, FLAT), (3.5, 5, FLAT),
            )
        ],
        wanted=160,
    )  # fmt: skip
    # Long lenses and own slopes: kept, cut above, cut below, at the ends and the seam.
    for closed in (False, True):
        yield path(
            "zoom_long_closed" if closed else "zoom_long",
            "Zooms up to 2000 mm, with slopes of their own.",
            [
                point((x, 0, 0.3 * x * x), *(view(zoom=z, slope=m, speeds=c, hold=h) for z, m in views))
                for x, c, h, views in (
                    (0, FLAT, 0, [(24, 2.5)]), (0.3, EASE_IN, 0, [(90, 3)]), (0.9, FLAT, 4, [(135, None), (1900, 12)]),
                    (1.2, EASE_OUT, 0, [(2000, None)]), (1.9, FLAT, 0, [(300, -40)]), (2.6, FLAT, 0, [(1, -3)]),
                    (3.1, FLAT, 0, [(600, 1e6)]),
                )
            ],
            closed=closed,
        )  # fmt: skip
    # Steep, shallow, shallow, steep: slopes that two intervals limit.
    steps = [(0, 10, 0), (0.5, 13, 5), (1.1, 70, 95), (1.6, 71, 97), (2, 72.5, 100), (2.5, 98, 175), (3, 99.5, 178)]
    for closed in (False, True):
        yield path(
            "monotone_closed" if closed else "monotone",
            "Steep and shallow steps of the zoom and of a tracked roll.",
            [
                point((x, 0, 0.2 * (x - 1.5) ** 2), view(at=(1, 2, 3), zoom=z, roll=r))
                for x, z, r in steps
            ],
            closed=closed,
        )  # fmt: skip
    for k in range(4):
        yield path(
            f"random_{k}", "Everything at random.",
            wander(100 + k, 6 + k, 1.0, 1.0, extra=0.3, targets=0.3, speeds=True),
            closed=k % 2 == 1, speeds=(60, 70, 80, 90), wanted=110,
        )  # fmt: skip
