#!/usr/bin/env python3
"""Writes scenes_expected.csv: what every scene in scenes/ must evaluate to, at 50 digits.

It shares nothing with the program: scenes are read by Python's own TOML parser, every network is
laid out as a graph of springs, dampers and masses and solved by nodal analysis (Gaussian elimination on the
nodal stiffness matrix in 250-digit complex arithmetic), and Eq. (24), (3), (4) and the creep velocity
are written down here once more. Columns:

  scene, critical_velocity (m/s, 50 digits), admissible (true/false),
  creep_velocity (m/s, 50 digits: mu0 <F_n> (1/eta_t + 1/eta_d), 0 where all paths carry a static load)

Needs mpmath; run it as  tests/data/scenes_expected.py > tests/data/scenes_expected.csv
"""

import csv
import re
import sys
import tomllib
from pathlib import Path

from mpmath import mp, mpc, mpf, nstr, pi

mp.dps = 250
SCENES = Path(__file__).resolve().parents[2] / "scenes"

UNITS = {
    "N/um": "1e6", "N/mm": "1e3", "kN/m": "1e3", "N/m": "1",
    "N.s/m": "1", "kg/s": "1", "N s/mm": "1e3", "mN.s/um": "1e3", "kN us/mm": "1",
    "N": "1", "kN": "1e3", "mN": "1e-3", "kg": "1", "g": "1e-3", "mg": "1e-6", "MHz": "1e6", "kHz": "1e3", "Hz": "1", "rad/s": "1", "rad/ms": "1e3",
    "mm": "1e-3", "um": "1e-6", "nm": "1e-9", "m": "1", "s": "1", "ms": "1e-3", "us": "1e-6", "ns": "1e-9",
    "GPa": "1e9", "MPa": "1e6", "N/mm2": "1e6", "Pa": "1", "kPa.s": "1e3", "Pa s": "1", "MPa.ms": "1e3",
}


def quantity(value):
    """A TOML value as SI: 'NUMBER UNIT' exactly as it is typed, a bare number as the double of it."""
    if not isinstance(value, str):
        return mpf(float(value))
    number, unit = value.split(maxsplit=1)
    return mpf(number) * mpf(UNITS[unit])


class Layout:
    """Springs and dampers between nodes; node 0 and node 1 are the terminals."""

    def __init__(self):
        self.edges = []  # (function of s, node, node)
        self.nodes = 2

    def node(self):
        self.nodes += 1
        return self.nodes - 1

    def stiffness(self, s):
        """K(s) between the terminals: unit displacement of node 0 against node 1."""
        n = self.nodes
        a = [[mpc(0)] * n for _ in range(n)]
        for k, i, j in self.edges:
            value = k(s)
            a[i][i] += value
            a[j][j] += value
            a[i][j] -= value
            a[j][i] -= value
        for pivot in range(n - 1, 1, -1):  # eliminate the inner nodes
            for i in range(pivot):
                factor = a[i][pivot] / a[pivot][pivot]
                for j in range(pivot):
                    a[i][j] -= factor * a[pivot][j]
        return a[0][0]


class Reader:
    """Expressions of a scene's networks, written into a layout."""

    def __init__(self, elements, networks):
        self.elements = elements
        self.networks = networks

    def spring(self, name):
        k = quantity(self.elements[name])
        return lambda s: mpc(k)

    def damper(self, name):
        c = quantity(self.elements[name])
        return lambda s: c * s

    def element(self, name):
        return self.spring(name) if name.startswith("k") else self.damper(name)

    def network(self, text):
        layout = Layout()
        self.place(self.parse(text), layout, 0, 1)
        return layout

    # Grammar: parallel := series ('|' series)*, series := part ('-' part)*.
    def parse(self, text):
        tokens = re.findall(r"[A-Za-z_]\w*|[|\-(),]", text)

        def parallel():
            parts = [series()]
            while tokens and tokens[0] == "|":
                tokens.pop(0)
                parts.append(series())
            return ("parallel", parts)

        def series():
            parts = [part()]
            while tokens and tokens[0] == "-":
                tokens.pop(0)
                parts.append(part())
            return ("series", parts)

        def part():
            token = tokens.pop(0)
            if token == "(":
                inner = parallel()
                assert tokens.pop(0) == ")"
                return inner
            if tokens and tokens[0] == "(":
                tokens.pop(0)
                arguments = []
                while tokens[0] != ")":
                    if tokens[0] != ",":
                        arguments.append(tokens[0])
                    tokens.pop(0)
                tokens.pop(0)
                return ("named", token, arguments)
            return ("name", token)

        tree = parallel()
        assert not tokens, tokens
        return tree

    def place(self, tree, layout, a, b):
        kind = tree[0]
        if kind == "parallel":
            for part in tree[1]:
                self.place(part, layout, a, b)
        elif kind == "series":
            ends = [a] + [layout.node() for _ in tree[1][1:]] + [b]
            for part, left, right in zip(tree[1], ends, ends[1:]):
                self.place(part, layout, left, right)
        elif kind == "named":
            self.named(tree[1], tree[2], layout, a, b)
        elif tree[1] in self.networks:
            self.graph(self.networks[tree[1]], layout, a, b)
        else:
            layout.edges.append((self.element(tree[1]), a, b))

    def named(self, name, p, layout, a, b):
        def spring(k, i, j):
            layout.edges.append((self.spring(k), i, j))

        def damper(c, i, j):
            layout.edges.append((self.damper(c), i, j))

        if name == "mass":  # to inertial ground: one of its ends is the far end of the drive
            m = quantity(self.elements[p[0]])
            layout.edges.append(((lambda s: m * s**2), a, b))
        elif name == "spring":
            spring(p[0], a, b)
        elif name == "damper":
            damper(p[0], a, b)
        elif name == "kelvin":
            spring(p[0], a, b)
            damper(p[1], a, b)
        elif name == "zener":
            middle = layout.node()
            spring(p[0], a, b)
            spring(p[1], a, middle)
            damper(p[2], middle, b)
        elif name == "burgers":  # a Maxwell element in series with a Kelvin element
            first, second = layout.node(), layout.node()
            spring(p[0], a, first)
            damper(p[1], first, second)
            spring(p[2], second, b)
            damper(p[3], second, b)
        elif name == "prony":
            spring(p[0], a, b)
            for k, tau in zip(self.elements[p[1]], self.elements[p[2]]):
                middle = layout.node()
                layout.edges.append(((lambda s, k=quantity(k): mpc(k)), a, middle))
                layout.edges.append(((lambda s, c=quantity(k) * quantity(tau): c * s), middle, b))
        else:
            raise ValueError(name)

    def graph(self, graph, layout, a, b):
        nodes = dict(zip(graph["terminals"], (a, b)))
        nodes.setdefault("ground", b)  # to an oscillation the far end stands still, too
        for name, left, right in graph["edges"]:
            for end in (left, right):
                if end not in nodes:
                    nodes[end] = layout.node()
            self.place(self.parse(name), layout, nodes[left], nodes[right])


# K(s) = k + c s + ... at a frequency so low that the next terms are beyond 50 digits, while the 250
# digits of the arithmetic still carry both the stiff elements and c s, about 80 decades apart.
SLOW = mpf(10) ** -70


def static_stiffness(layout):
    k = layout.stiffness(mpc(0, SLOW)).real
    return k if k > mpf(10) ** -30 else mpf(0)


def viscosity(layout):
    """eta of a network that carries no static load: K(s) ~ eta s."""
    return layout.stiffness(mpc(0, SLOW)).imag / SLOW


def measured(file, omega):
    """1/R(i omega) from a table, real and imaginary part linear between two rows."""
    with file.open() as table:
        rows = [[mpf(float(cell)) for cell in row] for row in list(csv.reader(table))[1:]]
    for (w0, *r0), (w1, *r1) in zip(rows, rows[1:]):
        if w0 <= omega <= w1:
            return 1 / ((mpc(*r0) * (w1 - omega) + mpc(*r1) * (omega - w0)) / (w1 - w0))
    raise ValueError("outside the table")


def angular_frequency(oscillation):
    """2 pi times the frequency, of a bare one times its double."""
    if "angular_frequency" in oscillation:
        return quantity(oscillation["angular_frequency"])
    return 2 * pi * quantity(oscillation["frequency"])


def of_held_sphere(scene):
    """Numbers of an elastic parabola on a leaf spring, by the names of tests/matrix/reference_held.py; radius; nu."""
    assert scene["contact"]["normal"] == "spring(E0)" and scene["drive"]["network"] == "kd | cd"
    assert scene["indenter"]["shape"] == "parabola"
    oscillation = scene["oscillation"]
    values = {name: quantity(value) for name, value in scene["elements"].items()}
    values |= {"mu0": quantity(scene["friction"]["coefficient"]), "omega": angular_frequency(oscillation),
               "du_z": quantity(oscillation["amplitude"]), "m": quantity(scene["body"]["mass"]),
               "W": quantity(scene["load"]["force"])}
    return values, quantity(scene["indenter"]["radius"]), quantity(scene["contact"]["poisson"])


def evaluate_held_sphere(scene):
    """The same of an indenter on a drive that gives: v* is the largest value of a speed over the phase."""
    sys.path.append(str(SCENES.parent / "tests/matrix"))
    import reference_held
    with mp.workdps(80):
        values, radius, nu = of_held_sphere(scene)
        depth = reference_held.depth_under_load(values, radius, nu)
        velocity = reference_held.sliding_velocity(values, radius, nu)
        # Its harmonics fall by this each, and none is left out before 50 digits.
        ratio = values["du_z"] / depth
        assert (ratio / (1 + mp.sqrt(1 - ratio**2))) ** reference_held.HARMONICS < mpf(10) ** -52
        return velocity, values["du_z"] < depth, mpf(0)


def evaluate(scene, folder=SCENES):
    """Critical velocity, whether it is admissible, creep velocity; the names of tables begin at `folder`."""
    if "indenter" in scene and "drive" in scene:
        return evaluate_held_sphere(scene)
    reader = Reader(scene["elements"], scene.get("networks", {}))
    contact, oscillation = scene["contact"], scene["oscillation"]
    omega = angular_frequency(oscillation)
    s = mpc(0, omega)
    du = quantity(oscillation["amplitude"])
    mu = quantity(scene["friction"]["coefficient"])

    normal = reader.network(contact["normal"])
    kn = normal.stiffness(s)
    if "mount" in scene:  # du is the vibrator's: what the mount leaves of it at the contact
        mount = reader.network(scene["mount"]["network"]).stiffness(s)
        moving = quantity(scene["mount"].get("mass", 0)) * omega**2
        assert abs(mount + kn - moving) > 0.05 * moving, "too near the mount's resonance"
        du *= abs(mount / (mount + kn - moving))
    kn0 = static_stiffness(normal)
    if "load" in scene:
        mean = quantity(scene["load"]["force"])
        u0 = mean / kn0 if kn0 else mp.inf  # it sinks for good
    else:
        u0 = quantity(oscillation["indentation"])
        mean = kn0 * u0
    if "tangential" in contact:
        tangential, factor = reader.network(contact["tangential"]), mpf(1)
    elif "poisson" in contact:
        nu = quantity(contact["poisson"])
        tangential, factor = normal, 2 * (1 - nu) / (2 - nu)
    else:
        tangential, factor = normal, quantity(contact["tangential_ratio"])
    kt = factor * tangential.stiffness(s)

    velocity = mu * omega * du * abs(kn) / abs(kt)
    drive = None
    if "drive" in scene:
        if "network" in scene["drive"]:
            drive = reader.network(scene["drive"]["network"])
        inertia = quantity(scene["body"]["mass"]) * omega**2 if "body" in scene else mpf(0)
        kd = drive.stiffness(s) if drive else measured(folder / scene["drive"]["receptance"], omega)
        assert abs(kd - inertia) > 0.05 * max(abs(kd), inertia), "too near resonance"
        assert abs(kt + kd - inertia) > 0.05 * inertia, "too near antiresonance"
        velocity *= abs(kt + kd - inertia) / abs(kd - inertia)

    creep = mpf(0)
    if static_stiffness(tangential) == 0:
        creep += 1 / (factor * viscosity(tangential))
    if drive is not None and static_stiffness(drive) == 0:
        creep += 1 / viscosity(drive)
    creep *= mu * mean
    closed = du < u0 and du * abs(kn) < mean
    return velocity, closed or contact.get("separation", False), creep


def main():
    print("scene,critical_velocity,admissible,creep_velocity")
    for file in sorted(SCENES.glob("*.toml")):
        velocity, admissible, creep = evaluate(tomllib.loads(file.read_text()))
        print(f"{file.name},{nstr(velocity, 50)},{str(admissible).lower()},{nstr(creep, 50)}")


if __name__ == "__main__":
    sys.exit(main())
