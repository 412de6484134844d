"""plant_faults.py takes a test that fails for one that notices, and no test that runs out of time."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from plant_faults import VERDICTS, outcome_of


class Outcomes(unittest.TestCase):
    def verdict(self, command):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "CTestTestfile.cmake").write_text(f"add_test(t {command})\n")
            ended = subprocess.run(["ctest", "--test-dir", folder, "--timeout", "1"], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, check=False)
        return VERDICTS[outcome_of(ended.returncode, ended.stdout, "t")]

    def test_are_told_apart(self):
        self.assertEqual(self.verdict("true"), "MISSED")
        self.assertEqual(self.verdict("false"), "caught")
        self.assertEqual(self.verdict("sleep 60"), "TIMED OUT")


if __name__ == "__main__":
    unittest.main()
