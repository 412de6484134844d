"""The reference of the public headers: doxygen has nothing to complain of, and its start page leads to
what it names.

    test_reference.py PROJECT BUILD
"""

import html
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, BUILD = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))
# What the start page tells readers to call and include; "..." and file names of examples are neither.
NAMED = re.compile(r"vcrit::(?!vcrit\b|symbolic\b(?!::))\w+(?:::\w+)*(?:\(\))?|(?<!<)vcrit/[\w/]+\.hpp")


def reference(folder, *settings):
    """Runs doxygen into the folder; its exit status and what it says."""
    text = "\n".join([(BUILD / "docs/Doxyfile").read_text(), f"OUTPUT_DIRECTORY = {folder}", *settings])
    run = subprocess.run(["doxygen", "-"], input=text, capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


class Reference(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.outcome = reference(cls.folder)

    def test_has_no_warnings(self):
        self.assertEqual(self.outcome, (0, ""))

    def test_has_a_page_that_says_what_each_header_is_for(self):
        headers = sorted((BUILD / "include/vcrit").rglob("*.hpp"))
        self.assertGreater(len(headers), 40)
        pages = [re.sub(r"<[^>]+>", "", page.read_text()) for page in self.folder.glob("*_8hpp.html")]
        for header in headers:
            first = header.read_text().splitlines()[0].removeprefix("// ")
            words = html.escape(re.split(r"[.:<] ", first)[0].rstrip("."), quote=False)
            self.assertTrue(any(words in page for page in pages), f"{header}: {words}")

    def test_start_page_leads_to_what_it_names(self):
        page = (self.folder / "index.html").read_text()
        linked = set(map(html.unescape, re.findall(r'<a class="el" href="[^"]+"[^>]*>([^<]+)</a>', page)))
        words = re.sub(r"```.*?```", "", (PROJECT / "docs/library.md").read_text(), flags=re.DOTALL)
        named = set(NAMED.findall(words))
        self.assertGreater(len(named), 30)
        self.assertEqual(named - linked, set())

    def test_start_page_names_every_example(self):
        page = (PROJECT / "docs/library.md").read_text()
        for file in (PROJECT / "examples").glob("*.c*"):
            self.assertIn(f"| {file.name} |", page)


class APlantedHeader(unittest.TestCase):
    def complaint(self, text):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "planted.hpp").write_text("// Planted.\n#pragma once\n" + text)
            status, said = reference(folder, f"INPUT = {folder}", "USE_MDFILE_AS_MAINPAGE =")
            self.assertNotEqual(status, 0)
            return said

    def test_with_a_broken_reference_is_found(self):
        self.assertIn("nowhere", self.complaint("/// As \\ref nowhere does.\nint f();\n"))

    def test_with_an_argument_that_is_not_there_is_found(self):
        self.assertIn("absent", self.complaint("/// \\param absent what?\nint f(int present);\n"))


if __name__ == "__main__":
    unittest.main()
