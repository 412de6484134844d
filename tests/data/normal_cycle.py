#!/usr/bin/python3
"""Writes normal_cycle.csv: the steady force of a contact that opens, to 25 digits.

An equilibrium spring, a direct damper and Maxwell branches side by side, k_inf = 1, under the
indentation mean + amplitude cos t; F = max(0, reaction), without adhesion. Apart, the network moves
freely by the exponential of its matrix, with no Kelvin units: for the state (e, f_1, ...) with
damper, (f_1, ...) without. Touching, each branch has its closed form. Where the surfaces meet and
part, and the branches' forces where they meet, are the roots of the conditions of a closed cycle by
Newton's method at 60 digits. Where time scales are long, the solution is followed there from one
with shorter ones.
"""

import csv
from pathlib import Path

from mpmath import cos, exp, expm, findroot, matrix, mp, mpf, nstr, pi, sin

mp.dps = 60

# name, damper, [(k, tau)], mean, amplitude
CASES = [
    ("elastic", 0, [], 1, 3),
    ("elastic out of reach for most of the time", 0, [], -2, "2.125"),
    ("Kelvin", "0.3", [], 1, 3),
    ("Kelvin with a stiff damper", 5, [], 1, "0.75"),
    ("Zener", 0, [(2, "0.7")], 1, 3),
    ("Zener open though the amplitude is less than the mean", 0, [(6, "1.5")], 1, "0.4"),
    ("Zener from far above", 0, [(2, "0.7")], "-0.5", "0.75"),
    ("branch of 1e6 radians", 0, [("0.5", 1000000)], 1, 2),
    ("branch of 1e-10 radians", 0, [(3, "1e-10")], 1, 2),
    ("three branches and a damper", "0.01", [(1, "0.02"), ("0.7", "0.8"), ("0.4", 30)], 1, 2),
    ("five decades", 0, [(1, "0.001"), (1, "0.1"), (1, 10), (1, 1000)], 1, 4),
]


class Network:
    def __init__(self, damper, branches, mean, amplitude):
        self.c = mpf(damper)
        self.branches = [(mpf(k), mpf(tau)) for k, tau in branches]
        self.mean, self.amplitude = mpf(mean), mpf(amplitude)

    def depth(self, t):
        return self.mean + self.amplitude * cos(t)

    def swing(self, k, tau, t):
        """The part of a branch's force in step with the indentation: Re(k i/(1/tau + i) a e^{it})."""
        rate = 1 / tau
        return k * self.amplitude * (cos(t) - rate * sin(t)) / (rate**2 + 1)

    def swung(self, k, tau, t):
        """Its integral."""
        rate = 1 / tau
        return k * self.amplitude * (sin(t) + rate * cos(t)) / (rate**2 + 1)

    def pressed(self, forces, begin, t):
        """Branch forces at t, touching since `begin`."""
        return [
            self.swing(k, tau, t) + (f - self.swing(k, tau, begin)) * exp(-(t - begin) / tau)
            for f, (k, tau) in zip(forces, self.branches)
        ]

    def reaction(self, forces, t):
        return self.depth(t) - self.c * self.amplitude * sin(t) + sum(forces)

    def impulse(self, forces, begin, end):
        total = self.mean * (end - begin) + self.amplitude * (sin(end) - sin(begin))
        total += self.c * self.amplitude * (cos(end) - cos(begin))
        for f, (k, tau) in zip(forces, self.branches):
            total += self.swung(k, tau, end) - self.swung(k, tau, begin)
            total += (f - self.swing(k, tau, begin)) * tau * (1 - exp(-(end - begin) / tau))
        return total

    def freed(self, forces, depth, duration):
        """Deformation and branch forces after moving freely."""
        n = len(self.branches)
        if self.c > 0:
            a = matrix(n + 1, n + 1)
            a[0, 0] = -1 / self.c
            for j in range(n):
                a[0, j + 1] = -1 / self.c
            for i, (k, tau) in enumerate(self.branches):
                for j in range(n + 1):
                    a[i + 1, j] = k * a[0, j]
                a[i + 1, i + 1] -= 1 / tau
            x = propagated(a, duration) * matrix([depth] + list(forces))
            return x[0], [x[i + 1] for i in range(n)]
        if n == 0:
            return mpf(0), []
        b = matrix(n, n)
        for i, (k, _) in enumerate(self.branches):
            for j in range(n):
                b[i, j] = k + (1 if i == j else 0)
        rates = matrix(n, n)
        for i, (_, tau) in enumerate(self.branches):
            rates[i, i] = -1 / tau
        x = propagated(b**-1 * rates, duration) * matrix(list(forces))
        return -sum(x), list(x)

    def conditions(self, begin, end, *forces):
        """0 for a closed cycle that touches from begin to end."""
        last = self.pressed(forces, begin, end)
        depth, again = self.freed(last, self.depth(end), 2 * pi - (end - begin))
        left = [depth - self.depth(begin), self.reaction(last, end)]
        return left + [a - f for a, f in zip(again, forces)]

    def holds(self, begin, end, forces):
        """Pressed while touching, above the substrate while apart, at a thousand times each."""
        for i in range(1, 1000):
            t = begin + (end - begin) * i / 1000
            if self.reaction(self.pressed(forces, begin, t), t) <= 0:
                return False
        last = self.pressed(forces, begin, end)
        with mp.workdps(20):
            for i in range(1, 200):
                t = (2 * pi - (end - begin)) * i / 200
                if self.freed(last, self.depth(end), t)[0] <= self.depth(end + t):
                    return False
        return True


def propagated(a, t):
    """e^{a t} through the eigenvectors: rates may lie decades apart."""
    if a.rows == 1:
        return matrix([[exp(a[0, 0] * t)]])
    values, vectors = mp.eig(a)
    return vectors * mp.diag([exp(v * t) for v in values]) * vectors**-1


def seed(network, steps=4000, periods=12):
    """Begin, end and forces by small steps, in doubles."""
    c, branches = float(network.c), [(float(k), float(tau)) for k, tau in network.branches]
    mean, amplitude, h = float(network.mean), float(network.amplitude), float(2 * pi) / steps
    import math

    t, forces, touching, begin, end = -math.pi, [0.0] * len(branches), False, None, None
    depth, first = 0.0, None
    for i in range(steps * periods):
        t = -math.pi + (i + 1) * h
        target = mean + amplitude * math.cos(t)
        # one implicit step of the free network, and one at the target
        weights = [k / (1 + h / tau) for k, tau in branches]
        kept = [f / (1 + h / tau) for f, (_, tau) in zip(forces, branches)]
        free = (c / h * depth + sum(w * depth for w in weights) - sum(kept)) / (1 + c / h + sum(weights))
        to = max(free, target) if free > target else target
        if to == target and not touching:
            begin, touching = t, True
            first = [f + w * (to - depth) for f, w in zip(kept, weights)]
        elif to != target and touching:
            end, touching = t, False
        forces = [f + w * (to - depth) for f, w in zip(kept, weights)]
        depth = to
    if end < begin:
        end += 2 * math.pi
    turns = math.floor(begin / (2 * math.pi) + 0.5)
    return [begin - 2 * math.pi * turns, end - 2 * math.pi * turns] + first


def solved(damper, branches, mean, amplitude):
    # Relaxation longer than 10 radians: reached from 10 on by factors of 2.
    longest = max([mpf(tau) for _, tau in branches], default=mpf(0))
    scale = mpf(1)
    while longest / scale > 10:
        scale *= 2
    guess = None
    while True:
        now = [(k, min(mpf(tau), longest / scale)) for k, tau in branches]
        network = Network(damper, now, mean, amplitude)
        guess = guess or seed(network)
        solution = findroot(network.conditions, guess, solver="mdnewton", tol=mpf(10) ** -70, maxsteps=60)
        guess = list(solution)
        if scale == 1:
            break
        scale /= 2
    begin, end, *forces = guess
    assert network.holds(begin, end, forces), (begin, end)
    return begin, end, network.impulse(forces, begin, end) / (2 * pi)


def main():
    with open(Path(__file__).with_suffix(".csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["name", "damper", "branches", "mean", "amplitude", "begin", "duration", "mean_force"])
        for name, damper, branches, mean, amplitude in CASES:
            begin, end, force = solved(damper, branches, mean, amplitude)
            text = " ".join(f"{k}:{tau}" for k, tau in branches)
            row = [nstr(x, 25) for x in (begin % (2 * pi), end - begin, force)]
            print(name, *row, flush=True)
            table.writerow([name, damper, text, mean, amplitude, *row])


if __name__ == "__main__":
    main()
