"""The benchmark program works: a few rows at few settings, its tables and its JSON file.

What it measures is not looked at: no test depends on time.

    test_simulators_program.py PROGRAM TABLE
"""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, TABLE = sys.argv.pop(1), Path(sys.argv.pop(1))
TIME = r"[0-9.]+ (us|ms|s)"


def run(*arguments, command="simulators"):
    return subprocess.run([PROGRAM, command, *arguments], capture_output=True, text=True, timeout=300)


def measured(beginnings, budget):
    """One quick run over the table's rows that begin so: what it printed, what it wrote."""
    header, *rows = TABLE.read_text().splitlines()
    chosen = [next(row for row in rows if row.startswith(beginning)) for beginning in beginnings]
    with tempfile.TemporaryDirectory() as folder:
        table, points = Path(folder) / "table.csv", Path(folder) / "points.json"
        table.write_text("\n".join([header, *chosen]) + "\n")
        result = run("--quick", "--every", "1", "--table", str(table), "--budget", budget, "--json", str(points))
        return result, json.loads(points.read_text())


class ASmallRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result, cls.points = measured(["P1", "P2", "P3,1,0,4,1e-1"], "10")

    def test_ends_well_with_progress_apart(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        self.assertIn("1/3 P1, delta 0, 0.1 v*", self.result.stderr)
        self.assertNotIn("1/3", self.result.stdout)

    def test_each_problem_has_its_table_with_the_exact_method_right_throughout(self):
        line = re.compile(rf"^exact +{TIME} +\d\.\de[-+]\d+ +(\d+)/\2 ", re.MULTILINE)
        self.assertEqual(len(line.findall(self.result.stdout)), 3)

    def test_the_goals_are_judged(self):
        judged = re.findall(r"at least \d+x (met|MISSED)$", self.result.stdout, re.MULTILINE)
        self.assertEqual(len(judged), 3)  # none of these rows is stiff
        for problem in ["P1", "P2", "P3"]:
            self.assertRegex(self.result.stdout, rf"(?m)^  {problem} +{TIME} +goal {TIME} (met|MISSED)$")

    # delta 10, v0 = 0.1 v*, from docs/physics.md.
    def test_the_reduced_model_is_compared(self):
        table = self.result.stdout.split("reduced model less full motion")[1]
        row = next(line for line in table.splitlines() if line.startswith("  10 "))
        self.assertEqual(row.split()[2], f"{0.7207052919138 - 0.43472823801559018:.4f}")

    def test_the_points_parse(self):
        points = self.points["points"]
        self.assertEqual({point["problem"] for point in points}, {"P1", "P2", "P3"})
        for point in points:
            self.assertGreater(point["seconds"], 0)
            self.assertGreaterEqual(point["error"], 0)
        self.assertIn("SUNDIALS", self.points["versions"])

    def test_every_method_is_there(self):
        methods = {point["method"] for point in self.points["points"]}
        for name in ["exact", "GSL rk8pd, Newton", "CVODE BDF, Newton", "Moreau, theta 1, cycles", "tanh, Newton",
                     "reduced model"]:
            self.assertIn(name, methods)

    # Doubles leave some ten units of rounding; the table has 22 digits.
    def test_the_exact_method_is_exact(self):
        errors = [point["error"] for point in self.points["points"] if point["method"] == "exact"]
        self.assertEqual(len(errors), 3)
        self.assertLess(max(errors), 1e-13)


class AMethodWithoutEnd(unittest.TestCase):
    """Explicit integration of a relaxation within 1e-9 periods: never over, whatever the machine."""

    def test_is_ended_and_said_so(self):
        result, points = measured(["P3,1,0,4,1e-9"], "0.05")
        self.assertEqual(result.returncode, 0, result.stderr)
        explicit = [point for point in points["points"] if point["method"] == "GSL rk8pd, Newton"]
        self.assertEqual([point["outcome"] for point in explicit], ["not finished"] * 2)
        self.assertEqual(explicit[0]["reason"], "out of time")
        self.assertTrue(explicit[1]["reason"].startswith("not tried"))
        self.assertRegex(result.stdout, r"GSL rk8pd, Newton +1e-06 +- +- +0/1 +out +not finished 1")


class Masses(unittest.TestCase):
    def test_each_number_of_masses_has_its_time_and_its_ratio_to_one(self):
        result = run("--repeat", "0.001", command="masses")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = re.findall(r"^[0-9.]+ omega (.*)$", result.stdout, re.MULTILINE)
        self.assertEqual(len(rows), 12, "a curve, a state by amplitude and one by drive, at four frequencies")
        for row in rows:
            times = [float(word) for word in re.findall(r"([0-9.e+]+) us", row)]
            ratios = [float(word) for word in row.split("us")[-1].split()]
            self.assertEqual((len(times), len(ratios)), (5, 4))
            # Times have three digits, ratios one behind the point.
            for time, ratio in zip(times[1:], ratios):
                self.assertAlmostEqual(ratio, time / times[0], delta=0.05 + 0.011 * ratio)


class WrongInput(unittest.TestCase):
    def test_is_refused(self):
        self.assertEqual(run("--problem", "P4").returncode, 2)
        self.assertEqual(run("--table", "/nowhere.csv").returncode, 2)
        self.assertEqual(run("--budget", "0").returncode, 2)
        self.assertEqual(run("--repeat", "0", command="masses").returncode, 2)


if __name__ == "__main__":
    unittest.main()
