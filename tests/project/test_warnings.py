"""Every source of the project is compiled with the promised warnings, as errors; clang-tidy's are errors too."""

import json
import re
import shlex
import sys
import unittest
from pathlib import Path

PROJECT, BUILD = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))
PROMISED = {"-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"}
# False alarms of GCC 12, see cmake/warnings.cmake.
ALLOWED_OFF = {"-Wno-maybe-uninitialized", "-Wno-restrict", "-Wno-stringop-overread"}
SILENT = re.compile(r"#\s*pragma\s+(GCC|clang)\s+diagnostic|#\s*pragma\s+GCC\s+system_header")
# Text of generated code: clang says where it did not vectorise a loop that need not be.
WRITES_CODE = {"symbolic/emit/languages/cpp/arithmetic.hpp"}
FOLDERS = ["src", "symbolic", "validation", "app", "python", "bench", "examples", "tests"]


def lacking(command):
    """What is wrong with a compiler's command."""
    words = set(shlex.split(command))
    silenced = {word for word in words if word == "-w" or word.startswith("-Wno-")} - ALLOWED_OFF
    return sorted(PROMISED - words) + sorted(silenced)


def sources(file):
    """The files of the project that a command compiles: `file`, or those that a unit of many includes."""
    included = re.findall(r'^#include "(.*)"$', Path(file).read_text(), re.M) if file.endswith("_cxx.cxx") else []
    return included or [file]


class Warnings(unittest.TestCase):
    def test_are_errors_in_every_command(self):
        commands = [entry for entry in json.loads((BUILD / "compile_commands.json").read_text())
                    if Path(entry["file"]).suffix in {".cpp", ".cxx", ".c"}]
        compiled = {Path(file).relative_to(PROJECT) for entry in commands for file in sources(entry["file"])}
        product = {file.relative_to(PROJECT) for folder in ("src", "symbolic", "app")
                   for file in (PROJECT / folder).rglob("*.cpp")}
        self.assertGreater(len(product), 200)
        self.assertEqual(product - compiled, set())
        self.assertEqual([(entry["file"], lacking(entry["command"])) for entry in commands
                          if lacking(entry["command"])], [])

    def test_are_not_silenced_in_a_source(self):
        files = [file for folder in FOLDERS for ending in ("*.cpp", "*.hpp", "*.c")
                 for file in (PROJECT / folder).rglob(ending)]
        self.assertGreater(len(files), 600)
        found = {str(file.relative_to(PROJECT)) for file in files if SILENT.search(file.read_text())}
        self.assertEqual(found, WRITES_CODE)

    def test_of_clang_tidy_are_errors(self):
        self.assertIn("WarningsAsErrors: '*'", (PROJECT / ".clang-tidy").read_text().splitlines())

    def test_a_lack_would_be_seen(self):
        complete = "c++ " + " ".join(sorted(PROMISED | ALLOWED_OFF))
        self.assertEqual(lacking(complete), [])
        self.assertEqual(lacking(complete.replace(" -Wshadow", "") + " -Wno-shadow"), ["-Wshadow", "-Wno-shadow"])
        self.assertEqual(lacking(complete + " -w"), ["-w"])


if __name__ == "__main__":
    unittest.main()
