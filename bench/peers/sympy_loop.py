"""v* by SymPy: |K|^2 composed of real and imaginary parts as expressions, common subexpressions named by cse, printed
by ccode into two C++ loops.

    sympy_loop.py PROBLEM.json LOOP.cpp
"""

import json
import sys

import sympy
from networks import composed

LOOP = """extern "C" void {name}(const double* const* x, std::size_t n, double* __restrict out, double*) {{
{outside}#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {{
{inside}{body}  }}
}}
"""


class Number:
    def __init__(self, re, im):
        self.re, self.im = re, im

    def __add__(self, other):
        return Number(self.re + other.re, self.im + other.im)

    def __mul__(self, other):
        return Number(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    def __truediv__(self, other):
        q = other.squared()
        return Number((self.re * other.re + self.im * other.im) / q, (self.im * other.re - self.re * other.im) / q)

    def squared(self):
        return self.re**2 + self.im**2


def real(value):
    return Number(value, sympy.Integer(0))


def velocity(problem):
    """Eq. (24) in symbols x0, x1, ... of the columns."""
    x = {name: sympy.Symbol(f"x{j}", positive=True) for j, name in enumerate(problem["columns"])}
    mu0, omega, du_z, m = list(x.values())[:4]

    def turn(name):
        return Number(sympy.Integer(0), x[name] * omega)

    def element(kind, name, time=None):
        if kind == "maxwell":
            return real(x[name]) * turn(time) / (real(1) + turn(time))
        return turn(name) if kind == "damper" else real(x[name])

    def stiffness(steps):
        return composed(steps, element, lambda a, b: a * b / (a + b))

    normal, drive = stiffness(problem["normal"]), stiffness(problem["drive"])
    if "ratio" in problem:
        tangential = real(x[problem["ratio"]]) * normal
    else:
        tangential = stiffness(problem["tangential"])
    loaded = drive + real(-m * omega**2)
    return mu0 * omega * du_z * sympy.sqrt(
        normal.squared() * (tangential + loaded).squared() / (tangential.squared() * loaded.squared()))


def loop(name, columns, body, varies):
    def read(chosen, index):
        return "".join(f"  const double x{j} = x[{j}][{index}];\n" for j in range(columns) if varies(j) == chosen)

    return LOOP.format(name=name, outside=read(False, "0"), inside=read(True, "i"), body=body)


def main():
    problem = json.load(open(sys.argv[1]))
    sys.setrecursionlimit(100000)
    names, (value,) = sympy.cse(velocity(problem), symbols=sympy.numbered_symbols("t"))
    body = "".join(f"    const double {name} = {sympy.ccode(expression)};\n" for name, expression in names)
    body += f"    out[i] = {sympy.ccode(value)};\n"
    columns = len(problem["columns"])
    with open(sys.argv[2], "w") as file:
        file.write("#include <cmath>\n#include <cstddef>\nusing std::pow;\nusing std::sqrt;\n")
        file.write(loop("sweep", columns, body, lambda j: j == problem["omega"]))
        file.write(loop("varying", columns, body, lambda j: True))


if __name__ == "__main__":
    main()
