"""A contact that opens, through the program: what it says of v*, of the motion, and of the map across
the border of separation."""

import unittest
from pathlib import Path

from program import Case, example

JUMPING = example("separation")


class Separation(Case):
    def changed(self, old, new):
        text = Path(JUMPING).read_text()
        self.assertEqual(text.count(old), 1, old)
        return self.write(text.replace(old, new))

    def simulated(self):
        return self.changed("poisson    = 0.3", 'tangential = "kelvin(k0, c1)"')

    def test_the_closed_form_is_kept(self):
        answer = self.answer("eval", JUMPING)
        self.assertTrue(answer["admissible"] and answer["opens"])
        self.assertEqual(answer["critical_velocity_by"], "formula")
        compared = self.answer("critical", JUMPING)
        self.assertTrue(compared["agree"])
        self.assertLess(compared["stick_onset_difference"], 1e-9)

    def test_elsewhere_v_is_simulated_and_says_so(self):
        scene = self.simulated()
        answer = self.answer("eval", scene)
        self.assertEqual(answer["critical_velocity_by"], "simulation")
        self.assertIsNone(answer["relative_error_bound"])
        self.assertIn("(simulated)", self.out("eval", scene))
        self.refused(3, ["critical", scene])
        self.refused(3, ["generate", scene, "--out", "out"])
        self.assertFalse((self.folder / "out").exists())
        # 1 % about it the motion changes from stick-slip to sliding.
        for ratio, regime in ((0.99, "stick-slip-apart"), (1.01, "sliding-apart")):
            motion = self.answer("simulate", scene, "--velocity-ratio", ratio)
            self.assertEqual(motion["regime"], regime)
            self.assertAlmostEqual(motion["velocity"] / answer["critical_velocity"], ratio, delta=1e-15)

    def test_a_motion_tells_of_both_starts(self):
        for start in ("sliding", "rest"):
            motion = self.answer("simulate", JUMPING, "--velocity-ratio", 0.3, "--start", start)
            self.assertEqual({event["to"] for event in motion["events"]}, {"slip", "apart", "stick"})
            separation = motion["separation"]
            self.assertTrue(separation["starts_agree"])
            self.assertLessEqual(abs(separation["other_start"]["friction_ratio"] - motion["friction_ratio"]),
                                 2 * motion["friction_ratio_error"])
            # More than K_n(0) u_z0 = 4 N: nothing pulls while it is open.
            self.assertGreater(separation["mean_normal_force"], 4)
            work = motion["energy"]
            self.assertLess(abs(work["drive"] - work["friction"] - work["dampers"]), work["error"])

    def test_starts_that_disagree_are_within_the_error(self):
        # A part in 2e8 off the fourth harmonic, undamped: a search stops where little changes from cycle to cycle.
        scene = self.scene({"kn": 4932956.987521647, "kd": 408321.35136545345}, tangential_ratio=0.5, separation=True,
                           network="kd", mass=0.0001497611070636386, angular_frequency=13053.937581869824,
                           amplitude=1.8754805392037193e-09, indentation=1.0204906617695415e-09,
                           coefficient=0.2669343414071576)
        disagreed = 0
        for velocity in (1297.6137876710734, 1296.3161725870861):
            answer = self.answer("simulate", scene, "--velocity", velocity)
            other = answer["separation"]["other_start"]
            difference = abs(answer["friction_ratio"] - other["friction_ratio"])
            self.assertLessEqual(difference, answer["friction_ratio_error"] + other["friction_ratio_error"])
            # A map has the same error, which covers both.
            row, _ = self.table(scene, "--over", f"velocity=lin:{velocity!r}:{2 * velocity!r}:2",
                                "--quantity", "friction_ratio", "--quantity", "friction_ratio_error")
            for each in (answer["friction_ratio"], other["friction_ratio"]):
                self.assertLessEqual(abs(float(row["friction_ratio"]) - each), float(row["friction_ratio_error"])
                                     + other["friction_ratio_error"])
            if not answer["separation"]["starts_agree"]:
                disagreed += 1
                self.assertGreater(float(row["friction_ratio_error"]), difference / 2)
        self.assertGreater(disagreed, 0)

    def test_without_separation_the_scene_is_outside_the_model(self):
        scene = self.changed("separation = true                # F_n = max(0, reaction), no adhesion\n", "")
        answer = self.answer("eval", scene)
        self.assertFalse(answer["admissible"])
        self.assertNotIn("opens", answer)
        self.refused(3, ["simulate", scene, "--velocity", "0.01"])
        self.write(scene.read_text().replace("1.5 um", "0.1 um"))
        self.assertNotIn("separation", self.answer("simulate", scene, "--velocity", "0.001"))

    def test_the_map_crosses_the_border(self):
        scene = self.simulated()
        rows = self.table(scene, "--over", "amplitude=log:1e-7:2e-6:7", "--over", "velocity_ratio=lin:0.1:1.3:5",
                          "--quantity", "friction_ratio", "--quantity", "regime", "--quantity", "critical_velocity")
        self.assertEqual(len(rows), 35)
        self.assertTrue({"sliding", "stick-slip", "sliding-apart", "stick-slip-apart"} <= {r["regime"] for r in rows})
        for row in rows[::6]:
            setting = ("--set", f"amplitude={row['amplitude']}")
            motion = self.answer("simulate", scene, *setting, "--velocity-ratio", row["velocity_ratio"])
            self.assertEqual(motion["regime"], row["regime"])
            # The sweep begins each search at the speed before: both are good to their errors.
            self.assertAlmostEqual(motion["friction_ratio"], float(row["friction_ratio"]), delta=1e-12)
            answer = self.answer("eval", scene, *setting)
            self.assertAlmostEqual(answer["critical_velocity"] / float(row["critical_velocity"]), 1, delta=1e-12)

    def test_a_velocity_is_found(self):
        found = self.answer("solve", JUMPING, "--for", "velocity", "--friction-ratio", 0.5)
        motion = self.answer("simulate", JUMPING, "--velocity", found["velocity"])
        self.assertAlmostEqual(motion["friction_ratio"], 0.5, delta=1e-9)
        self.assertEqual(motion["regime"], "stick-slip-apart")

    def test_a_contact_that_only_taps(self):
        tapping = (JUMPING, "--set", "indentation=0")
        answer = self.answer("eval", *tapping)
        self.assertTrue(answer["admissible"] and answer["opens"])
        ratio = self.answer("simulate", *tapping, "--velocity", answer["critical_velocity"] / 2)["friction_ratio"]
        found = self.answer("solve", *tapping, "--for", "velocity", "--friction-ratio", ratio)
        self.assertAlmostEqual(found["velocity"] / answer["critical_velocity"], 0.5, delta=1e-9)
        self.assertIn("contact closed      at no amplitude\n", self.run_program(
            "solve", *tapping, "--for", "velocity", "--friction-ratio", ratio).stdout)
        self.refused(3, ["solve", *tapping, "--for", "amplitude", "--friction-ratio", 0.5, "--velocity", 1e-3],
                     "without an indentation u_z0 the contact opens at every amplitude")
        table = self.folder / "table.csv"
        self.assertEqual(self.run_program("sweep", JUMPING, "--over", "indentation=lin:0:1e-7:2", "--quantity", "admissible",
                                          "--quantity", "critical_velocity", "--out", table).returncode, 0)
        self.assertIn(f"0,yes,{answer['critical_velocity']}", table.read_text())

    def test_a_contact_that_never_closes(self):
        apart = (JUMPING, "--set", "indentation=0", "--set", "amplitude=0")
        answer = self.answer("eval", *apart)
        self.assertEqual((answer["admissible"], answer["reasons"]), (False, ["the contact never closes"]))
        self.assertIn("No answer: the contact never closes.\n", self.run_program("eval", *apart).stdout)
        self.refused(3, ["simulate", *apart, "--velocity", 1e-3], "the contact never closes")

    def test_derive_says_where_the_formula_holds(self):
        self.assertTrue(self.answer("derive", JUMPING)["separation"]["closed_form"])
        derived = self.answer("derive", self.simulated())
        self.assertEqual(derived["separation"], {"closed_form": False, "lines": []})
        self.assertNotIn("separation", self.answer("derive", example("zener")))


if __name__ == "__main__":
    unittest.main()
