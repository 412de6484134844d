"""Typesets derivations as papers do, with pdflatex: every scene, and every cell of tests/data/hand_forms.csv, as a
standalone article. A line wider than the text (an overfull box), an error or a warning is a failure, named with its
document. `./dev appendix` runs it; it is not in the suite, which has KaTeX for the same formulas.

    typeset.py PROGRAM [--jobs 2] [--only TEXT] [--keep FOLDER]
"""

import argparse
import csv
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "tests/support"))
from example_scenes import with_formula  # noqa: E402

ALL = ["--limits", "--sensitivities"]
FORMS = ["nested", "storage-loss", "rational", "dimensionless", "expanded"]
# A table has no polynomials and no network; ten branches have too many terms.
REFUSED = {("measured_drive", "rational"), ("measured_drive", "storage-loss"), ("prony", "rational"), ("prony", "expanded")}
# Overfull boxes and errors; warnings of classes and packages.
FAULTS = re.compile(r"^(?:Overfull .*|! .*|.*Warning: .*)$", re.MULTILINE)
# Two runs of one document, which has neither references nor marks, would be the same.
LATEX = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error"]


def documents(program, folder):
    """(name, scene, words)"""
    for scene in with_formula(program):
        yield scene.stem, scene, ALL
        yield from ((f"{scene.stem}-{form}", scene, ["--form", form]) for form in FORMS
                    if (scene.stem, form) not in REFUSED)
    with open(PROJECT / "tests/data/hand_forms.csv", newline="", encoding="utf-8") as file:
        for cell in csv.DictReader(file):
            name = "-".join(re.sub(r"\W+", "_", cell[key]) for key in ("rheology", "drive", "poisson"))
            scene = folder / f"{name}.toml"
            scene.write_text(cell["scene"], encoding="utf-8")
            yield name, scene, ALL
            yield f"{name}-dimensionless", scene, ["--form", "dimensionless"]


def faults(program, folder, name, scene, words):
    """What is wrong with one document: nothing, or a text."""
    derived = subprocess.run([program, "derive", scene, "--format", "latex", "--standalone", *words],
                             capture_output=True, text=True, timeout=300)
    if derived.returncode != 0:
        return derived.stderr.strip()
    file = folder / f"{name}.tex"
    file.write_text(derived.stdout, encoding="utf-8")
    subprocess.run([*LATEX, file.name], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
    log = (folder / f"{name}.log").read_text(encoding="latin-1")
    found = FAULTS.findall(log)
    if not found and "Output written on" not in log:
        return "no pages"
    return "; ".join(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="documents whose name has this text")
    parser.add_argument("--keep", type=Path, help="leave documents and pages there")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="vcrit-appendix-") as private, ThreadPoolExecutor(chosen.jobs) as pool:
        folder = (chosen.keep or Path(private)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        asked = [each for each in documents(chosen.program.resolve(), folder) if chosen.only in each[0]]
        results = pool.map(lambda each: (each[0], faults(chosen.program.resolve(), folder, *each)), asked)
        failed = 0
        for name, fault in results:
            if fault:
                failed += 1
                print(f"{name}: {fault}")
    print(f"{len(asked)} documents typeset, {failed} with a fault")
    # None at all would be a test that cannot fail.
    return 1 if failed or not asked else 0


if __name__ == "__main__":
    sys.exit(main())
