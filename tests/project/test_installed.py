"""`cmake --install` finds all that it takes after every command of ./dev that builds in build/release: they build the target
vcrit_installed, and that has whatever is installed from the build folder."""

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


if __name__ == "__main__":
    unittest.main()
