#!/usr/bin/python3
"""Writes held_memory.csv: v* of indenters on viscoelastic half-spaces and drives that give.

All touching cells slide with one velocity v0 + dq/dt - (mu0/kappa) du_z/dt, q the body's way under mu0 F_n(t). Cells of
E0 | (E1 - E1 tau), or E0 | c, are followed in closed form. One that opens is given by the phase b at which it touches: where
it lifts off and how deep it lies is the root of one equation. So F_n and F_n' are integrals over b, or over the phase e of
lifting off, up to the cell that touches or lifts off now. Nothing is shared with the program: no interpolation, no steps
of time. omega = 1, nu = 0.3, mu0 = 0.3; radius or slope of the gap 1. Good to 1e-10, with harmonics above 120 left out.
"""

import cmath
import csv
import math
from pathlib import Path

import numpy as np

NU, MU = 0.3, 0.3
SHEAR = 2 * (1 - NU) / (2 - NU)
NODES = 60  # of Gauss's rule, on integrands that are analytic in their variable
HARMONICS, PHASES = 120, 400  # of a force whose coefficients fall like n^-5; phases of each arc

# id, material, E1/E0 or 0, tau or c/E0, shape, amplitude, indentation, kd, cd, m; E0 = 0.91, so that E* = 1.
ROWS = [
    ("Z1", "zener", "0.5", "1", "parabola", "0.5", "1", "2", "0", "0"),
    ("Z2", "zener", "2", "0.3", "parabola", "0.3", "1", "1.2", "0", "0"),
    ("Z3", "zener", "1", "4", "cone", "0.4", "1", "3", "0", "0"),
    ("Z4", "zener", "0.7", "0.8", "parabola", "1.3", "1", "2.5", "0", "0"),
    ("Z5", "zener", "0.5", "1", "parabola", "0.5", "1", "2", "0.5", "0.4"),
    ("Z6", "zener", "3", "0.5", "cone", "0.2", "1", "1.5", "0.3", "0.2"),
    ("Z7", "zener", "0.7", "0.8", "parabola", "1.3", "1", "2", "0.2", "0.3"),
    ("K1", "kelvin", "0", "0.5", "parabola", "0.4", "1", "2", "0", "0"),
    ("K2", "kelvin", "0", "1.5", "cone", "0.3", "1", "4", "0", "0"),
    ("K3", "kelvin", "0", "0.8", "parabola", "0.4", "1", "2", "0.4", "0.5"),
]


def gauss(count):
    """Nodes and weights on [0, 1]."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return [((float(x) + 1) / 2, float(w) / 2) for x, w in zip(nodes, weights)]


RULE = gauss(NODES)


class HalfSpace:
    """E* = 1 at rest; depths d = u_z0 - g(x)."""

    def __init__(self, row, shear=SHEAR):
        self.shear = shear
        self.id, self.material, share, time, self.shape, *rest = row
        self.share, self.time = float(share), float(time)
        self.swing, self.mean, self.kd, self.cd, self.m = map(float, rest)
        s = 1j
        zener = self.material == "zener"
        self.dynamic = 1 + (self.share * s * self.time / (1 + s * self.time) if zener else s * self.time)
        # Of the surface where it is free.
        self.recovery = 1 / ((1 + self.share) * self.time) if zener else 1 / self.time
        self.least = math.pi - cmath.phase(self.dynamic)  # where a cell carries least that never opens
        inside = self.mean - self.swing * abs(self.dynamic)
        self.closed = self.place(self.swing * abs(self.dynamic)) if inside > 0 else 0.0
        self.first, self.last = self.least - 2 * math.pi, self.least
        if inside <= 0:  # of the centre
            low, high = self.first, 0.0  # cells are the deeper the earlier they touch
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if self.lifted(middle)[1] > self.mean else (low, middle)
            self.first = high
            self.last = self.lifted(self.first)[0]

    def place(self, depth):
        return math.sqrt(max(self.mean - depth, 0)) if self.shape == "parabola" else self.mean - depth

    def area(self, x):
        return x**3 / 3 if self.shape == "parabola" else x**2 / 2

    def force(self, d, b, t):
        """Of a cell that touched at b, and its rate."""
        turn = self.swing * self.dynamic * cmath.exp(1j * t)
        if self.material == "kelvin":
            return d + turn.real, -turn.imag
        before = self.swing * (self.dynamic - 1) * cmath.exp(1j * b)
        left = (-(d + self.swing * math.cos(b)) - before.real) * math.exp(-(t - b) / self.time)
        return d + turn.real + left, -turn.imag - left / self.time

    def depth(self, b, e):
        """At which the free surface meets the indenter at b again."""
        left = math.exp(-self.recovery * (2 * math.pi + b - e))
        return self.swing * (left * math.cos(e) - math.cos(b)) / (1 - left)

    def root(self, function, high):
        """The one in (0, high), by halving and then regula falsi, the end that stays halved (Illinois)."""
        low, high = high * 1e-12, high * (1 - 1e-12)
        at_low, at_high = function(low), function(high)
        for i in range(80):
            middle = (low + high) / 2 if i < 12 else high - at_high * (high - low) / (at_high - at_low)
            at = function(middle)
            if at == 0 or abs(high - low) < 4e-16 * abs(high):
                return middle
            if (at > 0) == (at_high > 0):
                high, at_high, at_low = middle, at, at_low / (2 if i > 12 else 1)
            else:
                low, at_low, at_high = middle, at, at_high / (2 if i > 12 else 1)
            if at_low == 0 or at_high == 0:
                return middle
        return middle

    def lifted(self, b):
        """e and d of the cell that touches at b."""
        e = self.root(lambda each: self.force(self.depth(b, each), b, each)[0], self.least)
        return e, self.depth(b, e)

    def touched(self, e):
        """b and d of the cell that lifts off at e."""
        b = self.root(lambda each: self.force(self.depth(each, e), each, e)[0], self.least - 2 * math.pi)
        return b, self.depth(b, e)

    def slope(self, b, e, rising):
        """Of the depth over b, or over e, along cells that do open: their force is 0 at e."""
        h = 1e-3

        def over(function):
            values = [function(i * h) for i in (-2, -1, 1, 2)]
            return (values[0] - 8 * values[1] + 8 * values[2] - values[3]) / (12 * h)

        def left(by_b, by_e):
            one, two = b + by_b, e + by_e
            return self.force(self.depth(one, two), one, two)[0]
        depths = over(lambda i: self.depth(b + i, e)), over(lambda i: self.depth(b, e + i))
        lefts = over(lambda i: left(i, 0)), over(lambda i: left(0, i))
        if rising:
            return depths[0] - depths[1] * lefts[0] / lefts[1]
        return depths[1] - depths[0] * lefts[1] / lefts[0]

    def normal_force(self, t):
        """F_n and F_n' at a phase between the first touch and the last."""
        turn = self.swing * self.dynamic * cmath.exp(1j * t)
        force = 2 * (self.mean * self.closed - self.area(self.closed) + self.closed * turn.real)
        change = -2 * self.closed * turn.imag
        rising = t < 0
        start = self.first if rising else self.last
        for s, weight in RULE:
            at = start + (t - start) * s**2
            b, e = (at, self.lifted(at)[0]) if rising else (self.touched(at)[0], at)
            d, around = self.depth(b, e), self.slope(b, e, rising)
            x = self.place(d)
            if not x > 0:  # at the tip, in rounding
                continue
            width = -around / (2 * x if self.shape == "parabola" else 1) * 2 * (t - start) * s * weight
            f, f_rate = self.force(d, b, t)
            force += 2 * f * width
            change += 2 * f_rate * width
        if rising and self.material == "kelvin":
            e, d = self.lifted(t)
            x = self.place(d)
            change -= 2 * self.force(d, t, t)[0] * self.slope(t, e, rising) / (2 * x if self.shape == "parabola" else 1)
        return force, change

    def rise(self):
        """As a function of the phase: du_z/dt/kappa and the body's velocity."""
        if self.m == 0 and self.cd == 0:
            return lambda t: -self.swing * math.sin(t) / self.shear + self.normal_force(t)[1] / self.kd
        samples = []
        for low, high in ((self.first, 0.0), (0.0, self.last)):
            for s, weight in gauss(PHASES):
                t, jacobian = low + (high - low) * s**2 * (3 - 2 * s), (high - low) * 6 * s * (1 - s)
                samples.append((t, weight * jacobian * self.normal_force(t)[0]))
        swings = []
        for n in range(1, HARMONICS):
            s = 1j * n
            harmonic = sum(w * cmath.exp(-1j * n * t) for t, w in samples) / math.pi
            swings.append(s * harmonic / (self.kd + self.cd * s + self.m * s * s))
        return lambda t: (-self.swing * math.sin(t) / self.shear
                          + math.fsum((a * cmath.exp(1j * (n + 1) * t)).real for n, a in enumerate(swings)))

    def largest(self, phase=None):
        """Of the rise, and its phase: the polynomial through seven places around it, twice, unless it is known well."""
        rise = self.rise()
        for step in (0.06, 0.02) if phase is None else (0.02,):
            phase = self.steepest(rise) if phase is None else phase
            places = [phase + i * step for i in range(-3, 4)]
            values = [rise(t) for t in places]

            def through(t):
                return math.fsum(y * math.prod((t - other) / (place - other) for other in places if other != place)
                               for place, y in zip(places, values))
            for _ in range(20):  # Newton's method for where it is flat
                h = step / 10
                phase -= h / 2 * (through(phase + h) - through(phase - h)) / (through(phase + h) - 2 * through(phase) + through(phase - h))
        return through(phase), phase

    def steepest(self, rise):
        """Of some phases. A body that follows its spring is fastest while the indentation rises, as is the indentation."""
        count = 24
        return max((self.first + (self.last - self.first) * (i + 0.5) / count for i in range(count)),
                   key=lambda t: rise(t) if t < 0 or self.m or self.cd else -math.inf)


def main():
    with (Path(__file__).parent / "held_memory.csv").open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["id", "material", "share", "time", "shape", "amplitude", "indentation", "kd", "cd", "m", "v_star"])
        for row in ROWS:
            found = MU * HalfSpace(row).largest()[0]
            writer.writerow([*row, repr(found)])
            file.flush()
            print(row[0], repr(found), flush=True)


if __name__ == "__main__":
    main()
