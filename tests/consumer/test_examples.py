"""What the examples print, against values that do not come from vcrit.

    test_examples.py PROJECT FOLDER     FOLDER holds the programs (test_package.py builds them)
"""

import math
import random
import re
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT, FOLDER = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))
SCENES = PROJECT / "scenes"
ROUNDING = 2.0**-53


def lines(name, *arguments):
    command = [FOLDER / f"example_{name}", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()


def table(text):
    """Rows of numbers and words below a header row."""
    return [row.split(",") for row in text[1:]]


def inside(text, opening, closing, start):
    """What stands between a bracket at `start` and its partner, and where that ends."""
    depth = 0
    for i in range(start, len(text)):
        depth += (text[i] == opening) - (text[i] == closing)
        if depth == 0:
            return text[start + 1:i], i + 1
    raise ValueError(text)


def value_of_latex(text, values):
    """The little LaTeX that formulas of rational functions are written in."""
    while r"\frac" in text:
        at = text.index(r"\frac")
        over, end = inside(text, "{", "}", at + len(r"\frac"))
        under, end = inside(text, "{", "}", end)
        text = f"{text[:at]} (({over})/({under})) {text[end:]}"
    text = text.replace(r"\left|", " abs(").replace(r"\right|", ") ").replace(r"\Delta u", "du")
    text = re.sub(r"\^\{(\d+)\}", r"**\1", text)
    text = re.sub(r"\\?(\w+)_\{(\w+)\}", r"\1_\2", text).replace("\\", "")
    text = re.sub(r"(?<=[\w)])\s+(?=[\w(])", "*", text.strip())
    return eval(text, {"abs": abs}, values)


class Examples(unittest.TestCase):
    def near(self, value, expected, relative):
        self.assertAlmostEqual(float(value) / expected, 1, delta=relative)

    def test_critical_velocity(self):
        velocity, error = lines("critical_velocity", SCENES / "elastic.toml")
        # Eq. (31); seven numbers and six operations here are rounded.
        self.near(velocity.split()[2], 0.3 * 2 * math.pi * 20e3 * 0.1e-6 * 11.5 / 9.47, 13 * ROUNDING)
        self.assertEqual(error, "relative error at most 1.1e-16")  # 2^-53: correctly rounded

    def test_loop(self):
        rows = table(lines("loop"))
        self.assertEqual([float(frequency) for frequency, _ in rows], [1e3, 1e4, 1e5, 1e6])
        for frequency, velocity in rows:
            x = 2 * math.pi * float(frequency) * 1e-5  # omega c1/k1
            stiffness = 8 + 4 * 1j * x / (1 + 1j * x)  # N/um
            expected = 0.25 * 2 * math.pi * float(frequency) * 1e-7 * abs(stiffness) / 10
            # 32 units of rounding times the condition number 3 + 2 sqrt 2, as docs/report.md allows
            self.near(velocity, expected, 32 * (3 + 2 * math.sqrt(2)) * ROUNDING)

    def test_friction_curve(self):
        # G of the closed form in the head of the example, with 20 digits (30-digit root finding by mpmath).
        g = {0.001: 0.99693266303416232517, 0.1: 0.75717136015312994339, 0.25: 0.4918816026829403061,
             0.5: 0.2014522033336686888, 0.75: 0.047238266278833194827, 0.9: 0.0073108103345282100357,
             0.99: 0.000071763498506863749421, 1.01: 0.0}
        rows = table(lines("friction_curve", SCENES / "elastic.toml"))
        self.assertEqual([float(row[0]) for row in rows], list(g))
        for ratio, friction, regime in rows:
            # 1e-9 is what the simulation promises for friction.
            self.assertAlmostEqual(float(friction), 1 - g[float(ratio)] / 3, delta=1e-9)
            self.assertEqual(regime, "stick-slip" if float(ratio) < 1 else "sliding")

    def test_derive(self):
        printed = lines("derive", SCENES / "elastic_drive.toml")
        draw = random.Random(1)
        names = ["mu_0", "omega", "du_z", "m", "k_n", "k_t", "k_d"]
        values = {name: draw.uniform(1, 2) for name in names}
        mu0, omega, du_z, m, kn, kt, kd = values.values()
        rigid = mu0 * omega * du_z * kn / kt
        expected = {"(30)": rigid * abs(kt + kd - m * omega**2) / abs(kd - m * omega**2), "(31)": rigid}
        self.assertTrue(printed[0].startswith("(30) v* = "), printed[0])
        self.assertTrue(any(line.startswith("(31) kd -> infinity: ") for line in printed), printed)
        for line in printed:
            # Both ways round about a dozen times; the differences cancel to no less than a tenth.
            self.near(value_of_latex(line.split("v* = ")[1], values), expected[line.split()[0]], 240 * ROUNDING)

    def test_use_header(self):
        velocity, derivative = lines("use_header")
        # Eq. (30) by hand in the head of the example. Its doubles are given: m omega^2 and mu0 omega du_z
        # take some roundings, which 10 + 2 - 4 and 2 - 4 enlarge by at most 4/2 and more by none.
        self.near(velocity.split()[2], 4.8e-3, 20 * ROUNDING)
        self.assertEqual(velocity.split()[-1], "1.1e-16")
        self.near(derivative.split()[-1], 1, 20 * ROUNDING)

    def test_embed(self):
        rows = [row.split(",") for row in lines("embed")]
        self.assertEqual([float(omega) for omega, _ in rows], [2e4, 4e4, 6e4, 8e4])
        for omega, velocity in rows:
            x = 2.5e-9 * float(omega) ** 2  # N/um: 1, 4, 9, 16
            self.near(velocity, 2.5e-8 * float(omega) * 1.2 * abs(12 - x) / abs(2 - x), 40 * ROUNDING)


class Folder(unittest.TestCase):
    # generate.cpp writes what use_header.cpp and embed.c are built with.
    def test_every_example_is_tested(self):
        programs = {file.stem for file in (PROJECT / "examples").iterdir() if file.suffix in {".cpp", ".c"}}
        tested = {name.removeprefix("test_") for name in dir(Examples) if name.startswith("test_")}
        self.assertEqual(programs - {"generate"}, tested)
        for name in programs:
            self.assertTrue((FOLDER / f"example_{name}").is_file(), name)

    def test_every_example_opens_with_problem_solution_and_method(self):
        for file in (PROJECT / "examples").glob("*.c*"):
            self.assertRegex(file.read_text(), r"(?s)^(//|/\*) Problem .*? Exact solution .*? Method ", file)

    # A formatter that breaks long lines of comments leaves words at the left edge.
    def test_every_opening_keeps_its_columns(self):
        for file in (PROJECT / "examples").glob("*.c*"):
            opening = re.match(r"(?s)(.*?)\n(?: \*/|(?=#include))", file.read_text())[1]
            for line in opening.splitlines():
                self.assertRegex(line, r"^(//|/\*| \*)( (Problem {9}|Exact solution {2}|Method {10})\S| {17}\S|$| {5}\S)",
                                 f"{file.name}: {line}")


if __name__ == "__main__":
    unittest.main()
