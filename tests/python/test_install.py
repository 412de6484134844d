"""`cmake --install` puts the package where the system's Python finds it, and there it works."""

import importlib.metadata
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import vcrit
from support import PROJECT

BUILD = sys.argv.pop(1)


class Installed(unittest.TestCase):
    def test_package_works(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", prefix],
                           check=True, capture_output=True)
            # Debian's Python adds dist-packages to the folder of its version, under /usr/local.
            folder = Path(prefix) / f"lib/python3.{sys.version_info.minor}/dist-packages"
            code = ("import vcrit; print(vcrit.__file__);"
                    "print(vcrit.Scene('scenes/elastic.toml').critical_velocity())")
            result = subprocess.run([sys.executable, "-B", "-c", code], cwd=PROJECT, env={"PYTHONPATH": str(folder)},
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)
            file, value = result.stdout.split()
            self.assertEqual(file, str(folder / "vcrit/__init__.py"))
            # tests/data/scenes_expected.csv, to the digits of a double.
            self.assertAlmostEqual(float(value), 0.0045780336451466888, delta=1e-17)
            self.assertTrue((folder / "vcrit/py.typed").is_file())
            self.assertTrue((folder / "vcrit/_vcrit.pyi").is_file())

    def test_package_has_metadata(self):
        self.assertEqual(importlib.metadata.version("vcrit"), vcrit.__version__)
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", prefix],
                           check=True, capture_output=True)
            found = list(Path(prefix).glob("lib/python3*/dist-packages/vcrit-*.dist-info/METADATA"))
            self.assertEqual(len(found), 1)

    def test_extension_shows_no_symbols_but_its_own(self):
        symbols = subprocess.run(["nm", "-D", "--defined-only", vcrit._vcrit.__file__], check=True,
                                 capture_output=True, text=True).stdout.splitlines()
        self.assertIn("PyInit__vcrit", {line.split()[-1] for line in symbols})
        self.assertEqual([line for line in symbols if "5vcrit" in line], [])

    def test_folder_is_one_that_python_looks_in(self):
        result = subprocess.run([sys.executable, "-I", "-c", "import sys; print(sys.path)"],
                                capture_output=True, text=True)
        self.assertIn(f"/usr/local/lib/python3.{sys.version_info.minor}/dist-packages", result.stdout)


if __name__ == "__main__":
    unittest.main()
