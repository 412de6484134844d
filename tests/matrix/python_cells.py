"""The columns of the Python module: each function of it on each kind, in this one process."""

import warnings
from types import SimpleNamespace

import vcrit

from cells import FOLDER, REFERENCES, onset
import formulas


def asked(test, kind, column, call):
    """What the call gives, or nothing where the cell is a refusal; as if a command had been run."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            result, ran = call(vcrit.Scene(str(FOLDER / "kinds" / f"{kind}.toml"))), SimpleNamespace(returncode=0, stderr="")
        except vcrit.InputError as error:
            result, ran = None, SimpleNamespace(returncode=2, stderr=str(error))
        except vcrit.ModelError as error:
            result, ran = None, SimpleNamespace(returncode=3, stderr=str(error))
    ran.stdout = ""
    return result if test.answered(kind, column, ran) else None


def critical_velocity(test, kind, column):
    found = asked(test, kind, column, lambda scene: scene.critical_velocity())
    if found is not None:
        test.near(found, *onset(kind), "v*")


def critical_onset(test, kind, column):
    found = asked(test, kind, column, lambda scene: scene.critical_onset)
    if found is not None:
        value, error = onset(kind)
        test.near(found.contact_velocity, value, error, "v*")


def velocities(kind):
    references = REFERENCES[kind]
    return [float(references.text(f"velocity:{i}")) if f"velocity:{i}" in references else 1e-3 for i in (0, 1)]


def simulate(test, kind, column):
    found = asked(test, kind, column, lambda scene: scene.simulate(velocities(kind)[0]))
    if found is not None:
        name = "friction_ratio:0"
        reference = REFERENCES[kind]
        test.near(found.friction_ratio, reference(name), reference.error(name) + found.friction_ratio_error, name)
        test.assertEqual(found.regime, reference.text("regime:0"))


def friction_curve(test, kind, column):
    found = asked(test, kind, column, lambda scene: scene.friction_curve(velocities=velocities(kind)))
    if found is None:
        return
    references = REFERENCES[kind]
    for i in (0, 1):
        name = f"friction_ratio:{i}"
        test.near(found.friction_ratio[i], references(name), references.error(name) + found.friction_ratio_error[i], name)


def derive(test, kind, column):
    found = asked(test, kind, column, vcrit.derive)
    if found is None:
        return
    values = formulas.beside_poles(REFERENCES[kind].parameters())
    documents = {form: found.document(form) for form in ("text", "latex")}
    for form, document in documents.items():
        for value in formulas.onsets(document, form, values):
            test.near_in_digits(value, REFERENCES[kind]("formula"), form)
    alone = formulas.onsets(f"\\[ {found.latex} \\]", "latex", values)
    for value in alone:
        test.near_in_digits(value, REFERENCES[kind]("formula"), found.latex)
    if not alone:  # it has names of its own, and stands on a line of its own
        test.assertIn(found.latex.split("=", 1)[1].strip(), documents["latex"])
