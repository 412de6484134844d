"""ctest over those entries of which something is another than when they last passed.

    run_changed.py BUILD [--all] [WORD...]     in the project's folder; --all and named entries run in any case

What an entry depends on is hashed: its command and environment, the files and folders that these name, those whose
paths are in the programs among them (of a program not the commit that it is made of), the machine, its packages and
tools; of scripts also each file of the project that is no C++, of whatever is given the project's or the build's folder
each file there. An entry that has passed is kept under its hash (BUILD/passed.json) and left out as long as the hash
stays. Without git all entries run.
"""

import functools
import hashlib
import json
import os
import re
import shutil
import stat
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

PROJECT, BUILD = Path.cwd(), Path(sys.argv[1]).resolve()
WORDS = sys.argv[2:]
PASSED, OUTCOMES = BUILD / "passed.json", BUILD / "Testing/outcomes.xml"
# Read by C++ tests, by rooms of whatever name.
ALL_READ = ("scenes", "symbolic/emit/languages", "tests/data", "tests/languages", "tests/support", "bench")
READ_SOURCES = ("consumer", "mutation", "project")  # rooms whose scripts do
# In the build: what tests, ninja and ctest themselves write, and what is linked into something else.
WRITTEN = re.compile(r"(Testing|compilers|mypy_cache|same_bytes|CMakeFiles)/|\.ninja_|passed\.json|install_manifest|commit\.cpp")
VARIABLES = re.compile(r"PATH|HOME|TMPDIR|TZ|LANG|LC_|LD_|PYTHON|VCRIT|(CC|CXX)$|C\w*FLAGS|CPATH|C\w*_PATH|LIBRARY_PATH|OMP|"
                       r"GLIBC|MALLOC|\w*SAN_OPTIONS|SOURCE_DATE|SE_")
TOOLS = ("g++", "gcc", "clang++", "clang", "ld", "nvcc", "rustc", "node", "python3", "cmake", "ctest", "chromium", "mpirun")


def tracked():
    """All files that git knows or would."""
    if not shutil.which("git"):
        return []
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], stdout=subprocess.PIPE)
    return [f"{PROJECT}/{name}" for name in listed.stdout.decode().split("\0") if name] if listed.returncode == 0 else []


# Hundreds of entries depend on thousands of files each: paths are text here, which is compared ten times as fast.
FILES = tracked()
CODE = (".cpp", ".hpp")
NO_CODE = frozenset(file for file in FILES if not file.endswith(CODE))


def without_stamps(text):
    """A program without the commit that it is made of, which tells nothing of what it does, and without the linker's hash
    of all its bytes, a note whose length stands before it."""
    note = text.find(b"\3\0\0\0GNU\0")
    if note >= 4:
        text = text[:note] + text[note + 8 + text[note - 4]:]
    return re.sub(rb"vcrit's commit: .{13}", b"", text, flags=re.DOTALL)


def paths_in(text):
    """All paths of the project in these bytes."""
    found = set(re.findall(re.escape(os.fsencode(PROJECT)) + rb"[-+.\w/]*", text))
    return {os.path.normpath(os.fsdecode(path)) for path in found}


@functools.cache
def read(file, _changed):
    """Its hash and, if it is a program that was built, the paths that it names; once for each time that it was changed."""
    text = Path(file).read_bytes()
    if not (file.startswith(f"{BUILD}/") and text.startswith(b"\x7fELF")):
        return hashlib.sha256(text).hexdigest(), ()
    return hashlib.sha256(without_stamps(text)).hexdigest(), paths_in(text)


@functools.cache
def known(file):
    """The same of what may be no file."""
    try:
        found = os.stat(file)
    except OSError:
        return "no file", ()
    return read(file, (found.st_ino, found.st_size, found.st_ctime_ns)) if stat.S_ISREG(found.st_mode) else ("no file", ())


@functools.cache
def below(folder):
    """The files of the project, or what was built, below a folder of it."""
    if f"{folder}/".startswith(f"{BUILD}/"):
        files = (f"{place}/{name}" for place, _, names in os.walk(folder) for name in names)
        return frozenset(file for file in files if os.path.isfile(file) and not WRITTEN.match(file[len(str(BUILD)) + 1:])
                         and "/CMakeFiles/" not in file[len(str(BUILD)) + 1:])
    return frozenset(file for file in FILES if file.startswith(f"{folder}/"))


def behind(paths):
    """The files that these are or that lie below them."""
    found = set().union(*(below(path) if os.path.isdir(path) else {path} for path in paths))
    if f"{BUILD}/vcrit" in found:  # which starts its neighbour
        found.add(f"{BUILD}/vcrit-sweep")
    return found


@functools.cache
def named_by(file):
    """The files that a program names."""
    return behind(known(file)[1])


def inputs(entry, stated):
    room = entry["name"].split("/")[0]
    new = found = behind(paths_in(os.fsencode(stated)))
    while new:
        new = set().union(*map(named_by, new)) - found
        found = found | new
    found = found.union(*(below(f"{PROJECT}/{folder}") for folder in (*ALL_READ, f"tests/{room}")))
    if any(word.endswith(".py") for word in entry["command"]):
        found |= frozenset(FILES) if room in READ_SOURCES else NO_CODE
    elif f"{BUILD}/build.ninja" not in found:  # they are in the program
        found = {file for file in found if not (file.endswith(CODE) and file.startswith(f"{PROJECT}/tests/"))}
    return sorted(found)


def machine():
    with open("/proc/cpuinfo") as processors:
        flags = [line for line in processors if line.startswith(("model name", "flags"))]
    path = ":".join(each for each in os.environ.get("PATH", "").split(":") if Path(each) != BUILD / "compilers")
    tools = [os.path.realpath(found) for tool in TOOLS if (found := shutil.which(tool, path=path))]
    packages = [file for file in ("/var/lib/dpkg/status", *tools) if os.path.exists(file)]
    return [flags, os.uname().release, os.geteuid(), os.path.exists("/dev/nvidia0"),
            [(file, os.stat(file).st_size, os.stat(file).st_mtime_ns) for file in packages],
            sorted(each for each in os.environ.items() if VARIABLES.match(each[0])), known(os.path.realpath(__file__))[0]]


def entries():
    listed = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], check=True, stdout=subprocess.PIPE)
    return json.loads(listed.stdout)["tests"]


def hashes(listed):
    """{entry: hash} of these entries."""
    for cached in (known, below, named_by):
        cached.cache_clear()
    of_machine, result = machine(), {}
    for entry in listed:
        # Not all that lies in the folder where it runs is for it.
        stated = [entry["command"], [each for each in entry["properties"] if each["name"] not in ("WORKING_DIRECTORY", "COST")]]
        files = [(file, known(file)[0]) for file in inputs(entry, json.dumps(stated))]
        result[entry["name"]] = hashlib.sha256(repr([stated, of_machine, files]).encode()).hexdigest()
    return result


def run(left_out, chosen):
    """ctest's exit status, and the entries that passed and that did not."""
    OUTCOMES.unlink(missing_ok=True)
    words = ["-E", f"^({'|'.join(map(re.escape, left_out))})$"] if left_out else []
    words += ["-R", "|".join(chosen)] if chosen else []
    words += ["--output-on-failure", "--no-tests=error", "--output-junit", OUTCOMES]
    at_once = str(len(os.sched_getaffinity(0)) + 1)  # some tests wait more than they work
    status = subprocess.run(["ctest", "--test-dir", BUILD, "--parallel", at_once, *words]).returncode
    cases = xml.etree.ElementTree.parse(OUTCOMES).iter("testcase") if OUTCOMES.exists() else []
    outcomes = {case.get("name"): case.get("status") == "run" and case.find("failure") is None for case in cases}
    return status, outcomes


def main():
    chosen = [word for word in WORDS if word != "--all"]
    listed = entries()
    before = hashes(listed)
    passed = json.loads(PASSED.read_text()) if PASSED.exists() else {}
    same = [] if WORDS or not FILES else [name for name, value in before.items() if passed.get(name) == value]
    status = 0
    if len(same) < len(before):
        status, outcomes = run(same, chosen)
        after = hashes(listed)  # what was changed meanwhile has not passed
        good = {name: before[name] for name, fine in outcomes.items() if fine and before[name] == after.get(name)}
        PASSED.write_text(json.dumps({name: value for name, value in passed.items() if name not in outcomes} | good))
    if same:
        print(f"Not run: {len(same)} of {len(before)} tests, which have passed with the very same inputs (--all runs them, too)")
    sys.exit(status)


main()
