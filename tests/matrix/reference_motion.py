"""Stick-slip by implicit time steps of the nodal equations, for make_references.py: nothing of the program is used.

All steps are of first order, of constant length, and know no events: in each, the massless contact point either keeps
its place or takes the force that Coulomb's law allows, and the contact is either closed or bears no force. A value is
extrapolated from three step lengths, and its error is what the extrapolation still changes. Lanes (columns) are
motions side by side that differ in speed or indentation.
"""

import numpy as np

STEPS = {False: (2000, 4000, 8000),
         True: (1000, 1300, 1600, 2000, 2500, 3200, 4000, 5000, 6400)}  # a period; of a contact that opens
# A period repeats where its mean force, over the bound, changes by less.
REPEATS = 1e-8
# The most periods until a normal force repeats.
PERIODS = 30


class Nodes:
    """Stiffness, damping and masses of the nodes of a network whose node "far" stands still."""

    def __init__(self, edges, first):
        names = [first]
        for _, _, *ends in edges:
            names += [end for end in ends if end not in names and end != "far"]
        self.names = names
        size = len(names)
        self.matrices = {what: np.zeros((size, size)) for what in "kcm"}
        for what, value, left, right in edges:
            self.add(self.matrices[what], float(value), left, right)

    def add(self, matrix, value, left, right):
        for one, other in ((left, right), (right, left)):
            if one != "far":
                matrix[self.names.index(one), self.names.index(one)] += value
                if other != "far":
                    matrix[self.names.index(one), self.names.index(other)] -= value

    def step(self, h):
        """The inverse of what velocities at the end of a step are multiplied by, and the matrices that make its right side."""
        k, c, m = (self.matrices[what] for what in "kcm")
        return np.linalg.inv(k * h + c + m / h), k, m / h


def normal_forces(edges, omega, mean, amplitude, steps):
    """Reactions of one steady period, a row a step; `mean` is an array, a lane for each."""
    nodes = Nodes(edges, "surface")
    h = 2 * np.pi / omega / steps
    inverse, k, _ = nodes.step(h)
    own = inverse[:, :1]
    z = np.zeros((len(nodes.names), len(mean)))
    depths = [mean + amplitude * np.cos(2 * np.pi * (i + 1) / steps) for i in range(steps)]
    z[:] = mean + amplitude
    before = np.zeros((steps, len(mean)))
    for _ in range(PERIODS):
        forces = np.empty_like(before)
        for i, depth in enumerate(depths):
            free = -inverse @ (k @ z)
            forces[i] = np.maximum(0.0, ((depth - z[0]) / h - free[0]) / own[0])
            z += h * (free + own * forces[i])
        if np.max(np.abs(forces - before)) < 1e-10 * np.max(forces):
            break
        before = forces
    return forces


class Contact:
    """The contact point "contact", pulled over the ground by the end "far" of a network, in whose frame all is written."""

    def __init__(self, edges, omega, steps):
        self.nodes = Nodes(edges, "contact")
        self.h = 2 * np.pi / omega / steps
        self.inverse, self.k, self.m = self.nodes.step(self.h)
        self.has_mass = bool(np.any(self.m))
        self.own = self.inverse[:, :1]

    def period(self, x, w, bounds, velocities, record=None):
        """The state after one period, and the sum of the forces in it."""
        total = 0.0
        for bound in bounds:
            right = -(self.k @ x)
            if self.has_mass:
                right += self.m @ w
            free = self.inverse @ right
            force = np.minimum(np.maximum((free[0] + velocities) / self.own[0], -bound), bound)
            w = free - self.own * force
            x = x + self.h * w
            total = total + force
            if record is not None:
                record(force, w[0] + velocities, bound)
        return (x, w), total

    def sliding(self, bounds):
        """The oscillating velocity of the contact point under forces that repeat, by the steps' own compliance at each harmonic."""
        steps = len(bounds)
        c = self.nodes.matrices["c"]
        back = 1 - np.exp(-2j * np.pi * np.arange(1, steps) / steps)
        rate = (back / self.h)[:, None, None]
        mass = self.nodes.matrices["m"] * rate**2
        unit = np.zeros((steps - 1, len(c), 1), complex)
        unit[:, 0] = 1
        compliance = np.linalg.solve(self.k + c * rate + mass, unit)[:, 0, 0]
        spectrum = np.fft.fft(bounds, axis=0)
        spectrum[0] = 0
        spectrum[1:] *= -(compliance * back / self.h)[:, None]
        return np.fft.ifft(spectrum, axis=0).real


class Mean:
    """What one period leaves: mean force, friction's heat, and which phases there were."""

    def __init__(self, lanes):
        self.force, self.heat, self.bound, self.steps = np.zeros(lanes), np.zeros(lanes), np.zeros(lanes), 0
        self.phases = [set() for _ in range(lanes)]

    def __call__(self, force, velocity, bound):
        self.force, self.heat, self.bound = self.force + force, self.heat + force * velocity, self.bound + bound
        self.steps += 1
        bound = np.broadcast_to(bound, force.shape)
        for i, phases in enumerate(self.phases):
            if bound[i] <= 0:
                phases.add("apart")
            elif abs(force[i]) < bound[i] * (1 - 1e-12):
                phases.add("stick")
            else:
                phases.add("slip" if force[i] > 0 else "backslip")

    def regime(self, lanes):
        """Of some motions side by side."""
        phases = set().union(*(self.phases[lane] for lane in lanes))
        if not phases & {"slip", "backslip"}:
            return "stick"
        name = "stick-slip" if "stick" in phases else "sliding"
        return name + ("-backslip" if "backslip" in phases else "") + ("-apart" if "apart" in phases else "")


def steady(contact, bounds, velocities, state, periods, least=2):
    """State and means of a period that repeats: at most so many, until the mean force changes by less than REPEATS."""
    before = np.inf
    for i in range(periods):
        state, force = contact.period(*state, bounds, velocities)
        change = np.max(np.abs(force - before) / np.sum(bounds, axis=0).clip(1e-300))
        if i >= least and change < REPEATS:
            break
        before = force
    mean = Mean(len(velocities))
    mean.change = change
    state, _ = contact.period(*state, bounds, velocities, mean)
    return mean, state


def extrapolated(values, opening=False, steps=None):
    """What values at numbers of steps tend to, and an error.

    Steps err by first order in their length. Of a contact that stays closed N, 2N, 4N steps are extrapolated, and the
    error is twice what that moved, or a part of what the last halving did. Where the contact opens, each meeting falls
    between two steps, which adds as much at random: a line is laid through many N, each as far off as its step is long;
    the error is four standard deviations and what a parabola changes. Rounding of some thousand steps is below 1e-13.
    """
    values = np.asarray(values, float)
    if not opening:
        coarse, middle, fine = values
        best = 2 * fine - middle
        error = np.maximum(2 * np.abs(best - (2 * middle - coarse)), np.abs(fine - middle) / 20)
    else:
        h = 1 / np.array(steps or STEPS[True], float)
        design = np.stack([1 / h, np.ones_like(h), h], axis=1)
        flat = (values.reshape(len(h), -1).T / h).T
        parabola, (line, left, _, _) = (np.linalg.lstsq(part, flat, rcond=None) for part in (design, design[:, :2]))
        deviation = np.sqrt(left / (len(h) - 2) * np.linalg.inv(design[:, :2].T @ design[:, :2])[0, 0])
        best = line[0].reshape(values.shape[1:])
        error = (4 * deviation + np.abs(line[0] - parabola[0][0])).reshape(values.shape[1:])
    return best, error + 1e-13 * np.abs(best)
