"""Tables of tests/data against the scripts that make them, which share nothing with the program: all of
vstar_extreme.csv, and of stickslip_reference.csv, which takes minutes, a row of each kind.

    test_tables.py PROJECT
"""

import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

DATA = Path(sys.argv.pop(1)).resolve() / "tests/data"
sys.path.insert(0, str(DATA))


class Tables(unittest.TestCase):
    def test_of_extreme_numbers_is_made_again_to_the_byte(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in ["csv", "py"]:
                shutil.copy(DATA / f"vstar_extreme.{ending}", folder)
            table = Path(folder, "vstar_extreme.csv")
            with table.open(newline="") as file:
                header, *rows = csv.reader(file)
            given = header.index("status")
            with table.open("w", newline="") as file:  # what is computed goes first
                csv.writer(file).writerows([header, *[row[:given] + [""] * (len(row) - given) for row in rows]])
            subprocess.run([sys.executable, "-B", table.with_suffix(".py")], check=True, timeout=300)
            self.assertEqual(table.read_bytes(), (DATA / table.name).read_bytes())

    def test_of_steady_motions_has_these_rows(self):
        from stickslip_reference import row_of, systems
        with (DATA / "stickslip_reference.csv").open(newline="") as file:
            header, *rows = csv.reader(file)
        last = {texts[0]: texts for texts in systems()}
        self.assertEqual(sorted(last), ["P1", "P2", "P3"])
        for texts in last.values():
            with self.subTest(system=texts):
                self.assertIn([str(cell) for cell in row_of(texts, "0.5")], rows)


if __name__ == "__main__":
    unittest.main()
