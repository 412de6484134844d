"""The LaTeX of every derivation, form, limit and sensitivity of all scenes is taken by KaTeX at its strictest, which
throws where TeX would stop or guess: an unknown command, a missing brace, a letter that is no mathematics. The same of
what Markdown has between dollars, of the formulas in JSON, and of names that are hard to print.

KaTeX is Debian's package libjs-katex, nodejs runs it: without them the test fails.
"""

import csv
import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

from asked_documents import documents
from example_scenes import with_formula
from program import PROGRAM, PROJECT, Case

PRINT_DOCUMENTS = sys.argv.pop(1)
KATEX = "/usr/share/javascript/katex/katex.js"
HERE = Path(__file__).resolve().parent

FORMATS = {"shortest": ["latex", "markdown", "json"]} | {
    form: ["latex"] for form in ("nested", "storage-loss", "rational", "dimensionless", "expanded")}
REFUSED = [("measured_drive", "rational"), ("prony", "rational"),  # no polynomials; too many terms
           ("measured_drive", "storage-loss"), ("prony", "expanded")]
# Names with digits, underscores, Greek letters, the program's own symbols and LaTeX's own words.
HARD = {"normal": "k_1 | spring(alpha_beta12) - damper(nabla)", "tangential": "spring(frac) | spring(s) - damper(i_)",
        "network": "spring(K_n) | damper(c_9_x) - spring(mathrm)", "mass": "m"}

DISPLAYED = re.compile(r"\\\[(.*?)\\\]|(\\begin\{align\*\}.*?\\end\{align\*\})", re.DOTALL)
IN_LINE = re.compile(r"(?<![\\$])\$(?!\$)(.+?)(?<!\\)\$(?!\$)")
IN_BLOCKS = re.compile(r"\$\$(.*?)\$\$", re.DOTALL)


def latex_of_json(value):
    """All values under the key latex."""
    if isinstance(value, dict):
        yield from ([value["latex"]] if isinstance(value.get("latex"), str) else [])
        for each in value.values():
            yield from latex_of_json(each)
    elif isinstance(value, list):
        for each in value:
            yield from latex_of_json(each)


def formulas(text, form):
    """(mathematics, whether it is displayed)"""
    if form == "json":
        return [(each, True) for each in latex_of_json(json.loads(text))]
    displayed = IN_BLOCKS.findall(text) if form == "markdown" else map("".join, DISPLAYED.findall(text))
    rest = (IN_BLOCKS if form == "markdown" else DISPLAYED).sub("", text)
    return [(each, True) for each in displayed] + [(each, False) for each in IN_LINE.findall(rest)]


def derived(asked, formats=None):
    """{format: document} of each (scene, form), with limits and sensitivities."""
    return documents(PRINT_DOCUMENTS, [{"scene": str(scene), "form": form, "limits": True, "sensitivities": True,
                                        "formats": formats or FORMATS[form]} for scene, form in asked])


def faults_of(items):
    """One process for all of them. Many formulas are in many documents: each is typeset once, for the first of these."""
    different = {}
    for where, *formula in items:
        different.setdefault(tuple(formula), where)
    asked = json.dumps([[where, *formula] for formula, where in different.items()])
    done = subprocess.run(["node", HERE / "katex.mjs", KATEX], input=asked, capture_output=True, text=True, check=True, timeout=120)
    return json.loads(done.stdout)


class Katex(Case):
    @classmethod
    def setUpClass(cls):
        if not Path(KATEX).exists():
            raise RuntimeError(f"{KATEX} is missing: apt-get install libjs-katex")

    def test_it_takes_all_that_is_derived(self):
        scenes = [*with_formula(PROGRAM), self.scene(**HARD)]
        asked = [(scene, form) for scene in scenes for form in FORMATS if (scene.stem, form) not in REFUSED]
        items = []
        for (scene, form), printed in zip(asked, derived(asked), strict=True):
            self.assertEqual(list(printed), list(FORMATS[form]))
            for each, text in printed.items():
                where = f"{scene.name} {form} {each}"
                found = formulas(text, each)
                # Ten lines lead to v*, whatever the scene.
                self.assertGreater(len(found), 10, where)
                items += [(where, *each) for each in found]
        self.assertEqual(faults_of(items), [])

    def test_it_takes_all_cells_of_the_table_of_hand_forms(self):
        with (PROJECT / "tests/data/hand_forms.csv").open(newline="") as file:
            cells = list(csv.DictReader(file))
        self.assertEqual(len(cells), 216)
        files = [self.write(cell["scene"], f"{n}.toml") for n, cell in enumerate(cells)]
        items = []
        for file, printed in zip(files, derived([(file, "shortest") for file in files], ["latex"]), strict=True):
            items += [(file.read_text(), *each) for each in formulas(printed["latex"], "latex")]
        self.assertEqual(faults_of(items), [])

    def test_it_refuses_what_is_no_latex(self):
        good = [r"\mu_{0} \omega", r"\frac{k_{0}}{2}"]
        bad = [r"\omgea", r"\frac{k_{0}}{", r"k_0_1", r"\left(k", "µ", r"5 %", r"\mathrm{k_{0}"]
        items = [(str(n), each, True) for n, each in enumerate(good + bad)]
        self.assertEqual([fault.split(":")[0] for fault in faults_of(items)],
                         [str(n) for n in range(len(good), len(items))])


if __name__ == "__main__":
    unittest.main()
