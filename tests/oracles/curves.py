"""Reference values for the curves, from libraries that know nothing of this one.

    pip install numpy==2.4.6 scipy==1.17.1 splines==0.3.3
    python3 tests/oracles/curves.py > tests/oracles/curves.toml

Every number is printed with the digits that give it back to the last bit.
"""

import numpy as np
import scipy
import splines
from scipy.interpolate import BPoly, CubicSpline, KroghInterpolator

RANDOM = np.random.default_rng(1984)


def toml(value):
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return "[" + ", ".join(toml(element) for element in value) + "]"


def case(kind, **fields):
    print(f"\n[[{kind}]]")
    for name, value in fields.items():
        print(f"{name} = {toml(value)}")


def points(count, size=1.0):
    return RANDOM.uniform(-size, size, (count, 3))


def places(first, last, count=12):
    """Both ends and places between, none of them on a knot but by chance."""
    return np.concatenate(([first], np.sort(RANDOM.uniform(first, last, count)), [last]))


def parabola_slopes(p):
    """Slopes at the ends of the parabolas through the three outermost points."""
    at = np.arange(3.0)
    return (
        KroghInterpolator(at, p[:3]).derivative(0.0),
        KroghInterpolator(at, p[-3:]).derivative(2.0),
    )


def tuples(slopes):
    """`splines` compares what it gets with words, which arrays do not bear."""
    return tuple(tuple(slope) for slope in slopes)


def catmull_rom(p, ends, given):
    given = given if isinstance(given, str) else tuples(given)
    curve = splines.CatmullRom(p, endconditions=given)
    t = places(0.0, float(curve.grid[-1]))
    slopes = given if ends == "tangents" else ()
    case("catmull_rom", ends=ends, points=p, slopes=slopes, t=t,
         point=[curve.evaluate(x) for x in t])


def kochanek_bartels(p, tcb, closed):
    if closed:
        curve = splines.KochanekBartels(p, tcb=tcb, endconditions="closed")
    else:
        start, end = parabola_slopes(p)
        given = tuples(((1 - tcb[0][0]) * start, (1 - tcb[-1][0]) * end))
        curve = splines.KochanekBartels(p, tcb=tcb[1:-1], endconditions=given)
    t = places(0.0, float(curve.grid[-1]))
    case("kochanek_bartels", closed=closed, points=p, tcb=tcb, t=t,
         point=[curve.evaluate(x) for x in t])


def cubic_spline(p, knots, ends):
    slopes = points(2, 3.0) if ends == "clamped" else ()
    boundary = ((1, slopes[0]), (1, slopes[1])) if ends == "clamped" else ends
    curve = CubicSpline(knots, p, bc_type=boundary)
    x = places(knots[0], knots[-1])
    case("cubic_spline", ends=ends, points=p, knots=knots, slopes=slopes, x=x,
         point=curve(x), first=curve(x, 1), second=curve(x, 2))


def bezier(p):
    curve = BPoly(p[:, np.newaxis, :], [0.0, 1.0])
    t = places(0.0, 1.0)
    case("bezier", points=p, t=t, point=curve(t), derivative=curve(t, 1))


print("# Made by curves.py beside this file; not to be edited.")
print("# numpy", np.__version__, "scipy", scipy.__version__,
      "splines", splines.__version__)

for count in (3, 4, 7):
    p = points(count)
    catmull_rom(p, "natural", "natural")
    catmull_rom(p, "quadratic", parabola_slopes(p))
    catmull_rom(p, "tangents", points(2, 2.0))
    catmull_rom(p, "closed", "closed")
p = points(5)
p[2] = p[1]
catmull_rom(p, "quadratic", parabola_slopes(p))

for count in (3, 4, 8):
    for closed in (False, True):
        kochanek_bartels(points(count), RANDOM.uniform(-1, 1, (count, 3)), closed)
for corner in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1), (-1, 1, 1)):
    kochanek_bartels(points(5, 1e6), np.tile(np.float64(corner), (5, 1)), False)
p = points(6)
p[3] = p[2]
kochanek_bartels(p, RANDOM.uniform(-1, 1, (6, 3)), True)

for count in (2, 3, 4, 5, 12):
    for ends in ("natural", "clamped", "periodic"):
        p = points(count)
        if ends == "periodic":
            p[-1] = p[0]
        knots = np.cumsum(RANDOM.uniform(0.2, 2.0, count)) - 3.0
        cubic_spline(p, knots, ends)
for ends in ("natural", "clamped", "periodic"):
    p = points(9)
    p[-1] = p[0]
    cubic_spline(p, np.cumsum(10.0 ** RANDOM.uniform(-2, 2, 9)), ends)

for count in (1, 2, 4, 5, 11, 24):
    bezier(points(count))
