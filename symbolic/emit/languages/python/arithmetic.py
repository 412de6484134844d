# The fixed parts of generated Python, by sections. The generator fills in what begins with THE_. What is under "alone" is
# not generated: with it this file can be imported as it is.
#: imports
# mypy: disable-error-code="no-untyped-def,no-untyped-call"
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np


#: alone
@dataclass(eq=False)
class Parameters:
    mu0: Any
    THE_OMEGA: Any
    du_z: Any
#: tuples


class Certified(NamedTuple):
    value: Any
    relative_error_bound: Any  # infinite: nothing is known


class Gradient(NamedTuple):
    value: Any
    partial: Parameters  # d value/d parameter


class _Result(NamedTuple):
    value: Any
    bound: Any
    safe: Any
    partial: Any = ()


class _DD(NamedTuple):  # hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53
    hi: Any
    lo: Any


def _array(x):
    return np.asarray(x, dtype=np.float64)


def _arrays(x, n):
    if len(x) != n:
        raise ValueError(f"{len(x)} entries where {n} are expected")
    return [_array(entry) for entry in x]


#: alone
def _given(p):
    return Parameters(_array(p.mu0), _array(p.THE_OMEGA), _array(p.du_z))


def _gathered(x):
    return Parameters(*x)


def _in_range(p):
    return p.mu0 > 0.0
#: numbers


def _dd_number(hi, lo):
    return _DD(hi, lo)


def _dd_of(x):
    return _DD(x, 0.0)


def _dd_quick(a, b):
    s = a + b
    return _DD(s, b - (s - a))


def _dd_sum(a, b):
    s = a + b
    t = s - a
    return _DD(s, (a - (s - t)) + (b - t))


def _halves(a):
    c = 134217729.0 * a
    high = c - (c - a)
    return high, a - high


def _dd_product(a, b):
    p = a * b
    ah, al = _halves(a)
    bh, bl = _halves(b)
    return _DD(p, al * bl - (((p - ah * bh) - al * bh) - ah * bl))


def _dd_negated(a):
    return _DD(-a.hi, -a.lo)


def _dd_add_d(a, b):
    s = _dd_sum(a.hi, b)
    return _dd_quick(s.hi, s.lo + a.lo)


def _dd_add(a, b):
    s = _dd_sum(a.hi, b.hi)
    return _dd_quick(s.hi, s.lo + (a.lo + b.lo))


def _dd_mul_d(a, b):
    p = _dd_product(a.hi, b)
    return _dd_quick(p.hi, p.lo + a.lo * b)


def _dd_mul(a, b):
    p = _dd_product(a.hi, b.hi)
    return _dd_quick(p.hi, p.lo + (a.lo * b.hi + a.hi * b.lo))


def _dd_div(a, b):
    q = a.hi / b.hi
    return _dd_quick(q, _dd_add(a, _dd_negated(_dd_mul_d(b, q))).hi / b.hi)
#: root


def _dd_root(a):
    r = np.sqrt(a.hi)
    return _dd_quick(r, _dd_add(a, _dd_negated(_dd_product(r, r))).hi / (2.0 * r))
#: within


def _within(limit, x):  # -0 comes of a negative parameter
    return (x == 0.0) & ~np.signbit(x) | (x <= limit) & (x * limit >= 1.0)
#: less_inertia


def _dd_less_inertia(k, m, w):  # k - m w^2, exact but for the last rounding
    t = _dd_product(m, w)
    p = _dd_product(t.hi, w)
    q = _dd_product(t.lo, w)
    return _dd_add_d(_dd_add(_dd_sum(k, -p.hi), _dd_negated(_dd_sum(p.lo, q.hi))), -q.lo)


def _plain_less_inertia(k, m, w):
    t = _dd_product(m, w)
    p = _dd_product(t.hi, w)
    s = _dd_sum(k, -p.hi)
    return s.hi + ((s.lo - p.lo) - t.lo * w)
#: power_unit


def _unit(x):  # a power of two near 1/x
    return np.ldexp(1.0, 1 - np.frexp(x)[1])
#: nonzero


def _plain_nonzero(a, b):  # T/Q = 0/1 of what is not there
    return np.where((a == 0.0) & (b == 0.0), 1.0, a)


def _dd_nonzero(a, b):
    return _DD(_plain_nonzero(a.hi, b.hi), a.lo)
#: ties


from functools import lru_cache


def _plain_gap(gaps, re, im):  # edges that are 0, as bits
    return 2.0 * gaps + ((re == 0.0) & (im == 0.0))


def _dd_gap(gaps, re, im):
    return _plain_gap(gaps, re.hi, im.hi)


# Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness 1
# (1), its other gaps are none for good (0), and all other edges stay as they are (-1). `wiring`: two nodes an edge.
@lru_cache(10000)
def _ties(wiring, gaps):
    n = len(wiring) // 2
    ends = [1 << ord(wiring[2 * i]) - 97 | 1 << ord(wiring[2 * i + 1]) - 97 for i in range(n)]
    is_gap = [gaps >> n - 1 - i & 1 for i in range(n)]

    def leading_on(held, gap):
        return next((i for i in range(n) if is_gap[i] == gap and ends[i] & held and ends[i] & ~held), None)

    def connected(held):
        while (i := leading_on(held, 0)) is not None:
            held |= ends[i]
        return held

    held = connected(3)  # the terminals, and what edges and ties connect with them
    kinds = [0.0 if is_gap[i] and ends[i] & ~held else -1.0 for i in range(n)]
    while (i := leading_on(held, 1)) is not None:
        kinds[i] = 1.0
        held = connected(held | ends[i])
    return kinds


def _tie(wiring, gaps, edge):  # few of many rows have gaps of their own
    if not np.any(gaps):
        return -1.0
    values, places = np.unique(gaps, return_inverse=True)
    return np.array([_ties(wiring, int(each))[edge] for each in values])[places].reshape(np.shape(gaps))


def _plain_tied(a, kind, otherwise):
    return np.where(kind < 0.0, a, kind * otherwise)


def _dd_tied(a, kind, otherwise):
    return _DD(_plain_tied(a.hi, kind, otherwise), np.where(kind < 0.0, a.lo, 0.0))
#: magnitude


def _dd_magnitude(a):
    sign = np.where(a.hi < 0.0, -1.0, 1.0)
    return _DD(sign * a.hi, sign * a.lo)
#: unless_moderate


def _unless_moderate(x):
    return np.where(_within(2.0**200, x), 0.0, np.inf)
#: alone
THE_ROWS = 0.0, 0.0, 0.0
#: table


# The drive's receptance as it was measured: angular frequency, real and imaginary part. Linear between two rows.
_ROWS = np.array([THE_ROWS])


def _place(omega):  # of the row at or below omega, but for the last one; -1 outside of the table
    at = np.minimum(np.searchsorted(_ROWS[::3], omega, side="right") - 1, len(_ROWS) // 3 - 2)
    return np.where((omega >= _ROWS[0]) & (omega <= _ROWS[-3]), at, -1)


def _entry(at, number):
    return np.where(at < 0, np.nan, _ROWS[3 * np.maximum(at, 0) + number])
#: alone
THE_SQUARE_ROOT = np.sqrt
THE_ROOT = _dd_root
#: finished


# v* = factor root(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
# last rounding by u. safe: no number has left the range of doubles.
def _finished(h, value, e, u, inside):
    safe = inside & (h > 2.0**-900) & (h < 2.0**900) & (value >= 2.0**-1022) & (value < np.inf)
    bound = np.where(safe & (e < 2.0**-10), (1.01 * e + u) * (1.0 + 2.0**-50), np.inf)
    return _Result(value, bound, safe)


def _plain_finished(above, below, factor, roundings, inside):
    h = above / below
    return _finished(h, THE_SQUARE_ROOT(h) * factor, roundings * 2.0**-53, 0.0, inside)


def _dd_finished(above, below, factor, roundings, inside):
    v = _dd_mul(THE_ROOT(_dd_div(above, below)), factor).hi
    return _finished(above.hi / below.hi, v, roundings * 2.0**-102, 2.0**-53, inside)
#: alone
def _dd_evaluate(p, gradient):
    x = _dd_of(p.mu0)
    return _dd_finished(x, x, x, 50.0, _in_range(p))._replace(partial=[p.mu0] * 3)


def _plain_evaluate(p, gradient):
    return _plain_finished(p.mu0, p.mu0, p.mu0, 50.0, _in_range(p))._replace(partial=[p.mu0] * 3)
#: calls


def _result(evaluate, p, omega, gradient):
    p = _given(p if omega is None else replace(p, THE_OMEGA=omega))
    with np.errstate(all="ignore"):
        r = evaluate(p, gradient)
        plain = r if evaluate is _plain_evaluate or np.all(r.safe) else _plain_evaluate(p, gradient)

    def chosen(accurate, otherwise):
        return np.where(r.safe, accurate, otherwise)[()]

    partial = [chosen(a, b) for a, b in zip(r.partial, plain.partial)]
    return _Result(chosen(r.value, plain.value), chosen(r.bound, np.inf), r.safe, partial)


# v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: any parameter may be an array; `omega`, where it
# is given, stands in the place of p.THE_OMEGA.
def critical_velocity(p: Parameters, omega: Any = None) -> Any:
    return _result(_dd_evaluate, p, omega, False).value


def critical_velocity_certified(p: Parameters, omega: Any = None) -> Certified:
    r = _result(_dd_evaluate, p, omega, False)
    return Certified(r.value, r.bound)


def critical_velocity_gradient(p: Parameters, omega: Any = None) -> Gradient:
    r = _result(_dd_evaluate, p, omega, True)
    return Gradient(r.value, _gathered(r.partial))


# In plain double.
def fast_critical_velocity(p: Parameters, omega: Any = None) -> Any:
    return _result(_plain_evaluate, p, omega, False).value


def fast_critical_velocity_certified(p: Parameters, omega: Any = None) -> Certified:
    r = _result(_plain_evaluate, p, omega, False)
    return Certified(r.value, r.bound)


def fast_critical_velocity_gradient(p: Parameters, omega: Any = None) -> Gradient:
    r = _result(_plain_evaluate, p, omega, True)
    return Gradient(r.value, _gathered(r.partial))
