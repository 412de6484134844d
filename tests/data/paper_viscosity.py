#!/usr/bin/env python3
"""Checks paper_viscosity.csv and writes paper_crossings.csv: what viscosity does to the friction of a Kelvin contact.

It shares nothing with the program, and nothing with what made paper_viscosity.csv but the two equations of
paper_friction.py, whose motion it takes. Without dimensions, delta = omega c/k, v = v0/v*, D = du_z/u_z0 and
a = D sqrt(1 + delta^2), the amplitude of the normal force over its mean; mu/mu0 = 1 - D G(delta, v) whatever D.

paper_viscosity.csv: G; the same per a instead of per D; and both less their value at delta = 0, that is at equal
amplitude D and at equal a. 15 digits.

paper_crossings.csv: below v_c(delta) viscosity weakens the reduction of friction at equal a, above it strengthens it;
by how much of mu/mu0 at most, per a, and at which v. delta = 0 and inf are limits:
  delta -> 0:    G = G(0) + delta^2 (v + sin tau2)/(4 pi), so that v_c solves G(0) = (v + sin tau2)/(2 pi)
  delta -> inf:  G/sqrt(1 + delta^2) = v - p with [sqrt(1 - p^2) + p (pi/2 + asin p)]/pi = v

Needs mpmath; run it as  tests/data/paper_viscosity.py > tests/data/paper_crossings.csv
"""

import csv
import sys
from pathlib import Path

from mpmath import acos, asin, cos, findroot, inf, mp, mpf, nstr, pi, quad, sin, sqrt

import paper_friction

mp.dps = 40


def elastic(v):
    """G(0, v) and sin tau2: stick begins at pi + asin v, and ends where its force meets the bound."""
    t1 = pi + asin(v)
    bound = lambda t: cos(t) - cos(t1) - v * (t - t1)
    t = t1 + mpf(1) / 1000 * acos(v)
    while bound(t) > 0:
        t += acos(v) / 50
    t2 = findroot(bound, (t - acos(v) / 50, t), solver="anderson")
    return quad(bound, [t1, t2]) / (2 * pi), sin(t2)


def relaxed(v):
    """G/sqrt(1 + delta^2) for delta -> infinity."""
    rise = lambda p: (sqrt(1 - p**2) + p * (pi / 2 + asin(p))) / pi - v
    return v - findroot(rise, (mpf(-1), mpf(1)), solver="anderson", tol=mpf(10) ** -70)


starts = {}


def kelvin(delta, v):
    """G(delta, v), from the events of a speed nearby where these are known."""
    contact = paper_friction.Contact(delta, v)
    near = min((abs(v - other), events) for other, events in starts.get(delta, {mpf(9): None}).items())
    events = tuple(findroot(contact.equations, near[1]) if near[0] < 0.01 else contact.events())
    contact.check(*events)
    starts.setdefault(delta, {})[mpf(v)] = events
    t1, t2 = events
    lost = quad(lambda t: contact.bound(t) - contact.bound(t1) - contact.u * (t - t1), [t1, (t1 + t2) / 2, t2])
    return lost / (2 * pi * contact.d)


def difference(delta):
    """Reduction of mu/mu0 per a, less that of the elastic contact, over v."""
    if delta == inf:
        return lambda v: relaxed(v) - elastic(v)[0]
    return lambda v: kelvin(delta, v) / sqrt(1 + mpf(delta) ** 2) - elastic(v)[0]


def check_table():
    for row in csv.reader(Path(__file__).with_name("paper_viscosity.csv").read_text().splitlines()[1:]):
        delta, v = row[0], mpf(row[1])
        plain, root = elastic(v)[0], sqrt(1 + mpf(delta) ** 2)
        g = plain if delta == "0" else kelvin(delta, v)
        for text, value in zip(row[2:], [g, g / root, g - plain, g / root - plain]):
            if abs(mpf(text) - value) > mpf(10) ** -14 * max(abs(value), mpf(10) ** -3):
                sys.exit(f"delta {delta}, v {row[1]}: {text} against {nstr(value, 20)}")


def crossing(delta):
    if delta == 0:
        return findroot(lambda v: elastic(v)[0] - (v + elastic(v)[1]) / (2 * pi), (0.53, 0.54), solver="anderson")
    return findroot(difference(delta), (0.58, 0.71), solver="anderson", tol=mpf(10) ** -40)


def extreme(delta, near):
    """Where the difference does not change, and its value: by parabolas, each the better for the last."""
    f, h = difference(delta), mpf(1) / 500
    at = mpf(near)
    for _ in range(9):
        low, middle, high = f(at - h), f(at), f(at + h)
        at += h * (low - high) / (2 * (low - 2 * middle + high))
        h = max(h / 8, mpf(10) ** -9)
    return f(at), at


def main():
    check_table()
    print("delta,v_c,most_weakening,at,most_strengthening,at")
    print(f"0,{nstr(crossing(0), 20)},0,,0,")
    for delta, weak, strong in [("0.3", 0.0484, 0.7735), ("1", 0.089, 0.8104), ("2", 0.0981, 0.8265),
                                ("10", 0.1017, 0.8343), ("100", 0.1019, 0.8347), (inf, 0.1019, 0.8347)]:
        weakening, weakest = extreme(delta, weak)
        strengthening, strongest = extreme(delta, strong)
        print(f"{'inf' if delta == inf else delta},{nstr(crossing(delta), 20)},{nstr(-weakening, 15)},{nstr(weakest, 6)},"
              f"{nstr(strengthening, 15)},{nstr(strongest, 6)}")


if __name__ == "__main__":
    main()
