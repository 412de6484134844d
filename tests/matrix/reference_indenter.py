"""Friction below an indenter, for make_references.py: cells side by side, summed by Gauss's rule on panels."""

import csv
from math import asin, gamma, pi, sqrt, tan

import mpmath as mp
import numpy as np

from reference_kinds import FOLDER, found_depth, wired
from reference_motion import extrapolated
from reference_networks import stiffness

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


class Cells:
    """Of equal kind, under the scene's indenter: Gauss's rule over their friction."""

    def __init__(self, name, values, text):
        indenter = text["indenter"]
        self.g = profile(indenter)
        self.system, self.values = wired(name, values), values
        self.depth, amplitude = float(values["u_z0"]), float(values["du_z"])
        largest = indenter.get("radius", 1e-3) if indenter["shape"] == "flat" else 1e-4 if "csv" in indenter["shape"] else 0.1
        # Cells farther out than the rim at its largest never touch.
        rim = edge(self.g, self.depth + amplitude, largest)
        at_rest, dynamic = (float(abs(stiffness(self.system.normal, s))) for s in (mp.mpf(10) ** -60, 1j * values["omega"]))
        self.breaks = [0.0]
        for level in (self.depth - amplitude * dynamic / at_rest, self.depth, self.depth + 0.5 * amplitude):
            place = edge(self.g, level, largest) if level > 0 else 0.0
            if self.breaks[-1] < place < rim * (1 - 1e-9):
                self.breaks.append(place)
        self.breaks.append(rim)

    def friction(self, velocities):
        """Ratios and mean normal forces at these speeds, with their errors."""
        from reference_friction import Motions
        results = []
        for points in (POINTS // 2, POINTS):
            x, weights = grid(self.breaks, points)
            means = self.depth - self.g(x)
            self.motions = Motions(self.system, self.values, np.tile(means, len(velocities)), True, np.repeat(velocities, len(x)))
            sums = []
            for mean in self.motions.means:
                force = (mean.force / mean.steps).reshape(len(velocities), -1) @ weights
                bound = (mean.bound / mean.steps).reshape(len(velocities), -1) @ weights
                sums.append([force / bound, 2 * bound / float(self.values["mu0"]) / (1 - NU**2)])
            results.append(extrapolated(sums, True))
        (coarse, _), (best, error) = results
        self.count = len(x)
        return best, error + np.abs(best - coarse)

    def onset(self):
        from reference_friction import simulated_onset
        return simulated_onset(self.system, self.values, self.depth - self.g(grid(self.breaks, 6)[0]), True)


def cell_rows(name, values, text, linear):
    from reference_friction import RATIOS
    cells, speed = Cells(name, values, text), float(linear["formula"])
    velocities = [r * speed for r in RATIOS]
    best, error = cells.friction(velocities)
    onset, onset_error = cells.onset()
    fastest = int(np.argmax(onset[0]))
    yield "critical_velocity", onset[0][fastest], onset_error[0][fastest]
    for i, velocity in enumerate(velocities):
        yield f"velocity:{i}", velocity, 0
        yield f"friction_ratio:{i}", best[0][i], error[0][i]
        yield f"mean_normal_force:{i}", best[1][i], error[1][i]
        yield f"regime:{i}", cells.motions.regime(*range(i * cells.count, (i + 1) * cells.count)), 0

    def ratio(changed, velocity):
        if "W" in changed:
            changed = changed | found_depth(name, changed)
        found, off = Cells(name, changed, text).friction([velocity])
        return found[0][0], off[0][0]
    if not linear["closed"]:
        closed = linear["admissible_amplitude"] * mp.mpf("0.6")
        speed *= float(closed / values["du_z"])
        values = values | {"du_z": closed}
    yield from design_rows(values, speed / 2, *ratio(values, speed / 2), ratio)


def design_rows(values, velocity, wanted, error, ratio):
    """The friction ratio at a speed, and how it changes with each unknown; ratio(values, velocity), with its error."""
    yield "design:velocity", velocity, 0
    yield "design:amplitude", float(values["du_z"]), 0
    yield "design:omega", float(values["omega"]), 0
    yield "design:friction_ratio", wanted, error
    unknowns = [("velocity", None), ("amplitude", "du_z"), ("frequency", "omega")] + ([("force", "W")] if "W" in values else [])
    for unknown, key in unknowns:
        (high, more), (low, less) = (ratio(values, velocity * factor) if key is None
                                     else ratio(values | {key: values[key] * mp.mpf(factor)}, velocity) for factor in (1.02, 0.98))
        width = 0.04 * float(velocity if key is None else values[key])
        yield f"design:slope:{unknown}", (high - low) / width, (more + less) / width


def grid(breaks, points):
    """Gauss's rule on each panel, its points drawn to both ends where the integrand has roots."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    x, w = [], []
    for left, right in zip(breaks, breaks[1:]):
        t = (3 * nodes - nodes**3) / 2
        x.extend((left + right) / 2 + (right - left) / 2 * t)
        w.extend((right - left) / 2 * weights * 1.5 * (1 - nodes**2))
    return np.array(x), np.array(w)
