"""The columns of `derive` with a form and a format. In each column the command prints some of the kinds, by turns; all
cells are printed by the library in one process, which has the very bytes of those that the command prints."""

import functools
import sys

import formulas
from cells import FOLDER, KINDS, REFERENCES, refusal, run, scene
from asked_documents import documents

PRINT_DOCUMENTS = sys.argv.pop(1)
TURNS = 12  # of which the command has one: some three cells of each kind, and six of each column


@functools.cache
def printed_by_library(*columns):
    """{(kind, column): document} of all cells that have one."""
    asked = {}
    for column in columns:
        for kind in KINDS:
            if refusal(kind, column) is None:
                _, form, form_of_text = column.split("/")
                asked.setdefault((kind, form), []).append(form_of_text)
    found = documents(PRINT_DOCUMENTS, [{"scene": scene(kind), "form": form, "formats": formats}
                                    for (kind, form), formats in asked.items()], cwd=FOLDER / "kinds", timeout=600)
    return {(kind, f"derive/{form}/{each}"): text
            for (kind, form), texts in zip(asked, found, strict=True) for each, text in texts.items()}


def derive(test, columns):
    library = printed_by_library(*columns)

    def cell(kind, column):
        _, form, form_of_text = column.split("/")
        printed = library.get((kind, column))
        if printed is None or (KINDS.index(kind) + columns.index(column)) % TURNS == 0:
            if not test.answered(kind, column, ran := run("derive", scene(kind), "--form", form, "--format", form_of_text)):
                return
            test.assertEqual(printed, ran.stdout)
        else:
            test.looked_at(kind, column)
        check_printed(test, kind, form, form_of_text, printed)

    test.over(columns, cell)


def check_printed(test, kind, form, form_of_text, printed):
    values = formulas.beside_poles(REFERENCES[kind].parameters())
    found = formulas.all_onsets(printed, form, form_of_text, values)
    test.assertTrue(found, printed[:3000])
    for value in found:
        test.near_in_digits(value, REFERENCES[kind]("formula"), printed[:3000])
