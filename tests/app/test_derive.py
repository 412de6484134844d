"""`vcrit derive` as a user meets it: forms, equality, large networks."""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv.pop(1)


def run(*arguments, folder):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, timeout=120)


class Derive(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def scene(self, name, normal, elements="", before=""):
        text = f'{before}[contact]\nnormal = "{normal}"\ntangential = "kt"\n'
        text += '[drive]\nnetwork = "kd"\n[elements]\n' + elements
        (self.folder / name).write_text(text)
        return name

    def derive(self, *arguments, status=0):
        result = run("derive", *arguments, folder=self.folder)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    # k_b = k0 + k1, k_a = k_b k0/k1, c_a = c1 (k_b/k1)^2
    def test_chain_and_parallel_form_of_one_rheology_are_equal(self):
        common = "kt = 2e6\nkd = 1e6\n"
        parallel = self.scene("a.toml", "k0 | (k1 - c1)", common + "k0 = 3e6\nk1 = 1e6\nc1 = 7\n")
        chain = self.scene("b.toml", "kb - (ka | ca)", common + "kb = 4e6\nka = 12e6\nca = 112\n")
        self.assertIn("one canonical form", self.derive(parallel, "--equal", chain).stdout)
        other = json.loads(self.derive(parallel, "--equal", chain, "--json").stdout)
        self.assertEqual(other, {"equal": True, "scope": "values", "evidence": "canonical form", "chance_of_error": 0.0})

    def test_different_scenes_end_with_1_and_a_point_that_shows_it(self):
        first, second = self.scene("a.toml", "k0 | (k1 - c1)"), self.scene("b.toml", "k1 | (k0 - c1)")
        found = json.loads(self.derive(first, "--equal", second, "--json", status=1).stdout)
        self.assertFalse(found["equal"])
        settings = [word for name, value in {**found["counterexample"]["values"], "u_z0": 1}.items()
                    for word in ("--set", f"{name}={value!r}")]
        for file, key in ((first, "first"), (second, "second")):
            value = json.loads(run("eval", file, *settings, "--json", folder=self.folder).stdout)
            expected = found["counterexample"][key]
            self.assertAlmostEqual(value["critical_velocity"] / expected, 1, delta=1e-12)
        self.assertNotEqual(found["counterexample"]["first"], found["counterexample"]["second"])

    def test_a_wrong_other_scene_is_the_input_that_is_wrong(self):
        file = self.scene("a.toml", "k0")
        self.assertIn("none.toml", self.derive(file, "--equal", "none.toml", status=2).stderr)

    def test_the_fingerprint_is_that_of_the_function(self):
        fingerprints = [json.loads(self.derive(self.scene("a.toml", normal), "--json").stdout)["fingerprint"]
                        for normal in ("k0 | (k1 - c1)", "(c1 - k1) | k0", "k1 | (k0 - c1)")]
        self.assertRegex(fingerprints[0], "^[0-9a-f]{32}$")
        self.assertEqual(fingerprints[0], fingerprints[1])
        self.assertNotEqual(fingerprints[0], fingerprints[2])

    def test_forms_stand_beside_the_derivation(self):
        file = self.scene("a.toml", "k0 | (k1 - c1)")
        for form in ("rational", "dimensionless"):
            lines = json.loads(self.derive(file, "--form", form, "--json").stdout)[form]
            self.assertEqual(set(lines[0]), {"words", "text", "latex"})
            for kind in ("text", "latex", "markdown"):
                self.assertGreater(len(self.derive(file, "--form", form, "--format", kind).stdout),
                                   len(self.derive(file, "--format", kind).stdout))
        self.assertIn("abs(K_n)", self.derive(file, "--form", "nested").stdout.splitlines()[-1])

    def test_what_eval_is_said_to_simulate_it_simulates(self):
        # One rule for both: masses in the drive, loss factors and measured drives are beyond the simulator.
        (self.folder / "receptance.csv").write_text("omega,Re,Im\n1,1e-8,-1e-9\n1e9,1e-8,-1e-9\n")
        drives = {'network = "kd"\n': True, 'network = "kd | cd"\n': True, 'network = "kd - (mass(ms) | kd)"\n': False,
                  'network = "kd | mass(ms)"\n': False, 'network = "lossy(kd, eta)"\n': False,
                  'receptance = "receptance.csv"\n': False}
        for drive, simulated in drives.items():
            with self.subTest(drive=drive):
                scene = self.folder / "part.toml"
                scene.write_text('[contact]\nnormal = "kn | cn"\ntangential = "kt | ct"\nseparation = true\n'
                                 f"[drive]\n{drive}[body]\nmass = 1e-3\n"
                                 "[oscillation]\nangular_frequency = 1e5\namplitude = 9e-7\nindentation = 5e-7\n"
                                 "[friction]\ncoefficient = 0.3\n"
                                 "[elements]\nkn = 1e7\ncn = 20\nkt = 8e6\nct = 10\n"
                                 + ("" if "receptance" in drive else "kd = 3e7\n")
                                 + ("cd = 5\n" if "cd" in drive else "") + ("ms = 1e-3\n" if "ms" in drive else "")
                                 + ("eta = 0.1\n" if "eta" in drive else ""))
                text = " ".join(self.derive(scene).stdout.split())
                evaluated = subprocess.run([PROGRAM, "eval", scene], capture_output=True, text=True)
                self.assertEqual(evaluated.returncode, 0 if simulated else 3, evaluated.stderr)
                self.assertEqual("which vcrit eval simulates" in text, simulated)
                self.assertEqual("there is no answer" in text, not simulated)
                separation = json.loads(self.derive(scene, "--json").stdout)["separation"]
                self.assertEqual("not_simulated" in separation, not simulated)
                if not simulated:
                    self.assertIn(separation["not_simulated"], evaluated.stderr)

    def test_ten_runs_give_the_same_bytes(self):
        first, second = self.scene("a.toml", "k0 | (k1 - c1)"), self.scene("b.toml", "k1 | (k0 - c1)")
        for arguments, status in ((["--catalogue"], 0), ([first, "--equal", second], 1),
                                  ([first, "--limits", "--sensitivities", "--form", "rational"], 0)):
            outputs = {self.derive(*arguments, status=status).stdout for _ in range(10)}
            self.assertEqual(len(outputs), 1, arguments)

    def test_what_is_beyond_the_budget_is_refused_with_its_size(self):
        file = self.scene("a.toml", "prony(k0, k, tau, 40)")
        result = self.derive(file, "--form", "rational", status=3)
        self.assertEqual(result.stdout, "")
        # 2^40 + 40 2^39 terms of K_n, twice for K_t + K_d
        self.assertIn(f"{2 * (2**40 + 40 * 2**39):.6g} terms, more than the budget of 5000", result.stderr)

    def test_a_rational_form_is_readable_or_refused_with_its_size(self):
        data = Path(__file__).parent.parent / "data" / "rational"
        for name in ("rational_ladder5.toml", "rational_grid.toml"):
            result = subprocess.run([PROGRAM, "derive", data / name, "--form", "rational"],
                                    capture_output=True, text=True, timeout=100)
            if result.returncode == 3:
                self.assertRegex(result.stderr, r"v\*\^2 has \d+ terms, more than 30000: some [0-9.]+ MB of text")
            else:
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertLess(len(result.stdout), 10_000_000)
                self.assertIn("As a rational function of omega^2", result.stdout)

    def test_a_difference_that_no_double_shows_has_its_point(self):
        values = "kt = 5\nkd = 7\nk0 = 3\nk1 = 2\nc1 = 1\n"
        first = self.scene("a.toml", "k0 | (k1 - c1)", values)
        second = self.scene("b.toml", "k0 | (k1 - k2 - c1)", values + "k2 = 1e300\n")
        result = self.derive(first, "--equal", second, status=1)
        found = re.search(r"^which differ by (\S+) of themselves$", result.stdout, re.M)
        self.assertIsNotNone(found, result.stdout)
        self.assertLess(float(found[1]), 1e-12)
        self.assertGreater(float(found[1]), 0)
        example = json.loads(self.derive(first, "--equal", second, "--json", status=1).stdout)["counterexample"]
        self.assertEqual(f"{example['relative_difference']:.2g}", found[1])

    def test_large_networks_derive(self):
        ladder = "k100"
        for i in range(99, 0, -1):
            ladder = f"k{i} - (c{i} | ({ladder}))"
        self.assertIn("v* = mu0", self.derive(self.scene("a.toml", ladder)).stdout)
        self.assertIn("v* = mu0", self.derive(self.scene("a.toml", "prony(k0, k, tau, 100)")).stdout)
        node = lambda i, j: {(0, 0): "a", (5, 5): "b"}.get((i, j), f"{i}.{j}")
        pairs = [(node(i, j), node(i + a, j + b)) for i in range(6) for j in range(6)
                 for a, b in ((0, 1), (1, 0)) if i + a < 6 and j + b < 6]
        edges = [[f"{'kc'[n % 2]}{n}", *pair] for n, pair in enumerate(pairs)]
        grid = f'[networks.grid]\nterminals = ["a", "b"]\nedges = {json.dumps(edges)}\n'
        self.assertIn("v* = mu0", self.derive(self.scene("a.toml", "grid", before=grid)).stdout)


if __name__ == "__main__":
    unittest.main()
