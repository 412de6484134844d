"""`vcrit sweep` into large files: killed and resumed, a full disk, several processes, and what users of HDF5 and
netCDF see of them. Everything is compared with an undisturbed run, byte by byte."""

import csv
import json
import os
import pty
import random
import resource
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import h5py
import numpy
import xarray

from map_cases import (Case, ENVIRONMENT, FRICTION, LONGER, ON_ONE, PROGRAM, SANITIZED, VELOCITY, WITH_MPI, ZENER,
                       command, sweep, with_fault)


class Killed(Case):
    def interrupted(self, arguments, ending, kills):
        """Kills the sweep at random moments until it has come to its end; returns how often it was hit."""
        whole = self.whole(arguments, ending)
        duration = self.SECONDS[whole]
        file = self.folder / ("killed" + ending)
        # Other moments in every run of the suite; half of them early, while the file is laid out.
        hits, chance = 0, random.Random()
        while hits < kills:
            for path in self.folder.glob("killed*"):
                path.unlink()
            while not file.exists():
                process = subprocess.Popen(command([*arguments, "--out", str(file), "--resume"]),
                                           stderr=subprocess.PIPE, text=True)
                try:
                    # The later runs have less left to do.
                    moment = duration * chance.choice([0.1, 0.8]) * chance.random()
                    told = process.communicate(timeout=moment if hits < kills else 100)[1]
                    self.assertEqual(process.returncode, 0, told)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.communicate()
                    hits += not file.exists()
                    if file.exists():  # killed between its last two steps, which leaves names and no numbers
                        for ending in (".part.sweep", ".part.lock"):
                            Path(f"{file}{ending}").unlink(missing_ok=True)
            self.same(file, whole)

    def test_an_array_of_friction_ratios(self):
        self.interrupted(FRICTION, ".h5", 20)

    def test_an_array_of_critical_velocities(self):
        self.interrupted(VELOCITY, ".nc", 20)

    def test_a_table(self):
        self.interrupted(FRICTION, ".csv", 20)

    def test_before_each_of_its_writes(self):
        for result, _ in self.resumed_after_each("kill"):
            self.assertEqual(result.returncode, -signal.SIGKILL)

    def test_what_is_there_can_be_read(self):
        file = self.folder / "map.h5"
        part = Path(f"{file}.part")
        process = subprocess.Popen(command([*LONGER, "--out", str(file)]))
        done = 0
        while not 0.2 < done < 0.9:
            if part.exists():
                # The file may not be whole yet in its first moments.
                try:
                    with h5py.File(part, "r", locking=False) as opened:
                        done = opened["progress/blocks"][:].mean()
                except (OSError, KeyError):
                    pass
            self.assertIsNone(process.poll(), "the map is too small to be caught in the middle")
        process.kill()
        process.wait()
        whole = xarray.open_dataset(self.whole(LONGER, ".h5"), engine="netcdf4")
        partial = xarray.open_dataset(part, engine="netcdf4")
        there = partial.friction_ratio.notnull()
        self.assertGreater(float(there.mean()), 0.1)
        self.assertLess(float(there.mean()), 1)
        self.assertEqual(float(abs(partial.friction_ratio - whole.friction_ratio).where(there, 0).max()), 0)
        # Nothing is there that the whole map does not have: the missing numbers read as NaN, not as zeros.
        self.assertFalse(bool((partial.friction_ratio == 0).any()))


class FullDisk(Case):
    def limited(self, name, size):
        """A sweep that may write files of `size` bytes, as on a disk that is full then."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        return sweep(*FRICTION, "--out", str(self.folder / name), preexec_fn=limit)

    def test_a_table_goes_on_where_it_ended(self):
        whole = self.whole(FRICTION, ".csv")
        result = self.limited("map.csv", whole.stat().st_size // 2)
        self.assertEqual(result.returncode, 2)
        self.assertIn("map.csv.part: found", result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertFalse((self.folder / "map.csv").exists())
        self.done(sweep(*FRICTION, "--out", str(self.folder / "map.csv"), "--resume"))
        self.same(self.folder / "map.csv", whole)

    def test_full_at_each_of_its_writes(self):
        for result, file in self.resumed_after_each("full"):
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertRegex(result.stderr, f"{file.name}(.part)?: found No space left on device; expected")
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)

    def test_an_array_without_room_leaves_nothing(self):
        result = self.limited("map.h5", 100_000)
        self.assertEqual(result.returncode, 2)
        self.assertIn("map.h5.part: found File too large; expected a place", result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipUnless(os.geteuid() == 0 and subprocess.run(
        ["unshare", "-m", "true"], capture_output=True).returncode == 0, "needs root to mount a small disk")
    def test_an_array_on_a_disk_that_fills_up(self):
        # 5e6 doubles are 40 MB.
        script = """
            mount -t tmpfs -o size=20m none "$1" && cd "$1" || exit 99
            "$2" sweep "${@:3}" --out map.h5; status=$?
            mount -o remount,size=100m "$1"
            /usr/bin/python3 -c 'import h5py; print(h5py.File("map.h5.part")["progress/blocks"][:].mean())' || exit 98
            "$2" sweep "${@:3}" --out map.h5 --resume && cp map.h5 "$1.copy" || exit 97
            exit $status"""
        disk = self.folder / "disk"
        disk.mkdir()
        result = subprocess.run(["unshare", "-m", "bash", "-c", script, "bash", str(disk), PROGRAM, *VELOCITY],
                                capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("map.h5.part: found No space left on device; expected", result.stderr)
        self.assertIn("--resume goes on from here", result.stderr)
        self.assertTrue(0 < float(result.stdout) < 0.6, result.stdout)
        self.same(self.folder / "disk.copy", self.whole(VELOCITY, ".h5"))


class Array(Case):
    def test_it_is_labelled(self):
        file = self.whole([ZENER, "--over", "frequency=log:1 kHz:1 MHz:30", "--over", "velocity_ratio=lin:0.2:1.2:4",
                           "--quantity", "critical_velocity", "friction_ratio", "regime", "admissible",
                           "sensitivity:k1", "--set", "k0=7 N/um"], ".nc")
        data = xarray.open_dataset(file, engine="netcdf4")
        self.assertEqual(dict(data.sizes), {"frequency": 30, "velocity_ratio": 4})
        self.assertEqual(data.critical_velocity.dims, ("frequency", "velocity_ratio"))
        self.assertEqual(data.frequency.attrs["units"], "Hz")
        self.assertEqual(data.critical_velocity.attrs["units"], "m/s")
        self.assertEqual(data.sensitivity_k1.attrs["units"], "1")
        self.assertEqual(data.attrs["scene"], Path(ZENER).read_text())
        self.assertIn("set k0=7 N/um", data.attrs["sweep"])
        self.assertIn("Zener", data.attrs["title"])
        meanings = data.regime.attrs["flag_meanings"].split()
        self.assertEqual(meanings, ["sliding", "stick-slip", "stick-slip-backslip", "stick"])
        self.assertEqual(list(data.regime.attrs["flag_values"]), [1, 2, 3, 4])
        self.assertTrue(bool((data.regime.sel(velocity_ratio=1.2) == 1).all()))
        self.assertEqual(list(data.admissible.attrs["flag_values"]), [0, 1])
        self.assertEqual(data.admissible.dtype.kind, "u")  # none is missing
        self.assertTrue(bool((data.admissible == 1).all()))
        self.assertEqual(float(data.frequency[7]) * 0 + 30, len(set(data.frequency.values)))
        with h5py.File(file) as opened:
            self.assertEqual(opened["critical_velocity"].dims[0][0].name, "/frequency")

    def test_entries_of_arrays_have_names_of_the_conventions(self):
        file = self.whole([str(Path(ZENER).with_name("prony.toml")), "--over", "k[3]=lin:1e5:3e5:3", "--quantity",
                           "critical_velocity", "sensitivity:tau[2]"], ".nc")
        data = xarray.open_dataset(file, engine="netcdf4")
        self.assertEqual(sorted(data.variables), ["critical_velocity", "k_3", "sensitivity_tau_2"])
        self.assertEqual(list(data.k_3.values), [1e5, 2e5, 3e5])
        self.assertEqual(data.k_3.attrs["long_name"], "k[3]")
        self.assertEqual(data.sensitivity_tau_2.dims, ("k_3",))

    def test_it_is_the_table(self):
        arguments = FRICTION[:1] + ["--over", "k1=lin:1e6:9e6:6", "--over", "velocity=log:1 mm/s:1 m/s:9",
                                    "--quantity", "friction_ratio", "critical_velocity"]
        array = xarray.open_dataset(self.whole(arguments, ".h5"), engine="netcdf4")
        with self.whole(arguments, ".csv").open() as table:
            rows = list(csv.DictReader(table))
        for row, (k1, velocity) in zip(rows, [(k, v) for k in array.k1 for v in array.velocity], strict=True):
            self.assertEqual((float(row["k1"]), float(row["velocity"])), (float(k1), float(velocity)))
            here = array.sel(k1=k1, velocity=velocity)
            self.assertEqual(float(row["friction_ratio"]), float(here.friction_ratio))
            self.assertEqual(float(row["critical_velocity"]), float(here.critical_velocity))

    def test_json_tells_what_was_done(self):
        file = self.folder / "map.h5"
        told = json.loads(self.done(sweep(*VELOCITY, "--out", str(file), "--json")).stdout)
        self.assertEqual(told, {"file": str(file), "rows": 5_000_000, "rows_found": 5_000_000, "rows_outside": 0,
                                "reason": ""})

    def test_progress_is_shown_on_a_terminal_alone(self):
        # Most of a second; the line comes after a quarter of one. Without a terminal there are warnings at most.
        stderr = self.TOLD[self.whole(LONGER, ".h5")]
        self.assertEqual([line for line in stderr.splitlines() if not line.startswith("vcrit: warning:")], [])
        controller, terminal = pty.openpty()
        process = subprocess.Popen(command([*ON_ONE, "--out", str(self.folder / "b.h5")]), stderr=terminal)
        os.close(terminal)
        shown = b""
        while True:
            try:
                shown += os.read(controller, 4096)
            except OSError:
                break
        self.assertEqual(process.wait(60), 0)
        os.close(controller)
        self.assertRegex(shown.decode(), r"\d+\.\d % of 75000 points, [0-9.e+]+ a second, \d+ s left")
        self.assertIn(b"\r\x1b[Kvcrit: warning:", shown)

    @unittest.skipIf(SANITIZED, "the sanitizer keeps what is freed")
    def test_memory_does_not_grow_with_the_map(self):
        def peak(rows):
            before = self.folder / "peak"
            measure = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True); "
                       "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
            result = subprocess.run(
                ["/usr/bin/python3", "-c", measure, PROGRAM, "sweep", ZENER, "--over",
                 f"frequency=log:1 kHz:1 MHz:{rows}", "--over", "k1=lin:1e6:8e6:1000", "--quantity",
                 "critical_velocity", "--out", f"{before}{rows}.h5"], capture_output=True, text=True, check=True)
            return int(result.stdout)
        # 1e5 points take all that is allocated once for each thread; twenty million of them would be 160 MB.
        small, large = peak(1000), peak(20_000)
        self.assertLess(large, small + 20_000)


@unittest.skipIf(WITH_MPI, "built with MPI")
class WithoutMpi(Case):
    def test_several_processes_are_refused(self):
        result = sweep(*VELOCITY, "--out", str(self.folder / "map.h5"), mpi=2)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("expected one: this program was built without MPI", result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


@unittest.skipUnless(WITH_MPI, "built without MPI")
class Processes(Case):
    def test_the_number_of_ranks_does_not_change_a_bit(self):
        for name, arguments in [("friction", FRICTION), ("velocity", VELOCITY)]:
            whole = self.whole(arguments, ".h5")
            # More than once: ranks that begin at different times are what may go wrong.
            for ranks in (1, 2, 4, 4, 4):
                file = self.folder / f"{name}{ranks}.h5"
                file.unlink(missing_ok=True)
                told = json.loads(self.done(sweep(*arguments, "--out", str(file), "--json", mpi=ranks)).stdout)
                self.assertEqual(told["rows_found"], told["rows"])
                self.same(file, whole)

    def test_every_rank_works(self):
        # Blocks go to whoever asks: two ranks of one thread each take part in the same map.
        file = self.folder / "map.h5"
        process = subprocess.Popen(command([*FRICTION, "--threads", "1", "--out", str(file)], mpi=2),
                                   stderr=subprocess.DEVNULL, env=ENVIRONMENT)
        used = {}
        while process.poll() is None:
            for pid in self.ranks(process.pid):
                try:
                    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
                    used[pid] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
                except (FileNotFoundError, ProcessLookupError):
                    pass
            time.sleep(0.02)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(len(used), 2)
        self.assertGreater(min(used.values()), 0.3 * max(used.values()))

    @staticmethod
    def ranks(mpirun):
        children = Path(f"/proc/{mpirun}/task/{mpirun}/children")
        return children.read_text().split() if children.exists() else []

    def test_a_killed_rank_loses_nothing_that_is_written(self):
        whole = self.whole(LONGER, ".h5")
        file = self.folder / "map.h5"
        process = subprocess.Popen(command([*LONGER, "--out", str(file)], mpi=4), env=ENVIRONMENT,
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        done = 0
        while done < 0.2:
            try:
                with h5py.File(f"{file}.part", "r", locking=False) as opened:
                    done = opened["progress/blocks"][:].mean()
            except (OSError, KeyError):
                pass
            self.assertIsNone(process.poll(), "the map is too small to be caught in the middle")
        os.kill(int(self.ranks(process.pid)[2]), signal.SIGKILL)
        self.assertNotEqual(process.wait(60), 0)
        with h5py.File(f"{file}.part", "r") as opened, h5py.File(whole) as complete:
            there = opened["friction_ratio"][:] != 0
            self.assertGreaterEqual(there.mean(), 0.15)
            numpy.testing.assert_array_equal(opened["friction_ratio"][:][there], complete["friction_ratio"][:][there])
        told = json.loads(self.done(sweep(*LONGER, "--out", str(file), "--resume", "--json", mpi=2)).stdout)
        self.assertLess(told["rows_found"], told["rows"])
        self.same(file, whole)

    def test_a_rank_that_cannot_write_ends_all(self):
        whole, file = self.whole(LONGER, ".h5"), self.folder / "map.h5"
        # The first rank cannot lay out the file, the other one not write its first block.
        script = """[ "$OMPI_COMM_WORLD_RANK" != "$1" ] && shift 4; exec "${@:2}" """
        for rank in ("0", "1"):
            result = sweep(*LONGER, "--out", str(file), mpi=2,
                           through=["bash", "-c", script, "bash", rank, *with_fault("full", 1)])
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("map.h5.part: found ", result.stderr)
            self.assertEqual(result.stderr.count("vcrit: "), 1, result.stderr)
            self.assertEqual(Path(f"{file}.part").exists(), rank == "1")
        self.done(sweep(*LONGER, "--out", str(file), "--resume", mpi=2))
        self.same(file, whole)

    def test_mistakes_end_all_ranks_with_one_message(self):
        for arguments, status, message in [
                ([*VELOCITY, "--out", str(self.folder / "map.csv")], 2, "under mpirun"),
                ([*VELOCITY, "--out", str(self.folder / "map.xls")], 2, "a file ending in"),
                ([ZENER, "--over", "amplitude=lin:1 mm:2 mm:9", "--velocity", "1", "--quantity", "friction_ratio",
                  "--out", str(self.folder / "map.h5")], 3, "(Eq. 3)")]:
            result = sweep(*arguments, mpi=2)
            self.assertEqual(result.returncode, status, result.stderr)
            self.assertEqual(result.stderr.count("vcrit: "), 1, result.stderr)
            self.assertIn(message, result.stderr)
            self.assertEqual(list(self.folder.iterdir()), [])


class Folders(Case):
    def test_one_that_is_made_is_told(self):
        words = f"{self.folder}/new: there was no such folder, it is made"
        for number in (1, 2):
            told = self.done(sweep(ZENER, "--over", "k1=lin:1e6:2e6:3", "--quantity", "critical_velocity", "--json",
                                   "--out", f"{self.folder}/new/{number}.csv"))
            self.assertEqual(json.loads(told.stdout).get("warnings"), [words] if number == 1 else None)
            self.assertEqual(told.stderr, f"vcrit: warning: {words}\n" if number == 1 else "")


if __name__ == "__main__":
    unittest.main()
