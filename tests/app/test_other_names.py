"""Scenes that call quantities and elements by names of their own, through every command and language.

Each scene is held against one that is the same but for its names, which has the canonical ones: the numbers are the
same, to the bit where nothing is rounded on the way, and everything that is printed has the scene's names.
"""
import cmath
import contextlib
import json
import re
import subprocess
import unittest

import drivers
import program

# What can be called otherwise, in the order of the scene below: canonical name and value.
VALUES = {"nu": 0.3, "m": 1e-3, "omega": 6e4, "du_z": 1e-7, "u_z0": 1e-6, "mu0": 0.3,
          "k0": 7e6, "k1": 3e6, "c1": 20.0, "kd": 5e6}
KEYS = {"nu": "poisson", "m": "mass", "omega": "angular_frequency", "du_z": "amplitude", "u_z0": "indentation",
        "mu0": "coefficient", "k0": "k0", "k1": "k1", "c1": "c1", "kd": "kd"}

# Names as people choose them; each other's, in a circle; the keys themselves; those that derivations use.
OTHERS = [
    {"nu": "poisson", "m": "M", "omega": "w", "du_z": "a", "u_z0": "depth", "mu0": "mu", "k0": "E", "k1": "e1",
     "c1": "eta", "kd": "k_spring"},
    {"nu": "m", "m": "mu0", "omega": "du_z", "du_z": "omega", "u_z0": "nu", "mu0": "u_z0"},
    {"m": "k2", "k0": "m", "k1": "omega", "c1": "mu0", "kd": "du_z", "omega": "c2", "mu0": "k3", "du_z": "k4"},
    {"nu": "poisson", "m": "mass", "omega": "angular_frequency", "du_z": "amplitude", "u_z0": "indentation",
     "mu0": "coefficient"},
    {"nu": "K_n", "m": "s", "omega": "i", "du_z": "x", "u_z0": "t", "mu0": "K_d", "k0": "A", "k1": "p", "c1": "T",
     "kd": "abs"},
    # Words of Rust that C++ does not reserve.
    {"nu": "fn", "m": "self", "omega": "type", "du_z": "mod", "u_z0": "loop", "mu0": "Self", "k0": "impl", "k1": "crate",
     "c1": "match", "kd": "self_"},
    {"m": "beta_kd", "k0": "S_k1", "k1": "v", "c1": "kappa_k1", "kd": "out", "omega": "n", "mu0": "theta_c1"},
]


def without_facts(printed):
    """Of eval, whose sentences have the scene's names."""
    return {key: value for key, value in json.loads(printed).items() if key != "facts"}


def scene(names):
    given = {key: names.get(key, key) for key in VALUES}
    return program.scene({key: given[key] for key in ("k0", "k1", "c1", "kd")}, normal="k0 | (k1 - c1)", network="kd",
                         **{KEYS[key]: given[key] for key in ("nu", "m", "omega", "du_z", "u_z0", "mu0")})


def settings(names, but=()):
    return program.settings({names.get(key, key): value for key, value in VALUES.items() if key not in but})


class OtherNames(program.Case):
    def setUp(self):
        super().setUp()
        self.file = self.write(scene({}))
        self.canonical = self.write(scene({}), "canonical.toml")

    def run_on(self, command, *rest, file=None):
        printed = self.out(command, file or self.file, *rest)
        self.assertNotRegex(printed, r"\w~")
        return printed

    def wrong(self, text, command, *rest, found):
        self.write(text)
        self.refused(2, [command, self.file, *rest], found)

    @contextlib.contextmanager
    def named(self, names):
        self.write(scene(names))
        with self.subTest(scene=OTHERS.index(names)):
            yield

    def value(self):
        return self.answer("eval", self.canonical, *settings({}))["critical_velocity"]

    def test_formulas_are_printed_in_the_scenes_names(self):
        expected = self.value()
        for names in OTHERS:
            with self.named(names):
                for form in ("shortest", "expanded", "nested"):
                    text = program.unbroken(self.run_on("derive", "--form", form).rpartition("\nDerivation:")[2])
                    s, i, omega = re.search(r"with (\w+) = (\w+)\*(\w+)", text).groups()
                    self.assertEqual(omega, names.get("omega", "omega"))
                    known = {names.get(key, key): value for key, value in VALUES.items()}
                    self.assertNotIn(s, known)
                    self.assertNotIn(i, known)
                    known |= {i: 1j, s: VALUES["omega"] * 1j}
                    result = None
                    before, after = text.split("Normal contact", 1)
                    # Parts that got a name where the networks were still unknown; those of other formulas remain so.
                    parts = re.findall(r"^    (U_\d+) = (.+)$", before, re.M)
                    brought = program.names_in_words(text)  # the result may say them again
                    lines = re.findall(r"^    (\S+) = (.+)$", after, re.M)
                    networks = next(n for n, (left, _) in enumerate(lines) if left == "v*")
                    for left, right in brought + lines[:networks] + parts + [line for line in lines[networks:] if line not in brought]:
                        formula = re.sub(r"\b(abs|sqrt)\(", r"\1_of(", right.replace("^", "**"))
                        try:
                            value = eval(formula, {"__builtins__": {}}, dict(known, abs_of=abs, sqrt_of=cmath.sqrt))
                        except NameError:
                            self.assertTrue(left.startswith("U_"), text)
                            continue
                        if left == "v*":
                            result = abs(value)
                        else:
                            self.assertNotIn(left, known, text)
                            known[left] = value
                    # Some 40 operations in doubles, none of which cancels.
                    self.assertAlmostEqual(result / expected, 1, delta=1e-13)

    def test_documents_name_what_varies(self):
        own = json.loads(self.run_on("derive", "--format", "json", "--sensitivities", file=self.canonical))
        for names in OTHERS:
            with self.named(names):
                found = json.loads(self.run_on("derive", "--format", "json", "--sensitivities"))
                self.assertEqual(found["parameters"], [names.get(key, key) for key in own["parameters"]])
                self.assertEqual([each["parameter"] for each in found["sensitivities"]],
                                 [names.get(each["parameter"], each["parameter"]) for each in own["sensitivities"]])
                # What is one formula has one fingerprint, but that a ratio has no name but the scene's.
                if "nu" not in names and not {"k0", "k1", "c1", "kd"} & set(names):
                    self.assertEqual(found["fingerprint"], own["fingerprint"])
                for options in (["--format", "latex"], ["--format", "markdown"], ["--form", "rational"],
                                ["--form", "dimensionless"], ["--limits"]):
                    self.assertNotRegex(self.run_on("derive", *options), r"[\x00-\x08\x0b-\x1f]")

    def test_scenes_that_differ_in_names_of_quantities_are_equal(self):
        for names in ({"m": "M", "mu0": "mu"}, OTHERS[1], OTHERS[3]):
            self.write(scene(names))
            self.assertIn("equal: ", self.run_on("derive", "--equal", str(self.canonical)))

    def test_numbers_by_the_scenes_names(self):
        reference = {command[0]: self.run_on(*command, "--json", *settings({}), file=self.canonical)
                     for command in (["eval"], ["critical"], ["simulate", "--velocity-ratio", "0.5"])}
        for names in OTHERS:
            with self.named(names):
                for command in (["eval"], ["critical"], ["simulate", "--velocity-ratio", "0.5"]):
                    found = self.run_on(*command, "--json", *settings(names))
                    self.assertEqual(without_facts(found), without_facts(reference[command[0]]))
                # The keys of the file stand for the same.
                by_keys = [f"{KEYS[key]}={value!r}" for key, value in VALUES.items()]
                found = self.run_on("eval", "--json", *(p for each in by_keys for p in ("--set", each)))
                self.assertEqual(without_facts(found), without_facts(reference["eval"]))

    def test_what_is_missing_is_called_by_its_name(self):
        for names in OTHERS:
            with self.named(names):
                message = self.refused(2, ["eval", self.file])
                listed = [re.sub(r" \(\w+\)$", "", name)  # their keys
                          for name in re.search(r"no value for (.*); expected", message).group(1).split(", ")]
                self.assertEqual(sorted(listed), sorted(names.get(key, key) for key in VALUES))

    def test_solve(self):
        question = ["--for", "amplitude", "--friction-ratio", "0.99", "--velocity", "1e-3", "--samples", "20", "--json"]
        expected = json.loads(self.run_on("solve", *question, *settings({}, but=["du_z"]), file=self.canonical))
        for names in OTHERS:
            with self.named(names):
                found = json.loads(self.run_on("solve", *question, *settings(names, but=["du_z"])))
                self.assertEqual(found, expected)
                told = self.run_program("solve", self.file, *question, *settings(names))
                self.assertEqual(told.returncode, 2)
                self.assertIn("no value for what is sought", told.stderr)

    def swept(self, names, file):
        name = {key: names.get(key, key) for key in VALUES}
        rows = self.table(file, "--over", f"{name['k1']}=lin:1e6:4e6:3", "--over", f"{name['omega']}=log:1e4:1e5:3",
                          "--quantity", "critical_velocity", f"sensitivity:{name['m']}", f"sensitivity:{name['c1']}",
                          *settings(names, but=["k1", "omega"]))
        return [list(rows[0]), *(list(row.values()) for row in rows)]

    def test_sweep(self):
        header, *rows = self.swept({}, self.canonical)
        self.assertEqual(len(rows), 9)
        self.assertEqual(header, ["k1", "omega", "critical_velocity", "sensitivity_m", "sensitivity_c1"])
        for names in OTHERS:
            with self.named(names):
                found, *numbers = self.swept(names, self.file)
                self.assertEqual(found, [names.get("k1", "k1"), names.get("omega", "omega"), "critical_velocity",
                                         "sensitivity_" + names.get("m", "m"), "sensitivity_" + names.get("c1", "c1")])
                self.assertEqual(numbers, rows)

    def generate(self, name, *options):
        self.run_on("generate", "--out", self.folder, "--name", name, *options)

    def check_own_tests(self, libraries):
        """Compiled together, with the headers of quantities."""
        headers = "".join(f'#include "{name}_batch.hpp"\n#include "{name}_quantities.hpp"\n' for name in libraries)
        tests = "".join(f'#define main main_of_{name}\n#include "test_{name}.cpp"\n#undef main\n' for name in libraries)
        calls = "".join(f'  if (main_of_{name}() == 0) std::puts("{name}");\n' for name in libraries)
        self.write(f"#include <cstdio>\n{headers}{tests}int main() {{\n{calls}}}\n", "tests.cpp")
        drivers.ran(["g++", "-std=c++20", "-O0", "-o", "a", "tests.cpp"], self.folder)
        self.assertEqual(drivers.ran(["./a"], self.folder).split(), libraries)

    def test_generated_code(self):
        expected = self.value()
        libraries, rows = [], []
        for number, names in enumerate(OTHERS):
            self.write(scene(names))
            given = {names.get(key, key): value for key, value in VALUES.items() if key != "u_z0"}
            for language in drivers.LANGUAGES:
                self.generate(f"g{number}", "--language", language)
            self.generate(f"g{number}", "--quantities")
            layout = drivers.members((self.folder / f"g{number}.hpp").read_text())
            self.assertEqual({name for name, _ in layout}, set(given))
            libraries.append((f"g{number}", layout))
            rows.append((number, [given[name] for name, _ in layout]))
        self.check_own_tests([name for name, _ in libraries])
        for language in drivers.LANGUAGES:
            for number, answer in enumerate(drivers.answers(language, self.folder, libraries, rows)):
                with self.subTest(scene=number, language=language):
                    value, bound, fast, fast_bound, again, fast_again, batch, fast_batch = answer
                    for found in (value, fast, again, fast_again, batch, fast_batch):
                        self.assertAlmostEqual(found / expected, 1, delta=1e-14)

    def test_a_library_of_a_long_name_compiles_without_warnings(self):
        # Where a call with the name in it was long, C99 declared what edges of value 0 alone have a use for.
        bridge, name = program.example("bridge"), "bridge_of_springs_and_dampers"
        self.out("generate", bridge, "--out", ".", "--name", name)
        layout = drivers.members((self.folder / f"{name}.hpp").read_text())
        values = {"mu0": 0.2, "omega": 2.5e5, "du_z": 6e-8, "m": 3e-4, "k1": 2e7, "k2": 3e7, "k3": 2.5e7, "kd": 5e6,
                  "c1": 12, "c2": 18, "cd": 2}
        expected = json.loads(self.out("eval", bridge, "--json", "--set", "angular_frequency=2.5e5"))
        row = [values[member] for member, _ in layout]
        for language in ("c99", "cuda", "rust"):
            self.out("generate", bridge, "--out", ".", "--name", name, "--language", language)
            (value, *_), = drivers.answers(language, self.folder, [(name, layout)], [(0, row)])
            self.assertAlmostEqual(value / expected["critical_velocity"], 1, delta=1e-14)

    def test_fixed_by_its_name(self):
        self.write(scene({"m": "M", "k1": "E"}))
        self.generate("f", "--fix", "M,E", "--set", "M=0.001", "--set", "E=3e6")
        members = re.search(r"struct Parameters \{(.*?)\};", (self.folder / "f.hpp").read_text(), re.S).group(1)
        self.assertEqual(re.findall(r"(\w+)[,;]", members), ["mu0", "omega", "du_z", "nu", "k0", "c1", "kd"])

    def test_a_frequency_by_its_name(self):
        text = scene({}).replace('angular_frequency = "omega"', 'frequency = "f"')
        self.write(text)
        self.assertIn("    omega = 2*pi*f\n", self.run_on("derive"))
        found = self.run_on("eval", "--json", *settings({}, but=["omega"]), "--set", "f=9549.296585513721")
        self.assertAlmostEqual(json.loads(found)["critical_velocity"] / self.value(), 1, delta=1e-14)
        self.assertRegex(self.refused(2, ["eval", self.file]), r"no value for .*\bf\b")

    def test_elements_of_one_name_are_one(self):
        # k1 is k0: as if the networks were written so, whether k0 has a value or not.
        for value in ('"k0"', "7e6"):
            self.write(scene({"k1": "k0"}).replace('k0 = "k0"', f"k0 = {value}"))
            same = self.write(scene({}).replace("k1 - c1", "k0 - c1").replace('k1 = "k1"\n', "")
                              .replace('k0 = "k0"', f"k0 = {value}"), "same.toml")
            self.assertEqual(self.run_on("derive"), self.run_on("derive", file=same))
            both = settings({}, but=["k1"])
            self.assertEqual(self.run_on("eval", *both), self.run_on("eval", *both, file=same))
        self.wrong(scene({"k1": "k0"}), "eval", "--set", "k1=3e6", found='"k0", which sets them all')
        # Names are followed, through elements that no network has as well.
        self.write(scene({"k1": "k8"}) + 'k8 = "k9"\nk9 = 3e6\n')
        self.assertEqual(json.loads(self.run_on("eval", "--json", *settings({}, but=["k1"])))["critical_velocity"],
                         self.value())

    def test_entries_of_arrays(self):
        prony = scene({}).replace("k0 | (k1 - c1)", "prony(k0, k, tau)").replace('k1 = "k1"\nc1 = "c1"\n', "")
        self.write(prony + 'k = ["E", "k0"]\ntau = ["t1", 2e-5]\n')
        self.canonical.write_text(prony + "k = [3e6, 7e6]\ntau = [1e-5, 2e-5]\n")
        given = settings({}, but=["k1", "c1"])
        own = ["--set", "E=3e6", "--set", "t1=1e-5"]
        expected = json.loads(self.run_on("eval", "--json", *given, file=self.canonical))["critical_velocity"]
        found = self.run_on("eval", "--json", *given, *own)
        self.assertEqual(json.loads(found)["critical_velocity"], expected)
        self.assertIn("E*t1*s/(1 + t1*s)", self.run_on("derive", "--form", "nested"))
        self.generate("array", "--quantities")
        subprocess.run(["g++", "-std=c++20", "-O0", "-o", "a", "test_array.cpp"], cwd=self.folder, check=True)
        subprocess.run(["./a"], cwd=self.folder, check=True)
        # An array by another's name.
        self.write(prony + 'k = "E"\nE = [3e6, 7e6]\ntau = [1e-5, 2e-5]\n')
        self.assertEqual(json.loads(self.run_on("eval", "--json", *given))["critical_velocity"], expected)
        self.assertIn("E[2]", self.run_on("derive", "--form", "nested"))

    def test_what_makes_no_sense_is_refused(self):
        for names, found in (({"m": "mu0"}, "another name: coefficient is called so"),
                             ({"du_z": "a", "u_z0": "a"}, "is called so"),
                             ({"m": "k0"}, '"k0" as an element'),
                             ({"k1": "mu0"}, '"mu0" as an element'),
                             ({"k1": "c1"}, "as at"),
                             ({"k0": "k1", "k1": "k0"}, "names in a circle"),
                             ({"m": "frequency"}, '"frequency" as a symbol'),
                             ({"m": "velocity"}, '"velocity" as a symbol'),
                             ({"k1": "amplitude"}, '"amplitude" as an element'),
                             ({"mu0": "double"}, "reserved word"),
                             ({"k1": "template"}, "reserved word"),
                             ({"m": "MASS"}, "capitals")):
            with self.subTest(names=names):
                self.wrong(scene(names), "derive", found=found)
        self.wrong(scene({"m": "M"}), "eval", "--set", "mass=1", "--set", "M=2", found="one of the two")
        self.wrong(scene({"m": "M"}), "eval", "--set", "m=1", found='"m", which this scene does not have')
        self.wrong(scene({}).replace('angular_frequency = "omega"', 'frequency = "omega"'), "derive",
                     found="angular_frequency is called so")
        self.wrong(scene({"k1": "pad"}) + '[networks]\npad = "k7"\n', "derive", found="as a network and as an element")


if __name__ == "__main__":
    unittest.main()
