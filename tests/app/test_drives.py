"""Drives with masses of their own and measured drives, as a user meets them: values, sweeps, and one clear
message with its exit status for each thing that is wrong or not known."""

import csv
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, PROGRAM = Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
SONOTRODE, MEASURED = str(PROJECT / "scenes/sonotrode.toml"), str(PROJECT / "scenes/measured_drive.toml")
REST = """
[oscillation]
angular_frequency = 2
amplitude = 0.1
indentation = 1
[friction]
coefficient = 0.5
"""


def run(*arguments, folder=PROJECT):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, timeout=120)


class Case(unittest.TestCase):
    def value(self, *arguments, folder=PROJECT):
        result = run("eval", *arguments, "--json", folder=folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)["critical_velocity"]

    def refused(self, status, *arguments, folder=PROJECT):
        result = run(*arguments, folder=folder)
        self.assertEqual((result.returncode, result.stdout), (status, ""), result.stderr)
        errors = [line for line in result.stderr.splitlines() if "warning:" not in line]
        self.assertEqual(len(errors), 1, result.stderr)
        return errors[0].removeprefix("vcrit: ")

    def scene_refused(self, text, table=None):
        """The message of `eval` for a scene s.toml, with a table r.csv beside it."""
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "s.toml").write_text(text)
            if table is not None:
                Path(folder, "r.csv").write_text(table)
            return self.refused(2, "eval", "s.toml", folder=folder)


class Masses(Case):
    def drive(self, network, rest=""):
        return self.scene_refused(f'[contact]\nnormal = "kn"\npoisson = 0.3\n[drive]\nnetwork = "{network}"\n' + rest)

    def graph(self, edges, terminals='["a", "b"]', drive='[drive]\nnetwork = "g"\n'):
        return self.scene_refused('[contact]\nnormal = "kn"\npoisson = 0.3\n' + drive +
                                  f"[networks.g]\nterminals = {terminals}\nedges = [{edges}]\n")

    def test_a_mass_between_moving_points(self):
        expected = ('s.toml:5:11: found mass "m1" between two moving points; expected one end of each mass at the far '
                    'end of the drive, as in "k1 - (mass(m1) | k2)", or at node "ground" of a graph')
        self.assertEqual(self.drive("mass(m1) - k1"), expected)
        self.assertEqual(self.graph('["k1", "a", "1"], ["k2", "1", "b"], ["mass(m1)", "a", "1"]'), expected)

    def test_a_mass_in_a_contact(self):
        self.assertEqual(self.scene_refused('[contact]\nnormal = "kn | mass(m1)"\npoisson = 0.3\n'),
                         "s.toml:2:10: found a mass in the normal network; expected springs and dampers: only a [drive] "
                         "may hold masses")
        self.assertIn("s.toml:3:14: found a mass in the tangential network",
                      self.scene_refused('[contact]\nnormal = "kn"\ntangential = "kt | mass(m1)"\n'))

    def test_a_drive_without_a_static_path(self):
        for network in ["mass(m1)", "k1 - mass(m1)", "mass(m1) | k1 - mass(m2)"]:
            with self.subTest(network=network):
                self.assertEqual(self.drive(network),
                                 "s.toml:5:11: found a drive in which only masses lead to the far end; expected a path of "
                                 "springs and dampers, to balance the mean friction")
        self.assertIn("a drive network that elements of value 0 cut in two",
                      self.drive("mass(m1) | k1", "[elements]\nk1 = 0\nm1 = 1\n"))

    def test_ground_is_for_masses(self):
        self.assertEqual(self.graph('["k1", "a", "b"],\n ["k2", "a", "ground"]'),
                         's.toml:9:2: found an edge to "ground" other than a mass ("k2"); expected mass(...): springs and '
                         "dampers have no end at inertial ground")
        self.assertIn('found "ground" as the first terminal; expected the body\'s end first',
                      self.graph('["k1", "ground", "b"], ["mass(m1)", "b", "ground"]', '["ground", "b"]'))

    def test_names_and_units(self):
        self.assertIn('s.toml:7:6: found "3 N/m" (a unit of another dimension); expected a mass in kg',
                      self.drive("kd | mass(m1)", '[elements]\nm1 = "3 N/m"\n'))
        self.assertIn('found "k1" as a mass; expected a spring', self.drive("k1 | mass(k1)"))
        self.assertIn('found "m" as an element', self.drive("kd | mass(m)", "[body]\nmass = 1\n"))
        self.assertIn("no value for m1", self.drive("kd | mass(m1)", "[elements]\nkn = 1\nkd = 1\n" + REST))
        self.assertIn("m1 = -1; expected a finite value of at least 0",
                      self.drive("kd | mass(m1)", "[elements]\nm1 = -1\n"))

    def test_what_knows_one_body_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            for command in [["simulate", SONOTRODE, "--velocity", "0.001"], ["critical", SONOTRODE],
                            ["sweep", SONOTRODE, "--over", "velocity_ratio=lin:0.5:1:3", "--quantity", "friction_ratio",
                             "--out", "t.csv"]]:
                self.assertEqual(self.refused(3, *command, folder=folder),
                                 "the simulator knows one body; this drive holds masses of its own")
            self.assertEqual(self.refused(3, "generate", SONOTRODE, "--out", "lib", folder=folder),
                             "the generator knows one body; this drive holds masses of its own")
            self.assertEqual(list(Path(folder).iterdir()), [], "nothing is written")

    def test_a_mass_is_set_and_swept_like_any_value(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("sweep", SONOTRODE, "--over", "ms=lin:10 g:50 g:3", "--quantity", "critical_velocity", "--out",
                         "t.csv", folder=folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            rows = list(csv.DictReader(Path(folder, "t.csv").read_text().splitlines()))
            self.assertEqual([row["ms"] for row in rows], ["0.01", "0.03", "0.05"])
            for row in rows:
                self.assertEqual(float(row["critical_velocity"]), self.value(SONOTRODE, "--set", f"ms={row['ms']}"))
        self.assertEqual(self.value(SONOTRODE, "--set", "ms=60 g"), self.value(SONOTRODE))
        # A body and a mass at the near end of the drive are one thing.
        text = Path(SONOTRODE).read_text().replace('"kf - (', '"mass(m) | kf - (').replace('[body]\nmass = "4 g"', "")
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "s.toml").write_text(text + 'm = "4 g"\n')
            self.assertEqual(self.value("s.toml", folder=folder), self.value(SONOTRODE))


class Measured(Case):
    SCENE = '[contact]\nnormal = "kn"\npoisson = 0.3\n[drive]\nreceptance = "r.csv"\n[elements]\nkn = 1\n' + REST

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
                self.assertIn(message, self.scene_refused(self.SCENE, table))

    def test_wrong_scenes(self):
        self.assertIn('s.toml:5:14: found receptance = "r.csv", which is no file; expected a table in CSV',
                      self.scene_refused(self.SCENE))
        self.assertIn("s.toml:5:14: found network and receptance; expected one of the two",
                      self.scene_refused(self.SCENE.replace('"r.csv"', '"r.csv"\nnetwork = "kd"')))

    def test_outside_the_table_ends_with_3(self):
        self.assertRegex(self.refused(3, "eval", MEASURED, "--set", "frequency=10 kHz"),
                         r"omega = 62831.8530717958\d* rad/s is outside the receptance in .*measured_drive.csv, 94247.8 to "
                         r"169646 rad/s")

    def test_what_needs_a_network_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            for command in [["simulate", MEASURED, "--velocity", "0.001"], ["critical", MEASURED],
                            ["sweep", MEASURED, "--over", "velocity_ratio=lin:0.5:1:3", "--quantity", "friction_ratio",
                             "--out", "t.csv"]]:
                self.assertIn("the simulator needs a network; this drive is a measured receptance",
                              self.refused(3, *command, folder=folder))
            self.assertEqual(self.refused(3, "generate", MEASURED, "--out", "lib", folder=folder),
                             "the generator needs a network; this drive is a measured receptance")
            self.assertEqual(list(Path(folder).iterdir()), [], "nothing is written")

    # The table is found beside the scene, wherever the program runs, and each row is evaluated on its own.
    def test_a_sweep_over_the_frequency(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("sweep", MEASURED, "--over", "frequency=lin:16 kHz:28 kHz:25", "--quantity",
                         "critical_velocity", "--out", "t.csv", folder=folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("3 of 25 rows are outside the model (nan); the first: omega = ", result.stderr)
            rows = list(csv.DictReader(Path(folder, "t.csv").read_text().splitlines()))
        for row in rows:
            velocity = float(row["critical_velocity"])
            if float(row["frequency"]) >= 27e3:  # the table ends at 169646 rad/s, a little below 27 kHz
                self.assertTrue(math.isnan(velocity))
            else:
                self.assertEqual(velocity, self.value(MEASURED, "--set", f"frequency={row['frequency']}"))

    def test_derive_keeps_the_table_as_a_name(self):
        shown = run("derive", MEASURED).stdout
        self.assertIn("K_d = 1/R_d", shown)
        self.assertIn("abs(1 - R_d*m*omega^2)", shown.splitlines()[-1])


if __name__ == "__main__":
    unittest.main()
