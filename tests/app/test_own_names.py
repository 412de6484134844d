"""Elements that read like the program's own symbols, or like each other, in everything that is printed and generated.

A formula is read back as text: each definition is evaluated in its order, with the names that are printed, and the
result held against eval, which knows no names.
"""
import cmath
import re
import subprocess
import unittest

from program import Case, names_in_words, scene, unbroken

# What derivations call their own: stiffnesses, amplitudes, variables, the imaginary unit.
OWN = ["s", "i", "j", "x", "y", "z", "t", "b", "K_n", "K_t", "K_d", "R_d", "C_t", "f_n", "rho_d", "kappa_k1", "theta",
       "beta", "s_own", "K_n_own", "exp", "abs", "re", "v", "p", "dK_n"]
# Shapes in which an element named NAME stands, each with two others.
SHAPES = [
    ('spring(NAME) | damper(d1)', 'spring(k2) - damper(d1)', None),
    ('spring(k1) | damper(NAME)', 'spring(k2) | (spring(k1) - damper(NAME))', 'spring(k2) | damper(d1)'),
    ('spring(k1) | (spring(k2) - damper(d1))', 'spring(NAME) - damper(d1)', 'spring(NAME)'),
]
VALUES = {"k1": 3e6, "k2": 5e6, "d1": 20.0}
OSCILLATION = {"angular_frequency": 6e4, "amplitude": 1e-7, "indentation": 1e-6}


def named(shape, name):
    """A scene of this shape and its elements' values."""
    normal, tangential, drive = (part and part.replace("NAME", name) for part in shape)
    used = "".join(filter(None, (normal, tangential, drive)))
    values = dict(VALUES, **{name: 7e2 if f"damper({name})" in used else 7e5})
    present = {k: v for k, v in values.items() if f"({k})" in used}
    return scene(present, normal=normal, tangential=tangential, network=drive, mass=drive and 1e-3, **OSCILLATION), present


class OwnNames(Case):
    def value(self):
        return self.answer("eval", "s.toml")["critical_velocity"]

    def read_back(self, text, values, drive):
        """The last formula of a nested derivation, evaluated."""
        found = re.search(r"with (\w+) = (\w+)\*omega", text)
        s, i = found.groups()
        self.assertNotIn(s, values)
        self.assertNotIn(i, values)
        known = dict(values, omega=6e4, mu0=0.3, du_z=1e-7, m=1e-3, **{i: 1j, s: 6e4j})
        known = {k.replace("[", "_"): v for k, v in known.items()}
        after = text[text.index("Normal contact"):]
        for left, right in names_in_words(text) + re.findall(r"^    (\S+) = (.+)$", after, re.M):
            formula = re.sub(r"\b(abs|sqrt)\(", r"\1_of(", right.replace("^", "**"))
            result = eval(formula, {"__builtins__": {}}, dict(known, abs_of=abs, sqrt_of=cmath.sqrt))
            if left == "v*":
                return abs(result)
            self.assertNotIn(left, values, text)
            known[left] = result
        self.fail(text)

    def test_each_own_name_as_an_element(self):
        for number, shape in enumerate(SHAPES):
            self.write(named(shape, "q7")[0])
            expected = self.value()
            for name in OWN:
                with self.subTest(shape=number, name=name):
                    text, values = named(shape, name)
                    self.write(text)
                    self.assertEqual(self.value(), expected)
                    nested = unbroken(self.out("derive", "s.toml", "--form", "nested"))
                    self.assertNotRegex(nested, r"[\x00-\x08\x0b-\x1f]")
                    back = self.read_back(nested, values, shape[2])
                    # Some 40 operations in doubles, none of which cancels in these shapes.
                    self.assertAlmostEqual(back / expected, 1, delta=1e-13)

    def test_groups_are_told_from_elements_of_their_names(self):
        # An array's group too: kappa_k[1] of k[1].
        networks = [("spring(NAME) | (spring(k1) - damper(d1))", {"k1": 3e6, "d1": 20.0}),
                    ("prony(NAME, k, tau)", {"k": [3e6, 1e6], "tau": [1e-5, 2e-5]})]
        names = [["kappa_k1", "theta_d1", "kappa_kt", "theta_ct", "kappa_kd", "beta_m"],
                 ["kappa_k", "theta_tau", "kappa_kt", "theta_kt"]]
        includes = ""
        for (network, values), each in zip(networks, names):
            for name in each:
                elements = dict(values, kt=2e6, ct=9.0, kd=1e6, **{name: 7e5})
                self.scene(elements, normal=network.replace("NAME", name), tangential="kt | ct", network="kd", mass=1e-3,
                           **OSCILLATION)
                with self.subTest(name=name):
                    text = unbroken(self.out("derive", "s.toml", "--form", "dimensionless").rpartition("\nDerivation:")[2])
                    known = {"mu0": 0.3, "omega": 6e4, "du_z": 1e-7, "m": 1e-3}
                    for key, value in elements.items():
                        known |= {f"{key}_{i}": x for i, x in enumerate(value, 1)} if isinstance(value, list) \
                            else {key: value}
                    lines = re.findall(r"^    (\S+) = (.+)$", text[text.index("Dimensionless form"):], re.M)
                    for left, right in lines:
                        left, right = (re.sub(r"\[(\d+)\]", r"_\1", side) for side in (left, right))
                        formula = re.sub(r"\b(abs|sqrt)\(", r"\1_of(", right.replace("^", "**"))
                        value = eval(formula, {"__builtins__": {}}, dict(known, i=1j, abs_of=abs, sqrt_of=cmath.sqrt))
                        self.assertNotIn(left, known, text)
                        known[left] = value
                    self.assertAlmostEqual(abs(known["v*"]) / self.value(), 1, delta=1e-13)
                    self.out("generate", "s.toml", "--out", ".", "--name", f"own_{name}", "--quantities")
                    includes += f'#include "own_{name}_quantities.hpp"\n'
        self.assertEqual(includes.count("\n"), sum(map(len, names)))
        self.write(includes, "all.cpp")
        subprocess.run(["g++", "-std=c++20", "-fsyntax-only", "all.cpp"], cwd=self.folder, check=True)

    def test_generated_code_for_all_of_them(self):
        calls, includes, expected = [], [], []
        for number, name in enumerate(OWN):
            text, values = named(SHAPES[number % len(SHAPES)], name)
            self.write(text)
            library = f"g{number}"
            self.out("generate", "s.toml", "--out", ".", "--name", library)
            expected.append(self.value())
            header = (self.folder / f"{library}.hpp").read_text()
            members = re.search(r"struct Parameters \{(.*?)\};", header, re.S).group(1)
            given = dict(values, omega=6e4, mu0=0.3, du_z=1e-7, m=1e-3)
            sets = "".join(f"p.{place} = {given[place]!r};" for place in re.findall(r"(\w+)[,;]", members))
            includes.append(f'#include "{library}.hpp"\n')
            calls.append(f"{{ {library}::Parameters p{{}}; {sets} std::printf(\"%.17g\\n\", "
                         f"{library}::critical_velocity(p)); }}\n")
        self.write("#include <cstdio>\n" + "".join(includes) + "int main() {\n" + "".join(calls) + "}\n", "main.cpp")
        subprocess.run(["g++", "-std=c++20", "-O0", "-o", "main", "main.cpp"], cwd=self.folder, check=True)
        found = subprocess.run([self.folder / "main"], capture_output=True, text=True, check=True).stdout
        for value, right in zip(map(float, found.split()), expected, strict=True):
            self.assertAlmostEqual(value / right, 1, delta=1e-14)

    def test_words_and_derivatives_beside_elements_of_their_names(self):
        normal = " | ".join(f"spring({name})" for name in ("x", "B", "v0", "nu", "e"))
        file = self.scene(normal=normal, network="kd", mass="m")
        text = self.out("derive", file)
        for part in ("x_own: body", "m*x_own'' +", "v0_own - omega*abs(B_own)*sin(", "2*(1 - nu_own)/(2 - nu_own)"):
            self.assertIn(part, text)
        latex = self.out("derive", file, "--format", "latex")
        self.assertIn(r"\ddot{x}_{\mathrm{own}}", latex)
        self.assertIn(r"\operatorname{exp}\left(", latex)
        self.assertNotIn("e^{", latex)

    def test_names_that_would_be_set_alike(self):
        text = named(SHAPES[0], "k_1")[0]
        for pair in (("k1", "k_1"), ("k1_2", "k_1_2"), ("S_k1", "S_k_1")):
            self.write(text.replace("spring(k_1) |", f"spring({pair[0]}) | spring({pair[1]}) |")
                       .replace("k_1 = 7", f"{pair[0]} = 1.0\n{pair[1]} = 7"))
            latex = self.out("derive", "s.toml", "--format", "latex")
            symbols = re.search(r"K_\{n\} &? ?= (\S*k.*?)(?:\\\]|\\\\)", latex, re.S).group(1)
            springs = {part.strip() for part in symbols.split("+")} - {"c_{d1} s"}
            self.assertEqual(len([each for each in springs if "k" in each]), 2, symbols)


if __name__ == "__main__":
    unittest.main()
