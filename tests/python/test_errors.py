"""What vcrit refuses: Python exceptions with the text that the program prints."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import vcrit
from support import PROJECT, RESONANT, program

ZENER = "scenes/zener.toml"


def in_python_terms(text):
    """What the program says, with arguments of Python in place of its options."""
    text = re.sub(r"--set (\w+)(?=: found)", r"\1", text).replace("--set NAME=VALUE", "with_values(NAME=VALUE)")
    return re.sub(r"--([a-z]+)(-ratio)?", lambda option: option[1] + (option[2] or "").replace("-", "_"), text)


class TheProgram(unittest.TestCase):
    """Each error beside the program's."""

    def assert_same(self, error, call, *arguments):
        result = program(*arguments)
        self.assertEqual(result.returncode, {vcrit.InputError: 2, vcrit.ModelError: 3}[error], result.stderr)
        with self.assertRaises(error) as caught:
            call()
        self.assertEqual(f"vcrit: {caught.exception}\n", in_python_terms(result.stderr))

    def assert_same_text(self, error, text, use, *command):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "scene.toml"
            file.write_text(text)
            self.assert_same(error, lambda: use(vcrit.Scene(file)), command[0], str(file), *command[1:])

    def test_in_parts(self):
        text = (PROJECT / ZENER).read_text()
        line = 1 + text[:text.index("coefficient")].count("\n")
        with self.assertRaises(vcrit.InputError) as caught:
            vcrit.Scene.from_text(text.replace("coefficient = 0.3", "coefficient = -1"))
        error = caught.exception
        self.assertEqual(error.place[1], line)
        self.assertEqual((error.found, error.expected), ("coefficient = -1", "a finite value of at least 0"))
        self.assertIsNone(error.advice)
        self.assertEqual(str(error), f"{error.place[0]}:{line}:{error.place[2]}: found {error.found}; "
                                     f"expected {error.expected}")
        with self.assertRaises(vcrit.ModelError) as caught:
            vcrit.Scene("scenes/inadmissible.toml").simulate(velocity="1 mm/s")
        self.assertIsNone(caught.exception.place)
        # Those of the package's own Python.
        with self.assertRaises(vcrit.InputError) as caught:
            vcrit.Scene(ZENER).critical_velocity(frequency=[1 + 2j])
        self.assertIsNotNone(caught.exception.found)

    def test_on_a_missing_file(self):
        self.assert_same(vcrit.InputError, lambda: vcrit.Scene("no such file"), "eval", "no such file")

    def test_on_a_mistake_in_a_scene(self):
        good = (PROJECT / ZENER).read_text()
        for old, new in [('normal  = "k0 | (k1 - c1)"', 'normal = "k0 | (k1 - "'), ('"20 kHz"', '"20 kN"'),
                         ("coefficient = 0.3", "coefficient = -1"), ("[body]", "[bodies]"), ('"5 g"', "[")]:
            self.assertIn(old, good)
            with self.subTest(new=new):
                self.assert_same_text(vcrit.InputError, good.replace(old, new), lambda scene: scene, "eval")

    def test_on_values_that_cannot_be_set(self):
        scene = vcrit.Scene(ZENER)
        for name, value in [("k9", 1.0), ("k0", -1.0), ("k0", "8 Hz"), ("mass", float("inf")), ("k0", float("nan"))]:
            with self.subTest(name=name, value=value):
                self.assert_same(vcrit.InputError, lambda: scene.with_values({name: value}),
                                 "eval", ZENER, "--set", f"{name}={value}")

    def test_on_missing_values(self):
        text = (PROJECT / ZENER).read_text().replace('"5 g"', '"m"').replace('kd = "2 N/um"', "")
        self.assert_same_text(vcrit.InputError, text, lambda scene: scene.critical_velocity(), "eval")

    def test_on_speeds(self):
        scene = vcrit.Scene(ZENER)
        command = ["simulate", ZENER]
        for speed in [-1, 0]:
            self.assert_same(vcrit.InputError, lambda: scene.simulate(speed), *command, f"--velocity={speed}")
            self.assert_same(vcrit.InputError, lambda: scene.friction_curve(speed),
                             *command, f"--velocity={speed}")
            self.assert_same(vcrit.InputError, lambda: scene.friction_curve(velocity_ratios=speed),
                             *command, f"--velocity-ratio={speed}")
            with self.assertRaisesRegex(vcrit.InputError, f"^at index 1: velocity: found a speed of {speed} m/s"):
                scene.friction_curve([0.1, speed])
        for speed in [float("nan"), float("inf")]:
            self.assert_same(vcrit.InputError, lambda: scene.simulate(velocity_ratio=speed),
                             *command, f"--velocity-ratio={speed}")
        self.assert_same(vcrit.InputError, lambda: scene.simulate("2 mm"), *command, "--velocity=2 mm")

    def test_outside_the_model(self):
        file = "scenes/inadmissible.toml"
        self.assert_same(vcrit.ModelError, lambda: vcrit.Scene(file).simulate(1), "simulate", file, "--velocity=1")
        self.assert_same(vcrit.ModelError, lambda: vcrit.Scene(file).friction_curve([1]),
                         "simulate", file, "--velocity=1")
        self.assert_same_text(vcrit.ModelError, RESONANT, lambda scene: scene.simulate(velocity_ratio=0.5),
                              "simulate", "--velocity-ratio=0.5")
        file = str(PROJECT / "scenes/measured_drive.toml")  # a scene with a table names it from the root
        self.assert_same(vcrit.ModelError, lambda: vcrit.Scene(file).with_values(frequency=1e6).critical_velocity(),
                         "eval", file, "--set", "frequency=1e6")

    def test_on_a_rational_form_too_large(self):
        scene = vcrit.Scene("scenes/prony.toml")
        self.assert_same(vcrit.ModelError, lambda: vcrit.derive(scene, form="rational"),
                         "derive", "scenes/prony.toml", "--form", "rational")


class Environment(unittest.TestCase):
    def test_without_the_database_of_units_names_the_variable(self):
        environment = os.environ | {"UDUNITS2_XML_PATH": "/no such file.xml"}
        expected = 'UDUNITS2_XML_PATH: found "/no such file.xml"; expected the database of units'
        result = program("eval", ZENER, env=environment)
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"vcrit: {expected}", result.stderr)
        code = f"import vcrit\ntry:\n    vcrit.Scene({ZENER!r})\nexcept vcrit.InputError as error:\n    print(error)"
        result = subprocess.run([sys.executable, "-B", "-c", code], cwd=PROJECT, env=environment, capture_output=True,
                                text=True)
        self.assertTrue(result.stdout.startswith(expected), result.stdout + result.stderr)


class Exceptions(unittest.TestCase):
    def test_are_kinds_of_pythons_own(self):
        self.assertTrue(issubclass(vcrit.InputError, (vcrit.Error,)) and issubclass(vcrit.InputError, ValueError))
        self.assertTrue(issubclass(vcrit.ModelError, (vcrit.Error,)) and issubclass(vcrit.ModelError, ArithmeticError))
        self.assertFalse(issubclass(vcrit.Error, (ValueError, ArithmeticError)))

    def test_reach_python_from_arrays(self):
        scene = vcrit.Scene(ZENER)
        with self.assertRaisesRegex(vcrit.InputError, 'k9.*found "k9", which this scene does not have'):
            scene.critical_velocity(k9=np.ones(3))
        with self.assertRaisesRegex(vcrit.InputError, "^at index 1: k0: found k0 = -1; expected a finite value"):
            scene.critical_velocity(k0=np.array([1e6, -1]))
        with self.assertRaisesRegex(vcrit.InputError, "^frequency: found 1000.*; expected one number"):
            scene.critical_velocity(frequency=10**400)

    def test_name_half_characters(self):
        scene = vcrit.Scene(ZENER)
        for call in [lambda: vcrit.Scene("\ud800.toml"), lambda: vcrit.Scene.from_text("", "\ud800.toml"),
                     lambda: vcrit.Scene.from_text("title = '\ud800'"), lambda: scene.with_values(k0="8 N\udc80"),
                     lambda: scene.with_values({"k\ud800": 1}), lambda: scene.critical_velocity({"k\ud800": [1]}),
                     lambda: scene.critical_velocity(k0="8 N\udc80"), lambda: scene.simulate("1 m\udc80")]:
            self.assertRaisesRegex(vcrit.InputError, r"found '\\u(d800|dc80)', a lone surrogate", call)
        # A name of a file that is no UTF-8, as Python has it.
        with self.assertRaisesRegex(vcrit.InputError, "no such"):
            vcrit.Scene("no such \udcff file")

    def test_name_the_argument_that_is_of_another_kind(self):
        # These were TypeErrors that listed arguments of the compiled module, or said what Python's str has.
        scene = vcrit.Scene(ZENER)
        table = {"frequency": [1e3, 1e4, 1e5], "storage": [1e6, 2e6, 3e6], "loss": [1e5, 2e5, 1e5]}
        half = "\udc80"
        for place, found, expected, call in [
                ("method", "3", "a text", lambda: scene.simulate(0.1, method=3)),
                ("method", r"'\udc80', a lone surrogate", "text of whole characters",
                 lambda: scene.simulate(0.1, method=half)),
                ("start", "None", "a text", lambda: scene.simulate(0.1, start=None)),
                ("of", "None", "a text", lambda: scene.svg(None)),
                ("of", "b'friction'", "a text", lambda: scene.plot(b"friction")),
                ("format", "2.5", "a text", lambda: vcrit.derive(scene).document(2.5)),
                ("form", "None", "a text", lambda: vcrit.derive(scene, form=None)),
                ("scene", "a str", "a vcrit.Scene, as vcrit.Scene(file)", lambda: vcrit.derive(ZENER)),
                ("text", "b'a=1'", "a text", lambda: vcrit.Scene.from_text(b"a=1")),
                ("name of a value", "3", "a text", lambda: scene.with_values({3: 1.0})),
                ("over", "a list", "names and their values: {'frequency': values}",
                 lambda: scene.sweep(["frequency"], "regime")),
                ("over", "3", "a text", lambda: scene.sweep({3: [1.0]}, "regime")),
                ("quantity", "3", "a text", lambda: scene.sweep({"frequency": [1e4]}, 3)),
                ("quantity", "None", "a text", lambda: scene.sweep({"frequency": [1e4]}, [None])),
                ("sought", "3", "a text", lambda: scene.solve(3, 0.8)),
                ("friction_ratio", "None", "a number", lambda: scene.solve("velocity", None)),
                ("samples", "2.5", "a whole number", lambda: scene.solve("velocity", 0.8, samples=2.5)),
                ("samples", "1000000000000", "a whole number of at most 2147483647",
                 lambda: scene.solve("velocity", 0.8, samples=10**12)),
                ("limits", "'no'", "True or False", lambda: vcrit.derive(scene).document(limits="no")),
                ("sensitivities", "[1]", "True or False", lambda: vcrit.derive(scene).document(sensitivities=[1])),
                ("standalone", "array([1, 2])", "True or False",
                 lambda: vcrit.derive(scene).document("latex", standalone=np.array([1, 2]))),
                ("damper", "'False'", "True or False", lambda: vcrit.fit(table, damper="False")),
                ("max_branches", "None", "a whole number", lambda: vcrit.fit(table, max_branches=None)),
                ("max_branches", "2147483648", "a whole number of at most 2147483647",
                 lambda: vcrit.fit(table, max_branches=2**31))]:
            with self.subTest(place=place, found=found):
                with self.assertRaises(vcrit.InputError) as caught:
                    call()
                self.assertEqual(str(caught.exception), f"{place}: found {found}; expected {expected}")

    def test_name_methods_forms_and_formats(self):
        scene = vcrit.Scene(ZENER)
        with self.assertRaisesRegex(vcrit.InputError, '^method: found "other"; expected one of exact, moreau'):
            scene.simulate(0.1, method="other")
        with self.assertRaisesRegex(vcrit.InputError, '^start: found "top"; expected sliding or rest'):
            scene.simulate(0.1, start="top")
        with self.assertRaisesRegex(vcrit.InputError, '^form: found "short"; expected one of dimensionless, exp'):
            vcrit.derive(scene, form="short")
        with self.assertRaisesRegex(vcrit.InputError, '^format: found "odt"; expected one of c, html, json, latex'):
            vcrit.derive(scene).document("odt")

    def test_ask_for_one_kind_of_speed(self):
        scene = vcrit.Scene(ZENER)
        for call in [lambda: scene.simulate(), lambda: scene.simulate(1, velocity_ratio=1),
                     lambda: scene.friction_curve(), lambda: scene.friction_curve([1], velocity_ratios=[1])]:
            self.assertRaisesRegex(TypeError, "either velocities or their ratios", call)


if __name__ == "__main__":
    unittest.main()
