"""The wheel of `pip install .` (PEP 517), of what CMake builds and installs; Python's own library alone.

It is built in build/release, as by ./dev, so that what is there already is not built again. VCRIT_BUILD=FOLDER in the
environment, or --config-settings build=FOLDER, takes the package of a finished build as it is.
"""

import base64
import hashlib
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
DEBIANS = "/usr/bin/python3"  # which cmake/find_python.cmake takes
FIRST = "run ./dev build first, which installs what the build needs (Debian 12), then pip again"


class UnsupportedOperation(Exception):
    """Of build_sdist, by PEP 517."""


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("the sources of vcrit are the checkout: git archive packs them")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    given = (config_settings or {}).get("build") or os.environ.get("VCRIT_BUILD")
    if not given:
        refuse_other_python(suffix_of(DEBIANS))
    folder = Path(given) if given else built()
    with tempfile.TemporaryDirectory() as prefix:
        run("cmake", "--install", folder, "--component", "python", "--prefix", prefix, "--strip")
        metadata = next(Path(prefix).rglob("vcrit-*.dist-info"), None)
        if metadata is None:
            raise SystemExit(f"vcrit: {folder} was built without the Python module: {FIRST}")
        module = next(metadata.parent.glob("vcrit/_vcrit.*.so"))
        refuse_other_python(module.name.removeprefix("_vcrit"))
        return pack(metadata, Path(wheel_directory))


def suffix_of(python):
    """Of extension modules: ".cpython-311-x86_64-linux-gnu.so"."""
    asked = "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"
    try:
        return subprocess.run([python, "-I", "-c", asked], check=True, capture_output=True, text=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        raise SystemExit(f"vcrit: the Python module is built for Debian's {DEBIANS}, which does not run here") from None


def refuse_other_python(suffix):
    if suffix == sysconfig.get_config_var("EXT_SUFFIX"):
        return
    digits = suffix.split("-")[1]
    raise SystemExit(f"vcrit: this package is built for Python {digits[0]}.{digits[1:]} (Debian's {DEBIANS}); you run Python "
                     f"{sys.version_info.major}.{sys.version_info.minor} ({sys.executable}): make the environment with "
                     f"{DEBIANS} -m venv --system-site-packages")


def built():
    folder = PROJECT / "build/release"
    cache = folder / "CMakeCache.txt"
    known = cache.read_text() if cache.is_file() else ""
    if "\nVCRIT_PYTHON:BOOL=ON\n" not in known:
        tests = [] if "\nBUILD_TESTING:BOOL=" in known else ["-DBUILD_TESTING=OFF"]
        run("cmake", "--preset", "release", "-DVCRIT_PYTHON=ON", *tests)
    run("cmake", "--build", folder, "--target", "_vcrit")
    return folder


def run(*command):
    if shutil.which(command[0]) is None:
        raise SystemExit(f"vcrit: no {command[0]}: {FIRST}")
    if subprocess.run(list(map(str, command)), cwd=PROJECT).returncode != 0:
        raise SystemExit(f"vcrit: {' '.join(map(str, command[:2]))} failed: {FIRST}")


def pack(metadata, folder):
    """A wheel of the package beside its metadata; the same bytes for the same files."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    name = f"{metadata.name.removesuffix('.dist-info')}-{tag}.whl"
    (metadata / "INSTALLER").unlink()  # pip writes its own
    (metadata / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: vcrit\nRoot-Is-Purelib: false\nTag: {tag}\n")
    site, record = metadata.parent, f"{metadata.name}/RECORD"
    lines = []
    with zipfile.ZipFile(folder / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file in sorted(file for part in (site / "vcrit", metadata) for file in part.rglob("*") if file.is_file()):
            path, content = file.relative_to(site).as_posix(), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            lines.append(f"{path},sha256={digest},{len(content)}\n")
            add(wheel, path, content)
        add(wheel, record, "".join([*lines, f"{record},,\n"]).encode())
    return name


def add(wheel, path, content):
    entry = zipfile.ZipInfo(path)  # of 1980
    entry.external_attr = 0o644 << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    wheel.writestr(entry, content)
