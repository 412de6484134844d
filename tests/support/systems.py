"""Formulas that vcrit exports (`derive --format`) read back without the systems that they are for: each file by the
grammar of its language, as far as formulas need it, and evaluated in as many digits as mpmath is told to use.

A name that the language would not take for a plain variable is refused. The words are from the documentation of the
languages, not from the program.
"""

import ast
import re
import xml.etree.ElementTree as ET

import mpmath as mp

from rounded import is_real, root

# Symbols of System` that are short, or that somebody may call a part of a machine.
MATHEMATICA = """C D E I K N O Do Dt If Im In On Or Pi Re Tr All And Dot Exp Log Map Max Min Mod Not Off Out Set Sin Cos
Tan Sum Abs Arg Axes Ball Band Beta Black Block Blue Bond Body Box Byte Cap Cell Circle Cone Cube Cyan Darker Debug Decrement
Degree Delta Derivative Det Disk Drop Dynamic Element End Erf Exit Factor False File First Flat Floor Friction Gamma
Gray Grid Green Head Hold Infinity Input Inner Integer Join Key Label Last Length Less Level Limit Line List Locked Mean
Mass Module Names Needs Nest Norm Normal None Null Order Part Path Pause Piecewise Plot Plus Point Power Print Product
Prime Quit Random Range Rational Real Red Rest Return Root Round Row Run Save Series Sign Solid Solve Sort Span
Speed Spring Sphere Sqrt Star Stack Step String Switch Table Take Text Thick Thin Times Tube True Union
Unit Up Vectors While White With Xor Zeta""".split()
# ?reserved, ?initialfunctions, ?ininames, as far as a scene may call an element so.
MAPLE = """and assuming by description done elif end error fi from implies intersect local minus mod module next od
option options proc quit read save stop subset then to until use uses D I O Pi Catalan gamma Beta Chi Ci Digits Ei Eval
FAIL Heaviside Im Int Li Limit Normal Order Psi Re Shi Si Sum Zeta abs add alias arccos arcsin arctan array assign assume
assigned cat ceil coeff collect combine convert cos cot degree denom diff eval evalf exp expand factor floor frac gcd has
index infinity int interface iquo irem lcm length lhs lprint limit ln log log10 map max member min mul nops norm normal numer
op order parse plot plot3d print product radical rand range rational real rem residue rhs root round select seq series sign
signum simplify sin solve sort sqrt string subs sum symbol table tan time trace trunc type unapply undefined value
vector whattype zip""".split()
C = """I complex imaginary cabs carg creal cimag conj csqrt cpow sqrt sqrtf pow powf fabs abs exp log sin cos tan gamma lgamma
tgamma j0 j1 jn y0 y1 yn hypot ceil floor round trunc remainder fmax fmin fma nan erf erfc cbrt ldexp frexp
modf scalb signgam significand drem isnan isinf signbit finite log1p expm1 logb ilogb rint""".split()
# Of `from sympy import *`, beside Python's keywords.
SYMPY = """None True False as S N Q O E I pi beta gamma zeta Abs Rational Symbol sqrt symbols Chi Ci Si Ei Li Ne Eq Gt Ge Lt
Le Or And Not Xor re im arg sign exp log ln sin cos tan diff solve simplify series limit var test true false oo""".split()


class Wrong(Exception):
    """What the language would not take."""


def need(holds, *what):
    if not holds:
        raise Wrong(" ".join(str(each) for each in what)[:500])


class Export:
    """The parts of a file: `parameters` by what the scene calls them, `definitions` in order, `velocity`. An expression
    is a function of the values that names have by then."""

    def __init__(self, parameters, definitions, velocity):
        self.parameters, self.definitions, self.velocity = parameters, definitions, velocity

    def value(self, values):
        """v* where `values` has what the scene's names are; no other name has a value, and none has two."""
        names = {symbol: values[scene] for scene, symbol in self.parameters.items()}
        need(len(names) == len(self.parameters), "two parameters of one name", self.parameters)
        for name, expression in self.definitions:
            need(name not in names, "a second definition of", name)
            names[name] = expression(names)
        return self.velocity(names)


class Expression:
    """Recursive descent: sums, products, powers; what a system has of its own is in its row."""

    def __init__(self, system, text):
        self.system, self.names = system, None
        self.tokens = [found[0] for found in re.finditer(system.token + r"|\S", text)]
        self.at = 0

    def __call__(self, names):
        self.at, self.names = 0, names
        value = self.sum()
        need(self.peek() is None, "left over:", self.tokens[self.at:][:5])
        return value

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self, expected=None):
        token = self.peek()
        need(token is not None and expected in (None, token), token, "in place of", expected)
        self.at += 1
        return token

    def sum(self):
        minus = self.peek() == "-" and bool(self.take())
        value = self.product()
        value = -value if minus else value
        while self.peek() in ("+", "-"):
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self):
        value = self.power()
        while self.peek() in ("*", "/"):
            value = value * self.power() if self.take() == "*" else value / self.power()
        return value

    def power(self):
        value = self.atom()
        if self.system.power is not None and self.peek() == self.system.power:
            self.take()
            value = value ** self.exponent()
        return value

    def exponent(self):
        digits = self.take()
        need(digits.isdigit(), digits, "as an exponent")
        return int(digits)

    def atom(self):
        token = self.take()
        if token == "(":
            value = self.sum()
            self.take(")")
            return value
        if token[0].isdigit():
            need(re.fullmatch(self.system.number, token), token, "as a number")
            return mp.mpf(token)
        if token == self.system.imaginary:
            return mp.mpc(1j)
        if token in self.system.functions:
            return self.call(token)
        need(self.system.is_variable(token), token, "as a variable")
        need(token in self.names, token, "has no value")
        return self.names[token]

    def call(self, function):
        begin, end = self.system.brackets
        self.take(begin)
        value = self.sum()
        kind = self.system.functions[function]
        if kind == "pow":
            self.take(",")
            value = value ** self.exponent()
        self.take(end)
        if kind == "real" or kind == "root":
            need(is_real(value), function, "of a complex number")
        return root(value) if kind == "root" else value if kind == "pow" else abs(value)


class System:
    token = r"\d+|[A-Za-z]\w*"
    number, power, imaginary, brackets = r"\d+", "^", "I", "()"
    words = ()
    name = r"[A-Za-z][A-Za-z0-9_]*"
    result = "v_star"

    def is_variable(self, name):
        return re.fullmatch(self.name, name) is not None and name not in self.words

    def expression(self, text):
        return Expression(self, text)

    def statements(self, text):
        """(kind, name, text): parameters with what the scene calls them, definitions with their expressions."""
        raise NotImplementedError

    def read(self, text):
        parameters, definitions = {}, []
        for kind, name, what in self.statements(text):
            need(self.is_variable(name), name, "as a variable")
            if kind == "parameter":
                need(what not in parameters, what, "twice")
                parameters[what] = name
            else:
                definitions.append((name, self.expression(what)))
        need(definitions and definitions[-1][0] == self.result, "no", self.result)
        return Export(parameters, definitions[:-1], definitions[-1][1])

    def by_lines(self, text, parameter, definition, others=r"(?!)"):
        """Each line is one statement; what stands behind a parameter says what the scene calls it."""
        lines = [line for line in text.split("\n") if line]
        for i, line in enumerate(lines):
            if found := re.fullmatch(parameter, line):
                called = re.search(r"; (\S+) in the scene", line)
                yield "parameter", found["name"], called[1] if called else found["name"]
            elif found := re.fullmatch(definition, line):
                yield "definition", found["name"], found["text"]
            else:
                need(re.fullmatch(others, line), "line", i, line)


class Mathematica(System):
    name, result, brackets, words = r"[A-Za-z$][A-Za-z0-9$]*", "vStar", "[]", MATHEMATICA
    functions = {"Sqrt": "root", "Abs": "absolute"}

    def statements(self, text):
        need(text.startswith("(*"), "no comment in front")
        condition = r"(?P<name>\w+) > 0|-1 < (?P<nu>\w+) <= 1/2|Element\[(?P<complex>\w+), Complexes\]"
        text = re.sub(r"\A\(\*.*?\*\)\n", "", text, flags=re.S)
        text = re.sub(rf"(?<=&& )(?:{condition})(?=;)", lambda m: f"{m['name'] or m['nu'] or m['complex']}", text)
        return self.by_lines(text, r"\$Assumptions = \$Assumptions && (?P<name>\S+); \(\* [^*]* \*\)",
                             r"(?P<name>\S+) = (?P<text>[^;]+);?")


class Maple(System):
    words = MAPLE
    functions = {"sqrt": "root", "abs": "absolute"}

    def statements(self, text):
        text = re.sub(r"^#.*\n", "", text, flags=re.M)
        condition = r"(?P<name>\w+)(?: > 0| > -1, (?P=name) <= 1/2|, complex)"
        return self.by_lines(text, rf"assume\({condition}\):  # .*", r"(?P<name>\S+) := (?P<text>[^:;]+)[:;]")


class Maxima(System):
    token, imaginary = r"\d+|%i|'magnitude|[A-Za-z]\w*", "%i"
    words = ["if", "then", "do", "for", "step", "thru", "unless", "inf", "minf", "domain", "und", "labels", "values"]
    functions = {"sqrt": "root", "abs": "real", "'magnitude": "absolute"}

    def statements(self, text):
        need(text.startswith("/*"), "no comment in front")
        text = re.sub(r"\A/\*.*?\*/\n", "", text, flags=re.S)
        condition = r"assume\((?P<name>\w+) > 0\)|assume\((?P<nu>\w+) > -1, (?P=nu) <= 1/2\)|declare\((?P<complex>\w+), complex\)"
        text = re.sub(condition, lambda m: f"is({m['name'] or m['nu'] or m['complex']})", text)
        return self.by_lines(text, r"is\((?P<name>\w+)\)\$ /\* [^*]* \*/", r"(?P<name>\S+): (?P<text>[^$;]+)[$;]",
                             r"magnitude\(z\) := cabs\(z\)\$")


class C99(System):
    token, number, power, words = r"\d+\.\d+|\d+|[A-Za-z]\w*", r"\d+\.\d+", None, C
    functions = {"sqrt": "root", "fabs": "real", "cabs": "absolute", "pow": "pow"}

    def statements(self, text):
        text = re.sub(r"^//.*\n", "", text, flags=re.M)
        text = text.replace("return ", f"const double {self.result} = ")
        return self.by_lines(text, r"    double (?:complex )?(?P<name>\w+)[,)]  // .*",
                             r"  const double (?:complex )?(?P<name>\w+) = (?P<text>[^;]+);",
                             r"#include <(complex|math)\.h>|double v_star\(|\{|\}")


class SymPy(System):
    words = SYMPY
    operators = {ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b,
                 ast.Div: lambda a, b: a / b, ast.Pow: lambda a, b: a ** b}

    def statements(self, text):
        text = re.sub(r"^(#.*|from sympy import Abs, I, Rational, Symbol, sqrt)\n", "", text, flags=re.M)
        declared = r"(?P<name>\w+) = Symbol\('(?P=name)', (?:positive|real|complex)=True\)  # .*"
        return self.by_lines(text, declared, r"(?P<name>\w+) = (?P<text>[^#]+)")

    def expression(self, text):
        tree = ast.parse(text, mode="eval").body
        return lambda names: self.evaluated(tree, names)

    def evaluated(self, node, names):
        if isinstance(node, ast.BinOp):
            return self.operators[type(node.op)](self.evaluated(node.left, names), self.evaluated(node.right, names))
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -self.evaluated(node.operand, names)
        if isinstance(node, ast.Constant) and isinstance(node.value, int):
            return node.value if abs(node.value) < 2**31 else mp.mpf(node.value)
        if isinstance(node, ast.Name):
            need(node.id == "I" or node.id in names, node.id, "has no value")
            return mp.mpc(1j) if node.id == "I" else names[node.id]
        need(isinstance(node, ast.Call) and node.func.id in ("sqrt", "Abs", "Rational"), ast.dump(node)[:200])
        arguments = [self.evaluated(each, names) for each in node.args]
        if node.func.id == "Rational":
            return mp.mpf(arguments[0]) / arguments[1]
        return mp.sqrt(arguments[0]) if node.func.id == "sqrt" else abs(arguments[0])


class MathML:
    """From the presentation itself: what stands where decides."""

    SPACE = "{http://www.w3.org/1998/Math/MathML}"
    CHILDREN = {"mfrac": 2, "msup": 2, "msub": 2, "mover": 2, "msubsup": 3, "msqrt": 1, "mtd": 1}
    LEAVES = {"mi", "mn", "mo", "mtext"}

    def read(self, text):
        root = ET.fromstring(text.encode())
        self.check(root)
        tables = [table for table in root.iter(self.SPACE + "mtable")][1:]
        need(len(tables) == 2, len(tables), "tables")
        parameters = {}
        for symbol, scene, *_ in tables[1]:
            need(scene[0].text not in parameters, scene[0].text, "twice")
            parameters[scene[0].text] = self.key(symbol[0][0])
        equations = [(self.key(row[0][0][0] if row is not tables[0][-1] else row[0][0]), row[2][0]) for row in tables[0]]
        need(all(row[1][0].text == "=" for row in tables[0]), "no equation")
        definitions = [(name, lambda names, right=right: self.value(right, names)) for name, right in equations]
        return Export(parameters, definitions[:-1], definitions[-1][1])

    def check(self, element):
        tag = element.tag.removeprefix(self.SPACE)
        need(element.tag == self.SPACE + tag, element.tag)
        need(len(element) == self.CHILDREN.get(tag, len(element)), len(element), "children of", tag)
        need(tag in self.LEAVES or not (element.text or "").strip(), "text in", tag)
        need(tag not in self.LEAVES or (len(element) == 0 and element.text), "an empty", tag)
        need(tag in self.LEAVES or tag in self.CHILDREN or tag in ("math", "mrow", "mtable", "mtr"), tag)
        for child in element:
            self.check(child)

    def key(self, element):
        return re.sub(r"\s+$", "", ET.tostring(element, "unicode"))

    def value(self, element, names):
        if (key := self.key(element)) in names:
            return names[key]
        tag = element.tag.removeprefix(self.SPACE)
        if tag == "mn":
            return mp.mpf(element.text)
        if tag == "mi":
            need(element.text in ("i", "j"), key, "has no value")
            return mp.mpc(1j)
        if tag == "mfrac":
            return self.value(element[0], names) / self.value(element[1], names)
        if tag == "msqrt":
            return mp.sqrt(self.value(element[0], names))
        if tag == "msup":
            return self.value(element[0], names) ** int(element[1].text)
        need(tag == "mrow", key, "has no value")
        return self.row(list(element), names)

    def row(self, children, names):
        ends = [child.text if child.tag == self.SPACE + "mo" else None for child in (children[0], children[-1])]
        if ends == ["(", ")"]:
            return self.row(children[1:-1], names)
        if ends == ["|", "|"]:
            return abs(self.row(children[1:-1], names))
        total, factor, sign, slash = mp.mpf(0), None, 1, None
        for child in children:
            operator = child.text if child.tag == self.SPACE + "mo" else None
            if operator in ("+", "\N{MINUS SIGN}"):
                total, factor = total + sign * factor if factor is not None else total, None
                sign, slash = 1 if operator == "+" else -1, None
            elif operator is None:
                # a/b c may be read in two ways.
                need(slash != "used", child.tag, "behind what is behind a slash")
                value = self.value(child, names)
                factor = value if factor is None else factor / value if slash else factor * value
                slash = slash and "used"
            elif operator == "/":
                need(factor is not None and slash is None, operator)
                slash = "open"
            else:
                need(operator == "\N{INVISIBLE TIMES}" and factor is not None and slash is None, operator)
        need(factor is not None and slash != "open", "an operator at the end")
        return total + sign * factor


SYSTEMS = {"sympy": SymPy(), "mathematica": Mathematica(), "maple": Maple(), "maxima": Maxima(), "mathml": MathML(),
           "c": C99()}


def read(system, text):
    return SYSTEMS[system].read(text)
