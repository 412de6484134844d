"""Formulas taken to other systems (derive --format): 200 of them in all systems, against v* as `vcrit eval` has it.

SymPy, Maxima and a C compiler evaluate what is for them; Mathematica, Maple and MathML are read by their grammar
(tests/support/systems.py), and so are the others. Scenes are those of tests/data/hand_forms.csv and random ones, in
turn in each form, with values of 8 bits, so that the formula's exact numbers are those of the evaluation.
"""

import builtins
import json
import keyword
import re
import subprocess
import sys
import tempfile
import unittest

import mpmath as mp
import sympy

import systems
from program import Case, rows, run, scene
from rounded import Rounded

PRINT_DOCUMENTS = sys.argv.pop(1)
mp.mp.dps = 40
# v* is rounded correctly, once; what is computed in 40 digits has none to add.
ROUNDED = 2.0**-53 * 1.001
FORMATS = ("sympy", "mathematica", "maple", "maxima", "mathml", "c")


def exported():
    """Every other row of the table; the program adds 92 random scenes."""
    scenes = [row["scene"].replace("poisson = 0.3", "poisson = 0.3125") for row in rows("hand_forms.csv", 216)[::2]]
    done = subprocess.run([PRINT_DOCUMENTS, "exported"], input="".join(scene + "\0" for scene in scenes),
                          capture_output=True, text=True, check=True, timeout=300)
    return [json.loads(line) for line in done.stdout.splitlines()]


def sympy_value(text, values):
    """In 40 digits, by SymPy."""
    file = {}
    exec(text, file)
    v_star = file["v_star"]
    parameters = systems.read("sympy", text).parameters
    given = {file[name]: values[scene] for scene, name in parameters.items()}
    if v_star.atoms(sympy.Float) or not v_star.free_symbols <= set(given):
        raise AssertionError(f"{v_star} has more than exact numbers and {list(given)}")
    return mp.mpf(v_star.evalf(mp.mp.dps, subs=given))


def fraction(value):
    """The exact value in Maxima."""
    real, imaginary = ("{}/{}".format(*float(part).as_integer_ratio()) for part in (mp.re(value), mp.im(value)))
    return f"{real} + %i*{imaginary}"


def maxima_values(cases):
    """v* of each (text, values), from one process, in 40 digits."""
    lines = ["fpprec: 40$"]
    for i, (text, values) in enumerate(cases):
        parameters = systems.read("maxima", text).parameters
        given = ", ".join(f"{name} = {fraction(values[scene])}" for scene, name in parameters.items())
        lines += [text, f'print("RESULT", {i}, string(bfloat(ev(v_star, {given}, nouns))))$', "kill(all)$ fpprec: 40$"]
    with tempfile.NamedTemporaryFile("w", suffix=".mac") as file:
        file.write("\n".join(lines))
        file.flush()
        done = subprocess.run(["maxima", "--very-quiet", "-b", file.name], capture_output=True, text=True, timeout=300)
    found = re.findall(r"^RESULT (\d+) (\S+)", done.stdout, re.M)
    if [int(i) for i, _ in found] != list(range(len(cases))):
        raise AssertionError(f"{len(found)} results of {len(cases)}: {done.stdout[-3000:]}")
    return [mp.mpf(value.replace("b", "e")) for _, value in found]


def c_call(i, text, values):
    given = []
    for scene in systems.read("c", text).parameters:
        real, imaginary = (float(part).hex() for part in (mp.re(values[scene]), mp.im(values[scene])))
        given.append(real if mp.im(values[scene]) == 0 else f"{real} + {imaginary}*I")
    return f'  printf("%a\\n", v_star_{i}({", ".join(given)}));\n'


def c_values(cases, folder):
    """v* of each (text, values), from one program."""
    source = "".join(text.replace("double v_star(", f"double v_star_{i}(") for i, (text, _) in enumerate(cases))
    calls = "".join(c_call(i, *case) for i, case in enumerate(cases))
    (folder / "all.c").write_text(f"{source}#include <complex.h>\n#include <stdio.h>\nint main(void) {{\n{calls}  return 0;\n}}\n")
    subprocess.run(["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-ffp-contract=off", "all.c", "-lm",
                    "-o", "all"], cwd=folder, check=True)
    done = subprocess.run([folder / "all"], capture_output=True, text=True, check=True)
    return [float.fromhex(line) for line in done.stdout.split()]


def c_bound(text, values):
    """Of the relative error of what is computed in doubles."""
    found = systems.read("c", text).value({name: Rounded(value, 0) for name, value in values.items()})
    return float(found.error / abs(found.value))


class Evaluated(Case):
    """Cases: (texts by format, values, v*)."""

    def near(self, value, expected, relative, words):
        self.assertLessEqual(abs(value - expected), relative * abs(expected), f"{value} for {expected}: {words[-2000:]}")

    def check_by_grammar(self, cases):
        for texts, values, expected in cases:
            for each, text in texts.items():
                self.near(systems.read(each, text).value(values), expected, ROUNDED, f"{each}: {text}")

    def check_by_systems(self, cases):
        self.check_in_sympy(cases)
        self.check_in_maxima(cases)
        self.check_in_c(cases)

    def check_in_sympy(self, cases):
        for texts, values, expected in cases:
            self.near(sympy_value(texts["sympy"], values), expected, ROUNDED, texts["sympy"])

    def check_in_maxima(self, cases):
        found = maxima_values([(texts["maxima"], values) for texts, values, _ in cases])
        for (texts, values, expected), value in zip(cases, found):
            self.near(value, expected, ROUNDED, texts["maxima"])

    def check_in_c(self, cases):
        found = c_values([(texts["c"], values) for texts, values, _ in cases], self.folder)
        for (texts, values, expected), value in zip(cases, found):
            self.near(value, expected, ROUNDED + c_bound(texts["c"], values), texts["c"])


class Formulas(Evaluated):
    def test_have_the_value_of_v_star(self):
        cases = [(case["texts"], {name: mp.mpf(value) for name, value in case["values"].items()}, mp.mpf(case["velocity"]))
                 for case in exported()]
        self.assertEqual(len(cases), 200)
        self.assertGreater(sum("complex.h" in texts["c"] for texts, _, _ in cases), 20)
        self.check_by_grammar(cases)
        self.check_by_systems(cases)


# What would end a comment, or go on with it, or means something to XML or a terminal.
TITLE = "*/ x *) (* /* -- --> ]]> ?""?/ \\ \n # <b> & &amp; \" ' $ ; \u202e \u001b \u2028 \uffff"


class Names(Evaluated):
    def springs(self, names):
        """A scene of springs of these names, as far as a scene takes them; and the values of its symbols."""
        names, usual = list(names), {"kt": 1.5, "mu0": 0.375, "omega": 2.5, "du_z": 0.125}
        while True:
            values = {name: 1 + i / 64 for i, name in enumerate(names)}
            text = scene(values | {"kt": 1.5}, normal=" | ".join(f"spring({name})" for name in names), tangential="kt",
                         coefficient=0.375, angular_frequency=2.5, amplitude=0.125)
            file = self.write(f"title = {json.dumps(TITLE)}\n{text}", f"{names[0]}.toml")
            done = run("eval", file)
            if done.returncode == 0:
                return file, {name: mp.mpf(value) for name, value in (values | usual).items()}
            refused = re.search(r'"(\w+)"', done.stderr)[1]
            names.remove(refused)

    def cases_of(self, each, words, least):
        """Formulas of scenes whose springs are called by all these words, and by what the files define."""
        legal = sorted({word for word in words if re.fullmatch("[A-Za-z][A-Za-z0-9_]*", word)}
                       | {"v_star", "vStar", "magnitude"})
        scenes = [self.springs(legal[i:i + 100]) for i in range(0, len(legal), 100)]
        self.assertGreater(sum(len(values) for _, values in scenes), least)
        cases = [({each: self.out("derive", file, "--format", each)}, values,
                  mp.mpf(self.answer("eval", file)["critical_velocity"])) for file, values in scenes]
        self.check_by_grammar(cases)
        for texts, _, _ in cases:
            self.assertEqual(set(systems.read(each, texts[each]).parameters.values()) & set(words), set())
        return cases

    def test_of_sympy_are_changed(self):
        of_sympy = {}
        exec("from sympy import *", of_sympy)
        cases = self.cases_of("sympy", {*of_sympy, *dir(builtins), *keyword.kwlist}, 950)
        self.check_in_sympy(cases)
        # What SymPy prints of it reads back to symbols of the same names.
        for texts, _, _ in cases:
            file = {}
            exec(texts["sympy"], file)
            again = sympy.sympify(str(file["v_star"]))
            self.assertEqual({s.name for s in again.free_symbols}, {s.name for s in file["v_star"].free_symbols})

    def test_of_maxima_are_changed(self):
        """Its own list of symbols that have a value, another name, or a place in its grammar."""
        asked = ("(do-symbols (s :maxima) (let ((n (symbol-name s))) (when (and (> (length n) 1) (char= (char n 0) #\\$) "
                 "(or (boundp s) (get s 'nud) (get s 'led) (get s 'lbp) (get s 'assign) "
                 "(let ((a (get s 'alias))) (and a (char= (char (symbol-name a) 0) #\\$))))) "
                 '(format t "NAME ~a~%" (maybe-invert-string-case (subseq n 1))))))')
        printed = subprocess.run(["maxima", "--very-quiet", "--batch-string", f":lisp {asked}\n"], capture_output=True,
                                 text=True, timeout=60).stdout
        self.check_in_maxima(self.cases_of("maxima", re.findall(r"^NAME (\S+)$", printed, re.M), 300))

    def test_of_c_are_changed(self):
        self.check_in_c(self.cases_of("c", systems.C, 50))

    def test_of_mathematica_and_maple_are_changed(self):
        self.cases_of("mathematica", systems.MATHEMATICA, 100)
        self.cases_of("maple", systems.MAPLE, 100)

    def test_that_read_alike_stay_apart(self):
        """In two scenes, as a rational form grows with the square of the number of springs."""
        springs = lambda *names: " | ".join(f"spring({name})" for name in names)
        letters = {"beta": 1.5, "beta_": 2.5, "beta_2": 3.25, "S": 2.25, "S_": 3.5, "E": 1.125, "e": 5.5, "s": 6.5}
        indices = {"k1": 4.5, "k_1": 1.25, "k_n": 2.75, "K_n": 1.75, "kn": 2.0625, "i": 3.75, "I": 1.0625}
        arrays = {"k": [7.5, 8.25], "tau": [0.5, 0.75]}
        usual = {"m": 1.375, "mu0": 0.375, "omega": 2.5, "du_z": 0.125}
        entries = {f"{name}[{j}]": value for name, values in arrays.items() for j, value in enumerate(values, 1)}
        cases = []
        for elements, given, parts in (
                (letters, letters, {"normal": springs("beta", "beta_", "beta_2", "S", "S_"),
                                    "tangential": "spring(e) | damper(s)", "network": "spring(E)"}),
                (indices | arrays, indices | entries, {"normal": "prony(k1, k, tau) | " + springs("k_1", "k_n", "K_n", "kn"),
                                                       "tangential": "spring(i)", "network": "damper(I)"})):
            scene = self.scene(elements, **parts, mass=1.375, coefficient=0.375, angular_frequency=2.5, amplitude=0.125)
            values = {name: mp.mpf(value) for name, value in (given | usual).items()}
            expected = mp.mpf(self.answer("eval", scene)["critical_velocity"])
            cases += [({each: self.out("derive", scene, "--format", each, "--form", form) for each in FORMATS}, values, expected)
                      for form in ("shortest", "storage-loss", "nested", "rational", "dimensionless", "expanded")]
        self.check_by_grammar(cases)
        self.check_by_systems(cases)

    def test_of_a_measured_drive_and_of_quantities(self):
        table = self.write("omega,Re,Im\n1,1,-0.5\n2.5,0.5,-0.25\n4,0.25,-0.125\n", "drive.csv")
        scene = self.scene(normal="lossy(k, zeta) | damper(gamma)", tangential="kt", receptance=table.name, mass="Q",
                           angular_frequency="pi", amplitude="N", indentation=None, coefficient="E")
        values = {"k": 1.5, "zeta": 0.25, "gamma": 0.75, "kt": 2.25, "Q": 0.375, "pi": 2.5, "N": 0.125, "E": 0.375}
        answer = self.answer("eval", scene, *(word for name, value in values.items() for word in ("--set", f"{name}={value}")),
                             "--set", "u_z0=1")
        given = {name: mp.mpf(value) for name, value in values.items()} | {"R_d": mp.mpc(0.5, -0.25)}
        cases = [({each: self.out("derive", scene, "--format", each, "--form", form) for each in FORMATS}, given,
                  mp.mpf(answer["critical_velocity"])) for form in ("shortest", "nested", "dimensionless")]
        self.check_by_grammar(cases)
        self.check_by_systems(cases)


class Refused(Case):
    def test_what_is_for_readers(self):
        file = self.scene()
        for each in FORMATS:
            for option, words in (("--limits", ()), ("--sensitivities", ()), ("--equal", (file,))):
                self.refused(2, ["derive", file, "--format", each, option, *words], option.strip("-"), each, "expected text")

    def test_what_is_no_double(self):
        file = self.scene(tangential_ratio=1e-310, network="kd")
        self.assertIn("1" + "0" * 310, self.out("derive", file, "--form", "rational", "--format", "maple"))
        self.refused(3, ["derive", file, "--form", "rational", "--format", "c"], "digits")

    def test_what_is_no_language(self):
        for each, text in (("mathematica", "a_b = 1;\nvStar = 2"), ("mathematica", "(* *)\nK = 1;\nvStar = 2"),
                           ("mathematica", "(* *)\nvStar = sqrt[2]"), ("mathematica", "(* *)\nvStar = Sqrt(2)"),
                           ("maple", "gamma := 1:\nv_star := 2;"), ("maple", "v_star := 2 3;"), ("maple", "v_star := k1;"),
                           ("maxima", "/* */\nv_star: 1.5;"), ("c", "double v_star(\n{\n  return 2/3;\n}"),
                           ("c", "double v_star(\n{\n  return 2.0^3;\n}")):
            with self.assertRaises(systems.Wrong, msg=text):
                systems.read(each, text).value({})


if __name__ == "__main__":
    unittest.main()
