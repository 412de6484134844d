#!/usr/bin/python3
"""Writes opening_friction.csv: steady friction of contacts that open, to 20 digits.

It shares nothing with the program. In each motion (apart; touching in stick, slip or backslip) all is
one linear system X' = M X with X = (1, cos t, sin t, normal network, tangential network, body and
drive, integrals of F and F_n), propagated by matrix exponentials at 34 digits; networks are springs,
dampers and Maxwell branches, never Kelvin units. It is marched from rest on a grid of 2 pi/512, an
event sought where its function changes sign in a step, until friction and normal force of one period
after the other agree to 24 digits. omega = 1; the drive moves at v, the indentation is
mean + amplitude cos t, F_n = max(0, reaction), and where the surfaces meet the contact carries no
force, or with a direct damper what holds the contact point, if the bound mu F_n allows.

Columns: name; tangential, normal and drive network as "k_inf c k:tau k:tau ...", drive empty without;
mass, empty without; mean, amplitude, mu, velocity; friction_ratio = <F>/(mu <F_n>); regime.
Needs mpmath.
"""

import csv
from pathlib import Path

from mpmath import expm, matrix, mp, mpf, nstr, pi

mp.dps = 34
STEPS = 512
H = 2 * pi / STEPS

# name, tangential, normal, drive, mass, mean, amplitude, mu, velocity
CASES = [
    ("elastic a little open", "1 0", "1 0", "", "", 1, "1.25", 1, "0.6"),
    ("elastic far open and slow", "1 0", "1 0", "", "", 1, 10, 1, 1),
    ("elastic far open and fast", "1 0", "1 0", "", "", 1, 10, 1, 9),
    ("elastic from above", "1 0", "1 0", "", "", "-0.5", 1, 1, "0.3"),
    ("Kelvin", "1 0.3", "1 0.3", "", "", 1, 3, "0.5", "0.6"),
    ("Zener", "0.8 0 1.6:0.7", "1 0 2:0.7", "", "", 1, 3, "0.5", "0.6"),
    ("Zener on an elastic foundation", "1 0", "1 0 2:0.7", "", "", 1, 3, "0.5", "0.4"),
    ("normal damper on a Zener foundation", "0.8 0 1.6:0.7", "1 0.3", "", "", 1, 3, "0.5", "0.6"),
    ("Kelvin foundation without normal damper", "1 0.4", "1 0 1:0.5", "", "", 1, "2.5", "0.5", "0.7"),
    ("two branches", "1 0 0.5:0.2 0.7:3", "1 0 0.6:0.3 1:2", "", "", 1, 2, "0.5", "0.4"),
    ("body on a Kelvin drive", "1 0.1", "1 0 2:0.7", "2 0.1", "0.5", 1, 3, "0.5", "0.6"),
    ("body on a Kelvin drive and slow", "1 0", "1 0", "1 0.3", "1.5", 1, 3, "0.5", "0.1"),
    ("body on a Zener drive", "1 0 0.5:2", "1 0.2 2:0.7", "2 0.2 1:1.5", 2, 1, "2.2", "0.5", "0.6"),
    ("body with rates of the normal network", "1 0", "1 0 2:0.5", "0.5 2 1:0.5", "0.25", 1, 3, "0.5", "0.5"),
]


def parsed(text):
    k, c, *branches = text.split()
    return mpf(k), mpf(c), [tuple(mpf(x) for x in branch.split(":")) for branch in branches]


class System:
    def __init__(self, tangential, normal, drive, mass, mean, amplitude, mu, velocity):
        self.t, self.n = parsed(tangential), parsed(normal)
        self.d = parsed(drive) if drive else None
        self.mass = mpf(mass) if drive else None
        self.mean, self.amplitude, self.mu, self.v = (mpf(x) for x in (mean, amplitude, mu, velocity))
        names = ["1", "cos", "sin"]
        names += ["en"] + [f"n{i}" for i in range(len(self.n[2]))]
        names += ["et"] + [f"t{i}" for i in range(len(self.t[2]))]
        if self.d:
            names += ["u", "ed"] + [f"d{i}" for i in range(len(self.d[2]))]  # u: body less drive
        names += ["F", "Fn"]
        self.at = {name: i for i, name in enumerate(names)}
        self.motions = {motion: self.system(motion) for motion in ("apart", "stick", "slip", "backslip")}
        self.steps = {motion: expm(m * H) for motion, (m, _, _) in self.motions.items()}

    def row(self, **entries):
        result = matrix(1, len(self.at))
        for name, value in entries.items():
            result[0, self.at[{"one": "1"}.get(name, name)]] = mpf(value)
        return result

    def network(self, of, deformation, rate, m, name):
        """Puts branches and deformation at a given rate into m; the force as a row."""
        k, c, branches = of
        m[self.at["e" + name], :] = rate
        force = k * deformation + c * rate
        for i, (stiffness, tau) in enumerate(branches):
            own = self.row(**{f"{name}{i}": 1})
            m[self.at[f"{name}{i}"], :] = stiffness * rate - own / tau
            force = force + own
        return force

    def rate_under(self, of, force, force_rate, name):
        """The rate of deformation that gives a force."""
        k, c, branches = of
        own = k * self.row(**{"e" + name: 1})
        for i in range(len(branches)):
            own = own + self.row(**{f"{name}{i}": 1})
        if c > 0:
            return (force - own) / c
        # F' = (k + sum k_i) e' - sum f_i/tau_i
        lost, stiffness = force_rate, k
        for i, (ki, tau) in enumerate(branches):
            lost = lost + self.row(**{f"{name}{i}": 1}) / tau
            stiffness += ki
        return lost / stiffness

    def system(self, motion):
        """M, with the rows of F and of F_n."""
        size = len(self.at)
        m, nothing = matrix(size, size), matrix(1, size)
        m[1, 2], m[2, 1] = -1, 1
        if motion == "apart":
            rate = self.rate_under(self.n, nothing, nothing, "n")
            self.network(self.n, self.row(en=1), rate, m, "n")
            normal = nothing
        else:
            sinking = self.row(sin=-self.amplitude)
            normal = self.network(self.n, self.row(en=1), sinking, m, "n")
        top = self.row(one=self.v)
        if self.d:
            top = top + self.row(u=1)
        if motion == "stick":
            force = self.network(self.t, self.row(et=1), top, m, "t")
        else:
            side = {"slip": 1, "backslip": -1, "apart": 0}[motion]
            force = side * self.mu * normal
            rate = self.rate_under(self.t, force, force * m, "t")
            self.network(self.t, self.row(et=1), rate, m, "t")
        if self.d:
            held = self.network(self.d, self.row(ed=1), self.row(u=1), m, "d")
            m[self.at["u"], :] = -(force + held) / self.mass
        m[self.at["F"], :] = force
        m[self.at["Fn"], :] = normal
        return m, force, normal

    def velocity(self, motion, x):
        """Of the contact point."""
        top = self.v + (x[self.at["u"]] if self.d else 0)
        return top - (self.motions[motion][0] * x)[self.at["et"]]

    def ends(self, motion, x):
        """Functions > 0 that end a motion where they reach 0."""
        m, force, normal = self.motions[motion]
        if motion == "apart":
            depth = self.mean + self.amplitude * x[1]
            return [("met", x[self.at["en"]] - depth)]
        reaction = (normal * x)[0]
        if motion == "stick":
            f = (force * x)[0]
            return [("parted", reaction), ("slip", self.mu * reaction - f), ("backslip", self.mu * reaction + f)]
        side = 1 if motion == "slip" else -1
        return [("parted", reaction), ("stick", side * self.velocity(motion, x))]

    def met(self, x):
        """The motion that begins where the surfaces meet."""
        if self.t[1] == 0 and self.n[1] > 0:
            return "stick"  # F is 0, F_n is not
        for motion, side in (("slip", 1), ("backslip", -1)):
            if side * self.velocity(motion, x) > 0:
                return motion
        return "stick"


def march(system):
    x = matrix(len(system.at), 1)
    x[0], x[1] = 1, -1
    t, motion, regime, before = -pi, "apart", set(), None
    for period in range(400):
        x[system.at["F"]] = x[system.at["Fn"]] = 0
        regime.clear()
        for step in range(STEPS):
            left = H
            while left > 0:
                m = system.motions[motion][0]
                y = system.steps[motion] * x if left == H else moved(m, left, x)
                now = dict(system.ends(motion, x))
                name, passed = crossing(system, motion, x, y, left, now)
                if name is None:
                    x = y
                    break
                x, left = moved(m, passed, x), left - passed
                motion = {"met": None, "parted": "apart"}.get(name, name)
                regime.add(motion) if motion else None
                if name == "met":
                    x[system.at["en"]] = system.mean + system.amplitude * x[1]
                    motion = system.met(x)
                    regime.add(motion)
        ratio = x[system.at["F"]] / (system.mu * x[system.at["Fn"]])
        if before is not None and abs(ratio - before) < mpf(10) ** -24:
            return ratio, regime
        before = ratio
    raise RuntimeError("no steady state")


def moved(m, t, x):
    """e^{m t} x by its series, for a fraction of a step."""
    term = total = x
    for k in range(1, 200):
        term = (m * term) * (t / k)
        total = total + term
        if max(abs(value) for value in term) < mpf(10) ** -40:
            return total
    raise RuntimeError("the step is too long")


# What begins at zero within rounding has begun there.
TINY = mpf(10) ** -28


def crossing(system, motion, x, y, left, now):
    """The first of the functions to reach 0 within what is left of a step, and when."""
    first, best = None, None
    for name, value in system.ends(motion, y):
        if value >= 0 or (now[name] <= TINY and leaving(system, motion, x, name)):
            continue
        place = located(system, motion, x, left, name) if now[name] > TINY else mpf(0)
        if best is None or place < best:
            first, best = name, place
    return first, best


def leaving(system, motion, x, name):
    """Whether a function that is 0 at x grows from there."""
    later = moved(system.motions[motion][0], mpf(10) ** -10, x)
    return dict(system.ends(motion, later))[name] > 0


def located(system, motion, x, left, name):
    """The zero in (0, left] by the Illinois method."""
    m = system.motions[motion][0]
    f = lambda t: dict(system.ends(motion, moved(m, t, x)))[name]
    a, b, fa, fb = mpf(0), left, f(mpf(0)), f(left)
    for _ in range(100):
        c = b - fb * (b - a) / (fb - fa)
        fc = f(c)
        if abs(fc) < mpf(10) ** -33 or abs(b - a) < mpf(10) ** -32:
            return c
        if fc * fb < 0:
            a, fa = b, fb
        else:
            fa = fa / 2
        b, fb = c, fc
    raise RuntimeError("an event was not found")


def main():
    with open(Path(__file__).with_suffix(".csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow("name tangential normal drive mass mean amplitude mu velocity friction_ratio regime".split())
        for case in CASES:
            ratio, regime = march(System(*case[1:]))
            print(case[0], nstr(ratio, 20), sorted(regime), flush=True)
            table.writerow([*case, nstr(ratio, 20), " ".join(sorted(regime))])
            file.flush()


if __name__ == "__main__":
    main()
