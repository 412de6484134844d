"""The module in the repository is what its sources make, and asks nothing of a page but libc's few calls."""

import gzip
import os
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


def with_memory(folder):
    """The environment in which build_module's compiler is ccache where that is installed: clang takes a minute for what
    it may have compiled before. ccache knows it by the preprocessed text, and takes the next of the name on PATH."""
    if not (ccache := shutil.which("ccache")):
        return os.environ
    links = Path(folder, "compilers")
    links.mkdir()
    (links / "clang++-16").symlink_to(ccache)
    # The folder's name, which is another each time, is in no output.
    return os.environ | {"PATH": f"{links}:{os.environ['PATH']}", "CCACHE_NOHASHDIR": "1"}


class Module(unittest.TestCase):
    def test_the_sources_make_the_same_bytes(self):
        with tempfile.TemporaryDirectory(prefix="vcrit-module-") as folder:
            made = Path(folder, "simulator.wasm.gz")
            subprocess.run([LIVE / "build_module", made], check=True, env=with_memory(folder))
            self.assertTrue(made.read_bytes() == (LIVE / "simulator.wasm.gz").read_bytes(),
                            "./dev module compiles it anew")

    def test_it_asks_for_no_file_no_clock_and_no_network(self):
        module = gzip.decompress((LIVE / "simulator.wasm.gz").read_bytes())
        self.assertEqual(module[:8], b"\0asm\1\0\0\0")
        self.assertNotIn(str(PROJECT).encode(), module)
        asked = {"environ_get", "environ_sizes_get", "fd_close", "fd_seek", "fd_write", "proc_exit"}
        self.assertEqual({name for place, name in imports(module) if place == "wasi_snapshot_preview1"}, asked)
        self.assertEqual(len(imports(module)), len(asked))


if __name__ == "__main__":
    unittest.main(verbosity=2)
