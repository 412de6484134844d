"""What the README shows is what the program prints, to the byte.

In its console blocks, lines after "$ " are commands, run in the project's folder, and the lines up to
the next one are what each prints on standard output. Its C++ program is compiled against the evaluator
that the line before it generates, and prints the text block that follows.

    test_readme.py PROJECT PROGRAM            compares
    test_readme.py PROJECT PROGRAM --update   writes what is printed now into the README
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, PROGRAM = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))
PAGE = PROJECT / "README.md"
BLOCK = re.compile(r"(?<=^```console\n)(.*?)(?=^```$)", re.MULTILINE | re.DOTALL)
PROGRAM_BLOCK = re.compile(
    r"    vcrit (generate .* --out) DIR (--name \w+)\n[^`]*```cpp\n([^`]*)```[^`]*```text\n([^`]*)```")
COMMAND = re.compile(r"^\$ (.*)\n", re.MULTILINE)


def commands(block):
    """The commands of a block, in order."""
    return COMMAND.findall(block)


def printed(command):
    path = f"{PROGRAM.resolve().parent}:{os.environ.get('PATH', '')}"
    run = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command],
        cwd=PROJECT, env=os.environ | {"PATH": path}, capture_output=True, text=True, timeout=60,
    )
    if run.returncode != 0:
        raise RuntimeError(f"{command} ended with {run.returncode}: {run.stderr}")
    return run.stdout


def session(block):
    """The block as it would be written today."""
    return "".join(f"$ {command}\n{printed(command)}" for command in commands(block))


def printed_by_program(generate, name, source):
    """What the C++ program prints, compiled in a folder of its own beside the generated header."""
    with tempfile.TemporaryDirectory() as folder:
        printed(f"vcrit {generate} {folder} {name}")
        (Path(folder) / "main.cpp").write_text(source)
        compiler = os.environ.get("CXX", "c++")
        return printed(f"cd {folder} && {compiler} -std=c++20 -Wall -Wextra -Werror main.cpp && ./a.out")


def update():
    page = BLOCK.sub(lambda block: session(block[0]), PAGE.read_text())
    program = PROGRAM_BLOCK.search(page)
    output = printed_by_program(*program.groups()[:3])
    PAGE.write_text(page[: program.start(4)] + output + page[program.end(4):])


class Readme(unittest.TestCase):
    maxDiff = None
    blocks = BLOCK.findall(PAGE.read_text())

    def test_shows_what_is_really_printed(self):
        for block in self.blocks:
            with self.subTest(commands=commands(block)):
                self.assertEqual(block, session(block))

    def test_shows_a_scene_its_value_and_its_formula(self):
        shown = [command for block in self.blocks for command in commands(block)]
        for needed in ["cat scenes/", "vcrit eval scenes/", "vcrit derive scenes/"]:
            self.assertTrue(any(command.startswith(needed) for command in shown), needed)

    def test_shows_a_program_that_prints_what_it_says(self):
        generate, name, source, output = PROGRAM_BLOCK.search(PAGE.read_text()).groups()
        self.assertEqual(output, printed_by_program(generate, name, source))

    def test_every_line_belongs_to_a_command(self):
        for block in self.blocks:
            self.assertTrue(block.startswith("$ "), block)


if __name__ == "__main__":
    update() if "--update" in sys.argv else unittest.main()
