"""Generated C99 and C++ as firmware has them: compiled for ARM cores with and without a floating-point unit and fma,
against newlib and glibc, run by qemu and compared with nodal analysis at 250 digits (data/scenes_expected.py, which
shares nothing with the program). A build is right where every bound holds, or where the compiler ends in #error.

    embedded_trial.py PROGRAM [--rows 300] [--seed 1] [--jobs 2] [--only TEXT]

All scenes of scenes/ that have code, each with so many random sets of parameters. Prints one line a build: rows, those
whose bound is finite in the accurate and in the fast grade, and violations; ends with status 1 if there are any. With
--only, builds whose line begins with words that have TEXT: "c99 ", "cortex-m4".
"""

import argparse
import itertools
import math
import random
import re
import struct
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mpmath import mpc, mpf

HERE = Path(__file__).resolve().parent
SCENES = HERE.parents[1] / "scenes"
sys.path.insert(0, str(HERE.parent / "data"))
import scenes_expected  # noqa: E402

ANSWERS = 6  # of driver.c: value and bound of both grades, both batches
WRONG = (math.nan, math.inf, -1.0)  # no scene has them

# Cores without an operating system, newlib beneath. qemu's user mode knows their instructions as those of "max".
BARE = {
    "cortex-m0, no FPU": ["-mcpu=cortex-m0"],
    "cortex-m3, no FPU": ["-mcpu=cortex-m3"],
    "cortex-m4, FPU for float, softfp": ["-mcpu=cortex-m4", "-mfloat-abi=softfp", "-mfpu=fpv4-sp-d16"],
    "cortex-m4, FPU for float, hard": ["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
    "cortex-m7, fma": ["-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"],
    "cortex-a7, no FPU": ["-mcpu=cortex-a7", "-mfloat-abi=soft"],
    "cortex-a9, no fma, softfp": ["-mcpu=cortex-a9", "-mfloat-abi=softfp", "-mfpu=vfpv3-d16"],
    "cortex-a7, fma": ["-mcpu=cortex-a7", "-mfloat-abi=hard", "-mfpu=neon-vfpv4"],
}
# Linux, glibc.
LINUX = {
    "armv7-a, no fma": ["-march=armv7-a+fp", "-mfloat-abi=hard"],
    "cortex-a7, fma": ["-mcpu=cortex-a7", "-mfloat-abi=hard", "-mfpu=neon-vfpv4"],
}
PLAIN = (["-Os"], ["-O2"])
# What firmware is compiled with, too, on one core of each kind.
CHANGED = (["-O2", "-ffast-math"], ["-O2", "-fsingle-precision-constant"], ["-O2", "-ffinite-math-only"],
           ["-O3", "-fno-math-errno", "-ffp-contract=off"])
CHANGED_CORES = ("cortex-m4, FPU for float, hard", "cortex-m7, fma", "armv7-a, no fma")


def members(header):
    """Names of the parameters, arrays entry by entry, in the order of the C99 structure."""
    text = re.search(r"typedef struct \{\s*double ([^;]*);\s*\} \w+_Parameters;", header)[1]
    names = []
    for name in re.split(r",\s*", text):
        array = re.fullmatch(r"(\w+)\[(\d+)\]", name)
        names += [(array[1], i) for i in range(int(array[2]))] if array else [(name, None)]
    return names


class Library:
    """The evaluator of one scene, and what it has to answer."""

    def __init__(self, program, file, folder):
        self.scene = tomllib.loads(file.read_text())
        self.name = file.stem
        self.has_code = True
        for language in ("c99", "c++"):
            made = subprocess.run([program, "generate", file, "--language", language, "--out", folder / language, "--name",
                                   self.name], capture_output=True, text=True)
            if made.returncode == 3:  # a drive that generated code does not know
                self.has_code = False
                return
            if made.returncode != 0:
                sys.exit(made.stderr)
        self.members = members((folder / "c99" / f"{self.name}.h").read_text())

    def drawn(self, rng, kind):
        """Random values: a decade about those of the scene, of kind 1 twelve decades, of kind 2 next to resonance."""
        decades = 12 if kind == 1 else 1
        given = self.scene["oscillation"], self.scene["friction"]

        def near(value):
            return float(scenes_expected.quantity(value)) * 10 ** rng.uniform(-decades, decades)

        values = {name: [near(entry) for entry in value] if isinstance(value, list) else near(value)
                  for name, value in self.scene["elements"].items()}
        values["mu0"] = near(given[1]["coefficient"])
        values["omega"] = near(given[0]["frequency"]) * math.tau
        values["du_z"] = near(given[0]["amplitude"])
        if "body" in self.scene:
            values["m"] = near(self.scene["body"]["mass"])
        if kind == 2 and "body" in self.scene:
            self.near_resonance(rng, values)
        return values

    def near_resonance(self, rng, values):
        stiffnesses = self.stiffnesses(values)
        stiffness = stiffnesses["drive"] + rng.choice((0, 1)) * stiffnesses["tangential"]
        mass = stiffness.real / mpf(values["omega"]) ** 2 * (1 + mpf(10) ** rng.uniform(-13, -1))
        if mass > 0:
            values["m"] = float(mass)

    def stiffnesses(self, values):
        reader = scenes_expected.Reader(values, self.scene.get("networks", {}))
        contact, s = self.scene["contact"], mpc(0, mpf(values["omega"]))
        normal = reader.network(contact["normal"]).stiffness(s)
        if "tangential" in contact:
            tangential = reader.network(contact["tangential"]).stiffness(s)
        elif "poisson" in contact:
            nu = scenes_expected.exact(contact["poisson"])
            tangential = normal * 2 * (1 - nu) / (2 - nu)
        else:
            tangential = normal * scenes_expected.exact(contact["tangential_ratio"])
        found = {"normal": normal, "tangential": tangential}
        if "drive" in self.scene:
            found["drive"] = reader.network(self.scene["drive"]["network"]).stiffness(s)
        return found

    def velocity(self, values):
        """Eq. (24)."""
        k, omega = self.stiffnesses(values), mpf(values["omega"])
        velocity = mpf(values["mu0"]) * omega * mpf(values["du_z"]) * abs(k["normal"]) / abs(k["tangential"])
        if "drive" in k:
            d = k["drive"] - mpf(values.get("m", 0.0)) * omega**2
            velocity *= abs(k["tangential"] + d) / abs(d)
        return velocity

    def row(self, values):
        return [values[name] if entry is None else values[name][entry] for name, entry in self.members]


class Trial:
    """Rows for all libraries, and what is right for them."""

    def __init__(self, program, folder, count, seed):
        print(f"seed {seed}")
        rng, self.folder = random.Random(seed), folder
        self.libraries = [library for file in sorted(SCENES.glob("*.toml"))
                          if (library := Library(program, file, folder)).has_code]
        self.right, self.input = [], b""
        for number, library in enumerate(self.libraries):
            for i in range(count):
                values = library.drawn(rng, i % 3)
                self.add(number, library.row(values), library.velocity(values))
            for wrong in WRONG:
                row = library.row(values)
                row[rng.randrange(len(row))] = wrong
                self.add(number, row, None)
        for language, ending in (("c99", ".h"), ("c++", ".hpp")):
            lines = [f'#include "{library.name}{ending}"' for library in self.libraries]
            cases = " ".join(f"X({i}, {library.name})" for i, library in enumerate(self.libraries))
            (folder / language / "scenes.h").write_text("\n".join([*lines, f"#define SCENES(X) {cases}", ""]))

    def add(self, number, row, right):
        self.input += struct.pack(f"<{1 + len(row)}d", number, *row)
        self.right.append(right)

    def judge(self, output):
        """Finite bounds of the accurate and the fast grade, and violations."""
        if len(output) != 8 * ANSWERS * len(self.right):
            return 0, 0, f"{len(output)} bytes of answers"
        finite, violations = [0, 0], 0
        for i, right in enumerate(self.right):
            a, ea, f, ef, batch, fast_batch = struct.unpack_from(f"<{ANSWERS}d", output, 8 * ANSWERS * i)
            for grade, values, bound in ((0, (a, batch), ea), (1, (f, fast_batch), ef)):
                if bound == math.inf:
                    continue
                finite[grade] += 1
                violations += any(not holds(value, bound, right) for value in values)
        return *finite, violations


def holds(value, bound, right):
    """Nothing is known of wrong parameters, and a bound that is no number is none."""
    return right is not None and math.isfinite(value) and abs(mpf(value) - right) <= mpf(bound) * right


class Build:
    def __init__(self, trial, language, library, core, flags):
        self.trial, self.language, self.library, self.core, self.flags = trial, language, library, core, flags

    def command(self, program):
        target = "arm-none-eabi" if self.library == "newlib" else "arm-linux-gnueabihf"
        version = "" if self.library == "newlib" else "-12"
        is_cpp = self.language == "c++"
        words = [f"{target}-g++{version}", "-std=c++20", "-fno-exceptions", "-fno-rtti", "-Wno-psabi"] if is_cpp else \
            [f"{target}-gcc{version}", "-std=c99"]
        words += ["-mthumb", *(BARE if self.library == "newlib" else LINUX)[self.core], *self.flags]
        words += ["-D_DEFAULT_SOURCE", "-I", self.trial.folder / self.language, "-x", "c++" if is_cpp else "c"]
        words += [HERE / "driver.c"]
        if self.library == "newlib":
            words += ["-nostartfiles", "--specs=nosys.specs", "-x", "c", HERE / "bare.c"]
        return [*words, "-x", "none", "-static", "-lm", "-o", program]

    def run(self):
        """What came out of it, as a line, and whether that is right."""
        program = self.trial.folder / f"{self.language} {self.library} {self.core} {' '.join(self.flags)}"
        command = self.command(program)
        built = subprocess.run(command, capture_output=True, text=True)
        if built.returncode != 0:
            refused = "error: #error" in built.stderr
            return self.line("#error" if refused else built.stderr[-2000:]), refused
        ran = subprocess.run(["qemu-arm", "-cpu", "max", program], input=self.trial.input, capture_output=True)
        if ran.returncode != 0:
            return self.line(f"ended with {ran.returncode} {ran.stderr[-300:]}"), False
        accurate, fast, violations = self.trial.judge(ran.stdout)
        rows = len(self.trial.right)
        return self.line(f"{rows:6} rows {accurate:6} {fast:6} bounds, violations: {violations}"), violations == 0

    def line(self, what):
        return f"{self.language:4} {self.library:7} {self.core:33} {' '.join(self.flags):36} {what}"


def builds(trial):
    for language, (library, cores) in itertools.product(("c99", "c++"), (("newlib", BARE), ("glibc", LINUX))):
        for core in cores:
            for flags in (*PLAIN, *(CHANGED if core in CHANGED_CORES else ())):
                yield Build(trial, language, library, core, flags)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program", type=Path)
    options.add_argument("--rows", type=int, default=300)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--only", default="", metavar="TEXT")
    chosen = options.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="vcrit-embedded-") as folder, ThreadPoolExecutor(chosen.jobs) as pool:
        trial = Trial(chosen.program.resolve(), Path(folder), chosen.rows, chosen.seed)
        print(f"{len(trial.libraries)} scenes: {', '.join(library.name for library in trial.libraries)}", flush=True)
        chosen_builds = [build for build in builds(trial) if chosen.only in build.line("")]
        if not chosen_builds:
            sys.exit(f'no build has "{chosen.only}"')
        for line, is_right in pool.map(Build.run, chosen_builds):
            print(line, flush=True)
            wrong += not is_right
    print(f"{wrong} builds are wrong" if wrong else "Every build keeps its bounds or ends in #error.")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
