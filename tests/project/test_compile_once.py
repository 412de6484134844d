"""tests/support/compile_once: the same text is compiled once, any other again."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv.pop(1)) / "tests" / "support" / "compile_once"


class CompileOnce(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.links, self.real, self.log = self.folder / "links", self.folder / "real", self.folder / "log"
        self.links.mkdir()
        self.real.mkdir()
        (self.links / "cc1").symlink_to(SCRIPT)
        # A compiler whose output is all that it sees, and that is told of each time it runs.
        compiler = self.real / "cc1"
        compiler.write_text(f'#!/bin/sh\necho run >> {self.log}\necho "warning in $PWD/$1" >&2\nall=\n'
                            'while [ "$1" != -o ]; do [ ! -f "$1" ] || all="$all$(cat "$1")"; shift; done\nprintf %s "$all" > "$2"\n'
                            '! grep -q bad "$2"\n')
        compiler.chmod(0o755)

    def compile(self, name, files, *arguments):
        """What the compiler makes of the files, in a folder of that name, and whether it ran."""
        place = self.folder / name
        place.mkdir(exist_ok=True)
        for file, text in files.items():
            (place / file).write_text(text)
        before = self.runs()
        ran = subprocess.run([self.links / "cc1", *arguments, "-o", "out"], cwd=place, capture_output=True, text=True,
                             env={"PATH": f"{self.links}:{self.real}:/usr/bin:/bin"})
        made = (place / "out").read_text() if (place / "out").exists() else None
        return made, ran.returncode, ran.stderr, self.runs() > before

    def runs(self):
        return self.log.read_text().count("run") if self.log.exists() else 0

    def test_the_same_text_once(self):
        first = self.compile("a", {"m.cpp": "text", "h.hpp": "header"}, "m.cpp")
        second = self.compile("b", {"m.cpp": "text", "h.hpp": "header"}, "m.cpp")
        self.assertEqual(first[:2], ("text", 0))
        self.assertEqual(second[:2], first[:2])
        self.assertTrue(first[3])
        self.assertFalse(second[3])
        # Messages speak of the folder in which it was asked for.
        self.assertIn(f"{self.folder}/b/m.cpp", second[2])

    def test_the_same_code_of_another_scene_once(self):
        def generated(scene, run, batch_run, code="code"):
            guard = "VCRIT_GENERATED_x_HPP"
            return {"m.cpp": "text", "x.hpp": f"// Scene: {scene}\n#define {guard} 0x{run}ULL\n{code}\n",
                    "x_batch.hpp": f"// Of {scene}\n#if {guard} != 0x{batch_run}ULL\n"}

        one, other = "0123456789abcdef", "fedcba9876543210"
        for name, files, again in (("a", generated("a", one, one), True), ("b", generated("b", other, other), False),
                                   ("c", generated("b", one, other), True),
                                   ("d", generated("a", one, one, "// code"), True),
                                   ("e", generated("a\n// b", one, one), True)):
            self.assertEqual(self.compile(name, files, "m.cpp")[3], again, name)

    def test_anything_else_again(self):
        self.compile("a", {"m.cpp": "text", "h.hpp": "header", "o.o": "object"}, "m.cpp", "o.o")
        for number, (files, arguments) in enumerate([
                ({"m.cpp": "other", "h.hpp": "header", "o.o": "object"}, ("m.cpp", "o.o")),
                ({"m.cpp": "text", "h.hpp": "other", "o.o": "object"}, ("m.cpp", "o.o")),
                ({"m.cpp": "text", "h.hpp": "header", "o.o": "other"}, ("m.cpp", "o.o")),
                ({"m.cpp": "text", "h.hpp": "header", "o.o": "object"}, ("o.o", "m.cpp"))]):
            self.assertTrue(self.compile(f"b{number}", files, *arguments)[3], number)
        compiler = self.real / "cc1"
        compiler.write_text(compiler.read_text() + "# another version\n")
        same = {"m.cpp": "text", "h.hpp": "header", "o.o": "object"}
        self.assertTrue(self.compile("c", same, "m.cpp", "o.o")[3])

    def test_failures_are_told_each_time(self):
        for name in ("a", "b"):
            made, status, message, _ = self.compile(name, {"m.cpp": "bad"}, "m.cpp")
            self.assertEqual((status, made), (1, "bad"))
            self.assertIn("warning", message)

    def test_what_lies_elsewhere_is_compiled_each_time(self):
        (self.folder / "elsewhere.cpp").write_text("text")
        for _ in range(2):
            self.assertTrue(self.compile("a", {}, "../elsewhere.cpp")[3])
            for words in (["-I.."], ["-I", ".."], ["-L."], ["-include", "h.hpp"]):
                self.assertTrue(self.compile("a", {"m.cpp": "text", "h.hpp": "header"}, *words, "m.cpp")[3], words)

    def test_includes_from_the_folder_itself_are_kept(self):
        for words in (["-I."], ["-I", "."], ["-Iinner"]):
            for name, ran in (("a", True), ("b", False)):
                self.assertEqual(self.compile(name, {"m.cpp": "text"}, *words, "m.cpp")[3], ran, words)
        self.assertTrue(self.compile("c", {"m.cpp": "text", "more.cuh": "header"}, "-I.", "m.cpp")[3])


if __name__ == "__main__":
    unittest.main()
