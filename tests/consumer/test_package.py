"""The installed package as its users meet it: installed to a folder of its own, moved from there, and
then found by CMake and by pkg-config.

    test_package.py PROJECT BUILD COMPILER LAUNCHER FLAGS
"""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, BUILD, COMPILER, LAUNCHER, FLAGS = (sys.argv.pop(1) for _ in range(5))
SCENE = f"{PROJECT}/scenes/elastic.toml"
HERE = Path(__file__).parent
# Eq. (31) with the numbers of the scene; each of seven numbers and six operations is rounded at most
# once, by 2^-53 relative.
VELOCITY = 0.3 * 2 * math.pi * 20e3 * 0.1e-6 * 11.5 / 9.47
ROUNDING = 13 * 2.0**-53
# What CMake found out of this very compiler; with it there, and told so, it does not ask again, which takes longer than
# our own part.
COMPILER_FACTS = [file for file in Path(BUILD, "CMakeFiles").glob("*.*/*") if file.suffix in {".bin", ".cmake"}]
NO_GINAC = {"PKG_CONFIG_LIBDIR": "/nonexistent", "PKG_CONFIG_PATH": ""}

CACHED = {}


def run(*command, folder=None, **environment):
    return subprocess.run([str(word) for word in command], cwd=folder, env=os.environ | CACHED | environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def done(*command, **where):
    ended = run(*command, **where)
    if ended.returncode != 0:
        raise AssertionError(f"{command} ended with {ended.returncode}:\n{ended.stdout}")
    return ended.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        # ccache knows what it compiled in another such folder.
        CACHED.update(CCACHE_BASEDIR=str(cls.folder), CCACHE_NOHASHDIR="1", CCACHE_DEPEND="1")
        done("cmake", "--install", BUILD, "--prefix", cls.folder / "installed")
        cls.prefix = cls.folder / "whole/vcrit"
        cls.prefix.parent.mkdir()
        (cls.folder / "installed").rename(cls.prefix)
        cls.numeric = cls.folder / "numeric/vcrit"
        done("cmake", "--install", BUILD, "--prefix", cls.numeric, "--component", "numeric")

    def configure(self, name, source, *options, prefix=None, **environment):
        """Configures a consumer; the outcome and its build folder, beside the package: ccache sees the same headers there."""
        prefix = prefix or self.prefix
        build = prefix.with_name(f"build-{name}")
        for file in COMPILER_FACTS:
            known = build / "CMakeFiles" / file.parent.name
            known.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, known)
        outcome = run("cmake", "-G", "Ninja", "-S", source, "-B", build, "-DCMAKE_PLATFORM_INFO_INITIALIZED=1",
                      f"-DCMAKE_CXX_COMPILER={COMPILER}", f"-DCMAKE_CXX_COMPILER_LAUNCHER={LAUNCHER}",
                      f"-DCMAKE_CXX_FLAGS={FLAGS}", f"-DCMAKE_C_FLAGS={FLAGS}", f"-DCMAKE_PREFIX_PATH={prefix}",
                      *options, **environment)
        return outcome, build

    def built(self, name, source, *options, **where):
        outcome, build = self.configure(name, source, *options, **where)
        self.assertEqual(outcome.returncode, 0, outcome.stdout)
        done("cmake", "--build", build)
        return build

    def check_numeric(self, program):
        first, header, *rows = done(program, SCENE).split("\n")
        velocity, simulated, above = map(float, first.split())
        self.assertAlmostEqual(velocity / VELOCITY, 1, delta=ROUNDING)
        self.assertAlmostEqual(simulated / VELOCITY, 1, delta=1e-9)  # what the simulation promises
        self.assertAlmostEqual(above, 1, delta=1e-8)  # 1e-10 a step, some 50 steps a period
        self.assertEqual(header, "mu0,critical_velocity")
        swept = [[float(number) for number in row.split(",")] for row in rows if row]
        self.assertEqual([mu0 for mu0, _ in swept], [0.3, 0.6])
        for mu0, v in swept:  # v* is linear in mu0
            self.assertAlmostEqual(v / (VELOCITY * mu0 / 0.3), 1, delta=ROUNDING + 2.0**-52)
        linked = done("ldd", program) + done("nm", "-C", program)
        self.assertNotRegex(linked, r"ginac|GiNaC|libcln|cln::")
        self.assertIn("vcrit::read_scene", linked)

    def check_symbolic(self, program):
        # As above, and GiNaC's seventeen digits: half a unit in the last of them.
        self.assertAlmostEqual(float(done(program, SCENE)) / VELOCITY, 1, delta=ROUNDING + 0.5e-16)
        self.assertRegex(done("ldd", program), "libginac")

    def test_numeric_library_needs_no_ginac(self):
        build = self.built("numeric", HERE / "numeric", **NO_GINAC)
        self.check_numeric(build / "consumer")

    def test_numeric_component_stands_alone(self):
        self.check_numeric(self.built("numeric", HERE / "numeric", prefix=self.numeric) / "consumer")
        outcome, _ = self.configure("absent", HERE / "symbolic", prefix=self.numeric)
        self.assertNotEqual(outcome.returncode, 0)
        self.assertIn("vcrit's component symbolic", outcome.stdout)

    def test_symbolic_component(self):
        self.check_symbolic(self.built("symbolic", HERE / "symbolic") / "consumer")

    def test_symbolic_component_names_what_it_misses(self):
        outcome, _ = self.configure("missing", HERE / "symbolic", **NO_GINAC)
        self.assertNotEqual(outcome.returncode, 0)
        self.assertIn("For component symbolic is missing: ginac", outcome.stdout)

    def test_symbolic_component_may_be_optional(self):
        for found, environment in [("TRUE", {}), ("FALSE", NO_GINAC)]:
            outcome, _ = self.configure(f"optional-{found}", HERE / "symbolic", "-DOPTIONAL=ON", **environment)
            self.assertEqual(outcome.returncode, 0, outcome.stdout)
            self.assertIn(f"symbolic: {found}", outcome.stdout)

    def test_version(self):
        for wanted, status in [("0.1", 0), ("0.0.9", 1), ("0.2", 1), ("1", 1)]:
            outcome, _ = self.configure(f"version-{wanted}", HERE / "numeric", f"-DWANTED_VERSION={wanted}")
            self.assertEqual(outcome.returncode, status, f"{wanted}: {outcome.stdout}")

    def pkg_config(self, *words):
        path = next(self.prefix.glob("lib*/**/pkgconfig"))
        return done("pkg-config", *words, PKG_CONFIG_PATH=str(path)).split()

    def compiled(self, source, package):
        """An object file, and programs linked from it as a static and as any other one."""
        program, object_file = self.folder / "by-pkg-config", self.folder / "by-pkg-config.o"
        done(*LAUNCHER.split(), COMPILER, *FLAGS.split(), "-std=c++20", "-MD", "-c", source, "-o", object_file,
             *self.pkg_config("--cflags", package), folder=self.folder)
        for words in [["--static"], []]:
            done(COMPILER, *FLAGS.split(), object_file, "-o", program, *self.pkg_config("--libs", *words, package))
            yield program

    def test_pkg_config(self):
        for program in self.compiled(HERE / "numeric/main.cpp", "vcrit"):
            self.check_numeric(program)
        for program in self.compiled(HERE / "symbolic/main.cpp", "vcrit-symbolic"):
            self.check_symbolic(program)
        self.assertEqual(self.pkg_config("--modversion", "vcrit"), self.pkg_config("--modversion", "vcrit-symbolic"))
        # A project may use toml++ in its own way: no public header does.
        self.assertNotIn("TOML", " ".join(self.pkg_config("--cflags", "vcrit")))

    # That each stands alone is for `./dev check`.
    def test_all_headers_are_there(self):
        headers = sorted(self.prefix.glob("include/vcrit/**/*.hpp"))
        self.assertGreater(len(headers), 40)
        flags = ["-std=c++20", "-Wall", "-Wextra", "-Werror", *self.pkg_config("--cflags", "vcrit-symbolic")]
        source = self.folder / "headers.cpp"
        source.write_text("".join(f"#include <{header.relative_to(self.prefix / 'include')}>\n" for header in headers))
        done(*LAUNCHER.split(), COMPILER, *flags, "-MD", "-c", "headers.cpp", "-o", "headers.o", folder=self.folder)

    def test_program_runs(self):
        program = self.prefix / "bin/vcrit"
        self.assertIn("4.57803364", done(program, "eval", SCENE, "--digits", "17"))  # VELOCITY, by hand, in mm/s
        self.assertIn(self.pkg_config("--modversion", "vcrit")[0], done(program, "--version"))
        table = self.folder / "sweep.csv"
        done(program, "sweep", SCENE, "--over", "mu0=lin:0.3:0.6:2", "--quantity", "critical_velocity", "--out", table)
        self.assertEqual(len(table.read_text().splitlines()), 3)

    def test_shell_finds_its_files(self):
        for file in ["bash-completion/completions/vcrit", "zsh/site-functions/_vcrit"]:
            self.assertIn("vcrit", (self.prefix / "share" / file).read_text())
        page = done("man", "-M", self.prefix / "share/man", "vcrit", LC_ALL="C.UTF-8", MANPAGER="cat")
        self.assertIn("critical velocity of friction control", page)

    # Errors and the man page name docs/*.md; README.md shows scenes.
    def test_texts_and_scenes_come_along(self):
        share = self.prefix / "share/doc/vcrit"
        for folder, pattern in [("docs", "*.md"), ("docs", "*.svg"), ("docs/tutorial", "*"), ("scenes", "*"), ("examples", "*.c*"), (".", "README.md")]:
            expected = {file.name: file.read_bytes() for file in Path(PROJECT, folder).glob(pattern)}
            self.assertGreater(len(expected), 0)
            self.assertEqual({file.name: file.read_bytes() for file in (share / folder).glob(pattern)}, expected)
        for scene in ["zener.toml", "measured_drive.toml"]:
            self.assertIn("critical velocity", done(self.prefix / "bin/vcrit", "eval", share / "scenes" / scene))

    def test_links_of_its_texts_lead_somewhere(self):
        share = self.prefix / "share/doc/vcrit"
        links = [(page, link) for page in share.rglob("*.md") for link in re.findall(r"\]\(([^)#\s]+)", page.read_text())
                 if ":" not in link]
        self.assertGreater(len({page for page, _ in links}), 20)
        self.assertEqual([(page.name, link) for page, link in links if not (page.parent / link).exists()], [])

    # The lines of docs/library.md and no more: no standard, no second language.
    def test_project_of_the_library_page(self):
        source = self.folder / "page"
        source.mkdir()
        page = Path(PROJECT, "docs/library.md").read_text()
        numeric, _, link = re.search(r"```cmake\n(.*?)```", page, re.DOTALL)[1].splitlines()
        (source / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.20)\nproject(sample CXX)\n"
                                               f"{numeric}\nadd_executable(mine mine.cpp)\n{link}\n")
        (source / "mine.cpp").write_text(self.program_of_the_page())
        build = self.built("page", source)
        self.check_page(build / "mine")

    def check_page(self, program):
        self.assertAlmostEqual(float(done(program, SCENE).split()[2]) / VELOCITY, 1, delta=ROUNDING)
        ended = run(program, "no such file")
        self.assertEqual(ended.returncode, 1)
        self.assertIn("no such file", ended.stdout)

    @staticmethod
    def program_of_the_page():
        blocks = re.findall(r"```cpp\n(.*?)```", Path(PROJECT, "docs/library.md").read_text(), re.DOTALL)
        (block,) = [block for block in blocks if "<vcrit/vcrit.hpp>" in block]
        return block

    def test_program_of_the_page(self):
        source = self.folder / "page.cpp"
        source.write_text(self.program_of_the_page())
        for program in self.compiled(source, "vcrit"):
            self.check_page(program)

    # Optimised and without warnings, as they would be in the project.
    def test_examples_build_against_it(self):
        flags = f"{FLAGS} -Wall -Wextra -Wconversion -Wshadow -Werror"
        build = self.built("examples", f"{PROJECT}/examples", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_C_FLAGS={flags}",
                           f"-DCMAKE_CXX_FLAGS={flags}")
        done(sys.executable, "-B", HERE / "test_examples.py", PROJECT, build)

    def test_names_no_place(self):
        for file in sorted(self.prefix.rglob("*")):
            if file.suffix in {".cmake", ".pc", ".hpp", ".1"}:
                for place in [PROJECT, BUILD, str(self.folder)]:
                    self.assertNotIn(place, file.read_text(), file)


if __name__ == "__main__":
    unittest.main()
