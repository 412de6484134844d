"""The module in the repository is of the present sources, and asks nothing of a page but libc's few calls."""

import gzip
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from program import PROJECT

LIVE = PROJECT / "validation/live"


def number(data, at):
    """Unsigned LEB128, and the place after it."""
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if byte < 0x80:
            return value, at


def imports(module):
    """(module, name) of each import, by the binary format of WebAssembly."""
    at, found = 8, []
    while at < len(module):
        section, (size, begin) = module[at], number(module, at + 1)
        if section == 2:
            count, here = number(module, begin)
            for _ in range(count):
                words = []
                for _ in range(2):
                    length, here = number(module, here)
                    words.append(module[here:here + length].decode())
                    here += length
                assert module[here] == 0, "a function"
                _, here = number(module, here + 1)
                found.append(tuple(words))
        at = begin + size
    return found


def of_present_sources(live, module):
    """Whether a module bears the hash of what would be compiled, and was not changed after it."""
    ran = subprocess.run([live / "build_module", "--check", module], capture_output=True, text=True)
    assert not ran.stderr, ran.stderr
    return ran.returncode == 0


class Module(unittest.TestCase):
    def test_it_is_of_the_present_sources(self):
        self.assertTrue(of_present_sources(LIVE, LIVE / "simulator.wasm.gz"), "./dev module compiles it anew")

    def test_a_changed_header_or_flag_is_noticed_and_a_comment_is_not(self):
        with tempfile.TemporaryDirectory(prefix="vcrit-module-") as folder:
            for part in ("src", "validation/live"):
                shutil.copytree(PROJECT / part, Path(folder, part))
            live = Path(folder, "validation/live")
            module = live / "simulator.wasm.gz"

            def noticed(path, old, new):
                text = path.read_text()
                self.assertIn(old, text)
                path.write_text(text.replace(old, new, 1))
                same = of_present_sources(live, module)
                path.write_text(text)
                return not same

            self.assertFalse(noticed(Path(folder, "src/scene/scene.hpp"), "#pragma once\n", "#pragma once  // once\n\n"))
            self.assertTrue(noticed(Path(folder, "src/base/errors.hpp"), "class Bug :", "class [[nodiscard]] Bug :"))
            self.assertTrue(noticed(live / "build_module", " -O2 ", " -O1 "))

    def test_it_asks_for_no_file_no_clock_and_no_network(self):
        module = gzip.decompress((LIVE / "simulator.wasm.gz").read_bytes())
        self.assertEqual(module[:8], b"\0asm\1\0\0\0")
        self.assertNotIn(str(PROJECT).encode(), module)
        asked = {"environ_get", "environ_sizes_get", "fd_close", "fd_seek", "fd_write", "proc_exit"}
        self.assertEqual({name for place, name in imports(module) if place == "wasi_snapshot_preview1"}, asked)
        self.assertEqual(len(imports(module)), len(asked))


if __name__ == "__main__":
    unittest.main(verbosity=2)
