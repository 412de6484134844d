"""tests/support/run_changed.py: a test runs unless it has passed with the very same inputs."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(sys.argv.pop(1)) / "tests/support/run_changed.py"


class RunChanged(unittest.TestCase):
    """On a project of two entries, whose scripts tell of each time they run."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve() / "project"
        self.build = self.folder / "build"
        self.log = Path(folder.name) / "log"
        self.write("data", "fine")
        self.write(".gitignore", "build")
        self.entries = {"room/one": self.script("one", f"grep -q fine {self.folder}/data"), "room/two": self.script("two", ":")}
        subprocess.run(["git", "init", "-q", self.folder], check=True)

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def script(self, name, line):
        return self.write(f"scripts/{name}", f"echo {name} >> {self.log}\n{line}\n")

    def suite(self, *words, **environment):
        """Which scripts run, whether all is well, and what is printed."""
        listed = [f'add_test({name} "/bin/sh" "{script}" "{self.folder}/data")\n' if name == "room/one" else
                  f'add_test({name} "/bin/sh" "{script}")\n' for name, script in self.entries.items()]
        self.write("build/CTestTestfile.cmake", "".join(listed))
        self.log.unlink(missing_ok=True)
        ran = subprocess.run([sys.executable, "-B", SCRIPT, "build", *words], cwd=self.folder, capture_output=True, text=True,
                             env=os.environ | environment)
        started = sorted(self.log.read_text().split()) if self.log.exists() else []
        return started, ran.returncode == 0, ran.stdout

    def left_out(self, printed):
        last = printed.splitlines()[-1]
        said = re.match(r"Not run: (\d+) of (\d+) tests, which have passed with the very same inputs", last)
        return tuple(map(int, said.groups())) if said else None

    def test_what_has_passed_is_not_run_again_and_that_is_said(self):
        started, good, printed = self.suite()
        self.assertEqual((started, good, self.left_out(printed)), (["one", "two"], True, None))
        self.assertIn("100% tests passed, 0 tests failed out of 2", printed)
        started, good, printed = self.suite()
        self.assertEqual((started, good, self.left_out(printed)), ([], True, (2, 2)))
        self.assertNotIn("tests passed", printed)

    def test_the_same_bytes_written_again_are_the_same(self):
        self.suite()
        os.utime(self.write("data", "fine"), (1, 1))
        self.assertEqual(self.suite()[0], [])

    def test_a_changed_input_runs_it_again(self):
        self.suite()
        self.write("data", "fine, too")
        started, good, printed = self.suite()
        self.assertEqual((started, good, self.left_out(printed)), (["one"], True, (1, 2)))
        self.assertIn("100% tests passed, 0 tests failed out of 1", printed)
        self.script("two", "true")
        self.assertEqual(self.suite()[0], ["two"])

    def test_what_all_may_read_runs_all_again(self):
        for name in ("tests/data/table.csv", "tests/support/library.py", "tests/room/more", "scenes/new.toml"):
            self.suite()
            self.write(name, "new")
            self.assertEqual(self.suite()[0], ["one", "two"], name)

    def test_another_environment_runs_all_again(self):
        self.suite()
        self.assertEqual(self.suite(VCRIT_OTHER="1")[0], ["one", "two"])

    def test_a_failure_is_never_kept(self):
        self.suite()
        self.write("data", "bad")
        for _ in range(2):
            self.assertEqual(self.suite()[:2], (["one"], False))
        self.write("data", "fine")
        self.assertEqual(self.suite()[:2], (["one"], True))

    def test_a_new_entry_runs(self):
        self.suite()
        self.entries["room/three"] = self.script("three", ":")
        self.assertEqual(self.suite()[0], ["three"])

    def test_what_is_asked_for_runs(self):
        self.suite()
        self.assertEqual(self.suite("--all")[0], ["one", "two"])
        self.assertEqual(self.suite("room/tw")[0], ["two"])

    def test_what_a_program_names_is_read(self):
        program = self.write("build/program", f"\x7fELF {self.folder}/data")
        self.entries["room/two"] = f'{self.script("two", ":")}" "{program}'
        self.suite()
        self.write("data", "fine, too")
        self.assertEqual(self.suite()[0], ["one", "two"])

    def test_a_program_of_another_commit_is_the_same(self):
        def program(commit, hashed, code):
            note = b"\4\0\0\0" + bytes([len(hashed), 0, 0, 0]) + b"\3\0\0\0GNU\0" + hashed
            self.write("build/program", "").write_bytes(b"\x7fELF" + note + b"vcrit's commit: " + commit.ljust(13) + b"\0" + code)
        program(b"0123456789ab", b"12345678", b"code")
        self.entries["room/two"] = f'{self.script("two", ":")}" "{self.build}/program'
        self.suite()
        for commit, hashed, code, started in ((b"0123456789ab+", b"87654321", b"code", []), (b"unknown", b"abcdefgh", b"code", []),
                                              (b"unknown", b"abcdefgh", b"bode", ["two"]), (b"unknown", b"a" * 20, b"bode", ["two"]),
                                              (b"unknown", b"\n" * 20, b"bode", [])):
            program(commit, hashed, code)
            self.assertEqual(self.suite()[0], started, (commit, hashed, code))

    def test_the_commit_may_be_another(self):
        self.write("build/commit.cpp", "one")
        self.entries["room/two"] = f'{self.script("two", ":")}" "{self.build}'
        self.suite()
        self.write("build/commit.cpp", "two")
        self.assertEqual(self.suite()[0], [])

    def test_a_compiler_is_another_environment_but_not_its_cache(self):
        self.suite()
        self.assertEqual(self.suite(CCACHE_DISABLE="1")[0], [])
        self.assertEqual(self.suite(CXX="other")[0], ["one", "two"])

    def test_what_changes_meanwhile_has_not_passed(self):
        self.script("two", f"echo fine >> {self.folder}/data")
        self.suite()
        self.assertEqual(self.suite()[0], ["one"])

    def test_without_git_all_run(self):
        self.suite()
        self.assertEqual(self.suite(PATH="/nowhere:" + self.without_git())[0], ["one", "two"])

    def without_git(self):
        tools = self.folder / "build/tools"
        tools.mkdir()
        for name in ("ctest", "sh", "grep"):
            found = next(each for each in ("/usr/local/bin", "/usr/bin", "/bin") if Path(each, name).exists())
            (tools / name).symlink_to(Path(found, name))
        return str(tools)


if __name__ == "__main__":
    unittest.main()
