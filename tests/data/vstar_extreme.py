#!/usr/bin/python3
"""Fills in vstar_extreme.csv: v* of scenes with numbers of every size, exact.

It shares nothing with the program. A row's numbers up to ks are given: those of random scenes, class by class, and
some at the limits. What stands behind them is computed here once more. Doubles are rational numbers, and so are
Re and Im of every stiffness: networks are reduced in rational arithmetic, and

  v*^2 = (mu0 w duz)^2 |kz|^2 |N|^2/(|kx|^2 |D|^2),  D = ks - m w^2,  N = kx + D

is rational, too. Its root is rounded from an integer root of more than 400 bits, so that no rounding is in doubt.
Numbers are hexadecimal; networks:

  kelvin, maxwell  k;c                                  k | c, k - c
  zener            k0;k1;c1                             k0 | (k1 - c1)
  burgers          k1;c1;k2;c2                          k1 - c1 - (k2 | c2)
  prony10          k0;k1..k10;t1..t10                   k0 + sum k_j s t_j/(1 + s t_j)
  ladder10         k1..k10;c1..c10                      K_j = c_j s + (k_j - K_{j+1}), K10 = k10 + c10 s, K = K1
  bridge           k1..k5;c1..c5                        k_j | c_j along A-C, A-D, C-B, D-B, C-D; K between A and B

Columns: status (normal, subnormal, overflow, underflow, zero, pole, undefined), v* as the nearest double and with 30
digits, kappaD = (Re ks + m w^2)/|D|, kappaN = (Re kx + Re ks + m w^2)/|N|, and |kx|, |kz|, |D|, |N|. Needs mpmath, to
write decimal digits.
"""

import csv
from decimal import Decimal
from fractions import Fraction
from math import gcd, inf, isqrt
from pathlib import Path

from mpmath import mp, mpf, nstr

mp.prec = 500
FILE = Path(__file__).with_suffix(".csv")


class Rational:
    """A complex number of two rational ones, over one denominator: what they share is divided out once."""

    def __init__(self, re, im, below):
        shared = gcd(re, im, below)
        self.re, self.im, self.below = re // shared, im // shared, below // shared

    def __add__(self, other):
        return Rational(self.re * other.below + other.re * self.below, self.im * other.below + other.im * self.below,
                        self.below * other.below)

    def __mul__(self, other):
        return Rational(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re,
                        self.below * other.below)

    def __truediv__(self, other):
        return Rational((self.re * other.re + self.im * other.im) * other.below,
                        (self.im * other.re - self.re * other.im) * other.below, (other.re**2 + other.im**2) * self.below)

    def __bool__(self):
        return self.re != 0 or self.im != 0

    def real(self):
        return Fraction(self.re, self.below)

    def square(self):
        return Fraction(self.re**2 + self.im**2, self.below**2)


def real(x):
    return Rational(x.numerator, 0, x.denominator)


def imaginary(x):
    return Rational(0, x.numerator, x.denominator)


ZERO, ONE = real(0), real(1)


def series(*parts):
    whole = parts[0]
    for part in parts[1:]:
        total = whole + part
        whole = whole * part / total if total else ZERO
    return whole


def parallel(*parts):
    return sum(parts, ZERO)


def bridge(edges):
    """Nodes C and D one after the other: each a star, replaced by the mesh of its ends."""
    stiffness = dict(zip(["AC", "AD", "CB", "DB", "CD"], edges))
    for node in "CD":
        star = {name.replace(node, ""): z for name, z in stiffness.items() if node in name}
        stiffness = {name: z for name, z in stiffness.items() if node not in name}
        total = parallel(*star.values())
        ends = sorted(star, key="ACDB".index)
        for i, a in enumerate(ends):
            for b in ends[i + 1:]:
                mesh = star[a] * star[b] / total if total else ZERO
                stiffness[a + b] = stiffness.get(a + b, ZERO) + mesh
    return stiffness["AB"]


def stiffness(kind, numbers, w):
    x = [Fraction(float.fromhex(number)) for number in numbers.split(";")]
    k, c = lambda i: real(x[i]), lambda i: imaginary(w * x[i])
    if kind == "kelvin":
        return parallel(k(0), c(1))
    if kind == "maxwell":
        return series(k(0), c(1))
    if kind == "zener":
        return parallel(k(0), series(k(1), c(2)))
    if kind == "burgers":
        return series(k(0), c(1), parallel(k(2), c(3)))
    if kind == "prony10":
        branches = [imaginary(w * x[10 + j]) for j in range(1, 11)]
        return parallel(k(0), *[k(j) * y / (ONE + y) for j, y in enumerate(branches, 1)])
    if kind == "ladder10":
        inner = parallel(k(9), c(19))
        for j in reversed(range(9)):
            inner = parallel(c(10 + j), series(k(j), inner))
        return inner
    assert kind == "bridge", kind
    return bridge([parallel(k(j), c(5 + j)) for j in range(5)])


def root(square):
    """Its first 400 bits or more, and a last one that says whether there is more: rounds as the root does."""
    if square == 0:
        return Fraction(0)
    bits = 402 + max(0, square.denominator.bit_length() - square.numerator.bit_length())
    whole, rest = divmod(square.numerator << 2 * bits, square.denominator)
    found = isqrt(whole)
    return Fraction(2 * found + (1 if rest or found * found != whole else 0), 2 << bits)


def nearest_double(number):
    try:
        return float(number)  # correctly rounded by Python, subnormal numbers too
    except OverflowError:
        return inf


def hexadecimal(x):
    """As C's %a writes it: no zeros at the end."""
    if x == inf:
        return "inf"
    digits, exponent = x.hex().split("p")
    whole, dot, part = digits.partition(".")
    part = part if whole == "0x0" and x else part.rstrip("0")
    return f"{whole}{dot if part else ''}{part}p{exponent}"


def decimal(number, digits):
    value = mpf(number.numerator) / number.denominator
    # Written out from 1e-4 to as many places as there are digits before the point.
    return nstr(value, digits, strip_zeros=False, min_fixed=-5, max_fixed=digits - 1) if value else "0"


def short(number):
    """As C's %.3e writes it."""
    digits, exponent = f"{Decimal(number.numerator) / Decimal(number.denominator):.3e}".split("e")
    return f"{digits}e{int(exponent):+03d}"


def answers(row):
    mu0, w, duz, m = (Fraction(float.fromhex(row[name])) for name in ("mu0", "w", "duz", "m"))
    kx, kz, ks = (stiffness(row["kind"], row[name], w) for name in ("kx", "kz", "ks"))
    inertia = m * w * w
    d = ks + real(-inertia)
    n = kx + d
    squares = [z.square() for z in (kx, kz, d, n)]
    roots = [root(square) for square in squares]
    sizes = [decimal(each, 20) for each in roots]
    above = (mu0 * w * duz)**2 * squares[1] * squares[3]
    below = squares[0] * squares[2]
    kappas = ["nan", "nan"]
    if d and n:
        kappas = [short((re + inertia) / size)
                  for re, size in ((ks.real(), roots[2]), (kx.real() + ks.real(), roots[3]))]
    if below == 0:
        return ["undefined" if above == 0 else "pole", "nan" if above == 0 else "inf", "nan" if above == 0 else "inf",
                *kappas, *sizes]
    velocity = root(above / below)
    value = nearest_double(velocity)
    status = ("zero" if velocity == 0 else "underflow" if value == 0 else "overflow" if value == inf else
              "subnormal" if value < 2.0**-1022 else "normal")
    return [status, hexadecimal(value), decimal(velocity, 30), *kappas, *sizes]


def main():
    with FILE.open(newline="") as file:
        header, *rows = csv.reader(file)
    given = header.index("status")
    rows = [row[:given] + answers(dict(zip(header, row))) for row in rows]
    with FILE.open("w", newline="") as file:
        csv.writer(file).writerows([header, *rows])


if __name__ == "__main__":
    main()
