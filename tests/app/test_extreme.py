"""`vcrit eval` on every row of tests/data/vstar_extreme.csv: the double nearest to v* to the last bit, whatever
the size of the scene's numbers, and the right words where there is no such double.

    test_extreme.py TABLE PROGRAM
"""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TABLE, PROGRAM = Path(sys.argv.pop(1)), Path(sys.argv.pop(1)).resolve()
HALF_ULP, SMALLEST = 2.0**-53, 2.0**-1074

# Springs and dampers in the order of the table's numbers, and what is made of them.
SHAPES = {
    "kelvin": ("kc", "{0} | {1}"),
    "maxwell": ("kc", "{0} - {1}"),
    "zener": ("kkc", "{0} | ({1} - {2})"),
    "burgers": ("kckc", "{0} - {1} - ({2} | {3})"),
}
BRIDGE = ["A C", "A D", "C B", "D B", "C D"]


def ladder(names):
    inner = f"{names[9]} | {names[19]}"
    for j in range(8, -1, -1):
        inner = f"{names[10 + j]} | ({names[j]} - ({inner}))"
    return inner


def network(kind, letter, numbers):
    """A network of the table's kind: its expression, its lines of [elements], and those of [networks]."""
    values = [repr(float.fromhex(x)) for x in numbers.split(";")]
    if kind == "prony10":
        lines = [f"k{letter}0 = {values[0]}", f"k{letter} = [{', '.join(values[1:11])}]",
                 f"tau{letter} = [{', '.join(values[11:])}]"]
        return f"prony(k{letter}0, k{letter}, tau{letter})", lines, ""
    roles, expression = SHAPES.get(kind, ("k" * (len(values) // 2) + "c" * (len(values) // 2), ""))
    names = [f"{role}{letter}{i}" for i, role in enumerate(roles)]
    lines = [f"{name} = {value}" for name, value in zip(names, values)]
    if expression:
        return expression.format(*names), lines, ""
    if kind == "ladder10":
        return ladder(names), lines, ""
    edges = [[f"{names[i]} | {names[5 + i]}", *ends.split()] for i, ends in enumerate(BRIDGE)]
    graph = f'[networks.bridge_{letter}]\nterminals = ["A", "B"]\nedges = {json.dumps(edges)}\n'
    return f"bridge_{letter}", lines, graph


def scene(row):
    numbers = {name: repr(float.fromhex(row[name])) for name in ("mu0", "w", "duz", "m")}
    parts = [network(row["kind"], letter, row[column]) for letter, column in (("t", "kx"), ("n", "kz"), ("d", "ks"))]
    (tangential, normal, drive), elements, graphs = zip(*parts)
    body = f"[body]\nmass = {numbers['m']}\n" if float(numbers["m"]) else ""
    return (f'[contact]\nnormal = "{normal}"\ntangential = "{tangential}"\n[drive]\nnetwork = "{drive}"\n{body}'
            f"[oscillation]\nangular_frequency = {numbers['w']}\namplitude = {numbers['duz']}\nindentation = 1\n"
            f"[friction]\ncoefficient = {numbers['mu0']}\n{''.join(graphs)}"
            "[elements]\n" + "\n".join(line for lines in elements for line in lines) + "\n")


def has_empty_network(row):
    def carries(numbers):
        values = [float.fromhex(x) for x in numbers.split(";")]
        if row["kind"] == "maxwell":
            return all(values)
        if row["kind"] == "burgers":
            return all(values[:2]) and any(values[2:])
        return any(values)

    return not all(carries(row[column]) for column in ("kx", "kz", "ks"))


def evaluated(text):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "s.toml").write_text(text)
        return subprocess.run([PROGRAM, "eval", "s.toml", "--json"], cwd=folder, capture_output=True, text=True,
                              timeout=60)


class TheTable(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with TABLE.open() as file:
            cls.rows = list(csv.DictReader(file))

    def answered(self, row, text):
        result = evaluated(text)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def check(self, row):
        answer = self.answered(row, scene(row))
        value, bound, reasons = answer["critical_velocity"], answer["relative_error_bound"], answer["reasons"]
        if row["status"] == "pole":
            self.assertEqual(value, "inf")
            self.assertIn("resonance", " ".join(reasons))
            return
        self.assertEqual(value, float.fromhex(row["vstar_hex"]))
        if row["status"] == "normal":
            self.assertLessEqual(bound, HALF_ULP)
        elif row["status"] == "subnormal":
            self.assertLessEqual(bound * value, SMALLEST / 2)
        elif row["status"] == "underflow":
            self.assertGreaterEqual(bound, 1)
        else:
            self.assertEqual((row["status"], bound), ("zero", 0))

    def test_is_met_to_the_last_bit(self):
        rows = [row for row in self.rows if not has_empty_network(row)]
        for row in rows:
            with self.subTest(id=row["id"], kind=row["kind"], status=row["status"]):
                self.check(row)
        self.assertEqual(len(rows), 242)

    # What elements of value 0 cut in two is wrong input, as the reader of a scene sees it.
    def test_a_network_of_nothing_is_refused(self):
        rows = [row for row in self.rows if has_empty_network(row)]
        for row in rows:
            with self.subTest(id=row["id"]):
                result = evaluated(scene(row))
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn("value 0 cut in two", result.stderr)
        self.assertEqual(len(rows), 5)


class Beside(unittest.TestCase):
    """What the table has no row of."""

    ROW = {"kind": "kelvin", "mu0": "0x1p-1", "w": "0x1p+1", "duz": "0x1p-20", "m": "0x1p+1", "kx": "0x1p+0;0x0p+0",
           "kz": "0x1p+3;0x0p+0", "ks": "0x1p+3;0x0p+0"}

    def test_above_the_largest_double_it_is_infinite_and_says_why(self):
        result = evaluated(scene(self.ROW | {"mu0": "0x1p+600", "duz": "0x1p+600", "m": "0x0p+0"}))
        answer = json.loads(result.stdout)
        self.assertEqual((result.returncode, answer["critical_velocity"]), (0, "inf"))
        self.assertIn("v* is above the largest double", answer["reasons"])

    def test_resonance_of_both_kinds_is_outside_the_model(self):
        result = evaluated(scene(self.ROW | {"mu0": "0x0p+0"}))
        self.assertEqual((result.returncode, result.stdout), (3, ""))
        self.assertIn("0/0", result.stderr)

    def test_above_the_largest_double_there_is_infinity_with_its_reason(self):
        row = self.ROW | {"m": "0x1p+0", "duz": "0x1p+1023", "kz": "0x1p+10;0x0p+0"}
        answer = json.loads(evaluated(scene(row)).stdout)
        self.assertEqual((answer["critical_velocity"], answer["relative_error_bound"]), ("inf", "inf"))
        self.assertIn("largest double", " ".join(answer["reasons"]))


if __name__ == "__main__":
    unittest.main()
