"""What ./dev check compiles once and puts before files (check_alone.py): sets of headers.

A set is closed: with a header of the project it has all that this one includes. So it may stand before every file that
includes all of the set.
"""

import functools
import hashlib
import heapq
import re

# Milliseconds to read what takes long, after what all else includes. Any figures are right; good ones give good sets.
DEAR = {"CLI/App.hpp": 1250, "CLI/CLI.hpp": 1500, "Eigen/Core": 580, "ginac/ginac.h": 560, "nlohmann/json.hpp": 1200,
        "pybind11/pybind11.h": 1480, "pybind11/stl.h": 140, "pybind11/numpy.h": 200, "tbb/parallel_for.h": 560,
        "boost/math/tools/toms748_solve.hpp": 330, "boost/math/tools/minima.hpp": 310, "toml++/toml.h": 260,
        "boost/math/special_functions/gamma.hpp": 1300, "boost/math/quadrature/gauss_kronrod.hpp": 1370,
        "boost/container/small_vector.hpp": 120, "fmt/core.h": 110, "flint/fmpz_mpoly.h": 90, "flint/fmpq_poly.h": 100,
        "acb.h": 70, "filesystem": 300, "random": 150, "chrono": 160, "thread": 170, "mutex": 130, "complex": 130,
        "unordered_map": 50, "deque": 50, "map": 120, "memory": 140, "vector": 60, "set": 60, "atomic": 60,
        "unistd.h": 40, "cmath": 60, "fstream": 100, "algorithm": 60, "functional": 80, "string": 220}
OTHER = 20
PER_BYTE = 0.0025  # of a header of the project
SAVED = 0.83  # of what a file need not read, as the compiler still has to look things up in it
SET = 330  # to write one, besides what it takes to read
NEIGHBOURS = 150  # files that are compared with each other


class Headers:
    """Includes of files. Sets of headers are numbers, a bit for each."""

    def __init__(self, macros):
        self.bits, self.names, self.weights = {}, [], []
        self.macro = re.compile(r"^\s*#\s*(?:if|define)|\b(?:" + "|".join(macros) + r")\b", re.M)

    def bit(self, header, weight):
        if header not in self.bits:
            self.bits[header] = len(self.names)
            self.names.append(header)
            self.weights.append(weight)
        return 1 << self.bits[header]

    @functools.cache
    def text(self, file):
        return file.read_text()

    @functools.cache
    def digest(self, file):
        return hashlib.sha256(self.text(file).encode()).hexdigest()

    @functools.cache
    def includes(self, file):
        """Quotation mark or bracket, and name, of each unconditional include before a macro may say how one is read."""
        found, conditions = [], 0
        for directive in re.finditer(r'^\s*#\s*(if|endif|define|include\s*([<"])(.*)[>"])', self.text(file), re.M):
            if directive[1] == "define":
                break
            conditions += {"if": 1, "endif": -1}.get(directive[1], 0)
            if directive[2] and conditions == 0:
                found.append((directive[2], directive[3]))
        return found

    @functools.cache
    def own(self, file, name, searched):
        """The header of the project with that name in an include of the file."""
        return next((folder / name for folder in (file.parent, *searched) if (folder / name).is_file()), None)

    @functools.cache
    def beginning(self, file, searched):
        """The header of the project that nothing stands before."""
        mark, name = next(iter(self.includes(file)), ("", ""))
        first = re.search(r"^\s*#\s*(\w+)", self.text(file), re.M)
        return self.own(file, name, searched) if mark == '"' and first[1] == "include" else None

    @functools.cache
    def named(self, file, searched):
        """The headers of the project that it includes in whatever case, or None if a macro names what it includes."""
        names = re.findall(r'^\s*#\s*include\s*(?:[<"](.*)[>"]|\S+)', self.text(file), re.M)
        return {self.own(file, name, searched) for name in names} - {None} if all(names) else None

    @functools.cache
    def read(self, file, searched):
        """All files of the project that the compiler may read for it, or none if an include is named by a macro."""
        found, left = {file}, [file]
        while left:
            named = self.named(left.pop(), searched)
            if named is None:
                return []
            left += named - found
            found |= named
        return sorted(found)

    @functools.cache
    def below(self, file, searched):
        """All that it includes in any case, itself or through headers of the project, and whether this is the same in
        every file."""
        found, same = 0, not self.macro.search(self.text(file))
        for mark, name in self.includes(file):
            header = self.own(file, name, searched) if mark == '"' else None
            if header:
                within, header_same = self.below(header, searched)
                found |= within
                same &= header_same
                if header_same:
                    found |= self.bit(header, len(self.text(header)) * PER_BYTE)
            elif mark == "<":
                found |= self.bit(name, DEAR.get(name, OTHER))
        return found, same

    @functools.cache
    def before(self, file, searched):
        """What may stand before it."""
        return self.below(file, searched)[0]

    @functools.cache
    def weight(self, headers):
        return sum(self.weights[place] for place in self.places(headers))

    def places(self, headers):
        while headers:
            yield headers.bit_length() - 1
            headers ^= 1 << headers.bit_length() - 1

    def lines(self, headers):
        """Others first, since each of the project is known to need nothing before it."""
        names = [self.names[place] for place in sorted(self.places(headers))]
        others = [f"#include <{name}>\n" for name in names if isinstance(name, str)]
        return others + [f'#include "{name}"\n' for name in names if not isinstance(name, str)]


def largest(sets, headers, weight):
    """The costliest of the sets that may stand before a file with these headers."""
    return max((each for each in sets if each & ~headers == 0), key=weight, default=0)


def candidates(befores):
    """What files that follow each other both include."""
    found = set(befores)
    for distance in range(1, NEIGHBOURS):
        found.update(one & other for one, other in zip(befores, befores[distance:]))
    return found - {0}


def sets_for(befores, weight):
    """Chosen one after the other by how much less all files read, which falls with each set chosen."""
    chosen, taken = [], [0] * len(befores)
    within = {each: [file for file, before in enumerate(befores) if each & ~before == 0] for each in candidates(befores)}

    def gain(headers):
        whole = weight(headers)
        return SAVED * sum(whole - taken[file] for file in within[headers] if taken[file] < whole) - SET - whole

    left = [(-gain(each), each) for each in within]
    heapq.heapify(left)
    while left:
        _, headers = heapq.heappop(left)
        now = gain(headers)
        if left and now < -left[0][0]:
            heapq.heappush(left, (-now, headers))
        elif now > 0:
            chosen.append(headers)
            for file in within[headers]:
                taken[file] = max(taken[file], weight(headers))
        else:
            break
    return chosen
