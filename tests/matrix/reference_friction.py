"""Friction and simulated v* of a kind, for make_references.py, by the steps of reference_motion."""

from types import SimpleNamespace

import numpy as np

import mpmath as mp
from reference_indenter import cell_rows
from reference_kinds import found_depth, height, is_found, moving, wired
from reference_motion import STEPS, Contact, Mean, extrapolated, normal_forces, steady
from reference_networks import creep_viscosity, stiffness

# Speeds at which friction is compared, in units of v* (of the drive, where the path creeps).
RATIOS = (0.3, 0.8)
# A difference of v* over 8 % needs fewer steps than v*.
DIFFERENCE_STEPS = (800, 1000, 1300, 1600, 2000)
# The most periods before the one that counts: at the coarsest steps, and at each finer.
SETTLING, FINER = 1000, 60


def tangential_path(system):
    """Edges from the contact point to the far end, whose frame all is written in."""
    end = "far" if system.drive is None else "body"
    factor = float(system.ratio or 1)
    network = system.normal if system.ratio else system.tangential
    edges = [(what, float(value) * factor, a, b) for what, value, a, b in network("contact", end)]
    if system.drive is not None:
        edges += system.drive("body", "far")
        if system.mass:
            edges.append(("m", system.mass, "body", "far"))
    return [edge for edge in edges if edge[1] != 0]


def bounds_of(system, values, steps, means, opening):
    """mu0 F_n at the end of each step of a period, a column for each mean indentation."""
    omega, amplitude, mu = float(values["omega"]), float(height(system, values)), float(values["mu0"])
    if opening and system.mount:
        return mu * below_mount(system, values, omega, steps)[1].repeat(len(means), axis=1)
    if opening:
        edges = [edge for edge in system.normal("surface", "far") if edge[1] != 0]
        return mu * normal_forces(edges, omega, means, amplitude, steps)
    k = complex(stiffness(system.normal, 1j * values["omega"]))
    phases = 2 * np.pi * np.arange(1, steps + 1) / steps
    force = amplitude * (k * np.exp(1j * phases)).real
    return mu * (mean_forces(system, values, means)[None, :] + force[:, None])


def below_mount(system, values, omega, steps):
    """Without mass: the vibrator presses mount and contact, one after the other. Its mean place, as deep as the load has it."""
    edges = [edge for edge in (*system.mount("surface", "body"), *system.normal("body", "far")) if edge[1] != 0]
    amplitude, load = float(values["U"]), float(values["W"])

    def forces(means):
        return normal_forces(edges, omega, np.asarray(means), amplitude, steps)
    # The mean force grows with the place, first over all of it and then close by.
    low, high = -amplitude, load * sum(1 / float(mp.re(stiffness(each, mp.mpf(10) ** -60))) for each in (system.mount, system.normal))
    for _ in range(3):
        means = np.linspace(low, high, 9)
        mean = np.interp(load, forces(means).mean(axis=0), means)
        width = (high - low) / 100
        low, high = mean - width, mean + width
    return mean, forces([mean])


def mean_forces(system, values, means):
    """Of a closed contact; a load is its own."""
    if "W" in values:
        return np.full(len(means), float(values["W"]))
    return float(mp.re(stiffness(system.normal, mp.mpf(10) ** -60))) * means


def means_of(values):
    """The mean depth as an array; where a load sinks, its place alone."""
    return np.array([float(values.get("u_z0", 0))])


class Motions:
    """Steady motions at several speeds (lanes), at each number of steps."""

    def __init__(self, system, values, means, opening, velocities):
        self.means, self.opening = [], opening
        edges, omega = tangential_path(system), float(values["omega"])
        velocities = np.asarray(velocities, float)
        state, periods = None, SETTLING
        for steps in STEPS[opening]:
            bounds = bounds_of(system, values, steps, means, opening)
            contact = Contact(edges, omega, steps)
            if state is None:
                shape = len(contact.nodes.names), len(velocities)
                state = np.zeros(shape), np.zeros(shape)
            mean, state = steady(contact, bounds, velocities, state, periods)
            self.means.append(mean)
            periods = FINER
        self.change = max(mean.change for mean in self.means)

    def extrapolated(self, value):
        return extrapolated([value(mean) for mean in self.means], self.opening)

    def ratio(self):
        best, error = self.extrapolated(lambda mean: mean.force / mean.bound)
        # What has not yet settled at one number of steps goes on for some 30 such changes at most.
        return best, error + 30 * self.change

    def regime(self, *lanes):
        return self.means[-1].regime(lanes)


def simulated_onset(system, values, means, opening, all_steps=STEPS[True]):
    """v* of each mean indentation: the largest speed against the drive that sliding has while the contact is closed.

    It may be at the first step of touching, which comes late by a part of a step: the error has what one step changes.
    """
    found = []
    for steps in all_steps:
        bounds = bounds_of(system, values, steps, means, opening)
        velocity = -Contact(tangential_path(system), float(values["omega"]), steps).sliding(bounds)
        touching = np.where(bounds > 0, velocity, -np.inf)
        at, lanes = np.argmax(touching, axis=0), np.arange(len(means))
        change = np.abs(touching[at, lanes] - velocity[(at + 1) % steps, lanes])
        found.append([touching[at, lanes], bounds.mean(axis=0)])
    best, error = extrapolated(found, True, all_steps)
    error[0] += change
    return best, error


def simulated_sensitivities(name, values, means, opening, at):
    """(p/v*) dv*/dp by central differences of 4 %; what those of 8 % differ by tells how far v* bends."""
    for key, value in values.items():
        if isinstance(value, list) or is_found(key, values):
            continue
        slopes, errors = [], []
        for width in ("0.04", "0.08"):
            found = []
            for factor in (1 + mp.mpf(width), 1 - mp.mpf(width)):
                changed = values | {key: value * factor}
                if "W" in values:
                    changed |= found_depth(name, changed)
                new_means = means_of(changed)
                found.append(simulated_onset(moving(name, changed), changed, new_means, opening, DIFFERENCE_STEPS))
            (one, one_error), (two, two_error) = found
            distance = np.log((1 + float(width)) / (1 - float(width)))
            slopes.append(np.log(one[0][0] / two[0][0]) / distance)
            errors.append((one_error[0][0] + two_error[0][0]) / at / distance)
        # The difference errs by the third derivative, some step^2 times a few, and twice the step by four times that.
        bend = 5 * 0.04**2 * max(1, abs(slopes[0])) + abs(slopes[1] - slopes[0]) / 2
        yield f"simulated_sensitivity:{key}", slopes[0], errors[0] + bend


def friction_rows(name, values, text, linear):
    if "indenter" in text:
        yield from cell_rows(name, values, text, linear)
        return
    if name in ("separating_mount", "separating_with_mass"):
        return
    system = moving(name, values)
    if not linear["loaded"] or not text.get("oscillation") or not is_simulated(system):
        return
    opening = bool(text["contact"].get("separation")) and not linear["closed"]
    # Under a load an amplitude that is small enough leaves every contact closed.
    if "W" in values or "u_z0" not in values or values["u_z0"] > 0:
        yield from design_rows(name, design_values(name, values, linear))
    else:
        yield from tapping_design_rows(system, values)
    if not linear["closed"] and not opening:
        return
    means = means_of(values)
    onset, creep = float(linear["formula"]), float(linear["creep_over_mean_force"])
    if opening:
        if name in ("separation_free_harmonic", "separation_jump"):
            yield "critical_velocity", "inf", 0
            onset = float(values["mu0"] * values["omega"] * values["du_z"])
        else:
            best, error = simulated_onset(system, values, means, opening)
            onset = best[0][0]
            yield "critical_velocity", onset, error[0][0] + system.fit_error * onset
            # The drive runs ahead by the mean force over what creeps.
            slip = creep / float(values["mu0"])
            yield "drive_velocity", onset + slip * best[1][0], error[0][0] + slip * error[1][0] + system.fit_error * onset
            yield from simulated_sensitivities(name, values, means, opening, onset)
        if system.mount:
            at_rest = float(mp.re(stiffness(system.mount, mp.mpf(10) ** -60)))
            depth, error = extrapolated([[below_mount(system, values, float(values["omega"]), steps)[0]] for steps in STEPS[True]], True)
            yield "indentation", depth[0] - float(values["W"]) / at_rest, error[0]
    speed = speed_unit(onset, creep, system, values)
    if opening and name not in ("separation_free_harmonic", "separation_jump"):
        speed = onset + slip * best[1][0]
    yield from friction_at(system, values, means, opening, speed)


def speed_unit(onset, creep, system, values):
    if onset == 0:
        return 1e-3
    if onset == float("inf") or onset > 1e3:
        return 0.01
    return onset + creep * mean_forces(system, values, means_of(values))[0]


def friction_at(system, values, means, opening, speed):
    velocities = [ratio * speed for ratio in RATIOS]
    motions = Motions(system, values, np.repeat(means, len(RATIOS)), opening, velocities)
    ratio, error = motions.ratio()
    error = error + system.fit_error
    period = 2 * np.pi / float(values["omega"])
    force, force_error = motions.extrapolated(lambda mean: mean.force / mean.steps)
    normal, normal_error = motions.extrapolated(lambda mean: mean.bound / mean.steps / float(values["mu0"]))
    heat, heat_error = motions.extrapolated(lambda mean: mean.heat / mean.steps * period)
    for i, velocity in enumerate(velocities):
        yield f"velocity:{i}", velocity, 0
        yield f"friction_ratio:{i}", ratio[i], error[i]
        regime = motions.regime(i)
        if regime == "stick-slip" and ratio[i] > 1 - 1e-5:
            # Full friction with stick is a swing that the steps damp: steady below v* it is in exact resonance alone.
            regime = "sliding" if swings_freely(system, values) else "stick-slip"
        yield f"regime:{i}", regime, 0
        yield f"mean_normal_force:{i}", normal[i], normal_error[i]
        # Relative to what friction would be without vibration, as the ratio.
        fit_error = system.fit_error * float(values["mu0"]) * normal[i] * velocity * period
        yield f"energy_drive:{i}", force[i] * velocity * period, force_error[i] * velocity * period + fit_error
        yield f"energy_friction:{i}", heat[i], heat_error[i] + fit_error


def design_values(name, values, linear):
    """The scene with an amplitude that leaves the contact closed, and beside an antiresonance."""
    if not linear["closed"]:
        given = "U" if "U" in values else "du_z"
        values = values | {given: min(values[given], linear["admissible_amplitude"] * mp.mpf("0.6"))}
    if "W" in values:
        values = values | found_depth(name, values)
    if name == "antiresonance":
        values = values | {"omega": values["omega"] * mp.mpf("0.7")}
    return values


def design_rows(name, values):
    """The friction ratio at a speed, and how it changes with each unknown."""
    system = moving(name, values)
    means = means_of(values)
    onset = formula_of(system, values)
    mean = mean_forces(system, values, means)[0]
    velocity = 0.005 if onset > 1e3 else onset / 2 + creep_of(system, values) * mean
    motions = Motions(system, values, np.repeat(means, 3), False, velocity * np.array([1, 1.02, 0.98]))
    ratio, error = motions.ratio()
    yield "design:velocity", velocity, 0
    given = "U" if "U" in values else "du_z"
    yield "design:amplitude", float(values[given]), 0
    yield "design:omega", float(values["omega"]), 0
    yield "design:friction_ratio", ratio[0], error[0] + system.fit_error
    yield "design:slope:velocity", (ratio[1] - ratio[2]) / (0.04 * velocity), (error[1] + error[2]) / (0.04 * velocity)
    unknowns = [("amplitude", given), ("frequency", "omega")] + ([("force", "W")] if "W" in values else [])
    for unknown, key in unknowns:
        ends, errors = [], []
        for factor in ("1.02", "0.98"):
            changed = values | {key: values[key] * mp.mpf(factor)}
            if key == "W":
                changed |= found_depth(name, changed)
                means = means_of(changed)
            best, worst = Motions(moving(name, changed), changed, means, False, [velocity]).ratio()
            ends.append(best[0])
            errors.append(worst[0])
        width = 0.04 * float(values[key])
        yield f"design:slope:{unknown}", (ends[0] - ends[1]) / width, sum(errors) / width


def tapping_design_rows(system, values):
    """Of springs that no amplitude keeps closed, under a rigid drive: friction depends on v/(omega du_z) alone."""
    velocity = formula_of(system, values) / 2
    motions = Motions(system, values, np.zeros(3), True, velocity * np.array([1, 1.02, 0.98]))
    ratio, error = motions.ratio()
    yield "design:velocity", velocity, 0
    yield "design:amplitude", float(values["du_z"]), 0
    yield "design:friction_ratio", ratio[0], error[0]
    yield "design:omega", float(values["omega"]), 0
    slope, uncertain = (ratio[1] - ratio[2]) / (0.04 * velocity), (error[1] + error[2]) / (0.04 * velocity)
    yield "design:slope:velocity", slope, uncertain
    change = velocity / float(values["omega"])
    yield "design:slope:frequency", -slope * change, uncertain * change


def swings_freely(system, values):
    """Whether body and drive swing freely at a harmonic of the oscillation, but for the rounding of their numbers."""
    if system.drive is None:
        return False
    for n in (2, 3):
        s = 1j * n * values["omega"]
        inertia = system.mass * s**2
        if abs(stiffness(system.drive, s) + inertia) <= mp.mpf(10) ** -14 * abs(inertia):
            return True
    return False


def is_simulated(system):
    """Networks of springs, dampers and masses."""
    networks = [system.normal, None if system.ratio else system.tangential, system.drive, system.mount]
    if any(isinstance(network, str) for network in networks):
        return False
    return all(edge[0] in "kcm" for network in networks if network for edge in network("a", "b"))


def formula_of(system, values):
    omega = values["omega"]
    normal = stiffness(system.normal, 1j * omega)
    compliance = 1 / (system.ratio * normal if system.ratio else stiffness(system.tangential, 1j * omega))
    if system.drive is not None:
        try:
            drive = stiffness(system.drive, 1j * omega) - system.mass * omega**2
        except ZeroDivisionError:  # an absorber: infinite
            drive = mp.inf
        if drive == 0:
            return float("inf")
        compliance += 1 / drive
    return float(values["mu0"] * omega * height(system, values) * abs(normal * compliance))


def creep_of(system, values):
    contact = 1 / creep_viscosity(system.normal if system.ratio else system.tangential) / (system.ratio or 1)
    return float(values["mu0"] * (contact + (1 / creep_viscosity(system.drive) if system.drive else 0)))
