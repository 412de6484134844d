"""vcrit solve as a user meets it: the answer goes back into `simulate`, and what cannot be reached is explained."""

import unittest

from program import Case, example, scene, settings

KELVIN, ELASTIC = example("kelvin"), example("elastic")


class Solve(Case):
    def friction(self, velocity, **values):
        return self.answer("simulate", KELVIN, "--velocity", velocity, *settings(values))["friction_ratio"]

    def test_has_its_keys(self):
        result = self.answer("solve", KELVIN, "--for", "amplitude", "--friction-ratio", "0.5", "--velocity", "10 mm/s")
        self.assertEqual(
            list(result),
            ["for", "value", "unit", "value_error", "at_start", "wanted_friction_ratio", "friction_ratio",
             "friction_ratio_error", "regime", "velocity", "critical_velocity", "limits", "searched"])
        self.assertEqual(list(result["limits"]), ["amplitude", "frequency"])
        self.assertEqual(list(result["searched"]), ["from", "to", "samples", "evaluations", "unanswered"])
        self.assertEqual((result["for"], result["unit"], result["velocity"]), ("amplitude", "m", 0.01))
        self.assertEqual(result["regime"], "stick-slip")
        self.assertFalse(result["at_start"])

    # The numbers print so that they read back: simulate sees the same system to the last bit.
    def test_the_answer_reaches_the_ratio_in_simulate_and_a_hundredth_less_does_not(self):
        for sought in ["amplitude", "frequency"]:
            for velocity in [0.004, 0.01]:
                with self.subTest(sought=sought, velocity=velocity):
                    result = self.answer("solve", KELVIN, "--for", sought, "--friction-ratio", "0.75",
                                         "--velocity", velocity)
                    value = result["value"]
                    self.assertEqual(self.friction(velocity, **{sought: value}), result["friction_ratio"])
                    self.assertLessEqual(result["friction_ratio"], 0.75)
                    self.assertAlmostEqual(result["friction_ratio"], 0.75, delta=1e-12)
                    self.assertGreater(self.friction(velocity, **{sought: 0.99 * value}), 0.75)

    def test_the_largest_velocity_reaches_it_and_a_hundredth_more_does_not(self):
        result = self.answer("solve", KELVIN, "--for", "velocity", "--friction-ratio", "0.75")
        self.assertLessEqual(self.friction(result["value"]), 0.75)
        self.assertGreater(self.friction(1.01 * result["value"]), 0.75)
        self.assertEqual(result["velocity"], result["value"])

    def test_a_value_of_what_is_sought_is_not_needed_and_not_taken(self):
        command = ["solve", ELASTIC, "--for", "amplitude", "--friction-ratio", "0.6", "--velocity", "1 mm/s"]
        self.refused(2, [*command, "--set", "du_z=0.1 um"], "du_z with --for amplitude")
        # v* is linear in mu0, so that twice of both is the same question.
        twice = self.answer("solve", ELASTIC, "--for", "amplitude", "--friction-ratio", "0.6", "--velocity", "2 mm/s",
                            "--set", "mu0=0.6")
        once = self.answer(*command)
        self.assertAlmostEqual(twice["value"] / once["value"], 1, delta=1e-12)

    def test_text_says_value_ratio_regime_limits_and_what_was_searched(self):
        result = self.run_program("solve", KELVIN, "--for", "frequency", "--friction-ratio", "0.8", "--velocity", "0.01",
                     "--from", "5 kHz", "--to", "50 kHz", "--samples", "100")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for part in ["From a frequency of 10.5 kHz, the friction ratio at 10 mm/s is 0.8 or less.",
                     "frequency           10.5 kHz, the smallest", "(wanted: 0.8), stick-slip", "10 mm/s, 0.5956 times v*",
                     "below an amplitude of 0.2974 µm, or a frequency of 225.1 kHz",
                     "5 kHz to 50 kHz in 100 samples; a dip narrower than one sample can be missed (use --samples)"]:
            self.assertIn(part, result.stdout)

    def test_what_cannot_be_reached_is_status_3_and_says_why(self):
        for scene, question, words in [
            (ELASTIC, ["--for", "amplitude", "--velocity", "0.2"], "friction stays full at every admissible amplitude"),
            (ELASTIC, ["--for", "frequency", "--velocity", "0.01"], "an amplitude of"),
            (ELASTIC, ["--for", "velocity"], "the amplitude must be above"),
        ]:
            with self.subTest(question=question):
                command = ["solve", scene, *question, "--friction-ratio", "0.5"]
                self.refused(3, command, words)
                result = self.run_program(*command, "--json")
                self.assertEqual((result.returncode, result.stdout), (3, ""))
                self.assertIn(words, result.stderr)

    # Under 100 N the path creeps at 10 mm/s without a slip, under 10 N it slides.
    def test_a_path_that_creeps_has_no_largest_load(self):
        text = scene({"kn": 10e6, "kt": 8e6, "ct": 1000}, tangential="kt - ct", frequency="20 kHz", amplitude="0.1 um",
                     indentation=None)
        file = self.write(text + '[load]\nforce = "10 N"\n')
        command = ["solve", file, "--for", "force", "--friction-ratio", "0.9", "--velocity", "10 mm/s",
                   "--samples", "3"]
        self.refused(3, command, "the path creeps", "give one with --to")
        self.assertTrue(self.out(*command, "--to", "100 N").startswith(
            "At a load of 100 N, the friction ratio at 10 mm/s is 0.9 or less."))

    # A rigid drive has no mass and no drive, in no text.
    def test_what_a_scene_does_not_have_is_not_told(self):
        for question in [["--for", "velocity"], ["--for", "amplitude", "--velocity", "0.2"]]:
            for ratio in ["0.5", "0.9"]:
                result = self.run_program("solve", ELASTIC, *question, "--friction-ratio", ratio)
                for word in ["mass", "body", "resonance", "damper"]:
                    self.assertNotIn(word, result.stdout + result.stderr)

    def test_wrong_questions_are_status_2(self):
        for question, words in [
            (["--for", "amplitude", "--friction-ratio", "0.5"], "the velocity of the drive"),
            (["--for", "velocity", "--friction-ratio", "0.5", "--velocity", "1"], "it is what is sought"),
            (["--for", "velocity", "--friction-ratio", "1"], "between 0 and 1"),
            (["--for", "mass", "--friction-ratio", "0.5"], "--for"),
            (["--for", "velocity"], "--friction-ratio"),
            (["--for", "velocity", "--friction-ratio", "0.9", "--from", "5 kHz"], "a velocity in m/s"),
            (["--for", "velocity", "--friction-ratio", "0.9", "--from", "-1"], "above 0"),
            (["--for", "frequency", "--friction-ratio", "0.9", "--velocity", "1", "--from", "1e307", "--to", "1e308"],
             "--to: found 1 × 10³⁰⁸ Hz; expected a finite value above 0, and 2 pi f within the range of doubles"),
            (["--for", "frequency", "--friction-ratio", "0.9", "--velocity", "1", "--from", "1e-300", "--to", "1e300"],
             "ends whose ratio is within the range of doubles"),
        ]:
            with self.subTest(question=question):
                self.refused(2, ["solve", ELASTIC, *question], words)

    # It was said that this is an antiresonance, that frequencies reduce friction up to 1e-308 m/s, and that numbers
    # leave the range of doubles.
    def test_nothing_is_sought_without_vibration(self):
        for scene, sought in ((ELASTIC, "velocity"), (ELASTIC, "frequency"), (example("tribometer"), "force"),
                              (example("sphere"), "velocity")):
            speed = [] if sought == "velocity" else ["--velocity", "1 mm/s"]
            self.refused(3, ["solve", scene, "--for", sought, "--friction-ratio", "0.9", *speed, "--set", "amplitude=0"],
                         "without vibration, an amplitude of 0, friction is full at every speed", "--for amplitude")

    # --to was named, which nobody had given.
    def test_only_ends_that_were_given_are_wrong(self):
        command = ["solve", ELASTIC, "--for", "amplitude", "--friction-ratio", "0.5", "--velocity", "1 mm/s"]
        told = self.refused(2, [*command, "--from", "1 m"], "--from: found 1 m; expected a number below",
                            "where the search ends")
        self.assertNotIn("--to", told)
        self.refused(2, [*command, "--from", "2 nm", "--to", "1 nm"], "--from, --to: found from 2 nm to 1 nm")


if __name__ == "__main__":
    unittest.main()
