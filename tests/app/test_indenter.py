"""Friction below an indenter, through the program: numbers known to others, and what is outside."""

import unittest

from program import Case


class Indenters(Case):
    def indenter(self, shape="parabola", radius="5 mm", amplitude=0.5, **more):
        return self.scene({"E": "2 GPa"}, normal="spring(E)", shape=shape, radius=radius, frequency="20 kHz",
                          amplitude=f"{amplitude} um", indentation="1 um", **more)

    # Elastic parabola at half the indentation, mu_macro/mu0 to 1e-5 by others.
    def test_known_friction(self):
        scene = self.indenter()
        for ratio, friction in ((0.1, 0.49477), (0.25, 0.66931), (0.75, 0.96733), (0.9, 0.99488)):
            motion = self.answer("simulate", scene, "--velocity-ratio", ratio)
            self.assertAlmostEqual(motion["friction_ratio"], friction, delta=1e-5)
            self.assertLess(motion["friction_ratio_error"], 1e-9)
            self.assertLess(motion["indenter"]["start_disagreement"], 1e-12)

    # v* of Hertz' contact of any size: mu0 omega du_z (2 - nu)/(2(1 - nu)).
    def test_one_critical_velocity(self):
        expected = 0.3 * 2 * 3.141592653589793 * 20e3 * 0.5e-6 * 1.7 / 1.4
        for shape, size in (("parabola", {"radius": 1}), ("cone", {"radius": None, "angle": "1 deg"}),
                            ("flat", {"radius": 0.01}), ("power", {"radius": None, "prefactor": 1e6, "exponent": 4})):
            scene = self.indenter(shape, **size)
            self.assertAlmostEqual(self.answer("eval", scene)["critical_velocity"] / expected, 1, delta=1e-14)
            compared = self.answer("critical", scene)
            self.assertTrue(compared["agree"])
            self.assertLess(compared["stick_onset_difference"], 1e-9)

    # Hertz: F = 4/3 E* sqrt(R) d^(3/2); at a small amplitude its mean is that at rest, (1 + 3/16 D^2) of it.
    def test_normal_force_is_that_of_hertz(self):
        motion = self.answer("simulate", self.indenter(amplitude=0.001), "--velocity-ratio", 0.5)
        hertz = 4 / 3 * 2e9 / (1 - 0.3**2) * 5e-3**0.5 * 1e-6**1.5
        self.assertAlmostEqual(motion["indenter"]["mean_normal_force"] / hertz, 1, delta=1e-6)
        self.assertAlmostEqual(motion["indenter"]["contact_radius"], (5e-3 * 1e-6) ** 0.5, delta=1e-18)

    # A profile with many rows of a parabola is that parabola.
    def test_a_table(self):
        rows = [(i * 1e-6, (i * 1e-6) ** 2 / 1e-2) for i in range(140)]
        self.write("r,f\n" + "".join(f"{r!r},{f!r}\n" for r, f in rows), "tip.csv")
        motion = self.answer("simulate", self.indenter("tip.csv", None), "--velocity-ratio", 0.25)
        # The chords lie above the parabola by at most (1 um)^2/(8 R) = 2.5e-11 m, 2.5e-5 of the depth.
        self.assertAlmostEqual(motion["friction_ratio"], 0.66931, delta=1e-4)

    def test_separation_and_what_is_outside(self):
        open_scene = self.indenter(amplitude=2)
        self.assertFalse(self.answer("eval", open_scene)["admissible"])
        self.refused(3, ["simulate", open_scene, "--velocity", 0.1])
        separating = self.indenter(amplitude=2, separation=True)
        self.assertTrue(self.answer("eval", separating)["opens"])
        motion = self.answer("simulate", separating, "--velocity-ratio", 0.3)
        self.assertEqual(motion["regime"], "stick-slip-apart")
        self.assertEqual(motion["indenter"]["cells"][0]["regime"], "stick-slip-apart")
        self.refused(3, ["simulate", separating, "--velocity", 0.1, "--method", "moreau"])
        self.refused(3, ["solve", separating, "--for", "amplitude", "--friction-ratio", 0.5, "--velocity", 0.1],
                     "friction stays full at every admissible amplitude")

    # All cells move one body; v* by 20 digits of a maximum over the phase (tests/matrix/reference_held.py).
    def test_a_leaf_spring(self):
        scene = self.scene({"E": "2 GPa", "kd": "400 N/mm"}, normal="spring(E)", shape="parabola", radius="5 mm",
                           poisson=0.4, network="kd", angular_frequency=1e5, amplitude="0.2 um", indentation="1 um",
                           coefficient=0.3)
        found = self.answer("eval", scene)
        self.assertAlmostEqual(found["critical_velocity"] / 0.013060480672226070, 1, delta=1e-13)
        self.assertEqual(found["critical_velocity_by"], "maximum over the phase")
        motion = self.answer("simulate", scene, "--velocity-ratio", 0.3)
        self.assertAlmostEqual(motion["friction_ratio"], 0.87806, delta=2e-6)
        self.assertEqual(motion["cells"], 0)
        self.assertLess(motion["cells_error"], 1e-10)
        for command in (["derive"], ["generate", "--out", self.folder], ["critical"]):
            self.refused(3, [command[0], scene, *command[1:]])

    # What is answered goes back into simulate, to the bit. At 0.3 v* of its amplitude friction is 0.87806 (above).
    def test_solve_on_a_leaf_spring(self):
        scene = self.scene({"E": "2 GPa", "kd": "400 N/mm"}, normal="spring(E)", shape="parabola", radius="5 mm",
                           poisson=0.4, network="kd", angular_frequency=1e5, amplitude="0.2 um", indentation="1 um",
                           coefficient=0.3)
        velocity, ratio = 0.3 * 0.013060480672226070, 0.87806
        speed = self.answer("solve", scene, "--for", "velocity", "--friction-ratio", ratio)
        self.assertAlmostEqual(speed["value"] / velocity, 1, delta=1e-4)  # 2e-6 of the ratio, over a slope of 30 s/m
        again = self.answer("simulate", scene, "--velocity", repr(speed["value"]))
        self.assertEqual(again["friction_ratio"], speed["friction_ratio"])
        self.assertEqual(again["regime"], speed["regime"])
        amplitude = self.answer("solve", scene, "--for", "amplitude", "--friction-ratio", ratio, "--velocity", velocity)
        self.assertAlmostEqual(amplitude["value"] / 0.2e-6, 1, delta=1e-4)
        self.assertEqual(amplitude["searched"]["samples"], 32)
        told = self.run_program("solve", scene, "--for", "velocity", "--friction-ratio", ratio).stdout
        self.assertIn("below an indenter friction never falls with the speed", told)
        self.assertIn("at its centre below an amplitude of", told)

    def test_a_map(self):
        rows = self.table(self.indenter(), "--over", "amplitude=lin:0.1e-6:0.9e-6:3", "--over",
                          "velocity_ratio=lin:0.25:1.25:3", "--quantity", "friction_ratio", "--quantity", "regime")
        self.assertEqual({row["regime"] for row in rows}, {"stick-slip-apart", "sliding-apart"})
        there = [row for row in rows if row["amplitude"] == "5e-07" and row["velocity_ratio"] == "0.25"]
        self.assertAlmostEqual(float(there[0]["friction_ratio"]), 0.66931, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
