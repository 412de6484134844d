"""How long v* is as vcrit prints it, as it was written by hand, and as SymPy's simplify, factor and cse leave it.

    formula_lengths.py VCRIT HAND_FORMS.csv [--limit SECONDS]

A length is the number of + - * / ^ sqrt abs, definitions included. SymPy begins with Eq. (24) of symbols declared
positive, written in two ways: its real and imaginary parts as they come from the networks, and multiplied out. simplify
and factor are given both, cse these and what the other two made of them; the shortest of each counts. A form that is not
back within the limit is left out.
"""

import argparse
import csv
import json
import re
import signal
import statistics
import subprocess
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import sympy


def length(*expressions):
    return sum(len(re.findall(r"\*\*|[-+*/]|sqrt\(|Abs\(", str(each))) for each in expressions)


def derived(vcrit, form, scene):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(scene)
        file.flush()
        command = [vcrit, "derive", file.name, "--form", form, "--json"]
        return json.loads(subprocess.run(command, text=True, check=True, capture_output=True).stdout)


def as_it_comes(value):
    """|value| of positive symbols by its real and imaginary part."""
    re, im = value.as_real_imag()
    return sympy.sqrt(re**2 + im**2)


def multiplied_out(value):
    """|value| as the root of one real fraction."""
    parts = [sympy.expand(each).as_real_imag() for each in sympy.fraction(sympy.together(value))]
    above, below = (sympy.expand(re**2 + im**2) for re, im in parts)
    return sympy.sqrt(above / below)


def velocity(nested, modulus):
    """v* of a nested derivation with its definitions put in."""
    names = {"s": sympy.I * sympy.Symbol("omega", positive=True), "sqrt": sympy.sqrt, "abs": modulus}

    def value(text):
        text = re.sub(r"\[(\d+)\]", r"_\1", text).replace("^", "**")
        for name in re.findall(r"[A-Za-z]\w*", text):
            names.setdefault(name, sympy.Symbol(name, positive=True))
        return sympy.sympify(text, locals=names)

    for line in nested["definitions"]:
        name, text = line["text"].split(" = ")
        names[name] = value(text)
    return value(nested["critical_velocity"]["text"])


class TooLong(Exception):
    pass


def within(limit, function, *arguments):
    """Nothing where it takes longer than `limit` seconds."""
    def stop(*_):
        raise TooLong

    signal.signal(signal.SIGALRM, stop)
    signal.alarm(limit)
    try:
        return function(*arguments)
    except TooLong:
        return None
    finally:
        signal.alarm(0)


def factored(expression):
    """With each fraction below a root in factors."""
    return expression.replace(lambda each: each.is_Pow and each.exp == sympy.Rational(1, 2),
                              lambda each: sympy.sqrt(sympy.factor(each.base)))


def shared(expression):
    definitions, (value,) = sympy.cse(expression)
    return length(value, *(meaning for _, meaning in definitions))


def least(values):
    return min((each for each in values if each is not None), default=None)


def lengths(job):
    vcrit, limit, row = job
    nested = derived(vcrit, "nested", row["scene"])
    starts = [velocity(nested, modulus) for modulus in (as_it_comes, multiplied_out)]
    forms = [[within(limit, function, start) for start in starts] for function in (sympy.simplify, factored)]
    found = [least(each and length(each) for each in some) for some in forms]
    shortened = [within(limit, shared, each) for each in sum(forms, starts) if each is not None]
    own = derived(vcrit, "shortest", row["scene"])["operations"]
    return row["rheology"], [own, int(row["operations by hand"]), *found, least(shortened)]


def print_table(answers):
    columns = ["vcrit", "by hand", "simplify", "factor", "cse"]
    print(f"{'':32}" + "".join(f"{name:>10}" for name in columns))
    for rheology in dict.fromkeys(name for name, _ in answers):
        rows = [numbers for name, numbers in answers if name == rheology]
        known = [[each for each in column if each is not None] for column in zip(*rows)]
        print(f"{rheology:32}" + "".join(f"{statistics.median(column):>10.1f}" if column else f"{'-':>10}"
                                         for column in known))
    for name, column in list(zip(columns, zip(*(numbers for _, numbers in answers))))[1:]:
        pairs = [(numbers[0], other) for (_, numbers), other in zip(answers, column)]
        ratios = [own / other for own, other in pairs if other is not None]
        print(f"vcrit over {name}: median {statistics.median(ratios):.2f}, largest {max(ratios):.2f}; longer in "
              f"{sum(ratio > 1 for ratio in ratios)} of {len(pairs)}; no answer: {len(pairs) - len(ratios)}")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("vcrit", type=Path)
    arguments.add_argument("hand_forms", type=Path)
    arguments.add_argument("--limit", type=int, default=30)
    chosen = arguments.parse_args()
    rows = list(csv.DictReader(chosen.hand_forms.open()))
    with ProcessPoolExecutor() as pool:
        answers = list(pool.map(lengths, [(chosen.vcrit, chosen.limit, row) for row in rows]))
    print(f"Operations of v*, medians of {len(rows) // len({name for name, _ in answers})} scenes a rheology "
          f"(SymPy {sympy.__version__}, {chosen.limit} s a form)\n")
    print_table(answers)


if __name__ == "__main__":
    main()
