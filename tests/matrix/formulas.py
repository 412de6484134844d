"""Printed formulas read back: text and LaTeX as numbers, at a scene's values, in many digits."""

import functools
import json
import re

import mpmath as mp

import documents
import systems

mp.mp.dps = 80
# How far from a pole formulas are evaluated, where K_d is infinite and they would be infinite over infinite.
ASIDE = mp.mpf(10)**-45
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[+-]?\d+)?")
INDEX = re.compile(r"(\w+)\[(\d+)\]")
GREEK = {"mu", "omega", "tau", "kappa", "theta", "beta", "rho", "gamma", "alpha", "nu", "eta"}
TOKEN = re.compile(r"\\(?:left|right|frac|sqrt|Delta|mathrm|[a-zA-Z]+)|\d+(?:\.\d+)?|[a-zA-Z]|[{}_^+\-/()|=,']")


def beside_poles(values):
    return values | {"omega": values["omega"] * (1 + ASIDE)}


class Unknown(Exception):
    """A formula with a name that has no value (yet)."""


@functools.cache
def plain(name):
    """One spelling of a name: k[1], k_{(1)} and K_{n,own} without what only sets them."""
    return re.sub(r"\\mathrm|[\[\](){}_,\\]", "", name)


PRIME = "_prime"  # of storage and loss, K_n' and K_n'', which Python takes for strings


class Names(dict):
    """Values by names as text, and by what LaTeX makes of them."""

    def __init__(self, values):
        super().__init__()
        self.set_alike = {}
        self.evaluated = {}  # as Python takes the names of a text
        for name, value in values.items():
            self[name] = value

    def __setitem__(self, name, value):
        super().__setitem__(name, value)
        self.evaluated[name.replace("[", "_at_").rstrip("]").replace("'", PRIME)] = Number(mp.mpmathify(value))
        self.set_alike[plain("Deltauz" if name == "du_z" else name)] = Number(mp.mpmathify(value))

    def default(self, name, value):
        if name not in self and plain(name) not in self.set_alike:
            self[name] = value


def divided(a, b):
    return mp.inf if b == 0 and a != 0 else a / b


class Number:
    """A complex number whose quotient by 0 is infinite, as v* in resonance is."""

    def __init__(self, value):
        self.value = value

    def __add__(self, other): return Number(self.value + other.value)
    def __sub__(self, other): return Number(self.value - other.value)
    def __mul__(self, other): return Number(self.value * other.value)
    def __truediv__(self, other): return Number(divided(self.value, other.value))
    def __pow__(self, other): return Number(self.value ** other.value)
    def __neg__(self): return Number(-self.value)


@functools.cache
def constant(digits):
    return Number(mp.mpf(digits))


FUNCTIONS = {"abs": lambda x: Number(abs(x.value)), "sqrt": lambda x: Number(mp.sqrt(x.value)),
             "Re": lambda x: Number(mp.re(x.value))}

GIVEN = {"__builtins__": {}, "N_": constant, **{f"{name}_of_": function for name, function in FUNCTIONS.items()}}


@functools.cache
def compiled(text):
    """As Python takes it."""
    text = text.replace("'", PRIME)
    text = INDEX.sub(r"\1_at_\2", text)
    text = NUMBER.sub(lambda found: f'N_("{found[0]}")', text).replace("^", "**")
    text = re.sub(r"\b(abs|sqrt|Re)\(", r"\1_of_(", text)
    return compile(text.lstrip(" "), "formula", "eval")


def text_value(text, names):
    try:
        return eval(compiled(text), GIVEN, names.evaluated).value
    except (NameError, SyntaxError, TypeError, AttributeError) as error:
        raise Unknown(text) from error


@functools.cache
def tokens_of(text):
    """Ended by None."""
    return (*TOKEN.findall(text), None)


class Latex:
    """Recursive descent over the LaTeX that derive prints: sums, products by juxtaposition, powers, fractions, roots.
    Behind a slash stands one factor."""

    def __init__(self, text, names):
        self.tokens, self.at, self.names = tokens_of(text), 0, names
        self.index = None  # of the sum that is being evaluated, and its number

    def peek(self):
        return self.tokens[self.at]

    def take(self, expected=None):
        token = self.tokens[self.at]
        if token is None or (expected and token != expected):
            raise Unknown(f"{token} for {expected}")
        self.at += 1
        return token

    def whole(self):
        value = self.sum()
        if self.peek() is not None:
            raise Unknown(self.peek())
        return value.value

    def sum(self):
        sign = self.take() if self.peek() in ("+", "-") else "+"
        value = self.product()
        value = -value if sign == "-" else value
        while self.peek() in ("+", "-"):
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self):
        value, ends = self.power(), (None, "+", "-", ")", "}", "\\right", "|", "=", ",")
        while self.peek() not in ends:
            if self.peek() != "/":
                value = value * self.power()
                continue
            self.take()
            value = value / self.power()
            # a/b c may be read in two ways.
            if self.peek() not in ends:
                raise Unknown(f"{self.peek()} behind a slash")
        return value

    def power(self):
        value = self.atom()
        if self.peek() == "^":
            self.take()
            value = value ** self.group()
        return value

    def group(self):
        self.take("{")
        value = self.sum()
        self.take("}")
        return value

    def atom(self):
        token = self.take()
        if token == "{":
            self.at -= 1
            return self.group()
        if token == "\\left":
            bar = self.take()
            value = self.sum()
            self.take("\\right")
            self.take()
            return FUNCTIONS["abs"](value) if bar == "|" else value
        if token == "\\frac":
            over = self.group()
            return over / self.group()
        if token == "\\sum":
            return self.series()
        if token == "\\sqrt":
            return FUNCTIONS["sqrt"](self.group())
        if token[0].isdigit():
            return constant(token)
        return self.symbol(token)

    def series(self):
        self.take("_")
        index, first = self.raw().split("=")
        self.take("^")
        last, begin, total = self.raw(), self.at, constant("0")
        for number in range(int(first), int(last) + 1):
            self.at, self.index = begin, (index, number)
            total = total + self.product()
        self.index = None
        return total

    def symbol(self, token):
        name = token.lstrip("\\")
        if token == "\\mathrm":
            name = self.raw()
        elif token == "\\Delta":
            name = "Delta" + self.take()
        if self.peek() == "_":
            self.take()
            name += self.at_number(self.raw())
        while self.peek() == "'":
            name += self.take()
        name = plain(name)
        if name not in self.names.set_alike:
            raise Unknown(name)
        return self.names.set_alike[name]

    def at_number(self, letters):
        if self.index is None:
            return letters
        return re.sub(rf"(?<![^,]){self.index[0]}([+-]\d+)?$", lambda found: str(self.index[1] + int(found[1] or 0)),
                      letters)

    def raw(self):
        """The letters of a group, with all that only sets them."""
        self.take("{")
        letters, depth = "", 1
        while depth:
            token = self.take()
            depth += {"{": 1, "}": -1}.get(token, 0)
            letters += "" if token == "\\mathrm" else token.lstrip("\\")
        return letters[:-1]


def all_onsets(printed, form, form_of_text, values):
    """v* by everything that `derive` prints in one form and format."""
    if form_of_text in systems.SYSTEMS:
        return [systems.read(form_of_text, printed).value(values)]
    if form_of_text != "json":
        return onsets(printed, form_of_text, values)
    document, found = json.loads(printed), []
    for lines in (document["lines"], document.get(form, [])):
        texts = {"text": "\n".join(f"{line['words']}\n    {line['text']}" for line in lines),
                 "latex": "\n".join(f"{line['words']}\n\\[ {line['latex']} \\]" for line in lines)}
        found += [value for each, text in texts.items() for value in onsets(text, each, values)]
    return found + [abs(line_value(document["critical_velocity"], values, definitions=document["definitions"]))]


def onsets(document, form, values):
    """v* by each line of a printed derivation that can be evaluated at these values.

    The dimensionless form has stiffnesses of its own, over the one that its groups refer to, by the same names.
    """
    heading = {"text": r"^Dimensionless form:$", "latex": r"^\\subsection\*\{Dimensionless form\}$",
               "markdown": r"^##+ Dimensionless form$", "html": r"^<h2>Dimensionless form</h2>$"}[form]
    if form == "html":
        document, form = documents.as_latex(document), "latex"
    laplace = r"with (\S+) = (\S+)\*omega" if form == "text" else r"\$([^ $]+) = ([^ $]+) ?\\omega\$"
    words = re.findall(laplace, document)
    parts = re.split(heading, document, flags=re.M)
    # Names that words bring in: "separated, and Z = kd - m omega^2".
    meant = re.findall(r"and \$([A-Za-z]) = ([^$]+)\$", document) if form != "text" else []
    read_as, given = "text" if form == "text" else "latex", (tuple(values.items()), tuple(words))
    return [value for part in parts
            for value in part_onsets((*meant, *documents.equations(part, form)), read_as, *given)]


@functools.cache
def part_onsets(pairs, form, values, words):
    """In as many passes as it takes: a rational form names its parts before it says what they are. The same formulas are in
    documents of several formats."""
    values = dict(values)
    names = Names(values)
    for own, unit in words or [("s", "i")]:
        names.default(own.replace("\\mathrm", "").replace("\\", ""), 1j * values["omega"])
        names.default(unit, mp.mpc(1j))
    read = (lambda right: text_value(right, names)) if form == "text" else (lambda right: Latex(right, names).whole())
    star = {"text": ("v*", "v*^2")}.get(form, ("v^{*}", r"\left(v^{*}\right)^{2}"))
    pending, found = [pair for pair in pairs if pair[1] != "0"], []
    while True:
        later = []
        for left, right in pending:
            try:
                value = read(right)
            except Unknown:
                later.append((left, right))
                continue
            if left in star:
                found.append(abs(value) if left == star[0] else mp.sqrt(abs(value)))
            else:
                names.default(left, value)
        if len(later) == len(pending):
            return found
        pending = later


def line_value(item, values, what="text", definitions=()):
    """The value of one line or limit of the JSON, with its definitions and those of the document."""
    names = Names(values)
    if "omega" in values:
        for own, unit in (("s", "i"), ("s_own", "j")):
            names.default(own, 1j * values["omega"])
            names.default(unit, mp.mpc(1j))
    for definition in (*definitions, *item.get("definitions", [])):
        left, right = definition["text"].split(" = ", 1)
        names[left] = text_value(right, names)
    text = item[what]
    return text_value(text, names) if what == "text" else Latex(text, names).whole()
