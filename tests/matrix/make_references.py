#!/usr/bin/python3
"""Writes references.csv: what the program should say of each kind of scene, from nothing of the program.

The columns are kind, quantity, value, error. Linear quantities (v* by Eq. (24), its sensitivities and limits, stiffnesses,
amplitudes) come from nodal matrices in many digits, v* of a contact that is open for a while and all friction from time
steps of the nodal equations, an indenter's from its own sum over cells. `make_references.py [--linear] [KIND...]`
makes only these kinds again, with --linear nothing by time steps. All of them take half an hour on one core. Needs
numpy and mpmath.
"""

import csv
import sys
from itertools import combinations
from pathlib import Path

import mpmath as mp

from reference_friction import friction_rows
from reference_held import held_rows
from reference_kinds import KINDS, complex_height, is_found, read, receptance, wired, write_chain
from reference_networks import creep_viscosity, stiffness

TABLE = Path(__file__).parent / "references.csv"
LARGE = mp.mpf(10) ** 45
# A v* below is one that vanishes, one above the inverse grows without end: limits are off by some roots of LARGE.
SMALL = mp.mpf(10) ** -18
# Rows that reference_friction makes, and quantities that it needs and nobody else.
BY_STEPS = ("critical_velocity", "drive_velocity", "simulated_sensitivity", "velocity", "friction_ratio", "regime",
            "mean_normal_force", "energy_drive", "energy_friction", "design")
INNER = ("creep_over_mean_force", "normal_stiffness_at_rest")
mp.mp.dps = 150


def drive_stiffness(system, omega):
    """K_d - m omega^2; infinite for a rigid drive."""
    if system.drive is None:
        return mp.inf
    if isinstance(system.drive, str):
        r = receptance(system.drive, omega)
        return (mp.inf if r == 0 else 1 / r) - system.mass * omega**2
    try:
        return stiffness(system.drive, 1j * omega) - system.mass * omega**2
    except ZeroDivisionError:  # an absorber: infinite
        return mp.inf


def contact_stiffness(system, omega):
    normal = stiffness(system.normal, 1j * omega)
    return normal, system.ratio * normal if system.ratio else stiffness(system.tangential, 1j * omega)


def amplitudes(system, values):
    """Of the body and of the contact point, in m: both infinite in resonance."""
    omega, friction = values["omega"], values["mu0"] * complex_height(system, values)
    normal, tangential = contact_stiffness(system, omega)
    drive = drive_stiffness(system, omega)
    if drive == 0:
        return mp.inf, mp.inf
    body = -friction * normal / drive if abs(drive) < mp.inf else mp.mpf(0)
    return body, body - friction * normal / tangential


def formula(name, values, **changes):
    system = wired(name, values)
    vars(system).update(changes)
    return values["omega"] * abs(amplitudes(system, values)[1])


def scaled(values, names, factor):
    return {key: ([x * factor for x in value] if isinstance(value, list) else value * factor) if key in names else value
            for key, value in values.items()}


def entries(values):
    """Every parameter by the name that a formula gives it, with what changes it by a factor."""
    for key, value in values.items():
        if is_found(key, values):
            continue
        if not isinstance(value, list):
            yield key, lambda factor, key=key: scaled(values, {key}, factor)
        else:
            for i in range(len(value)):
                yield f"{key}[{i + 1}]", lambda factor, key=key, i=i: values | {
                    key: [x * factor if j == i else x for j, x in enumerate(values[key])]}


def sensitivities(name, values):
    at = formula(name, values)
    step = mp.mpf(10) ** -30
    for parameter, change in entries(values):
        if at not in (0, mp.inf):
            ratio = formula(name, change(1 + step)) / formula(name, change(1 - step))
            slope = mp.log(ratio) / mp.log((1 + step) / (1 - step))
            yield f"sensitivity:{parameter}", slope if abs(slope) > mp.mpf(10) ** -60 else 0


def limit_name(names, target, rigid=False):
    return "limit:" + "+".join(sorted(names)) + f"={target}" + (" rigid" if rigid else "")


def dampers(system, values):
    """Names of all elements of dampers, by what the networks do with them."""
    found = []
    for key in values:
        marked = wired_marked(system.name, values, key)
        if any(what == "c" for what, _ in marked) and key not in ("k",):
            found.append(key)
    return found


def wired_marked(name, values, key):
    """Edges that depend on one element."""
    one, other = (edges_of(wired(name, each)) for each in (values, scaled(values, {key}, 2)))
    return [(a[0], a[1]) for a, b in zip(one, other) if a[1] != b[1]]


def edges_of(system):
    networks = [system.normal, None if system.ratio else system.tangential, system.drive, system.mount]
    return [edge for network in networks if callable(network) for edge in network("a", "b")]


def limits(name, values):
    """v* where elements vanish or grow without end, one by one, all dampers, and each with a rigid drive."""
    system = wired(name, values)
    system.name = name
    elements = [key for key in values if key not in ("mu0", "omega", "du_z", "u_z0", "W", "U")]
    cases = [({key}, target) for key in elements for target in ("0", "inf")]
    all_dampers = set(dampers(system, values))
    cases += [(set(some), "0") for count in range(2, len(all_dampers) + 1) for some in combinations(sorted(all_dampers), count)]
    for names, target in cases:
        changed = scaled(values, names, 1 / LARGE if target == "0" else LARGE)
        for rigid in [False, True] if system.drive is not None else [False]:
            try:
                at = formula(name, changed, **({"drive": None} if rigid else {}))
            except ZeroDivisionError:
                continue
            yield limit_name(names, target, rigid), mp.mpf(0) if at < SMALL else mp.inf if at > 1 / SMALL else at
    if system.drive is not None:
        yield "limit:rigid", formula(name, values, drive=None)
    if "kt" in values and "kn" in values and not system.ratio:
        yield "limit:isotropic", formula(name, values, ratio=values["kt"] / values["kn"])
        yield "limit:isotropic rigid", formula(name, values, ratio=values["kt"] / values["kn"], drive=None)


def asymptotes(name, values):
    """v* ~ coefficient omega^power; nothing where it is known at some frequencies alone."""
    system = wired(name, values)
    if isinstance(system.drive, str) or any(what == "loss" for what, *_ in edges_of(system)):
        return
    for target, omega in (("0", 1 / LARGE), ("infinity", LARGE)):
        one, two = (formula(name, values | {"omega": w}) for w in (omega, 2 * omega))
        power = mp.nint(mp.log(two / one, 2))
        yield f"asymptote:omega -> {target}:power", power
        yield f"asymptote:omega -> {target}:coefficient", one / omega**power


def stiffnesses(name, values):
    system, omega = wired(name, values), values["omega"]
    normal, tangential = contact_stiffness(system, omega)
    parts = {"normal": normal, "tangential": tangential}
    if system.drive is not None:
        parts["drive"] = drive_stiffness(SimpleDrive(system), omega)
    for what, k in parts.items():
        if abs(k) < mp.inf:
            yield f"{what}_stiffness:storage", mp.re(k)
            yield f"{what}_stiffness:loss", mp.im(k)
    at_rest = equilibrium(system)
    yield "normal_stiffness_at_rest", at_rest
    left = mp.mpf(1)
    if system.mount is not None:
        mount = stiffness(system.mount, 1j * omega)
        yield "mount_stiffness:storage", mp.re(mount)
        yield "mount_stiffness:loss", mp.im(mount)
        response = mount / (mount + normal - system.moving * omega**2)
        yield "normal_oscillation:amplitude", values["U"] * abs(response)
        yield "normal_oscillation:phase", mp.arg(response)
        left = abs(response)
    yield "admissible_amplitude", mean_force(system, values) / abs(normal) / left
    body, point = amplitudes(system, values)
    for what, amplitude in (("body", body), ("contact_point", point)):
        if abs(amplitude) < mp.inf and (what != "body" or system.drive is not None):
            yield f"{what}_oscillation:amplitude", abs(amplitude)
            if amplitude:
                yield f"{what}_oscillation:phase", mp.arg(amplitude)


def mean_force(system, values):
    """K_n(0) u_z0, which is the load; below an indenter, of modulus E0, a load is that of all cells."""
    return values["W"] if "W" in values and "E0" not in values else values["u_z0"] * equilibrium(system)


class SimpleDrive:
    """The drive without the body's mass."""

    def __init__(self, system):
        self.drive, self.mass = system.drive, mp.mpf(0)


def equilibrium(system):
    """K_n(0): 0 where it falls with s."""
    if system.at_rest is not None:  # beside a table
        return system.at_rest
    slow = mp.mpf(10) ** -60
    at = mp.re(stiffness(system.normal, slow))
    return at if stiffness(system.normal, 2 * slow) / at < mp.mpf(3) / 2 else mp.mpf(0)


def given(values, system):
    """The numbers of the scene, as formulas and generated code are given them."""
    for key, value in values.items():
        if is_found(key, values):
            continue
        if isinstance(value, list):
            yield from ((f"value:{key}[{i + 1}]", x) for i, x in enumerate(value))
        else:
            yield f"value:{key}", value
    if isinstance(system.drive, str):
        yield "value:R_d real", mp.re(receptance(system.drive, values["omega"]))
        yield "value:R_d imaginary", mp.im(receptance(system.drive, values["omega"]))


def linear_rows(name, values, text):
    system = wired(name, values)
    yield from given(values, system)
    v = formula(name, values)
    yield "formula", v
    mean = mean_force(system, values)
    force = values["du_z"] * abs(contact_stiffness(system, values["omega"])[0])
    yield "closed", int(force < mean and ("u_z0" not in values or values["du_z"] < values["u_z0"]))
    yield "loaded", int(mean > 0)
    if "W" in values and "u_z0" in values:
        yield "indentation", values["u_z0"]
    if "W" in values and not equilibrium(system):  # all of it through one damper
        yield "sinking_velocity", values["W"] / creep_viscosity(system.normal)
    creep = mp.mpf(0)
    networks = [system.tangential if not system.ratio else system.normal]
    if callable(system.drive):
        networks.append(system.drive)
    for network, factor in zip(networks, (system.ratio or 1, 1)):
        creep += 1 / creep_viscosity(network) / factor
    yield "creep_over_mean_force", values["mu0"] * creep
    if text.get("contact", {}).get("separation") is None and "indenter" not in text:
        yield "closed_drive_velocity", v + values["mu0"] * mean * creep
    for rows in (sensitivities, limits, asymptotes, stiffnesses):
        yield from rows(name, values)


def rows_of(name, before, friction):
    """All rows, with those of friction made again or taken from before."""
    values, text = read(name)
    if "indenter" in text and "drive" in text:
        return held_table(name, held_rows(values, text))
    linear = dict(linear_rows(name, values, text))
    # A double has 55 digits at most, of the size of these values.
    rows = [[name, quantity, mp.nstr(value, 60 if quantity.startswith("value:") else 25), 0] for quantity, value in linear.items() if quantity not in INNER]
    if not friction:
        return rows + [row for row in before if row[1].split(":")[0] in BY_STEPS]
    for quantity, value, error in friction_rows(name, values, text, linear):
        value = value if isinstance(value, str) else repr(float(value))
        rows.append([name, quantity, value, f"{float(error):.1e}" if error else 0])
    return rows


def held_table(name, rows):
    """Of an indenter on a drive that gives, which has no linear quantities."""
    return [[name, quantity, value if isinstance(value, str) else mp.nstr(mp.mpf(value), 60 if quantity.startswith("value:") else 25),
             f"{float(error):.1e}" if error else 0] for quantity, value, error in rows]


def main():
    kept = {}
    if TABLE.exists():
        with TABLE.open() as file:
            for row in csv.reader(file):
                kept.setdefault(row[0], []).append(row)
    friction = "--linear" not in sys.argv
    wanted = [name for name in sys.argv[1:] if name != "--linear"] or sorted(KINDS)
    if "measured_drive" in wanted:
        write_chain()
    for name in wanted:
        kept[name] = rows_of(name, kept.get(name, []), friction)
        print(name, len(kept[name]), flush=True)
    with TABLE.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kind", "quantity", "value", "error"])
        writer.writerows(row for each in sorted(KINDS) for row in kept.get(each, []))


if __name__ == "__main__":
    main()
