"""--json of every command: one object on standard output, with the keys that docs/json.md tells of."""

import json
import os
import re
import unittest
from pathlib import Path

import drivers
from program import PROJECT, Case, example

ELASTIC, KELVIN = example("elastic"), example("kelvin")
PAD = str(PROJECT / "scenes/measured_pad.csv")
CALLS = {
    "derive": [KELVIN],
    "eval": [KELVIN],
    "generate": [KELVIN, "--out", "out"],
    "simulate": [KELVIN, "--velocity-ratio", "0.5"],
    "critical": [KELVIN],
    "plot": [KELVIN],
    "explore": [KELVIN, "--out", "page.html"],
    "sweep": [KELVIN, "--over", "velocity_ratio=lin:0.5:1:2", "--quantity", "friction_ratio", "--out", "out.csv"],
    "solve": [KELVIN, "--for", "velocity", "--friction-ratio", "0.8"],
    "fit": [PAD, "--out", "pad.toml"],
    "new": [],
    "check": [KELVIN],
    "validate": ["--paper", "--out", "out"],
}


class Json(Case):
    def test_every_command_has_it(self):
        listed = re.findall(r"^  (\w+) {2,}", self.run_program("--help").stdout.split("Subcommands:")[1], re.MULTILINE)
        self.assertEqual(set(listed), set(CALLS))
        for command, arguments in CALLS.items():
            self.assertIn("--json", self.run_program(command, "--help").stdout)
            self.answer(command, *arguments)

    def test_every_key_is_in_the_documents(self):
        told = (PROJECT / "docs/json.md").read_text()
        told += (PROJECT / "docs/design.md").read_text()  # solve and fit
        for command, arguments in CALLS.items():
            for key in self.answer(command, *arguments):
                self.assertIn(f"`{key}`", told, command)

    def test_wrong_input_leaves_standard_output_empty(self):
        for command, arguments in CALLS.items():
            if command == "new":  # reads nothing
                continue
            ended = self.run_program(command, *["absent.toml" if word in (KELVIN, PAD) else word for word in arguments], "--json",
                                         *(["absent.toml"] if command == "validate" else []))
            self.assertEqual((ended.returncode, ended.stdout), (2, ""), command)

    def failure(self, *arguments, status=2):
        ended = self.run_program(*arguments, "--json")
        self.assertEqual((ended.returncode, ended.stdout), (status, ""))
        told = json.loads(ended.stderr)
        self.assertEqual(told["status"], status)
        self.assertEqual(list(told)[:6], ["status", "message", "place", "found", "expected", "advice"])
        return told

    def test_a_failure_is_one_object_on_standard_error(self):
        text = Path(KELVIN).read_text()
        scene = self.write(text.replace("coefficient", "koefficient", 1))
        line = 1 + text[:text.index("coefficient")].count("\n")
        for command, arguments in CALLS.items():
            if KELVIN not in arguments or command == "check":  # whose answer it is
                continue
            wrong = [command, *[str(scene) if word == KELVIN else word for word in arguments]]
            told = self.failure(*wrong)
            self.assertEqual(told["place"], {"file": str(scene), "line": line, "column": 1}, command)
            self.assertIn("koefficient", told["found"])
            self.refused(2, wrong, told["message"])
        told = self.failure("fit", "absent.csv", "--out", "pad.toml")
        self.assertEqual(told["place"], {"file": "absent.csv"})
        told = self.failure("validate", KELVIN, "--paper", "--out", "out")
        self.assertEqual(told["found"], "scene files as well")

    def test_a_failure_of_the_model_and_of_the_command_line(self):
        told = self.failure("generate", example("separation"), "--out", "out", status=3)
        self.assertIn("for an evaluator of the closed contact", told["advice"])
        self.assertTrue(told["message"].endswith(told["advice"]))
        self.assertIsNone(told["place"])
        for words in (["--frobnicate"], ["eval", KELVIN, "--frobnicate"], ["eval"], ["simulate", KELVIN]):
            told = self.failure(*words)
            self.assertIn("--help", told["advice"])
            self.assertEqual(told["place"], {"file": "command line"})
        for words, place, found, expected in (
                (["eval", KELVIN, "--frobnicate"], "command line", "--frobnicate", "--help"),
                (["eval"], "command line", "no SCENE", "SCENE"),
                (["generate", KELVIN, "--out", "g", "--language", "ada"], "--language", "ada", "one of {c++,"),
                (["derive", KELVIN, "--budget", "few"], "--budget", "few", "a number of terms above 0"),
                (["solve", KELVIN, "--for", "velocity", "--friction-ratio", "half"], "--friction-ratio", '"half"',
                 "a ratio below 1: 0.8 or 80%"),
                (["generate", KELVIN, "--out", "--quantities"], "--out", "--quantities", "a value (./--quantities")):
            told = self.failure(*words)
            self.assertEqual((told["place"], told["found"]), ({"file": place}, found))
            self.assertIn(expected, told["expected"])
        self.assertFalse((self.folder / "--quantities").exists())

    def test_warnings_of_a_failure_stand_in_its_object(self):
        scene = self.write(Path(KELVIN).read_text().replace("[contact]", '[contact]\nfitted_range = ["1 Hz", "2 Hz"]', 1))
        told = self.failure("solve", scene, "--for", "velocity", "--friction-ratio", "0.001", status=3)
        self.assertEqual(len(told["warnings"]), 1)
        self.assertIn("vcrit: warning: ", self.run_program("eval", scene, "--json").stderr)

    def test_names_that_steer_a_terminal_are_escaped(self):
        told = self.failure("eval", "\u202e\x1b[31m.toml")
        self.assertEqual(told["place"]["file"], "\u202e\x1b[31m.toml")
        raw = self.run_program("eval", "\u202e\x1b[31m.toml", "--json").stderr
        self.assertNotIn("\u202e", raw)
        self.assertNotIn("\x1b", raw)

    def test_derive_is_its_format(self):
        self.assertEqual(self.out("derive", KELVIN, "--json"), self.out("derive", KELVIN, "--format", "json"))

    def test_derive_compares(self):
        self.assertTrue(self.answer("derive", KELVIN, "--equal", KELVIN)["equal"])
        self.assertFalse(self.answer("derive", KELVIN, "--equal", ELASTIC, status=1)["equal"])

    def test_generate_tells_what_it_wrote(self):
        result = self.answer("generate", KELVIN, "--out", "lib", "--name", "pad", "--quantities")
        self.assertEqual(result["language"], "c++")
        self.assertEqual(result["main"], ["lib/pad.hpp", "lib/pad_quantities.hpp"])
        self.assertEqual(set(result["files"]), self.written())
        self.assertGreater(len(result["files"]), 4)

    def test_generate_in_other_languages(self):
        for language, row in drivers.LANGUAGES.items():
            if language == "c++":
                continue
            result = self.answer("generate", KELVIN, "--out", language, "--language", language)
            file = f"{language}/critical.{row['file']}"
            self.assertEqual(result, {"language": language, "main": [file], "files": [file]})
            self.assertIn(file, self.written())

    def check_validation(self, result, by_subject):
        """`by_subject`: the comparisons in report.json."""
        self.assertEqual(set(result["files"]), self.written())
        self.assertEqual(result["page"], "out/index.html")
        found = [tuple(one[key] for key in ["subject", "key", "name", "outcome"]) for one in result["comparisons"]]
        expected = [(subject, one["key"], one["name"], one["outcome"])
                    for subject, comparisons in by_subject for one in comparisons]
        self.assertEqual(found, expected)
        self.assertEqual(result["passed"], all(outcome != "failed" for *_, outcome in found))

    def report(self):
        return json.loads((self.folder / "out/report.json").read_text())

    def test_validate_tells_all_verdicts_and_files(self):
        result = self.answer("validate", ELASTIC, example("measured_drive"), "--out", "out",
                             "--figures", "pictures")
        self.check_validation(result, [(scene["file"], scene["comparisons"]) for scene in self.report()["scenes"]])
        self.assertTrue(result["passed"])
        self.assertEqual({one["outcome"] for one in result["comparisons"]}, {"passed"})
        self.assertTrue(any(file.endswith(".svg") for file in result["files"]))

    def test_validate_tells_a_failure(self):
        for compiler in ["g++", "clang++", "c++"]:
            (self.folder / compiler).write_text("#!/bin/sh\nexit 1\n")
            (self.folder / compiler).chmod(0o755)
        result = self.answer("validate", ELASTIC, "--out", "out", status=1,
                             env=os.environ | {"PATH": f"{self.folder}:{os.environ['PATH']}"})
        result["files"] += ["g++", "clang++", "c++"]
        self.check_validation(result, [(scene["file"], scene["comparisons"]) for scene in self.report()["scenes"]])
        self.assertFalse(result["passed"])

    def test_validate_the_paper(self):
        result = self.answer("validate", "--paper", "--out", "out")
        parts = [part["comparisons"] for part in self.report()["paper"].values() if "comparisons" in part]
        by_key = sorted((one["key"], one["name"], one["outcome"]) for part in parts for one in part)
        found = sorted((one["key"], one["name"], one["outcome"]) for one in result["comparisons"])
        self.assertEqual(found, by_key)
        self.assertEqual({one["subject"] for one in result["comparisons"]}, {"the paper"})
        self.assertEqual(set(result["files"]), self.written())


if __name__ == "__main__":
    unittest.main()
