"""Compiles each source file and each header of the build folder BUILD on its own, for errors and warnings alone: no code
is made.

    check_alone.py BUILD [FOLDER...]     only files below these folders of the project

Files that are compiled together (cmake/unity.cmake) may lack an include without anybody noticing. Most of the time goes
to what a file includes. What many files include is therefore compiled once and put before them (cmake/compiled_once.py):
headers of others and of the project, each of which is checked on its own as well. They lend a file nothing that it lacks,
as it includes all of them, itself or through headers of the project. A source file that begins with a header may be the
check of that header, too, so that only what this one includes stands before it. A file that has passed is left out as long
as all that it includes, the command and the installed packages stay the same (BUILD/checked.json).

The compiler is clang: it writes in a third of the time of g++ what is compiled once, and instantiates templates that this
uses there, not again in each file. The build compiles the same files by g++, with its warnings.
"""

import collections
import concurrent.futures
import functools
import hashlib
import itertools
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from compiled_once import SAVED, Headers, largest, sets_for

COMPILER = "clang++-16"
# Of no account for errors and warnings, or for g++ alone. What is compiled once would have to be compiled for each of them.
LEFT_OUT = ("-g", "-fPIC", "-fno-semantic-interposition", "-fvisibility=hidden", "-fvisibility-inlines-hidden",
            "-fpch-preprocess", "-Winvalid-pch", "-Wno-maybe-uninitialized", "-Wno-restrict", "-Wno-stringop-overread")
PROCESS = 100  # milliseconds to start one

build, folders = Path(sys.argv[1]), sys.argv[2:]
project = Path(__file__).resolve().parent.parent


def words_of(command):
    """By clang, without what makes a file, and without what CMake puts before it."""
    words = shlex.split(command)
    if Path(words[0]).name == "ccache":
        words = words[1:]
    for option in ("-o", "-c", "-include"):
        if option in words:
            del words[words.index(option):words.index(option) + 2]
    return [COMPILER] + [word for word in words[1:] if word not in LEFT_OUT and not word.startswith("--param")]


def split(words):
    """Macros, folders to search, and what else is said to the compiler."""
    macros, folders, others, left = [], [], [], iter(words)
    for word in left:
        if word == "-isystem":
            folders.append((word, next(left)))
        elif word.startswith("-I"):
            folders.append((word,))
        else:
            (macros if word.startswith("-D") else others).append(word)
    return macros, tuple(folders), others


@functools.cache
def searched_for_own(folders):
    """One object for all files that search the same, as caches are asked with it: comparing folders takes long."""
    return tuple(Path(folder[0][2:]) for folder in folders if len(folder) == 1)


def folder_of(file):
    return file.relative_to(project).parts[0]


class Item:
    """A file to check, the headers that may stand before it, and the set of them that is to."""

    def __init__(self, file, entry, headers):
        self.file, self.entry, self.chosen, self.set = file, entry, 0, None
        self.macros, self.folders, self.options = split(entry["words"])
        searched = searched_for_own(self.folders)
        self.before = headers.before(file, searched)
        self.begun = headers.beginning(file, searched)
        self.read = headers.read(file, searched)
        self.checks = [self.key(self.read, headers)]  # with headers, if it is their check

    def key(self, files, headers):
        texts = [(str(file), headers.digest(file)) for file in files]
        return hashlib.sha256(repr((self.file, self.entry, texts)).encode()).hexdigest() if files else None

    def checked(self):
        what = [self.file] if self.file.suffix == ".cpp" else ["-include", self.file, "-x", "c++", "/dev/null"]
        before = self.set.before() if self.set else []
        return run([*self.entry["words"], *before, "-fsyntax-only", *what], self.entry["directory"])


class Set:
    """Headers compiled once."""

    def __init__(self, path, lines, users):
        self.path, self.users, self.compiled = path, users, None
        path.write_text("".join(lines))

    def words(self):
        """With the macros that all users have, and all folders that they search."""
        macros = [word for word in self.users[0].macros if all(word in user.macros for user in self.users)]
        folders = dict.fromkeys(folder for user in self.users for folder in user.folders)
        return [*self.users[0].options, *macros, *itertools.chain(*folders)]

    def compile(self):
        return run([*self.words(), "-fpch-instantiate-templates", "-x", "c++-header", self.path, "-o", f"{self.path}.pch"],
                   self.users[0].entry["directory"])

    def before(self):
        """Nothing if it could not be compiled: what is wrong with a header is said where that is checked."""
        return [] if self.compiled.result().returncode else ["-include-pch", f"{self.path}.pch"]


def run(words, directory):
    return subprocess.run(words, cwd=directory, capture_output=True, text=True)


def sources():
    """Those of the project, not what the build writes."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = Path(entry["file"])
        own = project in file.parents and build.resolve() not in file.parents
        if file.suffix == ".cpp" and own and (not folders or folder_of(file) in folders):
            yield file, {"words": words_of(entry["command"]), "directory": entry["directory"]}


def headers_of(items, headers):
    """Those in folders of the items, as items, compiled as the first source file that includes it is."""
    first = {}
    for item in items:
        for file in [*item.read, folder_of(item.file)]:
            first.setdefault(file, item)
    for folder in dict.fromkeys(folder_of(item.file) for item in items):
        for header in sorted((project / folder).rglob("*.hpp")):
            yield Item(header, first.get(header, first[folder]).entry, headers)


def without_begun(items, headers):
    """Without the headers that a source file checks, too, as it begins with them: nothing else may be before that, which is
    less work where little more would be."""
    begun = collections.defaultdict(list)
    for item in items:
        if item.before:
            begun[item.begun].append(item)
    for header in items:
        source = min(begun[header.file], key=lambda item: headers.weight(item.chosen), default=None)
        alone = PROCESS + headers.weight(header.before) - SAVED * headers.weight(header.chosen)
        if source and SAVED * (headers.weight(source.chosen) - headers.weight(header.chosen)) < alone:
            source.chosen = header.chosen
            source.checks += header.checks
        else:
            yield header


def sets_of(items, headers, path):
    """Those that items use; all items have the same options."""
    users = collections.defaultdict(list)
    for item in items:
        users[item.chosen].append(item)
    users.pop(0, None)
    for number, (each, using) in enumerate(users.items()):
        made = Set(path.with_suffix(f".{number}.hpp"), headers.lines(each), using)
        for item in using:
            item.set = made
        yield made


def planned(items, headers, folder):
    """The items that need a check, and all sets."""
    groups, needed, sets = collections.defaultdict(list), [], []
    for item in items:
        groups[tuple(item.options)].append(item)
    for number, group in enumerate(groups.values()):
        chosen = sets_for([item.before for item in group], headers.weight)
        for item in group:
            item.chosen = largest(chosen, item.before, headers.weight)
        group = list(without_begun(group, headers))
        sets += sets_of(group, headers, folder / str(number))
        needed += group
    return needed, sets


def environment():
    """What else decides whether a file passes: the compiler and the headers of others, and what is asked here."""
    packages = subprocess.run(["dpkg-query", "-W"], capture_output=True, text=True, check=True).stdout
    return packages + "".join(file.read_text() for file in sorted(Path(__file__).parent.glob("*.py")))


class Passed:
    """Kept in the build folder: the keys of files that have passed in the same environment."""

    def __init__(self, file):
        self.file, self.environment = file, hashlib.sha256(environment().encode()).hexdigest()
        kept = json.loads(file.read_text()) if file.exists() else {}
        self.keys = set(kept.get(self.environment, []))

    def without(self, items):
        return [item for item in items if item.checks[0] not in self.keys]

    def keep(self, keys):
        self.file.write_text(json.dumps({self.environment: sorted((self.keys | set(keys)) - {None})}))


def main():
    found = list(sources())
    macros = {re.match("-D([^=]*)", word)[1] for _, entry in found for word in entry["words"] if word.startswith("-D")}
    headers = Headers(macros)
    items = [Item(file, entry, headers) for file, entry in found]
    items += headers_of(items, headers)
    passed, keys, failures = Passed(build / "checked.json"), [], []
    count = len(items)
    left = passed.without(items)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        left, sets = planned(left, headers, Path(folder))
        for each in sets:
            each.compiled = pool.submit(each.compile)
        for done, (item, result) in enumerate(zip(left, pool.map(Item.checked, left)), 1):
            print(f"[{done}/{len(left)}] {item.file.relative_to(project)}", flush=True)
            if result.returncode:
                failures.append(result.stderr)
            else:
                keys += item.checks
    passed.keep(keys)
    if failures or not count:
        sys.exit("\n".join(failures) + f"{len(failures)} of {len(left)} files do not compile on their own")


main()
