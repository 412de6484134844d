"""The package's types: mypy --strict on package and example, and the stubs against the extension."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import vcrit
from support import PROGRAM, PROJECT

PACKAGE = Path(vcrit.__file__).parent
PLACE = tempfile.TemporaryDirectory()
# In the build folder: NumPy's types are read once, and again when they change.
CACHE = PACKAGE.parent.with_name("mypy_cache")


def checked(module, *arguments):
    environment = os.environ | {"MYPYPATH": f"{PACKAGE.parent}:{PROJECT}/examples", "MYPY_CACHE_DIR": str(CACHE)}
    return subprocess.run([sys.executable, "-B", "-m", module, *arguments], cwd=PLACE.name, env=environment,
                          capture_output=True, text=True, timeout=300)


def mypy(*arguments):
    return checked("mypy", "--strict", *map(str, arguments))


class Types(unittest.TestCase):
    def test_of_package_and_example_are_right(self):
        result = mypy("-p", "vcrit", "-m", "notebook")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_find_wrong_use(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "wrong.py"
            file.write_text(
                "import vcrit, numpy as np\n"
                "scene = vcrit.Scene('a')\n"
                "scene.critical_velocity() + 'm/s'\n"
                "scene.simulate(velocity_ratio=[0.5])\n"
                "scene.friction_curve([1.0]).friction\n"
                "vcrit.derive('a')\n"
                "vcrit.derive(scene).limits[0].latex + 1\n"
                "scene.critical_velocity(k0=1.0).shape\n"
                "reveal_type(scene.certified_critical_velocity.value)\n"
                "reveal_type(scene.critical_velocity(k0=np.ones(3)))\n"
                "scene.solve(0.5, 'amplitude')\n"
                "scene.sweep('frequency', 'regime')\n"
                "vcrit.fit(3.0)\n"
                "reveal_type(vcrit.fit('a').equilibrium)\n")
            result = mypy(file)
        found = [line.split(":", 1)[1].split(": ")[:2] for line in result.stdout.splitlines()[:-1]]
        expected = {line: "error" for line in range(3, 14)} | dict.fromkeys([9, 10, 14], "note")
        # The first of a line, which may have several, as line 11 has.
        self.assertEqual({int(line): kind for line, kind in reversed(found)}, expected, result.stdout)
        self.assertIn('"builtins.float"', result.stdout)
        self.assertIn('"numpy.ndarray[', result.stdout)

    def test_of_generated_modules_are_right_and_find_wrong_use(self):
        use = ("import pad\n"
               "p = pad.Parameters(*[1.0] * 8)\n"
               "reveal_type(pad.critical_velocity_certified(p))\n"
               "reveal_type(pad.fast_critical_velocity_gradient(p, omega=[1.0]).partial)\n"
               "pad.critical_velocity(1.0)\n")
        with tempfile.TemporaryDirectory() as folder:
            for scene, name in {"zener": "zener", "prony": "prony", "bridge": "bridge", "kelvin_rigid": "pad"}.items():
                subprocess.run([PROGRAM, "generate", PROJECT / f"scenes/{scene}.toml", "--language", "python", "--out", folder,
                                "--name", name], check=True, capture_output=True)
            Path(folder, "use.py").write_text(use)
            files = sorted(Path(folder).glob("*.py"))
            self.assertEqual(len(files), 5)
            found = mypy(*files).stdout  # all at once: a start of mypy takes longer than a module
        self.assertRegex(found, r'use.py:3: note: Revealed type is ".*pad\.Certified')
        self.assertRegex(found, r'use.py:4: note: Revealed type is "pad\.Parameters"')
        self.assertRegex(found, r"use.py:5: error: .*Parameters")
        self.assertIn("Found 1 error in 1 file", found)

    def test_of_the_extension_are_those_of_its_stub(self):
        allowed = PROJECT / "tests/python/stubtest_allowed.txt"
        result = checked("mypy.stubtest", "vcrit._vcrit", "--allowlist", str(allowed))
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_are_announced(self):
        self.assertTrue((PACKAGE / "py.typed").is_file())


if __name__ == "__main__":
    unittest.main()
