"""`pip install .` of the checkout: without network, into an environment of its own, and there it works."""

import base64
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

import vcrit
from support import PROJECT

BUILD = sys.argv.pop(1)
sys.path.insert(0, str(PROJECT / "python/wheel"))
import backend  # noqa: E402

# As a user has it: nothing but pip's usual settings, and no network.
ENVIRONMENT = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PIP"))} | {
    "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_INPUT": "1", "VCRIT_BUILD": BUILD}


def done(*command, **where):
    ended = subprocess.run(list(map(str, command)), env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           text=True, timeout=300, **where)
    if ended.returncode != 0:
        raise AssertionError(f"{command} ended with {ended.returncode}:\n{ended.stdout}")
    return ended.stdout


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        with mock.patch.dict(os.environ, VCRIT_BUILD=BUILD):
            cls.wheel = cls.folder / backend.build_wheel(cls.folder)

    def test_is_installed_by_pip_and_works(self):
        # Debian's pip: the environment sees it, as it sees NumPy.
        done(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", self.folder / "env")
        python = self.folder / "env/bin/python"
        done(python, "-m", "pip", "install", PROJECT)
        code = ("import vcrit, importlib.metadata as m; print(vcrit.__file__, m.version('vcrit'), "
                "vcrit.Scene('scenes/elastic.toml').critical_velocity())")
        file, version, value = done(python, "-B", "-c", code, cwd=PROJECT).split()
        self.assertTrue(file.startswith(str(self.folder)), file)
        self.assertEqual(version, vcrit.__version__)
        # tests/data/scenes_expected.csv, to the digits of a double.
        self.assertAlmostEqual(float(value), 0.0045780336451466888, delta=1e-17)
        done(python, "-m", "pip", "uninstall", "--yes", "vcrit")
        self.assertFalse(Path(file).parent.exists())

    def test_records_what_it_holds(self):
        with zipfile.ZipFile(self.wheel) as wheel:
            record, = [name for name in wheel.namelist() if name.endswith(".dist-info/RECORD")]
            rows = dict(line.split(",", 1) for line in wheel.read(record).decode().splitlines())
            self.assertEqual(set(rows), set(wheel.namelist()))
            for name, row in rows.items():
                content = wheel.read(name)
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
                self.assertEqual(row, "," if name == record else f"sha256={digest},{len(content)}")
            self.assertIn("vcrit/py.typed", rows)
            self.assertIn("vcrit/_vcrit.pyi", rows)

    def test_has_the_same_bytes_again(self):
        with tempfile.TemporaryDirectory() as other:
            again = Path(other) / backend.build_wheel(other, {"build": BUILD})
            self.assertEqual(again.read_bytes(), self.wheel.read_bytes())


class Refusals(unittest.TestCase):
    def test_of_another_python(self):
        with self.assertRaisesRegex(SystemExit, r"built for Python 3\.99 \(Debian's /usr/bin/python3\); you run Python 3\.\d+ "):
            backend.refuse_other_python(".cpython-399-x86_64-linux-gnu.so")

    def test_of_a_build_without_the_module(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(SystemExit, "./dev build first"):
            (Path(folder) / "cmake_install.cmake").touch()
            backend.build_wheel(folder, {"build": folder})

    def test_where_there_is_no_cmake(self):
        with mock.patch.dict(os.environ, PATH="/nonexistent"), self.assertRaisesRegex(SystemExit, "no cmake: run ./dev"):
            backend.run("cmake", "--version")


if __name__ == "__main__":
    unittest.main()
