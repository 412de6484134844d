"""A scene in Python: its values against 50 digits, its numbers, and scenes made of it."""

import copy
import json
import math
import os
import pickle
import tempfile
import unittest
import warnings

import vcrit
from support import OF_MAXIMUM, PROJECT, RESONANT, U, formula_rows, program, relative_difference, scene_rows

ZENER = "scenes/zener.toml"


class Scenes(unittest.TestCase):
    def test_have_the_critical_velocity_of_the_reference(self):
        without = formula_rows(False)
        for row in scene_rows():
            with self.subTest(scene=row["scene"]):
                scene = vcrit.Scene(PROJECT / "scenes" / row["scene"])
                found = scene.certified_critical_velocity
                # One rounding of omega = 2 pi f and of each unit's factor lies before the
                # evaluation, as for the program (tests/project/test_scenes.py).
                bound = found.relative_error_bound
                allowed = (OF_MAXIMUM if math.isnan(bound) else bound) + 16 * U
                self.assertEqual(math.isnan(bound), row in without)
                self.assertLess(relative_difference(found.value, row["critical_velocity"]), allowed)
                self.assertEqual(scene.critical_velocity(), found.value)
                self.assertEqual(found.reason, "")
                self.assertEqual(scene.admissible, row["admissible"] == "true")
                self.assertEqual(bool(scene.reasons), not scene.admissible)

    def test_creep_where_a_network_on_the_path_flows(self):
        creeping = 0
        for row in scene_rows():
            scene = vcrit.Scene(PROJECT / "scenes" / row["scene"])
            creep = float(row["creep_velocity"])
            creeping += creep > 0
            # Two roundings to the last place of v* + creep, and those of the units.
            self.assertAlmostEqual(scene.drive_velocity, float(row["critical_velocity"]) + creep,
                                   delta=20 * U * scene.drive_velocity)
        self.assertEqual(creeping, 1)

    def test_read_a_path_and_a_text_alike(self):
        text = (PROJECT / ZENER).read_text()
        from_text = vcrit.Scene.from_text(text)
        self.assertEqual(from_text.critical_velocity(), vcrit.Scene(ZENER).critical_velocity())
        self.assertEqual(from_text.title, "Zener contact under an elastic drive")
        self.assertEqual(vcrit.Scene.from_text(text.replace("title", "# title")).title, "")

    def test_a_measured_drive_is_found_beside_the_file_named(self):
        text = (PROJECT / "scenes/measured_drive.toml").read_text()
        scene = vcrit.Scene.from_text(text, "scenes/other.toml")
        self.assertEqual(scene.critical_velocity(), vcrit.Scene("scenes/measured_drive.toml").critical_velocity())

    def test_have_their_numbers_by_the_symbols_of_the_formulas(self):
        # As scenes/zener.toml has them, in SI.
        typed = {"mu0": (0.3, "1"), "omega": (2 * math.pi * 20e3, "rad/s"), "du_z": (1e-7, "m"),
                 "u_z0": (5e-7, "m"), "m": (5e-3, "kg"), "poisson": (0.3, "1"), "k0": (8e6, "N/m"),
                 "k1": (4e6, "N/m"), "c1": (30, "N.s/m"), "kd": (2e6, "N/m")}
        found = vcrit.Scene(ZENER).parameters
        self.assertEqual({name: each.unit for name, each in found.items()},
                         {name: unit for name, (_, unit) in typed.items()})
        for name, (value, _) in typed.items():
            # One rounding of a unit's factor and one of the product.
            self.assertAlmostEqual(found[name].value, value, delta=2 * 2 * U * value)

    def test_have_no_number_of_what_is_not_there(self):
        found = vcrit.Scene("scenes/elastic.toml").parameters
        self.assertEqual(set(found), {"mu0", "omega", "du_z", "u_z0", "kn", "kt"})
        massless = vcrit.Scene(ZENER).with_values(m=0)
        self.assertNotIn("m", massless.parameters)
        self.assertNotIn("m", vcrit.derive(massless).parameters)

    def test_name_what_may_be_set(self):
        names = vcrit.Scene("scenes/elastic.toml").settable
        self.assertEqual(dict(names), {
            "mu0": "1", "coefficient": "1", "omega": "rad/s", "angular_frequency": "rad/s", "frequency": "Hz",
            "du_z": "m", "amplitude": "m", "u_z0": "m", "indentation": "m", "kn": "N/m", "kt": "N/m"})

    def test_a_symbol_has_no_value(self):
        scene = vcrit.Scene.from_text((PROJECT / ZENER).read_text().replace('"5 g"', '"m"'))
        self.assertEqual(scene.parameters["m"], vcrit.Parameter(None, "kg"))
        with self.assertRaisesRegex(vcrit.InputError, r"no value for m \(mass\);"):
            scene.critical_velocity()
        self.assertEqual(scene.with_values(m="5 g").critical_velocity(), vcrit.Scene(ZENER).critical_velocity())

    def test_say_why_they_are_infinite(self):
        found = vcrit.Scene.from_text(RESONANT).certified_critical_velocity
        self.assertEqual(found.value, math.inf)
        self.assertIn("resonance", found.reason)

    def test_warn_of_what_has_no_effect(self):
        text = (PROJECT / "scenes/elastic.toml").read_text() + "kx = 1\n"
        with self.assertWarnsRegex(UserWarning, 'element "kx" is in no network') as caught:
            scene = vcrit.Scene.from_text(text)
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(len(scene.warnings), 1)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(scene.with_values(kn=1e6).warnings, scene.warnings)


    def test_warn_of_frequencies_beyond_what_was_fitted(self):
        text = (PROJECT / "scenes/elastic.toml").read_text().replace(
            "[contact]", '[contact]\nfitted_range = ["1 Hz", "1 GHz"]')
        scene = vcrit.Scene.from_text(text)
        self.assertEqual(scene.warnings, ())
        with self.assertWarnsRegex(UserWarning, "fitted to data from 1 Hz to 1 GHz") as caught:
            beyond = scene.with_values(frequency="2 GHz")
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(len(beyond.warnings), 1)

    def test_names_that_a_scene_gives_its_symbols(self):
        text = (PROJECT / ZENER).read_text()
        own = vcrit.Scene(PROJECT / ZENER)
        # Numbers as they were typed are exact, those given here are doubles.
        own = own.with_values({name: own.parameters[name].value for name in ("m", "mu0", "du_z", "k1")})
        numbers = {}
        for line, symbol, name in (('mass = "5 g"', "m", "M"), ("coefficient = 0.3", "mu0", "mu"),
                                   ('amplitude   = "0.1 um"', "du_z", "a"), ('k1 = "4 N/um"', "k1", "E")):
            self.assertIn(line, text)
            text = text.replace(line, f'{line.split("=")[0]}= "{name}"')
            numbers[name] = own.parameters[symbol].value
        scene = vcrit.Scene.from_text(text)
        self.assertEqual([name for name, parameter in scene.parameters.items() if parameter.value is None],
                         [name for name in scene.parameters if name in numbers])
        self.assertEqual(len(scene.parameters), len(own.parameters))
        self.assertLessEqual(set(numbers), set(scene.parameters))
        filled = scene.with_values(**numbers)
        self.assertEqual(filled.critical_velocity(), own.critical_velocity())
        self.assertEqual(filled.critical_velocity(M=[1e-3, 2e-3], E=3e6).tolist(),
                         own.critical_velocity(mass=[1e-3, 2e-3], k1=3e6).tolist())
        self.assertEqual(scene.critical_velocity(**numbers),
                         own.critical_velocity(m=numbers["M"], mu0=numbers["mu"], du_z=numbers["a"], k1=numbers["E"]))
        self.assertIn("M*omega^2", vcrit.derive(scene).text)


class OtherValues(unittest.TestCase):
    def setUp(self):
        self.scene = vcrit.Scene(ZENER)

    def test_are_numbers_or_texts(self):
        by_numbers = self.scene.with_values(k0=9e6, frequency=25e3)
        by_texts = self.scene.with_values(k0="9 N/um", frequency="25 kHz")
        # 25 kHz is 2 pi f to the last digit, 25e3 the double of it.
        self.assertAlmostEqual(by_numbers.critical_velocity() / by_texts.critical_velocity(), 1, delta=1e-14)
        for scene, frequency in [(by_numbers, "25e3"), (by_texts, "25 kHz")]:
            printed = program("eval", ZENER, "--set", "k0=9 N/um", "--set", f"frequency={frequency}", "--json").stdout
            self.assertEqual(json.loads(printed)["critical_velocity"], scene.critical_velocity())

    def test_leave_the_scene_as_it_is(self):
        before = self.scene.critical_velocity()
        self.assertNotEqual(self.scene.with_values(k0=9e6).critical_velocity(), before)
        self.assertEqual(self.scene.critical_velocity(), before)

    def test_add_up(self):
        twice = self.scene.with_values(k0=1.0).with_values(k1=2e6).with_values(k0=9e6)
        self.assertEqual(twice.critical_velocity(), self.scene.with_values(k0=9e6, k1=2e6).critical_velocity())

    def test_may_have_names_that_are_none_in_python(self):
        prony = vcrit.Scene("scenes/prony.toml")
        self.assertEqual(prony.with_values({"k[3]": 1e5}).parameters["k[3]"].value, 1e5)

    def test_keep_every_bit(self):
        self.assertEqual(self.scene.with_values(k0=0.1 + 0.2).parameters["k0"].value, 0.1 + 0.2)

    def test_go_with_copies(self):
        other = self.scene.with_values(k0=9e6)
        for made in [pickle.loads(pickle.dumps(other)), copy.copy(other), copy.deepcopy(other)]:
            self.assertEqual(made.critical_velocity(), other.critical_velocity())
            self.assertEqual(repr(made), "<vcrit.Scene 'scenes/zener.toml', k0='9000000.0'>")


class AsValues(unittest.TestCase):
    def test_are_equal_and_keys(self):
        scene, again = vcrit.Scene(ZENER), vcrit.Scene(ZENER)
        self.assertEqual(scene, again)
        self.assertEqual({scene: 1}[again], 1)
        self.assertEqual(scene.with_values(k0=1, k1=2), scene.with_values(k1=2).with_values(k0=1))
        self.assertNotEqual(scene, scene.with_values(k0=9e6))
        self.assertNotEqual(scene, vcrit.Scene("scenes/kelvin.toml"))
        self.assertNotEqual(scene, ZENER)

    def test_do_not_change(self):
        scene = vcrit.Scene(ZENER)
        with self.assertRaisesRegex(AttributeError, "a scene does not change"):
            scene.title = "other"
        with self.assertRaises(AttributeError):
            del scene._text
        with self.assertRaises(TypeError):
            scene._settings["k0"] = "1"

    def test_find_their_tables_from_another_folder(self):
        scene = vcrit.Scene("scenes/measured_drive.toml")
        before, kept = os.getcwd(), pickle.dumps(scene)
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                self.assertEqual(pickle.loads(kept), scene)
                self.assertEqual(scene.with_values(mu0=0.3).critical_velocity({"mu0": [0.0]})[0], 0)
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
