#!/usr/bin/python3
"""Writes indenter_friction.csv: steady friction of indenters on half-spaces, to 20 digits, or 13.

It shares nothing with the program. Lengths are in units of the mean indentation, forces of E*(0) dx, time
of 1/omega: the surface under x is pressed in by u(t) = z + D cos t, z = 1 - g(x), and carries f >= 0; along
the surface it carries q, |q| <= f in units of mu0. The drive moves at w D, w = v/v*, v* = mu0 omega
du_z/ratio, where q is measured by the same modulus as f.

Elastic: f = max(0, u), and in stick q grows at the rate w D. In slip q = f, until f grows as fast as q would
in stick, sin t = -w. So stick begins at t1 = -pi + asin w, or where the surfaces meet, at -T with
cos T = -z/D, if that is later and f grows fast enough there; not at all if sin T <= w for a touch shorter
than half a period. It ends where q meets f. Friction is f less what f exceeds q by in stick.

Zener, a spring 1 with one Maxwell branch (k, rate b): touching, f = u + branch, both in closed form; apart, the
deformation creeps back at the rate b' = b/(1 + k) until u meets it. A contact that slips or is apart has
deformed along the surface by as much as in depth, but for a part d that decays at the rate b', as both
obey one equation; in stick the branch relaxes in closed form. Here all cells open. Cycles are marched until
they repeat.

Over x they are integrated by mpmath's tanh-sinh between the points where the kind of cycle changes, at two
degrees; elastic ones in z, whose Jacobian is a power at the centre.

Columns: shape; exponent n of f = A r^n, 0 for a flat punch; network "k_inf c k:tau"; D = du_z/u_z0; w;
friction_ratio; normal_force: <F_n> in units of 2 E*(0) u_z0 a, a half the width of contact under u_z0.
Needs mpmath.
"""

import csv
from pathlib import Path

from mpmath import acos, asin, cos, exp, mp, mpc, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 30

SPEEDS = [".01", ".1", ".25", ".5", ".75", ".9"]
ELASTIC = [
    ("parabola", "2", "0.5"),
    ("parabola", "2", "2"),
    ("parabola", "2", "0.05"),
    ("cone", "1", "0.5"),
    ("power", "3", "1.5"),
    ("flat", "0", "1"),
    ("flat", "0", "4"),
]
ZENER = [("1", "0.3"), ("3", "0.8")]  # D, w of a parabola on 1 + a Maxwell branch 2:1


def zero(function, low, high):
    """Of a function that changes sign, by the Illinois method."""
    a, b, fa, fb = low, high, function(low), function(high)
    for _ in range(200):
        if fb == fa:
            return b
        c = b - fb * (b - a) / (fb - fa)
        fc = function(c)
        if abs(fc) < mpf(10) ** -(mp.dps - 1) or abs(b - a) < mpf(10) ** -(mp.dps - 2):
            return c
        if fc * fb < 0:
            a, fa = b, fb
        else:
            fa /= 2
        b, fb = c, fc
    raise RuntimeError("no zero found")


def elastic_means(z, depth, w):
    """<q> and <f> under the indentation z + depth cos t, z > -depth."""
    def area(a, b):  # of f
        return z * (b - a) + depth * (sin(b) - sin(a))

    touch = acos(-z / depth) if z < depth else None
    total = 2 * pi * z if touch is None else 2 * area(mpf(0), touch)
    begin = -pi + asin(w)
    if touch is not None and -touch > begin:
        begin = -touch
        if sin(touch) <= w:
            return total / (2 * pi), total / (2 * pi)
        f = mpf(0)
    else:
        f = z + depth * cos(begin)
    # f - q is greatest where f' = w D again, and has one zero from there on.
    last = begin + 2 * pi if touch is None else touch
    end = zero(lambda t: z + depth * cos(t) - f - w * depth * (t - begin), -asin(w), last)
    lost = area(begin, end) - (f * (end - begin) + w * depth * (end - begin) ** 2 / 2)
    return (total - lost) / (2 * pi), total / (2 * pi)


def elastic(n, depth, w, degree):
    """<q> and <f> integrated over x in [0, edge], in units of a; g = (x/a)^n."""
    if n == 0:
        return elastic_means(mpf(1), depth, w)
    kink = depth * sqrt(1 - w * w)
    breaks = sorted({z for z in (-depth, -kink, mpf(0), kink, depth, mpf(1)) if -depth <= z <= 1})
    sums = [mpf(0), mpf(0)]
    for low, high in zip(breaks, breaks[1:]):
        for i in range(2):
            if high == 1 and n > 1:  # the Jacobian's pole, taken out by 1 - z = s^n
                top = (1 - low) ** (1 / n)
                sums[i] += quad(lambda s: elastic_means(1 - s**n, depth, w)[i], [0, top], maxdegree=degree)
            else:
                sums[i] += quad(lambda z: elastic_means(z, depth, w)[i] * (1 - z) ** (1 / n - 1) / n,
                                [low, high], maxdegree=degree)
    return sums


def first_change(function, low, high, steps=48):
    """Where a function > 0 behind `low` first becomes negative; None if it does not."""
    before = low
    for i in range(1, steps + 1):
        t = low + (high - low) * i / steps
        if function(t) < 0:
            return zero(function, before, t) if i > 1 else small_change(function, low, t)
        before = t
    return None


def small_change(function, low, high):
    """The same in the first step, where the function may begin at 0."""
    t = high
    while function(t) < 0:
        t = low + (t - low) / 4
        if t - low < mpf(10) ** -15:
            return low
    return zero(function, t, high)


class ZenerCell:
    """One x: the normal cycle, then friction."""

    def __init__(self, z, depth, k, b):
        self.z, self.depth, self.k, self.b = z, depth, k, b
        self.slow = b / (1 + k)
        self.swing = k * depth * mpc(0, 1) / mpc(b, 1)  # of the branch's force
        met = -acos(-z / depth) if z < depth else -pi
        for _ in range(200):
            self.touch(met)
            before, met = met, self.next_met() - 2 * pi
            if abs(met - before) < mpf(10) ** -(mp.dps - 6):
                return
        raise RuntimeError("no normal cycle")

    def u(self, t):
        return self.z + self.depth * cos(t)

    def touch(self, met):
        self.met = met
        self.decay = -self.u(met) - (self.swing * exp(mpc(0, 1) * met)).real
        self.parted = first_change(self.f, met, met + 2 * pi)
        if self.parted is None:
            raise RuntimeError("a cell that never opens")

    def f(self, t):
        return self.u(t) + (self.swing * exp(mpc(0, 1) * t)).real + self.decay * exp(-self.b * (t - self.met))

    def area(self, a, c):
        """Of f."""
        turned = self.swing * (exp(mpc(0, 1) * c) - exp(mpc(0, 1) * a)) / mpc(0, 1)
        decayed = self.decay / self.b * (exp(-self.b * (a - self.met)) - exp(-self.b * (c - self.met)))
        return self.z * (c - a) + self.depth * (sin(c) - sin(a)) + turned.real + decayed

    def next_met(self):
        left = self.u(self.parted)
        gap = lambda t: left * exp(-self.slow * (t - self.parted)) - self.u(t)
        return first_change(gap, self.parted, 2 * pi)  # while u rises to its maximum

    def period(self, d, v):
        """One touch from d where they meet on: d at the next, what f exceeds q by, the motions."""
        t, lost, motions = self.met, mpf(0), ""
        while True:
            speed = lambda s: v + self.depth * sin(s) + self.slow * d * exp(-self.slow * (s - t))
            stop = t if speed(t) <= 0 else first_change(speed, t, self.parted)
            motions += "" if stop == t else "s"
            if stop is None:
                return d * exp(-self.slow * (self.met + 2 * pi - t)), lost, motions
            motions += "h"
            d *= exp(-self.slow * (stop - t))
            deformed = self.u(stop) + d
            steady = self.k * v / self.b
            over = self.f(stop) - deformed - steady  # what decays of the branch's force
            q = lambda s: deformed + v * (s - stop) + steady + over * exp(-self.b * (s - stop))
            t = first_change(lambda s: self.f(s) - q(s), stop, self.parted)
            if any(q(stop + (t - stop) * i / 8) < -self.f(stop + (t - stop) * i / 8) for i in range(8)):
                raise RuntimeError("slips back")
            held = t - stop
            lost += self.area(stop, t) - (deformed * held + v * held**2 / 2 + steady * held
                                          + over * (1 - exp(-self.b * held)) / self.b)
            d = deformed + v * held - self.u(t)

    def means(self, v):
        d = mpf(0)
        for _ in range(200):
            before = d
            d, lost, motions = self.period(d, v)
            if abs(d - before) < mpf(10) ** -(mp.dps - 7):
                total = self.area(self.met, self.parted)
                return (total - lost) / (2 * pi), total / (2 * pi), motions
        raise RuntimeError("no steady state")


def zener(depth, w, degree):
    """As elastic(), of a parabola."""
    def cell(x):
        z = 1 - x * x
        if z + depth < mpf(10) ** -10:  # no more than 1e-25 of the integrals
            return mpf(0), mpf(0), "s"
        return ZenerCell(z, depth, mpf(2), mpf(1)).means(w * depth)

    edge = sqrt(1 + depth)
    places = [edge * (1 - (mpf(i) / 40) ** 3) for i in range(40, 1, -1)]  # denser to the edge
    kinds = [cell(x)[2] for x in places]
    breaks = [mpf(0)]
    for a, b, kind, other in zip(places, places[1:], kinds, kinds[1:]):
        while kind != other and b - a > mpf(10) ** -12:
            middle = (a + b) / 2
            a, b = (middle, b) if cell(middle)[2] == kind else (a, middle)
        breaks += [(a + b) / 2] if kind != other else []
    sums = [mpf(0), mpf(0)]
    for low, high in zip(breaks, breaks[1:] + [edge]):
        known = {}
        def mean(x, i):
            if x not in known:
                known[x] = cell(x)
            return known[x][i]
        for i in range(2):
            sums[i] += quad(lambda x: mean(x, i), [low, high], maxdegree=degree)
    return sums


def checked(name, function, degrees, tolerance):
    (q, f), (fine_q, fine_f) = (function(degree) for degree in degrees)
    difference = abs(q / f - fine_q / fine_f)
    print(*name, nstr(fine_q / fine_f, 20), nstr(fine_f, 20), nstr(difference, 2), flush=True)
    if difference > tolerance:
        raise RuntimeError("the integrals have not converged")
    return fine_q / fine_f, fine_f


def main():
    with open(Path(__file__).with_suffix(".csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow("shape exponent network D w friction_ratio normal_force".split())
        for shape, n, depth in ELASTIC:
            for w in SPEEDS:
                name = [shape, n, "1 0", depth, w]
                values = checked(name, lambda degree: elastic(mpf(n), mpf(depth), mpf(w), degree), (6, 7),
                                 mpf(10) ** -20)
                table.writerow([*name, *(nstr(value, 20) for value in values)])
        mp.dps = 24
        for depth, w in ZENER:
            name = ["parabola", "2", "1 0 2:1", depth, w]
            values = checked(name, lambda degree: zener(mpf(depth), mpf(w), degree), (5, 6), mpf(10) ** -14)
            table.writerow([*name, *(nstr(value, 14) for value in values)])


main()
