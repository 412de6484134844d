"""Networks as nodal matrices, for make_references.py: nothing of the program is used.

A network is a list of edges (what, value, from, to), what one of "k", "c", "m" (spring, damper, mass to ground) or
"loss" (of a lossy spring, while it oscillates).
`spring`, `damper`, `lossy`, `mass`, `parallel`, `series` and `graph` make functions that lay edges between two nodes.
"""

from itertools import count

import mpmath as mp

FRESH = count()


def spring(value):
    return lambda a, b: [("k", value, a, b)]


def damper(value):
    return lambda a, b: [("c", value, a, b)]


def lossy(value, factor):
    return lambda a, b: [("k", value, a, b), ("loss", value * factor, a, b)]


def mass(value):
    return lambda a, b: [("m", value, a, b)]


def parallel(*parts):
    return lambda a, b: [edge for part in parts for edge in part(a, b)]


def series(*parts):
    def lay(a, b):
        nodes = [a, *(f"inner{next(FRESH)}" for _ in parts[1:]), b]
        return [edge for part, left, right in zip(parts, nodes, nodes[1:]) for edge in part(left, right)]
    return lay


def graph(*edges):
    """Of (network, from, to) with the ends "a" and "b"; "ground" is the far end, which stands still."""
    def lay(a, b):
        fresh = next(FRESH)
        place = {"a": a, "b": b, "ground": b}
        name = lambda node: place.get(node, f"inner{fresh}.{node}")
        return [edge for part, left, right in edges for edge in part(name(left), name(right))]
    return lay


def maxwell(k, c):
    return series(spring(k), damper(c))


def stiffness(network, s):
    """Force at "a" for a unit deformation from "a" to "b", where "b" stands still and inner nodes are free."""
    edges = [edge for edge in network("a", "b") if edge[1] != 0]
    nodes = []
    for _, _, *ends in edges:
        nodes += [end for end in ends if end not in nodes and end != "b"]
    held = reaching(edges)
    nodes = [node for node in nodes if node in held and node != "a"]
    place = {node: i for i, node in enumerate(["a", *nodes])}
    matrix = mp.zeros(len(place))
    for what, value, left, right in edges:
        value = value * {"k": 1, "c": s, "m": s * s, "loss": 1j if mp.im(s) else 0}[what]
        for one, other in ((left, right), (right, left)):
            if one in place:
                matrix[place[one], place[one]] += value
                if other in place:
                    matrix[place[one], place[other]] -= value
    if not nodes:
        return matrix[0, 0]
    unit = mp.zeros(len(place), 1)
    unit[0] = 1
    return 1 / mp.lu_solve(matrix, unit)[0]


def reaching(edges):
    """Nodes that edges connect to an end: what hangs nowhere carries nothing."""
    held = {"a", "b"}
    while True:
        more = {end for _, _, *ends in edges if held & set(ends) for end in ends} - held
        if not more:
            return held
        held |= more


def creep_viscosity(network):
    """eta in K(s) ~ eta s for slow motion, infinite where the network carries a load at rest."""
    slow = mp.mpf(10) ** -(mp.mp.dps // 3)
    at_rest, later = stiffness(network, slow), stiffness(network, 2 * slow)
    return later / (2 * slow) if later / at_rest > mp.mpf(3) / 2 else mp.inf
