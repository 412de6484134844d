"""The columns of `generate`: evaluators of all kinds, in each language compiled together and run once."""

import math
import re
import sys
from pathlib import Path

import mpmath as mp

from cells import KINDS, REFERENCES, U, run, scene

sys.path.insert(0, str(Path(__file__).parents[1] / "languages"))
from drivers import LANGUAGES, PLAIN_ANSWERS, answers, members, ran
QUANTITIES = {"normal_stiffness": ("storage", "loss"), "tangential_stiffness": ("storage", "loss"),
              "drive_stiffness": ("storage", "loss"), "mount_stiffness": ("storage", "loss"),
              "normal_oscillation": ("amplitude", "phase"), "body_oscillation": ("amplitude", "phase"),
              "contact_point_oscillation": ("amplitude", "phase"), "admissible_amplitude": ()}


def values(kind, name, length):
    references = REFERENCES[kind]
    text = lambda each: repr(float(references(f"value:{each}")))
    return [text(f"{name}[{i + 1}]") for i in range(length)] if length else [text(name)]


def flat(kind, layout):
    return [x for name, length in layout for x in values(kind, name, length)]


def entries(layout):
    return [each for name, length in layout for each in ([f"{name}[{i + 1}]" for i in range(length)] if length else [name])]


def generated(test, kind, column, folder, *options):
    """Whether there is code; then it is called KIND."""
    ran = run("generate", scene(kind), "--out", folder, *options)
    return test.answered(kind, column, ran)


def standing_for(layouts, ending, folder):
    """For each kind the first one of the same code: those that differ in numbers alone are compiled once."""
    first = {}

    def code(kind):
        text = (folder / f"x_{kind}.{ending}").read_text().replace(f"x_{kind}", "x")
        return re.sub(r"//.*|(?<=_x_HPP )0x\w+", "", text)  # the last tells one run's files from another's

    return {kind: first.setdefault(code(kind), kind) for kind in layouts}


def check(test, languages, folder):
    layouts = {}
    for kind in KINDS:
        with test.subTest(kind=kind, column="generate/c++"):
            if generated(test, kind, "generate/c++", folder, "--name", f"x_{kind}"):
                layouts[kind] = members((folder / f"x_{kind}.hpp").read_text())
    for language in languages[1:]:
        for kind in KINDS:
            with test.subTest(kind=kind, column=f"generate/{language}"):
                if generated(test, kind, f"generate/{language}", folder, "--name", f"x_{kind}", "--language", language):
                    test.assertIn(kind, layouts)
    for language in languages:
        standing = standing_for(layouts, LANGUAGES[language]["file"], folder)
        compiled = [kind for kind, first in standing.items() if kind == first]
        libraries = [(f"x_{kind}", layouts[kind]) for kind in compiled]
        numbers = [(compiled.index(standing[kind]), list(map(float, flat(kind, layout)))) for kind, layout in layouts.items()]
        rows = answers(language, folder, libraries, numbers, gradients=True)
        for (kind, layout), row in zip(layouts.items(), rows, strict=True):
            with test.subTest(kind=kind, column=f"generate/{language}"):
                check_row(test, kind, layout, row)
    check_more(test, folder)


def check_row(test, kind, layout, row):
    references = REFERENCES[kind]
    value, bound, fast, fast_bound = row[:4]
    count = len(entries(layout))
    partial = row[PLAIN_ANSWERS + 1:PLAIN_ANSWERS + 1 + count]
    test.assertEqual(len(row), PLAIN_ANSWERS + 2 * (1 + count))
    test.near_formula(value, kind, 2)
    reference = references("formula")
    if reference == mp.inf:
        return
    test.assertTrue(bound <= 2 * U or reference == 0 or kind.startswith("near_"), bound)
    if bound < mp.inf:
        test.near(value, reference, abs(reference) * (bound + U), "bound")
    if fast_bound < mp.inf:
        test.near(fast, reference, abs(reference) * (fast_bound + U), "fast")
    for name, slope in zip(entries(layout), partial, strict=True):
        if f"sensitivity:{name}" in references and references(f"value:{name}") != 0:
            expected = references(f"sensitivity:{name}")
            scale = references(f"value:{name}") / reference
            # Each step of the backward run rounds once; near resonance the slope is that much larger.
            test.near(slope * scale, expected, 1e-12 * max(1, abs(expected)), f"d/d{name}")


def check_more(test, folder):
    """What C++ alone has: quantities beside v*, and numbers folded in."""
    includes, lines, expected = [], [], []
    for kind in KINDS:
        with test.subTest(kind=kind, column="generate/fix"):
            if generated(test, kind, "generate/fix", folder, "--name", f"f_{kind}", "--fix", "all"):
                layout = members((folder / f"f_{kind}.hpp").read_text())
                # Parameters of every call; of a scene without numbers there is nothing to fold in.
                if kind != "symbols":
                    test.assertEqual([name for name, _ in layout], ["mu0", "omega", "U" if "value:U" in REFERENCES[kind] else "du_z"])
                includes.append(f"f_{kind}.hpp")
                numbers = ", ".join(flat(kind, layout))
                lines.append(f'std::printf("%a\\n", f_{kind}::critical_velocity({{{numbers}}}));')
                expected.append((kind, "generate/fix", "formula"))
        with test.subTest(kind=kind, column="generate/quantities"):
            if generated(test, kind, "generate/quantities", folder, "--name", f"q_{kind}", "--quantities"):
                header = (folder / f"q_{kind}_quantities.hpp").read_text()
                includes.append(f"q_{kind}_quantities.hpp")
                lines.append(quantity_lines(kind, header, expected))
    text = "#include <cstdio>\n" + "".join(f'#include "{each}"\n' for each in includes)
    (folder / "more.cpp").write_text(text + "int main() {\n" + "\n".join(lines) + "\n}\n")
    ran(["g++", "-std=c++20", "-O0", "-o", "more", "more.cpp"], folder)
    rows = list(map(float.fromhex, ran(["./more"], folder).split()))
    for (kind, column, quantity), row in zip(expected, rows, strict=True):
        with test.subTest(kind=kind, column=column, quantity=quantity):
            check_quantity(test, kind, quantity, row)


def quantity_lines(kind, header, expected):
    layout = members(header, "QuantityParameters")
    sets = " ".join(f".{name} = {{{', '.join(values(kind, name, length))}}}," if length else
                    f".{name} = {values(kind, name, 0)[0]}," for name, length in layout)
    block = [f"const q_{kind}::QuantityParameters p{{{sets}}};"]
    for function, parts in QUANTITIES.items():
        if f" {function}(" not in header:
            continue
        for part in parts or [""]:
            block.append(f'std::printf("%a\\n", q_{kind}::{function}(p){"." + part if part else ""});')
            expected.append((kind, "generate/quantities", f"{function}:{part}".rstrip(":")))
    return "{ " + "\n".join(block) + " }"


def check_quantity(test, kind, quantity, found):
    references = REFERENCES[kind]
    if quantity == "formula":
        test.near_formula(found, kind, 2)
        return
    if quantity not in references:  # in resonance: infinite, with any phase
        # Of an infinite stiffness neither part is a number, but that an undamped drive has no loss.
        no_number = math.isnan(found) or (found == 0 and quantity.endswith("loss"))
        infinite = no_number if quantity.startswith("drive_stiffness") else found == float("inf")
        test.assertTrue(quantity.endswith("phase") or infinite, quantity)
        return
    reference = references(quantity)
    scale = abs(reference)
    if quantity.endswith(("storage", "loss")):
        function = quantity.split(":")[0]
        scale = abs(mp.mpc(references(f"{function}:storage"), references(f"{function}:loss")))
    if quantity.endswith("phase"):
        # -pi and pi are one phase.
        reference = min((reference + turn * 2 * mp.pi for turn in (-1, 0, 1)), key=lambda each: abs(each - found))
        scale = mp.mpf(1)
    # Some roundings of the absolute value, more near (anti)resonance: the kinds have at most a hundredfold loss.
    test.near(found, reference, scale * 1e-13, quantity)
