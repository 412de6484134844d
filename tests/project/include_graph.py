"""The include graph of the project and the arrows in it that are not allowed.

The rooms stand in one order and a file may include only files of its own room or of an earlier one;
seven rules beyond the order are written down below. Quoted includes are the project's own files,
looked up beside the including file and then from the roots, as the compiler does; a file that the
build writes stands as its template NAME.in.
"""

import re
from pathlib import Path

# Earliest first; the folder of each room.
ROOMS = [
    "src/base",
    "src/linear",
    "src/record",
    "src/network",
    "src/scene",
    "src/problem",
    "src/stiffness",
    "src/modes",
    "src/normal",
    "src/rules",
    "src/critical",
    "src/fit",
    "src/realisation",
    "src/simulation/system",
    "src/simulation/motion",
    "src/simulation/steady",
    "src/simulation/methods",
    "src/indenter",
    "src/answers",
    "src/sweep",
    "src/maps",
    "src/design",
    "symbolic/formula",
    "symbolic/polynomial",
    "symbolic/derivation",
    "symbolic/analysis",
    "symbolic/shortest",
    "symbolic/facts",
    "symbolic/document",
    "symbolic/program",
    "symbolic/emit",
    "validation/run",
    "validation/figures",
    "validation/compare",
    "validation/accuracy",
    "validation/extremes",
    "validation/paper",
    "validation/live",
    "validation/report",
    "validation/pictures",
    "app",
    "python",
    # Outside the product: it may know all of it, and nothing of the product knows it.
    "bench/harness",
    "bench/simulators",
    "bench/scaling",
    "bench/bounds",
    "bench/speed",
    "bench",
]

ROOTS = ["src", "symbolic", "validation", "app", "python", "bench"]

# Simulation is the independent witness of Eq. (24): it must not know the formula, nor the formula it.
# The pairs hold for all rooms inside these folders.
FORBIDDEN = {
    ("src/simulation", "src/critical"),
    ("src/indenter", "src/critical"),
    ("symbolic", "src/simulation"),
    # Methods beside the exact one are witnesses against it, too: they share no code but the system.
    ("src/simulation/methods", "src/modes"),
    ("src/simulation/methods", "src/normal"),
    ("src/simulation/methods", "src/simulation/motion"),
    ("src/simulation/methods", "src/simulation/steady"),
    # The module for Python is the two libraries and pictures, without program and report.
    ("python", "app"),
    *(("python", room) for room in ROOMS if room.startswith("validation/") and room != "validation/pictures"),
}

# v* found in one way alone, by Eq. (24), which need not be that of the scene. Who uses it says so: what asks for v*
# asks src/answers, which knows where the formula holds. The symbolic rooms are of the formula, and validation holds
# each way against the others.
ONE_WAY = {
    "src/critical/critical_velocity.hpp",
    "src/critical/certified.hpp",
    "src/critical/batch.hpp",
    "src/critical/log_derivative.hpp",
}
KNOW_ONE_WAY = {"src/critical", "src/answers", "symbolic", "validation", "bench"}

# A scene as it was read can be changed half-way: all rooms work on what src/problem makes of it.
RAW_SCENE = "src/scene/scene.hpp"
KNOW_RAW_SCENES = {"src/scene", "src/problem", "validation/live", "bench/scaling"}  # live: reads one that is no TOML

# Computer algebra stays out of the numeric library and the program.
ALGEBRA = re.compile(r"(ginac|cln)/")
ALGEBRA_ROOTS = {"symbolic", "validation", "bench"}

# Eigen's decompositions take a compiler seconds in each unit that includes them: one room compiles them.
DECOMPOSITIONS = re.compile(r"(unsupported/)?Eigen/(?!Core$)")
KNOW_DECOMPOSITIONS = {"src/linear", "bench/simulators"}

# Code that the project writes into files of its own stands in raw strings, with includes of its own.
NOT_CODE = re.compile(r'R"(\w*)\(.*?\)\1"|/\*.*?\*/', re.DOTALL)

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]', re.MULTILINE)


def sources(root):
    for folder in ROOTS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in {".hpp", ".cpp", ".h", ".ipp"}:
                yield file


def room_of(path):
    """The innermost room that a path (relative, as text) lies in; None outside all rooms."""
    inside = [room for room in ROOMS if path.startswith(room + "/")]
    return max(inside, key=len, default=None)


def within(room, folder):
    return room == folder or room.startswith(folder + "/")


class IncludeGraph:
    """edges: file -> files it includes, as paths relative to the root; problems: what is wrong."""

    def __init__(self, root):
        self.root = Path(root)
        self.edges = {}
        self.problems = []
        for file in sources(self.root):
            self._read(file)
        self._find_cycles()

    def _read(self, file):
        name = file.relative_to(self.root).as_posix()
        self.edges[name] = []
        if room_of(name) is None:
            self.problems.append(f"{name} is in no room")
        for bracket, included in INCLUDE.findall(NOT_CODE.sub("", file.read_text())):
            if ALGEBRA.match(included) and name.split("/")[0] not in ALGEBRA_ROOTS:
                self.problems.append(f"{name} includes {included}: computer algebra has no place here")
            if DECOMPOSITIONS.match(included) and room_of(name) not in KNOW_DECOMPOSITIONS:
                self.problems.append(f"{name} includes {included}: ask src/linear, which compiles it for all")
            if bracket == '"':
                self._arrow(file, name, included)

    def _arrow(self, file, name, included):
        for folder in [file.parent] + [self.root / folder for folder in ROOTS]:
            for candidate in (folder / included, folder / f"{included}.in"):
                if candidate.is_file():
                    target = candidate.resolve().relative_to(self.root.resolve()).as_posix()
                    self.edges[name].append(target)
                    self._check(name, target)
                    return
        self.problems.append(f"{name} includes {included}, which is not there")

    def _check(self, name, target):
        here, there = room_of(name), room_of(target)
        if here is None or there is None:
            self.problems.append(f"{name} includes {target}: not an arrow between rooms")
        elif ROOMS.index(there) > ROOMS.index(here):
            self.problems.append(f"{name} includes {target}: {there} comes after {here}")
        elif any(within(here, one) and within(there, other) for one, other in FORBIDDEN):
            self.problems.append(f"{name} includes {target}: {here} must not know {there}")
        elif target in ONE_WAY and not any(within(here, room) for room in KNOW_ONE_WAY):
            self.problems.append(f"{name} includes {target}: v* is asked of src/answers")
        elif target == RAW_SCENE and not any(within(here, room) for room in KNOW_RAW_SCENES):
            self.problems.append(f"{name} includes {target}: a scene is resolved before it is used (problem/problem.hpp)")

    def _find_cycles(self):
        done, path = set(), []

        def visit(name):
            if name in path:
                cycle = path[path.index(name):] + [name]
                self.problems.append("cycle: " + " -> ".join(cycle))
                return
            if name in done:
                return
            path.append(name)
            for target in self.edges.get(name, []):
                visit(target)
            path.pop()
            done.add(name)

        for name in self.edges:
            visit(name)
