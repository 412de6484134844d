"""What a release promises: one version everywhere, Debian packages that hold what they should, and the same
bytes from the same sources, wherever they lie.

    test_release.py PROJECT BUILD
"""

import concurrent.futures
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1] / folder) for folder in ("languages", "support")]
import drivers
from example_scenes import with_formula

PROJECT, BUILD = (Path(sys.argv.pop(1)).resolve() for _ in range(2))
VCRIT = BUILD / "vcrit"


def done(*command, **how):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, **how).stdout


def folder_of(test):
    return Path(test.enterClassContext(tempfile.TemporaryDirectory()))


WRITES_NO_PLACES = unittest.skipIf("VCRIT_SANITIZED" in os.environ, "the sanitizer names the sources' places")


class Version(unittest.TestCase):
    def test_is_one(self):
        cmake = re.search(r"project\(vcrit VERSION ([\d.]+)", (PROJECT / "CMakeLists.txt").read_text())[1]
        newest = re.search(r"^## \[(\d[\d.]*)\] - (\d{4}-\d\d-\d\d)$", (PROJECT / "CHANGELOG.md").read_text(), re.M)
        citation = dict(re.findall(r"^(version|date-released): (\S+)$", (PROJECT / "CITATION.cff").read_text(), re.M))
        self.assertEqual(newest.groups(), (cmake, citation["date-released"]))
        self.assertEqual(citation["version"], cmake)
        self.assertIn(cmake, done(VCRIT, "--version").splitlines()[0])


class DebianPackages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = folder_of(cls)
        # How well they are packed is not the point; as users get them it takes long.
        done("cpack", "-B", cls.folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", cwd=BUILD)
        cls.package = {file.name.split("_")[0]: file for file in cls.folder.glob("*.deb")}
        cls.root = cls.folder / "root"
        for file in cls.package.values():
            done("dpkg-deb", "-x", file, cls.root)

    def field(self, package, name):
        return done("dpkg-deb", "-f", self.package[package], name).strip()

    def test_need_what_they_use(self):
        needs = self.field("vcrit", "Depends")
        self.assertNotIn("libginac", needs)  # it is in the programs, from its archive
        for library in ("libgmp10", "libgsl", "libflint-arb", "libudunits2", "libnetcdf", "libhdf5", "libstdc++6"):
            self.assertIn(library, needs)
        self.assertIn("libgsl-dev", self.field("libvcrit-dev", "Depends"))

    def test_hold_files_of_the_system_alone(self):
        for file in self.package.values():
            for line in done("dpkg-deb", "-c", file).splitlines():
                with self.subTest(line=line):
                    self.assertRegex(line, r"^[d-]rw[x-]r-[x-]r-[x-] root/root .* \./(usr/.*)?$")

    @WRITES_NO_PLACES
    def test_name_no_place_of_the_build(self):
        for file in self.root.rglob("*"):
            if file.is_file():
                self.assertNotIn(str(PROJECT).encode(), file.read_bytes(), file)

    def test_have_manual_copyright_and_examples(self):
        for path in ("man/man1/vcrit.1", "doc/vcrit/copyright", "doc/vcrit/CHANGELOG.md", "doc/libvcrit-dev/copyright",
                     "bash-completion/completions/vcrit", "zsh/site-functions/_vcrit"):
            self.assertTrue((self.root / "usr/share" / path).stat().st_size > 0)

    def test_program_runs_from_its_package(self):
        scene = self.root / "usr/share/doc/vcrit/scenes/zener.toml"
        self.assertEqual(done(self.root / "usr/bin/vcrit", "eval", scene, "--json"),
                         done(VCRIT, "eval", PROJECT / "scenes/zener.toml", "--json"))


class SameBytes(unittest.TestCase):
    UNITS = ("scene/indenter.cpp", "critical/certified.cpp", "simulation/steady/steady_cycle.cpp")

    @classmethod
    def setUpClass(cls):
        cls.folder = folder_of(cls)
        # The same two in each run, so that a compilation there may be known.
        cls.places = [BUILD / "same_bytes/a", BUILD / "same_bytes/another/much/longer/place"]
        cls.entry = next(entry for entry in json.loads((BUILD / "compile_commands.json").read_text())
                         if "vcrit_numeric.dir" in entry["command"])

    def compiled(self, place):
        """The object of sources of the library, one file as the build makes of them, from a copy in `place`; a cache
        knows what was compiled there alone."""
        command = self.entry["command"].replace(self.entry["file"], str(place / "units.cpp"))
        words = shlex.split(command.replace(str(PROJECT / "src"), str(place / "src")))
        compiler = next(i for i, word in enumerate(words) if "ccache" not in word)
        words = [*filter(None, [shutil.which("ccache")]), *words[compiler:]]
        words[words.index("-o") + 1] = str(place / "units.o")
        words[words.index("-O3")] = "-O1"  # no pass above names a place, and they take most of the time
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        shutil.copytree(PROJECT / "src", place / "src")
        (place / "units.cpp").write_text("".join(f'#include "{place}/src/{unit}"\n' for unit in self.UNITS))
        cache = {"CCACHE_DIR": str(place.with_name(f"{place.name}.ccache")), "CCACHE_BASEDIR": "", "CCACHE_DEPEND": "1",
                 "CCACHE_SLOPPINESS": "include_file_ctime,include_file_mtime"}
        done(*words, "-MD", "-g0", cwd=place, env=os.environ | cache)
        return (place / "units.o").read_bytes()

    # The whole library twice: ./dev reproducible.
    @WRITES_NO_PLACES
    def test_of_the_library_wherever_its_sources_lie(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            first, second = pool.map(self.compiled, self.places)
        self.assertEqual(first, second)

    def generated(self, scene, language, place, **environment):
        place.mkdir(parents=True)
        shutil.copy(scene, place)
        done(VCRIT, "generate", scene.name, "--language", language, "--out", "out", cwd=place,
             env=os.environ | environment)
        return {file.name: file.read_bytes() for file in (place / "out").rglob("*") if file.is_file()}

    def test_of_generated_code_at_any_time_and_place(self):
        # Drives with masses or measured ones, and a contact that opens, have no evaluators.
        without = {"separation", "measured_drive", "sonotrode"}
        for scene in with_formula(VCRIT):
            if scene.stem in without:
                continue
            for language in drivers.LANGUAGES:
                name = f"{scene.stem}-{language}"
                with self.subTest(name):
                    first = self.generated(scene, language, self.folder / "here" / name)
                    second = self.generated(scene, language, self.folder / "there/there" / name, TZ="Asia/Tokyo",
                                            LC_ALL="C", HOME="/nonexistent")
                    self.assertTrue(first)
                    self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main()
