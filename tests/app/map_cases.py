"""What the tests of maps share: sweeps of several lengths, run as a user runs them, and their files."""

import filecmp
import itertools
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from program import PROGRAM, example

WITH_MPI = sys.argv.pop(1) == "ON"
FAULTS = str(Path(sys.argv.pop(1)).resolve())
ZENER = example("zener")
MPIRUN = shutil.which("mpirun") or sys.exit("mpirun is missing; ./dev test installs it")
# Some thirty blocks, long enough to be hit.
FRICTION = [ZENER, "--over", "k1=lin:1e6:9e6:30", "--over", "amplitude=lin:0.01 um:0.6 um:20", "--over",
            "velocity_ratio=lin:0.2:1.2:50", "--quantity", "friction_ratio", "regime"]
# Some seconds: long enough to be caught in the middle.
LONGER = [word.replace(":30", ":90").replace(":20", ":40") for word in FRICTION]
# On one thread it takes most of a second, in which others begin.
ON_ONE = [word.replace(":30", ":50").replace(":20", ":30") for word in FRICTION] + ["--threads", "1"]
VELOCITY = [ZENER, "--over", "frequency=log:1 kHz:1 MHz:2000", "--over", "k1=lin:1e6:8e6:2500", "--quantity",
            "critical_velocity"]
# A few blocks: the file's beginning and end are what is at stake. Above v* nothing is simulated; v* tells rows apart, and
# the regime those that are outside the model.
FEW = [ZENER, "--over", "k1=lin:1e6:9e6:3", *FRICTION[3:5], "--over", "velocity_ratio=lin:1.01:1.2:50", "--quantity",
       "critical_velocity", "regime"]
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
SANITIZED = "VCRIT_SANITIZED" in os.environ
if SANITIZED:  # Open MPI leaves what its plugins took
    ENVIRONMENT["ASAN_OPTIONS"] = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"


def command(arguments, mpi=0, through=(), program=PROGRAM):
    processes = [MPIRUN, "--oversubscribe", "--bind-to", "none", "-n", str(mpi)] if mpi else []
    return [*processes, *through, program, "sweep", *arguments]


def sweep(*arguments, mpi=0, through=(), program=PROGRAM, **options):
    return subprocess.run(command(arguments, mpi, through, program), capture_output=True, text=True, timeout=300,
                          env=ENVIRONMENT, **options)


def with_fault(fault, number):
    """What to start the program through, so that its change of files with this number goes wrong."""
    return ["env", f"LD_PRELOAD={FAULTS}", f"FAULT={fault}", f"FAULT_AT={number}"]


class Case(unittest.TestCase):
    TOGETHER = tempfile.TemporaryDirectory()
    WHOLE, SECONDS, TOLD = {}, {}, {}  # files, how long they took, what was written to stderr

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def done(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def whole(self, arguments, ending):
        """What an undisturbed run writes; it is made once for all tests."""
        key = (*arguments, ending)
        if key not in Case.WHOLE:
            file, start = Path(Case.TOGETHER.name, f"{len(Case.WHOLE)}{ending}"), time.monotonic()
            Case.TOLD[file] = self.done(sweep(*arguments, "--out", str(file))).stderr
            Case.WHOLE[key], Case.SECONDS[file] = file, time.monotonic() - start
        return Case.WHOLE[key]

    def resumed_after_each(self, fault):
        """Sweeps whose first, second, ... change of a file goes wrong, until none does; each is resumed then. They are by
        what `vcrit sweep` becomes, as a quarter of their time would be its start."""
        sweeper = f"{PROGRAM}-sweep"
        for ending in (".h5", ".csv"):
            whole = self.whole(FEW, ending)
            for number in itertools.count(1):
                file = self.folder / f"{fault}{number}{ending}"
                arguments = [*FEW, "--out", str(file)]
                result = sweep(*arguments, through=with_fault(fault, number), program=sweeper)
                if result.returncode == 0:
                    break
                self.assertFalse(file.exists())
                yield result, file
                self.done(sweep(*arguments, "--resume", program=sweeper))
                self.same(file, whole)
            # At least the layout, the blocks and the name.
            self.assertGreater(number, 5)

    def same(self, file, whole):
        self.assertTrue(filecmp.cmp(file, whole, shallow=False))
        self.assertEqual([p.name for p in self.folder.iterdir() if ".part" in p.name], [])
