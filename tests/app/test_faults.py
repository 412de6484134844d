"""What can go wrong around the program: streams that are full or closed, disks without room, folders that cannot be
written, compilers that die, and signals. It says so, leaves earlier results as they were, and nothing behind.

test_faults.py PROGRAM FAULTS
"""

import filecmp
import itertools
import json
import os
import resource
import shutil
import signal
import stat
import subprocess
import sys
import time
import unittest
from pathlib import Path

import program
from program import PROGRAM, example

FAULTS = str(Path(sys.argv.pop(1)).resolve())
ZENER, KELVIN, ELASTIC = example("zener"), example("kelvin_rigid"), example("elastic")
PATIENCE = 60  # seconds, for what takes a moment; the machine may be busy
CAN_MOUNT = os.geteuid() == 0 and subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode == 0

DATA = "frequency,storage,loss\n" + "".join(f"{f},{8e6 + 4e6 * x * x / (1 + x * x)},{4e6 * x / (1 + x * x)}\n"
                                             for f in (10 ** (3 + i / 8) for i in range(17)) for x in [f / 1e4])


def run(*arguments, **options):
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    return program.run(*arguments, capture_output=False, **streams | options)


class Case(program.Case):
    def setUp(self):
        super().setUp()
        self.data = self.write(DATA, "data.csv")

    def commands(self, out):
        """What writes files, without those that take long."""
        return [["generate", ZENER, "--out", f"{out}/g"],
                ["generate", ZENER, "--language", "python", "--out", f"{out}/p"],
                ["sweep", ZENER, "--over", "k1=lin:1e6:2e6:3", "--quantity", "critical_velocity", "--json", "--out",
                 f"{out}/a.csv"],
                ["sweep", ZENER, "--over", "k1=lin:1e6:2e6:3", "--quantity", "critical_velocity", "--json", "--out",
                 f"{out}/a.h5"],
                ["fit", str(self.data), "--out", f"{out}/f.toml"]]

    def one_message(self, result, words):
        told = result.stderr
        if "--json" in result.args:
            told = "vcrit: " + json.loads(told)["message"] + "\n"
        self.assertRegex(told, f"^vcrit: .*{words}.*\n$")

    def texts(self, folder):
        return {file.name: file.read_bytes() for file in Path(folder).iterdir()}


class Streams(Case):
    def all_commands(self):
        return [["eval", ZENER], ["eval", ZENER, "--json"], ["derive", ZENER], ["derive", "--catalogue"],
                ["derive", ZENER, "--equal", KELVIN], ["simulate", ZENER, "--velocity-ratio", "0.5"],
                ["critical", ZENER], ["solve", ZENER, "--for", "velocity", "--friction-ratio", "0.8"],
                ["--version"], ["--help"], ["eval", "--help"], ["--man"], ["--completion", "bash"],
                *self.commands(self.folder)]

    def test_a_full_stdout(self):
        for arguments in self.all_commands():
            with self.subTest(arguments), open("/dev/full", "w") as full:
                result = run(*arguments, stdout=full)
                self.assertEqual(result.returncode, 2)
                self.one_message(result, "stdout: found No space left on device; expected a place that can be written")

    def test_a_closed_stdout(self):
        for arguments in self.all_commands():
            with self.subTest(arguments):
                result = run(*arguments, stdout=None, preexec_fn=lambda: os.close(1))
                self.assertEqual(result.returncode, 2)
                self.one_message(result, "stdout: found")
        # Nor has the file that got its number been printed into.
        self.assertNotIn("rows_found", (self.folder / "a.csv").read_text())

    def closed_pipe(self, arguments, **options):
        reading, writing = os.pipe()
        os.close(reading)
        try:
            return run(*arguments, stdout=writing, **options)
        finally:
            os.close(writing)

    def test_a_pipe_that_nobody_reads(self):
        for arguments in self.all_commands():
            with self.subTest(arguments):
                result = self.closed_pipe(arguments)  # as in a shell: `vcrit derive SCENE | head -1` is no error
                self.assertEqual((result.returncode, result.stderr), (-signal.SIGPIPE, ""))
                ignoring = self.closed_pipe(arguments, restore_signals=False)
                self.assertEqual(ignoring.returncode, 2)
                self.one_message(ignoring, "stdout: found")

    def test_messages_that_nobody_can_read_change_nothing(self):
        for arguments, status in [(["eval", ZENER], 0), (["eval", "absent.toml"], 2), (["frobnicate"], 2),
                                  (["derive", ZENER, "--equal", KELVIN], 1)]:
            with self.subTest(arguments), open("/dev/full", "w") as full:
                self.assertEqual(run(*arguments, stderr=full).returncode, status)
                self.assertEqual(run(*arguments, preexec_fn=lambda: os.close(2)).returncode, status)


class Generate(Case):
    def generated(self, scene, name):
        self.assertEqual(run("generate", scene, "--quantities", "--out", self.folder / name).returncode, 0)
        return self.texts(self.folder / name)

    def faulty(self, fault, number):
        """Zener's library generated over Kelvin's; the change of a file with this number goes wrong."""
        out = self.folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        shutil.copytree(self.folder / "kelvin", out)
        fault = {"LD_PRELOAD": FAULTS, "FAULT": fault, "FAULT_AT": str(number), "FAULT_IN": str(out)}
        return run("generate", ZENER, "--quantities", "--out", out, env=os.environ | fault)

    def setUp(self):
        super().setUp()
        self.old, self.new = self.generated(KELVIN, "kelvin"), self.generated(ZENER, "zener")

    def test_a_full_disk_leaves_the_earlier_library(self):
        for number in itertools.count(1):
            result = self.faulty("full", number)
            if result.returncode == 0:
                break
            self.assertEqual(result.returncode, 2)
            self.one_message(result, "found No space left on device; expected")
            # The sixth write is the last; a rename takes no room, and where it fails, the first ones are done.
            if number <= 6:
                self.assertEqual(self.texts(self.folder / "out"), self.old)
            else:
                self.assertNotIn(".part", " ".join(self.texts(self.folder / "out")))
        self.assertEqual(number, 13)

    def test_files_of_another_hand_stay(self):
        for file, language in [("CMakeLists.txt", "c++"), ("critical.hpp", "c++"), ("test_critical.cpp", "c++"),
                               ("critical.py", "python"), ("critical.h", "c99")]:
            with self.subTest(file):
                out = self.folder / f"own-{file}"
                out.mkdir()
                (out / file).write_text("project(mine)\n")
                result = run("generate", ZENER, "--language", language, "--out", out)
                self.assertEqual(result.returncode, 2)
                self.one_message(result, "found a file that vcrit did not generate; expected another folder")
                self.assertEqual(self.texts(out), {file: b"project(mine)\n"})

    def preprocessed(self, *files):
        text = "".join(f'#include "{file}"\n' for file in files)
        return subprocess.run(["g++", "-std=c++20", "-E", "-o", os.devnull, "-x", "c++", "-"], input=text, text=True,
                              cwd=self.folder / "out", capture_output=True)

    def test_a_kill_leaves_whole_files_that_do_not_mix(self):
        mixed = 0
        for number in itertools.count(1):
            result = self.faulty("kill", number)
            now = self.texts(self.folder / "out")
            if result.returncode == 0:
                break
            self.assertEqual(result.returncode, -signal.SIGKILL)
            for name in self.old:
                self.assertIn(now[name], [self.old[name], self.new[name]])
            if number <= 6:
                self.assertEqual({name: now[name] for name in self.old}, self.old)
            for name, *more in [("critical_batch.hpp",), ("critical_quantities.hpp",),
                                ("test_critical.cpp", "critical_batch.hpp")]:
                whole = self.of_one_run(now, name, *more)
                compiled = self.preprocessed(name)
                self.assertEqual(compiled.returncode == 0, whole, compiled.stderr)
                if not whole:
                    self.assertIn("are of two runs: vcrit generate again", compiled.stderr)
                    mixed += 1
            # The same command makes it whole.
            run("generate", ZENER, "--quantities", "--out", self.folder / "out")
            again = self.texts(self.folder / "out")
            self.assertEqual({name: again[name] for name in self.new}, self.new)
        self.assertEqual(now, self.new)
        self.assertEqual(number, 13)
        self.assertGreaterEqual(mixed, 3)

    def of_one_run(self, now, *names):
        return any(all(now[name] == run[name] for name in ["critical.hpp", *names]) for run in (self.old, self.new))

    @unittest.skipUnless(CAN_MOUNT, "needs root to mount a small disk")
    def test_disks_with_too_little_room(self):
        script = """
            mount -t tmpfs -o size=1m none "$1" && cp -r "$2/kelvin" "$1/out" || exit 99
            free="$(df --output=avail -k "$1" | tail -1)"
            head -c "$((free - $3))k" /dev/zero >"$1/filler" || exit 98
            "$4" generate "$5" --quantities --out "$1/out" >/dev/null; status=$?
            cp -r "$1/out" "$2/result"
            exit $status"""
        disk = self.folder / "disk"
        disk.mkdir()
        statuses = []
        for room in [0, 4, 8, 16, 24, 32, 48, 128]:  # kB; the library takes some 45
            shutil.rmtree(self.folder / "result", ignore_errors=True)
            result = subprocess.run(["unshare", "-m", "bash", "-c", script, "bash", disk, self.folder, str(room),
                                     PROGRAM, ZENER], capture_output=True, text=True, timeout=60)
            statuses.append(result.returncode)
            self.assertIn(result.returncode, [0, 2], result.stderr)
            self.assertEqual(self.texts(self.folder / "result"), self.new if result.returncode == 0 else self.old)
            if result.returncode == 2:
                self.one_message(result, "found No space left on device; expected")
        self.assertEqual((statuses[0], statuses[-1]), (2, 0))
        self.assertEqual(statuses, sorted(statuses, reverse=True))


class Folders(Case):
    def refused(self, run_it, out, words):
        for arguments in self.commands(out):
            with self.subTest(arguments):
                result = run_it(arguments)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.one_message(result, words)
        self.assertEqual(list(Path(out).iterdir()), [])

    @unittest.skipUnless(CAN_MOUNT, "needs root to mount a folder")
    def test_a_read_only_mount(self):
        out = self.folder / "out"
        out.mkdir()
        script = 'mount --bind "$1" "$1" && mount -o remount,ro,bind "$1" || exit 99; exec "${@:2}"'
        self.refused(lambda arguments: subprocess.run(["unshare", "-m", "bash", "-c", script, "bash", out, PROGRAM,
                                                       *arguments], capture_output=True, text=True, timeout=60),
                     out, "found Read-only file system; expected")

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("setpriv"), "needs root to become somebody else")
    def test_a_folder_of_somebody_else(self):
        os.chmod(self.folder, 0o755)
        out = self.folder / "out"
        out.mkdir(mode=0o755)
        # Where everybody can read them.
        program, scene, _ = (shutil.copy(file, self.folder) for file in (PROGRAM, ZENER, f"{PROGRAM}-sweep"))
        become = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", program]
        self.refused(lambda arguments: subprocess.run([*become, *[scene if a == ZENER else a for a in arguments]],
                                                      capture_output=True, text=True, timeout=60, cwd="/"),
                     out, "found Permission denied; expected")

    def test_links_are_not_followed(self):
        out, outside = self.folder / "out", self.folder / "outside"
        (out / "g").mkdir(parents=True)
        (out / "p").mkdir()
        for name in ["g/critical.hpp", "p/critical.py", "a.csv", "a.h5", "a.csv.part.sweep", "a.h5.part.new", "f.toml",
                     "f.html"]:
            outside.write_text("somebody else's")
            (out / name).symlink_to(outside)
        for arguments in self.commands(out):
            result = run(*arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(outside.read_text(), "somebody else's")
        self.assertFalse(any(path.is_symlink() for path in out.rglob("*")))
        # A sweep's part neither, whether there is something at its end or not.
        for target in [outside, self.folder / "absent"]:
            for name in ["b.csv", "b.h5"]:
                part = out / f"{name}.part"
                part.unlink(missing_ok=True)
                part.symlink_to(target)
                for resume in [[], ["--resume"]]:
                    result = run(*self.commands(out)[2][:-1], out / name, *resume)
                    self.assertEqual(result.returncode, 2)
                    self.one_message(result, "found a symbolic link")
        self.assertEqual(outside.read_text(), "somebody else's")
        self.assertFalse((self.folder / "absent").exists())


@unittest.skipIf("VCRIT_SANITIZED" in os.environ, "the sanitizer alone takes more memory")
class Limits(Case):
    """A scene uses what memory and time it is given, and no more."""

    def scene(self, networks, normal):
        return self.write(Path(KELVIN).read_text().replace("[contact]", f"[networks]\n{networks}\n[contact]", 1)
                          .replace('"kelvin(k, c)"', f'"{normal}"'))

    def test_networks_of_networks_end(self):
        # 2^60 elements in 60 lines.
        lines = ['n0 = "k | c"', *(f'n{i} = "n{i - 1} - n{i - 1}"' for i in range(1, 60))]
        result = run("eval", self.scene("\n".join(lines), "n59"),
                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30)))
        self.assertEqual(result.returncode, 2)
        self.one_message(result, "found more than 1000000 elements; expected a smaller network")

    def test_too_little_memory_is_told(self):
        lines = ['n0 = "k | c"', *(f'n{i} = "n{i - 1} - n{i - 1}"' for i in range(1, 18))]
        scene = self.scene("\n".join(lines), "n17")
        # Enough for the program itself, with its libraries.
        result = run("eval", scene, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 27, 1 << 27)))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.one_message(result, "out of memory")


class Validate(Case):
    """With compilers of the tests' own on PATH: the report is made without one, too."""

    def setUp(self):
        super().setUp()
        self.temporary, self.bin, self.report = (self.folder / name for name in ["tmp", "bin", "out"])
        self.temporary.mkdir()
        self.bin.mkdir()

    def compiler(self, script):
        (self.bin / "g++").write_text(f"#!/bin/bash\n{script}\n")
        (self.bin / "g++").chmod(0o755)

    def environment(self, **more):
        return os.environ | {"PATH": str(self.bin), "TMPDIR": str(self.temporary)} | more

    def validate(self, scene=KELVIN, **more):
        return run("validate", scene, "--out", self.report, env=self.environment(**more))

    def nothing_is_left(self):
        self.assertEqual(list(self.temporary.iterdir()), [])

    def test_the_files_are_written_together(self):
        self.assertEqual(self.validate().returncode, 0)
        old = self.texts(self.report)
        self.assertEqual(set(old), {"index.html", "kelvin_rigid.evidence.html", "report.json"})
        fault = {"LD_PRELOAD": FAULTS, "FAULT_IN": str(self.report)}
        # Three writes and three renames, the index last.
        for kind, number, status in [("full", 1, 2), ("full", 3, 2), ("kill", 3, -signal.SIGKILL),
                                     ("kill", 4, -signal.SIGKILL), ("kill", 6, -signal.SIGKILL)]:
            result = self.validate(ELASTIC, **fault, FAULT=kind, FAULT_AT=str(number))
            self.assertEqual(result.returncode, status, result.stderr)
            now = self.texts(self.report)
            self.assertEqual(now["index.html"], old["index.html"])
            if number < 5:
                self.assertEqual(now["report.json"], old["report.json"])
            if kind == "full":
                self.assertEqual(set(now), set(old))
        self.wait_for(lambda: not list(self.temporary.iterdir()))

    def test_a_killed_compiler_is_told(self):
        self.compiler('[[ $1 == --version ]] && echo "g++ 0" && exit; kill -9 $$')
        result = self.validate()
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("FAILED", result.stderr)
        self.assertIn("failed", (self.report / "report.json").read_text())
        self.nothing_is_left()

    def wait_for(self, holds):
        end = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), end, "it did not come")
            time.sleep(0.02)

    def alive(self, process):
        try:
            return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
        except (FileNotFoundError, ProcessLookupError):
            return False

    def test_signals_leave_nothing(self):
        told = self.folder / "told"
        # Hangs with a child, as a compiler with an assembler, and a file in the folder for them.
        self.compiler(f'''echo half >"$TMPDIR/cc.s"
            /bin/sleep 1000 & echo "$$ $! $TMPDIR" >"{told}.new"
            /bin/mv "{told}.new" "{told}"; wait''')
        self.report.mkdir()
        (self.report / "index.html").write_text("earlier")
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL]:
            with self.subTest(number):
                told.unlink(missing_ok=True)
                process = subprocess.Popen([PROGRAM, "validate", KELVIN, "--out", self.report], env=self.environment(),
                                           stdout=subprocess.DEVNULL, start_new_session=True)
                self.wait_for(told.exists)
                compiler, child, folder = told.read_text().split()
                self.assertTrue(folder.startswith(f"{self.temporary}/vcrit-"), folder)
                for private in [Path(folder), *self.temporary.iterdir()]:
                    self.assertEqual(stat.S_IMODE(private.stat().st_mode), 0o700)
                # As a terminal does it: to all of the foreground.
                os.killpg(process.pid, number)
                self.assertEqual(process.wait(PATIENCE), -number)
                self.wait_for(lambda: not list(self.temporary.iterdir()))
                self.wait_for(lambda: not self.alive(compiler) and not self.alive(child))
        self.assertEqual(self.texts(self.report), {"index.html": b"earlier"})

    def test_a_missing_place_for_temporary_files_is_told(self):
        self.compiler("exit 1")
        self.temporary.rmdir()
        result = self.validate()
        self.assertEqual(result.returncode, 2)
        self.one_message(result, f"{self.temporary}")
        self.assertFalse(self.report.exists())
        self.temporary.mkdir()


if __name__ == "__main__":
    unittest.main()
