"""Friction by simulation, against steady states known to 22 digits."""

import json
import math
import pickle
import unittest
import unittest.mock

import numpy as np
import vcrit
from support import PROJECT, U, program, rows, scene

KELVIN = "scenes/kelvin.toml"


def scene_of(row):
    """A row of stickslip_reference.csv: <F_n> = 1 N and its amplitude by a normal spring of 1 N/m."""
    tangential = "k0"
    elements = {"kn": 1, "k0": row["k0"]}
    if float(row["c"]) > 0:
        tangential += " | c"
        elements["c"] = row["c"]
    if row["k1"]:
        tangential += " | maxwell(k1, c1)"
        elements |= {"k1": row["k1"], "c1": float(row["k1"]) * float(row["tau_periods"]) * 2 * math.pi}
    drive = {}
    if row["k_d"] != "inf":
        drive = {"network": "kd | cd", "mass": float(row["m"])}
        elements |= {"kd": row["k_d"], "cd": row["c_d"]}
    return vcrit.Scene.from_text(scene({name: float(value) for name, value in elements.items()}, tangential=tangential,
                                       angular_frequency=1, amplitude=float(row["F_n_amplitude"]),
                                       coefficient=float(row["mu0"]), **drive))


def allowed(row):
    # As tests/simulation/steady/test_exact.cpp derives it for these rows: a strongly damped contact
    # that forgets slowly may lose 4e-12, the others a thousand roundings.
    return 4e-12 if float(row["c"]) >= 10 else 1000 * U


class Friction(unittest.TestCase):
    def test_has_its_reference_values(self):
        for row in rows("stickslip_reference.csv", 45):
            with self.subTest(row=row):
                scene = scene_of(row)
                curve = scene.friction_curve([float(row["velocity"])])
                self.assertAlmostEqual(curve.friction_ratio[0], float(row["friction_ratio"]), delta=allowed(row))
                # A few roundings of each value, and what the systems' one resonance makes of them:
                # |D| = 0.7 of k_d = 1 at the least.
                self.assertAlmostEqual(curve.velocity_ratio[0], float(row["velocity_ratio"]), delta=40 * U)
                one = scene.simulate(velocity_ratio=float(row["velocity_ratio"]))
                self.assertAlmostEqual(one.friction_ratio, float(row["friction_ratio"]), delta=allowed(row))
                self.assertEqual(len(one.events), int(row["events_per_cycle"]))
                self.assertEqual(one.periods, 1)

    def test_curve_has_the_shape_of_its_speeds(self):
        scene = vcrit.Scene(KELVIN)
        ratios = np.array([[0.3, 1.2, 0.6], [0.9, 0.1, 2.0]])
        curve = scene.friction_curve(velocity_ratios=ratios)
        for values in curve:
            self.assertEqual(values.shape, (2, 3))
        np.testing.assert_array_equal(curve.velocity, ratios * scene.critical_velocity())
        np.testing.assert_array_equal(curve.regime == "sliding", ratios > 1)
        np.testing.assert_array_equal(curve.friction_ratio[ratios > 1], 1)
        np.testing.assert_array_equal(curve.reason, "")
        # Friction rises with the speed (Coulomb friction is monotone).
        order = np.argsort(ratios, axis=None)
        self.assertTrue((np.diff(curve.friction_ratio.flat[order]) >= 0).all())
        for velocity, friction, error in zip(curve.velocity.flat, curve.friction_ratio.flat,
                                             curve.friction_ratio_error.flat):
            one = scene.simulate(velocity)
            # One steady state, found twice, each to its own estimate and a rounding.
            self.assertAlmostEqual(one.friction_ratio, friction, delta=error + one.friction_ratio_error + 2 * U)

    def test_many_speeds_come_in_lots(self):
        # More speeds than are found one from another, each known in itself: elastic, rigid drive.
        elastic = next(row for row in rows("stickslip_reference.csv", 45) if row["velocity_ratio"] == "0.5")
        curve = scene_of(elastic).friction_curve(velocity_ratios=np.full(100, 0.5))
        np.testing.assert_allclose(curve.friction_ratio, float(elastic["friction_ratio"]), rtol=0, atol=1000 * U)

    def test_takes_views_and_leaves_them_alone(self):
        scene = vcrit.Scene(KELVIN)
        ratios = np.linspace(0.1, 1.1, 11)
        ratios.flags.writeable = False
        every_other = scene.friction_curve(velocity_ratios=ratios[::2])
        # The search begins at the speed before, which may change the last digits of an answer.
        np.testing.assert_allclose(every_other.friction_ratio,
                                   scene.friction_curve(velocity_ratios=ratios).friction_ratio[::2], rtol=1e-12)
        self.assertEqual(scene.friction_curve([]).friction_ratio.shape, (0,))
        for values in scene.friction_curve(velocity_ratios=0.5):
            self.assertIsInstance(values, np.ndarray)
            self.assertEqual(values.shape, ())

    def test_at_one_speed_is_what_the_program_prints(self):
        for method in ["exact", "moreau", "rk8pd", "tanh"]:
            with self.subTest(method=method):
                found = vcrit.Scene(KELVIN).simulate("2 mm/s", method=method)
                printed = json.loads(program("simulate", KELVIN, "--velocity", "2 mm/s", "--method", method,
                                             "--json").stdout)
                for key in ["velocity", "velocity_ratio", "friction_ratio", "friction_ratio_error", "regime",
                            "method", "periods"]:
                    self.assertEqual(getattr(found, key), printed[key], key)
                self.assertEqual([event._asdict() for event in found.events], printed["events"])
                energy = found.energy and found.energy._asdict()
                self.assertEqual(energy, printed.get("energy"))
                self.assertEqual(found.energy is not None, method == "exact")

    def test_at_a_ratio_to_a_velocity_of_0_names_the_cause(self):
        # Both were told as a speed of 0 that was given. Antiresonance: 1 + 3 = 1 x 2^2, without rounding.
        still = vcrit.Scene.from_text(scene({"kn": 1, "k0": 1, "kd": 3}, tangential="k0", angular_frequency=2, amplitude=0.5,
                                            coefficient=0.3, network="kd", mass=1))
        for given, words in [(still, r"v\* is 0 here: velocity_ratio has no meaning"),
                             (vcrit.Scene(KELVIN).with_values(mu0=0), "no friction to compare with")]:
            with self.assertRaisesRegex(vcrit.ModelError, words):
                given.simulate(velocity_ratio=0.5)
            with self.assertRaisesRegex(vcrit.ModelError, words):
                given.friction_curve(velocity_ratios=[0.5, 0.7])

    def test_finds_the_energy_when_it_is_asked_for(self):
        scene = vcrit.Scene(KELVIN)
        state = scene.simulate("2 mm/s")
        with unittest.mock.patch("vcrit.results._vcrit.energy", wraps=vcrit._vcrit.energy) as energy:
            scene.simulate("2 mm/s")
            energy.assert_not_called()
            self.assertIs(state.energy, state.energy)
            energy.assert_called_once()
        self.assertEqual(pickle.loads(pickle.dumps(state)), state)
        self.assertEqual(pickle.loads(pickle.dumps(scene.simulate("2 mm/s"))).energy, state.energy)

    def test_energy_is_balanced_however_fast_a_damper_rests(self):
        # Rates kt/(ct omega) of 1e-2 to 1e11 a radian: the panels of the quadrature begin elsewhere for each.
        for c in np.geomspace(1e-9, 1e4, 27):
            state = vcrit.Scene(KELVIN).with_values(ct=c).simulate(velocity_ratio=0.5)
            drive, friction, dampers, error = state.energy
            self.assertAlmostEqual(drive, friction + dampers, delta=3 * error)
            self.assertLess(error, 1e-9 * drive)

    def test_from_rest_is_the_same(self):
        scene = vcrit.Scene(KELVIN)
        ends = [scene.simulate(velocity_ratio=0.3, start=start) for start in ["sliding", "rest"]]
        # One steady value (the distance of two motions never grows), found twice to its own error.
        self.assertLessEqual(abs(ends[0].friction_ratio - ends[1].friction_ratio),
                             sum(each.friction_ratio_error for each in ends))


class SurfacesThatPart(unittest.TestCase):
    def test_as_the_program_says(self):
        scene = vcrit.Scene("scenes/separation.toml")
        onset = scene.critical_onset
        self.assertEqual(onset.by, "formula")
        self.assertEqual(onset.contact_velocity, scene.critical_velocity())
        curve = scene.friction_curve(velocity_ratios=[0.3, 1.1])
        self.assertEqual(list(curve.regime), ["stick-slip-apart", "sliding-apart"])
        state = scene.simulate(curve.velocity[0])
        self.assertIn("apart", {event.to for event in state.events})
        printed = json.loads(program("simulate", "scenes/separation.toml", "--velocity-ratio", "0.3", "--json").stdout)
        self.assertEqual(printed["friction_ratio"], state.friction_ratio)

    def test_below_an_indenter(self):
        scene = vcrit.Scene("scenes/sphere.toml")
        curve = scene.friction_curve(velocity_ratios=[0.5, 1.1])
        self.assertEqual(list(curve.regime), ["stick-slip-apart", "sliding-apart"])
        state = scene.simulate(curve.velocity[0])
        self.assertEqual(state.friction_ratio, curve.friction_ratio[0])
        self.assertIsNone(state.energy)
        printed = json.loads(program("simulate", "scenes/sphere.toml", "--velocity-ratio", "0.5", "--json").stdout)
        self.assertEqual(printed["friction_ratio"], state.friction_ratio)
        with self.assertRaises(vcrit.ModelError):
            scene.simulate("1 mm/s", method="moreau")

    def test_simulated_critical_velocity(self):
        text = (PROJECT / "scenes/separation.toml").read_text().replace("poisson    = 0.3", 'tangential = "kelvin(k0, c1)"')
        scene = vcrit.Scene.from_text(text)
        onset = scene.critical_onset
        self.assertEqual(onset.by, "simulation")
        closed = vcrit.Scene.from_text(text.replace("separation = true", ""))
        self.assertNotAlmostEqual(onset.contact_velocity / closed.critical_velocity(), 1, delta=0.01)
        curve = scene.friction_curve(velocity_ratios=[0.99, 1.01])
        self.assertEqual(list(curve.regime), ["stick-slip-apart", "sliding-apart"])
        self.assertAlmostEqual(curve.velocity[0] / onset.contact_velocity, 0.99, delta=1e-15)


if __name__ == "__main__":
    unittest.main()
