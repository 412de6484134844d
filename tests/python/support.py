"""What the tests of the Python package share."""

import os
import subprocess
import sys
from fractions import Fraction

from example_scenes import has_formula
from program import PROGRAM, PROJECT, rows, scene  # noqa: F401
from program import run as program  # noqa: F401

os.chdir(PROJECT)

# An undamped drive in resonance, kd = m omega^2 exactly: 4 = 1 x 2^2.
RESONANT = scene({"k": 1, "kd": 4}, normal="k", tangential_ratio=0.5, network="kd", mass=1, indentation=0.5,
                 coefficient=0.25)

# A unit in the last place, relative.
U = 2.0**-53


# Where v* is a maximum over the phase: steps are good to 1e-14 each, and some ten of them reach a phase.
OF_MAXIMUM = 1e-13


def scene_rows():
    """Of all scenes in scenes/: their values in many digits."""
    return rows("scenes_expected.csv", 16)


def formula_rows(with_one=True):
    """Of those with a formula of v*, or of those without."""
    found = [row for row in scene_rows() if has_formula(PROGRAM, PROJECT / "scenes" / row["scene"]) == with_one]
    assert found
    return found


def relative_difference(value, reference):
    """Exactly, of two numbers given in any way."""
    reference = Fraction(reference)
    return abs(Fraction(value) - reference) / reference


def in_python(code, *arguments):
    """A program in a process of its own, which sees what this one sees."""
    return subprocess.run([sys.executable, "-B", "-c", code, *map(str, arguments)],
                          cwd=PROJECT, capture_output=True, text=True, timeout=120)
