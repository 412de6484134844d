"""The program as a user meets it: JSON keys, exit statuses, what goes to stdout and what to stderr."""

import json
import keyword
import shutil
import unittest
from pathlib import Path

import drivers
from example_scenes import with_formula
from program import PROGRAM, PROJECT, Case, example, run, scene, settings

KELVIN, DRIVE = example("kelvin"), example("elastic_drive")
RESONANCE = settings({"omega": 1000, "m": 2, "kd": 2e6})


class Commands(Case):
    def test_eval_has_its_keys(self):
        self.assertEqual(
            set(self.answer("eval", KELVIN)),
            {"critical_velocity", "relative_error_bound", "admissible", "reasons", "drive_velocity", "facts", "sentence", "effect"})

    def test_simulate_has_its_keys(self):
        result = self.answer("simulate", KELVIN, "--velocity-ratio", "0.5")
        self.assertLessEqual(
            {"velocity", "velocity_ratio", "friction_ratio", "friction_ratio_error", "regime", "method",
             "periods", "events", "energy"}, set(result))
        self.assertEqual(result["velocity_ratio"], 0.5)
        self.assertIn(result["regime"], ["stick-slip", "stick-slip-backslip"])
        self.assertLess(0, result["friction_ratio"])
        self.assertLess(result["friction_ratio"], 1)
        for event in result["events"]:
            self.assertIn(event["to"], ["slip", "stick", "backslip"])
            self.assertTrue(0 <= event["phase"] < 6.283185307179587)

    # The drive does v0 <F> in a second; the scene has mu0 = 0.25, k_n = 10 N/um, u_z0 = 0.3 um, 20 kHz.
    def test_simulate_tells_where_the_work_goes(self):
        result = self.answer("simulate", KELVIN, "--velocity-ratio", "0.5")
        energy = result["energy"]
        self.assertEqual(set(energy), {"drive", "friction", "dampers", "error"})
        self.assertLessEqual(abs(energy["drive"] - energy["friction"] - energy["dampers"]), energy["error"])
        self.assertLess(energy["error"], 1e-12 * energy["drive"])
        power = result["velocity"] * result["friction_ratio"] * 0.25 * 10 * 0.3
        self.assertAlmostEqual(energy["drive"] * 20e3 / power, 1, delta=1e-14)
        self.assertIn(f"power of drive      {1e3 * power:.4g} mW", self.out("simulate", KELVIN, "--velocity-ratio", "0.5"))

    def test_simulate_above_the_critical_velocity_is_pure_sliding(self):
        result = self.answer("simulate", KELVIN, "--velocity-ratio", "1.01")
        self.assertEqual(result["regime"], "sliding")
        self.assertEqual(result["friction_ratio"], 1)
        self.assertEqual(result["events"], [])

    def test_a_speed_with_a_unit_is_the_same_speed(self):
        plain = self.answer("simulate", KELVIN, "--velocity", "0.002")
        self.assertEqual(self.answer("simulate", KELVIN, "--velocity", "2 mm/s"), plain)

    def test_both_starts_end_at_the_same_friction(self):
        for scene in ["kelvin", "zener", "bridge"]:
            ratios = [self.answer("simulate", example(scene), "--velocity-ratio", "0.3", "--start", start)
                      for start in ["sliding", "rest"]]
            # One steady value (the distance of two motions never grows), found twice to its own error.
            allowed = sum(r["friction_ratio_error"] for r in ratios)
            self.assertLessEqual(abs(ratios[0]["friction_ratio"] - ratios[1]["friction_ratio"]), allowed)
            self.assertLess(allowed, 1e-9)

    def test_every_method_has_the_same_keys_and_the_same_friction(self):
        command = ["simulate", KELVIN, "--velocity-ratio", "0.5"]
        exact = self.answer(*command)
        for method in ["moreau", "rkf45", "rk8pd", "msbdf", "tanh"]:
            for extra in [[], ["--start", "rest"], ["--plain"]]:
                with self.subTest(method=method, extra=extra):
                    result = self.answer(*command, "--method", method, *extra)
                    # Where the work of the drive goes is known for the exact method alone.
                    self.assertEqual(list(result), [key for key in exact if key != "energy"])
                    self.assertEqual(result["method"], method)
                    self.assertEqual(result["regime"], exact["regime"])
                    self.assertEqual(len(result["events"]), len(exact["events"]))
                    # Estimates of errors that scatter: within three of them.
                    self.assertLessEqual(abs(result["friction_ratio"] - exact["friction_ratio"]),
                                         3 * result["friction_ratio_error"])

    def test_the_options_of_a_method_reach_it(self):
        command = ["simulate", KELVIN, "--velocity-ratio", "0.5", "--method"]
        for method, option, rough, fine in [("rk8pd", "--tolerance", "1e-3", "1e-12"), ("moreau", "--steps", "50", "5000"),
                                            ("moreau", "--theta", "1", "0.5"), ("tanh", "--regularisation", "0.1", "1e-4")]:
            with self.subTest(option=option):
                errors = [self.answer(*command, method, option, value)["friction_ratio_error"] for value in [rough, fine]]
                self.assertLess(errors[1], errors[0] / 10)

    def test_the_reduced_model_takes_a_kelvin_contact_under_a_rigid_drive(self):
        result = self.answer("simulate", example("kelvin_rigid"), "--velocity-ratio", "0.5", "--method", "reduced")
        exact = self.answer("simulate", example("kelvin_rigid"), "--velocity-ratio", "0.5")
        self.assertEqual(list(result), [key for key in exact if key != "energy"])
        self.assertLessEqual(abs(result["friction_ratio"] - exact["friction_ratio"]), result["friction_ratio_error"])

    def test_critical_agrees_on_every_admissible_scene(self):
        for scene in with_formula(PROGRAM):
            if scene.name in ("inadmissible.toml", "sonotrode.toml", "measured_drive.toml"):
                continue
            with self.subTest(scene=scene.name):
                result = self.answer("critical", scene)
                self.assertLess(abs(result["simulated"] - result["formula"]) / result["formula"], 1e-9)
                self.assertLess(result["relative_difference"], 1e-9)
                # Both witnesses lose a few units in the last place here.
                self.assertLess(abs(result["stick_onset"] / result["formula"] - 1), 1e-12)
                self.assertTrue(result["agree"])

    def test_set_changes_the_scene(self):
        value = self.answer("eval", KELVIN)["critical_velocity"]
        doubled = self.answer("eval", KELVIN, "--set", "amplitude=0.2 um")["critical_velocity"]
        # v* is linear in du_z; the two amplitudes are rounded on their own.
        self.assertAlmostEqual(doubled / value, 2, delta=1e-14)

    def test_an_infinite_value_has_its_reason(self):
        result = self.answer("eval", DRIVE, *RESONANCE)
        self.assertEqual(result["critical_velocity"], "inf")
        self.assertIn("resonance", result["reasons"][0])

    def test_generate_writes_a_library(self):
        self.out("generate", KELVIN, "--out", "lib", "--name", "kelvin_contact")
        self.assertIn("namespace kelvin_contact", (self.folder / "lib/kelvin_contact.hpp").read_text())
        self.assertTrue((self.folder / "lib/CMakeLists.txt").exists())

    def test_generate_writes_one_file_in_other_languages(self):
        for language, row in drivers.LANGUAGES.items():
            if language == "c++":
                continue
            file = f"k.{row['file']}"
            printed = self.out("generate", KELVIN, "--out", language, "--name", "k", "--language", language)
            self.assertEqual(printed, f"{language}/{file}\n")
            self.assertEqual([path.name for path in (self.folder / language).iterdir()], [file])

    def test_generate_fixes_parameters(self):
        printed = self.out("generate", "--out", "lib", "--fix", "kn,cn", "--fix", "m", "--quantities", KELVIN)
        self.assertEqual(printed, "lib/critical.hpp\nlib/critical_quantities.hpp\n")
        for name, first in [("critical", "struct Parameters"), ("critical_quantities", "struct QuantityParameters")]:
            header = (self.folder / f"lib/{name}.hpp").read_text()
            self.assertIn("--fix kn,cn,m --quantities", header.replace("\n//", ""))
            parameters = header[header.index(first):].split("};")[0]
            self.assertRegex(parameters, r"\bkt\b")
            self.assertNotRegex(parameters, r"\b(kn|cn|m)[,;]")

    # The order of GiNaC's terms changes from process to process.
    def test_of_formulas_that_are_equally_short_each_run_takes_the_same(self):
        elements = {"k0": 1e6, "k1": 2e6, "k2": 3e6, "k3": 4e6, "c4": 5, "k5": 6e6, "kd": 1e6, "k6": 2e5, "c7": 3, "c8": 4}
        self.scene(elements, normal="k0 | ((k1 | k2) - k3 - (c4 | k5))", network="kd | (k6 | c7 | c8)", mass=2)
        for form in ("shortest", "dimensionless"):
            found = [self.out("derive", "s.toml", "--form", form) for _ in range(6)]
            self.assertIn("du_max", found[0])
            self.assertEqual({*found}, {found[0]})

    def test_the_page_about_networks_is_the_same_in_every_run(self):
        pages = [run("derive", example("burgers"), "--material") for _ in range(3)]
        self.assertEqual([page.returncode for page in pages], [0] * 3)
        self.assertIn("Tangential contact", pages[0].stdout)
        self.assertEqual({page.stdout for page in pages}, {pages[0].stdout})

    def test_a_massless_rigid_scene_has_neither_mass_nor_drive(self):
        self.out("generate", example("kelvin_rigid"), "--out", "lib")
        header = (self.folder / "lib/critical.hpp").read_text()
        parameters = header[header.index("struct Parameters"):].split("};")[0]
        for absent in [r"\bm\b", r"\bk_?d\b", "mass", "drive"]:
            self.assertNotRegex(parameters, absent)


class Verdicts(Case):
    """Exit status 1: a comparison failed. Here the compiler on the path is a liar."""

    def test_a_failed_comparison_ends_with_1_and_is_named(self):
        for name in ["g++", "clang++", "c++"]:
            self.write("#!/bin/sh\nexit 1\n", name).chmod(0o755)
        result = self.run_program("validate", example("elastic"), "--out", "out",
                                  env={"PATH": f"{self.folder}:/usr/bin:/bin"})
        self.assertEqual(result.returncode, 1)
        self.assertIn("FAILED", result.stderr)
        report = json.loads((self.folder / "out/report.json").read_text())
        outcomes = {c["key"]: c["outcome"] for c in report["scenes"][0]["comparisons"]}
        self.assertEqual(outcomes["generated"], "failed")
        self.assertEqual(outcomes["simulation"], "passed")


class Mistakes(Case):
    METHOD = ["simulate", KELVIN, "--velocity-ratio", "0.5", "--method"]

    def text_refused(self, text, *words, command="eval"):
        self.write(text)
        out = ["--out", "out"] if command in ("generate", "validate") else []
        self.refused(2, [command, "s.toml", *out], *words)

    def test_an_unknown_method_is_refused(self):
        self.refused(2, [*self.METHOD, "euler"], "euler", "rk8pd")

    def test_options_that_a_method_does_not_take_are_refused(self):
        for method, *option in [("exact", "--tolerance", "1e-6"), ("exact", "--plain"), ("rk8pd", "--steps", "100"),
                                ("rkf45", "--theta", "1"), ("moreau", "--tolerance", "1e-6"),
                                ("msbdf", "--regularisation", "0.1"), ("reduced", "--plain")]:
            with self.subTest(method=method, option=option):
                self.refused(2, [*self.METHOD, method, *option], option[0], method)

    def test_options_out_of_range_are_refused(self):
        for method, option, value in [("rk8pd", "--tolerance", "0"), ("moreau", "--steps", "1"), ("moreau", "--theta", "2"),
                                      ("tanh", "--regularisation", "-1")]:
            with self.subTest(option=option):
                self.refused(2, [*self.METHOD, method, option, value], option[2:])

    def test_the_reduced_model_says_what_it_has_not(self):
        self.refused(3, ["simulate", example("zener"), "--velocity-ratio", "0.5", "--method", "reduced"],
                     "a drive that is not rigid, and a mass")

    def test_a_method_that_does_not_settle_says_how(self):
        # Above v* what swings on an undamped drive swings for ever.
        self.refused(3, ["simulate", DRIVE, "--velocity-ratio", "1.05", "--method", "rk8pd", "--tolerance", "1e-6",
                         "--plain"], "rk8pd has not settled after")

    def test_errors_name_file_line_found_and_expected(self):
        self.text_refused(scene(normal="k0 | (k1 - c1"), "s.toml:2:16", "found", "expected")

    def test_every_command_refuses_a_wrong_scene_and_writes_nothing(self):
        for command in ["derive", "eval", "generate", "critical", "validate"]:
            with self.subTest(command=command):
                self.text_refused(scene().replace("normal", "norml"), "norml", command=command)

    def test_missing_values_are_named_at_once(self):
        text = scene(normal="kn | cn", angular_frequency=None, amplitude=None, indentation=None, coefficient=None)
        self.text_refused(text, "kn", "cn", "mu0", "omega", "du_z", "u_z0")

    def test_a_missing_file(self):
        self.refused(2, ["eval", "none.toml"], "none.toml")

    def test_names_that_cannot_be_generated(self):
        for name in ["class", "../evil", "a b", "std", "x;y"]:
            with self.subTest(name=name):
                self.refused(2, ["generate", KELVIN, "--out", "out", "--name", name])
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_names_that_python_refuses(self):
        for name in keyword.kwlist:
            with self.subTest(name=name):
                self.scene(normal=f"spring({name})", tangential="kt")
                to = ["generate", "s.toml", "--out", name, "--name", "good", "--language"]
                self.refused(2, [*to, "python"], name)
                self.assertFalse((self.folder / name).exists())
                # Words that Python alone reserves are names elsewhere.
                if name in ("None", "True", "False", "as"):
                    self.out(*to, "c99")

    def into_folders_of_inputs(self, scene):
        """Pages, pictures and headers have names of their own, which a scene may bear as well."""
        text = Path(scene).read_text()
        page, data, picture = [self.write(text, name) for name in ("index.html", "report.json", "cycle_force.svg")]
        header = self.write("# Generated by vcrit once.\n" + text, "critical.hpp")
        return [["validate", page, "--out", "."], ["validate", scene, data, "--out", "."],
                ["validate", picture, "--out", "report", "--figures", "."], ["generate", header, "--out", "."]]

    # A measured drive was lost to `--out drive.csv`, and a scene to `--out scene.toml`.
    def test_what_a_result_is_made_from_is_not_written_over(self):
        drive = self.write(Path(example("measured_drive")).with_suffix(".csv").read_bytes(), "measured_drive.csv")
        measured = self.write(Path(example("measured_drive")).read_bytes(), "measured.toml")
        zener = self.write(Path(example("zener")).read_bytes(), "zener.toml")
        values = self.write("0.1\n0.2\n", "values.csv")
        pad = self.write(Path(example("measured_pad")).with_suffix(".csv").read_bytes(), "pad.toml")
        sweep = ["--quantity", "critical_velocity", "--over"]
        for command in [["sweep", measured, *sweep, "mu0=lin:0.1:0.2:2", "--out", drive.name],
                        ["sweep", zener, *sweep, "mu0=list:values.csv", "--out", values],
                        ["explore", zener, "--out", "./zener.toml"], ["fit", pad, "--out", pad],
                        *self.into_folders_of_inputs(zener)]:
            with self.subTest(command=command):
                self.refused(2, command, "found a file that this result is made from; expected another name")
        self.assertEqual(values.read_text(), "0.1\n0.2\n")
        self.assertEqual(drive.read_bytes()[:11], b"omega,Re,Im")

    def test_parameters_that_cannot_be_fixed(self):
        for name, words in [("kdd", 'expected "kd"'), ("omega", "parameter of every call")]:
            with self.subTest(name=name):
                self.refused(2, ["generate", KELVIN, "--out", "out", "--fix", name], words)
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_wrong_usage_ends_with_2(self):
        for arguments in [["nothing"], ["eval"], ["eval", KELVIN, "--wrong"], ["simulate", KELVIN],
                          ["simulate", KELVIN, "--velocity", "1", "--velocity-ratio", "1"],
                          ["derive", KELVIN, "--format", "pdf"], ["derive"],
                          ["derive", KELVIN, "--catalogue"], ["derive", "--catalogue", "--limits"],
                          ["derive", "--material"], ["derive", KELVIN, "--material", "--form", "nested"],
                          ["derive", "--material", "missing.toml"], ["derive", KELVIN, "--form", "by-size"],
                          ["simulate", KELVIN, "--velocity", "-1"],
                          ["simulate", KELVIN, "--velocity", "3 kg"], ["eval", KELVIN, "--set", "kn"]]:
            with self.subTest(arguments=arguments):
                self.refused(2, arguments)

    def test_outside_the_model_ends_with_3(self):
        for command in [["simulate", "--velocity", "0.01"], ["critical"]]:
            self.refused(3, [command[0], example("inadmissible"), *command[1:]])

    def test_resonance_leaves_nothing_to_compare(self):
        for command in [["critical"], ["simulate", "--velocity-ratio", "0.5"]]:
            self.refused(3, [command[0], DRIVE, *command[1:], *RESONANCE], "resonance")

    def test_zero_by_zero_ends_with_3(self):
        self.refused(3, ["eval", DRIVE, *RESONANCE, "--set", "mu0=0"])


class Sweep(Case):
    def sweep(self, *arguments):
        """The table with its header, and what is told beside it."""
        result = self.run_program("sweep", KELVIN, *arguments, "--out", "table.csv")
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        header, *rows = (self.folder / "table.csv").read_text().splitlines()
        return [header.split(",")] + [[float(cell) for cell in row.split(",")] for row in rows], result.stderr

    def test_the_friction_curve_is_that_of_simulate(self):
        table, _ = self.sweep("--over", "velocity_ratio=lin:0.2:1:5", "--quantity", "friction_ratio")
        self.assertEqual(table[0], ["velocity_ratio", "friction_ratio"])
        self.assertEqual([row[0] for row in table[1:]], [0.2, 0.4, 0.6, 0.8, 1])
        for ratio, friction in table[1:]:
            single = self.answer("simulate", KELVIN, "--velocity-ratio", ratio)
            # Both are good to their own estimate.
            self.assertLessEqual(abs(friction - single["friction_ratio"]), 2 * single["friction_ratio_error"])

    def test_critical_velocity_over_two_axes(self):
        table, _ = self.sweep("--over", "frequency=log:1 kHz:100 kHz:3", "mass=lin:1 g:5 g:2",
                              "--quantity", "critical_velocity")
        self.assertEqual(table[0], ["frequency", "mass", "critical_velocity"])
        self.assertEqual([row[:2] for row in table[1:]],
                         [[f, m] for f in [1e3, 1e4, 1e5] for m in [1e-3, 5e-3]])
        for frequency, mass, critical in table[1:]:
            single = self.answer("eval", KELVIN, *settings({"frequency": frequency, "m": mass}))
            self.assertEqual(critical, single["critical_velocity"])

    def test_rows_outside_the_model_are_nan_and_told(self):
        table, told = self.sweep("--over", "amplitude=lin:0.1 um:1 um:2", "--velocity-ratio", "0.5",
                                 "--quantity", "friction_ratio")
        self.assertEqual([row[1] == row[1] for row in table[1:]], [True, False])
        self.assertIn("1 of 2 rows", told)

    def test_mistakes_write_nothing(self):
        for status, axis, quantity, words, *rest in [
                (2, "mass=1:2:3", "friction_ratio", "NAME=lin|log:FROM:TO:N"),
                (2, "mass=lin:1:2:3", "friction_ratio", "at no speed"),
                (2, "frequncy=lin:1:2:3", "friction_ratio", "frequency"),
                (2, "frequency=lin:0:2:3", "critical_velocity", "above 0"),
                (3, "amplitude=lin:1 mm:2 mm:3", "friction_ratio", "(Eq. 3)", "--velocity", "1"),
                (2, "mass=lin:1:2:3", "critical_velocity", ".csv", "--out", "a.xls")]:
            out = [] if "--out" in rest else ["--out", "table.csv"]
            self.refused(status, ["sweep", KELVIN, "--over", axis, "--quantity", quantity, *out, *rest], words)


class Help(unittest.TestCase):
    def test_every_command_has_help(self):
        for command in ["derive", "eval", "generate", "simulate", "critical", "sweep", "validate"]:
            result = run(command, "--help")
            self.assertEqual(result.returncode, 0)
            self.assertIn("SCENE", result.stdout)

    def test_what_must_be_given_comes_first(self):
        told = run("simulate", "--help").stdout
        self.assertLess(told.index("--velocity TEXT"), told.index("--set NAME=VALUE"))
        self.assertEqual(told.count("--velocity-ratio RATIO"), 1)
        commands = run("--help").stdout
        self.assertLess(commands.index("\n  eval "), commands.index("\n  derive "))

    def test_the_version_names_the_parts(self):
        result = run("--version")
        self.assertEqual(result.returncode, 0)
        first = result.stdout.splitlines()[0]
        self.assertRegex(first, r"^vcrit \d+\.\d+\.\d+ \(commit ([0-9a-f]{12}\+?|unknown)\)$")
        if (PROJECT / ".git").exists() and shutil.which("git"):
            self.assertNotIn("unknown", first)
        for part in ["vcrit", "GiNaC", "Eigen", "GSL", "Boost", "FLINT", "Arb"]:
            self.assertIn(part, result.stdout)


if __name__ == "__main__":
    unittest.main()
