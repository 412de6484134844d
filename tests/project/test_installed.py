"""What the commands of ./dev build. `cmake --install` finds all that it takes after every one that builds in build/release:
they build the target vcrit_installed, and that has whatever is installed from the build folder. What `./dev demo` builds
before that, vcrit_first, links its own choice of objects, and lacks none."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT, BUILD = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))


def ninja(*words):
    return subprocess.run(["ninja", "-C", BUILD, "-t", *words], check=True, capture_output=True, text=True).stdout


def installed():
    """The files in the build folder that CMake would install, relative to it."""
    files = set()
    for script in BUILD.rglob("cmake_install.cmake"):
        if not {"tests", "bench", "examples"} & set(script.relative_to(BUILD).parts):
            for listed in re.findall(r"file\(INSTALL [^)]*?FILES ([^)]*)\)", script.read_text()):
                files |= set(re.findall(rf'"{re.escape(str(BUILD))}/([^"]+)"', listed))
    return files


class Installed(unittest.TestCase):
    def test_is_all_of_one_target(self):
        built = {line.split(": ")[0] for line in ninja("targets", "all").splitlines()}
        needed = set(re.findall(r'label="([^"]+)"', ninja("graph", "vcrit_installed")))
        files = installed()
        for name in ["vcrit", "vcrit-sweep", "src/libvcrit.a", "symbolic/libvcrit-symbolic.a"]:
            self.assertIn(name, files)
        # Others are written when CMake configures, or beside the program.
        self.assertEqual((files & built) - needed, set())
        self.assertGreaterEqual(len(files & built), 4)

    def test_is_built_by_every_command(self):
        dev = (PROJECT / "dev").read_text()
        # build() adds the target wherever targets are named; other calls name it themselves, or the first third of it.
        self.assertIn('[[ $preset != release ]] || set -- "$@" vcrit_installed', dev)
        calls = re.findall(r'^ *compile ".*?" release ?(.*)$', dev, re.MULTILINE)
        self.assertEqual(set(calls), {"vcrit_first", "vcrit_installed"})
        self.assertLess(dev.index("release vcrit_first"), dev.index("release vcrit_installed"))


class First(unittest.TestCase):
    """Nothing else links vcrit_first."""

    def test_lacks_no_source(self):
        compiled = set()
        for line in ninja("commands", "vcrit_first").splitlines():
            source = re.search(r" -c (\S+\.cxx|\S+\.cpp)$", line)
            if not source:
                continue
            text = Path(source[1]).read_text()
            unit = re.findall(r'^#include "(/[^"]+\.cpp)"$', text, re.MULTILINE) if source[1].endswith(".cxx") else []
            compiled |= {Path(file) for file in unit or [source[1]]}
        self.assertGreater(len(compiled), 100)
        lacking = set()
        seen, new = set(), compiled
        while new:
            new = {header for file in new for header in headers_of(file)} - seen
            seen |= new
        for header in seen:
            source = header.with_suffix(".cpp")
            if source.exists() and source not in compiled:
                lacking.add(str(source.relative_to(PROJECT)))
        self.assertEqual(lacking, set(), "of rooms that vcrit_objects_first leaves out of vcrit_first")


def headers_of(file):
    """The project's headers that a source file includes itself."""
    for name in re.findall(r'^#include "([^"/]+/[^"]+)"$', file.read_text(), re.MULTILINE):
        for folder in ("src", "symbolic"):
            if (PROJECT / folder / name).exists():
                yield PROJECT / folder / name


if __name__ == "__main__":
    unittest.main()
