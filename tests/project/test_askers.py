"""One question, one answer: whether an indenter presses, whether the contact may open, whether a load is its mean force
and whether the drive resonates is told by the rulebook.

src/rules/kinds.hpp says what follows (cells_move, may_open, load_is_mean_force, drive_resonates, Facts::loses_contact,
...). A room behind it that reads the scene's own words, or looks for masses in a network, instead answers the same
question once more, and the two answers drift apart. Those below have a reason: they build from what they read, or show
it.

Run with the project's folder. With --list, prints all who read them.
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
ASKED = re.compile(r"\b(?:problem_?|scene_?)(?:\(\))?(?:->|\.)(?:indenter|separation)\b(?!->)")
MASSES = re.compile(r"\bhas_masses\(")
MEAN_FORCE = re.compile(r"(?:->|\.)load\b\s*(?:&&\s*!|\|\|\s*)[^;{]{,20}(?:indenter|cells_move)")
COMMENT = re.compile(r"//[^\n]*")
ROOMS = ("src", "symbolic", "validation", "app", "python")
BEFORE_THE_RULES = ("src/base/", "src/linear/", "src/network/", "src/record/", "src/scene/", "src/problem/", "src/stiffness/",
                    "src/modes/", "src/normal/", "src/rules/")
# What moves.
BUILD = {"src/indenter/half_space.cpp", "src/simulation/system/system.cpp", "src/maps/map_file.cpp", "python/scene.cpp"}
# Derivations and their words: which symbols and lines there are.
DERIVE = {"symbolic/analysis/half_space.cpp", "symbolic/analysis/separation.cpp", "symbolic/derivation/meanings.cpp",
          "symbolic/document/appendix.cpp", "symbolic/document/findings.cpp",
          "symbolic/emit/languages/cpp/quantities.cpp", "symbolic/facts/facts.cpp",
          "symbolic/program/quantities.cpp"}
# Drawings, units and which comparisons there are.
SHOW = {"validation/compare/agreement.cpp", "validation/compare/frequency_points.cpp", "validation/compare/indented.cpp",
        "validation/compare/values.cpp", "validation/compare/velocity_comparisons.cpp", "validation/report/answer_figures.cpp",
        "validation/report/explorer_record.cpp", "validation/report/material_page.cpp", "validation/report/plots.cpp",
        "validation/report/system_drawing.cpp"}
# What is made of a network with masses, part by part: the motion, the stiffness, the formula; and their words.
OF_MASSES = {"src/critical/drive_response.cpp", "src/simulation/system/system.cpp", "symbolic/emit/languages/cpp/companions.cpp",
             "symbolic/program/drive_tree.cpp", "validation/report/material_page.cpp"}
WITH_A_REASON = {ASKED: BUILD | DERIVE | SHOW, MASSES: OF_MASSES, MEAN_FORCE: set()}


def asks(text, question=ASKED):
    text = COMMENT.sub("", text)
    return [text.count("\n", 0, found.start()) + 1 for found in question.finditer(text)]


def askers(question):
    """The files that ask, with lines."""
    files = sorted(file for room in ROOMS for file in (ROOT / room).rglob("*.[ch]pp"))
    names = {str(file.relative_to(ROOT)): file for file in files}
    read = {name: asks(file.read_text(), question) for name, file in names.items() if not name.startswith(BEFORE_THE_RULES)}
    return {name: lines for name, lines in read.items() if lines}


class Askers(unittest.TestCase):
    def test_nobody_else_asks(self):
        for question, known in WITH_A_REASON.items():
            with self.subTest(question.pattern):
                self.assertEqual({}, {name: lines for name, lines in askers(question).items() if name not in known})

    def test_those_with_a_reason_still_ask(self):
        for question, known in WITH_A_REASON.items():
            with self.subTest(question.pattern):
                self.assertEqual(set(), known - set(askers(question)))

    def test_a_question_is_seen_and_data_is_not(self):
        self.assertEqual([1], asks("if (problem->indenter) return;\n"))
        self.assertEqual([2], asks("// why\nconst bool may = sweep.problem->separation;"))
        self.assertEqual([1], asks("return problem_->load && problem_->indenter.has_value();"))
        self.assertEqual([], asks("problem->indenter->profile; // problem->separation\nrules::cells_move(problem);"))
        self.assertEqual([1], asks("if (drive.has_masses()) return;", MASSES))
        self.assertEqual([], asks("rules::drive_resonates(problem)", MASSES))
        for text in ("problem->load && !problem->indenter", "!it->load || rules::cells_move(it)"):
            self.assertEqual([1], asks(text, MEAN_FORCE))
        self.assertEqual([], asks("problem->load && problem->indenter; !problem->load && !problem->mount", MEAN_FORCE))


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        for asked in WITH_A_REASON:
            for name, lines in askers(asked).items():
                print(name, *lines)
    else:
        unittest.main(verbosity=2)
