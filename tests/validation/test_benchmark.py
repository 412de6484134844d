"""The benchmark program works: a few rows at few settings, its tables and its JSON file.

What it measures is not looked at: no test depends on time.

    test_benchmark.py PROGRAM
"""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv.pop(1)
TIME = r"[0-9.]+ (us|ms|s)"


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=300)


class ASmallRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "points.json"
            cls.result = run("--quick", "--every", "12", "--budget", "0.4", "--json", str(file))
            cls.points = json.loads(file.read_text())

    def test_ends_well_with_progress_apart(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        self.assertIn("1/4 P1, delta 0, 0.1 v*", self.result.stderr)
        self.assertNotIn("1/4", self.result.stdout)

    def test_each_problem_has_its_table_with_the_exact_method_right_throughout(self):
        line = re.compile(rf"^exact +{TIME} +\d\.\de-\d+ +(\d+)/\2 ", re.MULTILINE)
        self.assertEqual(len(line.findall(self.result.stdout)), 3)

    def test_the_goals_are_judged(self):
        judged = re.findall(r"at least \d+x (met|MISSED)$", self.result.stdout, re.MULTILINE)
        self.assertEqual(len(judged), 4)
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
            if point["outcome"] == "not finished":
                self.assertTrue(point["reason"])
            elif "seconds" in point:
                self.assertGreater(point["seconds"], 0)
                self.assertGreaterEqual(point["error"], 0)
        self.assertIn("SUNDIALS", self.points["versions"])

    def test_every_method_answers_somewhere(self):
        points = self.points["points"]
        answered = {point["method"] for point in points if "seconds" in point}
        self.assertEqual(answered, {point["method"] for point in points})
        for name in ["exact", "GSL rk8pd, Newton", "CVODE BDF, Newton", "reduced model"]:
            self.assertIn(name, answered)

    # Doubles leave some ten units of rounding; the table has 22 digits.
    def test_the_exact_method_is_exact(self):
        errors = [point["error"] for point in self.points["points"] if point["method"] == "exact"]
        self.assertEqual(len(errors), 4)
        self.assertLess(max(errors), 1e-13)


class WrongInput(unittest.TestCase):
    def test_is_refused(self):
        self.assertEqual(run("--problem", "P4").returncode, 2)
        self.assertEqual(run("--table", "/nowhere.csv").returncode, 2)
        self.assertEqual(run("--budget", "0").returncode, 2)


if __name__ == "__main__":
    unittest.main()
