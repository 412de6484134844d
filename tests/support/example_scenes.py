"""The scenes of the repository, and which of them have a formula of v*: the program says so, and no test by their names."""

import functools
import subprocess
from pathlib import Path

SCENES = Path(__file__).resolve().parents[2] / "scenes"
# As the rulebook says it; tests/rules has all of its words.
NO_FORMULA = "has no formula"


@functools.cache
def has_formula(program, scene):
    """Whether `vcrit derive` has one, in the form that takes no search. Anything but a formula or the refusal that there is
    none is an error."""
    result = subprocess.run([program, "derive", scene, "--form", "nested"], cwd=SCENES.parent, capture_output=True, text=True, timeout=300)
    if result.returncode == 0 and not result.stderr:
        return True
    if (result.returncode, result.stdout) == (3, "") and NO_FORMULA in result.stderr:
        return False
    raise AssertionError(f"vcrit derive {scene}: status {result.returncode}; {result.stderr}")


def with_formula(program):
    """The files of those that have one, in the order of their names."""
    everything = sorted(SCENES.glob("*.toml"))
    found = [scene for scene in everything if has_formula(program, scene)]
    if not len(everything) - 3 <= len(found) < len(everything):
        raise AssertionError(f"{len(found)} of {len(everything)} scenes have a formula; expected all but one or a few")
    return found
