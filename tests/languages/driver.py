"""As driver.c."""
import sys
from importlib import import_module

import numpy as np

LIBRARIES = [
    #: each
    ("LIBRARY", MEMBERS, "OMEGA"),
    #: end
]


def parameters(module, layout, x):
    members, at = {}, 0
    for name, length in layout:
        members[name] = x[at : at + length] if length else x[at]
        at += length or 1
    return module.Parameters(**members)


def flat(layout, p):
    return [x for name, n in layout for x in (getattr(p, name) if n else [getattr(p, name)])]


def answers(library, rows):
    """All rows at once, and batches one by one."""
    name, layout, omega = LIBRARIES[library]
    module = import_module(name)
    p = parameters(module, layout, np.array(rows).T)
    batches = [[], []]
    for row in rows:
        one = parameters(module, layout, row)
        at = [getattr(one, omega)]
        batches[0].append(module.critical_velocity(one, omega=at)[0])
        batches[1].append(module.fast_critical_velocity(one, omega=at)[0])
    columns = [*module.critical_velocity_certified(p), *module.fast_critical_velocity_certified(p)]
    columns += [module.critical_velocity(p), module.fast_critical_velocity(p), *batches]
    if WITH_GRADIENTS:
        for g in module.critical_velocity_gradient(p), module.fast_critical_velocity_gradient(p):
            columns += [g.value, *flat(layout, g.partial)]
    return np.array(columns).T


lines = [line.split() for line in sys.stdin]
found = [None] * len(lines)
for library in range(len(LIBRARIES)):
    places = [i for i, line in enumerate(lines) if int(line[0]) == library]
    rows = [[float(x) for x in lines[i][1:]] for i in places]
    if rows:
        for i, row in zip(places, answers(library, rows)):
            found[i] = row
for row in found:
    print(*map(float, row))
