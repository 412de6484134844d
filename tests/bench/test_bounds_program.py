"""The trial of error bounds as a program: its table, its JSON, and its exit status.

    test_bounds_program.py PROGRAM
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([PROGRAM, "bounds", *arguments], capture_output=True, text=True, timeout=300)


class ASmallRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            counts = Path(folder) / "counts.json"
            cls.result = run("--only", "kelvin", "--cases", "500", "--seed", "2", "--markdown", "--json", str(counts))
            cls.counts = json.loads(counts.read_text())

    def test_counts_every_case_once(self):
        kelvin = self.counts["systems"]["kelvin"]
        self.assertEqual(list(self.counts["systems"]), ["kelvin"])
        self.assertEqual(kelvin["all"]["cases"] + kelvin["all"]["undefined"], 500)
        self.assertEqual({d["cases"] + d["undefined"] for d in kelvin["draws"].values()}, {50})
        self.assertEqual(kelvin["draws"]["moderate"]["certified"], 50)

    def test_its_exit_status_tells_of_violations(self):
        violations = sum(self.counts["systems"]["kelvin"]["all"]["violations"].values())
        self.assertEqual(self.result.returncode, 1 if violations else 0)
        self.assertEqual("violated, kelvin, case" in self.result.stderr, violations > 0)

    def test_its_table_is_markdown(self):
        lines = self.result.stdout.splitlines()
        self.assertTrue(lines[0].startswith("| system | cases |"))
        self.assertTrue(lines[2].startswith("| kelvin | "))


class Mistakes(unittest.TestCase):
    def test_an_unknown_system_is_named(self):
        result = run("--only", "nothing")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn('"nothing"', result.stderr)


if __name__ == "__main__":
    unittest.main()
