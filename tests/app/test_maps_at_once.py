"""Several sweeps to one place, and sweeps that may not go on with what they find."""

import resource
import shutil
import subprocess
import unittest
from pathlib import Path

import scene_text
from map_cases import Case, ON_ONE, PROGRAM, ZENER, command, sweep


class ProgramOfItsOwn(Case):
    """HDF5 and MPI are forty libraries, which take longer to load than an answer takes: arrays alone need them."""

    def test_no_other_command_loads_them(self):
        loaded = [subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
                  for program in (PROGRAM, f"{PROGRAM}-sweep")]
        for libraries, has in zip(loaded, (False, True)):
            self.assertEqual("libhdf5" in libraries, has)

    def test_a_program_copied_alone_tells_what_it_lacks(self):
        alone, out = shutil.copy(PROGRAM, self.folder), self.folder / "a.nc"
        swept = ["sweep", ZENER, "--over", "mu0=lin:0.1:0.2:2", "--quantity", "critical_velocity"]
        for words in (["eval", ZENER], ["sweep", "--help"], swept, [*swept, "--out", self.folder / "a.csv"]):
            self.done(subprocess.run([alone, *words], capture_output=True, text=True))
        result = subprocess.run([alone, *swept, "--out", out], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^vcrit: .*/vcrit-sweep cannot be started \(No such file.*install all of vcrit")
        self.assertFalse(out.exists())


class OneAtATime(Case):
    """Of several sweeps to one place exactly one writes, and what it writes is whole."""

    def start(self, file, *options):
        return subprocess.Popen(command([*ON_ONE, "--out", str(file), *options]), stderr=subprocess.PIPE, text=True)

    def test_a_resume_beside_a_run(self):
        for ending in (".csv", ".h5"):
            file = self.folder / ("beside" + ending)
            running = self.start(file)
            while not Path(f"{file}.part").exists():
                self.assertIsNone(running.poll())
            for options in (("--resume",), ()):
                second = sweep(*ON_ONE, "--out", str(file), *options)
                self.assertEqual(second.returncode, 2)
                self.assertIn("a sweep that is running now", second.stderr)
            told = running.communicate()[1]
            self.assertEqual(running.returncode, 0, told)
            self.same(file, self.whole(ON_ONE, ending))
            self.assertEqual(list(self.folder.glob(f"beside{ending}*")), [file])

    def test_two_resumes_and_two_starts(self):
        for ending in (".csv", ".nc"):
            whole = self.whole(ON_ONE, ending)
            for resumed in (False, True):
                file = self.folder / ("two" + ending)
                for path in self.folder.glob("two*"):
                    path.unlink()
                if resumed:
                    first = self.start(file)
                    while not Path(f"{file}.part").exists():
                        pass
                    first.kill()
                    first.communicate()
                both = [self.start(file, *(["--resume"] if resumed else [])) for _ in range(2)]
                told = [process.communicate()[1] for process in both]
                self.assertEqual(sorted(process.returncode for process in both), [0, 2], told)
                self.same(file, whole)

    def test_the_table_of_an_indenter_belongs_to_its_sweep(self):
        table, scene = self.folder / "tab.csv", self.folder / "tab.toml"
        scene.write_text(scene_text.scene({"k0": 1e9}, normal="k0", shape="tab.csv", frequency="20 kHz", amplitude=1e-7,
                                          indentation=5e-7))
        table.write_text("r,f\n0,0\n2e-4,4e-6\n")
        arguments = [str(scene), "--over", "amplitude=lin:1e-8:3e-7:1500", "--velocity", "1e-3", "--quantity",
                     "friction_ratio", "--out", str(self.folder / "t.csv")]
        running = subprocess.Popen(command(arguments), stderr=subprocess.PIPE)
        while not Path(f"{self.folder}/t.csv.part").exists():
            self.assertIsNone(running.poll())
        running.kill()
        running.communicate()
        table.write_text("r,f\n0,0\n1e-4,1e-7\n2e-4,4e-5\n")
        resumed = sweep(*arguments, "--resume")
        self.assertEqual(resumed.returncode, 2, resumed.stderr)
        self.assertIn("the unfinished file of another sweep", resumed.stderr)

    def test_a_file_that_may_not_grow(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
        result = sweep(*ON_ONE, "--out", str(self.folder / "m.csv"), preexec_fn=limit)
        self.assertEqual(result.returncode, 2)
        self.assertIn("m.csv.part: found File too large", result.stderr)


if __name__ == "__main__":
    unittest.main()
