"""Every kind of scene (kinds/*.toml) against every command, language, method, quantity and form: see CONTRIBUTING.md.

A cell holds an independent value (references.csv, by make_references.py, which shares nothing with the program) or a
refusal (refusals.csv: exit status and a part of the message). The columns come from the program's own help, so that a
new one has no cells and fails, as a new kind does.
"""

import csv
import functools
import json
import os
import tempfile
import unittest
from pathlib import Path

import mpmath as mp

import check_cells
import derive_cells
import evaluators
import formulas
import plot_cells
import python_cells
import sweep_cells
from cells import (FOLDER, KINDS, LOOKED_AT, REFERENCES, REFUSALS, U, Cells, choices, commands, free_share, onset, receptance,
                   refusal, run, scene)

# Formats of the derivation; those of systems have v* alone, tests/document tries every form of it.
DOCUMENTS, FORMS = ("text", "latex", "markdown", "html", "json"), choices("derive", "form")
SYSTEMS = [each for each in choices("derive", "format") if each not in DOCUMENTS]
LANGUAGES, METHODS = choices("generate", "language"), choices("simulate", "method")
STARTS, UNKNOWNS = choices("simulate", "start"), choices("solve", "for")
QUANTITIES, PICTURES = choices("sweep", "quantity"), choices("plot", "of")
PYTHON = ("critical_velocity", "critical_onset", "simulate", "friction_curve", "derive")
DERIVED = [f"derive/{form}/{each}" for form in FORMS for each in DOCUMENTS] + [f"derive/shortest/{each}" for each in SYSTEMS]
COLUMNS = {
    "eval": ["eval"],
    "derive": [*DERIVED, "derive/limits", "derive/sensitivities", "derive/equal"],
    "generate": [f"generate/{each}" for each in LANGUAGES] + ["generate/quantities", "generate/fix"],
    "simulate": [f"simulate/{each}" for each in METHODS + STARTS],
    "critical": ["critical"], "explore": ["explore"],
    "plot": [f"plot/{each}" for each in PICTURES],
    "sweep": [f"sweep/{each}" for each in QUANTITIES],
    "solve": [f"solve/{each}" for each in UNKNOWNS],
    "check": ["check"],
    "validate": ["validate"],
    "python": [f"python/{each}" for each in PYTHON],
}
# What a report compares of each kind, by docs/report.md: one that is no longer made is missed here.
with (FOLDER / "comparisons.csv").open() as file:
    COMPARISONS = {row["kind"]: row["comparisons"].split() for row in csv.DictReader(file)}
OTHER_COMMANDS = {"fit", "new"}  # read no scene


@functools.cache
def derived(kind):
    return json.loads(derive_cells.printed_by_library(*DERIVED)[kind, "derive/shortest/json"])


class Matrix(Cells, unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def over(self, columns, check):
        for column in columns:
            for kind in KINDS:
                with self.subTest(kind=kind, column=column):
                    check(kind, column)

    def test_eval(self):
        self.over(["eval"], self.eval)

    def eval(self, kind, column):
        answer = self.answer(kind, column, "eval", scene(kind))
        if not answer:
            return
        references = REFERENCES[kind]
        (value, error), simulated = onset(kind), answer.get("critical_velocity_by", "formula") != "formula"
        self.assertEqual(simulated, answer["relative_error_bound"] is None)
        if simulated or not answer.get("opens"):
            self.near(answer["critical_velocity"], value, error, "v*")
        else:
            # By the formula, which is exact, and by steps.
            self.near_formula(answer["critical_velocity"], kind)
            self.near(answer["critical_velocity"], value, error, "v* by steps")
        if not simulated:
            self.assertLessEqual(answer["relative_error_bound"], U)
        parts = "opens" in answer
        self.assertEqual(answer["admissible"],
                         bool(references("loaded")) and (parts or kind.startswith("indenter") or bool(references("closed"))))
        self.assertEqual(answer["admissible"] and value != mp.inf, not answer["reasons"])
        if parts and not kind.startswith("indenter"):
            self.assertEqual(answer["opens"], not references("closed"))
        for drive in ("drive_velocity", "closed_drive_velocity"):
            if drive in references:
                allowed = references.error(drive) or 4 * U * float(min(references(drive), mp.mpf(10)**300))
                self.near(answer["drive_velocity"], references(drive), allowed, drive)
        check_cells.normal(self, kind, answer)
        share = free_share(kind)
        self.assertEqual(answer.get("free_harmonic"), 2 if share else None)
        if share:
            self.near(answer["sliding_from"], value * share, (4 * U + 2e-12) * float(value))

    def test_derive(self):
        derive_cells.derive(self, DERIVED)

    def test_limits(self):
        self.over(["derive/limits"], self.limits)

    def limits(self, kind, column):
        document = self.answer(kind, column, "derive", scene(kind), "--limits")
        if not document:
            return
        references, values = REFERENCES[kind], formulas.beside_poles(REFERENCES[kind].parameters())
        for limit in document["limits"]:
            name = self.limit_name(limit["name"], document)
            self.assertIn(name, references, limit["name"])
            for what in ("text", "latex") if not limit["definitions"] else ("text",):
                value = formulas.line_value(limit, values, what)
                self.near_in_digits(abs(value), references(name), f"{limit['name']} {what}")
        for line in document["asymptotes"]:
            start = f"asymptote:{line['name']}"
            self.assertEqual(line["power"], int(references(f"{start}:power")), start)
            at = dict(line["coefficient"], definitions=line["definitions"])
            still = {name: value for name, value in values.items() if name != "omega"}
            self.near_in_digits(abs(formulas.line_value(at, still)), references(f"{start}:coefficient"), start)
        self.assertEqual(len(document["asymptotes"]), len(references.begin("asymptote:")) // 2)

    def limit_name(self, name, document):
        """As make_references.py calls it."""
        parts = [part.split(" -> ") for part in name.replace("isotropic contact, K_t = kt*K_n/kn", "isotropic -> ")
                 .replace(", K_d", "; K_d").replace(", kd -> inf", "; kd -> inf").replace("isotropic -> ,", "isotropic -> ;")
                 .split("; ")]
        drive = "K_d" if "K_d -> infinity" in name else "kd"
        rigid = len(parts) > 1
        names, target = parts[0]
        if names == "isotropic":
            return "limit:isotropic" + (" rigid" if rigid else "")
        if names in ("K_d", drive) and target == "infinity" and (names == "K_d" or self.drive_is_one(document)):
            return "limit:rigid"
        target = {"0": "0", "infinity": "inf"}[target]
        return "limit:" + "+".join(sorted(names.split(", "))) + f"={target}" + (" rigid" if rigid else "")

    def drive_is_one(self, document):
        return any(line["text"] == "K_d = kd" for line in document["lines"])

    def test_sensitivities(self):
        self.over(["derive/sensitivities"], self.sensitivities)

    def sensitivities(self, kind, column):
        document = self.answer(kind, column, "derive", scene(kind), "--sensitivities")
        if not document:
            return
        references, values = REFERENCES[kind], formulas.beside_poles(REFERENCES[kind].parameters())
        listed = {line["parameter"]: line for line in document["sensitivities"]}
        self.assertLessEqual(set(listed), set(references.begin("value:")))
        for name in references.begin("sensitivity:"):
            reference = references(f"sensitivity:{name}")
            if "measured" in kind and name == "omega":
                self.assertNotIn(name, listed)  # how the table changes is in no formula
                continue
            if name not in listed:
                self.assertEqual(reference, 0, name)
                continue
            for each, scale in (("relative", 1), ("derivative", references("formula") / values[name])):
                line = dict(listed[name][each], definitions=listed[name]["definitions"])
                value = formulas.line_value(line, values, definitions=document["definitions"])
                self.near_in_digits(mp.re(value) / scale, reference, f"{each} {name}")

    def test_equal(self):
        self.over(["derive/equal"], self.equal)

    def equal(self, kind, column):
        same = self.answer(kind, column, "derive", scene(kind), "--equal", scene(kind))
        if not same:
            return
        self.assertTrue(same["equal"])
        other = "closed_body" if kind != "closed_body" else "closed_drive"
        ran = run("derive", scene(kind), "--equal", scene(other), "--json")
        self.assertEqual(ran.returncode, 1, ran.stderr)
        found = json.loads(ran.stdout)["counterexample"]
        for place, each in (("first", kind), ("second", other)):
            document = derived(each)
            line = dict(document["critical_velocity"], definitions=document["definitions"])
            values = REFERENCES[each].parameters() | {name: mp.mpf(x) for name, x in found["values"].items()}
            values |= {"du_z": values["U"]} if "U" in found["values"] else {}  # one symbol, by its name in the first
            if "R_d" in values:
                values["R_d"] = receptance(values["omega"])
            value = abs(formulas.line_value(line, values))
            self.near(found[place], value, 1e-12 * value, place)

    def test_simulate(self):
        self.over([f"simulate/{each}" for each in METHODS + STARTS], self.simulate)

    def simulate(self, kind, column):
        method = column.split("/")[1]
        references = REFERENCES[kind]
        how = ("--start", method) if method in STARTS else ("--method", method)
        for i in (0, 1) if method == "exact" else (0,) if method in METHODS else (1,):
            velocity = references.text(f"velocity:{i}") if f"velocity:{i}" in references else "1e-3"
            answer = self.answer(kind, column, "simulate", scene(kind), "--velocity", velocity, *how)
            if not answer:
                return
            self.check_motion(kind, i, answer)

    def check_motion(self, kind, i, answer):
        references = REFERENCES[kind]
        ratio = f"friction_ratio:{i}"
        own = answer["friction_ratio_error"]
        self.near(answer["friction_ratio"], references(ratio), references.error(ratio) + own, ratio)
        value, error = onset(kind)
        if 0 < value < mp.inf:
            expected = mp.mpf(answer["velocity"]) / value
            self.near(answer["velocity_ratio"], expected, expected * (error / value + 4 * U), "velocity_ratio")
        if answer["method"] != "exact":
            return
        self.assertEqual(answer["regime"], references.text(f"regime:{i}"))
        for part in ("drive", "friction"):
            name = f"energy_{part}:{i}"
            if name in references and answer.get("energy"):
                self.near(answer["energy"][part], references(name), references.error(name) + answer["energy"]["error"], name)
        inside = answer.get("separation") or answer.get("indenter")
        if inside:
            name = f"mean_normal_force:{i}"
            self.near(inside["mean_normal_force"], references(name),
                      references.error(name) + inside.get("mean_normal_force_error", 0), name)

    def test_critical(self):
        self.over(["critical"], self.critical)

    def critical(self, kind, column):
        ran = run("critical", scene(kind), "--json")
        if not self.answered(kind, column, ran) and ran.returncode != 1:
            return
        answer = json.loads(ran.stdout)
        self.near_formula(answer["formula"], kind)
        (value, error), fit = onset(kind), answer.get("realisation_difference", 0)
        self.assertLess(fit, 2e-3)  # a fifth of what tables err by between rows, an eighth of their second differences
        self.assertEqual(answer["agree"], ran.returncode == 0)
        self.near(answer["simulated"], value * (free_share(kind) or 1), error + (fit + 1e-9) * value, "simulated")
        if answer["stick_onset"] is None:
            self.assertIn(kind, ("free_harmonic", "drive_free_harmonics", "near_free_harmonic", "antiresonance"))
        else:
            self.near(answer["stick_onset"], value, error + (fit + 1e-9) * value, "stick_onset")

    def test_plot(self):
        self.over([f"plot/{each}" for each in PICTURES], lambda kind, column: plot_cells.plot(self, kind, column))

    def test_explore(self):
        self.over(["explore"], lambda kind, column: plot_cells.explore(self, kind, column))

    def test_sweep(self):
        sweep_cells.sweep(self, [f"sweep/{each}" for each in QUANTITIES])

    def test_solve(self):
        self.over([f"solve/{each}" for each in UNKNOWNS], self.solve)

    def solve(self, kind, column):
        references, unknown = REFERENCES[kind], column.split("/")[1]
        has = "design:friction_ratio" in references
        wanted = references.text("design:friction_ratio") if has else "0.9"
        velocity = references("design:velocity") if has else mp.mpf("1e-3")
        amplitude = references("design:amplitude") if has else None
        arguments = ["solve", scene(kind), "--for", unknown, "--friction-ratio", wanted]
        if unknown != "velocity":
            arguments += ["--velocity", mp.nstr(velocity, 17)]
        arguments += ["--set", f"amplitude={mp.nstr(amplitude, 17)}"] if unknown != "amplitude" and has else []
        if unknown == "velocity" and "formula" in references and references("formula") > 1e3:  # no upper end, or one lost in rounding
            arguments += ["--to", "0.1"]
        # A path that creeps carries ever less of the friction of a larger load: the largest is that searched up to.
        creeps = unknown == "force" and "design:slope:force" in references and references("design:slope:force") < 0
        arguments += ["--to", "100"] if creeps else []
        force = references("value:W") if "value:W" in references else None
        truth, at_start = {"velocity": velocity, "amplitude": amplitude, "force": force}.get(unknown), False
        if unknown == "frequency" and has:
            truth = references("design:omega") / (2 * mp.pi)
            slope = references("design:slope:frequency")
            arguments += ["--from", mp.nstr(truth * 0.98, 17), "--to", mp.nstr(truth * 1.02, 17), "--samples", 6 if "indent" in kind else 40]
            at_start = slope > 0
            truth = truth * mp.mpf("0.98") if at_start else truth
        answer = self.answer(kind, column, *arguments)
        if not answer:
            return
        if creeps:
            return self.assertEqual((answer["at_start"], answer["value"], answer["searched"]["to"]), (True, 100, 100))
        slope = abs(references(f"design:slope:{unknown}")) * (2 * mp.pi if unknown == "frequency" else 1)
        allowed = 2 * references.error("design:friction_ratio") / slope + answer["value_error"] + 4 * U * abs(truth)
        self.assertEqual(answer["at_start"], at_start)
        self.near(answer["value"], truth, allowed, unknown)

    def test_generate(self):
        evaluators.check(self, LANGUAGES, self.folder)

    def test_check(self):
        self.over(["check"], lambda kind, column: check_cells.check(self, kind, column))

    def test_validate(self):
        """All kinds in one call; with no compiler, since generated code has columns of its own."""
        def validated(*kinds):
            return run("validate", *map(scene, kinds), "--out", self.folder / "report", "--json",
                       timeout=120 + 5 * len(kinds), env=dict(os.environ, PATH="/nonexistent"))

        refused = [kind for kind in KINDS if refusal(kind, "validate")]
        for kind in refused:
            with self.subTest(kind=kind, column="validate"):
                self.assertFalse(self.answered(kind, "validate", validated(kind)))
        validated(*(kind for kind in KINDS if kind not in refused))
        for each in json.loads((self.folder / "report/report.json").read_text())["scenes"]:
            kind = Path(each["file"]).stem
            with self.subTest(kind=kind, column="validate"):
                LOOKED_AT.add((kind, "validate"))
                self.assertEqual([compared["key"] for compared in each["comparisons"]], COMPARISONS[kind])
                for compared in each["comparisons"]:
                    self.check_compared(kind, compared)

    def check_compared(self, kind, compared):
        key, outcome = compared["key"], compared["outcome"]
        if outcome != "passed" and key != "generated":
            expected = refusal(kind, f"validate/{key}")
            self.assertIsNotNone(expected, compared)
            self.assertEqual(expected[0], outcome, compared)
            self.assertIn(expected[1], compared["detail"])

    def test_python(self):
        self.over([f"python/{name}" for name in PYTHON],
                  lambda kind, column: getattr(python_cells, column.split("/")[1])(self, kind, column))


class Whole(unittest.TestCase):
    """After the matrix, by the alphabet."""

    def test_all_cells_were_looked_at(self):
        self.assertEqual(set(commands()), set(COLUMNS) - {"python"} | OTHER_COMMANDS)
        cells = {(kind, column) for kind in KINDS for columns in COLUMNS.values() for column in columns}
        self.assertEqual(sorted(cells - LOOKED_AT), [])
        self.assertEqual(sorted(LOOKED_AT - cells), [])
        print(f"{len(cells)} cells: {len(KINDS)} kinds, {len(cells) // len(KINDS)} columns")

    def test_no_row_is_left_over(self):
        self.assertEqual(sorted(set(REFERENCES) ^ set(KINDS)), [])
        self.assertEqual([row for row in REFUSALS if not row.get("used")], [])
        refused = {kind for kind in KINDS if refusal(kind, "validate")}
        self.assertEqual(sorted(set(COMPARISONS) ^ (set(KINDS) - refused)), [])


if __name__ == "__main__":
    unittest.main()
