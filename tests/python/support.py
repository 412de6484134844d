"""What the tests of the Python package share."""

import csv
import os
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

PROJECT, PROGRAM = Path(sys.argv.pop(1)), sys.argv.pop(1)
os.chdir(PROJECT)

# A unit in the last place, relative.
U = 2.0**-53


def program(*arguments):
    """The program run in the project's folder."""
    return subprocess.run([PROGRAM, *arguments], cwd=PROJECT, capture_output=True, text=True, timeout=60)


def rows(name, expected):
    """A table of tests/data, with so many rows: a test over none would pass."""
    with (PROJECT / "tests/data" / name).open() as file:
        found = list(csv.DictReader(file))
    if len(found) != expected:
        raise AssertionError(f"tests/data/{name}: found {len(found)} rows; expected {expected}")
    return found


def relative_difference(value, reference):
    """Exactly, of two numbers given in any way."""
    reference = Fraction(reference)
    return abs(Fraction(value) - reference) / reference


def in_python(code, *arguments):
    """A program in a process of its own, which sees what this one sees."""
    return subprocess.run([sys.executable, "-B", "-c", code, *map(str, arguments)],
                          cwd=PROJECT, capture_output=True, text=True, timeout=120)
