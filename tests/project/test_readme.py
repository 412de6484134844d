"""What the README and the pages of docs show is what the program prints, to the byte; they name all quantities of sweeps.

In its console blocks, lines after "$ " are commands, run in the project's folder, and the lines up to
the next one are what each prints on standard output. The C++ program of docs/evaluators.md is compiled against the
evaluator that the line before it generates, and prints the text block that follows. The picture is that of `vcrit plot`.

    test_readme.py PROJECT PROGRAM            compares
    test_readme.py PROJECT PROGRAM --update   writes what is printed now into them
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, PROGRAM = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))
README, EVALUATORS, PICTURE = PROJECT / "README.md", PROJECT / "docs/evaluators.md", PROJECT / "docs/friction.svg"
PAGES = [README, *sorted((PROJECT / "docs").glob("*.md"))]
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


def drawn():
    with tempfile.TemporaryDirectory() as folder:
        printed(f"vcrit plot scenes/zener.toml --out {folder}/friction.svg")
        return (Path(folder) / "friction.svg").read_text()


def update():
    for page in PAGES:
        page.write_text(BLOCK.sub(lambda block: session(block[0]), page.read_text()))
    text = EVALUATORS.read_text()
    program = PROGRAM_BLOCK.search(text)
    output = printed_by_program(*program.groups()[:3])
    EVALUATORS.write_text(text[: program.start(4)] + output + text[program.end(4):])
    PICTURE.write_text(drawn())


class Readme(unittest.TestCase):
    maxDiff = None
    blocks = {page: BLOCK.findall(page.read_text()) for page in PAGES}

    def test_shows_what_is_really_printed(self):
        for page, blocks in self.blocks.items():
            for block in blocks:
                with self.subTest(page=page, commands=commands(block)):
                    self.assertEqual(block, session(block))

    def test_shows_a_scene_its_value_and_its_formula(self):
        shown = [command for block in self.blocks[README] for command in commands(block)]
        for needed in ["cat scenes/", "vcrit eval scenes/", "vcrit derive scenes/"]:
            self.assertTrue(any(command.startswith(needed) for command in shown), needed)

    def test_shows_a_program_that_prints_what_it_says(self):
        generate, name, source, output = PROGRAM_BLOCK.search(EVALUATORS.read_text()).groups()
        self.assertEqual(output, printed_by_program(generate, name, source))

    def test_pages_about_sweeps_name_every_quantity(self):
        names = re.search(r"--quantity \{([^}]*)\}", printed("vcrit sweep --help"))[1].split(",")
        self.assertGreater(len(names), 5)
        for page in ["commands.md", "maps.md"]:
            text = (PROJECT / "docs" / page).read_text()
            for name in names:
                self.assertIn(f"`{name}`", text, page)

    def test_every_line_belongs_to_a_command(self):
        for block in sum(self.blocks.values(), []):
            self.assertTrue(block.startswith("$ "), block)

    def test_shows_the_picture_of_the_program_on_a_page_that_one_reads_at_once(self):
        text = README.read_text()
        self.assertIn("](docs/friction.svg)", text)
        self.assertEqual(PICTURE.read_text(), drawn())
        self.assertLessEqual(text.count("\n"), 150)


if __name__ == "__main__":
    update() if "--update" in sys.argv else unittest.main()
