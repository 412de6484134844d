"""What the README shows is what the program prints, to the byte.

A fenced block after the line  <!-- run: vcrit ARGUMENTS -->  is that command's standard output, run in
the project's folder; one after  <!-- file: PATH -->  is that file.

    test_readme.py PROJECT PROGRAM            compares
    test_readme.py PROJECT PROGRAM --update   writes what is printed now into the README
"""

import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT, PROGRAM = Path(sys.argv.pop(1)), sys.argv.pop(1)
PAGE = PROJECT / "README.md"
BLOCK = re.compile(r"^(<!-- (run|file): (.+?) -->\n+```\w*\n)(.*?)^```$", re.MULTILINE | re.DOTALL)
MARKER = re.compile(r"^<!-- (?:run|file): ", re.MULTILINE)


def blocks(page):
    return [block[1:] for block in BLOCK.findall(page)]


def actual(kind, what):
    if kind == "file":
        return (PROJECT / what).read_text()
    command = shlex.split(what)
    assert command[0] == "vcrit", what
    run = subprocess.run([PROGRAM] + command[1:], cwd=PROJECT, capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, f"{what} ended with {run.returncode}: {run.stderr}"
    return run.stdout


def update():
    def renewed(block):
        return block[1] + actual(block[2], block[3]) + "```"

    PAGE.write_text(BLOCK.sub(renewed, PAGE.read_text()))


class Readme(unittest.TestCase):
    maxDiff = None
    page = PAGE.read_text()

    def test_shows_what_is_really_printed(self):
        for kind, what, shown in blocks(self.page):
            with self.subTest(what=what):
                self.assertEqual(shown, actual(kind, what))

    def test_every_marker_has_its_block(self):
        self.assertEqual(len(blocks(self.page)), len(MARKER.findall(self.page)))

    def test_shows_a_scene_its_value_and_its_formula(self):
        shown = [f"{kind} {what.split(' scenes/')[0]}" for kind, what, _ in blocks(self.page)]
        for needed in ["run vcrit eval", "run vcrit derive"]:
            self.assertIn(needed, shown)


if __name__ == "__main__":
    update() if "--update" in sys.argv else unittest.main()
