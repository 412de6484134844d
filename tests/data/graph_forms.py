#!/usr/bin/python3
"""Writes graph_forms.csv: relaxation forms of graphs, each number rounded to the nearest double.

The script solves no eigenproblem. With terminal 1 held, K(s) = det(A + s C)/det(A' + s C') of the nodal
matrices with and without terminal 0. Both polynomials are computed exactly, in rational numbers, and
common factors are removed. The poles are then real and simple, and the roots of the derivative separate
them, so bisection finds them to 60 digits. The residues give the stiffnesses. As graph_relaxation.hpp
promises, branches of less than 1e-30 of K at their rate are left out, and branches whose times differ
by 1e-15 or less become one.

A graph is written as "from-to k_inf c k:tau ...; ...", a form as "k_inf c k:tau ...".
"""

import csv
import random
from fractions import Fraction
from pathlib import Path

from mpmath import mp, mpf, sqrt

mp.dps = 80


def spring(k):
    return (k, 0, [])


def damper(c):
    return (0, c, [])


def branch(*pairs):
    return (0, 0, list(pairs))


def bridge(*edges):
    return list(zip([(0, 2), (0, 3), (2, 3), (2, 1), (3, 1)], edges))


def complete(nodes, *edges):
    pairs = [(i, j) for i in range(nodes) for j in range(i + 1, nodes)]
    return [(pair, edges[i % len(edges)]) for i, pair in enumerate(pairs)]


def scattered(seed, nodes, decades):
    """A spring, a damper or a branch between each two nodes, values from 10^-decades to 10^decades."""
    draw = random.Random(seed)

    def value():
        return 10 ** draw.uniform(-decades, decades)

    kinds = [lambda: spring(value()), lambda: damper(value()), lambda: branch((value(), value()))]
    return [(pair, draw.choice(kinds)()) for pair, _ in complete(nodes, None)]


CASES = [
    ("bridge", bridge(spring(2e7), damper(12.0), spring(3e7), damper(18.0), spring(2.5e7))),
    ("bridge of springs", bridge(*map(spring, (1.0, 2.0, 3.0, 4.0, 5.0)))),
    ("times over 24 decades", bridge(branch((1.0, 1e-12), (2.0, 1.0)), branch((3.0, 1e12)), spring(0.5),
                                     branch((0.7, 1e-6)), branch((1.1, 1e6)))),
    ("times over 120 decades", bridge(branch((1.0, 1e-60), (2.0, 1.0)), branch((3.0, 1e60)), spring(0.5),
                                      branch((0.7, 1e-30)), branch((1.1, 1e30)))),
    ("stiffness over 240 decades", bridge(branch((1e-120, 1.0)), spring(1e120), branch((1.0, 3.0)), damper(1e-60),
                                          branch((1e60, 0.5)))),
    ("a slow branch beside a stiff spring", bridge(spring(1.0), spring(3.0), branch((1e-20, 1e100)), spring(2.0),
                                                   spring(0.25))),
    ("times that differ by 1e-9", bridge(*[branch((1.0 + i, 1 + 1e-9 * i)) for i in range(5)])),
    ("times that differ by 1e-14", bridge(*[branch((1.0 + i, 1 + 1e-14 * i)) for i in range(5)])),
    ("times of 1e30 that differ by 1e-13", bridge(spring(1e-30), branch((1.0, 1e30)), spring(1.0),
                                                  branch((1.0, 1e30 * (1 + 1e-13))), damper(1e-25))),
    ("times of 1e30 that differ by 1e-13 beside one of 1e-30", bridge(
        branch((1.0, 1e-30), (1.0, 1e30)), spring(2.0), branch((1.0, 1e30 * (1 + 1e-13))), damper(1e30),
        branch((3.0, 1e30 * (1 + 2e-13))))),
    ("equal branches", bridge(*[branch((3.0, 7.0))] * 5)),
    ("five nodes and all edges equal", complete(5, (0.1, 0, [(0.3, 0.7)]))),
    ("six nodes and two kinds of edges in turn", complete(6, spring(0.7), damper(0.3))),
    ("Kelvin elements of equal times", complete(4, (0.1, 0.3, []), (0.2, 0.6, []))),
    ("equal branches at two times", complete(4, (0, 0.1, [(0.3, 0.1)]), (0.2, 0, [(1.7, 3.0)]))),
] + [(f"{nodes} nodes and numbers over {2 * decades} decades", scattered(decades + nodes, nodes, decades))
     for nodes in (4, 5) for decades in (3, 10, 20, 40, 70)]


def determinant(rows):
    rows, product = [row[:] for row in rows], Fraction(1)
    for i in range(len(rows)):
        pivot = next((j for j in range(i, len(rows)) if rows[j][i]), None)
        if pivot is None:
            return Fraction(0)
        if pivot != i:
            rows[i], rows[pivot], product = rows[pivot], rows[i], -product
        product *= rows[i][i]
        for j in range(i + 1, len(rows)):
            factor = rows[j][i] / rows[i][i]
            rows[j] = [x - factor * y for x, y in zip(rows[j], rows[i])]
    return product


def trimmed(p):
    while p and not p[-1]:
        p.pop()
    return p


def times_linear(p, root):
    return [a - root * b for a, b in zip([Fraction(0)] + p, p + [Fraction(0)])]


def determinant_polynomial(a, c):
    """det(a + s c), coefficients of increasing powers: Newton's interpolation at s = 0, 1, ..."""
    values = [determinant([[x + s * y for x, y in zip(*rows)] for rows in zip(a, c)]) for s in range(len(a) + 1)]
    for order in range(1, len(values)):
        for i in range(len(values) - 1, order - 1, -1):
            values[i] = (values[i] - values[i - 1]) / order
    result = [values[-1]]
    for s in range(len(values) - 2, -1, -1):
        result = times_linear(result, s)
        result[0] += values[s]
    return trimmed(result)


def divided(p, q):
    """Quotient and remainder."""
    rest, quotient = p[:], [Fraction(0)] * max(0, len(p) - len(q) + 1)
    for i in range(len(quotient) - 1, -1, -1):
        quotient[i] = rest[i + len(q) - 1] / q[-1]
        for j, x in enumerate(q):
            rest[i + j] -= quotient[i] * x
    return quotient, trimmed(rest)


def common(p, q):
    while q:
        p, q = q, divided(p, q)[1]
        q = [x / q[-1] for x in q]
    return p


def derivative(p):
    return [i * x for i, x in enumerate(p)][1:]


def value(p, x):
    result = Fraction(0)
    for coefficient in reversed(p):
        result = result * x + coefficient
    return result


def of(x):
    return mpf(x.numerator) / x.denominator


def rounded(x, bits=220):
    """Rounds to this many bits, so that fractions stay short."""
    with mp.workprec(bits):
        sign, mantissa, exponent, _ = of(x)._mpf_ if isinstance(x, Fraction) else mpf(x)._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** exponent


def bisected(p, low, high):
    """The only root between low >= 0 and high, which may be many decades apart."""
    rising = value(p, high) > 0
    while high - low > high / 2 ** 210:
        middle = rounded(sqrt(of(low) * of(high))) if low > 0 and high > 2 * low else rounded((low + high) / 2)
        if not low:
            middle = high / 2 ** 64
        if (value(p, middle) > 0) == rising:
            high = middle
        else:
            low = middle
    return high


def positive_roots(p):
    """All roots of a polynomial with positive, simple roots."""
    if len(p) < 2:
        return []
    bound = 1 + max(abs(x / p[-1]) for x in p)
    places = [Fraction(0)] + positive_roots(derivative(p)) + [bound]
    return [bisected(p, low, high) for low, high in zip(places, places[1:])]


def matrices(edges):
    nodes = 1 + max(max(pair) for pair, _ in edges)
    size = nodes + sum(len(edge[2]) for _, edge in edges)
    a, c = ([[Fraction(0)] * size for _ in range(size)] for _ in range(2))

    def stamp(matrix, i, j, x):
        for row, column, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
            matrix[row][column] += sign * x

    for (i, j), (k, damping, branches) in edges:
        stamp(a, i, j, Fraction(k))
        stamp(c, i, j, Fraction(damping))
        for stiffness, time in branches:
            stamp(a, i, nodes, Fraction(stiffness))
            stamp(c, nodes, j, Fraction(stiffness) * Fraction(time))
            nodes += 1
    return a, c


def without(matrix, first):
    keep = [i for i in range(len(matrix)) if i != 1 and i >= first]
    return [[matrix[i][j] for j in keep] for i in keep]


def form_of(edges):
    """k_inf, c and all branches as (k, rate), not rounded."""
    a, c = matrices(edges)
    p, q = (determinant_polynomial(without(a, first), without(c, first)) for first in (0, 1))
    shared = common(p, q)
    p, q = divided(p, shared)[0], divided(q, shared)[0]
    equilibrium, slope = p[0] / q[0], derivative(q)
    damping = p[-1] / q[-1] if len(p) > len(q) else Fraction(0)
    # With s = -x all roots are positive.
    rates = positive_roots([x * (-1) ** i for i, x in enumerate(q)])
    return equilibrium, damping, [(-value(p, -r) / (r * value(slope, -r)), r) for r in rates]


def doubles(equilibrium, damping, branches):
    result = []
    for k, r in reversed(branches):
        if k <= Fraction(1, 10 ** 30) * (equilibrium + damping * r + sum(h * r / (r + q) for h, q in branches)):
            continue
        time = float(1 / r)
        if result and time - result[-1][1] <= 1e-15 * time:
            result[-1] = (result[-1][0] + k, result[-1][1])
        else:
            result.append((k, time))
    return float(equilibrium), float(damping), [(float(k), time) for k, time in result]


def text(form):
    equilibrium, damping, branches = form
    return " ".join([f"{equilibrium!r} {damping!r}"] + [f"{k!r}:{tau!r}" for k, tau in branches])


def main():
    with open(Path(__file__).with_suffix(".csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["name", "graph", "form"])
        for name, edges in CASES:
            graph = "; ".join(f"{i}-{j} {text(edge)}" for (i, j), edge in edges)
            table.writerow([name, graph, text(doubles(*form_of(edges)))])
            print(name, flush=True)


if __name__ == "__main__":
    main()
