"""Surfaces that part, through the program: what it says of v*, of the motion, and of the map across
the border of separation."""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, PROGRAM = Path(sys.argv.pop(1)), sys.argv.pop(1)

SCENE = (PROJECT / "scenes/jumping.toml").read_text()


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=PROJECT, capture_output=True, text=True, timeout=120)


class Separation(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def scene(self, *replacements):
        text = SCENE
        for old, new in replacements:
            self.assertEqual(text.count(old), 1, old)
            text = text.replace(old, new)
        file = Path(self.folder.name) / "scene.toml"
        file.write_text(text)
        return file

    def json(self, *arguments):
        done = run(*arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_the_closed_form_is_kept(self):
        answer = self.json("eval", "scenes/jumping.toml")
        self.assertTrue(answer["admissible"] and answer["opens"])
        self.assertEqual(answer["critical_velocity_by"], "formula")
        compared = self.json("critical", "scenes/jumping.toml")
        self.assertTrue(compared["agree"])
        self.assertLess(compared["stick_onset_difference"], 1e-9)

    def test_elsewhere_v_is_simulated_and_says_so(self):
        scene = self.scene(("poisson    = 0.3", 'tangential = "kelvin(k0, c1)"'))
        answer = self.json("eval", scene)
        self.assertEqual(answer["critical_velocity_by"], "simulation")
        self.assertIsNone(answer["relative_error_bound"])
        self.assertIn("(simulated)", run("eval", scene).stdout)
        self.assertEqual(run("critical", scene).returncode, 3)
        made = run("generate", scene, "--out", Path(self.folder.name) / "out")
        self.assertEqual(made.returncode, 3)
        self.assertFalse((Path(self.folder.name) / "out").exists())
        # 1 % about it the motion changes from stick-slip to sliding.
        for ratio, regime in ((0.99, "stick-slip-apart"), (1.01, "sliding-apart")):
            motion = self.json("simulate", scene, "--velocity-ratio", ratio)
            self.assertEqual(motion["regime"], regime)
            self.assertAlmostEqual(motion["velocity"] / answer["critical_velocity"], ratio, delta=1e-15)

    def test_a_motion_tells_of_both_starts(self):
        for start in ("sliding", "rest"):
            motion = self.json("simulate", "scenes/jumping.toml", "--velocity-ratio", 0.3, "--start", start)
            self.assertEqual({event["to"] for event in motion["events"]}, {"slip", "apart", "stick"})
            parting = motion["separation"]
            self.assertTrue(parting["starts_agree"])
            self.assertLessEqual(abs(parting["other_start"]["friction_ratio"] - motion["friction_ratio"]),
                                 2 * motion["friction_ratio_error"])
            # More than K_n(0) u_z0 = 4 N: the surfaces do not pull while they are apart.
            self.assertGreater(parting["mean_normal_force"], 4)
            work = motion["energy"]
            self.assertLess(abs(work["drive"] - work["friction"] - work["dampers"]), work["error"])

    def test_starts_that_disagree_are_within_the_error(self):
        # A part in 2e8 off the fourth harmonic, undamped: a search stops where little changes from cycle to cycle.
        scene = Path(self.folder.name) / "near_harmonic.toml"
        scene.write_text('[contact]\nnormal = "kn"\ntangential_ratio = 0.5\nseparation = true\n[drive]\nnetwork = "kd"\n'
                         '[body]\nmass = 0.0001497611070636386\n[oscillation]\nangular_frequency = 13053.937581869824\n'
                         'amplitude = 1.8754805392037193e-09\nindentation = 1.0204906617695415e-09\n'
                         '[friction]\ncoefficient = 0.2669343414071576\n'
                         '[elements]\nkn = 4932956.987521647\nkd = 408321.35136545345\n')
        disagreed = 0
        for velocity in (1297.6137876710734, 1296.3161725870861):
            answer = self.json("simulate", scene, "--velocity", repr(velocity))
            other = answer["separation"]["other_start"]
            difference = abs(answer["friction_ratio"] - other["friction_ratio"])
            self.assertLessEqual(difference, answer["friction_ratio_error"] + other["friction_ratio_error"])
            # A map has the same error, which covers both.
            out = Path(self.folder.name) / f"{velocity}.csv"
            done = run("sweep", scene, "--over", f"velocity=lin:{velocity!r}:{2 * velocity!r}:2", "--out", out,
                       "--quantity", "friction_ratio", "--quantity", "friction_ratio_error")
            self.assertEqual(done.returncode, 0, done.stderr)
            with out.open() as file:
                row = next(csv.DictReader(file))
            for each in (answer["friction_ratio"], other["friction_ratio"]):
                self.assertLessEqual(abs(float(row["friction_ratio"]) - each), float(row["friction_ratio_error"])
                                     + other["friction_ratio_error"])
            if not answer["separation"]["starts_agree"]:
                disagreed += 1
                self.assertGreater(float(row["friction_ratio_error"]), difference / 2)
        self.assertGreater(disagreed, 0)

    def test_without_separation_the_scene_is_outside_the_model(self):
        scene = self.scene(("separation = true                # F_n = max(0, reaction), no adhesion\n", ""))
        answer = self.json("eval", scene)
        self.assertFalse(answer["admissible"])
        self.assertNotIn("opens", answer)
        self.assertEqual(run("simulate", scene, "--velocity", "0.01").returncode, 3)
        closed = scene.read_text().replace("1.5 um", "0.1 um")
        scene.write_text(closed)
        self.assertNotIn("separation", self.json("simulate", scene, "--velocity", "0.001"))

    def test_the_map_crosses_the_border(self):
        scene = self.scene(("poisson    = 0.3", 'tangential = "kelvin(k0, c1)"'))
        out = Path(self.folder.name) / "map.csv"
        done = run("sweep", scene, "--over", "amplitude=log:1e-7:2e-6:7", "--over", "velocity_ratio=lin:0.1:1.3:5",
                   "--quantity", "friction_ratio", "--quantity", "regime", "--quantity", "critical_velocity",
                   "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = list(csv.DictReader(out.open()))
        self.assertEqual(len(rows), 35)
        self.assertTrue({"sliding", "stick-slip", "sliding-apart", "stick-slip-apart"} <= {r["regime"] for r in rows})
        for row in rows[::6]:
            setting = ("--set", f"amplitude={row['amplitude']}")
            motion = self.json("simulate", scene, *setting, "--velocity-ratio", row["velocity_ratio"])
            self.assertEqual(motion["regime"], row["regime"])
            # The sweep begins each search at the speed before: both are good to their errors.
            self.assertAlmostEqual(motion["friction_ratio"], float(row["friction_ratio"]), delta=1e-12)
            answer = self.json("eval", scene, *setting)
            self.assertAlmostEqual(answer["critical_velocity"] / float(row["critical_velocity"]), 1, delta=1e-12)

    def test_a_velocity_is_found(self):
        found = self.json("solve", "scenes/jumping.toml", "--for", "velocity", "--friction-ratio", 0.5)
        motion = self.json("simulate", "scenes/jumping.toml", "--velocity", found["velocity"])
        self.assertAlmostEqual(motion["friction_ratio"], 0.5, delta=1e-9)
        self.assertEqual(motion["regime"], "stick-slip-apart")

    def test_derive_says_where_the_formula_holds(self):
        self.assertTrue(self.json("derive", "scenes/jumping.toml")["separation"]["closed_form"])
        scene = self.scene(("poisson    = 0.3", 'tangential = "kelvin(k0, c1)"'))
        derived = self.json("derive", scene)
        self.assertEqual(derived["separation"], {"closed_form": False, "lines": []})
        self.assertNotIn("separation", self.json("derive", "scenes/zener.toml"))


if __name__ == "__main__":
    unittest.main()
