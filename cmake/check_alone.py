"""Compiles each source file of the build folder BUILD on its own, for errors and warnings alone: no code is made. So
with each header that no source file begins with.

    check_alone.py BUILD [FOLDER...]     only files below these folders of the project

Files that are compiled together (cmake/unity.cmake) may lack an include without anybody noticing. Most of the time goes
to headers of others, which are therefore compiled once and put before the file. They lend it nothing that it lacks: they
are among those that it includes, itself or through headers of the project. A source file that begins with a header of
the project is the check of that header, too, so that only what this one includes may stand before it; where the file
includes something large beside, its header is checked on its own, which takes less.
"""

import collections
import concurrent.futures
import functools
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

build, folders = Path(sys.argv[1]), sys.argv[2:]
project = Path(__file__).resolve().parent.parent
# What is compiled once, the costliest first: a file takes the first all of which it includes. Any set is right; these were
# chosen, one after the other, by how much less all files read.
LARGE = [set(headers.split()) for headers in (  # each takes the compiler more than a second
    "Eigen/Core", "nlohmann/json.hpp optional string utility vector", "CLI/CLI.hpp", "ginac/ginac.h")]
OFTEN = "compare cstddef functional map memory optional stdexcept string string_view utility variant vector"
BEFORE = [*LARGE, *(set(headers.split()) for headers in (f"{OFTEN} complex", OFTEN, "memory string", "string", "vector"))]
# Of no account for errors and warnings, but what is compiled once would have to be compiled for each of them.
FOR_CODE = ("-g", "-fPIC", "-fno-semantic-interposition")
FEWEST = 5  # files that something is compiled once for, which takes as long as three of them save


def command_of(entry):
    """Without what makes a file."""
    words = shlex.split(entry["command"])
    if Path(words[0]).name == "ccache":
        words = words[1:]
    for option in ("-o", "-c"):
        del words[words.index(option):words.index(option) + 2]
    return [word for word in words if word not in FOR_CODE]


@functools.cache
def includes(file):
    """Whether it is unconditional, quotation mark or bracket, and name of each include."""
    found, conditions = [], 0
    for line in file.read_text().splitlines():
        if directive := re.match(r'\s*#\s*(if|endif|include\s*([<"])(.*)[>"])', line):
            conditions += {"if": 1, "endif": -1}.get(directive[1], 0)
            if directive[2]:
                found.append((conditions == 0, directive[2], directive[3]))
    return found


def header_of_project(file, name, searched):
    return next((folder / name for folder in (file.parent, *searched) if (folder / name).is_file()), None)


def begun_with(file, searched):
    """The header of the project that nothing stands before."""
    unconditional, mark, name = next(iter(includes(file)), (False, "", ""))
    return header_of_project(file, name, searched) if unconditional and mark == '"' else None


def headers_of_others(file, searched):
    """All that it includes in any case, itself or through headers of the project."""
    found, seen, left = set(), {file}, [file]
    while left:
        file = left.pop()
        for unconditional, mark, name in includes(file):
            own = header_of_project(file, name, searched) if unconditional and mark == '"' else None
            if own and own not in seen:
                seen.add(own)
                left.append(own)
            elif unconditional and mark == "<":
                found.add(name)
    return found


@functools.cache
def before(file, searched):
    """What may be put before a file that nothing else is asked of."""
    included = headers_of_others(file, searched)
    return next((each for each in BEFORE if each <= included), set())


def shared(entry):
    """What may be put before it, and the options that this is compiled with."""
    headers = sorted(before(entry["begun with"] or entry["file"], entry["searched"]))
    return tuple(headers), tuple(word for word in entry["words"] if word.startswith(("-f", "-m", "-O", "-W")))


class Precompiled:
    """Headers compiled once for each set of them and of options."""

    def __init__(self, folder, entries):
        self.folder, self.commands, self.users = folder, {}, collections.Counter(map(shared, entries))

    def words(self, entry):
        """The entry's command with them."""
        command, key = entry["words"], shared(entry)
        if not key[0] or self.users[key] < FEWEST:
            return command
        header = self.folder / f"before_{[*self.commands, key].index(key)}.hpp"
        if key not in self.commands:
            header.write_text("".join(f"#include <{each}>\n" for each in key[0]))
            without_macros = [word for word in command if not word.startswith("-D")]  # the compiler checks those of users
            self.commands[key] = {"words": [*without_macros, "-x", "c++-header", header, "-o", f"{header}.gch"],
                                  "directory": entry["directory"]}
        return [*command, "-include", header, "-Winvalid-pch"]


def run(entry):
    return subprocess.run(entry["words"], cwd=entry["directory"], capture_output=True, text=True)


def read(entry):
    """With its command and the folders where headers of the project are."""
    words = command_of(entry)
    searched = tuple(Path(word[2:]) for word in words if word.startswith("-I"))
    file = Path(entry["file"])
    begun = begun_with(file, searched)
    if begun and before(file, searched) in LARGE and before(begun, searched) not in LARGE:
        begun = None
    return entry | {"file": file, "words": words, "searched": searched, "begun with": begun}


def folder_of(entry):
    return Path(entry["file"]).relative_to(project).parts[0]


def headers_without_file(entries):
    """As entries: compiled as a source file of the same folder would be."""
    begun = {entry["begun with"] for entry in entries}
    for folder in sorted({folder_of(entry) for entry in entries}):
        like = next(entry for entry in entries if folder_of(entry) == folder)
        for header in sorted((project / folder).rglob("*.hpp")):
            if header not in begun:
                yield like | {"file": header, "header": True, "begun with": None}


entries = [read(entry) for entry in json.loads((build / "compile_commands.json").read_text())
           if entry["file"].endswith(".cpp") and project in Path(entry["file"]).parents
           and (not folders or folder_of(entry) in folders)]
entries += headers_without_file(entries)
failures = []
with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    precompiled = Precompiled(Path(folder), entries)
    for entry in entries:
        what = ["-include", entry["file"], "-x", "c++", "/dev/null"] if entry.get("header") else [entry["file"]]
        entry["words"] = [*precompiled.words(entry), "-fsyntax-only", *what]
    failures += [result.stderr for result in pool.map(run, precompiled.commands.values()) if result.returncode]
    for done, (entry, result) in enumerate(zip(entries, pool.map(run, entries)), 1):
        print(f"[{done}/{len(entries)}] {entry['file'].relative_to(project)}", flush=True)
        if result.returncode:
            failures.append(result.stderr)
if failures or not entries:
    sys.exit("\n".join(failures) + f"{len(failures)} of {len(entries)} files do not compile on their own")
