"""Random scenes for held_load.py: what kinds of scenes the program knows, over a few or over twenty decades."""

import cmath
import json
import random

# Units of each kind of number, with the share of them that one has: all are in data/scenes_expected.py.
UNITS = {
    "stiffness": {"N/m": 1, "N/um": 1e6, "N/mm": 1e3, "kN/m": 1e3},
    "damping": {"N.s/m": 1, "kg/s": 1, "N s/mm": 1e3, "mN.s/um": 1e3, "kN us/mm": 1},
    "modulus": {"Pa": 1, "MPa": 1e6, "GPa": 1e9, "N/mm2": 1e6},
    "viscosity": {"Pa s": 1, "kPa.s": 1e3, "MPa.ms": 1e3},
    "time": {"s": 1, "ms": 1e-3, "us": 1e-6, "ns": 1e-9},
    "mass": {"kg": 1, "g": 1e-3, "mg": 1e-6},
    "length": {"m": 1, "mm": 1e-3, "um": 1e-6, "nm": 1e-9},
    "force": {"N": 1, "kN": 1e3, "mN": 1e-3},
    "frequency": {"Hz": 1, "kHz": 1e3, "MHz": 1e6},
    "angular frequency": {"rad/s": 1, "rad/ms": 1e3},
}
# A number with a unit may have more digits than a double.
MOST_DIGITS = 40
# Names that formulas and generated code have for other things.
ODD_NAMES = ["s", "i", "j", "K_n", "K_t", "omega1", "B", "exp", "H", "e1", "nan", "t", "x_own", "N"]


class Draw:
    """A random scene as TOML."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.decades = self.random.choices([1, 3, 6, 20], [3, 4, 2, 1])[0]
        self.elements, self.networks, self.files = {}, {}, {}
        self.odd_names = self.random.sample(ODD_NAMES, len(ODD_NAMES)) if self.chance(0.1) else []
        self.share_of_units = self.random.choice([0, 0.5, 1])
        self.separates, self.has_indenter = self.chance(0.25), self.chance(0.04)
        self.has_mount = not self.has_indenter and self.chance(0.15)
        # A drive below an indenter gives v* as a maximum over the phase, no formula.
        self.has_drive = self.chance(0.3 if self.has_indenter else 0.7)
        self.in_half_space = self.has_indenter  # moduli and viscosities

    def chance(self, share):
        return self.random.random() < share

    def value(self, middle):
        return middle * 10 ** self.random.uniform(-self.decades / 2, self.decades / 2)

    def number(self, value, kind):
        """TOML of about that value: the double, or with a unit and any number of digits."""
        if not self.chance(self.share_of_units):
            return repr(value)
        unit, factor = self.random.choice(list(UNITS[kind].items()))
        digits = f"{value / factor:.{self.random.randint(0, 16)}e}"
        if self.chance(0.2):
            head, exponent = digits.split("e")
            more = "".join(self.random.choices("0123456789", k=self.random.randint(1, MOST_DIGITS - 17)))
            digits = f"{head}{'' if '.' in head else '.'}{more}{self.random.choice('eE')}{exponent}"
        return json.dumps(f"{digits} {unit}")

    def spring(self):
        return self.element("k")

    def damper(self):
        return self.element("c")

    def element(self, letter):
        """The name of a new element, as named rheologies take it."""
        name = self.odd_names.pop() if self.odd_names else f"{letter}{len(self.elements)}"
        kinds, middles = {"k": (("stiffness", "modulus"), (1e6, 1e9)), "c": (("damping", "viscosity"), (10, 1e4)),
                          "m": (("mass",), (1e-4,))}[letter]
        self.elements[name] = self.number(self.value(middles[self.in_half_space]), kinds[self.in_half_space])
        return name

    def alone(self, letter):
        """The same as a network."""
        name = self.element(letter)
        if name.startswith(letter) and not self.chance(0.1):
            return name
        return f"{'spring' if letter == 'k' else 'damper'}({name})"

    def leaf(self):
        shape = self.random.choices(["k", "c", "kelvin", "zener", "burgers", "prony", "bridge"],
                                    [6, 5, 2, 2, 1, 1, 1])[0]
        k, c = self.spring, self.damper
        if shape in "kc":
            return self.alone(shape)
        if shape == "kelvin":
            return f"kelvin({k()}, {c()})"
        if shape == "zener":
            return f"zener({k()}, {k()}, {c()})"
        if shape == "burgers":
            return f"burgers({k()}, {c()}, {k()}, {c()})"
        return self.prony() if shape == "prony" else self.bridge()

    def prony(self):
        n = self.random.randint(1, 12)
        number = len(self.elements)
        kind, middle = ("modulus", 1e9) if self.in_half_space else ("stiffness", 1e6)
        for name, values in ((f"kp{number}", [self.number(self.value(middle), kind) for _ in range(n)]),
                             (f"tau{number}", [self.number(self.value(1e-5), "time") for _ in range(n)])):
            self.elements[name] = f"[{', '.join(values)}]"
        return f"prony({self.spring()}, kp{number}, tau{number})"

    def bridge(self):
        arms = [self.alone(self.random.choice("kc")) for _ in range(5)]
        ends = [("a", "1"), ("a", "2"), ("1", "b"), ("2", "b"), ("1", "2")]
        return self.graph([[arm, *end] for arm, end in zip(arms, ends)])

    def graph(self, edges):
        name = f"graph{len(self.networks)}"
        self.networks[name] = edges
        return name

    def network(self, depth=0):
        if depth == 3 or self.chance(0.3):
            return self.leaf()
        sign = self.random.choice([" | ", " - "])
        parts = [self.network(depth + 1) for _ in range(self.random.randint(2, 3))]
        return "(" + sign.join(parts) + ")"

    def drive(self):
        """Without masses, with some at the end of a chain or in a graph, or a table."""
        way = self.random.choices(["network", "chain", "graph", "table"], [6, 1, 1, 1])[0]
        if way == "network":
            return f'network = "{self.network()}"'
        if way == "table":
            return self.receptance()
        mass = f"mass({self.element('m')})"
        inner, outer = self.network(2), self.network(2)
        if way == "chain":
            return f'network = "{self.alone("k")} | {inner} - ({mass} | {outer})"'
        edges = [[inner, "a", "1"], [mass, *self.random.sample(["1", "ground"], 2)], [outer, "1", "b"],
                 [self.alone("k"), "a", "b"]]
        return f'network = "{self.graph(edges)}"'

    def receptance(self):
        """A table around the frequency as it is typed, with few digits up to 2.2 times another; lossy throughout."""
        omegas = sorted(self.omega * 10 ** x for x in [-self.random.uniform(0.4, 1), self.random.uniform(0.4, 1),
                                                       self.random.uniform(-1, 1)])
        rows = [(omega, cmath.rect(1 / self.value(1e6), -self.random.uniform(0, 3.1))) for omega in omegas]
        self.files["the drive.csv"] = "omega,Re,Im\n" + "".join(f"{w!r},{r.real!r},{r.imag!r}\n" for w, r in rows)
        return 'receptance = "the drive.csv"'

    def tangential(self):
        way = 0 if self.has_indenter else self.random.randrange(3)
        if way == 0:
            return f"poisson = {self.random.uniform(0, 0.5)!r}"
        return f"tangential_ratio = {self.random.uniform(0.5, 1)!r}" if way == 1 else f'tangential = "{self.network()}"'

    def indenter(self):
        return ["[indenter]", self.random.choice([
            f'shape = "flat"\nradius = {self.number(1e-4, "length")}',
            f'shape = "parabola"\nradius = {self.number(1e-3, "length")}',
            'shape = "cone"\nangle = "0.7 deg"', 'shape = "power"\nprefactor = 4000\nexponent = 3'])]

    def mount(self):
        """Of the vibrator: it carries the load."""
        lines = ["[mount]", f'network = "{self.alone("k")} | {self.network(1)}"']
        return lines + ([f"mass = {self.number(self.value(1e-4), 'mass')}"] if self.chance(0.5) else [])

    def oscillation(self):
        indentation = 10 ** self.random.uniform(-7, -5)
        amplitude = indentation * self.random.uniform(0.01, 3 if self.separates else 0.9)
        given = (f"frequency = {self.number(self.frequency, 'frequency')}" if self.chance(0.7) else
                 f"angular_frequency = {self.number(self.omega, 'angular frequency')}")
        lines = ["[oscillation]", given, f"amplitude = {self.number(amplitude, 'length')}"]
        if self.has_indenter or self.chance(0.8):  # below one the load is an integral over the profile
            return lines + [f"indentation = {self.number(indentation, 'length')}"]
        return lines + ["[load]", f"force = {self.number(self.value(1e6) * indentation, 'force')}"]

    def toml(self):
        self.frequency = self.value(2e4)
        self.omega = 6.283185307179586 * self.frequency
        # Half of them surely carry a static load.
        load = f"{self.alone('k')} | " if self.chance(0.5) else ""
        lines = [f"title = {json.dumps('Größe <b>&amp; 10 % of $x_1$')}"] if self.chance(0.1) else []
        lines += ["[contact]", f'normal = "{load}{self.network()}"', self.tangential()]
        if self.separates:
            lines += ["separation = true"]
        if self.chance(0.1):
            lines += ['fitted_range = ["1 kHz", 2e4]']
        if self.has_indenter:
            lines += self.indenter()
        self.in_half_space, self.half_space = False, list(self.elements)
        if self.has_mount:
            lines += self.mount()
        if self.has_drive:
            lines += ["[drive]", self.drive()]
            if self.chance(0.6):
                lines += ["[body]", f"mass = {self.number(self.value(1e-4), 'mass')}"]
        lines += self.oscillation() + ["[friction]", f"coefficient = {self.random.uniform(0.05, 1)!r}"]
        for name, edges in self.networks.items():
            lines += [f"[networks.{name}]", 'terminals = ["a", "b"]', f"edges = {json.dumps(edges)}"]
        lines += ["[elements]"] + [f"{name} = {value}" for name, value in self.elements.items()]
        return "\n".join(lines) + "\n"

    def broken(self, text):
        """One character that is another, or is not there."""
        at = self.random.randrange(len(text))
        return text[:at] + self.random.choice(["", "x", '"', "-1", "]", "\n", "é", "(", "0"]) + text[at + 1:]
