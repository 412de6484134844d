"""The columns of `generate`: evaluators of all kinds, in each language compiled together and run once.

Every driver prints for each kind v*, its bound, v* of the fast grade, and the partial derivatives in the order of Parameters.
"""

import json
import re
import subprocess
import sys

import mpmath as mp

from cells import KINDS, REFERENCES, U, run, scene

SUFFIX = {"c++": "hpp", "c99": "h", "python": "py", "javascript": "mjs", "cuda": "cuh"}
QUANTITIES = {"normal_stiffness": ("storage", "loss"), "tangential_stiffness": ("storage", "loss"),
              "drive_stiffness": ("storage", "loss"), "body_oscillation": ("amplitude", "phase"),
              "contact_point_oscillation": ("amplitude", "phase"), "admissible_amplitude": ()}


def members(header, struct="Parameters"):
    """[(name, length or 0)] of a struct of a C++ header."""
    body = re.search(rf"struct {struct} \{{(.*?)\}};", header, re.S)
    if not body:
        return []
    found = []
    for line in body[1].splitlines():
        declared = re.match(r"\s*(?:double|std::array<double, (\d+)>) ([\w, ]+);", line)
        if declared:
            found += [(name, int(declared[1] or 0)) for name in declared[2].split(", ")]
    return found


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
        rows = DRIVERS[language](folder, layouts)
        for (kind, layout), row in zip(layouts.items(), rows, strict=True):
            with test.subTest(kind=kind, column=f"generate/{language}"):
                check_row(test, kind, layout, [float(x) for x in row.split()])
    check_more(test, folder)


def check_row(test, kind, layout, row):
    references = REFERENCES[kind]
    value, bound, fast, fast_bound, *partial = row
    test.near_formula(value, kind, 2)
    reference = references("formula")
    if reference == mp.inf:
        return
    test.assertTrue(bound <= 2 * U or reference == 0 or kind.startswith(("near_", "drive_absorber")), bound)
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


def ran(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        raise AssertionError(done.stderr[:3000] + done.stdout[:500])
    return done.stdout.splitlines()


def c_like(folder, layouts, header, call, begin):
    """One program with the headers of all kinds."""
    blocks = []
    for kind, layout in layouts.items():
        numbers = flat(kind, layout)
        count = len(numbers)
        block = [call["parameters"].format(n=f"x_{kind}")]
        block.append(f"const double given[] = {{{', '.join(numbers)}}}; memcpy(&p, given, sizeof p); double d[{count}];")
        block.append(call["run"].format(n=f"x_{kind}"))
        block.append('printf("%a %a %a %a", a.value, a.relative_error_bound, f.value, f.relative_error_bound);')
        block.append(f'for (int i = 0; i < {count}; ++i) printf(" %a", d[i]); printf("\\n");')
        blocks.append("{ " + "\n".join(block) + " }")
    includes = "".join(f'#include "x_{kind}.{header}"\n' for kind in layouts)
    return f"{begin}{includes}int main(void) {{\n" + "\n".join(blocks) + "\nreturn 0; }\n"


CPP = {"parameters": "{n}::Parameters p;",
       "run": "const {n}::Certified a = {n}::critical_velocity_certified(p), f = {n}::fast::critical_velocity_certified(p); "
              "const {n}::Gradient g = {n}::critical_velocity_gradient(p); memcpy(d, &g.partial, sizeof d);"}
C99 = {"parameters": "{n}_Parameters p;",
       "run": "const {n}_Certified a = {n}_critical_velocity_certified(&p), f = {n}_fast_critical_velocity_certified(&p); "
              "const {n}_Gradient g = {n}_critical_velocity_gradient(&p); memcpy(d, &g.partial, sizeof d);"}


def compiled(compiler, folder, source, text):
    (folder / source).write_text(text)
    return hexadecimal(ran([*compiler, "-O0", "-o", "program", source, *(["-lm"] if source.endswith(".c") else [])], folder)
                       or ran(["./program"], folder))


def hexadecimal(lines):
    return [" ".join(repr(float.fromhex(x)) for x in line.split()) for line in lines]


def cpp(folder, layouts):
    text = c_like(folder, layouts, "hpp", CPP, "#include <cstdio>\n#include <cstring>\nusing namespace std;\n")
    return compiled(["g++", "-std=c++20"], folder, "all.cpp", text)


def c99(folder, layouts):
    text = c_like(folder, layouts, "h", C99, "#include <stdio.h>\n#include <string.h>\n")
    return compiled(["gcc", "-std=c99"], folder, "all.c", text)


def cuda(folder, layouts):
    """Its host code; device code runs in tests/emit where there is a device."""
    text = c_like(folder, layouts, "cuh", CPP, "#include <cstdio>\n#include <cstring>\nusing namespace std;\n")
    return compiled(["g++", "-std=c++17", "-x", "c++"], folder, "all.cu", text)


def given(layouts):
    """{kind: [[name, value or array], ...]} as JSON."""
    return json.dumps({kind: [[name, [float(x) for x in values(kind, name, n)] if n else float(values(kind, name, 0)[0])]
                              for name, n in layout] for kind, layout in layouts.items()})


def python(folder, layouts):
    (folder / "all.py").write_text(f"""from importlib import import_module
for kind, given in {given(layouts)}.items():
    module = import_module("x_" + kind)
    p = module.Parameters(**dict(given))
    a, f = module.critical_velocity_certified(p), module.fast_critical_velocity_certified(p)
    partial = module.critical_velocity_gradient(p).partial
    flat = [x for name, v in given for x in (getattr(partial, name) if isinstance(v, list) else [getattr(partial, name)])]
    print(*map(float, (*a, *f, *flat)))
""")
    return ran([sys.executable, "-B", "all.py"], folder)


def javascript(folder, layouts):
    (folder / "all.mjs").write_text(f"""const all = {given(layouts)};
for (const [kind, given] of Object.entries(all)) {{
  const m = await import(`./x_${{kind}}.mjs`), p = Object.fromEntries(given);
  const a = m.critical_velocity_certified(p), f = m.fast_critical_velocity_certified(p);
  const g = m.critical_velocity_gradient(p).partial;
  console.log([a.value, a.relative_error_bound, f.value, f.relative_error_bound,
    ...given.flatMap(([name]) => g[name])].join(" ").replaceAll("Infinity", "inf").replaceAll("NaN", "nan"));
}}
""")
    return ran(["node", "all.mjs"], folder)


DRIVERS = {"c++": cpp, "c99": c99, "python": python, "javascript": javascript, "cuda": cuda}


def check_more(test, folder):
    """What C++ alone has: quantities beside v*, and numbers folded in."""
    includes, lines, expected = [], [], []
    for kind in KINDS:
        with test.subTest(kind=kind, column="generate/fix"):
            if generated(test, kind, "generate/fix", folder, "--name", f"f_{kind}", "--fix", "all"):
                layout = members((folder / f"f_{kind}.hpp").read_text())
                # Parameters of every call; of a scene without numbers there is nothing to fold in.
                if kind != "symbols":
                    test.assertEqual([name for name, _ in layout], ["mu0", "omega", "du_z"])
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
    rows = compiled(["g++", "-std=c++20"], folder, "more.cpp", text + "int main() {\n" + "\n".join(lines) + "\n}\n")
    for (kind, column, quantity), row in zip(expected, rows, strict=True):
        with test.subTest(kind=kind, column=column, quantity=quantity):
            check_quantity(test, kind, quantity, float(row))


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
        test.assertTrue(quantity.endswith("phase") or found == float("inf"), quantity)
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
