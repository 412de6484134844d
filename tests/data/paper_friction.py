#!/usr/bin/env python3
"""Writes paper_friction.csv: steady friction of a Kelvin contact under a rigid drive, to 25 digits.

It shares nothing with the program. With k = omega = mu0 <F_n> = 1, delta = c, F_n amplitude a = 0.9,
D = a/sqrt(1 + delta^2), the friction bound is b(t) = 1 + D cos t - delta D sin t and the drive runs
at u = ratio D, since v* = D. The contact's force is F = e + delta e'. Stick from t1 to t2 with
e' = u, then slip with F = b, of which e = 1 + D cos t + C exp(-(t - t2)/delta) is the motion. F is
continuous at both ends of stick, and so is e:

  b(t2) - b(t1) = u (t2 - t1),                                          the force through stick
  u + D sin t1 = (u + D sin t2) exp(-(t1 + 2 pi - t2)/delta)            the velocity where slip ends

The two equations are solved by Newton's method in 40 digits from a scan in doubles; that nothing
happens in between (slip goes forward, the force stays below the bound in stick) is checked on a
fine grid. Rows that tests/data/stickslip_reference.csv has, too, must agree with it.

Columns: delta, velocity_ratio, friction_ratio.
Needs mpmath; run it as  tests/data/paper_friction.py > tests/data/paper_friction.csv
"""

import csv
import math
import sys
from pathlib import Path

from mpmath import cos, exp, findroot, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 40
AMPLITUDE = mpf(9) / 10
STEP = 2**-7


class Contact:
    def __init__(self, delta, ratio):
        self.delta = mpf(delta)
        self.d = AMPLITUDE / sqrt(1 + self.delta**2)
        self.u = mpf(ratio) * self.d

    def bound(self, t):
        return 1 + self.d * (cos(t) - self.delta * sin(t))

    def slip_velocity(self, t, t2):
        fading = exp(-(t - t2) / self.delta) * (self.u + self.d * sin(t2))
        return self.u + self.d * sin(t) - fading

    def equations(self, t1, t2):
        return [(self.bound(t2) - self.bound(t1) - self.u * (t2 - t1)) / self.d,
                self.slip_velocity(t1 + 2 * pi, t2) / self.d]

    def scan(self, positive, start):
        """The first time after start at which `positive` no longer holds."""
        t = start + STEP
        while positive(t):
            t += STEP
        low, high = t - STEP, t
        while high - low > 1e-14 * high:
            middle = (low + high) / 2
            low, high = (middle, high) if positive(middle) else (low, middle)
        return high

    def events(self):
        """t1 and t2: some periods from event to event in doubles, then Newton's method."""
        d, delta, u = float(self.d), float(self.delta), float(self.u)
        bound = lambda t: d * (math.cos(t) - delta * math.sin(t))
        velocity = lambda t: u + d * math.sin(t) - (u + d * math.sin(t2)) * math.exp(-(t - t2) / delta)
        t2 = math.pi - math.atan(delta) - 0.05  # shortly before the bound is least
        for _ in range(40 + 8 * int(delta)):
            t1 = self.scan(lambda t: velocity(t) > 0, t2)
            t2 = self.scan(lambda t: bound(t) > bound(t1) + u * (t - t1), t1)
        turns = math.floor(t1 / (2 * math.pi))
        found = findroot(self.equations, (t1 - 2 * pi * turns, t2 - 2 * pi * turns))
        self.check(*found)
        return found

    def check(self, t1, t2):
        for i in range(1, 400):
            t = t1 + (t2 - t1) * i / 400
            assert self.bound(t) > self.bound(t1) + self.u * (t - t1), "sticks"
            t = t2 + (t1 + 2 * pi - t2) * i / 400
            assert self.slip_velocity(t, t2) > 0, "slips forward"

    def friction(self):
        t1, t2 = self.events()
        deficit = quad(lambda t: self.bound(t) - self.bound(t1) - self.u * (t - t1), [t1, (t1 + t2) / 2, t2])
        return 1 - deficit / (2 * pi)


def known():
    file = Path(__file__).with_name("stickslip_reference.csv")
    rows = csv.DictReader(file.read_text().splitlines())
    return {(row["c"], row["velocity_ratio"]): mpf(row["friction_ratio"]) for row in rows if row["problem"] == "P1"}


def main():
    references = known()
    print("delta,velocity_ratio,friction_ratio")
    for delta in ["1", "2", "10", "100"]:
        for ratio in ["0.1", "0.3", "0.5", "0.7", "0.9", "0.99"]:
            friction = Contact(delta, ratio).friction()
            reference = references.get((delta, ratio))
            if reference is not None and abs(friction - reference) > mpf(10) ** -21:
                sys.exit(f"delta {delta}, ratio {ratio}: {friction} against {reference}")
            print(f"{delta},{ratio},{nstr(friction, 25, strip_zeros=False)}")


if __name__ == "__main__":
    main()
