"""`vcrit derive` as a user meets it: forms, equality, large networks."""

import os
import re
import resource
import unittest

from example_scenes import with_formula
from program import PROGRAM, PROJECT, Case, settings

SYMBOLS = dict.fromkeys(["angular_frequency", "amplitude", "indentation", "coefficient"])
DIFFERENT = "k0 | (k1 - c1)", "k1 | (k0 - c1)"


def within(seconds):
    """Of processor time, for a program that is started; ten times as many for a sanitized one."""
    limit = seconds * (10 if "VCRIT_SANITIZED" in os.environ else 1)
    return lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))


class Derive(Case):
    def contact(self, name, normal, *parts):
        return self.scene(*parts, name=name, normal=normal, tangential="kt", network="kd", **SYMBOLS)

    def derive(self, *arguments, status=0):
        return self.out("derive", *arguments, status=status)

    def different(self):
        return [self.contact(f"{number}.toml", normal) for number, normal in enumerate(DIFFERENT)]

    # k_b = k0 + k1, k_a = k_b k0/k1, c_a = c1 (k_b/k1)^2
    def test_chain_and_parallel_form_of_one_rheology_are_equal(self):
        common = {"kt": 2e6, "kd": 1e6}
        parallel = self.contact("a.toml", "k0 | (k1 - c1)", common | {"k0": 3e6, "k1": 1e6, "c1": 7})
        chain = self.contact("b.toml", "kb - (ka | ca)", common | {"kb": 4e6, "ka": 12e6, "ca": 112})
        self.assertIn("one canonical form", self.derive(parallel, "--equal", chain))
        other = self.answer("derive", parallel, "--equal", chain)
        self.assertEqual(other, {"equal": True, "scope": "values", "evidence": "canonical form", "chance_of_error": 0.0})

    def test_different_scenes_end_with_1_and_a_point_that_shows_it(self):
        first, second = self.different()
        found = self.answer("derive", first, "--equal", second, status=1)
        self.assertFalse(found["equal"])
        point = found["counterexample"]
        for file, key in ((first, "first"), (second, "second")):
            value = self.answer("eval", file, *settings(point["values"] | {"u_z0": 1}))
            self.assertAlmostEqual(value["critical_velocity"] / point[key], 1, delta=1e-12)
        self.assertNotEqual(point["first"], point["second"])

    def test_a_wrong_other_scene_is_the_input_that_is_wrong(self):
        self.refused(2, ["derive", self.contact("a.toml", "k0"), "--equal", "none.toml"], "none.toml")

    def test_the_fingerprint_is_that_of_the_function(self):
        fingerprints = [self.answer("derive", self.contact("a.toml", normal))["fingerprint"]
                        for normal in ("k0 | (k1 - c1)", "(c1 - k1) | k0", "k1 | (k0 - c1)")]
        self.assertRegex(fingerprints[0], "^[0-9a-f]{32}$")
        self.assertEqual(fingerprints[0], fingerprints[1])
        self.assertNotEqual(fingerprints[0], fingerprints[2])

    def test_an_article_and_a_page_are_whole(self):
        file = self.contact("a.toml", "k0 | (k1 - c1)")
        part = self.derive(file, "--format", "latex")
        article = self.derive(file, "--format", "latex", "--standalone")
        self.assertTrue(article.startswith("\\documentclass[a4paper]{article}\n"))
        self.assertTrue(article.endswith("\n\\end{document}\n"))
        self.assertIn(part.strip(), article)
        page = self.derive(file, "--format", "html")
        self.assertTrue(page.startswith("<!DOCTYPE html>"))
        self.assertEqual(page, self.derive(file, "--format", "html", "--standalone"))
        # Nothing of it comes from elsewhere, and nothing runs.
        self.assertIsNone(re.search(r"<script|<link|\bsrc=|\bhref=|url\(", page))
        for words in (["text"], ["markdown"], ["json"]):
            self.refused(2, ["derive", file, "--standalone", "--format", *words], "standalone", "latex")

    def test_documents_say_what_symbols_mean(self):
        file = self.contact("a.toml", "prony(k0, k, tau, 6)")
        for kind in ("latex", "markdown", "html"):
            document = self.derive(file, "--format", kind)
            for part in ("Assumptions", "relaxation time of the normal contact", "N/m", "spring of the drive",
                         "10.24411/1683-805X-2018-12009"):
                self.assertIn(part, document, kind)

    def test_a_long_series_is_one_line(self):
        file = self.contact("a.toml", "prony(k0, k, tau, 8)")
        text = self.derive(file, "--sensitivities")
        for part in ("K_n = k0 + sum(k[j]*tau[j]*s/(1 + tau[j]*s), j = 1..8)", "T_j = omega*tau[j]  (j = 1..8)",
                     "    S_tau[j] = "):
            self.assertIn(part, text)
        self.assertNotIn("k[5]", text)

    def test_lines_of_a_terminal_fit(self):
        for scene in with_formula(PROGRAM):
            for line in self.derive(scene, "--limits", "--sensitivities").splitlines():
                self.assertLessEqual(len(line), 100, f"{scene.name}: {line}")

    def test_forms_stand_beside_the_derivation(self):
        file = self.contact("a.toml", "k0 | (k1 - c1)")
        for form in ("rational", "dimensionless"):
            lines = self.answer("derive", file, "--form", form)[form]
            self.assertEqual(set(lines[0]), {"words", "text", "latex"})
            for kind in ("text", "latex", "markdown"):
                self.assertGreater(len(self.derive(file, "--form", form, "--format", kind)),
                                   len(self.derive(file, "--format", kind)))
        lines = self.derive(file, "--form", "nested").splitlines()
        self.assertIn("abs(K_n)", [line for line in lines if line.startswith("    v* = ")][-1])

    def test_what_eval_is_said_to_simulate_it_simulates(self):
        # One rule for both: loss factors are beyond the simulator, measured drives are not.
        self.write("omega,Re,Im\n1,1e-8,-1e-9\n1e9,1e-8,-1e-9\n", "receptance.csv")
        contact = {"kn": 1e7, "cn": 20, "kt": 8e6, "ct": 10}
        for drive, elements, simulated in [
                ({"network": "kd"}, {"kd": 3e7}, True),
                ({"network": "kd | cd"}, {"kd": 3e7, "cd": 5}, True),
                ({"network": "kd - (mass(ms) | kd)"}, {"kd": 3e7, "ms": 1e-3}, True),
                ({"network": "kd | mass(ms)"}, {"kd": 3e7, "ms": 1e-3}, True),
                ({"network": "lossy(kd, eta)"}, {"kd": 3e7, "eta": 0.1}, False),
                ({"receptance": "receptance.csv"}, {}, True)]:
            with self.subTest(drive=drive):
                scene = self.scene(contact | elements, normal="kn | cn", tangential="kt | ct", separation=True, mass=1e-3,
                                   angular_frequency=1e5, amplitude=9e-7, indentation=5e-7, **drive)
                text = " ".join(self.derive(scene).split())
                evaluated = self.run_program("eval", scene)
                self.assertEqual(evaluated.returncode, 0 if simulated else 3, evaluated.stderr)
                self.assertEqual("which vcrit eval simulates" in text, simulated)
                self.assertEqual("there is no answer" in text, not simulated)
                separation = self.answer("derive", scene)["separation"]
                self.assertEqual("not_simulated" in separation, not simulated)
                if not simulated:
                    self.assertIn(separation["not_simulated"], evaluated.stderr)

    def test_ten_runs_give_the_same_bytes(self):
        first, second = self.different()
        for arguments, status, words in (
                (["--catalogue"], 0, "Standard linear solid"), ([first, "--equal", second], 1, ""),
                ([first, "--limits", "--sensitivities", "--form", "rational"], 0, "")):
            outputs = {self.derive(*arguments, status=status) for _ in range(10)}
            self.assertEqual(len(outputs), 1, arguments)
            self.assertIn(words, outputs.pop(), arguments)

    def test_what_is_beyond_the_budget_is_refused_with_its_size(self):
        file = self.contact("a.toml", "prony(k0, k, tau, 40)")
        # 2^40 + 40 2^39 terms of K_n, twice for K_t + K_d
        self.refused(3, ["derive", file, "--form", "rational"],
                     f"{2 * (2**40 + 40 * 2**39):.6g} terms, more than the budget of 5000")

    def test_a_rational_form_is_readable_or_refused_with_its_size(self):
        """In 4 s of processor time: the 10 s that a formula may take, on a machine that is busy or half as fast."""
        for name in ("rational_ladder5.toml", "rational_grid.toml"):
            result = self.run_program("derive", PROJECT / "tests/data/rational" / name, "--form", "rational",
                                      preexec_fn=within(4))
            if result.returncode == 3:
                self.assertRegex(result.stderr, r"v\*\^2 has \d+ terms, more than 30000: some [0-9.]+ MB of text")
            else:
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertLess(len(result.stdout), 10_000_000)
                self.assertIn("As a rational function of omega^2", result.stdout)

    def test_a_difference_that_no_double_shows_has_its_point(self):
        values = {"kt": 5, "kd": 7, "k0": 3, "k1": 2, "c1": 1}
        first = self.contact("a.toml", "k0 | (k1 - c1)", values)
        second = self.contact("b.toml", "k0 | (k1 - k2 - c1)", values | {"k2": 1e300})
        printed = self.derive(first, "--equal", second, status=1)
        found = re.search(r"^which differ by (\S+) of themselves$", printed, re.M)
        self.assertIsNotNone(found, printed)
        self.assertLess(float(found[1]), 1e-12)
        self.assertGreater(float(found[1]), 0)
        example = self.answer("derive", first, "--equal", second, status=1)["counterexample"]
        self.assertEqual(f"{example['relative_difference']:.2g}", found[1])

    def test_facts_are_mathematics_in_sentences(self):
        """No name of a symbol is left among the words, of facts of all kinds, with and without a line of their own."""
        springs = {"tangential": "kt", **SYMBOLS}
        bridge = (["a", "b"], [["k1", "a", "1"], ["k1", "a", "2"], ["c1", "1", "2"], ["k1", "1", "b"], ["k1", "2", "b"]])
        kinds = {"does not enter": [{}, {"bridge": bridge}, {"normal": "bridge", **springs}],
                 "is proportional to the frequency": [{"normal": "kn", "network": "kd", **springs}],
                 "is infinite where": [{"normal": "kn", "network": "kd", "mass": "m", **springs}],
                 "vanishes at the antiresonance": [{"normal": "kn", "network": "kd", "mass": "m", **springs}],
                 "Dampers keep": [{"normal": "kn", "network": "kd | cd", "mass": "m", **springs}],
                 "times": [{"normal": "prony(k0, k, tau, 90)", **springs}],
                 "stays closed while": [{"normal": "kn | cn", **springs}]}
        for words, (*parts, changed) in kinds.items():
            file = self.scene(*parts, **changed)
            for form, mathematics in (("latex", r"\$[^$]*\$"), ("html", r"<math>.*?</math>")):
                with self.subTest(words=words, form=form):
                    printed = self.derive(file, "--format", form)
                    sentence = re.search(rf"^.*{words}.*$", printed, re.M)
                    self.assertIsNotNone(sentence, printed[:2000])
                    plain = re.sub(mathematics, "", sentence[0])
                    self.assertNotRegex(plain, r"v\*|[_^|]|omega|\b(du|[kcKm]\d?n?)\b")
                    self.assertNotEqual(plain, sentence[0])

    def test_every_form_of_long_series_ends_soon_or_says_its_size(self):
        """At most 10 s of processor time and 10 MB; what is refused is so before it is made, with a count."""
        series = "prony(q0, q, s, 100)"
        for changed in ({"network": "kd", "mass": "m"}, {"network": "kd", "tangential": series}):
            file = self.scene(normal="prony(k0, k, tau, 100)", **SYMBOLS | changed)
            for form in ("shortest", "nested", "storage-loss", "rational", "dimensionless", "expanded"):
                with self.subTest(form=form, **changed):
                    result = self.run_program("derive", file, "--form", form, preexec_fn=within(10))
                    self.assertIn(result.returncode, (0, 3), result.stderr)
                    self.assertLess(len(result.stdout), 10_000_000)
                    if result.returncode == 3:
                        self.assertRegex(result.stderr, r"[\d.e+]+ terms")

    def test_every_format_and_option_of_the_largest_scenes_ends_soon_or_says_its_size(self):
        """At most 10 s of processor time and 10 MB, in each format with all that can be asked for."""
        node = lambda i, j: {(0, 0): "a", (5, 5): "b"}.get((i, j), f"{i}.{j}")
        pairs = [(node(i, j), node(i + a, j + b)) for i in range(6) for j in range(6)
                 for a, b in ((0, 1), (1, 0)) if i + a < 6 and j + b < 6]
        grid = {"grid": (["a", "b"], [[f"{'kc'[n % 2]}{n}", *pair] for n, pair in enumerate(pairs)])}
        drive = {"network": "kd | cd", "mass": "m"}
        measured = (PROJECT / "tests/matrix/kinds/measured_contact.toml").read_text()
        for table in ("pad.csv", "pad_tangential.csv"):
            self.write((PROJECT / "tests/matrix/kinds" / table).read_text(), table)
        for parts, changed in (([{}, grid], {"normal": "grid", "poisson": "nu", "tangential": None, **drive}),
                               ([], {"normal": "generalized_kelvin(k, tau, 48)", "tangential": "kt", "mass": "m",
                                     "network": "ladder(q, c, 20)"}),
                               ([], None)):
            file = self.write(measured) if changed is None else self.scene(*parts, **SYMBOLS | changed)
            asked = ["--limits", "--sensitivities"]
            words = [["--format", kind, *asked] for kind in ("text", "latex", "markdown", "html", "json")]
            words += [["--format", kind] for kind in ("sympy", "mathematica", "maple", "maxima", "mathml", "c")]
            for each in [*words, ["--format", "latex", "--standalone", "--limits"], ["--material"]]:
                with self.subTest(words=each, scene=changed or "measured contact"):
                    result = self.run_program("derive", file, *each, preexec_fn=within(10))
                    self.assertIn(result.returncode, (0, 3), result.stderr)
                    self.assertLess(len(result.stdout.encode()), 10_000_000)
                    if result.returncode == 3:
                        self.assertRegex(result.stderr, r"some [\d.e+]+ MB")

    def test_large_networks_derive(self):
        ladder = "k100"
        for i in range(99, 0, -1):
            ladder = f"k{i} - (c{i} | ({ladder}))"
        self.assertIn("v* = mu0", self.derive(self.contact("a.toml", ladder)))
        self.assertIn("v* = mu0", self.derive(self.contact("a.toml", "prony(k0, k, tau, 100)")))
        node = lambda i, j: {(0, 0): "a", (5, 5): "b"}.get((i, j), f"{i}.{j}")
        pairs = [(node(i, j), node(i + a, j + b)) for i in range(6) for j in range(6)
                 for a, b in ((0, 1), (1, 0)) if i + a < 6 and j + b < 6]
        edges = [[f"{'kc'[n % 2]}{n}", *pair] for n, pair in enumerate(pairs)]
        self.assertIn("v* = mu0", self.derive(self.contact("a.toml", "grid", {}, {"grid": (["a", "b"], edges)})))


if __name__ == "__main__":
    unittest.main()
