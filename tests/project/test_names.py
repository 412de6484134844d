"""One name, one meaning.

1. Files of a library may be compiled together, so what their anonymous namespaces declare bears names of its own.
2. A name of a nested namespace hides that of an outer one: a function `to_text(const GiNaC::ex&)` in vcrit::symbolic
   once stood in the way of vcrit::to_text(double), and whoever saw both got other digits without a word. So a nested
   namespace, anonymous ones too, does not declare again what a header declares in a namespace around it, unless the
   same file brings the outer one in beside it (`using vcrit::to_text;`).
3. A type has one name: what a header declares in a namespace is called so in no other namespace, and no type within
   another one hides it. Types within others may share a name (`Effect::Kind`, `Form::Kind`): they are written with
   their owner.

Run with the project's folder. With --list [FOLDER...], prints what breaks a rule instead.
"""

import functools
import itertools
import pathlib
import sys
import unittest

from declarations import declarations

ROOT = pathlib.Path(sys.argv.pop(1))
LIBRARIES = ("src", "symbolic", "validation", "app", "python", "bench")
NOT_ITS_OWN = ("using", "nested")  # no names of the namespace itself
# What never meets the types of vcrit: the file that generated C++ is made of, and bench's formulas by hand, which are
# compiled by themselves and named after what they stand for.
APART = {"alone", "by_hand"}


def library(name):
    """What the file is compiled into."""
    return name.split("/")[0]


def around(outer, inner):
    """Whether the namespace `outer` is `inner` or one around it."""
    return inner[:len(outer)] == outer


def named(namespace):
    return tuple(part for part in namespace if part)


def clashes(sources):
    """Names that two anonymous namespaces of a library declare, seen from a common place."""
    found = {}
    for name, declared in sources.items():
        for one in declared:
            if name.endswith(".cpp") and "" in one.namespace and one.kind not in NOT_ITS_OWN:
                found.setdefault((library(name), one.name), {}).setdefault((named(one.namespace), name), one.line)
    result = []
    for (_, name), places in sorted(found.items()):
        for (a, b) in itertools.combinations(sorted(places), 2):
            if a[1] != b[1] and (around(a[0], b[0]) or around(b[0], a[0])):
                result.append(f"{a[1]}:{places[a]} and {b[1]}:{places[b]} both declare `{name}` in an anonymous namespace")
    return result


def hidden(sources):
    """Declarations that hide one of a header, in a namespace around them."""
    seen = {}
    for file, declared in sources.items():
        if file.endswith(".hpp"):
            for one in declared:
                if one.kind not in NOT_ITS_OWN and "" not in one.namespace:
                    seen.setdefault(one.name, []).append((one.namespace, file, one.line))
    result = []
    for file, declared in sources.items():
        beside = {(named(one.namespace), one.name) for one in declared if one.kind == "using"}
        for one in declared:
            mine = named(one.namespace)
            if (mine, one.name) in beside or one.kind in NOT_ITS_OWN or not (file.endswith(".hpp") or "" in one.namespace):
                continue
            for namespace, header, line in seen.get(one.name, []):
                nested = around(namespace, mine) and ("" in one.namespace or namespace != mine)
                if nested and header != file and visible(library(header), library(file)):
                    result.append(f"{file}:{one.line} declares `{one.name}`, which hides {'::'.join(namespace)}::{one.name} "
                                  f"of {header}:{line}")
    return sorted(set(result))


def shared(sources):
    """Types of headers that two namespaces declare, and those within a type that hide one of a namespace around it."""
    of_namespaces, result = {}, []
    for file, declared in sorted(sources.items()):
        for one in declared if file.endswith(".hpp") else []:
            if one.kind == "type" and "" not in one.namespace and not APART & set(one.namespace):
                of_namespaces.setdefault(one.name, {}).setdefault(one.namespace, f"{file}:{one.line}")
    for name, places in sorted(of_namespaces.items()):
        if len(places) > 1:
            declared = " and ".join(f"{'::'.join(namespace)} ({place})" for namespace, place in sorted(places.items()))
            result.append(f"`{name}` is a type of {declared}")
    for file, declared in sorted(sources.items()):
        for one in declared if file.endswith(".hpp") else []:
            for namespace, place in of_namespaces.get(one.name, {}).items():
                if one.kind == "nested" and around(namespace, named(one.namespace)):
                    result.append(f"{file}:{one.line} declares `{one.name}` within a type, which hides "
                                  f"{'::'.join(namespace)}::{one.name} of {place}")
    return result


def visible(header, file):
    """Whether files of the library `file` can include headers of `header`."""
    return header == file or header in ("src", "symbolic", "validation")


@functools.cache
def sources():
    files = sorted(file for library in LIBRARIES for file in (ROOT / library).rglob("*.[ch]pp"))
    return {str(file.relative_to(ROOT)): declarations(file.read_text()) for file in files}


def trial(**texts):
    """Sources written here: `src_a_hpp="..."` is src/a.hpp."""
    places = ((name.replace("_", "/", 1), text) for name, text in texts.items())
    return {"".join(name.rpartition("_")[:1]) + "." + name.rpartition("_")[2]: declarations(text) for name, text in places}


class Names(unittest.TestCase):
    def test_the_sources_are_read(self):
        declared = {(one.namespace, one.name) for each in sources().values() for one in each}
        self.assertGreater(len(declared), 3000)
        self.assertIn((("vcrit",), "to_text"), declared)

    def test_files_of_a_library_can_be_compiled_together(self):
        self.assertEqual([], clashes(sources()))

    def test_no_name_hides_that_of_an_outer_namespace(self):
        self.assertEqual([], hidden(sources()))

    def test_a_type_has_one_name(self):
        types = {one.name for file, each in sources().items() for one in each if one.kind == "type" and file.endswith(".hpp")}
        self.assertGreater(len(types), 600)
        self.assertEqual([], shared(sources()))


class Rules(unittest.TestCase):
    OUTER = "namespace vcrit {\nstd::string to_text(double value);\n}\n"

    def hides(self, **texts):
        return len(hidden(trial(src_numbers_hpp=self.OUTER, **texts)))

    def test_an_overload_in_a_nested_namespace_is_found(self):
        self.assertEqual(1, self.hides(symbolic_text_hpp="namespace vcrit::symbolic { std::string to_text(const ex& e); }"))
        self.assertEqual(1, self.hides(symbolic_a_cpp="namespace vcrit::symbolic { namespace { int to_text(T t) { return 1; } } }"))

    def test_one_that_brings_the_outer_ones_in_is_none(self):
        self.assertEqual(0, self.hides(
            symbolic_text_hpp="namespace vcrit::symbolic { using vcrit::to_text; std::string to_text(const ex& e); }"))

    def test_siblings_and_the_same_namespace_hide_nothing(self):
        self.assertEqual(0, self.hides(src_units_hpp="namespace vcrit { std::string to_text(const Unit& u); }",
                                       src_other_hpp="namespace other { std::string to_text(int i); }"))

    def test_anonymous_names_of_two_files_clash(self):
        a = "namespace vcrit { namespace { constexpr double turn = 2 * pi; struct Kind { int turn; }; } }"
        b = "namespace vcrit::fit { namespace { template <class T> T turn(std::vector<T> v) { return v[0]; } } }"
        self.assertEqual(1, len(clashes(trial(src_a_cpp=a, src_b_cpp=b))))
        self.assertEqual(1, len(clashes(trial(src_a_cpp=a.replace("turn =", "half = pi, turn ="), src_b_cpp=b))))
        self.assertEqual([], clashes(trial(src_a_cpp=a, symbolic_b_cpp=b)))
        self.assertEqual([], clashes(trial(src_a_cpp=a.replace("vcrit", "vcrit::maps"), src_b_cpp=b)))

    def test_a_type_of_two_rooms_is_found(self):
        motion = "namespace vcrit::simulation { struct System { int n; }; }"
        algebra = "namespace vcrit::symbolic { class System; }"
        self.assertEqual(1, len(shared(trial(src_a_hpp=motion, symbolic_b_hpp=algebra))))
        self.assertEqual(1, len(shared(trial(src_a_hpp=motion, src_b_hpp="namespace vcrit { using System = int; }"))))
        self.assertEqual([], shared(trial(src_a_hpp=motion, src_b_hpp="namespace vcrit::simulation { struct System; }")))
        self.assertEqual([], shared(trial(src_a_hpp=motion, bench_b_hpp=algebra.replace("vcrit::symbolic", "by_hand"))))
        self.assertEqual([], shared(trial(src_a_hpp=motion, symbolic_b_cpp=algebra)))

    def test_a_type_within_another_that_hides_one_is_found(self):
        place = "namespace vcrit { struct Place { int line; }; }"
        within = "namespace vcrit::symbolic { class Dialect { enum class Place { free }; Place at; }; }"
        self.assertEqual(1, len(shared(trial(src_a_hpp=place, symbolic_b_hpp=within))))
        self.assertEqual([], shared(trial(src_a_hpp=place.replace("vcrit", "vcrit::maps"), symbolic_b_hpp=within)))
        kinds = "namespace vcrit { struct A { enum class Kind { a }; }; struct B { enum class Kind { b }; }; }"
        self.assertEqual([], shared(trial(src_a_hpp=kinds)))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--list"]:
        for line in clashes(sources()) + hidden(sources()) + shared(sources()):
            if line.startswith(tuple(sys.argv[2:])):
                print(line)
    else:
        unittest.main(verbosity=2)
