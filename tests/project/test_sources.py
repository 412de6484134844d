"""What holds for every source file: no unfinished work left behind, none too long to read."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv.pop(1))
FOLDERS = ["src", "symbolic", "validation", "app", "python", "bench", "examples", "cmake", "scenes", "docs", "tests", ".ci"]
SUFFIXES = {".cpp", ".hpp", ".h", ".py", ".txt", ".cmake", ".toml", ".md", ".js", ".mjs", ".css", ".html"}
UNFINISHED = re.compile(r"\b(TO" + r"DO|FIX" + r"ME|X" + r"XX)\b")
LONGEST = 400


def files(root):
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.is_file() and file.suffix in SUFFIXES:
                yield file


def unfinished(root):
    return [
        f"{file.relative_to(root)}:{number}: {line.strip()}"
        for file in files(root)
        for number, line in enumerate(file.read_text().splitlines(), 1)
        if UNFINISHED.search(line)
    ]


def too_long(root):
    return [
        f"{file.relative_to(root)}: {lines} lines"
        for file in files(root)
        if file.suffix in {".cpp", ".hpp", ".h", ".py", ".js", ".mjs", ".css"}
        and (lines := len(file.read_text().splitlines())) > LONGEST
    ]


def without_opening_comment(root):
    return [
        str(file.relative_to(root))
        for file in files(root)
        if file.suffix in {".hpp", ".cpp"}
        and file.parts[len(root.parts)] != "tests"
        and not file.with_suffix(".hpp").exists()
        and not file.read_text().startswith("// ")
    ]


# Strings of C++, raw ones too; comments may say <b> as they like.
STRING = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<end>[^(]*)\((?P<raw>.*?)\)(?P=end)"|"(?P<plain>(?:[^"\\\n]|\\.)*)"', re.S)
HTML = ("html head body meta title style script link header main nav section div span p a ul ol li table thead tbody tr "
        "th td h1 h2 h3 figure figcaption details summary small strong em b i sub sup code pre button input label output "
        "svg g path circle text tspan").split()
PRODUCT = ["src", "symbolic", "validation", "app", "python"]


def tag(names):
    return re.compile(rf"</?(?:{'|'.join(names)})(?:\s+[a-z-]+=|\s*/?>)")


def tags(root):
    """Tags in strings of C++: pages are made of templates, which escape. The symbolic part prints MathML as it prints
    LaTeX and text."""
    return [
        f"{file.relative_to(root)}: {found[0][:60]}"
        for folder in PRODUCT
        for file in sorted((root / folder).rglob("*.[ch]pp"))
        for found in STRING.finditer(file.read_text())
        if "#include" not in found[0]
        and tag(HTML if folder == "symbolic" else [*HTML, "m[a-z]+"]).search(found["raw"] or found["plain"] or "")
    ]


# Options of commands belong to app/, keywords of Python to python/: libraries name arguments by keys
# (src/base/arguments.hpp). A whole command, "vcrit generate ...", is a text to be typed.
LIBRARIES = ["src", "symbolic", "validation"]
OPTION = re.compile(r"(^|[^-\w])--[a-z]{2}")
WHOLE_COMMANDS = {"symbolic/emit/options.cpp", "validation/report/report_json.cpp"}
COMMANDS_OF_OTHERS = {'"--version"'}  # of compilers


def options(root):
    return [
        f"{file.relative_to(root)}: {found[0][:60]}"
        for folder in LIBRARIES
        for file in sorted((root / folder).rglob("*.[ch]pp"))
        if str(file.relative_to(root)) not in WHOLE_COMMANDS
        for found in STRING.finditer(file.read_text())
        if found[0] not in COMMANDS_OF_OTHERS
        and OPTION.search(found["plain"] or "") and "vcrit " not in found["plain"]
    ]


class Sources(unittest.TestCase):
    def test_are_finished(self):
        self.assertEqual(unfinished(PROJECT), [])

    def test_can_be_read_in_a_sitting(self):
        self.assertEqual(too_long(PROJECT), [])

    def test_say_what_they_are_for(self):
        self.assertEqual(without_opening_comment(PROJECT), [])

    def test_have_no_tags(self):
        self.assertEqual(tags(PROJECT), [])

    def test_of_libraries_name_no_options(self):
        self.assertEqual(options(PROJECT), [])

    def test_are_found_at_all(self):
        self.assertGreater(sum(1 for _ in files(PROJECT)), 50)


class APlantedTree(unittest.TestCase):
    def test_shows_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "src").mkdir()
            (root / "src/long.cpp").write_text("// Long.\n" * (LONGEST + 1))
            (root / "src/open.hpp").write_text("int f();  // TO" + "DO: more\n")
            self.assertEqual(too_long(root), [f"src/long.cpp: {LONGEST + 1} lines"])
            (root / "src/page.cpp").write_text('// A <b>bold</b> page.\nauto a = "<p class=\\"x\\">";\n'
                                               'auto b = R"(<li>)"; std::vector<double> c; auto d = "a <b, c> d";\n')
            self.assertEqual(tags(root), ['src/page.cpp: "<p class=\\"x\\">"', 'src/page.cpp: R"(<li>)"'])
            (root / "src/option.cpp").write_text('// As for --set.\nauto a = "give --to"; auto b = "run vcrit eval --json"; --c;\n'
                                                 'auto d = "`to`, a -- b, --"; auto e = "--velocity-ratio";\n')
            self.assertEqual(options(root), ['src/option.cpp: "give --to"', 'src/option.cpp: "--velocity-ratio"'])
            self.assertEqual(unfinished(root), ["src/open.hpp:1: int f();  // TO" + "DO: more"])


if __name__ == "__main__":
    unittest.main()
