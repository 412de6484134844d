"""What the program tells the shell about itself: help with examples, man page, completions.

    test_shell.py PROGRAM SHARE     SHARE holds man page and completions as they are installed
"""

import functools
import os
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from pathlib import Path

import completion_drivers
import drivers
from program import PROGRAM, PROJECT

SHARE = Path(sys.argv.pop(1)).resolve()
MAN = SHARE / "man/man1/vcrit.1"
COMMANDS = ["eval", "derive", "generate", "simulate", "critical", "plot", "explore", "sweep", "solve", "fit", "new", "check",
            "validate"]
# "  -h,--help   Print ...", as CLI11 writes options; positionals stand under a heading of their own.
OPTION = re.compile(r"^ {2}((?:-\w,)?--[\w-]+(?:,--[\w-]+)*)(?: (\S.*?))?(?: {2,}|$)", re.MULTILINE)
CHOICES = re.compile(r"^\{(.*)\}")
EXAMPLE = re.compile(r"^    (vcrit .*)$", re.MULTILINE)


def text_of(*command, folder=PROJECT):
    return subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, text=True, check=True).stdout


@functools.cache
def help_of(command):
    return text_of(PROGRAM, *([command] if command else []), "--help")


def options_of(command):
    """All options of a help, as lists of names, and what each takes."""
    return {tuple(names.split(",")): value for names, value in OPTION.findall(help_of(command))}


def names_of(command):
    return {name for names in options_of(command) for name in names}


def choices_of(command):
    """Options whose values are a list."""
    return {name: CHOICES.match(value)[1].split(",") for names, value in options_of(command).items()
            if CHOICES.match(value) for name in names}


class Help(unittest.TestCase):
    def test_lists_the_commands(self):
        listed = re.findall(r"^  (\w+) {2,}", help_of("").split("Subcommands:")[1].split("Examples:")[0], re.MULTILINE)
        self.assertEqual(listed, COMMANDS)

    def test_ends_with_examples_that_run(self):
        for command in ["", *COMMANDS]:
            body, examples = help_of(command).split("\nExamples:\n")
            self.assertIn("Options:", body)
            lines = EXAMPLE.findall(examples)
            self.assertGreaterEqual(len(lines), 1, command)
            self.assertEqual(len(lines) * 2, len(examples.strip().splitlines()), "words above each line")
            for line in lines:
                with self.subTest(line=line), tempfile.TemporaryDirectory() as folder:
                    self.assertTrue(line.startswith(f"vcrit {command}"))
                    self.run_example(line, Path(folder))

    def run_example(self, line, folder):
        (folder / "scenes").symlink_to(PROJECT / "scenes")
        path = f"{Path(PROGRAM).parent}:{os.environ['PATH']}"
        run = subprocess.run(["bash", "-c", line], cwd=folder, env=os.environ | {"PATH": path},
                             capture_output=True, text=True, timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        written = [file for file in folder.iterdir() if file.name != "scenes"]
        self.assertTrue(run.stdout or written, "an example that shows nothing")


class Documents(unittest.TestCase):
    """What docs/commands.md says of options is what the helps say."""

    text = (PROJECT / "docs/commands.md").read_text()
    everywhere = {"--help", "--set", "--digits"}  # told of below the list, once for all commands

    def documented(self, command):
        lines = re.findall(rf"^    vcrit {command} (.*(?:\n {{8,}}.*)*)", self.text.split("| command |")[0], re.MULTILINE)
        return "\n".join(lines)

    def test_name_every_option_and_no_other(self):
        for command in COMMANDS:
            # Of an option with several names one is enough.
            told = set(re.findall(r"--[\w-]+", self.documented(command)))
            options = [{name for name in names if name.startswith("--")} for names in options_of(command)]
            missing = [names for names in options if not names & (told | self.everywhere)]
            self.assertEqual((missing, told - names_of(command)), ([], set()), command)

    def test_list_the_values_of_the_helps(self):
        seen = 0
        for command in COMMANDS:
            told = dict(re.findall(r"(--[\w-]+) ([a-z-]+(?:\|[a-z-]+)+)(?=[\]\s])", self.documented(command)))
            for option, values in told.items():
                self.assertEqual(values.split("|"), choices_of(command)[option], command)
                seen += 1
        self.assertGreaterEqual(seen, 4)  # form, start, over of plot, for

    def test_say_which_commands_take_the_common_options(self):
        few = re.search(r"All commands but (.*?) take `--set", self.text)[1]
        self.assertEqual({c for c in COMMANDS if "--set" not in names_of(c)}, set(re.findall(r"`(\w+)`", few)))
        digits = re.search(r"^(.*) show four digits.*--digits 17", self.text, re.MULTILINE)[1]
        self.assertEqual({c for c in COMMANDS if "--digits" in names_of(c)}, set(re.findall(r"`(\w+)`", digits)))


class Man(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = MAN.read_text()
        cls.page = text_of("mandoc", "-T", "ascii", "-O", "width=200", MAN)
        cls.page = re.sub(r".\x08", "", cls.page)  # bold and underlined by overstriking

    def section(self, command):
        """The roff of the command's section, or of the program's options."""
        heading = f".SS {command}\n" if command else ".SH OPTIONS\n"
        return re.split(r"\n\.S[SH]", self.source.split(heading)[1])[0]

    def options_of(self, command):
        """As of a help: the line below each .TP that has options."""
        tags = [re.sub(r"\\f[BRI]", "", tag).replace("\\-", "-")
                for tag in re.findall(r"^\.TP\n(.*)$", self.section(command), re.MULTILINE)]
        split = [re.fullmatch(r"((?:-\w, )?--[\w-]+(?:, --[\w-]+)*)(?: (.*))?", tag) for tag in tags if tag.startswith("-")]
        return {tuple(tag[1].split(", ")): tag[2] or "" for tag in split}

    def test_is_clean(self):
        self.assertEqual(text_of("mandoc", "-T", "lint", MAN), "")
        run = subprocess.run(["man", "--warnings", "-l", MAN], capture_output=True, text=True,
                             env=os.environ | {"LC_ALL": "C.UTF-8"})
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_has_every_option_and_no_other(self):
        for command in ["", *COMMANDS]:
            self.assertEqual(self.options_of(command), options_of(command), command)

    def test_has_every_command_and_no_other(self):
        commands = self.page.split("\nCOMMANDS\n")[1].split("\nEXIT STATUS\n")[0]
        self.assertEqual(re.findall(r"^   (\w+)$", commands, re.MULTILINE), COMMANDS)

    def test_says_each_exit_status_of_the_documents(self):
        listed = (PROJECT / "docs/commands.md").read_text().split("## Exit status")[1].split("\n#")[0]
        told = self.page.split("\nEXIT STATUS\n")[1].split("\nENVIRONMENT\n")[0]
        self.assertEqual(re.findall(r"^   *(\d+) ", told, re.MULTILINE), re.findall(r"^\| (\d+) \|", listed, re.MULTILINE))

    def test_has_the_sections_that_readers_look_for(self):
        headings = re.findall(r"^[A-Z ]+$", self.page, re.MULTILINE)
        self.assertEqual(headings[-4:], ["EXIT STATUS", "ENVIRONMENT", "EXAMPLES", "SEE ALSO"])
        self.assertNotIn("Examples:", self.page.split("\nEXAMPLES\n")[1])

    def test_shows_the_examples_of_the_help(self):
        for command in ["", *COMMANDS]:
            for line in EXAMPLE.findall(help_of(command)):
                self.assertIn(line, self.page)

    def test_is_what_the_program_prints(self):
        self.assertEqual(text_of(PROGRAM, "--man"), MAN.read_text())
        for shell, file in [("bash", "bash-completion/completions/vcrit"), ("zsh", "zsh/site-functions/_vcrit")]:
            self.assertEqual(text_of(PROGRAM, "--completion", shell), (SHARE / file).read_text())


class Completion(unittest.TestCase):
    """The same questions for both shells, which ask the program."""

    @classmethod
    def setUpClass(cls):
        path = os.environ["PATH"]
        os.environ["PATH"] = f"{Path(PROGRAM).parent}:{path}"
        cls.addClassCleanup(os.environ.update, PATH=path)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        for file in ["pad.toml", "pin.toml", "notes.txt"]:
            (cls.folder / file).write_text("")
        (cls.folder / "some scenes").mkdir()

    def bash(self, line):
        words = line.replace("=", " = ").split(" ") if "--over" not in line else line.split(" ")
        return completion_drivers.bash(SHARE / "bash-completion/completions/vcrit", words, self.folder)

    def zsh(self, line):
        return completion_drivers.zsh(SHARE / "zsh/site-functions", line, self.folder)

    def offered(self, line, expected, of=lambda words: words):
        for shell in [self.bash, self.zsh]:
            with self.subTest(line=line, shell=shell.__name__):
                self.assertEqual(of(shell(line)), sorted(expected))

    def test_of_commands(self):
        self.offered("vcrit ", COMMANDS, lambda words: sorted(word for word in words if word[0] != "-"))
        self.offered("vcrit si", ["simulate"])

    def test_of_options(self):
        for command in COMMANDS:
            # zsh offers no short option where a long one is begun.
            expected = {name for name in names_of(command) if name.startswith("--")}
            self.offered(f"vcrit {command} --", expected)
        self.offered("vcrit --", {name for name in names_of("") if name.startswith("--")})
        self.offered("vcrit simulate pad.toml --velocity-", ["--velocity-ratio"])

    def test_of_values(self):
        seen = 0
        for command in ["", *COMMANDS]:
            for option, values in choices_of(command).items():
                self.offered(f"vcrit {command} {option} ".replace("  ", " "), values)
                seen += 1
        self.assertGreaterEqual(seen, 7)  # completion, format, form, language, method, start, quantity
        self.offered("vcrit simulate --method=mo", ["moreau"])
        self.offered("vcrit simulate --method m", ["moreau", "msbdf"])
        self.offered("vcrit generate --language ", list(drivers.LANGUAGES))
        self.offered("vcrit plot --over fre", ["frequency"])

    def test_of_scenes_and_folders(self):
        scenes = ["pad.toml", "pin.toml", "some scenes"]
        self.offered("vcrit eval ", scenes, lambda words: [word.rstrip("/") for word in words])
        self.offered("vcrit eval pi", ["pin.toml"])
        self.offered("vcrit derive pad.toml --equal pi", ["pin.toml"])
        self.offered("vcrit validate pad.toml pi", ["pin.toml"])
        self.offered("vcrit generate pad.toml --out ", ["some scenes"], lambda words: [word.rstrip("/") for word in words])
        self.offered("vcrit fit no", ["notes.txt"])

    def test_of_zsh_may_be_sourced(self):
        script = SHARE / "zsh/site-functions/_vcrit"
        self.assertEqual(completion_drivers.zsh(self.folder, "vcrit si", self.folder, script), ["simulate"])
        self.assertEqual(completion_drivers.zsh(self.folder, "vcrit si", self.folder), [])

    def test_of_names_in_a_scene(self):
        (self.folder / "kelvin.toml").write_text((PROJECT / "scenes/kelvin.toml").read_text())
        self.addCleanup((self.folder / "kelvin.toml").unlink)
        self.offered("vcrit eval kelvin.toml --set am", ["amplitude="])
        self.offered("vcrit sweep kelvin.toml --over vel", ["velocity=", "velocity_ratio="])
        self.offered("vcrit sweep kelvin.toml --over freq", ["frequency="])
        self.offered("vcrit eval pad.toml --set ", [])  # no scene

    def test_of_what_nobody_can_know(self):
        self.offered("vcrit simulate pad.toml --velocity ", [])

    def test_of_further_values(self):
        line = "vcrit sweep pad.toml --quantity critical_velocity fr"
        self.offered(line, ["friction_ratio", "friction_ratio_error"], lambda words: [word for word in words if not word.endswith(".toml")])

    def test_is_silent_where_the_program_is_gone(self):
        with unittest.mock.patch.dict(os.environ, PATH="/usr/bin:/bin"):
            self.offered("vcrit si", [])

    def test_goes_on_behind_a_value(self):
        self.offered("vcrit simulate pad.toml --method exact --sta", ["--start"])


if __name__ == "__main__":
    unittest.main()
