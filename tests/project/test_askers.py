"""One question, one answer: whether an indenter presses and whether the contact may open is told by the rulebook.

src/rules/kinds.hpp says what follows from either (cells_move, may_open, Facts::loses_contact, ...). A room behind it that
reads the scene's own words instead answers the same question once more, and the two answers drift apart. Those below have
a reason: they build from the words, or show them.

Run with the project's folder. With --list, prints all who read them.
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
ASKED = re.compile(r"\b(?:problem_?|scene_?)(?:\(\))?(?:->|\.)(?:indenter|separation)\b(?!->)")
COMMENT = re.compile(r"//[^\n]*")
ROOMS = ("src", "symbolic", "validation", "app", "python")
BEFORE_THE_RULES = ("src/base/", "src/linear/", "src/network/", "src/record/", "src/scene/", "src/problem/", "src/stiffness/",
                    "src/modes/", "src/normal/", "src/rules/")
# What moves, and the table of an indenter's profile.
BUILD = {"src/indenter/half_space.cpp", "src/simulation/system/system.cpp", "src/maps/map_file.cpp", "python/scene.cpp"}
# Derivations and their words: which symbols and lines there are.
DERIVE = {"symbolic/analysis/half_space.cpp", "symbolic/analysis/separation.cpp", "symbolic/derivation/loaded.cpp",
          "symbolic/derivation/meanings.cpp", "symbolic/document/appendix.cpp", "symbolic/document/findings.cpp",
          "symbolic/emit/languages/cpp/quantities.cpp", "symbolic/facts/closed_amplitude.cpp", "symbolic/facts/facts.cpp",
          "symbolic/program/quantities.cpp"}
# Drawings, units and which comparisons there are.
SHOW = {"validation/compare/agreement.cpp", "validation/compare/frequency_points.cpp", "validation/compare/indented.cpp",
        "validation/compare/values.cpp", "validation/compare/velocity_comparisons.cpp", "validation/report/answer_figures.cpp",
        "validation/report/explorer_record.cpp", "validation/report/material_page.cpp", "validation/report/plots.cpp",
        "validation/report/system_drawing.cpp"}


def asks(text):
    text = COMMENT.sub("", text)
    return [text.count("\n", 0, found.start()) + 1 for found in ASKED.finditer(text)]


def askers():
    """The files that ask, with lines."""
    files = sorted(file for room in ROOMS for file in (ROOT / room).rglob("*.[ch]pp"))
    names = {str(file.relative_to(ROOT)): file for file in files}
    read = {name: asks(file.read_text()) for name, file in names.items() if not name.startswith(BEFORE_THE_RULES)}
    return {name: lines for name, lines in read.items() if lines}


class Askers(unittest.TestCase):
    def test_nobody_else_asks(self):
        self.assertEqual({}, {name: lines for name, lines in askers().items() if name not in BUILD | DERIVE | SHOW})

    def test_those_with_a_reason_still_ask(self):
        self.assertEqual(set(), (BUILD | DERIVE | SHOW) - set(askers()))

    def test_a_question_is_seen_and_data_is_not(self):
        self.assertEqual([1], asks("if (problem->indenter) return;\n"))
        self.assertEqual([2], asks("// why\nconst bool may = sweep.problem->separation;"))
        self.assertEqual([1], asks("return problem_->load && problem_->indenter.has_value();"))
        self.assertEqual([], asks("problem->indenter->profile; // problem->separation\nrules::cells_move(problem);"))


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        for name, lines in askers().items():
            print(name, *lines)
    else:
        unittest.main(verbosity=2)
