"""The held load: random scenes (draw.py) through eval, derive, simulate and, some of them, critical, sweep, generate
and a compiler. Values are compared with nodal analysis at 250 digits (data/scenes_expected.py, which shares nothing
with the program) and have to lie within their own bound; what is refused has to be refused with one message and the
right status.

    held_load.py PROGRAM [--scenes 10000] [--compiled 100] [--level=-O1] [--seed 1] [--jobs 2]

Prints what came out of how many; ends with status 1 and the scenes that failed (kept in the folder
that it names) if there are any.
"""

import argparse
import csv
import json
import re
import resource
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
from draw import Draw  # noqa: E402

# Of sums and formulas in doubles. Nodes stay a twentieth away from resonance (scenes_expected refuses nearer ones): v*
# loses at most some 100 roundings of its parameters, and omega = 2 pi f is rounded twice.
TOLERANCE = 1e-12
# One scene of so many is swept, and goes through `critical`; one of so many that open through time steps, too.
SWEPT, STEPPED = 8, 4
# What the program says where doubles do not hold a motion; allowed where numbers of a scene are twenty decades apart.
BEYOND_DOUBLES = "lost in rounding"
# Seconds of one core for one command; the slowest take some. Beyond them it ends by a signal.
PATIENCE = 60


def patient():
    resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE, PATIENCE))


class Failed(Exception):
    pass


def require(condition, *what):
    if not condition:
        raise Failed(" ".join(map(str, what)))


class Trial:
    """One scene in a folder of its own."""

    def __init__(self, program, folder, seed, level):
        self.program, self.folder, self.level, self.seed = program, folder, level, seed  # None: compiles nothing
        self.draw = Draw(seed)
        self.is_broken = seed % 10 == 0
        self.text = self.draw.toml()
        for name, text in {"s.toml": self.draw.broken(self.text) if self.is_broken else self.text,
                           **self.draw.files}.items():
            (folder / name).write_text(text)
        self.found = Counter()

    def command(self, *words, statuses=(2, 3)):
        ended = subprocess.run([self.program, words[0], "s.toml", *words[1:]], cwd=self.folder, capture_output=True,
                               text=True, preexec_fn=patient)
        if ended.returncode != 0:
            require(ended.returncode in statuses, words, "ended with", ended.returncode, ended.stdout,
                    ended.stderr[-500:])
        if ended.returncode > 1:
            require(ended.stdout == "", words[0], "wrote before it refused")
            if "--json" in words:
                told = json.loads(ended.stderr)
                require(told["status"] == ended.returncode, words[0], "tells another status:", ended.stderr)
                require(ended.returncode == 3 or (told["found"] and told["expected"] and told["place"]), words[0],
                        "refused without saying what it expects:", ended.stderr)
            else:
                told = [line for line in ended.stderr.splitlines() if not line.startswith("vcrit: warning: ")]
                require(len(told) == 1 and told[0].startswith("vcrit: "), words[0], "has no single message:",
                        ended.stderr)
        self.found[f"{words[0]} {ended.returncode}"] += 1
        return ended

    def run(self):
        evaluated = self.command("eval", "--json")
        derived = self.command("derive", "--format", "json")
        simulated = [self.command("simulate", "--velocity-ratio", str(ratio), "--json") for ratio in (0.5, 1.05)]
        if self.is_broken:
            return self.found
        with (self.folder / "s.toml").open("rb") as file:
            self.scene = tomllib.load(file)
        require(evaluated.returncode == 0 or self.has_no_velocity(evaluated.stderr), "a sound scene is refused:",
                evaluated.stderr)
        require(derived.returncode == (3 if self.by_phases else 0), "no formula:", derived.stderr)
        if evaluated.returncode == 0:
            answer = json.loads(evaluated.stdout)
            if not self.by_phases:
                self.compare(answer, json.loads(derived.stdout))
            self.check_motion(answer, *simulated)
            if self.seed % SWEPT == 1:
                self.command("critical", "--json", statuses=(3,))
                self.check_sweep(answer)
        if self.level:
            self.compile()
        return self.found

    @property
    def by_phases(self):
        """Whether v* is a maximum over the phase: an indenter on a drive that gives."""
        return self.draw.has_indenter and self.draw.has_drive

    def has_no_velocity(self, told):
        """0/0; or v* is that of a motion, which the scene does not have, or doubles do not."""
        if not self.by_phases and not self.draw.separates:
            return "0/0" in told
        if self.draw.decades == 20 and BEYOND_DOUBLES in told:
            self.found["v* of a contact that opens, beyond doubles"] += 1
            return True
        reader = scenes_expected.Reader(self.scene["elements"], self.scene.get("networks", {}))
        no_load = scenes_expected.static_stiffness(reader.network(self.scene["contact"]["normal"])) == 0
        is_measured, has_masses = "receptance" in self.scene.get("drive", {}), "mass(" in str(self.scene)
        has_dampers = any(not name.startswith("k") for name in self.draw.half_space)
        return any(words in told and holds for words, holds in (
            ("no static load", no_load), ("it sinks for ever", no_load and "load" in self.scene),
            ("below a mount", "mount" in self.scene),
            ("several parts hold it", has_masses and "body" not in self.scene),
            ("cells with a memory", self.by_phases and has_dampers),
            ("whole contact opens", self.by_phases and not self.draw.separates),
            # docs/limits.md: a light body on the drive rings on while the rim of the indenter opens.
            ("within the bound on the work", self.by_phases and self.draw.separates and "body" in self.scene),
            ("below an indenter", self.by_phases and (has_masses or is_measured))))

    def compare(self, answer, formula):
        closed = {**self.scene, "contact": {**self.scene["contact"], "separation": False}}
        try:
            velocity, stays_closed, creep = scenes_expected.evaluate(closed, self.folder)
        except AssertionError:  # too near resonance
            self.found["near resonance"] += 1
            return
        require(abs(self.derived(formula) / velocity - 1) < TOLERANCE, "the derived formula differs")
        require(answer["admissible"] == (stays_closed or self.draw.separates), "admissible", answer["reasons"])
        if self.draw.separates:
            require(answer["opens"] != stays_closed, "opens", answer["opens"])
            if answer["critical_velocity_by"] == "simulation":
                self.found["v* of a contact that opens, simulated"] += 1
                return
        found = mpmath.mpf(answer["critical_velocity"])
        require(abs(found / velocity - 1) <= answer["relative_error_bound"] < TOLERANCE, "eval", found, "within",
                answer["relative_error_bound"], "nodal analysis", mpmath.nstr(velocity, 20))
        if stays_closed or not self.draw.separates:
            # The sum of both in doubles.
            total = mpmath.mpf(answer["drive_velocity"])
            require(abs(total / (velocity + creep) - 1) < TOLERANCE, "creep", total, mpmath.nstr(velocity + creep, 20))
        self.found["agrees with nodal analysis"] += 1

    def derived(self, formula):
        scene, quantity = self.scene, scenes_expected.quantity
        omega = scenes_expected.angular_frequency(scene["oscillation"])
        unit = mpmath.mpc(0, 1)
        names = {"abs": abs, "sqrt": mpmath.sqrt, "i": unit, "j": unit, "j_own": unit, "omega": omega,
                 "s": unit * omega, "s_own": unit * omega, "mu0": scene["friction"]["coefficient"],
                 # Of the contact, or of the vibrator above a mount.
                 "du_z": quantity(scene["oscillation"]["amplitude"]), "U": quantity(scene["oscillation"]["amplitude"]),
                 "m": quantity(scene.get("body", {}).get("mass", 0)), "m_n": quantity(scene.get("mount", {}).get("mass", 0))}
        if "receptance" in scene.get("drive", {}):
            names["R_d"] = 1 / scenes_expected.measured(self.folder / scene["drive"]["receptance"], omega)
        for name, value in scene["elements"].items():
            names[name] = [0, *map(quantity, value)] if isinstance(value, list) else quantity(value)

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
            without_periods = ended.stdout.replace('"periods": null', "")
            require("null" not in without_periods, "a motion without a number:", ended.stdout[:500])
            if ended.returncode != 0:
                self.found["no motion: " + re.sub(r"[-\d.e+]+", "#", json.loads(ended.stderr)["message"])[:100]] += 1
        if fast.returncode == 0:
            motion = json.loads(fast.stdout)
            slack = 1e-9 + motion["friction_ratio_error"]
            if motion["regime"].startswith("sliding"):
                require(abs(motion["friction_ratio"] - 1) <= slack, "sliding at", motion["friction_ratio"])
            elif answer["drive_velocity"] == answer["critical_velocity"]:  # else 1.05 v* is not above v* and creep
                require(motion["velocity"] <= self.border_of(motion, answer), "no sliding above v*:", motion["regime"], motion["friction_ratio"])
            self.found[f"above v*: {motion['regime']}"] += 1
        if slow.returncode == 0:
            motion = json.loads(slow.stdout)
            slack = 1e-9 + motion["friction_ratio_error"]
            require(0 <= motion["friction_ratio"] + slack and motion["friction_ratio"] <= 1 + slack, "friction", motion)
            slides = motion["regime"].startswith("sliding")
            require(not slides or motion["velocity"] >= self.border_of(motion, answer), "it slides at v*/2")
            self.found[f"at v*/2: {motion['regime']}"] += 1
            self.check_separation(motion)

    @staticmethod
    def border_of(motion, answer):
        """Of sliding, where the drive is the structure that was fitted to a random table: by that."""
        fitted = motion.get("realisation")
        return fitted["critical_velocity"] if fitted else answer["critical_velocity"]

    def check_separation(self, motion):
        """Both starts, and time steps, which share nothing with the exact motion but the scene."""
        if "separation" not in motion:
            return
        require(motion["separation"]["starts_agree"], "starts disagree", motion)
        if self.seed % STEPPED != 0:
            return
        ended = self.command("simulate", "--velocity-ratio", "0.5", "--method", "moreau", "--json")
        if ended.returncode == 0:
            stepped = json.loads(ended.stdout)
            off, error = abs(stepped["friction_ratio"] - motion["friction_ratio"]), stepped["friction_ratio_error"]
            self.found["time steps agree" if off <= error else "time steps disagree"] += 1

    def check_sweep(self, answer):
        """v* is proportional to mu0, also where it is simulated."""
        mu0 = self.scene["friction"]["coefficient"]
        swept = self.command("sweep", "--over", f"mu0=lin:{mu0 / 2!r}:{2 * mu0!r}:3", "--quantity", "critical_velocity",
                             "--quantity", "admissible", "--out", "t.csv")
        if swept.returncode != 0:
            require(not answer["admissible"], "not swept:", swept.stderr)
            return
        with (self.folder / "t.csv").open() as table:
            for row in csv.DictReader(table):
                require((row["admissible"] == "yes") == answer["admissible"], "swept", row)
                expected = float(answer["critical_velocity"]) / mu0 * float(row["mu0"])
                found = float(row["critical_velocity"])
                near = found == expected or abs(found / expected - 1) < 1e-9  # both infinite, or near each other
                require(near if answer["admissible"] else found != found, "swept", row, expected)
        self.found["swept"] += 1

    def compile(self):
        if self.command("generate", "--out", "lib", "--name", "scene").returncode != 0:
            return
        library = self.folder / "lib"
        built = subprocess.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-Werror", self.level, "test_scene.cpp", "-o", "test"],
                               cwd=library, capture_output=True, text=True)
        require(built.returncode == 0, "does not compile:", built.stderr[-2000:])
        ran = subprocess.run([library / "test"], cwd=library, capture_output=True, text=True)
        require(ran.returncode == 0, "the generated test fails:", ran.stdout[-500:])
        self.found["compiled and agrees"] += 1


def attempt(program, folder, seed, level):
    place = folder / str(seed)
    place.mkdir()
    try:
        found = Trial(program, place, seed, level).run()
    except Exception as error:  # whatever it is, the others go on
        return Counter(), f"{place}: {error}"
    shutil.rmtree(place)
    return found, None


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program", type=Path)
    options.add_argument("--scenes", type=int, default=10000)
    options.add_argument("--compiled", type=int, default=100)
    options.add_argument("--level", default="-O1", help="of the compiler: 13 s for a large mesh, with -O0 a fifth")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    chosen = options.parse_args()
    folder, total, failures = Path(tempfile.mkdtemp(prefix="held-load-")), Counter(), []
    every = max(1, chosen.scenes // chosen.compiled)
    with ProcessPoolExecutor(chosen.jobs) as pool:
        trials = [pool.submit(attempt, chosen.program.resolve(), folder, chosen.seed + i,
                              chosen.level if i % every == every // 2 else None)
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
