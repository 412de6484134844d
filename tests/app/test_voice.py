"""What the program says to people: few digits and units, the same sentence everywhere, help where it is asked for, the command
or option that was meant, colour on a terminal for what is wrong alone."""

import csv
import os
import unittest
from pathlib import Path

import mpmath

from program import PROJECT, Case, example

ZENER = example("zener")


def shares():
    """(p/v*) dv*/dp of the Zener scene, by derivatives of the modulus in 30 digits."""
    mpmath.mp.dps = 30
    at = {"omega": 2 * mpmath.pi * 20000, "mu0": mpmath.mpf("0.3"), "du_z": mpmath.mpf("1e-7"), "poisson": mpmath.mpf("0.3"),
          "m": mpmath.mpf("5e-3"), "k0": mpmath.mpf("8e6"), "k1": mpmath.mpf("4e6"), "c1": mpmath.mpf(30), "kd": mpmath.mpf("2e6")}

    def velocity(p):
        damper = mpmath.mpc(0, p["omega"] * p["c1"])
        normal = p["k0"] + p["k1"] * damper / (p["k1"] + damper)
        tangential = normal * 2 * (1 - p["poisson"]) / (2 - p["poisson"])
        receptance = 1 / tangential + 1 / (p["kd"] - p["m"] * p["omega"] ** 2)
        return p["omega"] * p["mu0"] * p["du_z"] * abs(normal) * abs(receptance)

    return {name: mpmath.diff(lambda x, name=name: velocity(at | {name: x}), value) * value / velocity(at) for name, value in at.items()}


class Numbers(Case):
    # v* = 0.00409484150375441745, 1 - 0.1 um over 0.39677336269670169 um = 0.74796695191345 by mpmath; k0 u_z0 = 4 N.
    def test_eval_says_what_vibration_does(self):
        lines = self.out("eval", ZENER).splitlines()
        self.assertEqual(lines[:4], [
            "Zener contact under an elastic drive", "20 kHz, 0.1 µm amplitude, 0.5 µm indentation (4 N mean normal force).", "",
            "Vibration lowers friction below 4.095 mm/s, by at most 25 %."])
        for line in ["  lowest friction     0.748 of the sliding value (at rest)",
                     "  contact closed      up to 0.3968 µm (now 0.1 µm)"]:
            self.assertIn(line, lines)
        self.assertEqual(self.answer("eval", ZENER)["sentence"], lines[3])

    def test_digits(self):
        self.assertIn("below 4.094841503754418 mm/s", self.out("eval", ZENER, "--digits", "17"))
        self.assertIn("below 4.1 mm/s", self.out("eval", ZENER, "--digits", "2"))
        for number in ("0", "18", "few"):
            self.refused(2, ["eval", ZENER, "--digits", number], "--digits", number)

    def test_outside_the_model_there_is_no_v_in_the_sentence(self):
        text = self.out("eval", example("inadmissible"))
        self.assertIn("\nNo answer: at this amplitude the contact would open. It stays closed up to 0.2236 µm (now 0.36 µm).", text)
        self.assertIn("by the formula, which does not describe this motion", text)

    # mu0 k0 u_z0 = 1.2 N; the numbers are those of --json.
    def test_simulate_has_forces_and_a_coefficient(self):
        ratio = self.answer("simulate", ZENER, "--velocity", "2 mm/s")["friction_ratio"]
        text = self.out("simulate", ZENER, "--velocity", "2 mm/s")
        for part in ["At 2 mm/s, 0.4884 times v*, friction is ", f"mean friction       {1.2 * ratio:.4g} N of 1.2 N",
                     f"coefficient         {0.3 * ratio:.4g} (mu0 = 0.3)", "mean normal force   4 N",
                     "stick-slip: the contact sticks for a part of every cycle", "°  the contact starts to slide"]:
            self.assertIn(part, text)

    # 10 m/s is 2442 v*: what was meant was 10 mm/s.
    def test_a_speed_far_above_is_told(self):
        self.assertIn("\nAt 10 m/s, 2442 times v*: no reduction there, friction is full.\n",
                      self.out("simulate", ZENER, "--velocity", "10"))

    def test_a_ratio_may_be_per_cent(self):
        self.assertEqual(self.answer("simulate", ZENER, "--velocity-ratio", "50%"),
                         self.answer("simulate", ZENER, "--velocity-ratio", "0.5"))
        self.refused(2, ["simulate", ZENER, "--velocity-ratio", "half"], 'found "half"; expected a multiple of v*: 0.5 or 50%')

    def test_other_ratios_likewise(self):
        solve = ["solve", ZENER, "--for", "velocity", "--friction-ratio"]
        self.assertEqual(self.answer(*solve, "90%"), self.answer(*solve, "0.9"))
        self.refused(2, [*solve, "half"], '--friction-ratio: found "half"; expected a ratio below 1: 0.8 or 80%')
        sweep = ["sweep", ZENER, "--over", "k0=lin:7 N/um:8 N/um:2", "--quantity", "friction_ratio", "--velocity-ratio"]
        self.assertEqual(self.out(*sweep, "50%"), self.out(*sweep, "0.5"))

    # By mpmath: (k0/v*) dv*/dk0 and the like of |B| = mu0 du_z |K_n| |1/K_t + 1/(K_d - m omega^2)|.
    def test_sensitivities_are_numbers_too(self):
        rows = self.out("derive", ZENER, "--sensitivities").split("Sensitivities of this scene")[1].splitlines()[1:]
        found = {name: float(value) for name, value in (row.split() for row in rows)}
        self.assertEqual(list(found), sorted(found, key=lambda name: -abs(found[name])))
        for name, share in shares().items():
            self.assertAlmostEqual(found[name], share, delta=abs(share) * 5e-4)  # four digits
        self.assertNotIn("of this scene", self.out("derive", ZENER, "--limits"))

    def test_critical_says_what_is_independent(self):
        text = self.out("critical", ZENER)
        self.assertTrue(text.startswith("Formula and simulation agree on v* = 4.095 mm/s.\n"), text)
        self.assertIn("threshold of the linear sliding response, which the formula shares", text)
        self.assertIn("(independent)", text)


class Fit(Case):
    # k0 is 6 N/µm in the data, of which the fit finds 0.1 %.
    def test_has_units_that_read_well(self):
        text = self.out("fit", str(PROJECT / "scenes/measured_pad.csv"), "--out", "pad.toml")
        self.assertRegex(text, r"\n  k0   5\.996 N/µm   ± 1\d kN/m")
        self.assertIn("\n95 % intervals, for any number of branches, in N/µm:\n", text)
        self.assertNotIn("e+0", text)


class Tables(Case):
    SWEEP = ["sweep", ZENER, "--over", "velocity=lin:0.5 mm/s:4.5 mm/s:3", "--quantity", "regime"]

    def test_without_a_file_the_table_is_printed(self):
        rows = [line.split("  ") for line in self.out(*self.SWEEP).splitlines()]
        self.assertEqual([[cell.strip() for cell in row if cell] for row in rows],
                         [["velocity [mm/s]", "regime"], ["0.5", "stick-slip"], ["2.5", "stick-slip"], ["4.5", "sliding"]])
        self.assertEqual(self.answer(*self.SWEEP)["table"], [[0.0005, "stick-slip"], [0.0025, "stick-slip"], [0.0045, "sliding"]])

    # 4.094841503754417 mm/s at 20 kHz; the contact opens above 0.3968 um.
    def test_numbers_of_a_printed_table_have_four_digits_and_one_unit_a_column(self):
        text = self.run_program("sweep", ZENER, "--over", "amplitude=lin:0.1 um:0.5 um:2", "--quantity", "critical_velocity").stdout
        self.assertEqual(text.splitlines(), ["amplitude [µm]  critical_velocity [mm/s]", "0.1             4.095", "0.5             nan"])

    def test_csv_on_standard_output_is_that_of_a_file(self):
        self.out(*self.SWEEP, "--out", "table.csv")
        self.assertEqual(self.out(*self.SWEEP, "--out", "-"), (self.folder / "table.csv").read_text())

    # Read by Python's csv. 20 kHz, 0.1 um: 4.0948415037544174 mm/s.
    def test_units_in_the_header_if_asked_for(self):
        sweep = ["sweep", ZENER, "--over", "velocity_ratio=lin:0.5:1.5:2", "--over", "frequency=lin:20 kHz:40 kHz:2",
                 "--quantity", "critical_velocity", "regime", "sensitivity:mu0", "--out"]
        self.out(*sweep, "names.csv")
        self.out(*sweep, "units.csv", "--units")
        names, units = ([*csv.reader((self.folder / name).read_text().splitlines())] for name in ("names.csv", "units.csv"))
        self.assertEqual(names[0], ["velocity_ratio", "frequency", "critical_velocity", "regime", "sensitivity_mu0"])
        self.assertEqual(units[0], ["velocity_ratio", "frequency [Hz]", "critical_velocity [m/s]", "regime", "sensitivity_mu0"])
        self.assertEqual((names[1:], len(names)), (units[1:], 5))
        self.assertAlmostEqual(float(units[1][2]), 4.0948415037544174e-3, delta=1e-17)
        self.assertEqual(self.out(*sweep, "-", "--units"), (self.folder / "units.csv").read_text())

    def test_maps_need_a_file(self):
        self.refused(2, [*self.SWEEP[:3], "velocity=lin:1:2:100001", *self.SWEEP[4:]], "no file with so many rows")
        self.refused(2, [*self.SWEEP, "--resume"], "no file with --resume")

    def test_an_axis_may_lack_its_spacing(self):
        for range_ in ("1 mm/s:5 mm/s:5", "linear:1 mm/s:5 mm/s:5", "linspace:1 mm/s:5 mm/s:5"):
            self.refused(2, [*self.SWEEP[:3], f"velocity={range_}", *self.SWEEP[4:]], 'did you mean "velocity=lin:1 mm/s:5 mm/s:5"?')

        self.refused(2, [*self.SWEEP[:3], "velocity=lin:1 mm/s:5 mm/s", *self.SWEEP[4:]], 'say how many values: "velocity=lin:1 mm/s:5 mm/s:11"')

    def test_quantities_go_by_other_words(self):
        for word, meant in (("friction", "friction_ratio"), ("vstar", "critical_velocity"), ("v*", "critical_velocity")):
            self.refused(2, [*self.SWEEP[:5], word], f'found "{word}"; expected "{meant}"')

    def test_quantities_stand_apart(self):
        self.refused(2, [*self.SWEEP[:5], "regime,friction_ratio"], 'found "regime,friction_ratio"',
                     "several stand apart, without commas: regime friction_ratio")

    def test_values_of_an_axis_are_named_by_it(self):
        def refused(axis, *words, more=("--quantity", "critical_velocity")):
            self.assertNotIn("--set", self.refused(2, ["sweep", ZENER, "--over", axis, *more], *words))
        refused("poisson=lin:0.1:0.7:3", "--over poisson: found poisson = 0.7; expected")
        refused("k0=lin:-1 N/um:2 N/um:3", "--over k0: found k0 = -1 N/µm; expected")
        refused("frequency=lin:-1 kHz:2 kHz:3", "--over frequency: found frequency = -1 kHz; expected")
        refused("frequency=lin:1 kHz:2 kHz:3", "--over", "frequency", "angular_frequency",
                more=["--over", "angular_frequency=lin:1:2:2", "--quantity", "critical_velocity"])
        friction = ["--quantity", "friction_ratio"]
        refused("velocity=lin:-1 mm/s:2 mm/s:3", "--over velocity: found a speed of -1 mm/s", more=friction)
        refused("velocity_ratio=lin:-1:2:3", "--over velocity_ratio: found -1; expected a ratio above 0", more=friction)
        refused("k0=lin:1:2:3", "--velocity-ratio: found -1; expected a ratio above 0", more=["--velocity-ratio", "-1", *friction])
        refused("k0=lin:1:2:3", "--velocity: found a speed of -2 mm/s", more=["--velocity", "-2 mm/s", *friction])

    def test_an_axis_may_have_been_meant(self):
        self.refused(2, ["sweep", ZENER, "--over", "freq=lin:1:2:3", "--quantity", "critical_velocity"], 'expected "frequency"')


class Values(Case):
    def test_out_of_range_are_repeated_as_they_were_typed(self):
        for name, typed in (("amplitude", "-0.1 um"), ("k0", "-8 N/um"), ("mass", "-5 g"), ("frequency", "0 kHz")):
            self.refused(2, ["eval", ZENER, "--set", f"{name}={typed}"], f"--set {name}: found {name} = {typed}; expected a finite value")
        scene = self.write(Path(ZENER).read_text().replace('"0.1 um"', '"-0.1 um"').replace('"8 N/um"', '"-8 N/um"'))
        told = self.run_program("check", scene)
        for words in ("amplitude = -0.1 um", "k0 = -8 N/um"):
            self.assertIn(words, told.stdout)
        self.refused(2, ["eval", ZENER, "--set", "amplitude=-1e-7"], "amplitude = -1e-07; expected")  # a double, in SI

    def test_of_options_too(self):
        solve = ["solve", ZENER, "--for", "amplitude", "--friction-ratio", "0.5", "--velocity", "2 mm/s"]
        self.refused(2, [*solve, "--from", "-1 um"], "--from: found -1 µm; expected a number above 0")
        self.refused(2, ["simulate", ZENER, "--velocity-ratio", "-0.5"], "--velocity-ratio: found -0.5; expected a ratio above 0")


class Help(Case):
    def test_alone_and_by_its_word(self):
        self.assertEqual(self.out(), self.out("--help"))
        self.assertEqual(self.out("help"), self.out("--help"))
        self.assertEqual(self.out("help", "eval"), self.out("eval", "--help"))

    def test_what_was_meant(self):
        self.refused(2, ["evl", ZENER], 'found "evl"', "did you mean eval?")
        self.refused(2, ["eval", ZENER, "--jsn"], "found --jsn", "did you mean --json?")
        self.refused(2, ["help", "evla"], "did you mean eval?")
        for arguments, meant in [
                (["--vesion"], "--version"), (["--completion", "bsh"], "bash"), (["new", "a.toml", "--rheology", "zner"], "zener"),
                (["derive", ZENER, "--format", "latx"], "latex"), (["solve", ZENER, "--for", "amplitud"], "amplitude"),
                (["simulate", ZENER, "--method", "rk45", "--velocity", "1"], "rkf45"), (["eval", ZENER, "--digts=3"], "--digits"),
                (["simulate", ZENER, "--velocty", "1"], "--velocity")]:
            self.refused(2, arguments, f"did you mean {meant}?")

    def test_all_that_is_missing(self):
        self.refused(2, ["eval"], "found no SCENE; expected vcrit eval SCENE;")
        self.refused(2, ["fit", "data.csv"], "found no --out; expected vcrit fit DATA --out ")
        self.refused(2, ["solve", ZENER], "found no --for, no --friction-ratio; expected vcrit solve SCENE --for {amplitude,",
                     "--friction-ratio RATIO")
        self.refused(2, ["derive"], "found no SCENE; expected vcrit derive SCENE")

    def test_one_of_two(self):
        both = "--velocity and --velocity-ratio"
        self.refused(2, ["simulate", ZENER], f"found none of {both}; expected one of the two")
        self.refused(2, ["simulate", ZENER, "--velocity", "1", "--velocity-ratio", "2"], f"found {both}; expected one of the two")

    def test_what_belongs_elsewhere(self):
        self.refused(2, ["eval", ZENER, "--frequency", "25"], "a number of the scene is --set frequency=VALUE")
        self.refused(2, ["simulate", ZENER, "--velocity", "2", "mm/s"], 'a value with a blank in it needs quotes: "2 mm/s"')
        self.refused(2, [ZENER], f"; vcrit eval {ZENER}")
        self.refused(2, ["evaluate", ZENER], "did you mean eval?")
        self.refused(2, ["simulate", ZENER, "--velocity-ratio", "0,5"], 'write a decimal point: "0.5"')
        self.refused(2, ["eval", self.write("frequency,storage,loss\n", "d.csv")], "vcrit fit makes a scene of measured stiffness")
        self.refused(2, ["eval", self.scene(normal="kn", network="rigid")], "leave out [drive]")
        self.refused(2, ["eval", self.write(Path(ZENER).read_text().replace("poisson ", "poissons_ratio "))], 'expected "poisson"')

    def test_blanks_around_signs_do_no_harm(self):
        self.assertEqual(self.out("eval", ZENER, "--set", "k0 = 9 N/um"), self.out("eval", ZENER, "--set", "k0=9 N/um"))
        axes = ["frequency=lin:1 kHz:2 kHz:3", "frequency = lin: 1 kHz : 2 kHz : 3"]
        tables = [self.out("sweep", ZENER, "--over", axis, "--quantity", "critical_velocity") for axis in axes]
        self.assertEqual(*tables)

    def test_options_that_exclude_each_other(self):
        self.refused(2, ["plot", ZENER, "--over", "frequency", "--cycle"], "--over and --cycle; expected one of the two")
        self.refused(2, ["derive", ZENER, "--material", "--limits"], "--limits and --material; expected one of the two")

    def test_too_much(self):
        self.refused(2, ["eval", ZENER, "other.toml"], "found other.toml; expected one SCENE")
        self.refused(2, ["plot", ZENER, "--samples", "9"],
                     "found --samples; expected one of --help, --set, --over, --of, --cycle, --to,", "--velocity, --velocity-ratio; run")
        self.refused(2, ["--digits", "3", "eval", ZENER], "found --digits; expected a command before its options")

    def test_no_value(self):
        """An empty one, as an unset variable of the shell leaves, is named by the option that has it."""
        for option, line in [
            ("SCENE", ["eval", ""]), ("SCENE", ["validate", "", "--out", "v"]), ("FILE", ["new", ""]),
            ("--out", ["fit", "x.csv", "--out", ""]), ("--velocity", ["simulate", ZENER, "--velocity", ""]),
            ("--out", ["generate", ZENER, "--out", ""]), ("--out", ["plot", ZENER, "--out", ""]),
        ]:
            with self.subTest(line=line):
                self.refused(2, line, f'{option}: found ""; expected a value')
        for line in (["--digits", ""], ["--digits="]):
            self.refused(2, ["eval", ZENER, *line], "--digits: found ")
        self.refused(2, ["eval", ZENER, "--digits", ""], 'found "";')

    def test_once(self):
        self.refused(2, ["eval", ZENER, "--digits", "6", "--digits", "7"], "--digits: found it 2 times; expected it once")
        self.refused(2, ["simulate", ZENER, *["--velocity", "1"] * 3], "--velocity: found it 3 times; expected it once")
        self.refused(2, ["eval", ZENER, "--", "--digits"], "--digits behind --", "expected options before it")

    def test_options_of_methods(self):
        """By the name of the option, also where the library refuses its value."""
        for option, value, method in (("steps", "3", "moreau"), ("theta", "0.4", "moreau"), ("tolerance", "1", "rk8pd"),
                                      ("regularisation", "2", "tanh")):
            self.refused(2, ["simulate", ZENER, "--velocity-ratio", "0.5", "--method", method, f"--{option}", value],
                         f"vcrit: --{option}: found {value}; expected a number from")
        self.refused(2, ["simulate", ZENER, "--velocity-ratio", "0.5", "--steps", "9"], "expected moreau, which takes it")

    def test_whole_numbers(self):
        """An int of C++ is not any number."""
        solve = ["solve", ZENER, "--for", "velocity", "--friction-ratio", "0.8"]
        simulate = ["simulate", ZENER, "--velocity-ratio", "0.5", "--method", "moreau"]
        for line, option, value in ((["fit", "pad.csv", "--out", "pad.toml"], "max-branches", "1e12"),
                                    (solve, "samples", "2.5"), (simulate, "steps", "99999999999")):
            self.refused(2, [*line, f"--{option}", value],
                         f"--{option}: found {value}; expected a whole number of at most 2147483647; run with --help")
        self.refused(2, [*simulate, "--theta", "half"], "--theta: found half; expected a number; run with --help")

    def test_languages_by_short_names(self):
        for short, full in [("c", "c99"), ("cpp", "c++"), ("js", "javascript"), ("py", "python")]:
            self.assertEqual(self.answer("generate", ZENER, "--out", short, "--language", short)["language"], full)


class Networks(Case):
    def test_letters_of_textbooks(self):
        for network, written in [("E0 | (E1 - eta1)", "spring(E0) | (spring(E1) - damper(eta1))"), ("k0 | G1", "k0 | spring(G1)")]:
            self.refused(2, ["eval", self.scene(normal=network)], f'write "{written}"')
        message = self.refused(2, ["eval", self.scene(normal="E0 | pad")], 'element "E0" of unknown kind')
        self.assertNotIn("write", message)


class Colour(Case):
    RED = "\x1b[31m"

    def test_what_is_wrong_is_red(self):
        for arguments in (["eval", "absent.toml"], ["eval", example("inadmissible")], ["evl"]):
            self.assertIn(self.RED, self.on_terminal(*arguments, with_errors=True, TERM="xterm"), arguments)
            for environment in ({"TERM": "dumb"}, {"TERM": "xterm", "NO_COLOR": "1"}, {}):
                self.assertNotIn("\x1b", self.on_terminal(*arguments, with_errors=True, **environment), arguments)
        self.assertIn(self.RED, self.on_terminal("eval", "absent.toml", with_errors=True, TERM="xterm", NO_COLOR=""))

    def test_nothing_else_is(self):
        self.assertNotIn("\x1b", self.on_terminal("eval", ZENER, TERM="xterm"))


class Pipes(Case):
    def test_have_no_colour(self):
        environment = os.environ | {"TERM": "xterm"}
        for arguments in (["eval", "absent.toml"], ["eval", example("inadmissible")]):
            ended = self.run_program(*arguments, env=environment)
            self.assertNotIn("\x1b", ended.stdout + ended.stderr)


if __name__ == "__main__":
    unittest.main()
