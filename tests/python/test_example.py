"""examples/notebook.py, run cell by cell as a notebook does, and as a script."""

import io
import re
import subprocess
import sys
import unittest
from contextlib import redirect_stdout

import numpy as np
import vcrit
from IPython.core.interactiveshell import InteractiveShell
from support import PROJECT

EXAMPLE = PROJECT / "examples/notebook.py"


class Notebook:
    """What the cells print, and what is shown of their last lines."""

    def __init__(self, file):
        self.printed, self.shown = [], []
        shell = InteractiveShell.instance()
        shell.history_manager.enabled = False
        shell.displayhook.write_format_data = lambda data, metadata=None: self.shown.append(data)
        shell.displayhook.write_output_prompt = lambda: None
        shell.displayhook.finish_displayhook = lambda: None
        self.names = shell.user_ns
        self.names["__file__"] = str(file)
        for cell in re.split(r"^# %%", file.read_text(), flags=re.MULTILINE)[1:]:
            out = io.StringIO()
            with redirect_stdout(out):
                shell.run_cell("#" + cell).raise_error()
            self.printed.append(out.getvalue())


class Example(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.notebook = Notebook(EXAMPLE)
        cls.names = cls.notebook.names

    def test_shows_formula_and_limit(self):
        scene = vcrit.Scene("scenes/zener.toml")
        shown = [data.get("text/latex") for data in self.notebook.shown]
        # By hand: a rigid drive leaves mu0 omega du_z/r with r = 2(1 - 0.3)/(2 - 0.3) = 14/17.
        rigid = r"$\displaystyle v^{*} = \frac{17}{14} \mu_{0} \omega \Delta u_{z}$"
        self.assertEqual(shown, [vcrit.derive(scene)._repr_latex_(), rigid])

    def test_finds_the_resonance_on_the_map(self):
        frequency, drive = self.names["frequency"], self.names["drive"]
        step = frequency[1] - frequency[0]
        for stiffness, row in zip(drive.flat, self.names["v_star"]):
            # kd = m omega^2 with 5 g.
            resonance = np.sqrt(stiffness / 5e-3) / (2 * np.pi)
            self.assertLessEqual(abs(frequency[np.argmax(row)] - resonance), step)

    def test_draws_it(self):
        drawing = next(text for text in self.notebook.printed if "kHz" in text).splitlines()
        self.assertEqual(len(drawing), 10)
        for line in drawing[:9]:
            self.assertEqual(len(line.split("|")[1]), 67)
        self.assertTrue(any("@" in line for line in drawing))

    def test_friction_agrees_with_the_formula(self):
        curve = self.names["curve"]
        np.testing.assert_array_equal(curve.friction_ratio == 1, curve.velocity_ratio > 1)
        self.assertTrue((np.diff(curve.friction_ratio) >= 0).all())
        self.assertEqual(self.notebook.printed[-1], "just below v*: stick-slip\njust above v*: sliding\n")

    def test_runs_as_a_script(self):
        result = subprocess.run([sys.executable, "-B", EXAMPLE], cwd="/", capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "".join(self.notebook.printed))


if __name__ == "__main__":
    unittest.main()
