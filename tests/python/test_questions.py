"""solve, sweep and fit in Python: closed forms, and what the program answers to the same questions."""

import csv
import io
import json
import math
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np
import vcrit
from support import PROJECT, program

ELASTIC = vcrit.Scene("scenes/elastic.toml")
# Eq. (31) with the numbers of the scene.
VELOCITY = 0.3 * 2 * math.pi * 20e3 * 0.1e-6 * 11.5 / 9.47
# Friction of an elastic contact is 1 - D G(v0/v*), D = du_z/u_z0; G by 30-digit root finding as in
# tests/consumer/test_examples.py.
G = {0.1: 0.75717136015312994339, 0.5: 0.2014522033336686888, 0.9: 0.0073108103345282100357}
# What the simulation promises for friction.
PROMISED = 1e-9


def told(*arguments):
    return json.loads(program(*arguments, "--json").stdout)


class Solve(unittest.TestCase):
    RATIO = 1 - G[0.5] / 3

    def test_finds_what_the_closed_form_has(self):
        # dG/dx is -0.75 there: a change of 1e-9 in friction moves the speed by less than 1e-8 of it.
        found = ELASTIC.solve("velocity", self.RATIO)
        self.assertAlmostEqual(found.value / (0.5 * VELOCITY), 1, delta=2e-8)
        self.assertEqual((found.sought, found.unit), ("velocity", "m/s"))
        self.assertAlmostEqual(found.friction_ratio, self.RATIO, delta=2 * PROMISED)
        # v* grows with the amplitude as D does.
        found = ELASTIC.solve("amplitude", self.RATIO, velocity=0.5 * VELOCITY)
        self.assertAlmostEqual(found.value / 1e-7, 1, delta=2e-8)
        self.assertAlmostEqual(found.largest_amplitude / 3e-7, 1, delta=1e-12)

    def test_answers_as_the_program(self):
        file = "scenes/zener.toml"
        found = vcrit.Scene(file).solve("frequency", 0.9, velocity="2 mm/s", from_="5 kHz", to=50e3, samples=50)
        printed = told("solve", file, "--for", "frequency", "--friction-ratio", "0.9", "--velocity", "2 mm/s",
                       "--from", "5 kHz", "--to", "50e3", "--samples", "50")
        for name in ["value", "unit", "value_error", "at_start", "friction_ratio", "friction_ratio_error", "regime",
                     "velocity", "critical_velocity"]:
            self.assertEqual(getattr(found, name), printed[name], name)
        self.assertEqual(found.largest_amplitude, printed["limits"]["amplitude"])
        self.assertEqual(found.searched, (printed["searched"]["from"], printed["searched"]["to"]))
        self.assertEqual(pickle.loads(pickle.dumps(found)), found)

    def test_names_arguments_of_python(self):
        for words, arguments, named in [
                ('^sought: found "mass"; expected one of amplitude, frequency, force, velocity', ("mass", 0.5), {}),
                ("^velocity: found none; expected the velocity", ("amplitude", 0.5), {}),
                ("^velocity: found a velocity, which is sought", ("velocity", 0.5), {"velocity": 1.0}),
                ("^friction_ratio: found 1; expected", ("velocity", 1.0), {}),
                ("^from_: found -1 m/s; expected a number above 0", ("velocity", 0.5), {"from_": -1.0}),
                ("^from_, to: found from 2 mm/s to 1 mm/s", ("velocity", 0.5), {"from_": "2 mm/s", "to": "1 mm/s"}),
                ('^to: found "1 Hz"', ("velocity", 0.5), {"to": "1 Hz"}),
                ("^samples: found 2", ("velocity", 0.5), {"samples": 2})]:
            with self.subTest(words), self.assertRaisesRegex(vcrit.InputError, words) as caught:
                ELASTIC.solve(*arguments, **named)
            self.assertNotIn("--", str(caught.exception))

    def test_warns_of_frequencies_beyond_the_data(self):
        text = (PROJECT / "scenes/elastic.toml").read_text().replace(
            "[contact]", '[contact]\nfitted_range = ["19 kHz", "21 kHz"]')
        scene = vcrit.Scene.from_text(text)
        with self.assertWarnsRegex(UserWarning, "fitted to data from 19 kHz to 21 kHz") as caught:
            scene.solve("frequency", self.RATIO, velocity=0.5 * VELOCITY)
        self.assertEqual(caught.filename, __file__)


class Sweep(unittest.TestCase):
    def test_has_the_closed_form_on_its_grid(self):
        amplitude = np.array([0.05e-6, 0.1e-6, 0.2e-6])
        found = ELASTIC.sweep({"amplitude": amplitude, "velocity_ratio": list(G)},
                              ["friction_ratio", "critical_velocity", "regime", "admissible", "sensitivity:mu0"])
        self.assertEqual(found.shape, (3, 3))
        expected = 1 - np.outer(amplitude / 0.3e-6, list(G.values()))
        np.testing.assert_allclose(found["friction_ratio"], expected, rtol=0, atol=PROMISED)
        np.testing.assert_allclose(found["critical_velocity"], np.outer(amplitude, [VELOCITY / 0.1e-6] * 3), rtol=1e-13)
        np.testing.assert_array_equal(found["regime"], np.full((3, 3), "stick-slip"))
        self.assertEqual(found["admissible"].dtype, np.bool_)
        self.assertTrue(found["admissible"].all())
        np.testing.assert_allclose(found["sensitivity_mu0"], 1, rtol=1e-12)
        np.testing.assert_array_equal(found["amplitude"], amplitude)
        self.assertEqual(found.units["critical_velocity"], "m/s")
        self.assertEqual(repr(found), "<vcrit.Sweep: friction_ratio, critical_velocity, regime, admissible, "
                                      "sensitivity_mu0 over amplitude (3) and velocity_ratio (3)>")

    def test_answers_as_the_program(self):
        over, quantities = {"frequency": "log:1 kHz:100 kHz:5", "kd": ["1 N/um", 2e6]}, ["critical_velocity", "friction_ratio"]
        found = vcrit.Scene("scenes/zener.toml").sweep(over, quantities, velocity="1 mm/s")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.csv"
            result = program("sweep", "scenes/zener.toml", "--over", f"frequency={over['frequency']}", "--over",
                             "kd=lin:1e6:2e6:2", "--velocity", "1 mm/s", "--quantity", *quantities, "--out", file)
            self.assertEqual(result.returncode, 0, result.stderr)
            rows = list(csv.reader(io.StringIO(file.read_text())))[1:]
        table = np.array(rows, dtype=float)
        np.testing.assert_array_equal(found["frequency"], table[::2, 0])
        for column, name in enumerate(quantities, 2):
            np.testing.assert_array_equal(found[name].ravel(), table[:, column])

    def test_warns_of_points_outside_the_model(self):
        with self.assertWarnsRegex(UserWarning, "1 of 2 points are outside the model .*; the first: ") as caught:
            found = ELASTIC.sweep({"amplitude": ["0.1 um", "0.4 um"]}, "friction_ratio", velocity_ratio=0.5)
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(found.outside, 1)
        np.testing.assert_array_equal(np.isnan(found["friction_ratio"]), [False, True])
        self.assertIn("amplitude", found.reason)

    def test_refuses_in_the_words_of_python(self):
        for words, arguments, named in [
                ('^over k9: found "k9"', ({"k9": [1.0]}, "critical_velocity"), {}),
                ('^quantity: found "friction"', ({"kn": [1.0]}, "friction"), {}),
                ("^over: found no axis", ({}, "critical_velocity"), {}),
                ("^over kn: found an array of shape", ({"kn": [[1.0]]}, "critical_velocity"), {}),
                ("^over kn: found 0 values", ({"kn": []}, "critical_velocity"), {}),
                ("as an axis .over. or as one value", ({"kn": [1.0]}, "friction_ratio"), {}),
                ('^velocity: found "1 Hz"', ({"kn": [1.0]}, "friction_ratio"), {"velocity": "1 Hz"})]:
            with self.subTest(words), self.assertRaisesRegex(vcrit.InputError, words) as caught:
                ELASTIC.sweep(*arguments, **named)
            self.assertNotRegex(str(caught.exception), "--|`")


class Fit(unittest.TestCase):
    TABLE = "docs/tutorial/dma.csv"
    GIVEN = {"poisson": 0.38, "frequency": "28 kHz", "amplitude": "0.2 um", "indentation": "1 um", "coefficient": 0.4}

    def test_finds_the_series_that_made_the_data(self):
        frequency = np.geomspace(10, 1e5, 41)
        x = 2j * np.pi * frequency * 1e-4
        stiffness = 2e6 + 1e6 * x / (1 + x)
        found = vcrit.fit({"frequency": frequency, "storage": stiffness.real, "loss": stiffness.imag})
        # Data of 16 digits: what the search settles to.
        self.assertAlmostEqual(found.equilibrium.value / 2e6, 1, delta=1e-8)
        np.testing.assert_allclose(found.branches.stiffness, [1e6], rtol=1e-8)
        np.testing.assert_allclose(found.branches.time, [1e-4], rtol=1e-8)
        np.testing.assert_allclose(found.stiffness(frequency), stiffness, rtol=1e-8)
        self.assertEqual(found.stiffness(1e3).shape, ())
        self.assertIsNone(found.damper)
        self.assertTrue(repr(found).startswith("<vcrit.Fit: 1 branch and an equilibrium spring, misfit "))

    def test_answers_as_the_program(self):
        found = vcrit.fit(self.TABLE, punch_radius="0.5 mm", **self.GIVEN)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.toml"
            options = [word for name, value in self.GIVEN.items() for word in (f"--{name}", str(value))]
            printed = told("fit", self.TABLE, "--out", file, "--punch-radius", "0.5 mm", *options)
            self.assertEqual(found.text, file.read_text())
        self.assertEqual(found.equilibrium, (printed["equilibrium"], printed["equilibrium_error"]))
        for name in vcrit.Branches._fields:
            np.testing.assert_array_equal(getattr(found.branches, name), [each[name] for each in printed["branches"]])
        for name in vcrit.KnownStiffness._fields[1:]:
            # The program adds the frequency of the oscillation where it lies within the data.
            known = dict(zip((each["frequency"] for each in printed["stiffness"]),
                             (each[name] for each in printed["stiffness"])))
            np.testing.assert_array_equal(getattr(found.known, name), [known[at] for at in found.known.frequency])
        self.assertEqual(found.rms_relative_misfit, printed["rms_relative_misfit"])
        self.assertEqual(list(found.words), printed["words"])
        self.assertGreater(found.scene.critical_velocity(), 0)

    def test_takes_columns_with_units(self):
        with open(PROJECT / self.TABLE) as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        columns = {name: np.array(column, float) for name, *column in zip(*rows)}
        from_columns = vcrit.fit(columns, punch_radius=0.5e-3, **self.GIVEN)
        from_file = vcrit.fit(self.TABLE, punch_radius="0.5 mm", **self.GIVEN)
        np.testing.assert_allclose(from_columns.branches.stiffness, from_file.branches.stiffness, rtol=1e-9)

    def test_warns_of_assumed_units(self):
        table = "frequency,storage,loss\n1,2.00,.20\n4,2.27,.23\n16,2.58,.26\n63,2.93,.30\n250,3.33,.34\n1000,3.80,.38\n"
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.csv"
            file.write_text(table)
            with self.assertWarnsRegex(UserWarning, "N/m") as caught:
                vcrit.fit(file)
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # arrays are in SI
            columns = dict(zip(["frequency", "storage", "loss"],
                               np.loadtxt(io.StringIO(table), delimiter=",", skiprows=1).T))
            vcrit.fit(columns)

    def test_refuses_in_the_words_of_python(self):
        three = {"frequency": [1, 2, 3], "storage": [1, 2, 3], "loss": [1, 1, 1]}
        moduli = {"frequency": [1, 2, 3], "storage [MPa]": [1, 2, 3], "loss [MPa]": [1, 1, 1]}
        for words, data, named in [
                ("^data:1: found storage in MPa.*or punch_radius and poisson of a flat punch", moduli, {}),
                ("^punch_radius: found no Poisson's ratio beside it; expected poisson", moduli, {"punch_radius": 1e-3}),
                ("^max_branches: found", three, {"max_branches": -1}),
                ("^loss .N/m.: found an array of shape", three | {"loss": [1, 1]}, {}),
                ("^data: found '1 Hz'; expected numbers", three | {"frequency": ["1 Hz"] * 3}, {}),
                ('^data:1: found a column "mass', three | {"mass": [1, 2, 3]}, {}),
                ('^frequency: found "1 m"', {"frequency": [1, 2, 4], "storage": [1, 2, 3], "loss": [.5, .5, .5]},
                 {"frequency": "1 m"})]:
            with self.subTest(words), self.assertRaisesRegex(vcrit.InputError, words) as caught:
                vcrit.fit(data, **named)
            self.assertNotRegex(str(caught.exception), "--|`")


if __name__ == "__main__":
    unittest.main()
