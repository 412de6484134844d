"""Processor time of critical_velocity over NumPy arrays beside the C++ batch call: ./dev bench python

Both work on the same arrays in one process, in turn; the best of several is printed, and the ratio.

    benchmark.py LIBRARY PROJECT [--points N] [--rounds N]
"""

import argparse
import ctypes
import sys
import time
from pathlib import Path

import numpy as np
import vcrit

CASES = [
    ("elastic", ["kn"]),
    ("elastic_drive", ["frequency"]),
    ("zener", ["frequency"]),
    ("zener", ["frequency", "k0", "c1", "m"]),
    ("prony", ["frequency"]),
]


class BatchCall:
    """The C++ batch call of one scene on given columns."""

    def __init__(self, library, scene, columns):
        names = (ctypes.c_char_p * len(columns))(*(name.encode() for name in columns))
        library.vcrit_formula.restype = ctypes.c_void_p
        self.library, self.size = library, len(next(iter(columns.values())))
        self.formula = ctypes.c_void_p(library.vcrit_formula(str(scene).encode(), names, ctypes.c_size_t(len(columns))))
        self.columns = (ctypes.c_void_p * len(columns))(*(column.ctypes.data for column in columns.values()))

    def into(self, out):
        self.library.vcrit_evaluate(self.formula, self.columns, ctypes.c_size_t(len(self.columns)),
                                    ctypes.c_void_p(out.ctypes.data), ctypes.c_size_t(self.size))

    def anew(self):
        self.library.vcrit_evaluate_new(self.formula, self.columns, ctypes.c_size_t(len(self.columns)),
                                        ctypes.c_size_t(self.size))


def seconds(call):
    start = time.process_time()
    call()
    return time.process_time() - start


def best(calls, rounds):
    """The least time of each call, made in turn."""
    return [min(times) for times in zip(*([seconds(call) for call in calls] for _ in range(rounds)))]


def measured(library, project, name, varying, points, rounds):
    file = project / f"scenes/{name}.toml"
    scene = vcrit.Scene(file)
    units = np.linspace(0.9, 1.1, points)
    value = {each: parameter.value for each, parameter in scene.parameters.items()}
    value["frequency"] = value["omega"] / (2 * np.pi)
    columns = {each: value[each] * np.roll(units, 1000 * i) for i, each in enumerate(varying)}
    batch, out, other = BatchCall(library, file, columns), np.empty(points), np.empty(points)
    times = best([lambda: batch.into(out), lambda: scene.critical_velocity(columns, out=other),
                  batch.anew, lambda: scene.critical_velocity(columns)], rounds)
    if not np.array_equal(out, other):
        sys.exit(f"{name}: the two differ")
    return times


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("library", type=ctypes.CDLL)
    arguments.add_argument("project", type=Path)
    arguments.add_argument("--points", type=int, default=10**7)
    arguments.add_argument("--rounds", type=int, default=15)
    chosen = arguments.parse_args()
    print(f"v* at {chosen.points:,} points, best of {chosen.rounds} in turn, in ms\n")
    print("| scene | arrays | C++ | NumPy, `out=` | ratio | C++, new array | NumPy, new array | ratio |")
    print("|---|---|---|---|---|---|---|---|")
    for name, varying in CASES:
        given, out, new, anew = measured(chosen.library, chosen.project, name, varying, chosen.points, chosen.rounds)
        print(f"| {name} | {', '.join(varying)} | {given * 1e3:.1f} | {out * 1e3:.1f} | {out / given:.3f} "
              f"| {new * 1e3:.1f} | {anew * 1e3:.1f} | {anew / new:.3f} |", flush=True)


if __name__ == "__main__":
    main()
