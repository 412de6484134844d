"""Dimension analysis of derivations: with the units that the nomenclature lists, both sides of every line measure the
same, and so do the terms of each sum."""
import ast
import re
import unittest
from fractions import Fraction

from program import Case, scene

# Exponents of kg, m and s.
UNITS = {"1": (0, 0, 0), "rad": (0, 0, 0), "m": (0, 1, 0), "s": (0, 0, 1), "kg": (1, 0, 0), "1/s": (0, 0, -1),
         "rad/s": (0, 0, -1), "m/s": (0, 1, -1), "N": (1, 1, -2), "N/m": (1, 0, -2), "N s/m": (1, 0, -1),
         "m/N": (-1, 0, 2), "Pa": (1, -1, -2), "Pa s": (1, -1, -1)}
NAMES = {"Deltauz": "du_z", "v*": "v*"}
ELASTIC = {"tangential": "kt", "network": "kd", "mass": "m"}


class Dimension:
    """Of a value; 0 has any."""

    def __init__(self, powers):
        self.powers = powers and tuple(map(Fraction, powers))

    def plain(self):
        return self.powers is None or not any(self.powers)

    def same(self, other):
        if self.powers is None:
            return other
        if other.powers not in (None, self.powers):
            raise AssertionError(f"{self.powers} and {other.powers} in one sum")
        return self

    def times(self, other, power=1):
        if None in (self.powers, other.powers):
            return Dimension(None)
        return Dimension([a + power * b for a, b in zip(self.powers, other.powers)])


PLAIN = Dimension(UNITS["1"])


def measured(node, known):
    if isinstance(node, ast.Constant):
        return PLAIN if node.value else Dimension(None)
    if isinstance(node, ast.Name):
        return known[node.id]
    if isinstance(node, ast.Subscript):
        return known[node.value.id]
    if isinstance(node, ast.UnaryOp):
        return measured(node.operand, known)
    if isinstance(node, ast.Call):
        inside = measured(node.args[0], known)
        if node.func.id == "sqrt":
            return PLAIN.times(inside, Fraction(1, 2))
        if node.func.id != "abs" and not inside.plain():
            raise AssertionError(f"{node.func.id} of {inside.powers}")
        return inside if node.func.id == "abs" else PLAIN
    left = measured(node.left, known)
    if isinstance(node.op, ast.Pow):
        return PLAIN.times(left, ast.literal_eval(node.right))
    right = measured(node.right, known)
    if isinstance(node.op, (ast.Add, ast.Sub)):
        return left.same(right)
    return left.times(right, 1 if isinstance(node.op, ast.Mult) else -1)


class Units(Case):
    def nomenclature(self, *forms):
        """Dimensions by the names in formulas as text."""
        page = self.out("derive", "s.toml", "--format", "markdown", *forms)
        rows = re.findall(r"^\| \$(.+?)\$ \| .* \| (\S.*?) \|$", page, re.M)
        self.assertGreater(len(rows), 8)
        known = {"i": PLAIN, "pi": PLAIN, "e": PLAIN}
        for symbol, unit in rows:
            name = re.sub(r"\\mathrm|,j|_\{j\}|[\\{}^_, ]", "", symbol.split(" = ")[0])
            known[NAMES.get(name, name)] = Dimension(UNITS[unit])
        return {re.sub(r"[*_]", "", name): each for name, each in known.items()}

    def side(self, text):
        plain = re.sub(r"\bv\*(?=$|\))", "v", text).replace("^", "**")
        return ast.parse(re.sub(r"(?<=\w)_(?=\w)", "", plain), mode="eval").body

    def lines(self, *forms):
        known, found = self.nomenclature(*forms), self.answer("derive", "s.toml", *forms)
        return self.equations(found["definitions"] + found["lines"], known)

    def equations(self, lines, known):
        """How many measure the same on both sides; `known` gets what they define."""
        checked = 0
        for line in lines:
            left, right = line["text"].split(" = ", 1)
            if "''" in line["text"]:
                continue  # a derivative by time
            with self.subTest(line=line["text"]):
                measure = measured(self.side(right), known)
                name = self.side(left)
                if isinstance(name, ast.Name) and name.id not in known:
                    known[name.id] = measure  # a definition of its own
                else:
                    measured(name, known).same(measure)
                checked += 1
        return checked

    def test_every_line_measures_the_same_on_both_sides(self):
        for changed in ({"normal": "zener(k0, k1, c1)"}, {"normal": "zener(k0, k1, c1)", **ELASTIC},
                        {"normal": "burgers(k1, c1, k2, c2)", "network": "kd | cd"},
                        {"normal": "prony(k0, k, tau, 2)", **ELASTIC}, {"normal": "lossy(k0, eta)", **ELASTIC},
                        {"normal": "kn | cn", "tangential": "kt | ct", "network": "mass(m1) | kd"}):
            for forms in ([], ["--form", "nested"]):
                with self.subTest(scene=changed, forms=forms):
                    self.write(scene(**changed, angular_frequency=None, amplitude=None, indentation=None,
                                     coefficient=None))
                    self.assertGreater(self.lines(*forms), 7)

    def expression(self, text, known, measure):
        with self.subTest(expression=text):
            measured(self.side(text), known).same(measure)
        return 1

    def findings(self):
        """Limits, asymptotes, resonances and sensitivities; how many were looked at."""
        options = ["--limits", "--sensitivities"]
        known, found = self.nomenclature(*options), self.answer("derive", "s.toml", *options)
        checked = self.equations(found["definitions"] + found["lines"] + found.get("sensitivity_definitions", []), known)
        velocity, omega = known["v"], known["omega"]
        for each in found["limits"] + found["asymptotes"] + found["resonances"] + found["sensitivities"]:
            names = dict(known)
            checked += self.equations(each["definitions"], names)
            if "power" in each:
                checked += self.expression(each["coefficient"]["text"], names, velocity.times(omega, -each["power"]))
            elif "condition" in each:
                # A sum that vanishes measures something, the same in each term.
                measured(self.side(each["condition"]["text"].split(" = ")[0]), names)
                for part, measure in (("frequency", omega), ("real_part", None), ("imaginary_part", None)):
                    if each[part] and measure:
                        checked += self.expression(each[part]["text"], names, measure)
                    elif each[part]:
                        measured(self.side(each[part]["text"].split(" = ")[0]), names)
            elif "parameter" in each:
                parameter = names[re.sub(r"[*_]", "", each["parameter"]).split("[")[0]]
                checked += self.expression(each["relative"]["text"], names, PLAIN)
                checked += self.expression(each["derivative"]["text"], names, velocity.times(parameter, -1))
            else:
                checked += self.expression(each["text"], names, velocity)
        return checked

    def test_what_is_asked_besides_measures_what_it_is(self):
        for changed in ({"normal": "zener(k0, k1, c1)", **ELASTIC}, {"normal": "kn | cn", "network": "kd | cd", "mass": "m"},
                        {"normal": "burgers(k1, c1, k2, c2)", "network": "kd | cd"},
                        {"normal": "prony(k0, k, tau, 6)", **ELASTIC}, {"normal": "kn | cn", "tangential": "kt | ct",
                                                                       "network": "kd - (mass(m1) | k3)"}):
            with self.subTest(scene=changed):
                self.write(scene(**changed, angular_frequency=None, amplitude=None, indentation=None, coefficient=None))
                self.assertGreater(self.findings(), 25)

    def test_a_wrong_unit_is_found(self):
        self.write(scene(normal="zener(k0, k1, c1)", **ELASTIC))
        known = self.nomenclature()
        known["c1"] = known["k1"]
        with self.assertRaises(AssertionError):
            measured(self.side("k1 + c1*s"), known)


if __name__ == "__main__":
    unittest.main()
