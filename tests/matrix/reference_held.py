"""v* and friction of a parabola on a drive k | c with a body, for make_references.py.

v* in 40 digits: all touching cells slide with one velocity, v0 + dq/dt - (mu0 E*/G*) du_z/dt with q the body's swing under
mu0 F_n, by Fourier's series of F_n = 4/3 E* sqrt(R) u_z^(3/2). Friction by cells of equal width in small steps of time.
On a half-space that relaxes, and a spring alone: v* by closed forms of its cells (tests/data/held_memory.py).
"""

import sys
from pathlib import Path

import mpmath as mp
import numpy as np

from reference_indenter import design_rows
from reference_kinds import mindlin

RATIOS = (0.3, 0.8)
HARMONICS, SAMPLES = 60, 256  # of a force that is analytic: its coefficients fall by a constant each


def plain_modulus(values, nu):
    return values["E0"] / (1 - mp.mpf(nu) ** 2)


def normal_forces(values, radius, nu, depth):
    """F_n at so many phases, as long as the centre stays closed."""
    return [mp.mpf(4) / 3 * plain_modulus(values, nu) * mp.sqrt(radius)
            * (depth + values["du_z"] * mp.cos(2 * mp.pi * i / SAMPLES)) ** mp.mpf(1.5) for i in range(SAMPLES)]


def depth_under_load(values, radius, nu):
    """u_z0 at which the mean of F_n is the load W: somewhat less than that of W at rest, as F_n is convex."""
    at_rest = (mp.mpf(3) / 4 * values["W"] / plain_modulus(values, nu) / mp.sqrt(radius)) ** (mp.mpf(2) / 3)

    def share(x):
        return mp.fsum(normal_forces(values, radius, nu, x * at_rest)) / SAMPLES / values["W"] - 1
    return at_rest * mp.findroot(share, (mp.mpf("0.99"), 1))


def sliding_velocity(values, radius, nu):
    """v*: the largest over the phase."""
    if "u_z0" not in values:
        values = values | {"u_z0": depth_under_load(values, radius, nu)}
    amplitude, omega = values["du_z"], values["omega"]
    force = normal_forces(values, radius, nu, values["u_z0"])
    swings = []
    for n in range(1, HARMONICS):
        harmonic = 2 * mp.fsum(f * mp.cos(2 * mp.pi * n * i / SAMPLES) for i, f in enumerate(force)) / SAMPLES
        s = 1j * n * omega
        swings.append(s * harmonic / (values["kd"] + values.get("cd", 0) * s + values.get("m", 0) * s * s))

    def rate(t):
        swing = mp.fsum(mp.re(a * mp.expjpi((n + 1) * t / mp.pi)) for n, a in enumerate(swings))
        return values["mu0"] * (-amplitude * omega * mp.sin(t) / mindlin(nu) + swing)
    coarse = [2 * mp.pi * i / 400 for i in range(400)]
    best = max(coarse, key=rate)
    return rate(mp.findroot(lambda t: mp.diff(rate, t), best))


class Cells:
    """Of equal width, on a body in small steps of time: Verlet's method, or balance without a mass."""

    def __init__(self, values, radius, nu, count):
        v = {key: float(value) for key, value in values.items()}
        self.v, self.radius = v, float(radius)
        self.normal = float(plain_modulus(values, nu))
        self.shear = float(mindlin(nu)) * self.normal
        width = np.sqrt(self.radius * (v["u_z0"] + v["du_z"])) / count
        x = (np.arange(count) + 0.5) * width
        self.gap, self.width = x**2 / self.radius, 2 * width

    def bounds(self, t):
        depth = self.v["u_z0"] + self.v["du_z"] * np.cos(self.v["omega"] * t)
        return self.v["mu0"] * self.normal * np.maximum(0, depth - self.gap)

    def ratio(self, velocity, steps, periods):
        v, h = self.v, 2 * np.pi / self.v["omega"] / steps
        step = self.with_mass if "m" in v else self.without_mass
        state = {"forces": np.zeros_like(self.gap), "place": 0.0, "speed": 0.0, "force": 0.0}
        friction = bound = 0.0
        self.regimes = set()
        for i in range(steps * periods):
            limits = self.bounds(h * (i + 1))
            step(state, velocity, h, limits)
            if i >= steps * (periods - 1):
                friction += state["force"]
                bound += self.width * limits.sum()
                if np.any(np.abs(state["forces"]) < limits * (1 - 1e-9)):
                    self.regimes.add("stick")
        return friction / bound, bound / v["mu0"] / steps

    def moved(self, state, by, limits):
        forces = np.clip(state["forces"] + self.shear * by, -limits, limits)
        return forces, self.width * forces.sum()

    def with_mass(self, state, velocity, h, limits):
        v = self.v
        half = state["speed"] + h / 2 * (-v["kd"] * state["place"] - v["cd"] * state["speed"] - state["force"]) / v["m"]
        state["place"] += h * half
        state["forces"], state["force"] = self.moved(state, h * (velocity + half), limits)
        state["speed"] = ((half + h / 2 * (-v["kd"] * state["place"] - state["force"]) / v["m"])
                          / (1 + h / 2 * v["cd"] / v["m"]))

    def without_mass(self, state, velocity, h, limits):
        """The place at which the spring balances the cells, by Newton's method on straight pieces."""
        v, place = self.v, state["place"]
        for _ in range(60):
            forces, force = self.moved(state, velocity * h + place - state["place"], limits)
            sticking = np.abs(state["forces"] + self.shear * (velocity * h + place - state["place"])) < limits
            slope = v["kd"] + self.width * self.shear * sticking.sum()
            change = -(v["kd"] * place + force) / slope
            place += change
            if abs(change) < 1e-14 * (abs(place) + v["du_z"]):
                break
        state["forces"], state["force"] = self.moved(state, velocity * h + place - state["place"], limits)
        state["place"] = place


class RelaxingCells(Cells):
    """The same of springs and a branch that relaxes, on a spring alone; what presses them is found by the same steps."""

    def __init__(self, values, radius, nu, count):
        super().__init__(values, radius, nu, count)
        self.across, self.along = ({"spring": np.zeros_like(self.gap), "branch": np.zeros_like(self.gap)} for _ in range(2))
        self.place = np.zeros_like(self.gap)

    def ratio(self, velocity, steps, periods):
        v, h = self.v, 2 * np.pi / self.v["omega"] / steps
        time = v["c1"] / v["E1"]
        self.left = np.exp(-h / time)
        self.gain = self.normal * v["E1"] / v["E0"] * time / h * (1 - self.left)
        return super().ratio(velocity, steps, periods)

    def carried(self, forces):
        return forces["spring"] + self.left * forces["branch"]

    def move(self, forces, way):
        forces["spring"] = forces["spring"] + self.normal * way
        forces["branch"] = self.left * forces["branch"] + self.gain * way

    def bounds(self, t):
        down = self.v["u_z0"] + self.v["du_z"] * np.cos(self.v["omega"] * t) - self.gap
        before, at_once = self.carried(self.across), self.normal + self.gain
        way = np.maximum(down - self.place, -before / at_once)
        self.move(self.across, way)
        self.place = self.place + way
        return self.v["mu0"] * np.maximum(0, before + at_once * way)

    def without_mass(self, state, velocity, h, limits):
        """The place at which the spring balances the cells, by Newton's method on straight pieces."""
        v, place, ratio = self.v, state["place"], self.shear / self.normal
        before, at_once = ratio * self.carried(self.along), ratio * (self.normal + self.gain)
        for _ in range(60):
            tried = before + at_once * (velocity * h + place - state["place"])
            slope = v["kd"] + self.width * at_once * (np.abs(tried) < limits).sum()
            change = -(v["kd"] * place + self.width * np.clip(tried, -limits, limits).sum()) / slope
            place += change
            if abs(change) < 1e-14 * (abs(place) + v["du_z"]):
                break
        tried = before + at_once * (velocity * h + place - state["place"])
        state["forces"] = np.clip(tried, -limits, limits)
        state["force"], state["place"] = self.width * state["forces"].sum(), place
        self.move(self.along, (state["forces"] - before) / at_once)


def elastic_rows(values, given, radius, nu):
    """v* and its sensitivities, and the mean force."""
    critical = sliding_velocity(given, radius, nu)
    yield "critical_velocity", critical, mp.mpf(10) ** -13 * critical
    small = mp.mpf(10) ** -10  # of central differences: 1e-20 of the third derivative
    for key in given:
        one, two = (sliding_velocity(given | {key: given[key] * factor}, radius, nu) for factor in (1 + small, 1 - small))
        yield f"sensitivity:{key}", mp.log(one / two) / (2 * small), 0
    mean = mp.quad(lambda t: (values["u_z0"] + values["du_z"] * mp.cos(t)) ** mp.mpf(1.5), [0, mp.pi]) / mp.pi
    yield "mean", mean * mp.mpf(4) / 3 * plain_modulus(values, nu) * mp.sqrt(radius), 0


def half_space(values, radius, nu):
    """In lengths of sqrt(R) along the surface, moduli of E* and times of 1/omega."""
    sys.path.append(str(Path(__file__).parents[1] / "data"))
    from held_memory import HalfSpace
    stiff = plain_modulus(values, nu) * mp.sqrt(radius)
    return HalfSpace(("", "zener", values["E1"] / values["E0"], values["omega"] * values["c1"] / values["E1"], "parabola",
                      values["du_z"], values["u_z0"], values["kd"] / stiff, 0, 0), shear=mindlin(nu))


def relaxing_rows(values, radius, nu):
    """v* and its sensitivities, by differences that leave 7 digits; the mean force by a sum over phases."""
    at = half_space(values, radius, nu)
    largest, phase = at.largest()

    def sliding(given):
        return given["mu0"] * given["omega"] * half_space(given, radius, nu).largest(phase)[0]
    yield "critical_velocity", values["mu0"] * values["omega"] * largest, mp.mpf(10) ** -10 * values["mu0"] * values["omega"] * largest
    small = 1e-4
    for key in values:
        one, two = (sliding(values | {key: values[key] * factor}) for factor in (1 + small, 1 - small))
        yield f"sensitivity:{key}", mp.log(one / two) / (2 * small), 0
    mean = 0.0
    from held_memory import gauss
    for low, high in ((at.first, 0), (0, at.last)):
        mean += mp.fsum(w * (high - low) * 6 * s * (1 - s) * at.normal_force(low + (high - low) * s**2 * (3 - 2 * s))[0]
                        for s, w in gauss(40)) / (2 * mp.pi)
    yield "mean", mean * plain_modulus(values, nu) * mp.sqrt(radius), 0


def held_rows(values, text):
    """v* with its sensitivities, and friction at two speeds."""
    mp.mp.dps = 40
    radius, nu = mp.mpf(text["indenter"]["radius"]), str(text["contact"]["poisson"])
    given = {key: value for key, value in values.items() if key != "u_z0" or "W" not in values}
    for key, value in given.items():
        yield f"value:{key}", value, 0
    yield "loaded", 1, 0
    if "W" in values:
        yield "indentation", values["u_z0"], 0
    linear = list(relaxing_rows(values, radius, nu) if "E1" in values else elastic_rows(values, given, radius, nu))
    critical, mean = linear[0][1], linear.pop()[1]
    yield from linear
    kind, first = RelaxingCells if "E1" in values else Cells, None
    for i, share in enumerate(RATIOS):
        velocity = float(share * critical)
        found = []
        for count, steps in ((150, 2000), (300, 4000), (600, 8000)):
            cells = kind(values, radius, nu, count)
            found.append(cells.ratio(velocity, steps, 25)[0])
        yield f"velocity:{i}", velocity, 0
        # What halving both changes: the rest is at most as much.
        error = 2 * (abs(found[2] - found[1]) + abs(found[1] - found[0]) / 4)
        first = first or (velocity, found[2], error)
        yield f"friction_ratio:{i}", found[2], error
        yield f"mean_normal_force:{i}", mean, mp.mpf(10) ** -12 * mean
        yield f"regime:{i}", "stick-slip-apart" if "stick" in cells.regimes else "sliding-apart", 0

    def ratio(changed, velocity):
        if "W" in changed:
            changed = changed | {"u_z0": depth_under_load(changed, radius, nu)}
        return kind(changed, radius, nu, 150).ratio(velocity, 2000, 25)[0], 0  # of a difference, whose ends err alike
    yield from design_rows(values, *first, ratio)
