"""./dev bench python, a small run: it works, and what it times are the same values. No time is judged."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT, LIBRARY = Path(__file__).resolve().parents[2], sys.argv.pop(1)


class Benchmark(unittest.TestCase):
    def test_prints_its_table(self):
        result = subprocess.run(
            [sys.executable, "-B", PROJECT / "bench/python/benchmark.py", LIBRARY, PROJECT,
             "--points", "1000", "--rounds", "2"], capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = result.stdout.split("|---|\n")[1].splitlines()
        self.assertEqual(len(rows), 5, result.stdout)
        for row in rows:
            self.assertEqual(len(re.findall(r"\d+\.\d+", row)), 6, row)


if __name__ == "__main__":
    unittest.main()
