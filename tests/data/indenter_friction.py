#!/usr/bin/python3
"""Writes indenter_friction.csv: steady friction of indenters on an elastic half-space, to 20 digits.

It shares nothing with the program. Lengths are in units of the mean indentation, forces of E* dx, time
of 1/omega: the surface under x is pressed in by u(t) = 1 - g(x) + D cos t and carries f = max(0, u); along
the surface it carries q, |q| <= f in units of mu0, which in stick grows at the rate w D of the drive,
w = v/v*, v* = mu0 omega du_z/ratio. In forward slip q = f, until f grows as fast as q would in stick:
sin t = -w. The steady cycle of each x is a scalar problem:

* closed at all times (1 - g >= D): from t1 = -pi + arcsin... where f' = w D first holds, q = f(t1) +
  w D (t - t1) until it meets f again;
* open: q = 0 where the surfaces meet at -T, cos T = -(1 - g)/D; it slips on as long as f grows more slowly
  than q would, and sticks from -T, or from t1 on, until q meets f.

In both cases stick begins at t1 = -pi + asin w, or at -T if that is later and f grows fast enough, and not
at all if T < asin w. <q> and <f> over a period are then integrals of elementary functions. Over x they are
integrated by mpmath's tanh-sinh between the points where the kind of cycle changes, in the variable that
makes g linear (z = 1 - g, whose Jacobian is a power at the centre), and compared with twice the nodes.

Columns: shape; exponent n of f = A r^n, 0 for a flat punch; D = du_z/u_z0; w = v/v*; friction_ratio;
normal_force: <F_n> in units of 2 E* u_z0 a, a half the width of contact under u_z0.
Needs mpmath.
"""

import csv
from pathlib import Path

from mpmath import acos, asin, cos, findroot, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 30

SPEEDS = [".1", ".25", ".5", ".75", ".9"]
CASES = [
    ("parabola", "2", "0.5"),
    ("parabola", "2", "2"),
    ("parabola", "2", "0.05"),
    ("cone", "1", "0.5"),
    ("power", "3", "1.5"),
    ("flat", "0", "1"),
    ("flat", "0", "4"),
]


def zero(function, low, high):
    """Of a function that changes sign, by the Illinois method."""
    a, b, fa, fb = low, high, function(low), function(high)
    for _ in range(200):
        if fb == fa:
            return b
        c = b - fb * (b - a) / (fb - fa)
        fc = function(c)
        if fc == 0 or abs(b - a) < mpf(10) ** -(mp.dps - 2):
            return c
        if fc * fb < 0:
            a, fa = b, fb
        else:
            fa /= 2
        b, fb = c, fc
        if fc == 0 or abs(fc) < mpf(10) ** -(mp.dps - 1):
            return c
    raise RuntimeError("no zero found")


def means(z, depth, w):
    """<q> and <f> under the indentation z + depth cos t, z > -depth."""
    def area(a, b):  # of f
        return z * (b - a) + depth * (sin(b) - sin(a))

    if z >= depth:
        touch, total = None, 2 * pi * z
    else:
        touch = acos(-z / depth)
        total = 2 * area(mpf(0), touch)
    begin = -pi + asin(w)  # f grows as fast as q would in stick, f'' > 0
    if touch is not None and -touch > begin:
        begin = -touch
        if sin(touch) <= w:  # f grows more slowly from there on
            return total / (2 * pi), total / (2 * pi)
    f = z + depth * cos(begin) if touch is None or begin > -touch else mpf(0)
    q = lambda t: f + w * depth * (t - begin)
    excess = lambda t: z + depth * cos(t) - q(t)
    # The excess is greatest where f' = w again, at -asin w, and has one zero from there on.
    end = zero(excess, -asin(w), pi if touch is None else touch) if touch is not None else \
        zero(excess, -asin(w), begin + 2 * pi)
    stuck = area(begin, end) - (f * (end - begin) + w * depth * (end - begin) ** 2 / 2)
    return (total - stuck) / (2 * pi), total / (2 * pi)


def integrals(n, depth, w, degree):
    """Of <q> and <f> over x in [0, edge], in units of half the width a of contact; g = (x/a)^n."""
    if n == 0:
        return means(mpf(1), depth, w)
    kink = depth * sqrt(1 - w * w)
    # x = (1 - z)^{1/n}; at the centre z = 1
    breaks = sorted({z for z in (-depth, -kink, mpf(0), kink, depth, mpf(1)) if -depth <= z <= 1})
    numerator, denominator = mpf(0), mpf(0)
    for low, high in zip(breaks, breaks[1:]):
        weight = lambda z: (1 - z) ** (1 / n - 1) / n
        if high == 1 and n > 1:  # the Jacobian's pole, taken out by 1 - z = s^n
            top = (1 - low) ** (1 / n)
            numerator += quad(lambda s: means(1 - s**n, depth, w)[0], [0, top], maxdegree=degree)
            denominator += quad(lambda s: means(1 - s**n, depth, w)[1], [0, top], maxdegree=degree)
        else:
            numerator += quad(lambda z: means(z, depth, w)[0] * weight(z), [low, high], maxdegree=degree)
            denominator += quad(lambda z: means(z, depth, w)[1] * weight(z), [low, high], maxdegree=degree)
    return numerator, denominator


def main():
    with open(Path(__file__).with_suffix(".csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow("shape exponent D w friction_ratio normal_force".split())
        for shape, exponent, d in CASES:
            for speed in SPEEDS:
                n, depth, w = mpf(exponent), mpf(d), mpf(speed)
                coarse = integrals(n, depth, w, 6)
                fine = integrals(n, depth, w, 7)
                ratios = [q / f for q, f in (coarse, fine)]
                if abs(ratios[1] - ratios[0]) > mpf(10) ** -20:
                    raise RuntimeError(f"{shape} {d} {speed}: {nstr(ratios[1] - ratios[0])}")
                print(shape, d, speed, nstr(ratios[1], 20), nstr(fine[1], 20),
                      nstr(ratios[1] - ratios[0], 2), flush=True)
                table.writerow([shape, exponent, d, speed, nstr(ratios[1], 20), nstr(fine[1], 20)])


main()
