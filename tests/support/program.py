"""What Python tests share: the program run as a user runs it, scenes (scene_text.py), and what a refusal looks like.

A test is started as test_NAME.py PROGRAM [ARGUMENT...], with this folder on PYTHONPATH (tests/CMakeLists.txt).
"""

import csv
import json
import os
import pty
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from scene_text import scene

PROJECT = Path(__file__).resolve().parents[2]
PROGRAM = str(Path(sys.argv.pop(1)).resolve())
PATIENCE = 300  # seconds, several times what the slowest command takes where the machine is busy


def example(name):
    return str(PROJECT / f"scenes/{name}.toml")


def run(*arguments, folder=PROJECT, **options):
    """The program, from the project's folder; numbers among the arguments are written as they print."""
    words = [word if isinstance(word, (bytes, Path)) else str(word) for word in arguments]
    return subprocess.run([PROGRAM, *words], cwd=folder, timeout=PATIENCE,
                          **{"capture_output": True, "text": True} | options)


def unbroken(text):
    """A printed derivation with every equation on one line."""
    return text.replace("\n        ", " ")


def names_in_words(text):
    """g and Z of a printed derivation, which words bring in, each with what it stands for."""
    found = re.findall(r" and (\w+) = [^:\n]+:\n    \1 = (.+)$", text, re.M)
    found += re.findall(r"\sseparated,\sand\s(\w+)\s=\s([^:]+):$", text, re.M)
    return [(name, " ".join(meaning.split())) for name, meaning in found]


def settings(values):
    """{"kn": 3} as --set kn=3"""
    return [word for name, value in values.items() for word in ("--set", f"{name}={value}")]


def rows(table, expected):
    """A table of tests/data, with so many rows: a test over none would pass."""
    with (PROJECT / "tests/data" / table).open() as file:
        found = list(csv.DictReader(file))
    if len(found) != expected:
        raise AssertionError(f"tests/data/{table}: found {len(found)} rows; expected {expected}")
    return found


class Case(unittest.TestCase):
    """With a folder of its own, in which the program runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vcrit-test-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve()

    def run_program(self, *arguments, **options):
        return run(*arguments, **{"folder": self.folder} | options)

    def write(self, text, name="s.toml"):
        """A file in the test's folder."""
        file = self.folder / name
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return file

    def scene(self, *parts, name="s.toml", **changed):
        return self.write(scene(*parts, **changed), name)

    def out(self, *arguments, status=0, **options):
        """What is printed."""
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, status, result.stderr)
        return result.stdout

    def on_terminal(self, *arguments, with_errors=False, **environment):
        """What a terminal of this kind (TERM, NO_COLOR) shows. Unless it shows errors too, there may be none."""
        kept = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "TERM")}
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=theirs, cwd=self.folder, env=kept | environment,
                                   stderr=theirs if with_errors else subprocess.PIPE)
        os.close(theirs)
        shown = b""
        try:
            while part := os.read(ours, 4096):
                shown += part
        except OSError:  # the other end has gone
            pass
        os.close(ours)
        self.assertEqual(process.communicate(timeout=PATIENCE), (None, None if with_errors else b""))
        return shown.decode().replace("\r", "")

    def answer(self, *arguments, status=0, **options):
        """The one object that --json prints."""
        found = json.loads(self.out(*arguments, "--json", status=status, **options))
        self.assertIsInstance(found, dict)
        return found

    def table(self, *arguments):
        """The rows that a sweep writes, as texts by column."""
        out = self.folder / "table.csv"
        self.out("sweep", *arguments, "--out", out)
        return list(csv.DictReader(line for line in out.read_text().splitlines() if not line.startswith("#")))

    def reported(self, subject):
        """What `validate --paper` or `--extremes` finds, all of it as expected, and its page."""
        result = self.run_program("validate", subject, "--out", "out")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "out/index.html\n", ""))
        self.assertEqual(self.written(), {"out/index.html", "out/report.json"})
        report = json.loads((self.folder / "out/report.json").read_text())
        self.assertIs(report["passed"], True)
        return report, (self.folder / "out/index.html").read_text()

    def written(self):
        return {str(file.relative_to(self.folder)) for file in self.folder.rglob("*") if file.is_file()}

    def refused(self, status, arguments, *words, **options):
        """One message with these words, nothing printed and nothing written; the message."""
        before = self.written()
        result = self.run_program(*arguments, **options)
        self.assertEqual((result.returncode, result.stdout), (status, ""), result.stderr)
        errors = [line for line in result.stderr.splitlines() if not line.startswith("vcrit: warning:")]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertRegex(errors[0], "^vcrit: ")
        for word in words:
            self.assertIn(word, errors[0])
        self.assertEqual(self.written(), before)
        return errors[0].removeprefix("vcrit: ")
