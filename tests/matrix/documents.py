"""Printed derivations read back as equations (left, right): rows of one equation joined, ranges of an index written out,
MathML as the LaTeX that it shows."""

import re
import xml.etree.ElementTree as ET

DISPLAYS = {
    "latex": re.compile(r"\\\[ (.*?) \\\]|\\begin\{align\*\}\n(.*?)\n\\end\{align\*\}", re.DOTALL),
    "markdown": re.compile(r"\$\$(?!\\begin)(.*?)\$\$|\$\$\\begin\{aligned\}\n(.*?)\n\\end\{aligned\}\$\$", re.DOTALL),
}
RANGE = {"text": re.compile(r"  \((\w+) = (\d+)\.\.(\d+)\)$"),
         "latex": re.compile(r", \\quad (\w+) = (\d+), \\ldots, (\d+)$")}
INLINE, BLOCK = re.compile(r"<math><mrow>.*?</mrow></math>"), re.compile(r'<math display="block".*?</math>', re.DOTALL)
GREEK = {"α": "alpha", "β": "beta", "γ": "gamma", "η": "eta", "θ": "theta", "κ": "kappa", "λ": "lambda", "μ": "mu",
         "ν": "nu", "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau", "φ": "phi", "ω": "omega", "Δ": "Delta", "ζ": "zeta",
         "δ": "delta", "ε": "epsilon", "ξ": "xi", "χ": "chi", "ψ": "psi"}
SIGNS = {"−": " - ", "+": " + ", "\u2062": " ", "=": " = ", "*": "*"}


def inside(element):
    return "".join(latex_of(child) for child in element)


def latex_of(element):
    """Of an element of MathML."""
    text, children = element.text or "", [latex_of(child) for child in element]
    if element.tag == "mi":
        return f"\\{GREEK[text]} " if text in GREEK else text if len(text) == 1 else f"\\mathrm{{{text}}}"
    if element.tag in ("mn", "mo"):
        return SIGNS.get(text, text)
    if element.tag == "mfrac":
        return f"\\frac{{{children[0]}}}{{{children[1]}}}"
    if element.tag == "msqrt":
        return f"\\sqrt{{{''.join(children)}}}"
    if element.tag == "msub":
        return f"{children[0].strip()}_{{{children[1]}}}"
    if element.tag == "msup":
        return f"{{{children[0]}}}^{{{children[1]}}}" if "^" in children[0] else f"{children[0].strip()}^{{{children[1]}}}"
    if element.tag == "munderover":
        return f"\\sum_{{{children[1].replace(' ', '')}}}^{{{children[2]}}} "
    if element.tag == "mrow" and len(element) > 1 and element[0].tag == "mo" and element[0].text in ("|", "("):
        return f"\\left{children[0]}{''.join(children[1:-1])}\\right{children[-1]}"
    return "".join(children)


def rows_of_table(block):
    rows = []
    for left, sign, right in ET.fromstring(re.sub(r' class="[^"]*"', "", block)).iter("mtr"):
        if latex_of(sign).strip() == "∼":
            continue
        right, *tail = [latex_of(child) for child in right]
        span = re.search(r"(\w+) = (\d+),…,(\d+)", "".join(tail))
        right += f", \\quad {span[1]} = {span[2]}, \\ldots, {span[3]}" if span else ""
        rows.append(f"{latex_of(left)} & = {right}" if inside(left) else f"&\\quad {{}} {right}")
    return "\\begin{align*}\n" + " \\\\\n".join(rows) + "\n\\end{align*}"


def as_latex(page):
    """A page in HTML with its formulas as LaTeX."""
    page = BLOCK.sub(lambda found: rows_of_table(found[0]).replace("\\", "\\"), page)
    return INLINE.sub(lambda found: f"${latex_of(ET.fromstring(found[0])).strip()}$", page)


def rows(document, form):
    if form == "text":
        yield from (line[4:] for line in document.splitlines() if line.startswith("    "))
        return
    for lone, several in DISPLAYS[form].findall(document):
        yield from [lone] if lone else several.split(" \\\\\n")


def joined(document, form):
    """[left, right] of each equation."""
    found, open_row = [], False
    for row in rows(document, form):
        go_on = re.match(r"    |&\\quad \{\} ", row)
        parts = re.split(r" &? ?= ", row, maxsplit=1)
        if go_on:
            if open_row:
                found[-1][1] += " " + row[go_on.end():].strip()
            continue
        open_row = len(parts) == 2 and (form != "text" or " " not in parts[0])
        if open_row:
            found.append(parts)
    return found


def at_number(text, index, number):
    """k[j], k[j+2] and T_j, or k_{j}, k_{j+2} and T_{j}, at a number."""
    def shifted(found):
        return str(number + int(found[1] or 0))
    text = re.sub(rf"(?<=\[){index}([+-]\d+)?(?=\])", shifted, text)
    text = re.sub(rf"(?<=[{{,]){index}([+-]\d+)?(?=\}})", shifted, text)
    return re.sub(rf"\b([A-Z])_{index}\b", rf"\g<1>{number}", text)


def without_sums(text):
    """sum(k[j]*T_j, j = 1..10) written out."""
    while (at := text.find("sum(")) >= 0:
        end, depth = at + 4, 1
        while depth:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        body, span = text[at + 4:end - 1].rsplit(", ", 1)
        index, first, last = re.fullmatch(r"(\w+) = (\d+)\.\.(\d+)", span).groups()
        terms = " + ".join(f"({at_number(body, index, number)})" for number in range(int(first), int(last) + 1))
        text = f"{text[:at]}({terms}){text[end:]}"
    return text


def equations(document, form):
    """(left, right) of each formula of a printed derivation; HTML as as_latex() has it."""
    result = []
    for left, right in joined(document, form):
        span = RANGE["text" if form == "text" else "latex"].search(right)
        numbers = [None]
        if span:
            right, numbers = right[:span.start()], range(int(span[2]), int(span[3]) + 1)
        for number in numbers:
            pair = [left, right] if number is None else [at_number(each, span[1], number) for each in (left, right)]
            result.append((pair[0], without_sums(pair[1]) if form == "text" else pair[1]))
    return result
