"""K(s) of a network in symbols by SymPy or Maxima, timed; the last line says how long it took.

    stiffness.py NETWORK.json composed|cancel|field|newdet
"""

import json
import subprocess
import sys
import time

from networks import composed

# Short ones are repeated, since Maxima's clock ticks in milliseconds.
NEWDET = """a: {}$
b: {}$
measured(n) := block([t: elapsed_real_time()], for i thru n do (newdet(a), newdet(b)), (elapsed_real_time() - t)/n)$
t: measured(1)$
if t < 0.005 then t: measured(1000)$
print("seconds", float(t))$
"""


def measured(run):
    """The median of as many runs as fit into a tenth of a second. SymPy remembers expressions, and is made to forget."""
    from sympy.core.cache import clear_cache as forget
    seconds, begin = [], time.perf_counter()
    while not seconds or time.perf_counter() - begin < 0.1:
        forget()
        start = time.perf_counter()
        run()
        seconds.append(time.perf_counter() - start)
    return sorted(seconds)[len(seconds) // 2]


def stiffness(steps, x):
    def element(kind, name, tau=None):
        if kind == "maxwell":
            return x[name] * x[tau] * x["s"] / (1 + x[tau] * x["s"])
        return x[name] * x["s"] if kind == "damper" else x[name]

    return composed(steps, element)


def sympy_seconds(network, method):
    import sympy
    from sympy.polys.fields import field
    sys.setrecursionlimit(100000)
    names = network["names"]
    symbols = field(names, sympy.ZZ)[1:] if method == "field" else sympy.symbols(names, positive=True)
    x = dict(zip(names, symbols))
    last = sympy.cancel if method == "cancel" else lambda value: value
    return measured(lambda: last(stiffness(network["steps"], x)))


def newdet(network):
    """Two determinants of the nodal matrix: terminal 1 is held, terminal 0 comes last."""
    nodes = network["nodes"]
    k = [["0"] * nodes for _ in range(nodes)]
    for one, other, stiffness in network["edges"]:
        for i, j in ((one, other), (other, one)):
            k[i][i] += "+" + stiffness
            k[i][j] += "-" + stiffness

    def matrix(kept):
        rows = ("[" + ",".join(k[i][j] for j in kept) + "]" for i in kept)
        return f"matrix({','.join(rows)})" if kept else "matrix([1])"

    inner = list(range(2, nodes))
    script = sys.argv[1] + ".mac"
    with open(script, "w") as file:
        file.write(NEWDET.format(matrix(inner + [0]), matrix(inner)))
    said = subprocess.run(["/usr/bin/maxima", "--very-quiet", "--batch", script], check=True, capture_output=True, text=True)
    return float(said.stdout.rpartition("seconds ")[2].split()[0])


def main():
    network, method = json.load(open(sys.argv[1])), sys.argv[2]
    print("seconds", newdet(network) if method == "newdet" else sympy_seconds(network, method))


if __name__ == "__main__":
    main()
