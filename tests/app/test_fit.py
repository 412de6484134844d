"""vcrit fit as a user meets it: a table in, a scene and a page out, and nothing written for a bad table."""

import cmath
import json
import math
import random
import re
import unittest

from program import Case

K0, BRANCHES = 2e6, [(1e6, 1e-5), (3e6, 1e-3), (5e5, 2e-2)]


def stiffness(omega):
    return K0 + sum(k * 1j * omega * tau / (1 + 1j * omega * tau) for k, tau in BRANCHES)


def spring_pot(omega):
    return 1e5 * cmath.exp(0.4 * cmath.log(1j * omega))


def table(model, noise=0.0, errors=False, rows=60, first=0.1, last=1e6):
    """Hz and N/um, each component off by a normal deviate times |K|."""
    draw = random.Random(11)
    text = "frequency [Hz],storage [N/um],loss [N/um]" + (",storage_error [N/um],loss_error [N/um]" if errors else "")
    for i in range(rows):
        frequency = first * (last / first) ** (i / (rows - 1))
        k = model(2 * math.pi * frequency) / 1e6
        error = noise * abs(k)
        cells = [frequency, k.real + error * draw.gauss(0, 1), k.imag + error * draw.gauss(0, 1)]
        text += "\n" + ",".join(map(repr, cells + ([error, error] if errors else [])))
    return text + "\n"


class Fit(Case):
    def fit(self, text, *arguments):
        self.write(text, "data.csv")
        result = self.run_program("fit", "data.csv", "--out", "out/scene.toml", "--json", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def test_exact_data_give_the_series_back(self):
        result = self.fit(table(stiffness))
        self.assertEqual(
            list(result),
            ["scene", "page", "rows", "equilibrium", "equilibrium_error", "branches", "order_in_doubt", "stiffness",
             "rms_relative_misfit", "degrees_of_freedom", "noise", "exhausted", "words"])
        self.assertEqual((result["scene"], result["page"], result["rows"]), ("out/scene.toml", "out/scene.html", 60))
        found = [result["equilibrium"]] + [b[key] for key in ("stiffness", "time") for b in result["branches"]]
        truth = [K0] + [k for k, _ in BRANCHES] + [tau for _, tau in BRANCHES]
        self.assertEqual(len(found), len(truth))
        for a, b in zip(found, truth):
            self.assertAlmostEqual(a / b, 1, delta=1e-9)  # the search settles to 1e-11; a hundredfold

    def test_moduli_below_a_punch_give_the_series_of_their_stiffness(self):
        length = 2 * 0.5e-3 / (1 - 0.4 ** 2)
        text = "freq [Hz],storage_modulus [MPa],tan_delta\n"
        for i in range(60):
            frequency = 0.1 * 1e7 ** (i / 59)
            k = stiffness(2 * math.pi * frequency)
            text += f"{frequency!r},{k.real / length / 1e6!r},{k.imag / k.real!r}\n"
        result = self.fit(text, "--punch-radius", "0.5 mm", "--poisson", "0.4")
        found = [result["equilibrium"]] + [b[key] for key in ("stiffness", "time") for b in result["branches"]]
        truth = [K0] + [k for k, _ in BRANCHES] + [tau for _, tau in BRANCHES]
        self.assertEqual(len(found), len(truth))
        for a, b in zip(found, truth):
            self.assertAlmostEqual(a / b, 1, delta=1e-9)
        self.assertIn("below a flat punch of radius 500 µm", " ".join(result["words"]))
        self.write(text, "data.csv")
        self.refused(2, ["fit", "data.csv", "--out", "a.toml"], "found storage_modulus in MPa, a modulus")
        self.refused(2, ["fit", "data.csv", "--out", "a.toml", "--punch-radius", "1 mm"], "expected --poisson as well")
        self.refused(2, ["fit", "data.csv", "--out"], "--out: found no value;")
        self.refused(2, ["fit", "data.csv", "--out", "a.toml", "--punch-radius", "0", "--poisson", "0.3"],
                     "expected a length above 0")
        self.refused(2, ["fit", "data.csv", "--out", "a.toml", "--punch-radius", "1 mm", "--poisson", "0.6"],
                     "expected a number above -1, at most 0.5")

    def test_headers_of_other_programs(self):
        for header, words in [("freq_hz,storage,loss", 'a unit stands in brackets: "freq [Hz]"'),
                              ("frequency [Hz]\tstorage [MPa]\tloss [MPa]", "found columns separated by tabs"),
                              ("Frequency (Hz),Storage Modulus (MPa),Loss Modulus (MPa),Tan Delta", "leave its column out")]:
            self.write(header + "\n1,2,3\n", "data.csv")
            self.refused(2, ["fit", "data.csv", "--out", "a.toml", "--punch-radius", "1 mm", "--poisson", "0.3"], words)
        usual, primed = (f"frequency [Hz],{names}\n1,2,.2\n10,3,.3\n100,4,.4\n" for names in
                         ("storage [N/um],loss [N/um]", "E_prime [N/um],E_double_prime [N/um]"))
        self.assertEqual(self.fit(usual)["branches"], self.fit(primed)["branches"])

    def test_noise_is_measured_and_the_numbers_are_within_their_errors(self):
        result = self.fit(table(stiffness, 0.01))
        self.assertEqual(len(result["branches"]), 3)
        # 113 degrees of freedom: the estimate scatters by 6.7 %; four times that.
        self.assertAlmostEqual(result["noise"] / 0.01, 1, delta=0.27)
        for branch, (k, tau) in zip(result["branches"], BRANCHES):
            # Five standard deviations; none may be larger than 5 % either.
            self.assertLess(abs(branch["stiffness"] - k), 5 * branch["stiffness_error"])
            self.assertLess(abs(branch["time"] - tau), 5 * branch["time_error"])
            self.assertLess(branch["stiffness_error"], 0.05 * k)

    def test_intervals_of_the_stiffness_cross_the_data_and_hold_the_truth(self):
        result = self.fit(table(stiffness, 0.01, rows=12), "--frequency", "20 Hz")
        frequencies = [at["frequency"] for at in result["stiffness"]]
        self.assertEqual(frequencies, sorted(frequencies))
        for expected in (0.1, 20, 1e6):
            self.assertLess(min(abs(f / expected - 1) for f in frequencies), 1e-9)
        for at in result["stiffness"]:
            truth = stiffness(2 * math.pi * at["frequency"])
            for name, value in (("storage", truth.real), ("loss", truth.imag)):
                low, high = at[name + "_low"], at[name + "_high"]
                self.assertLessEqual(low, at[name])
                self.assertLessEqual(at[name], high)
                # The half width is 1.96 deviations; three of them, and twenty draws are never outside.
                self.assertLess(abs(value - at[name]), 1.5 * (high - low))
        outside = self.fit(table(stiffness, 0.01, rows=12), "--frequency", "2 MHz")
        self.assertEqual(len(outside["stiffness"]), len(frequencies) - 1)

    def test_given_errors_bring_chi_squared(self):
        result = self.fit(table(stiffness, 0.01, errors=True))
        self.assertNotIn("noise", result)
        self.assertEqual(result["degrees_of_freedom"], 113)
        # Mean 113, deviation 15: four of them.
        self.assertAlmostEqual(result["chi_squared"], 113, delta=60)

    def test_a_spring_pot_over_eight_decades_is_fitted_to_the_noise(self):
        result = self.fit(table(spring_pot, 0.01, rows=81, first=0.01))
        self.assertFalse(result["exhausted"])
        self.assertAlmostEqual(result["noise"] / 0.01, 1, delta=0.3)
        # Of both components together.
        self.assertAlmostEqual(result["rms_relative_misfit"] / (0.01 * math.sqrt(2)), 1, delta=0.3)

    def test_the_scene_is_one_for_the_other_commands(self):
        self.fit(table(stiffness, 0.01))
        for command in [["derive", "out/scene.toml"], ["generate", "out/scene.toml", "--out", "lib"]]:
            result = self.run_program(*command)
            self.assertEqual((result.returncode, result.stderr), (0, ""), command)
        self.refused(2, ["eval", "out/scene.toml"], "nu", "omega", "du_z", "u_z0", "mu0")
        text = (self.folder / "out/scene.toml").read_text()
        self.assertNotIn("[body]", text)
        self.assertNotIn("[drive]", text)

    def test_what_is_given_makes_it_complete(self):
        self.fit(table(stiffness), "--frequency", "20 kHz", "--amplitude", "0.1 um", "--indentation", "0.5 um",
                 "--coefficient", "0.3", "--poisson", "0.4", "--title", "Pad")
        result = self.answer("eval", "out/scene.toml")
        # Rigid drive, isotropic contact: v* = mu0 omega du_z (2 - nu)/(2 - 2 nu).
        expected = 0.3 * 2 * math.pi * 20e3 * 1e-7 * 1.6 / 1.2
        self.assertAlmostEqual(result["critical_velocity"] / expected, 1, delta=1e-14)

    def test_the_page_shows_data_fit_and_residuals_and_needs_nothing_else(self):
        # All losses are well above the noise: logarithmic axes show no others.
        self.fit(table(stiffness, 0.01, first=10, last=3e4))
        page = (self.folder / "out/scene.html").read_text()
        charts = [json.loads(part.split("</script>")[0])
                  for part in page.split('<script type="application/json">')[1:]]
        self.assertEqual(len(charts), 3)
        drawn = [series["points"] for series in charts[0]["series"]]
        self.assertEqual([len(values) for values in drawn], [301, 301, 60, 60])
        # The drawn line is the model within what 1 % of noise leaves of it.
        for frequency, storage, *_ in drawn[0]:
            self.assertAlmostEqual(1e6 * storage / stiffness(2 * math.pi * frequency).real, 1, delta=0.01)
        self.assertEqual([chart["y"]["title"] for chart in charts[::2]], 2 * ["stiffness, N/µm"])
        words = re.sub(r"<(script|style|pre)\b.*?</\1>", "", page, flags=re.DOTALL)
        self.assertIn("60 frequencies from 10 Hz to 30 kHz", words)
        self.assertRegex(words, r"<td>(2\.9|3\.0)\d\d? N/µm ± \d+ kN/m</td><td>(99\d(\.\d)? µs|1\.\d{1,3} ms) ± \d+ µs")
        self.assertNotRegex(words, r"\d(\.\d+)?e[+-]\d")
        residuals = [point[1] for series in charts[1]["series"][:2] for point in series["points"]]
        self.assertEqual(len(residuals), 120)
        # In per cent, of 1 % noise: the mean square is 1 less 7 of 120 parameters, scattering by 13 %.
        self.assertAlmostEqual(sum(r * r for r in residuals) / 120, 113 / 120, delta=0.52)
        self.assertIn("Content-Security-Policy", page)
        self.assertNotIn('src="http', page)

    def test_figures_are_files_too(self):
        self.fit(table(stiffness, 0.01), "--figures", "figures")
        self.assertEqual(
            sorted(path.name for path in (self.folder / "figures").iterdir()),
            sorted(f"{name}.{ending}" for name in ["branches", "residuals", "stiffness"] for ending in ["gp", "pdf", "svg"]))

    def test_the_terminal_says_what_was_found(self):
        self.write(table(stiffness), "d.csv")
        result = self.run_program("fit", "d.csv", "--out", "s.toml")
        self.assertEqual(result.stdout.splitlines()[0], "3 branches and an equilibrium spring")
        self.assertEqual(result.stdout.splitlines()[-2:], [
            "Wrote s.toml and, with data and series, s.html.", "It lacks numbers, which vcrit check s.toml names."])
        whole = self.run_program("fit", "d.csv", "--out", "s.toml", "--frequency", "1 kHz", "--amplitude", "0.1 um",
                                 "--indentation", "1 um", "--coefficient", "0.3", "--poisson", "0.3")
        self.assertEqual(whole.stdout.splitlines()[-1], "Wrote s.toml and, with data and series, s.html.")
        self.assertRegex(result.stdout, r"k    3 N/µm .* tau  1 ms ")

    # Storage that swings up and down is no network's.
    def test_data_that_no_series_comes_near_are_called_so(self):
        result = self.fit(table(lambda omega: 1e6 * complex(2 + math.cos(5 * math.log(omega)), 0.01)))
        self.assertIn("no series of springs and dampers comes near these data", result["words"])
        self.assertNotIn("comes near", str(self.fit(table(stiffness, 0.01))["words"]))

    def test_a_bad_table_is_one_message_with_file_and_line_and_nothing_is_written(self):
        head = "frequency,storage,loss\n"
        for text, line, words in [
            ("frequency,storage\n1,2\n", 1, "no column loss"),
            (head + "1,2,1\n2,-2,1\n", 3, "storage = -2 N/m"),
            (head + "1,2,1\n3,2,1\n2,2,1\n", 4, "go on rising"),
            (head + "1,2,nan\n2,2,1\n", 2, "\"nan\""),
            (head + "1,2,1\n", 2, "one row of numbers"),
            (head + "1,2,1\n2,2,1\n", 3, "2 rows of numbers; expected at least 3 rows"),
        ]:
            with self.subTest(words=words):
                self.write(text, "bad.csv")
                message = self.refused(2, ["fit", "bad.csv", "--out", "out/s.toml"], words)
                self.assertTrue(message.startswith(f"bad.csv:{line}: "), message)
                self.assertFalse((self.folder / "out").exists())

    def test_units_that_are_assumed_are_named(self):
        rows = "1,2,0.1\n10,2.1,0.2\n100,2.3,0.2\n1000,2.4,0.1\n"
        words = str(self.fit("frequency,storage,loss\n" + rows)["words"])
        self.assertIn("frequency in Hz, storage in N/m, loss in N/m", words)
        self.assertNotIn("units", str(self.fit("frequency [Hz],storage [N/m],loss [N/m]\n" + rows)["words"]))

    # Fitted from 100 Hz to 10 kHz; asked for at 1 MHz by every command that evaluates.
    def test_frequencies_beyond_the_data_are_warned_of(self):
        self.fit(table(stiffness, first=100, last=1e4), "--frequency", "1 kHz", "--amplitude", "0.1 um",
                 "--indentation", "0.5 um", "--coefficient", "0.3", "--poisson", "0.4")
        scene = "out/scene.toml"
        self.assertIn('fitted_range = ["100 Hz", "10000 Hz"]', (self.folder / scene).read_text())
        said = "fitted to data from 100 Hz to 10 kHz and is asked for at "
        outside, inside = ["--set", "frequency=1 MHz"], ["--set", "frequency=10 kHz"]
        ratio = ["--velocity-ratio", "0.5"]
        of_speed = ["--for", "velocity", "--friction-ratio", "0.9"]
        grid = ["--quantity", "critical_velocity", "--out", "t.csv"]
        for arguments, warned in [
            (["eval", scene], None), (["eval", scene, *inside], None), (["eval", scene, *outside], "1 MHz"),
            (["simulate", scene, *ratio, *outside], "1 MHz"), (["critical", scene, *outside], "1 MHz"),
            (["derive", scene, *outside], "1 MHz"), (["generate", scene, "--out", "lib", *outside], "1 MHz"),
            (["solve", scene, *of_speed, *outside], "1 MHz"), (["solve", scene, *of_speed], None),
            (["sweep", scene, "--over", "mu0=lin:0.1:0.2:2", *grid, *outside], "1 MHz"),
            (["sweep", scene, "--over", "frequency=log:1 kHz:1 MHz:3", *grid], "1 kHz to 1 MHz"),
            (["sweep", scene, "--over", "omega=log:1e3:1e4:3", *grid, *outside], None),
            (["sweep", scene, "--over", "omega=log:1e2:1e4:3", *grid], "15.92 Hz to 1.592 kHz"),
            (["solve", scene, "--for", "frequency", "--friction-ratio", "0.9", "--velocity", "0.1 mm/s",
              "--from", "1 Hz"], "1 Hz to "),
        ]:
            with self.subTest(arguments=arguments):
                result = self.run_program(*arguments, "--json")
                self.assertEqual(result.returncode, 0, result.stderr)
                found = json.loads(result.stdout)
                if warned is None:
                    self.assertEqual((result.stderr, found.get("warnings")), ("", None))
                    continue
                self.assertEqual(len(found["warnings"]), 1)
                self.assertIn(said + warned, found["warnings"][0])
                self.assertEqual(result.stderr, f"vcrit: warning: {found['warnings'][0]}\n")

    # A loss of 0 leaves a stiffness that is the same at all frequencies but for rounding: its chart had ticks without
    # end, until no memory was left.
    def test_a_stiffness_that_stays_has_a_chart(self):
        for stays in (1e6, 1e20):
            found = self.fit("frequency,storage,loss\n" + "".join(f"{i},{stays},0\n" for i in range(1, 9)))
            self.assertEqual(found["branches"], [])
            self.assertAlmostEqual(found["equilibrium"] / stays, 1, delta=1e-9)

    # Squares left the range of doubles: status 70, or "no series comes near these data" of a plain spring.
    def test_numbers_whose_squares_are_no_doubles_are_refused(self):
        for cells, words in [("1,1e-320,1e-321", "a stiffness of"), ("1,1e200,1", "a stiffness of"),
                             ("1e-300,1e6,1", "an angular frequency of")]:
            self.write(f"frequency,storage,loss\n{cells}\n10,1e6,1\n100,1e6,1\n", "d.csv")
            self.refused(2, ["fit", "d.csv", "--out", "s.toml"], "d.csv: found " + words)

    # "s.toml:8:11" was named, which is not there.
    def test_wrong_values_are_those_of_options(self):
        self.write(table(stiffness), "d.csv")
        for option, value in (("poisson", "0.6"), ("frequency", "-1"), ("amplitude", "-1 um")):
            self.refused(2, ["fit", "d.csv", "--out", "s.toml", f"--{option}", value],
                         f"--{option}: found {option} = {value}; expected")

    def test_wrong_options_write_nothing(self):
        self.write(table(stiffness), "d.csv")
        for arguments, words in [
            (["--out", "o/s.txt"], ".toml"), (["--out", "o/s.toml", "--max-branches", "0"], "at least 1"),
            (["--out", "o/s.toml", "--frequency", "1 mm"], "--frequency"), ([], "--out"),
            (["--out", "o/s.toml", "--amplitude", "-1 um"], "amplitude"),
        ]:
            with self.subTest(arguments=arguments):
                self.refused(2, ["fit", "d.csv", *arguments], words)
                self.assertFalse((self.folder / "o").exists())


if __name__ == "__main__":
    unittest.main()
