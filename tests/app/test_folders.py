"""Folders for results: made where they are missing, gone again with what could not be written, asked for before long work.

test_folders.py PROGRAM FAULTS
"""

import os
import sys
import unittest
from pathlib import Path

from program import Case, example, run

FAULTS = str(Path(sys.argv.pop(1)).resolve())
ZENER = example("zener")
DATA = "frequency,storage,loss\n1e3,8e6,1e5\n1e4,9e6,9e5\n1e5,1.1e7,1e6\n1e6,1.2e7,1e5\n"


class Folders(Case):
    def test_a_full_disk_leaves_no_folder_that_was_made_for_the_result(self):
        new = self.folder / "new" / "deep"
        fault = {"LD_PRELOAD": FAULTS, "FAULT": "full", "FAULT_AT": "1", "FAULT_IN": str(new)}
        data = self.write(DATA, "data.csv")
        swept = ["sweep", ZENER, "--over", "k1=lin:1e6:2e6:3", "--quantity", "critical_velocity", "--out"]
        commands = [["generate", ZENER, "--out", new], [*swept, f"{new}/a.csv"], [*swept, f"{new}/a.h5"],
                    ["fit", data, "--out", f"{new}/f.toml"], ["new", f"{new}/n.toml"],
                    ["explore", ZENER, "--out", f"{new}/e.html"], ["plot", ZENER, "--out", f"{new}/p.svg"],
                    ["validate", ZENER, "--out", new]]
        for arguments in commands:
            with self.subTest(arguments):
                result = run(*arguments, env=os.environ | fault | {"PATH": "/nowhere"})
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn("No space left on device", result.stderr)
                self.assertFalse(new.parent.exists())

    def test_validate_asks_for_its_places_before_the_work(self):
        (self.folder / "g++").write_text(f"#!/bin/bash\ntouch {self.folder}/worked\n")
        (self.folder / "g++").chmod(0o755)
        file = self.write("", "file")
        path = {"PATH": f"{self.folder}:{os.environ['PATH']}"}
        for places in [["--out", f"{file}/out"], ["--out", f"{self.folder}/out", "--figures", f"{file}/figures"]]:
            for what in [ZENER, "--paper", "--extremes"]:
                result = run("validate", what, *places, env=os.environ | path)
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr, "^vcrit: .*found Not a directory; expected a place that can be written\n$")
                self.assertFalse((self.folder / "worked").exists() or (self.folder / "out").exists())

    def test_a_sweep_outside_the_model_leaves_no_folder(self):
        for name in ["a.csv", "a.h5"]:
            result = run("sweep", example("inadmissible"), "--over", "k=lin:1e6:2e6:2", "--quantity", "critical_velocity",
                         "--out", self.folder / "new" / "deep" / name)
            self.assertEqual(result.returncode, 3, result.stderr)
            self.assertFalse((self.folder / "new").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
