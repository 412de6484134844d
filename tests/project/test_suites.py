"""Every test case of C++ runs: in a suite of its file's name, which an entry of ctest's names."""

import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT, BUILD = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))
TESTS = PROJECT / "tests"
BEGIN = re.compile(r"^BOOST_AUTO_TEST_SUITE\((\w+)\)$", re.MULTILINE)
END = re.compile(r"^BOOST_AUTO_TEST_SUITE_END\(\)$", re.MULTILINE)
CASE = re.compile(r"^(BOOST_\w*TEST_CASE\w*|RC_BOOST_\w*PROP)\(", re.MULTILINE)


def fault(name, text):
    """What is wrong with the suite of test_NAME.cpp."""
    begins, ends = list(BEGIN.finditer(text)), list(END.finditer(text))
    if [begin[1] for begin in begins] != [name] or len(ends) != 1:
        return f"{name}: expected one suite, {name}"
    cases = [case.start() for case in CASE.finditer(text)]
    if not cases or cases[0] < begins[0].start() or cases[-1] > ends[0].start():
        return f"{name}: no cases, or some outside the suite"
    return None


def entries():
    """The entries of ctest's: name to words of the command, none where its program is not built."""
    printed = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], check=True, text=True,
                             stdout=subprocess.PIPE).stdout
    return {test["name"]: test.get("command", []) for test in json.loads(printed)["tests"]}


def reads_without_counting(text):
    """Whether a test opens a table of tests/data itself, so that it passes over none of its rows."""
    return bool(re.search(r"stream\s+\w+[({]\s*VCRIT_TEST_DATA[^;]*\.csv", text))


class Suites(unittest.TestCase):
    def setUp(self):
        self.files = {str(file.relative_to(TESTS).with_suffix("")): file for file in TESTS.rglob("test_*.cpp")}

    def test_bear_their_files_names(self):
        self.assertGreater(len(self.files), 100)
        faults = [fault(file.stem, file.read_text()) for file in self.files.values()]
        self.assertEqual([each for each in faults if each], [])

    def test_are_all_run(self):
        commands = entries()
        self.assertEqual(sorted(set(self.files) - set(commands)), [])
        self.assertEqual([name for name, file in self.files.items()
                          if commands[name] and commands[name][1:] != [f"--run_test={file.stem}"]], [])

    def test_that_begin_first_are_there(self):
        *lines, end = (TESTS / "costs.txt").read_text().splitlines()
        self.assertEqual(end, "---")
        names = [name for name, runs, seconds in map(str.split, lines) if int(runs) == 1 and float(seconds) > 0]
        self.assertEqual(len(names), len(lines))
        with_python = {name for name in names if name.startswith(("python/", "matrix/"))}  # where the module is built
        self.assertEqual(sorted(set(names) - set(entries()) - with_python), [])

    # One that has it runs again after each change of whatever file.
    def test_have_the_projects_folder_only_to_read_sources(self):
        rooms = {name.split("/")[0] for name, command in entries().items() if str(PROJECT) in command}
        self.assertIn("project", rooms)
        self.assertLessEqual(rooms, {"consumer", "project"})

    # tests/support/table.hpp
    def test_count_the_rows_of_tables(self):
        self.assertTrue(reads_without_counting('std::ifstream file(VCRIT_TEST_DATA "/a.csv");'))
        self.assertFalse(reads_without_counting('test::rows_of("a.csv", 3)'))
        self.assertEqual([str(file) for ending in ["*.cpp", "*.hpp"] for file in TESTS.rglob(ending)
                          if reads_without_counting(file.read_text())], [])

    # What libFuzzer reads: comments, or [name=]"text" with no other escapes. Of a dictionary with a fault it reads nothing.
    def test_dictionaries_of_fuzz_targets_are_read(self):
        line = re.compile(r'(#.*|\w*=?"([^"\\]|\\["\\]|\\x[0-9A-Fa-f]{2})+")?')
        self.assertIsNone(line.fullmatch(r'"a\nb"'))
        files = list((TESTS / "fuzz" / "dictionaries").glob("*.dict"))
        self.assertGreater(len(files), 4)
        self.assertEqual([f"{file.name}:{i}" for file in files for i, text in enumerate(file.read_text().splitlines(), 1)
                          if not line.fullmatch(text)], [])

    def test_a_fault_would_be_seen(self):
        whole = "BOOST_AUTO_TEST_SUITE(test_a)\nBOOST_AUTO_TEST_CASE(x) {}\nBOOST_AUTO_TEST_SUITE_END()\n"
        self.assertIsNone(fault("test_a", whole))
        self.assertIsNotNone(fault("test_b", whole))
        self.assertIsNotNone(fault("test_a", whole + "BOOST_FIXTURE_TEST_CASE(y, F) {}\n"))
        self.assertIsNotNone(fault("test_a", whole.replace("BOOST_AUTO_TEST_CASE", "//")))
        self.assertIsNotNone(fault("test_a", whole + whole))


if __name__ == "__main__":
    unittest.main()
