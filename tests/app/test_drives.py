"""Drives with masses of their own and measured drives, as a user meets them: values, sweeps, and one clear
message with its exit status for each thing that is wrong or not known."""

import json
import math
import unittest
from pathlib import Path

from program import Case, example

SONOTRODE, MEASURED = example("sonotrode"), example("measured_drive")
TO_BE_SET = dict.fromkeys(["angular_frequency", "amplitude", "indentation", "coefficient"])


class Drives(Case):
    def value(self, *arguments):
        return self.answer("eval", *arguments)["critical_velocity"]

    def scene_refused(self, *words, elements=(), networks=(), **changed):
        """The message of `eval` for a scene s.toml."""
        self.scene(elements, networks, **TO_BE_SET | changed)
        return self.refused(2, ["eval", "s.toml"], *words)


class Masses(Drives):
    def drive(self, network, *words, **more):
        return self.scene_refused(*words, network=network, **more)

    def graph(self, edges, *words, terminals=("a", "b")):
        return self.drive("g", *words, networks={"g": (terminals, edges)})

    def test_a_mass_between_moving_points(self):
        expected = ('s.toml:5:11: found mass "m1" between two moving points; expected one end of each mass at the far '
                    'end of the drive, as in "k1 - (mass(m1) | k2)", or at node "ground" of a graph')
        self.assertEqual(self.drive("mass(m1) - k1"), expected)
        self.assertEqual(self.graph([["k1", "a", "1"], ["k2", "1", "b"], ["mass(m1)", "a", "1"]]), expected)

    def test_a_mass_in_a_contact(self):
        self.assertEqual(self.scene_refused(normal="kn | mass(m1)"),
                         "s.toml:2:10: found a mass in the normal network; expected springs and dampers: only a [drive] "
                         "may hold masses")
        self.scene_refused("s.toml:3:14: found a mass in the tangential network", tangential="kt | mass(m1)")

    def test_a_drive_without_a_static_path(self):
        for network in ["mass(m1)", "k1 - mass(m1)", "mass(m1) | k1 - mass(m2)"]:
            with self.subTest(network=network):
                self.assertEqual(self.drive(network),
                                 "s.toml:5:11: found a drive in which only masses lead to the far end; expected a path of "
                                 "springs and dampers, to balance the mean friction")
        self.drive("mass(m1) | k1", "a drive network that elements of value 0 cut in two", elements={"k1": 0, "m1": 1})

    def test_ground_is_for_masses(self):
        self.assertEqual(self.graph([["k1", "a", "b"], ["k2", "a", "ground"]]),
                         's.toml:8:28: found an edge to "ground" other than a mass ("k2"); expected mass(...): springs and '
                         "dampers have no end at inertial ground")
        self.graph([["k1", "ground", "b"], ["mass(m1)", "b", "ground"]],
                   'found "ground" as the first terminal; expected the body\'s end first', terminals=("ground", "b"))

    def test_names_and_units(self):
        for network, elements, more, words in [
                ("kd | mass(m1)", {"m1": "3 N/m"}, {},
                 's.toml:7:6: found "3 N/m" (a unit of another dimension); expected a mass in kg'),
                ("k1 | mass(k1)", {}, {}, 'found "k1" as a mass; expected a spring'),
                ("kd | mass(m)", {}, {"mass": 1}, 'found "m" as an element'),
                ("kd | mass(m1)", {"kn": 1, "kd": 1},
                 {"angular_frequency": 2, "amplitude": 0.1, "indentation": 1, "coefficient": 0.5}, "no value for m1"),
                ("kd | mass(m1)", {"m1": -1}, {}, "m1 = -1; expected a finite value of at least 0")]:
            self.drive(network, words, elements=elements, **more)

    def test_only_the_reduced_model_knows_no_masses(self):
        told = self.refused(3, ["simulate", SONOTRODE, "--velocity", "0.001", "--method", "reduced"])
        self.assertTrue(told.endswith("this scene has a drive that holds masses"), told)

    # The body is the drive's end: together they swing by their response to the same force.
    def test_masses_swing(self):
        answer = self.answer("simulate", SONOTRODE, "--velocity-ratio", "0.5")
        self.assertEqual(list(answer["masses"]), ["m", "ms"])
        for amplitude in answer["masses"].values():
            self.assertTrue(0 < amplitude < 1e-6)
        one_body = self.answer("simulate", example("kelvin"), "--velocity-ratio", "0.5")
        self.assertNotIn("masses", one_body)

    def test_an_evaluator_has_each_mass_as_a_member(self):
        self.out("generate", SONOTRODE, "--out", "lib", "--name", "horn")
        self.assertIn(" double mu0, omega, du_z, m, k0, k1, c1, kf, ms, km, cm; ",
                      (self.folder / "lib/horn.hpp").read_text())

    def test_a_mass_is_set_and_swept_like_any_value(self):
        rows = self.table(SONOTRODE, "--over", "ms=lin:10 g:50 g:3", "--quantity", "critical_velocity")
        self.assertEqual([row["ms"] for row in rows], ["0.01", "0.03", "0.05"])
        for row in rows:
            self.assertEqual(float(row["critical_velocity"]), self.value(SONOTRODE, "--set", f"ms={row['ms']}"))
        self.assertEqual(self.value(SONOTRODE, "--set", "ms=60 g"), self.value(SONOTRODE))
        # A body and a mass at the near end of the drive are one thing.
        text = Path(SONOTRODE).read_text().replace('"kf - (', '"mass(m) | kf - (').replace('[body]\nmass = "4 g"', "")
        self.write(text + 'm = "4 g"\n')
        self.assertEqual(self.value("s.toml"), self.value(SONOTRODE))

    # A light mass that dampers drag decays a billion times faster than the units beside it relax: these are found all the
    # same. With [body] the motion is found without this matrix of all masses.
    def test_a_light_mass_before_units_that_relax_alike(self):
        elements = {"k": [1e6, 2e6, 1.5e6, 3e6], "tau": [9e-6, 1e-5, 1.1e-5, 1.2e-5], "kn": 8e6, "kt": 7e6, "ct": 30}
        values = {"normal": "kn", "tangential": "kt | ct", "angular_frequency": 1e5, "amplitude": 2e-7,
                  "indentation": 5e-7, "coefficient": 0.3}
        for mass in [1e-13, 1e-16]:
            one = self.scene(elements, network="generalized_kelvin(k, tau)", mass=mass, **values)
            expected = self.answer("simulate", one, "--velocity-ratio", "0.5")
            two = self.scene(elements | {"mb": mass}, network="mass(mb) | generalized_kelvin(k, tau)", **values)
            found = self.answer("simulate", two, "--velocity-ratio", "0.5")
            self.assertLess(found["friction_ratio_error"], 1e-13)
            self.assertAlmostEqual(found["friction_ratio"], expected["friction_ratio"], delta=1e-13)

    # Two masses on a rigid link are one; what rounding takes of the drive behind it is stated, or the scene is refused.
    def test_a_link_that_is_nearly_rigid(self):
        values = {"normal": "kn", "tangential": "kt | ct", "angular_frequency": 1e5, "amplitude": 2e-7,
                  "indentation": 5e-7, "coefficient": 0.3}
        elements = {"kd": 3e6, "cd": 20, "kn": 8e6, "kt": 7e6, "ct": 30}
        one = self.scene(elements, network="kd | cd", mass=3e-4, **values)
        expected = self.answer("simulate", one, "--velocity-ratio", "0.5")["friction_ratio"]
        for link in [1e18, 1e21]:
            two = self.scene(elements | {"ks": link, "mm": 2e-4}, network="ks - (mass(mm) | kd | cd)", mass=1e-4, **values)
            found = self.answer("simulate", two, "--velocity-ratio", "0.5")
            self.assertLess(abs(found["friction_ratio"] - expected), found["friction_ratio_error"])
            self.assertLess(found["friction_ratio_error"], 1e-4)
        for network, more in [("ks - (mass(mm) | kd | cd)", {"ks": 1e24}),
                              ("(ks | cs) - (mass(mm) | kd | cd)", {"ks": 1e21, "cs": 1e16})]:
            two = self.scene(elements | more | {"mm": 2e-4}, network=network, mass=1e-4, **values)
            self.refused(3, ["simulate", two, "--velocity-ratio", "0.5"], "so different in stiffness, damping or mass")


class Measured(Drives):
    def measured(self, *words, **more):
        return self.scene_refused(*words, elements={"kn": 1}, receptance="r.csv", angular_frequency=2, amplitude=0.1,
                                  indentation=1, coefficient=0.5, **more)

    def test_wrong_tables_are_told_with_file_and_line(self):
        header = "omega,Re,Im\n"
        for table, message in [
                ("1,2,3\n", 'r.csv:1: found "1,2,3"; expected the header omega,Re,Im'),
                (header + "1,2,3\n", "r.csv:2: found one row of numbers; expected at least two rows"),
                (header + "1,2,3\n2,2\n", 'r.csv:3: found "2,2"; expected three numbers: omega, Re, Im'),
                (header + "1,2,3\n2,a,3\n", 'r.csv:3: found "a"; expected a finite number'),
                (header + "1,2,3\n2,inf,3\n", 'r.csv:3: found "inf"; expected a finite number'),
                (header + "3,2,3\n2,2,3\n", "r.csv:3: found omega = 2 after 3; expected omega increasing")]:
            with self.subTest(message=message):
                self.write(table, "r.csv")
                self.measured(message)

    def test_wrong_scenes(self):
        self.measured('s.toml:5:14: found receptance = "r.csv", which is no file; expected a table in CSV')
        self.measured("s.toml:6:14: found network and receptance; expected one of the two", network="kd")

    def test_outside_the_table_ends_with_3(self):
        self.assertRegex(self.refused(3, ["eval", MEASURED, "--set", "frequency=10 kHz"]),
                         r"10 kHz is outside the receptance in .*measured_drive.csv, 15 kHz to 27 kHz$")

    def test_formula_and_motion_are_compared_within_the_error_of_the_fit(self):
        answer = json.loads(self.run_program("critical", MEASURED, "--json").stdout)
        self.assertTrue(answer["agree"])
        # Real and imaginary part of R_d have five digits: some 1e-4 of it, of which v* is a smooth function.
        self.assertLess(answer["realisation_difference"], 1e-3)
        self.assertGreater(answer["tolerance"], answer["realisation_difference"])
        self.assertLessEqual(answer["relative_difference"], answer["realisation_difference"])
        self.assertIn("a structure fitted to the table", self.run_program("critical", MEASURED).stdout)

    def test_a_contact_that_opens_moves_on_the_fit(self):
        text = Path(MEASURED).read_text().replace("measured_drive.csv", str(Path(MEASURED).with_suffix(".csv")))
        self.write(text.replace("[contact]", "[contact]\nseparation = true"))
        opens = ["s.toml", "--set", "amplitude=0.8um"]
        onset = json.loads(self.run_program("eval", *opens, "--json").stdout)
        self.assertEqual((onset["opens"], onset["critical_velocity_by"]), (True, "simulation"))
        self.assertGreater(onset["relative_error_estimate"], 1e-9)
        answer = self.simulated(*opens)
        fit = answer["realisation"]
        self.assertEqual(fit["critical_velocity"], onset["critical_velocity"])
        self.assertGreaterEqual(answer["friction_ratio_error"], fit["error"])
        self.assertIn("apart", answer["regime"])
        self.assertIn("harmonic 2 of the oscillation, 40.2 kHz, lies outside the table", answer["warnings"][-1])
        self.refused(3, ["critical", *opens], "no closed form of v* where this contact opens, so there is nothing to compare")

    def simulated(self, *arguments):
        return json.loads(self.run_program("simulate", *arguments, "--velocity-ratio", "0.5", "--json").stdout)

    def test_friction_rests_on_a_fit_and_has_its_error(self):
        answer = self.simulated(MEASURED)
        fit = answer["realisation"]
        # Two modes and a compliance, five digits: real and imaginary part are off by 5e-5 of |R| at most, 7.1e-5 together.
        self.assertEqual(fit["pairs"], 2)
        self.assertLess(fit["misfit"], 7.1e-5)
        self.assertEqual(fit["outside"], [2, 3, 4, 5, 6, 7, 8])
        self.assertGreaterEqual(answer["friction_ratio_error"], fit["error"])
        self.assertLess(fit["error"], 1e-4)
        self.assertIn("harmonic 2 of the oscillation, 40.2 kHz, lies outside the table (to 27 kHz): friction below v* rests on an "
                      "extrapolation", answer["warnings"][-1])
        # Between two rows of 250 Hz a resonance of 72 Hz half-width, 2 kHz away, bends by (250/2000)^2/4 of itself.
        self.assertLess(abs(fit["critical_velocity"] / self.value(MEASURED) - 1), 4e-3)

    def test_other_methods_have_the_error_of_the_fit_as_well(self):
        exact = self.simulated(MEASURED)
        for method in ("rk8pd", "moreau"):
            other = self.simulated(MEASURED, "--method", method)
            self.assertEqual(other["realisation"], exact["realisation"])
            self.assertGreaterEqual(other["friction_ratio_error"], other["realisation"]["error"])
            self.assertLessEqual(abs(other["friction_ratio"] - exact["friction_ratio"]), other["friction_ratio_error"])

    def test_the_static_compliance_does_not_matter(self):
        text = Path(MEASURED).read_text().replace("measured_drive.csv", str(Path(MEASURED).with_suffix(".csv")))
        self.write(text.replace("[body]", 'static_compliance = "8 um/N"\n[body]'))
        here, there = self.simulated("s.toml"), self.simulated(MEASURED)
        self.assertLessEqual(abs(here["friction_ratio"] - there["friction_ratio"]), there["realisation"]["error"])
        self.write(text.replace("[body]", 'static_compliance = "1 nm/N"\n[body]'))
        self.refused(2, ["simulate", "s.toml", "--velocity-ratio", "0.5"], "static_compliance = 1 nm/N, less than the")

    def test_tables_of_friction_say_what_their_error_lacks(self):
        ran = self.run_program("sweep", MEASURED, "--over", "velocity_ratio=lin:0.5:1:3", "--quantity", "friction_ratio",
                               "--out", "t.csv")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("its error does not hold that of the fit", ran.stderr)

    def test_an_evaluator_holds_the_table(self):
        self.out("generate", MEASURED, "--out", "lib", "--name", "tool")
        text = (self.folder / "lib/tool.hpp").read_text()
        self.assertIn("// R_d: 49 rows from 94247.8 to 169646 rad/s", text)
        numbers = text.split("rows[] = {")[1].split("};")[0].split(",")
        rows = Path(MEASURED).with_suffix(".csv").read_text().split()[1:]
        self.assertEqual([float(x) for x in numbers], [float(x) for row in rows for x in row.split(",")])

    # The table is found beside the scene, wherever the program runs, and each row is evaluated on its own.
    def test_a_sweep_over_the_frequency(self):
        sweep = [MEASURED, "--over", "frequency=lin:16 kHz:28 kHz:25", "--quantity", "critical_velocity"]
        self.assertIn("3 of 25 rows are outside the model (nan); the first: 27 kHz is outside the receptance",
                      self.run_program("sweep", *sweep, "--out", "told.csv").stderr)
        for row in self.table(*sweep):
            velocity = float(row["critical_velocity"])
            if float(row["frequency"]) >= 27e3:  # the table ends at 169646 rad/s, a little below 27 kHz
                self.assertTrue(math.isnan(velocity))
            else:
                self.assertEqual(velocity, self.value(MEASURED, "--set", f"frequency={row['frequency']}"))

    def test_derive_keeps_the_table_as_a_name(self):
        shown = self.out("derive", MEASURED)
        self.assertIn("K_d = 1/R_d", shown)
        self.assertIn("abs(1 - R_d*m*omega^2)", shown.splitlines()[-1])


if __name__ == "__main__":
    unittest.main()
