"""The held load: random scenes through eval, derive, simulate and, some of them, generate and a compiler. Values
are compared with nodal analysis at 250 digits (data/scenes_expected.py, which shares nothing with the program);
what is refused has to be refused with one message and the right status.

    held_load.py PROGRAM [--scenes 10000] [--compiled 100] [--seed 1] [--jobs 2]

Prints what came out of how many; ends with status 1 and the scenes that failed (kept in the folder
that it names) if there are any.
"""

import argparse
import json
import random
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import mpmath

sys.path.insert(0, str(Path(__file__).parents[1] / "data"))
import scenes_expected  # noqa: E402

# Nodes stay a twentieth away from resonance (scenes_expected refuses nearer ones): v* loses at most some 100
# roundings of its parameters, and omega = 2 pi f is rounded twice.
TOLERANCE = 1e-12
# Seconds for one command; the slowest take two.
PATIENCE = 120


class Draw:
    """A random scene as TOML, over a few or over twenty decades."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.decades = self.random.choices([1, 3, 6, 20], [3, 4, 2, 1])[0]
        self.elements, self.networks = {}, {}

    def value(self, middle):
        return middle * 10 ** self.random.uniform(-self.decades / 2, self.decades / 2)

    def spring(self):
        return self.element("k", 1e6)

    def damper(self):
        return self.element("c", 10)

    def element(self, kind, middle):
        name = f"{kind}{len(self.elements)}"
        self.elements[name] = self.value(middle)
        return name

    def leaf(self):
        shape = self.random.choices(["k", "c", "kelvin", "zener", "burgers", "prony", "bridge"],
                                    [6, 5, 2, 2, 1, 1, 1])[0]
        k, c = self.spring, self.damper
        if shape == "k":
            return k()
        if shape == "c":
            return c()
        if shape == "kelvin":
            return f"kelvin({k()}, {c()})"
        if shape == "zener":
            return f"zener({k()}, {k()}, {c()})"
        if shape == "burgers":
            return f"burgers({k()}, {c()}, {k()}, {c()})"
        return self.prony() if shape == "prony" else self.bridge()

    def prony(self):
        n = self.random.randint(1, 12)
        number = len(self.elements)
        self.elements[f"kp{number}"] = [self.value(1e6) for _ in range(n)]
        self.elements[f"tau{number}"] = sorted(self.value(1e-5) for _ in range(n))
        return f"prony({self.spring()}, kp{number}, tau{number})"

    def bridge(self):
        name = f"bridge{len(self.networks)}"
        arms = [self.random.choice([self.spring, self.damper])() for _ in range(5)]
        ends = [("a", "1"), ("a", "2"), ("1", "b"), ("2", "b"), ("1", "2")]
        self.networks[name] = [[arm, *end] for arm, end in zip(arms, ends)]
        return name

    def network(self, depth=0):
        if depth == 3 or self.random.random() < 0.3:
            return self.leaf()
        sign = self.random.choice([" | ", " - "])
        parts = [self.network(depth + 1) for _ in range(self.random.randint(2, 3))]
        return "(" + sign.join(parts) + ")"

    def tangential(self):
        way = self.random.randrange(3)
        if way == 0:
            return f"poisson = {self.random.uniform(0, 0.5)!r}"
        return f"tangential_ratio = {self.random.uniform(0.5, 1)!r}" if way == 1 else f'tangential = "{self.network()}"'

    def toml(self):
        # Half of them surely carry a static load.
        load = f"{self.spring()} | " if self.random.random() < 0.5 else ""
        lines = ["[contact]", f'normal = "{load}{self.network()}"', self.tangential()]
        if self.random.random() < 0.7:
            lines += ["[drive]", f'network = "{self.network()}"']
            if self.random.random() < 0.6:
                lines += ["[body]", f"mass = {self.value(1e-4)!r}"]
        frequency, indentation = self.value(2e4), 10 ** self.random.uniform(-7, -5)
        lines += ["[oscillation]", f"frequency = {frequency!r}",
                  f"amplitude = {indentation * self.random.uniform(0.01, 0.9)!r}", f"indentation = {indentation!r}",
                  "[friction]", f"coefficient = {self.random.uniform(0.05, 1)!r}"]
        for name, edges in self.networks.items():
            lines += [f"[networks.{name}]", 'terminals = ["a", "b"]', f"edges = {json.dumps(edges)}"]
        lines += ["[elements]"] + [f"{name} = {value!r}" for name, value in self.elements.items()]
        return "\n".join(lines) + "\n"

    def broken(self, text):
        """One character that is another, or is not there."""
        at = self.random.randrange(len(text))
        return text[:at] + self.random.choice(["", "x", '"', "-1", "]", "\n", "é", "(", "0"]) + text[at + 1:]


class Failed(Exception):
    pass


def require(condition, *what):
    if not condition:
        raise Failed(" ".join(map(str, what)))


class Trial:
    """One scene in a folder of its own."""

    def __init__(self, program, folder, seed, compiles):
        self.program, self.folder, self.compiles = program, folder, compiles
        self.draw = Draw(seed)
        self.is_broken = seed % 10 == 0
        self.text = self.draw.toml()
        (folder / "s.toml").write_text(self.draw.broken(self.text) if self.is_broken else self.text)
        self.found = Counter()

    def command(self, *words):
        ended = subprocess.run([self.program, words[0], "s.toml", *words[1:]], cwd=self.folder, capture_output=True,
                               text=True, timeout=PATIENCE)
        if ended.returncode != 0:
            require(ended.returncode in (2, 3), words[0], "ended with", ended.returncode, ended.stderr[-500:])
            require(ended.stdout == "", words[0], "wrote before it refused")
            told = [line for line in ended.stderr.splitlines() if not line.startswith("vcrit: warning: ")]
            begins = "{" if "--json" in words else "vcrit: "
            require(len(told) == 1 and told[0].startswith(begins), words[0], "has no single message:", ended.stderr)
            kind = "; expected" if ended.returncode == 2 else begins
            require(kind in told[0], words[0], "refused without saying what it expects:", told[0])
        self.found[f"{words[0]} {ended.returncode}"] += 1
        return ended

    def run(self):
        evaluated = self.command("eval", "--json")
        derived = self.command("derive", "--format", "json")
        simulated = [self.command("simulate", "--velocity-ratio", str(ratio), "--json") for ratio in (0.5, 1.05)]
        if self.is_broken:
            return self.found
        require(evaluated.returncode == 0 or "0/0" in evaluated.stderr, "a sound scene is refused:", evaluated.stderr)
        require(derived.returncode == 0, "no formula:", derived.stderr)
        if evaluated.returncode == 0:
            answer = json.loads(evaluated.stdout)
            self.compare(answer, json.loads(derived.stdout))
            self.check_motion(answer, *simulated)
        if self.compiles:
            self.compile()
        return self.found

    def compare(self, answer, formula):
        with (self.folder / "s.toml").open("rb") as file:
            scene = tomllib.load(file)
        try:
            velocity, admissible, creep = scenes_expected.evaluate(scene)
        except AssertionError:  # too near resonance
            self.found["near resonance"] += 1
            return
        found = mpmath.mpf(answer["critical_velocity"])
        require(abs(found / velocity - 1) < TOLERANCE, "eval", found, "nodal analysis", mpmath.nstr(velocity, 20))
        require(answer["admissible"] == admissible, "admissible", answer["reasons"], admissible)
        # The sum of both in doubles.
        total = mpmath.mpf(answer["drive_velocity"])
        require(abs(total / (velocity + creep) - 1) < TOLERANCE, "creep", total, mpmath.nstr(velocity + creep, 20))
        require(abs(self.derived(scene, formula) / velocity - 1) < TOLERANCE, "the derived formula differs")
        self.found["agrees with nodal analysis"] += 1

    def derived(self, scene, formula):
        names = {"abs": abs, "sqrt": mpmath.sqrt, "mu0": scene["friction"]["coefficient"]}
        names["omega"] = 2 * mpmath.pi * mpmath.mpf(scene["oscillation"]["frequency"])
        names["s"] = mpmath.mpc(0, names["omega"])
        names["du_z"], names["m"] = scene["oscillation"]["amplitude"], scene.get("body", {}).get("mass", 0)
        for name, value in scene["elements"].items():
            names[name] = [0, *map(mpmath.mpf, value)] if isinstance(value, list) else mpmath.mpf(value)

        def value(text):
            text = re.sub(r"(?<![\w.])(\d+)(?![\w.\]])", r"mpf(\1)", text)
            return eval(text.replace("^", "**"), {"mpf": mpmath.mpf, **names})

        left = [line["text"].split(" = ", 1) for line in formula["definitions"]]
        while left:  # some are of others
            name, right = left.pop(0)
            try:
                names[name] = value(right)
            except NameError:
                left.append((name, right))
        return value(formula["critical_velocity"]["text"])

    def check_motion(self, answer, slow, fast):
        if not answer["admissible"]:
            require(slow.returncode == 3 and fast.returncode == 3, "a motion outside the model")
            return
        for ended in (slow, fast):
            require("null" not in ended.stdout, "a motion without a number:", ended.stdout[:500])
            if ended.returncode != 0:
                self.found["no motion: " + re.sub(r"[-\d.e+]+", "#", ended.stderr.strip())[:100]] += 1
        if fast.returncode == 0:
            motion = json.loads(fast.stdout)
            slack = 1e-9 + motion["friction_ratio_error"]
            if motion["regime"] == "sliding":
                require(abs(motion["friction_ratio"] - 1) <= slack, "sliding at", motion["friction_ratio"])
            elif answer["drive_velocity"] == answer["critical_velocity"]:  # else 1.05 v* is not above v* and creep
                require(False, "no sliding above v*:", motion["regime"], motion["friction_ratio"])
            self.found[f"above v*: {motion['regime']}"] += 1
        if slow.returncode == 0:
            motion = json.loads(slow.stdout)
            slack = 1e-9 + motion["friction_ratio_error"]
            require(0 <= motion["friction_ratio"] + slack and motion["friction_ratio"] <= 1 + slack, "friction", motion)
            self.found[f"at v*/2: {motion['regime']}"] += 1

    def compile(self):
        self.command("generate", "--out", "lib", "--name", "scene")
        library = self.folder / "lib"
        built = subprocess.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-O1", "test_scene.cpp", "-o", "test"],
                               cwd=library, capture_output=True, text=True)
        require(built.returncode == 0, "does not compile:", built.stderr[-2000:])
        ran = subprocess.run([library / "test"], cwd=library, capture_output=True, text=True)
        require(ran.returncode == 0, "the generated test fails:", ran.stdout[-500:])
        self.found["compiled and agrees"] += 1


def attempt(program, folder, seed, compiles):
    place = folder / str(seed)
    place.mkdir()
    try:
        found = Trial(program, place, seed, compiles).run()
    except Exception as error:  # whatever it is, the others go on
        return Counter(), f"{place}: {error}"
    shutil.rmtree(place)
    return found, None


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program", type=Path)
    options.add_argument("--scenes", type=int, default=10000)
    options.add_argument("--compiled", type=int, default=100)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    chosen = options.parse_args()
    folder, total, failures = Path(tempfile.mkdtemp(prefix="held-load-")), Counter(), []
    every = max(1, chosen.scenes // chosen.compiled)
    with ProcessPoolExecutor(chosen.jobs) as pool:
        trials = [pool.submit(attempt, chosen.program.resolve(), folder, chosen.seed + i, i % every == every // 2)
                  for i in range(chosen.scenes)]
        for trial in trials:
            found, failure = trial.result()
            total += found
            if failure:
                failures.append(failure)
                print(failure, flush=True)
    for what, count in sorted(total.items()):
        print(f"{count:8} {what}")
    print(f"{chosen.scenes} scenes from seed {chosen.seed}, {len(failures)} failures")
    if not failures:
        shutil.rmtree(folder)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
