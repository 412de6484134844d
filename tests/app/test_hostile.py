"""Input that was written to do harm, or that grew beyond any sense: every command answers rightly or refuses with
exit status 2 and a message of bounded length that says what the limit is, within the memory allowed here.
"""

import json
import math
import os
import re
import resource
import subprocess
import unittest
from itertools import combinations

from program import Case

# Address space of the program. What is tried here needs at most about a third; without the limits in the sources
# each of the refused inputs needs more, or a stack beyond the usual 8 MiB.
MEMORY = 6 * 2**30
# Seconds of processor time, some ten times what the slowest needs; without the limits in the sources, hours.
TIME = 120
# InputError leaves out the middle of texts: three of 4000 bytes, each at most four times as long when escaped.
LONGEST_MESSAGE = 3 * 4 * 4000 + 1000

SCENE = """title = "hostile"
[contact]
normal = "{normal}"
poisson = 0.25
[drive]
network = "{drive}"
[oscillation]
angular_frequency = 1e5
amplitude = 1e-7
indentation = 1e-6
[friction]
coefficient = 0.5
[elements]
k0 = 4e6
{elements}
[networks]
{networks}
"""


def scene(normal="k0", drive="kd", elements="kd = 1e6", networks=""):
    return SCENE.format(normal=normal, drive=drive, elements=elements, networks=networks)


def critical_velocity(contact, drive):
    """Eq. (24) without dampers and mass: K_t/K_n = 2(1 - nu)/(2 - nu), v* = mu0 omega du_z K_n/K_t (1 + K_t/K_d)."""
    ratio = 2 * (1 - 0.25) / (2 - 0.25)
    return 0.5 * 1e5 * 1e-7 / ratio * (1 + ratio * contact / drive)


def limits():
    if "VCRIT_SANITIZED" not in os.environ:  # the sanitizer alone takes terabytes of addresses
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (TIME, TIME))
    resource.setrlimit(resource.RLIMIT_STACK, (8 * 2**20, 8 * 2**20))


class Hostile(Case):
    def run_program(self, *arguments):
        return super().run_program(*arguments, text=False, preexec_fn=limits)

    def write(self, text, name="s.toml"):
        return super().write(text, name).name  # messages name it as it is given

    def assert_refused(self, done, *words):
        message = done.stderr.decode()  # must be UTF-8
        self.assertEqual(done.returncode, 2, message[-2000:])
        self.assertEqual(done.stdout, b"")
        self.assertLess(len(message), LONGEST_MESSAGE)
        for word in words:
            self.assertIn(word, message)
        self.assertRegex(message, r"\Avcrit: [^\x00-\x1f\x7f]*\n\Z")

    def refuse(self, text, *words, command=("eval",)):
        self.assert_refused(self.run_program(*command, self.write(text)), *words)

    def assert_velocity(self, text, expected, *options):
        done = self.run_program("eval", self.write(text), *options, "--json")
        self.assertEqual(done.returncode, 0, done.stderr.decode()[-2000:])
        found = json.loads(done.stdout)["critical_velocity"]
        # The formula above rounds some ten times, each time by 1.1e-16 at most.
        self.assertTrue(math.isclose(found, expected, rel_tol=2e-15), (found, expected))


class DeepNesting(Hostile):
    def test_of_brackets(self):
        self.refuse(scene(drive="(" * 1200 + "kd" + ")" * 1200), "found 1200 levels of brackets; expected at most 200")
        self.refuse(scene(drive="(" * 1000000), "found 1000000 levels of brackets")
        self.assert_velocity(scene(drive="(" * 200 + "kd" + ")" * 200), critical_velocity(4e6, 1e6))

    def test_of_named_networks(self):
        for form in ("{}", "(kd | {})", "kd | (kd - {})"):
            names = "".join(f'n{i} = "{form.format(f"n{i + 1}")}"\n' for i in range(100000))
            with self.subTest(form):
                self.refuse(scene(drive="n0", networks=names + 'n100000 = "kd"'), "at most 200 levels of brackets and named")
        # Read in an order in which each finds the next one known.
        names = "".join(f'n{i:04} = "kd | (kd - n{i - 1:04})"\n' for i in range(1, 500))
        self.refuse(scene(networks='n0000 = "kd"\n' + names), "combinations in one another; expected at most 400")

    def test_of_graphs(self):
        graphs = "".join(f'n{i} = {{terminals = ["a", "b"], edges = [["n{i + 1}", "a", "b"]]}}\n' for i in range(5000))
        self.refuse(scene(drive="n0", networks=graphs + 'n5000 = "kd"'), "at most 200 levels")

    def test_of_toml(self):
        for text in ("a" + ".a" * 1000000 + " = 1\n", "[a" + ".a" * 1000000 + "]\n=", "a = {a" + ".a" * 1000000 + " = 1}"):
            with self.subTest(text[:5]):
                self.refuse(text, "s.toml:1: found a key of more than 20 parts")
        for text in ("a = " + "[" * 1000000, "a = " + "{a = " * 1000000):
            with self.subTest(text[:7]):
                self.refuse(text, "s.toml:1:", "no TOML", "256")
        # Strings and comments are no keys.
        dots = f"# {'.' * 100}\n" + scene().replace("hostile", "." * 100 + '\\"' + "." * 100)
        self.assert_velocity(dots, critical_velocity(4e6, 1e6))


class Exponents(Hostile):
    def test_of_scene_numbers(self):
        for number in ("1e400", "1e99999999999999999999", "1e-400"):
            for quoted in (f'"{number}"', f'"{number} N/m"'):
                with self.subTest(quoted):
                    self.refuse(scene(elements=f"kd = {quoted}"), "s.toml:15:6", f"{number}", "beyond the range of doubles")
            if number != "1e-400":  # in TOML, that is 0
                self.refuse(scene(elements=f"kd = {number}"), "s.toml:15:", number)

    def test_of_settings(self):
        # Once "1e401" was 1e40 of a unit "1".
        for number in ("1e401", "1e-401", "-1e401", "1" * 60000 + "-" * 60000, "1e" * 60000):
            with self.subTest(number[:10]):
                done = self.run_program("eval", self.write(scene()), "--set", f"mu0={number}")
                self.assert_refused(done, "--set mu0")

    def test_that_are_in_range(self):
        self.assert_velocity(scene(elements="kd = 1e300").replace("4e6", '"4e305"'), critical_velocity(4e305, 1e300))

    def test_of_units(self):
        for unit in ("m^99999999999", "N^-2147483648", "(" * 30 + "N/m" + ")" * 30 + "^999", "N/m" * 10000):
            with self.subTest(unit[:20]):
                self.refuse(scene(elements=f'kd = "1 {unit}"'), "expected a stiffness in N/m")
        # udunits printed it, so that standard output was not empty.
        self.refuse(scene(elements='kd = "1 N/m\\n"'), "expected a stiffness in N/m")


class Size(Hostile):
    million = [f"k{i}" for i in range(1, 1000001)]

    def test_of_a_million_elements(self):
        ones = "\n".join(f"{name} = 1" for name in self.million)
        self.assert_velocity(scene(drive=" | ".join(self.million), elements=ones), critical_velocity(4e6, 1e6))

    def test_of_edges_in_series(self):
        edges = ",".join(f'["kd", "n{i}", "n{i + 1}"]' for i in range(1000000))
        graph = f'chain = {{terminals = ["n0", "n1000000"], edges = [{edges}]}}'
        self.assert_velocity(scene(drive="chain", elements="kd = 1e12", networks=graph), critical_velocity(4e6, 1e6))

    # Each pair of a rung and a post halves what is left: of springs of 1e6 the stiffness of the endless ladder is the
    # golden section of one, to rounding after 40 of them.
    def test_of_a_ladder(self):
        rungs = ",".join(f'["kd", "n{i}", "n{i + 1}"], ["kd", "n{i + 1}", "b"]' for i in range(100000))
        graph = f'ladder = {{terminals = ["n0", "b"], edges = [{rungs}]}}'
        golden = 1e6 * (math.sqrt(5) - 1) / 2
        self.assert_velocity(scene(drive="ladder", networks=graph), critical_velocity(4e6, golden))

    def test_of_what_series_and_parallel_leave(self):
        grid = [(f"{x}.{y}", f"{x + dx}.{y + dy}") for x in range(20) for y in range(20) for dx, dy in ((0, 1), (1, 0))
                if x + dx < 20 and y + dy < 20]
        edges = ",".join(f'["kd", "{a}", "{b}"]' for a, b in grid)
        graph = f'grid = {{terminals = ["0.0", "19.19"], edges = [{edges}]}}'
        self.refuse(scene(drive="grid", networks=graph), "inner nodes and branches", "at most 200",
                    command=("simulate", "--velocity", "1"))

    def test_of_relaxation_times(self):
        branches = " | ".join(f"(kk{i} - c{i})" for i in range(20001))
        values = "".join(f"kk{i} = 1\nc{i} = {i + 1}\n" for i in range(20001))
        self.refuse(scene(drive=f"kd - ({branches})", elements="kd = 1\n" + values), "relaxation times", "at most 20000",
                    command=("simulate", "--velocity", "1"))

    def test_of_more(self):
        self.refuse(scene(drive=" | ".join(["kd"] * 1000001)), "found more than 1000000 elements")
        self.refuse(scene(drive=" | ".join(["prony(kd, k, tau, 100000)"] * 1000000)), "more than 1000000 elements")
        doubled = "".join(f'n{i} = "n{i + 1} | n{i + 1}"\n' for i in range(60)) + 'n60 = "kd"'
        self.refuse(scene(drive="n0", networks=doubled), "more than 1000000 elements")
        edges = ",".join(f'["prony(kd, k, tau, 100000)", "a", "n{i}"]' for i in range(100))
        graph = f'g = {{terminals = ["a", "b"], edges = [{edges}]}}'
        self.refuse(scene(drive="g", networks=graph), "more than 4000000 elements")

    def test_of_a_complete_graph(self):
        edges = ",".join(f'["kd", "{a}", "{b}"]' for a, b in combinations(range(400), 2))
        graph = f'g = {{terminals = ["0", "1"], edges = [{edges}]}}'
        self.refuse(scene(drive="g", networks=graph), "more than 4000000 steps")

    def test_of_keys(self):
        self.refuse("".join(f"a{i}.b = 1\n" for i in range(10001)), "s.toml:10001: found more than 10000 dotted keys")
        self.refuse("".join(f"[a{i}.b]\n" for i in range(10001)), "s.toml:10001: found more than 10000 dotted keys")

    def test_of_files_without_end(self):
        self.assert_refused(self.run_program("eval", "/dev/zero"), "/dev/zero: found more than 67108864 bytes")
        done = self.run_program("sweep", self.write(scene()), "--over", "kd=list:/dev/zero", "--quantity",
                                "critical_velocity", "--out", "o.csv")
        self.assert_refused(done, "/dev/zero: found more than 536870912 bytes")

    def test_of_names(self):
        long = "k" * 120000
        self.refuse(scene(drive=long), "is longer than 64 characters")
        self.assert_refused(self.run_program("eval", self.write(scene()), "--set", f"{long}=1"), "does not have")


class Cycles(Hostile):
    def test_of_names(self):
        for drive, networks in (("a", 'a = "a"'), ("a", 'a = "kd | b"\nb = "kd - (c)"\nc = "a"'), ("kd", 'a = "b"\nb = "a"')):
            with self.subTest(networks):
                self.refuse(scene(drive=drive, networks=networks), "inside itself; expected networks that do not contain themselves")

    def test_through_graphs(self):
        graph = 'a = {terminals = ["a", "b"], edges = [["b", "a", "b"]]}\nb = "kd | a"'
        self.refuse(scene(drive="b", networks=graph), "inside itself")


class Bytes(Hostile):
    WRONG = (b"\xff", b"\xc3(", b"\xed\xa0\x80", b"\xf5\x80\x80\x80", b"\xc0\x80", b"\0", b"\x1b[31m", b"\x7f")

    def test_in_scenes(self):
        for wrong in self.WRONG:
            for place in (b"hostile", b"kd", b"[friction]"):
                with self.subTest(wrong=wrong, place=place):
                    self.refuse(scene().encode().replace(place, wrong + place))
        for wrong in (r"\ud800", r"\u0000", r"\u001b[31m", r"\u009b31m"):
            self.refuse(scene(drive="kd" + wrong))

    def test_in_options(self):
        name = self.write(scene())
        for wrong in self.WRONG:
            if b"\0" in wrong:
                continue  # ends every argument
            for setting in (b"kd=1" + wrong, wrong + b"=1", b"kd=1 N/m" + wrong, wrong):
                with self.subTest(setting):
                    self.assert_refused(self.run_program("eval", name, "--set", setting), "--set")
            done = self.run_program("sweep", name, "--over", wrong + b"=lin:1:2:3", "--quantity", "critical_velocity",
                                    "--out", "o.csv")
            self.assert_refused(done, "--over")
            self.assert_refused(self.run_program("eval", b"no" + wrong + b".toml"), "no such file")

    def test_in_tables(self):
        table = 'receptance = "t.csv"'
        for wrong in self.WRONG:
            with self.subTest(wrong):
                self.write(b"omega,Re,Im\n1," + wrong + b",0\n2,1,0\n", "t.csv")
                self.refuse(scene().replace('network = "kd"', table), "t.csv:2: found")
                self.write(b"frequency,storage," + wrong + b"\n", "d.csv")
                self.assert_refused(self.run_program("fit", "d.csv", "--out", "f.toml"), "d.csv:1: found")
                self.write(b"1\n" + wrong + b"\n", "l.txt")
                done = self.run_program("sweep", self.write(scene()), "--over", "kd=list:l.txt", "--quantity",
                                        "critical_velocity", "--out", "o.csv")
                self.assert_refused(done, "l.txt:2: found")


class Names(Hostile):
    WRONG = {"class": "reserved", "co_await": "reserved", "const": "reserved", "kd__": "underscores", "NULL": "macro",
             "INFINITY": "macro", "M_PI": "macro", "assert": "reserved", "errno": "reserved"}
    TORN = ("k'd", 'k\\"d', "../kd", "k/d", "k\\\\d", "k.d", "k d", "k;d", "$(k)", "k{}", "%s", "..", "/etc/passwd", "é")

    def test_of_elements(self):
        for name, why in self.WRONG.items():
            for drive in (name, f"spring({name})"):
                with self.subTest(drive):
                    self.refuse(scene(drive=drive), "name", why)
        for name in self.TORN:
            with self.subTest(name):
                self.refuse(scene(drive=f"kd | {name}"), "s.toml:6:")

    def test_of_networks_and_ratios(self):
        for name in [*self.WRONG, *self.TORN]:
            with self.subTest(name):
                self.refuse(scene(networks=f'"{name}" = "k0"'), "a name")
                if name in self.WRONG:
                    self.refuse(scene().replace("poisson = 0.25", f'poisson = "{name}"'), "name")

    def test_of_libraries(self):
        for name in [*self.WRONG, "../x", "a/b", 'a"b', "a'b", "..", "", "é", "std"]:
            with self.subTest(name):
                done = self.run_program("generate", self.write(scene()), "--out", "out", "--name", name)
                self.assert_refused(done, "name")
                self.assertFalse((self.folder / "out").exists())

    def test_of_nodes_are_free(self):
        for name in self.TORN:
            graph = f'g = {{terminals = ["a", "b"], edges = [["kd", "a", "{name}"], ["kd", "{name}", "b"]]}}'
            with self.subTest(name):
                self.assert_velocity(scene(drive="g", networks=graph, elements="kd = 2e6"), critical_velocity(4e6, 1e6))

    def test_of_titles_stay_out_of_code(self):
        title = '*/ #error \\\\\\n#error 1\\n\\"\\"\\" \'\'\' \\\\'
        self.write(scene().replace("hostile", title))
        self.assertEqual(self.run_program("generate", "s.toml", "--out", "out", "--name", "vs").returncode, 0)
        compiled = subprocess.run(["c++", "-std=c++20", "-Wall", "-Werror", "-fsyntax-only", "-x", "c++", "out/vs.hpp"],
                                  cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(compiled.returncode, 0, compiled.stderr)


if __name__ == "__main__":
    unittest.main()
