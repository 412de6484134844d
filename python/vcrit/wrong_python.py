"""Why the package cannot be imported: one sentence, which needs nothing but Python."""

import sys
from pathlib import Path


def why(error: ImportError, folder: Path = Path(__file__).parent) -> str:
    """What to say where the extension module or NumPy is missing."""
    running = f"Python {sys.version_info.major}.{sys.version_info.minor} ({sys.executable})"
    built_for = [_version(file.name) for file in sorted(folder.glob("_vcrit.cpython-*.so"))]
    if not built_for:
        return f"vcrit: {folder} holds no module: build it with ./dev build, for Debian's /usr/bin/python3"
    if error.name == "numpy" or sys.version_info[:2] == built_for[0]:
        return (f"vcrit: {running} cannot import {error.name or 'the module'} ({error}); this package was built for "
                "Debian's /usr/bin/python3 and its NumPy (apt-get install python3-numpy)")
    major, minor = built_for[0]
    return (f"vcrit: this package was built for Python {major}.{minor} (Debian's /usr/bin/python3); you run {running}; "
            "run that Python, or build with ./dev build where it is another one")


def _version(name: str) -> tuple[int, int]:
    """Of "_vcrit.cpython-311-x86_64-linux-gnu.so"."""
    digits = name.split("-")[1]
    return int(digits[0]), int(digits[1:])
