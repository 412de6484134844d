#!/usr/bin/python3
"""Writes stickslip_reference.csv: steady stick-slip friction under an oscillating normal force, to 22 digits.

It shares nothing with the program. omega = 1, F_n = 1 + a cos t. The contact, between contact point and body, is
a spring k0 with a damper c (rigid drive alone) or a Maxwell branch (k1, tau); the body has mass m, and its drive,
k_d beside c_d, is pulled at v. Without a drive (k_d = inf) the body moves at v. With w the contact's elongation,
f the branch's force, e the drive's elongation and V the body's velocity:

  slip     k0 w + c w' + f = mu0 F_n,  until the contact point's velocity V - w' falls to 0
  stick    w' = V,                     until k0 w + c w' + f reaches mu0 F_n
  always   f' = k1 w' - f/tau,  e' = v - V,  m V' = k_d e + c_d (v - V) - (k0 w + f)

Each is linear and solved by eigenvectors beside a particular solution, at 50 digits; in stick e + w grows at
the rate v. Events are zeros between the points of a grid, found by bracketing. From sliding the motion is marched
some periods; then Newton's method closes the cycle, from a time of slip to the same time one period later (the
longest relaxation time is 1e6 periods). The friction of the cycle is integrated in closed form.

v_star = mu0 a |1/K + 1/(k_d + i c_d - m)|, K the contact's stiffness at omega = 1. events_per_cycle are the
changes between stick and slip. Needs mpmath and takes two minutes.
"""

import csv
from pathlib import Path

from mpmath import (cos, diag, eig, exp, findroot, floor, inverse, lu_solve, matrix, mp, mpc, mpf, nstr, pi,
                    sin, zeros)

mp.dps = 50
AMPLITUDE, MU = mpf(9) / 10, mpf(1) / 2
GRID = 256  # points a period; events within less are none of these systems'
COLUMNS = ["problem", "k0", "c", "k1", "tau_periods", "m", "k_d", "c_d", "mu0", "F_n_amplitude", "velocity_ratio",
           "v_star", "velocity", "friction_ratio", "events_per_cycle"]


def real(z):
    return mpc(z).real


class Course:
    """y' = A y + b0 + b1 (t - t0) + Re(bc e^(it)) from y(t0) = y0."""

    def __init__(self, modes, t0, y0, b0, b1, bc):
        a, (rates, vectors, inverted) = modes
        identity = diag([1] * a.rows)
        self.t0, self.rates, self.vectors = t0, rates, vectors
        self.p1 = -lu_solve(a, b1)
        self.p0 = lu_solve(a, self.p1 - b0)
        self.pc = lu_solve(mpc(0, 1) * identity - a, bc)
        self.weights = inverted * (y0 - self.particular(t0))

    def particular(self, t):
        wave = exp(mpc(0, t))
        return matrix([self.p0[i] + self.p1[i] * (t - self.t0) + real(self.pc[i] * wave)
                       for i in range(self.p0.rows)])

    def at(self, t):
        modes = self.vectors * matrix([w * exp(r * (t - self.t0)) for w, r in zip(self.weights, self.rates)])
        return self.particular(t) + modes.apply(real)

    def integral(self, t):
        """Of y from t0 to t."""
        d = t - self.t0
        modes = self.vectors * matrix([w * (exp(r * d) - 1) / r for w, r in zip(self.weights, self.rates)])
        waves = self.pc * ((exp(mpc(0, t)) - exp(mpc(0, self.t0))) / mpc(0, 1))
        return self.p0 * d + self.p1 * (d * d / 2) + (modes + waves).apply(real)


def modes_of(a):
    values, vectors = eig(a)
    return a, (values, vectors, inverse(vectors))


class Driven:
    """Elastic or Zener contact, body and drive."""

    def __init__(self, k0, k1, tau, m, kd, cd, v):
        self.k0, self.k1, self.tau, self.m, self.kd, self.cd, self.v = k0, k1, tau, m, kd, cd, v
        n = 3 if k1 else 2
        a = zeros(n)  # slip: e, V, f
        a[0, 1], a[1, 0], a[1, 1] = -1, kd / m, -cd / m
        s = zeros(n)  # stick: w, V, f
        s[0, 1], s[1, 0], s[1, 1] = 1, -(kd + k0) / m, -cd / m
        if k1:
            a[2, 2] = -k0 / (k0 + k1) / tau
            s[1, 2], s[2, 1], s[2, 2] = -1 / m, k1, -1 / tau
        self.slip_modes, self.stick_modes, self.n = modes_of(a), modes_of(s), n

    def branch(self, y):
        return y[2] if self.k1 else mpf(0)

    def slip(self, t0, y0):
        b0, bc = zeros(self.n, 1), zeros(self.n, 1)
        b0[0], b0[1] = self.v, (self.cd * self.v - MU) / self.m
        bc[1] = -MU * AMPLITUDE / self.m
        if self.k1:  # f' (1 + k1/k0) = k1/k0 mu0 F_n' - f/tau
            bc[2] = self.k1 / (self.k0 + self.k1) * MU * AMPLITUDE * mpc(0, 1)
        return Course(self.slip_modes, t0, y0, b0, zeros(self.n, 1), bc)

    def stick(self, t0, y0):
        w = (bound(t0) - self.branch(y0)) / self.k0
        start = matrix([w, *y0[1:]])
        b0, b1 = zeros(self.n, 1), zeros(self.n, 1)
        b0[1] = (self.kd * (y0[0] + w) + self.cd * self.v) / self.m
        b1[1] = self.kd * self.v / self.m
        course = Course(self.stick_modes, t0, start, b0, b1, zeros(self.n, 1))
        course.elongation = y0[0] + w
        return course

    def after_stick(self, course, t):
        y = course.at(t)
        return matrix([course.elongation + self.v * (t - course.t0) - y[0], *y[1:]])

    def point_velocity(self, t, y):
        return y[1] - (bound_rate(t) + (y[2] / self.tau if self.k1 else 0)) / (self.k0 + self.k1)

    def force(self, t, y):
        return self.k0 * y[0] + self.branch(y)

    def impulse(self, course, t):
        total = course.integral(t)
        return self.k0 * total[0] + self.branch(total)


class Rigid:
    """Kelvin or elastic contact whose body moves at v. The state in slip is w; an elastic contact has none."""

    def __init__(self, k0, c, v):
        self.k0, self.c, self.v, self.n = k0, c, v, 1 if c else 0
        self.modes = modes_of(matrix([[-k0 / c]])) if c else None

    def slip(self, t0, y0):
        if self.c:
            return Course(self.modes, t0, y0, matrix([MU / self.c]), zeros(1), matrix([MU * AMPLITUDE / self.c]))
        return Line(t0, None, 0)

    def stick(self, t0, y0):
        return Line(t0, y0[0] if self.c else bound(t0) / self.k0, self.v)

    def after_stick(self, course, t):
        return course.at(t)

    def point_velocity(self, t, y):
        return self.v - ((bound(t) - self.k0 * y[0]) / self.c if self.c else bound_rate(t) / self.k0)

    def force(self, t, y):
        return self.k0 * y[0] + self.c * self.v

    def impulse(self, course, t):
        return self.k0 * course.integral(t)[0] + self.c * self.v * (t - course.t0)


class Line:
    """w0 + v (t - t0)"""

    def __init__(self, t0, w0, v):
        self.t0, self.w0, self.v = t0, w0, v

    def particular(self, t):
        return self.at(t)

    def at(self, t):
        return None if self.w0 is None else matrix([self.w0 + self.v * (t - self.t0)])

    def integral(self, t):
        d = t - self.t0
        return matrix([self.w0 * d + self.v * d * d / 2])


def bound(t):
    return MU * (1 + AMPLITUDE * cos(t))


def bound_rate(t):
    return -MU * AMPLITUDE * sin(t)


def first_zero(function, begin, end):
    """Where a function that is positive after begin falls to 0; none before end."""
    step = 2 * pi / GRID
    low, t = begin, begin
    while t < end:
        t = min(t + step, end)
        if function(t) <= 0:
            if low == begin:  # 0 at its own begin, too
                low = begin + (t - begin) / 2**20
                assert function(low) > 0, "at once"
            return findroot(function, (low, t), solver="anderson")
        low = t
    return None


def sliding(system):
    """Time and state of motion without stick, where the contact point is fastest."""
    course = system.slip(mpf(0), zeros(system.n, 1) if system.n else None)
    time = max((2 * pi * i / GRID for i in range(GRID)),
               key=lambda t: system.point_velocity(t, course.particular(t)))
    return time, course.particular(time)


def marched(system, t, y, end):
    """From slip at t to slip at end: the state, events and impulse."""
    events, impulse, sticking = [], mpf(0), False
    while True:
        course = system.stick(t, y) if sticking else system.slip(t, y)
        if sticking:
            until = first_zero(lambda s: bound(s) - system.force(s, course.at(s)), t, end)
        else:
            until = first_zero(lambda s: system.point_velocity(s, course.at(s)), t, end)
        stop = end if until is None else until
        if sticking:
            impulse += system.impulse(course, stop)
            y = system.after_stick(course, stop)
        else:
            impulse += MU * (stop - t + AMPLITUDE * (sin(stop) - sin(t)))
            y = course.at(stop)
        if until is None:
            return y, events, impulse, sticking
        t, sticking = until, not sticking
        events.append(t)


def closed(system):
    """The friction ratio of the cycle, and its events."""
    begin, y = sliding(system)
    _, events, _, _ = marched(system, begin, y, begin + 12 * pi)
    last = len(events) - 1 - (len(events) - 1) % 2  # stick begins with each second one
    middle = (events[last - 1] + events[last]) / 2
    y, _, _, sticking = marched(system, begin, y, middle)
    assert not sticking
    for _ in range(40):
        after, events, impulse, sticking = marched(system, middle, y, middle + 2 * pi)
        assert not sticking
        if system.n == 0:
            break
        miss = after - y
        size = max(abs(x) for x in miss)
        if size < mpf(10)**-32:
            break
        h, jacobian = mpf(10)**-22, zeros(system.n)
        for j in range(system.n):
            moved = y.copy()
            moved[j] += h
            column = (marched(system, middle, moved, middle + 2 * pi)[0] - after) / h
            for i in range(system.n):
                jacobian[i, j] = column[i] - (1 if i == j else 0)
        y = y - lu_solve(jacobian, miss)
    else:
        raise RuntimeError("no cycle")
    return impulse / (2 * pi * MU), len(events)


def systems():
    """problem, k0, c, k1, tau_periods, m, k_d, c_d as text."""
    for c in ["0", "1", "10", "100"]:
        yield ["P1", "1", c, "", "", "0", "inf", ""]
    for kd in ["0.5", "1", "2"]:
        yield ["P2", "1", "0", "", "", "0.3", kd, "0.02"]
    for tau in ["1e-9", "1e-6", "1e-3", "1e-1", "1e0", "1e1", "1e3", "1e6"]:
        yield ["P3", "1", "0", "4", tau, "0.3", "0.5", "0.1"]


def row_of(texts, ratio):
    k0, c, k1, tau, m, kd, cd = [mpf(x) if x else mpf(0) for x in texts[1:]]
    tau *= 2 * pi
    stiffness = k0 + mpc(0, c) + (k1 * mpc(0, tau) / (1 + mpc(0, tau)) if k1 else 0)
    compliance = 1 / stiffness + (0 if kd == mp.inf else 1 / (kd - m + mpc(0, cd)))
    threshold = MU * AMPLITUDE * abs(compliance)
    v = mpf(ratio) * threshold
    friction, events = closed(Rigid(k0, c, v) if kd == mp.inf else Driven(k0, k1, tau, m, kd, cd, v))
    return [*texts, "0.5", "0.9", ratio, *map(fixed, (threshold, v)), nstr(friction, 22), events]


def fixed(x):
    """22 decimals, not rounded; those of a short number are left out."""
    digits = str(int(floor(x * mpf(10)**22 + mpf(10)**-20))).rjust(23, "0")
    text = f"{digits[:-22]}.{digits[-22:]}"
    return text.rstrip("0") if text.endswith("0000000000") else text


def main():
    with Path(__file__).with_suffix(".csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(COLUMNS)
        for texts in systems():
            for ratio in ["0.1", "0.5", "0.99"]:
                rows.writerow(row_of(texts, ratio))
                file.flush()


if __name__ == "__main__":
    main()
