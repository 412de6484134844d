"""Scenes with a mount, as a user meets them: what eval, simulate, sweep and solve say, and one clear message with its
exit status for each thing that is wrong or not known."""

import cmath
import math
import unittest
from pathlib import Path

import drivers
from program import Case, example, scene

MOUNT = example("mount")


class Mounts(Case):
    def mounted(self, mount='network = "km"', elements=(), more="", **changed):
        """A Kelvin contact on a mount, whose section comes first."""
        values = {"kn": 1e7, "cn": 30, "km": 5e6} | dict(elements)
        given = {"normal": "kn | cn", "angular_frequency": 1e5, "amplitude": 1e-7, "indentation": 5e-7} | changed
        return self.write(f"[mount]\n{mount}\n{more}{scene(values, **given)}").name

    def of_many_factors(self):
        """A graph under a mount of four branches: a scene's file, and its numbers."""
        elements = {"ka": 7e5, "kb": 5e5, "ca": 100.0, "cb": 30.0, "cc": 80.0, "kc": 8e5, "k0": 1.5e6, "kt": 3e6,
                    "k1": 1e6, "ct": 120.0, "kd": 9e6, "k": [1.3e6, 8.2e6, 8.3e6, 7e5],
                    "tau": [1.4e-6, 2.4e-5, 6.3e-5, 8.5e-7]}
        bridge = (["a", "b"],
                  [["ka", "a", "1"], ["kb | ca", "a", "2"], ["cb", "1", "2"], ["cc", "1", "b"], ["kc", "2", "b"]])
        text = scene(elements, {"bridge": bridge}, normal="bridge", tangential="kt | (k1 - ct)", network="kd",
                     mass=4e-4, angular_frequency=3.6e5, amplitude=1e-7, indentation=5e-7)
        file = self.write(f'[mount]\nnetwork = "prony(k0, k, tau)"\nmass = "m"\n{text}').name
        return file, {"mu0": 0.3, "omega": 3.6e5, "U": 1e-7, "m": 4e-4} | elements

    def bounds_of_evaluators(self, languages, file, values, *options):
        """Of their values, which are those of eval."""
        expected = self.answer("eval", file)["critical_velocity"]
        for language in ("c++", *languages):
            self.out("generate", file, "--out", ".", "--name", "many", "--language", language, *options)
        layout = drivers.members((self.folder / "many.hpp").read_text())
        row = [x for name, length in layout for x in (values[name] if length else [values[name]])]
        for language in languages:
            (value, bound, fast, fast_bound, *_), = drivers.answers(language, self.folder, [("many", layout)], [(0, row)])
            self.assertLessEqual(abs(value / expected - 1), 2 * bound)
            self.assertLessEqual(abs(fast / expected - 1), 2 * fast_bound)
            yield bound, fast_bound

    def test_evaluators_of_many_factors_have_bounds(self):
        # A factor of v* stood above and below the line: no range of plain doubles held all of them.
        for bound, fast_bound in self.bounds_of_evaluators(("c++", "python", "javascript"), *self.of_many_factors()):
            self.assertLess(bound, 1.2e-16)
            self.assertLess(fast_bound, 1e-12)

    def test_evaluators_without_a_plain_range_compile_without_warnings(self):
        # A number folded in that plain doubles have no range for: a parameter of a function has no use then.
        file, values = self.of_many_factors()
        text = self.folder.joinpath(file).read_text()
        self.write(text.replace("kt = 3000000.0", "kt = 3e290"))
        for bound, _ in self.bounds_of_evaluators(("c99", "cuda"), file, values, "--fix", "kt"):
            self.assertIn("return false;", (self.folder / "many.hpp").read_text())
            self.assertLess(bound, 1.2e-16)

    def test_eval_and_simulate_say_what_arrives_at_the_contact(self):
        scene = self.mounted('network = "km"\nmass = 2e-4')
        stiffness = complex(1e7, 3e6)
        height = 1e-7 * 5e6 / (5e6 + stiffness - 2e-4 * 1e10)
        velocity = 0.3 * 1e5 * abs(height) * (2 - 0.3) / (2 * (1 - 0.3))
        found = self.answer("eval", scene)
        for answer in (found, self.answer("simulate", scene, "--velocity-ratio", "0.5")):
            self.assertAlmostEqual(answer["amplitude"] / abs(height), 1, delta=1e-14)
            self.assertAlmostEqual(answer["mount_phase"], cmath.phase(height), delta=1e-14)
            self.assertEqual(answer["indentation"], 5e-7)
            self.assertAlmostEqual(answer["mean_normal_force"], 5, delta=1e-14)
        self.assertAlmostEqual(found["critical_velocity"] / velocity, 1, delta=1e-14)
        # Of the vibrator: K_n(0) u_z0 over |K_n|, over what the mount leaves.
        largest = 5 / abs(stiffness) / abs(height / 1e-7)
        self.assertAlmostEqual(found["effect"]["largest_closed_amplitude"] / largest, 1, delta=1e-14)
        for amplitude, admissible in ((largest * (1 - 1e-12), True), (largest * (1 + 1e-12), False)):
            self.assertEqual(self.answer("eval", scene, "--set", f"amplitude={amplitude!r}")["admissible"], admissible)

    def test_without_a_mount_there_are_no_such_keys(self):
        found = self.answer("eval", example("tribometer"))
        self.assertEqual({"amplitude", "mount_phase"} & set(found), set())
        self.assertNotIn("contact_amplitude", found["effect"])

    def test_sweeps_vary_the_moving_mass_the_mount_and_the_frequency(self):
        def swept(axis, quantity):
            ran = self.run_program("sweep", MOUNT, "--over", axis, "--quantity", quantity, "--out", "t.csv")
            self.assertEqual(ran.returncode, 0, ran.stderr)
            rows = [line.split(",") for line in Path(self.folder, "t.csv").read_text().split()[1:]]
            return [(float(x), float(y)) for x, y in rows]

        for axis, name in (("mount.mass=lin:1e-3:3e-3:5", "mount.mass"), ("km=log:1e7:3e7:4", "km"),
                           ("frequency=lin:1e4:3e4:4", "frequency")):
            for x, found in swept(axis, "contact_amplitude"):
                alone = self.answer("eval", MOUNT, "--set", f"{name}={x!r}")
                self.assertAlmostEqual(found / alone["amplitude"], 1, delta=1e-15)
        for x, found in swept("mount.mass=lin:1e-3:3e-3:5", "critical_velocity"):
            alone = self.answer("eval", MOUNT, "--set", f"mount.mass={x!r}")
            # One that opens has no v* in a table.
            self.assertTrue(found == alone["critical_velocity"] if alone["admissible"] else math.isnan(found))

    # What simulate then meets.
    def test_solve_answers(self):
        at = ["--velocity", "2 mm/s"]
        for sought, velocity in (("amplitude", at), ("force", at), ("frequency", at), ("velocity", [])):
            result = self.answer("solve", MOUNT, "--for", sought, "--friction-ratio", "0.9", *velocity)
            changed = [] if sought == "velocity" else ["--set", f"{sought}={result['value']!r}"]
            ran = self.answer("simulate", MOUNT, "--velocity", repr(result["velocity"]), *changed)
            self.assertAlmostEqual(ran["friction_ratio"], 0.9, delta=1e-12)

    def test_an_undamped_resonance_has_no_number_that_is_none(self):
        # In doubles, too: 2^-10 kg times 1e10 (rad/s)^2 is 9765625 N/m.
        self.mounted('network = "km"\nmass = 9.765625e-4', {"kn": 4765625}, normal="kn")
        found = self.answer("eval", "s.toml")
        self.assertFalse(found["admissible"])
        self.assertEqual(found["amplitude"], "inf")
        self.assertEqual(found["mount_phase"], -math.pi / 2)
        self.assertEqual(found["critical_velocity"], "inf")
        self.assertNotIn("largest_closed_amplitude", found["effect"])
        self.refused(3, ["simulate", "s.toml", "--velocity", "1e-3"], "(Eq. ")

    def test_what_is_no_mount_is_wrong_input(self):
        def said(*words, **scene):
            return self.refused(2, ["eval", self.mounted(**scene)], *words)

        said("s.toml:2:11: found a mass in the mount; expected springs and dampers", mount='network = "km | mass(mm)"',
             elements={"mm": 1e-3})
        said("found a mount that carries no load at rest: K_m(0) = 0", mount='network = "km - cm"', elements={"cm": 3})
        said('no "network" in [mount]', mount="mass = 1e-3")
        said('"weight" in [mount]', mount='network = "km"\nweight = 2')
        said("[indenter] with [mount]", shape="cone", angle=0.1)
        said("found no value for u_z0", "indentation in [oscillation] or force in [load]", indentation=None)

    def test_a_contact_that_may_open_needs_a_load_and_no_mass(self):
        for mount, words in (('network = "km"', "needs a load for its mean force, and none is given"),
                             ('network = "km"\nmass = 1e-4', "height and force react on each other")):
            scene = self.mounted(mount, separation=True)
            for command in (["eval"], ["simulate", "--velocity", "1e-3"], ["critical"], ["generate", "--out", "out"]):
                with self.subTest(mount=mount, command=command):
                    self.refused(3, [command[0], scene, *command[1:]], words)

    # Of springs: the vibrator's place u has <F_n> = k [sqrt(U^2 - u^2) + u acos(-u/U)]/pi.
    def test_a_contact_that_opens_under_a_load(self):
        k, amplitude, place = 1e7 * 5e6 / 1.5e7, 1e-7, 3e-8
        force = k * (math.sqrt(amplitude**2 - place**2) + place * math.acos(-place / amplitude)) / math.pi
        scene = self.mounted(normal="kn", separation=True, indentation=None, more=f"[load]\nforce = {force!r}\n")
        found = self.answer("eval", scene)
        self.assertAlmostEqual(found["indentation"] / (place - force / 5e6), 1, delta=1e-9)
        self.assertTrue(found["opens"])
        self.assertNotIn("amplitude", found)
        self.assertNotIn("contact_amplitude", found["effect"])
        self.assertIn("0.1 µm amplitude of the vibrator,", self.run_program("eval", scene).stdout)
        velocity = 0.3 * 1e5 * amplitude * k / 1e7 * (2 - 0.3) / (2 * (1 - 0.3))
        self.assertAlmostEqual(found["critical_velocity"] / velocity, 1, delta=1e-14)
        ran = self.answer("simulate", scene, "--velocity-ratio", "0.5")
        self.assertEqual({"amplitude", "mount_phase"} & set(ran), set())
        self.assertIn("vibrator's deepest place", self.run_program("simulate", scene, "--velocity-ratio", "0.5").stdout)
        ran = self.run_program("sweep", scene, "--over", "amplitude=lin:1e-8:1e-7:2", "--quantity", "contact_amplitude",
                               "--out", "t.csv")
        rows = [line.split(",") for line in Path(self.folder, "t.csv").read_text().split()[1:]]
        self.assertAlmostEqual(float(rows[0][1]) / (1e-8 * 5e6 / 1.5e7), 1, delta=1e-14)
        self.assertEqual(rows[1][1], "nan")
        self.assertIn("its height has harmonics", ran.stderr)


if __name__ == "__main__":
    unittest.main()
