"""`./dev check` (cmake/check_alone.py) finds what a file lacks, although it puts precompiled headers before files: on a
project of a few small files.

Run with the project's folder.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))

# What is right, and beside it files that each break one rule. Several include <string> in any case, so that it is compiled once.
FILES = {
    "text.hpp": """#pragma once
#include <string>
std::string text_of(int number);
""",
    "text.cpp": """#include "text.hpp"
#include <vector>
std::string text_of(int number) { return std::to_string(std::vector<int>{number}.front()); }
""",
    "lacks_include.cpp": """#include "text.hpp"
std::vector<std::string> texts;
""",
    "includes_if.cpp": """#ifdef NEVER
#include <string>
#endif
std::string name;
""",
    "lacks_header.cpp": """#include <string>
std::string text() { return text_of(1); }
""",
    "warns.cpp": """#include "text.hpp"
void warns() { int unused; }
""",
    # What its source file includes after it, or another before it, must not help a header.
    "header_lacks_include.hpp": """#pragma once
void print(const std::string& text);
""",
    "header_lacks_include.cpp": """#include "header_lacks_include.hpp"
#include <string>
void print(const std::string&) {}
""",
    "unbegun.hpp": """#pragma once
inline int first_of(const std::vector<int>& numbers) { return numbers.front(); }
""",
    # Compiled once it would be the same for all.
    "width.hpp": """#pragma once
#include <string>
#ifdef WIDE
inline int wide = 1;
#endif
""",
    "width.cpp": """#define WIDE
#include "width.hpp"
int width() { return wide; }
""",
    # Compiled as its user is, although the macro keeps it out of what is compiled once.
    "of_user.hpp": """#pragma once
#ifndef FOR_user
#error "not for this file"
#endif
""",
    "user.cpp": """#include <string>
#include "of_user.hpp"
std::string used;
""",
    "main.cpp": """#include <vector>
#include "text.hpp"
#include "unbegun.hpp"
int main() { return static_cast<int>(text_of(first_of({1, 2})).size()); }
""",
}
ERRORS = {"lacks_include.cpp:2", "includes_if.cpp:4", "lacks_header.cpp:2", "warns.cpp:2", "header_lacks_include.hpp:2",
          "unbegun.hpp:2"}


def check(project):
    """Exit status of the check, and what it says."""
    done = subprocess.run([sys.executable, "-B", project / "cmake/check_alone.py", project / "build"],
                          capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


class CheckAlone(unittest.TestCase):
    def project(self, files):
        """Those files in src, in a folder of its own."""
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        project = pathlib.Path(place.name).resolve()
        for name in ("cmake", "src", "build"):
            (project / name).mkdir()
        for name in ("check_alone.py", "compiled_once.py"):
            shutil.copy(ROOT / "cmake" / name, project / "cmake")
        for name, text in files.items():
            (project / "src" / name).write_text(text)
        commands = [{"file": str(file), "directory": str(project / "build"),
                     "command": f"g++ -std=c++20 -g -Wall -Werror -DFOR_{file.stem} -I{project}/src -o {file.stem}.o -c {file}"}
                    for folder in ("build", "src") for file in sorted((project / folder).glob("*.cpp"))]
        (project / "build/compile_commands.json").write_text(json.dumps(commands))
        return project

    def assert_faults(self, faults, count, outcome):
        status, text = outcome
        self.assertNotEqual(status, 0)
        self.assertEqual(set(re.findall(r"/src/(\S+:\d+):\d+: error: ", text)), faults, text)
        self.assertIn(f"{len(faults)} of {count} files do not compile on their own", text)

    def test_each_fault_and_no_other(self):
        project = self.project(FILES)
        self.assert_faults(ERRORS, 13, check(project))
        # What has passed is left out until something that it reads is another.
        for name, old, new in (("unbegun.hpp", "once", "once\n#include <vector>"), ("width.hpp", "= 1", '= ""')):
            (project / "src" / name).write_text(FILES[name].replace(old, new))
        outcome = check(project)
        self.assert_faults(ERRORS - {"unbegun.hpp:2"} | {"width.hpp:4"}, 9, outcome)
        again = set(re.findall(r"^\[\d+/\d+\] src/(\S+)$", outcome[1], re.M))
        changed = {"unbegun.hpp", "main.cpp", "width.hpp", "width.cpp"}
        self.assertEqual(again, {error.split(":")[0] for error in ERRORS} | changed)

    def test_without_faults(self):
        made = {"../build/made.cpp": '#include "made.hpp"\nint made = ;\n', "../build/made.hpp": "int made = ;\n"}  # by the build
        outcome = check(self.project({name: FILES[name] for name in ("text.hpp", "text.cpp")} | made))
        self.assertEqual(outcome, (0, "[1/1] src/text.cpp\n"))


unittest.main()
