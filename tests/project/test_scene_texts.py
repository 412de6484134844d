"""One builder of scenes: a test says what is particular to its scene, and tests/support/scene_text.hpp or scene_text.py
writes the rest.

A scene typed out in a test repeats the format of files in one place more. Those below have a reason.

Run with the project's folder. With --list, prints all who type one.
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
# The section that every scene has and the end of its line: in a text, escaped, or one of a list of texts.
TYPED = re.compile(r"""\[contact\](?:\n|\\n|["'],\s*f?["'])""")
# How a scene's text is read: its sections, its spellings, and the lines and columns of complaints.
READ = {"tests/app/test_check.py", "tests/scene/test_arguments.cpp", "tests/scene/test_complaints.cpp",
        "tests/scene/test_expressions.cpp", "tests/scene/test_indenter_section.cpp", "tests/scene/test_measured_contact.cpp",
        "tests/scene/test_named_stiffness.cpp", "tests/scene/test_rational_stiffness.cpp", "tests/scene/test_receptance.cpp",
        "tests/scene/test_scene.cpp", "tests/scene/test_spelled_names.cpp"}
# Texts that were written to do harm, or by chance.
HOSTILE = {"tests/app/test_hostile.py", "tests/app/test_hostile_text.py", "tests/load/draw.py"}
# A table in the place of the normal network.
MEASURED = {"tests/critical/test_log_derivative.cpp"}
# One line more in a scene of the project.
CHANGED = {"tests/app/test_drives.py", "tests/app/test_faults.py", "tests/app/test_json.py", "tests/python/test_questions.py",
           "tests/python/test_scene.py"}
WITH_A_REASON = READ | HOSTILE | MEASURED | CHANGED


def typed(text):
    return [text.count("\n", 0, found.start()) + 1 for found in TYPED.finditer(text)]


def typists():
    """The files that type scenes, with lines."""
    files = sorted(file for kind in ("*.[ch]pp", "*.py") for file in (ROOT / "tests").rglob(kind))
    found = {str(file.relative_to(ROOT)): typed(file.read_text()) for file in files if file != pathlib.Path(__file__)}
    return {name: lines for name, lines in found.items() if lines}


class SceneTexts(unittest.TestCase):
    def test_no_other_test_types_one(self):
        self.assertEqual({}, {name: lines for name, lines in typists().items() if name not in WITH_A_REASON})

    def test_those_with_a_reason_still_do(self):
        self.assertEqual(set(), WITH_A_REASON - set(typists()))

    def test_a_scene_is_seen_and_a_message_is_not(self):
        section = "[" + "contact]"
        self.assertEqual([2], typed(f'text = """title = "A pad"\n{section}\nnormal = "k"\n"""'))
        self.assertEqual([1], typed(f'parse_scene("{section}\\nnormal = \\"k\\"\\n")'))
        self.assertEqual([1], typed(f'lines = ["{section}", "poisson = 0.3"]'))
        self.assertEqual([], typed(f'"separation = true in {section}"'))


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        for name, lines in typists().items():
            print(name, *lines)
    else:
        unittest.main(verbosity=2)
