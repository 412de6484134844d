"""Compiles each source file of the build folder BUILD on its own, for errors and warnings alone: no code is made. So
with each header of the libraries that no source file begins with.

    check_alone.py BUILD [FOLDER...]     only files below these folders of the project

Files that are compiled together (cmake/unity.cmake) may lack an include without anybody noticing. Large headers of
others are compiled once where nothing of the project stands before them, so that they lend nothing to what should have
included it.
"""

import concurrent.futures
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
# Each takes the compiler 0.7 to 1.7 s.
LARGE = ("ginac/ginac.h", "nlohmann/json.hpp", "Eigen/Dense", "CLI/CLI.hpp")


def command_of(entry):
    """Without what makes a file."""
    words = shlex.split(entry["command"])
    if Path(words[0]).name == "ccache":
        words = words[1:]
    for option in ("-o", "-c"):
        del words[words.index(option):words.index(option) + 2]
    return words


def included_first(file, searched, seen):
    """The headers of others that a file includes before anything else is read, and whether there is nothing else."""
    found, seen = [], seen | {file}
    for line in file.read_text().splitlines():
        include = re.match(r'#include ([<"])(.*)[>"]', line)
        if include and include[1] == '"':
            own = next((folder / include[2] for folder in [file.parent, *searched] if (folder / include[2]).is_file()), None)
            more, whole = included_first(own, searched, seen) if own and own not in seen else ([], False)
            found += more
            if not whole:
                return found, False
        elif include:
            found.append(include[2])
        elif line.strip() and not line.startswith(("//", "#pragma once")):
            return found, False
    return found, True


class Precompiled:
    """The large headers that files begin with, compiled once for each set of them and of options."""

    def __init__(self, folder):
        self.folder, self.made = folder, {}

    def words(self, file, command):
        """The command with them."""
        searched = [Path(word[2:]) for word in command if word.startswith("-I")]
        headers = set(included_first(file, searched, set())[0]).intersection(LARGE)
        if not headers:
            return command
        key = (*sorted(headers), *(word for word in command if word.startswith(("-f", "-m", "-O", "-W"))))
        if key not in self.made:
            header = self.folder / f"large_{len(self.made)}.hpp"
            header.write_text("".join(f"#include <{each}>\n" for each in sorted(headers)))
            without_macros = [word for word in command if not word.startswith("-D")]  # the compiler checks those of users
            subprocess.run([*without_macros, "-x", "c++-header", header, "-o", f"{header}.gch"], check=True)
            self.made[key] = header
        return [*command, "-include", self.made[key], "-Winvalid-pch"]


def alone(entry):
    return subprocess.run(entry["words"], cwd=entry["directory"], capture_output=True, text=True)


def headers_without_file(entries):
    """As entries: compiled as a source file of the same library would be."""
    begun_with = set()
    for entry in entries:
        first = re.search(r'^#include "(.*)"', Path(entry["file"]).read_text(), re.MULTILINE)
        begun_with.add(first[1] if first else "")
    for library in ("src", "symbolic"):
        like = [entry for entry in entries if Path(entry["file"]).relative_to(project).parts[0] == library]
        for header in sorted((project / library).rglob("*.hpp")) if like else []:
            if str(header.relative_to(project / library)) not in begun_with:
                yield like[0] | {"file": str(header), "header": True}


entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
           if entry["file"].endswith(".cpp") and project in Path(entry["file"]).parents
           and (not folders or Path(entry["file"]).relative_to(project).parts[0] in folders)]
entries += headers_without_file(entries)
failures = []
with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    precompiled = Precompiled(Path(folder))
    for entry in entries:
        command = precompiled.words(Path(entry["file"]), command_of(entry))
        read = ["-include", entry["file"], "-x", "c++", "/dev/null"] if entry.get("header") else [entry["file"]]
        entry["words"] = [*command, "-fsyntax-only", *read]
    for done, (entry, result) in enumerate(zip(entries, pool.map(alone, entries)), 1):
        print(f"[{done}/{len(entries)}] {Path(entry['file']).relative_to(project)}", flush=True)
        if result.returncode:
            failures.append(result.stderr)
if failures or not entries:
    sys.exit("\n".join(failures) + f"{len(failures)} of {len(entries)} files do not compile on their own")
