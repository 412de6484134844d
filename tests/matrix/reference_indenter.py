"""Friction below an indenter, for make_references.py: cells side by side, summed by Gauss's rule on panels."""

import csv
from math import asin, gamma, pi, sqrt, tan

import numpy as np

from reference_kinds import FOLDER, wired
from reference_motion import extrapolated

# Panels end where cells begin to part and where the rim is; the rule on each has so many points, and again half of them.
POINTS = 24
NU = 0.4


def profile(indenter):
    """g(x) of the one-dimensional contact, for x >= 0."""
    shape = indenter["shape"]
    if shape == "flat":
        return lambda x: np.where(x < indenter["radius"], 0.0, np.inf)
    if shape == "cone":
        return lambda x: pi / 2 * x * tan(indenter["angle"])
    if shape == "parabola":
        return lambda x: x**2 / indenter["radius"]
    if shape == "power":
        n = indenter["exponent"]
        return lambda x: sqrt(pi) / 2 * n * gamma(n / 2) / gamma((n + 1) / 2) * indenter["prefactor"] * x**n
    with (FOLDER / shape).open() as file:
        rows = [(float(row["r"]), float(row["f"])) for row in csv.DictReader(file)]

    def table(x):
        total = 0.0
        for (r0, f0), (r1, f1) in zip(rows, rows[1:]):
            if x > r0:
                total += (f1 - f0) / (r1 - r0) * (asin(min(1.0, r1 / x)) - asin(r0 / x))
        return x * total
    return np.vectorize(table)


def edge(g, depth, largest):
    """Where g reaches a depth."""
    low, high = 0.0, largest
    if g(np.array(high)) <= depth:
        return high
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if g(np.array(middle)) < depth else (low, middle)
    return low


def cells(name, values, text, linear):
    from reference_friction import RATIOS, Motions, simulated_onset
    indenter = text["indenter"]
    g = profile(indenter)
    system = wired(name, values)
    depth, amplitude = float(values["u_z0"]), float(values["du_z"])
    largest = indenter.get("radius", 1e-3) if indenter["shape"] == "flat" else 1e-4 if "csv" in indenter["shape"] else 0.1
    # Cells farther out than the rim at its largest never touch.
    rim = edge(g, depth + amplitude, largest)
    dynamic = float(abs(linear["normal_stiffness:storage"] + 1j * linear["normal_stiffness:loss"]))
    ratio_at_rest = dynamic / float(linear["normal_stiffness_at_rest"])
    breaks = [0.0]
    for level in (depth - amplitude * ratio_at_rest, depth, depth + 0.5 * amplitude):
        place = edge(g, level, largest) if level > 0 else 0.0
        if breaks[-1] < place < rim * (1 - 1e-9):
            breaks.append(place)
    breaks.append(rim)
    speed = float(linear["formula"])
    velocities = [r * speed for r in RATIOS]
    results = []
    for points in (POINTS // 2, POINTS):
        x, weights = grid(breaks, points)
        means = depth - g(x)
        motions = Motions(system, values, np.tile(means, len(RATIOS)), True, np.repeat(velocities, len(x)))
        sums = []
        for mean in motions.means:
            force = (mean.force / mean.steps).reshape(len(RATIOS), -1) @ weights
            bound = (mean.bound / mean.steps).reshape(len(RATIOS), -1) @ weights
            sums.append([force / bound, 2 * bound / float(values["mu0"]) / (1 - NU**2)])
        results.append(extrapolated(sums, True))
    (coarse, _), (best, error) = results
    error = error + np.abs(best - coarse)
    onset, onset_error = simulated_onset(system, values, depth - g(grid(breaks, 6)[0]), True)
    fastest = int(np.argmax(onset[0]))
    yield "critical_velocity", onset[0][fastest], onset_error[0][fastest]
    for i, velocity in enumerate(velocities):
        yield f"velocity:{i}", velocity, 0
        yield f"friction_ratio:{i}", best[0][i], error[0][i]
        yield f"mean_normal_force:{i}", best[1][i], error[1][i]
        yield f"regime:{i}", motions.regime(*range(i * len(x), (i + 1) * len(x))), 0


def grid(breaks, points):
    """Gauss's rule on each panel, its points drawn to both ends where the integrand has roots."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    x, w = [], []
    for left, right in zip(breaks, breaks[1:]):
        t = (3 * nodes - nodes**3) / 2
        x.extend((left + right) / 2 + (right - left) / 2 * t)
        w.extend((right - left) / 2 * weights * 1.5 * (1 - nodes**2))
    return np.array(x), np.array(w)
