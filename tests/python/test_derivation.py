"""The derivation in Python, and how a notebook shows it."""

import json
import math
import unittest

import vcrit
from IPython.core.formatters import DisplayFormatter
from support import formula_rows, program, relative_difference

ELASTIC, KELVIN, PRONY = "scenes/elastic.toml", "scenes/kelvin.toml", "scenes/prony.toml"


def derive(file):
    return vcrit.derive(vcrit.Scene(file))


class Derivation(unittest.TestCase):
    def test_is_what_the_program_prints(self):
        for row in formula_rows():
            file = f"scenes/{row['scene']}"
            with self.subTest(scene=file):
                derivation = derive(file)
                self.assertEqual(derivation.text, program("derive", file).stdout)
                for format in ["latex", "markdown", "html", "json"]:
                    self.assertEqual(derivation.document(format), program("derive", file, "--format", format).stdout)

    def test_is_refused_where_v_is_no_formula(self):
        for row in formula_rows(False):
            with self.assertRaisesRegex(vcrit.ModelError, "has no formula"):
                derive(f"scenes/{row['scene']}")

    def test_has_the_programs_options(self):
        self.assertEqual(derive(KELVIN).document("latex", standalone=True),
                         program("derive", KELVIN, "--format", "latex", "--standalone").stdout)
        self.assertEqual(derive(KELVIN).document(limits=True), program("derive", KELVIN, "--limits").stdout)
        self.assertEqual(derive(KELVIN).document(sensitivities=True),
                         program("derive", KELVIN, "--sensitivities").stdout)
        nested = vcrit.derive(vcrit.Scene(KELVIN), form="nested")
        self.assertEqual(nested.text, program("derive", KELVIN, "--form", "nested").stdout)

    def test_in_two_forms_by_turns_stays_apart(self):
        scene, forms = vcrit.Scene(KELVIN), ("shortest", "nested")
        derivations = [vcrit.derive(scene, form=form) for form in forms]
        for form, derivation in list(zip(forms, derivations)) * 2:
            self.assertEqual(derivation.text, program("derive", KELVIN, "--form", form).stdout)

    # By hand: Eq. (31), mu0 omega du_z kn/kt.
    def test_of_an_elastic_contact_is_equation_31(self):
        derivation = derive(ELASTIC)
        self.assertEqual(derivation.equation, "(31)")
        self.assertEqual(derivation.latex, r"v^{*} = \frac{\mu_{0} \omega \Delta u_{z} k_{n}}{k_{t}}")
        self.assertEqual(derivation.formula, "mu0*omega*du_z*kn/kt")
        self.assertEqual(repr(derivation), "v* = mu0*omega*du_z*kn/kt")
        self.assertEqual(derivation.parameters, ("mu0", "omega", "du_z", "kn", "kt"))
        self.assertEqual(derivation.definitions, ())
        self.assertEqual(derivation.lines[-1].latex, derivation.latex)
        self.assertEqual(derivation.lines[-1].words, "Result")

    def test_has_a_formula_with_the_value_of_the_scene(self):
        for file in [ELASTIC, KELVIN, "scenes/zener.toml", "scenes/kelvin_rigid.toml"]:
            scene = vcrit.Scene(file)
            names = {name: each.value for name, each in scene.parameters.items()} | {"sqrt": math.sqrt, "abs": abs}
            derivation = vcrit.derive(scene)
            for definition in derivation.definitions:
                name, formula = definition.text.split(" = ")
                names[name] = eval(formula.replace("^", "**"), {}, names)
            value = eval(derivation.formula.replace("^", "**"), {}, names)
            # Some fifty operations far from resonance, |D| above a tenth of its terms.
            self.assertLess(relative_difference(value, scene.critical_velocity()), 1e-13)

    def test_needs_no_values(self):
        text = 'contact.normal = "kn"\ncontact.tangential = "kt"\n'
        self.assertEqual(vcrit.derive(vcrit.Scene.from_text(text)).latex, derive(ELASTIC).latex)

    def test_has_the_limits_of_the_paper(self):
        limits = {limit.equation: limit for limit in derive(KELVIN).limits if limit.equation}
        self.assertLessEqual({"(29)", "(30)", "(31)"}, set(limits))
        # By hand: (31), and (30) with its absolute values.
        self.assertEqual(limits["(31)"].text, "mu0*omega*du_z*kn/kt")
        self.assertEqual(limits["(31)"].latex, r"\frac{\mu_{0} \omega \Delta u_{z} k_{n}}{k_{t}}")
        self.assertEqual(limits["(30)"].text,
                         "mu0*omega*du_z*kn*abs(kd + kt - m*omega^2)/(kt*abs(kd - m*omega^2))")
        names = [limit.name for limit in derive(KELVIN).limits]
        self.assertIn("kd -> infinity", names)
        self.assertEqual(len(names), len(json.loads(derive(KELVIN).document("json", limits=True))["limits"]))

    def test_tells_formulas_apart(self):
        self.assertEqual(derive(ELASTIC).fingerprint, derive(ELASTIC).fingerprint)
        self.assertNotEqual(derive(ELASTIC).fingerprint, derive(KELVIN).fingerprint)


class Notebook(unittest.TestCase):
    """What Jupyter is given to show."""

    def shown(self, thing):
        data, _ = DisplayFormatter().format(thing)
        return data

    def test_shows_the_formula(self):
        shown = self.shown(derive(ELASTIC))
        self.assertEqual(shown["text/latex"],
                         r"$\displaystyle v^{*} = \frac{\mu_{0} \omega \Delta u_{z} k_{n}}{k_{t}}$")
        self.assertEqual(shown["text/plain"], "v* = mu0*omega*du_z*kn/kt")

    def test_shows_limits_and_steps(self):
        limit = next(limit for limit in derive(KELVIN).limits if limit.equation == "(31)")
        self.assertEqual(self.shown(limit)["text/latex"], self.shown(derive(ELASTIC))["text/latex"])
        step = derive(ELASTIC).lines[0]
        self.assertEqual(self.shown(step)["text/latex"], f"$\\displaystyle {step.latex}$")

    def test_shows_what_the_names_in_a_nested_formula_mean(self):
        derivation = vcrit.derive(vcrit.Scene(PRONY), form="nested")
        lines = self.shown(derivation)["text/latex"].splitlines()
        self.assertEqual(lines[0], r"$$\begin{gathered}")
        self.assertEqual(lines[-1], r"\end{gathered}$$")
        self.assertEqual(lines[1:-1], [each.latex + r" \\" for each in derivation.definitions] + [derivation.latex])
        self.assertEqual([each.text.split(" = ")[0] for each in derivation.definitions], ["K_n", "K_d"])

    def test_is_given_balanced_latex(self):
        for row in formula_rows():
            text = derive(f"scenes/{row['scene']}")._repr_latex_()
            self.assertEqual(text.count("{"), text.count("}"))
            self.assertEqual(text.count(r"\left"), text.count(r"\right"))
            self.assertEqual(text.count("$") % 2, 0)


if __name__ == "__main__":
    unittest.main()
