"""The kinds of scenes, wired a second time: each network of kinds/*.toml by hand, its numbers from the file.

`wired(NAME, VALUES)` gives the networks that the file's text stands for, in the terms of reference_networks.
"""

import csv
import tomllib
from pathlib import Path
from types import SimpleNamespace

import mpmath as mp

from reference_networks import damper, graph, lossy, mass, maxwell, parallel, series, spring, stiffness

FOLDER = Path(__file__).parent / "kinds"


def kelvin(k, c):
    return parallel(spring(k), damper(c))


def zener(k, k1, c1):
    return parallel(spring(k), maxwell(k1, c1))


def prony(v):
    return parallel(spring(v["k0"]), *(maxwell(k, k * tau) for k, tau in zip(v["k"], v["tau"])))


def mindlin(nu):
    return 2 * (1 - mp.mpf(nu)) / (2 - mp.mpf(nu))


def bridge(v, *more):
    return graph((spring(v["k1"]), "a", "1"), (damper(v["c1"]), "a", "2"), (spring(v["k2"]), "1", "2"),
                 (damper(v["c2"]), "1", "b"), (spring(v["k3"]), "2", "b"), *more)


def frame(v):
    return graph((spring(v["k1"]), "a", "1"), (mass(v["m1"]), "1", "ground"), (kelvin(v["k2"], v["c2"]), "1", "b"),
                 (spring(v["k3"]), "a", "b"))


def rows_of_table(table, *columns):
    with (FOLDER / table).open() as file:
        return [[mp.mpf(row[key]) for key in columns] for row in csv.DictReader(file)]


def between_rows(table, omega, *columns):
    """Complex numbers, linear between two rows of a table."""
    rows = rows_of_table(table, *columns)
    for (left, *low), (right, *high) in zip(rows, rows[1:]):
        if left <= omega <= right:
            part = (omega - left) / (right - left)
            return mp.mpc(*(a + part * (b - a) for a, b in zip(low, high)))
    raise ValueError(omega)


# Tables of a contact by the end of the names of their numbers, K' and K''/K'.
PADS = {"n": "pad.csv", "t": "pad_tangential.csv"}


def measured_numbers(omega):
    """k_n, eta_n, k_t and eta_t."""
    found = {}
    for end, table in PADS.items():
        k = between_rows(table, omega, "angular_frequency [rad/s]", "storage [N/m]", "loss [N/m]")
        found |= {f"k_{end}": mp.re(k), f"eta_{end}": mp.im(k) / mp.re(k)}
    return found


def measured(v, end):
    """A number changes by its factor, and with omega as its table does."""
    here, there = measured_numbers(mp.mpf(10) ** 5), measured_numbers(v["omega"])
    k, eta = (v[name] * there[name] / here[name] for name in (f"k_{end}", f"eta_{end}"))
    return lossy(k, eta)


# normal, tangential (a network, or K_t/K_n as a number), drive or None, and with a mount that.
KINDS = {
    "closed": lambda v: (kelvin(v["kn"], v["cn"]), mindlin("0.3"), None),
    "closed_body": lambda v: (zener(v["k0"], v["k1"], v["c1"]), kelvin(v["kt"], v["ct"]), kelvin(v["kd"], v["cd"])),
    "closed_drive": lambda v: (kelvin(v["k0"], v["c0"]), zener(v["kt"], v["k1"], v["c1"]),
                               zener(v["kd"], v["k2"], v["c2"])),
    "same_network": lambda v: (zener(v["k0"], v["k1"], v["c1"]), mp.mpf("0.8"), zener(v["k0"], v["k1"], v["c1"])),
    "undamped_drive": lambda v: (kelvin(v["kn"], v["cn"]), mindlin("0.25"), spring(v["kd"])),
    "free_harmonic": lambda v: (spring(v["kn"]), spring(v["kt"]), spring(v["kd"])),
    "resonance": lambda v: (spring(v["kn"]), kelvin(v["kt"], v["ct"]), spring(v["kd"])),
    "rigid_mass": lambda v: (kelvin(v["kn"], v["cn"]), mindlin("0.3"), None),
    "no_static_load": lambda v: (maxwell(v["k1"], v["c1"]), mindlin("0.3"), None),
    "separation_elastic": lambda v: (spring(v["kn"]), spring(v["kt"]), None),
    "separation_isotropic": lambda v: (zener(v["k0"], v["k1"], v["c1"]), mindlin("0.3"), None),
    "separation_late": lambda v: (kelvin(v["k0"], v["c1"]), mindlin("0.3"), None),
    "separation_memory": lambda v: (zener(v["k0"], v["k1"], v["c1"]), kelvin(v["kt"], v["ct"]), None),
    "separation_body": lambda v: (spring(v["kn"]), spring(v["kt"]), kelvin(v["kd"], v["cd"])),
    "separation_creeping": lambda v: (spring(v["kn"]), maxwell(v["kt"], v["ct"]), None),
    "separation_masses": lambda v: (spring(v["kn"]), spring(v["kt"]),
                                    series(spring(v["kf"]), parallel(mass(v["ms"]), kelvin(v["km"], v["cm"])))),
    "separation_measured": lambda v: (spring(v["kn"]), spring(v["kt"]), "chain.csv"),
    "separation_lossy": lambda v: (spring(v["kn"]), lossy(v["kt"], v["eta1"]), None),
    "drive_free_harmonics": lambda v: (spring(v["kn"]), spring(v["kt"]),
                                       series(spring(v["kf"]), parallel(mass(v["ms"]), spring(v["km"])))),
    "separation_jump": lambda v: (kelvin(v["kn"], v["cn"]), spring(v["kt"]), None),
    "indenter_elastic": lambda v: (spring(v["E0"]), mindlin("0.4"), None),
    "indenter_viscoelastic": lambda v: (zener(v["E0"], v["E1"], v["c1"]), mindlin("0.4"), None),
    "indenter_drive": lambda v: (spring(v["E0"]), mindlin("0.4"), spring(v["kd"])),
    "indenter_drive_mass": lambda v: (spring(v["E0"]), mindlin("0.4"), kelvin(v["kd"], v["cd"])),
    "indenter_drive_viscoelastic": lambda v: (zener(v["E0"], v["E1"], v["c1"]), mindlin("0.4"), spring(v["kd"])),
    "measured_drive": lambda v: (kelvin(v["kn"], v["cn"]), kelvin(v["kt"], v["ct"]), "chain.csv"),
    "drive_masses": lambda v: (zener(v["k0"], v["k1"], v["c1"]), mindlin("0.35"),
                               series(spring(v["kf"]), parallel(mass(v["ms"]), kelvin(v["km"], v["cm"])))),
    "drive_absorber": lambda v: (kelvin(v["kn"], v["cn"]), kelvin(v["kt"], v["ct"]),
                                 parallel(spring(v["kd"]), series(spring(v["k1"]), mass(v["m1"])))),
    "drive_graph_masses": lambda v: (kelvin(v["kn"], v["cn"]), mindlin("0.3"), frame(v)),
    "graph": lambda v: (bridge(v), mp.mpf("0.8"), kelvin(v["kd"], v["cd"])),
    "lossy": lambda v: (parallel(lossy(v["k0"], v["eta0"]), damper(v["c0"])), lossy(v["kt"], v["eta1"]),
                        parallel(spring(v["kd"]), lossy(v["k1"], v["eta1"]))),
    "graph_zero": lambda v: (bridge(v, (spring(v["k4"]), "1", "b")), spring(v["kt"]), None),
    "zero_elements": lambda v: (parallel(zener(v["k0"], v["k1"], v["c1"]), damper(v["c0"])),
                                zener(v["kt"], v["k2"], v["c2"]), kelvin(v["kd"], v["cd"])),
    "creeping": lambda v: (zener(v["k0"], v["k1"], v["c1"]),
                           series(maxwell(v["k2"], v["c2"]), kelvin(v["k3"], v["c3"])), maxwell(v["kd"], v["cd"])),
    "fluid": lambda v: (kelvin(v["kn"], v["cn"]), damper(v["ct"]), None),
    "prony": lambda v: (prony(v), mindlin("0.38"), kelvin(v["kd"], v["cd"])),
    "odd_names": lambda v: (zener(v["s"], v["K_n"], v["omega1"]), kelvin(v["i"], v["B"]), kelvin(v["exp"], v["H"])),
    "fitted": lambda v: (prony(v), mindlin("0.3"), None),
    "fitted_beyond": lambda v: (prony(v), mindlin("0.3"), kelvin(v["kd"], v["cd"])),
    "made_of_others": lambda v: (
        zener(v["k0"], v["k0"] * 7 / 10, v["k0"] * 7 / 10 * v["t1"]),
        parallel(spring(v["k0"] + v["kd"] / 4),
                 series(*(kelvin(k, k * tau) for k, tau in zip(v["k"], v["tau"])))),
        kelvin(v["kd"], v["r"] ** 2 * v["k0"] * 7 / 10 * v["t1"])),
    "load_closed": lambda v: (zener(v["k0"], v["k1"], v["c1"]), mindlin("0.3"), kelvin(v["kd"], v["cd"])),
    "separation_load": lambda v: (spring(v["kn"]), spring(v["kt"]), None),
    "load_creeping": lambda v: (maxwell(v["k1"], v["c1"]), kelvin(v["kt"], v["ct"]), None),
    "mount": lambda v: (kelvin(v["kn"], v["cn"]), mindlin("0.3"), None, kelvin(v["km"], v["cm"])),
    "mount_mass": lambda v: (zener(v["k0"], v["k1"], v["c1"]), kelvin(v["kt"], v["ct"]), kelvin(v["kd"], v["cd"]),
                             zener(v["km"], v["k2"], v["c2"])),
    "separation_mount": lambda v: (kelvin(v["kn"], v["cn"]), mindlin("0.3"), kelvin(v["kd"], v["cd"]),
                                   zener(v["km"], v["k2"], v["c2"])),
    "creeping_mount": lambda v: (maxwell(v["k1"], v["c1"]), mindlin("0.3"), kelvin(v["kd"], v["cd"]), spring(v["km"])),
    "measured_contact": lambda v: (measured(v, "n"), measured(v, "t"), kelvin(v["kd"], v["cd"])),
    "rational": lambda v: (prony({"k0": v["k0_pad"], "k": v["k_pad"], "tau": v["tau_pad"]}), mindlin("0.3"),
                           spring(v["kd"])),
    # (k0 k1 + (k0 + k1) c1 s)/(k1 + c1 s), and k1 = r k0
    "rational_names": lambda v: (zener(v["k0"], v["r"] * v["k0"], v["c1"]), mindlin("0.3"), spring(v["kd"])),
    "symbols": lambda v: (zener(v["k0"], v["k1"], v["c1"]), mindlin("0.3"), spring(v["kd"])),
}
for same, other in [("antiresonance", "free_harmonic"), ("near_free_harmonic", "free_harmonic"),
                    ("not_admissible", "closed"),
                    ("separation_undamped", "free_harmonic"), ("separation_free_harmonic", "free_harmonic"),
                    ("separation_tapping", "separation_elastic"), ("separation_closed", "separation_memory"), ("separation_no_load", "no_static_load"),
                    ("indenter_separation", "indenter_viscoelastic"), ("indenter_flat", "indenter_viscoelastic"),
                    ("indenter_table", "indenter_elastic"), ("near_resonance", "resonance"),
                    ("indenter_load", "indenter_elastic"), ("indenter_drive_load", "indenter_drive_mass"), ("separating_mount", "mount"),
                    ("separating_with_mass", "mount_mass")]:
    KINDS[same] = KINDS[other]

# Commands have values for these alone by --set.
SYMBOLS = {"k0": 8e6, "k1": 4e6, "c1": 30.0, "kd": 2e6, "m": 5e-4, "mu0": 0.3, "omega": 1e5, "du_z": 1e-7, "u_z0": 5e-7}


# What chain.csv is a table of: C-two-09 of tests/data/two_mass_chains.csv in units of 1e7 N/m and 1e5 rad/s.
CHAIN = series(kelvin(mp.mpf("1.72e7"), mp.mpf("16.3")),
               parallel(mass(mp.mpf("1.61e-3")), kelvin(mp.mpf("2.96e6"), mp.mpf("10.5"))))
# Its five digits are off by 5e-6 of R_d on average, of which a fit to 200 rows leaves less: so is friction that rests on it.
FIT_ERROR = 5e-6


def exact(value):
    return [mp.mpf(x) for x in value] if isinstance(value, list) else mp.mpf(value)


def touching(u, d):
    """Mean over a period of what a spring of unit stiffness is pressed by, at a mean depth u and an amplitude d."""
    if abs(u) >= d:
        return max(u, mp.mpf(0))
    return (mp.sqrt(d**2 - u**2) + u * mp.acos(-u / d)) / mp.pi


def pressed(name, values):
    """u_z0 under the load W: W/K_n(0), or where elastic contacts open the root of their mean force in closed form.

    Nothing where no spring carries it, and where steps find it.
    """
    force, d = values["W"], values["du_z"]
    if name == "indenter_load":  # a sphere: cells of depth u - x^2/R, by which the rim is open for a part of each period
        modulus, radius = values["E0"] / (1 - mp.mpf("0.4") ** 2), mp.mpf(5e-3)
        static = (force / modulus / mp.sqrt(radius) * 3 / 4) ** (mp.mpf(2) / 3)

        def share(x):
            u = x * static
            edges = [mp.sqrt(radius * max(each, 0)) for each in (0, u - d, u, u + d)]
            return 2 * modulus * mp.quad(lambda y: touching(u - y**2 / radius, d), edges) / force - 1
        with mp.workdps(30):
            return static * mp.findroot(share, (mp.mpf("0.9"), 1), solver="anderson")
    if name == "indenter_drive_load":
        from reference_held import depth_under_load
        with mp.workdps(40):
            return depth_under_load(values, mp.mpf(5e-3), "0.4")
    at_rest = values.get("kn", values.get("k0"))
    if at_rest is None or name == "separation_mount":
        return None
    if name != "separation_load" or force / at_rest > d:
        return force / at_rest
    return d * mp.findroot(lambda x: at_rest * touching(x * d, d) / force - 1,
                           (mp.mpf(-99) / 100, force / at_rest / d), solver="anderson")


def found_depth(name, values):
    found = pressed(name, values)
    return {} if found is None else {"u_z0": found}


def is_found(key, values):
    """What a scene does not give: the depth under a load, the contact's amplitude below a mount."""
    return (key == "u_z0" and "W" in values) or (key == "du_z" and "U" in values)


def read(name):
    """The scene's numbers by their symbols, and what its file says beside them."""
    with (FOLDER / f"{name}.toml").open("rb") as file:
        text = tomllib.load(file)
    # Expressions are those of KINDS.
    values = {key: exact(value) for key, value in text.get("elements", {}).items() if not isinstance(value, str)}
    # (12e6 s + 8e11)/(s + 1e5) = 8e6 + 4e6 s/(s + 1e5)
    if name == "rational":
        values |= {"k0_pad": mp.mpf("8e6"), "k_pad": [mp.mpf("4e6")], "tau_pad": [mp.mpf("1e-5")]}
    if name == "measured_contact":
        values |= {"k_n0": exact(text["contact"]["static_stiffness"])} | measured_numbers(mp.mpf(10) ** 5)
    if "oscillation" in text:
        oscillation = text["oscillation"]
        values |= {"mu0": exact(text["friction"]["coefficient"]), "omega": exact(oscillation["angular_frequency"]),
                   "du_z": exact(oscillation["amplitude"])}
        if "load" in text:
            values["W"] = exact(text["load"]["force"])
            values |= found_depth(name, values)
        else:
            values["u_z0"] = exact(oscillation["indentation"])
    else:
        values = {key: exact(value) for key, value in SYMBOLS.items()}
    for key, section in (("m", "body"), ("m_n", "mount")):
        given = text.get(section, {}).get("mass")
        if given is not None and given != "m":
            values[key] = exact(given)
    if "mount" in text:
        values["U"] = values.pop("du_z")
        values["du_z"] = height(wired(name, values), values)
    return values, text


def complex_height(system, values):
    """A_z of the contact: the amplitude given, or what the mount leaves of the vibrator's U cos(omega t)."""
    if system.mount is None:
        return values["du_z"]
    s = 1j * values["omega"]
    mount = stiffness(system.mount, s)
    return values["U"] * mount / (mount + stiffness(system.normal, s) + system.moving * s**2)


def height(system, values):
    """|A_z|"""
    return abs(complex_height(system, values))


def wired(name, values):
    normal, tangential, drive, *mount = KINDS[name](values)
    ratio = None if callable(tangential) else tangential
    moving = values.get("m_n", mp.mpf(0))
    if mount and "m_n" not in values:  # the body's own, if any
        moving = values.get("m", mp.mpf(0))
    if drive is None:
        values = {key: value for key, value in values.items() if key != "m"}
    return SimpleNamespace(normal=normal, ratio=ratio, tangential=tangential, drive=drive, mass=values.get("m", mp.mpf(0)),
                           mount=mount[0] if mount else None, moving=moving, fit_error=0, at_rest=values.get("k_n0"))


def moving(name, values):
    """What moves in time: of a table that of which it is one."""
    system = wired(name, values)
    if system.drive == "chain.csv":
        system.drive, system.fit_error = CHAIN, FIT_ERROR
    return system


def receptance(table, omega):
    """R_d of a measured drive, linear between two rows of its table."""
    return between_rows(table, omega, "omega", "Re", "Im")


def write_chain():
    """200 rows of five digits from 0.22 to 8.18 times the frequency of the oscillation, which lies between two of them."""
    with (FOLDER / "chain.csv").open("w") as file:
        file.write("omega,Re,Im\n")
        for i in range(200):
            omega = 22000 + 4000 * i
            r = 1 / stiffness(CHAIN, 1j * omega)
            file.write(f"{omega},{float(mp.re(r)):.4e},{float(mp.im(r)):.4e}\n")
