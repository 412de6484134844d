#!/usr/bin/python3
"""Makes the column `velocity` of opening_onset.csv again: v* in m/s where surfaces part, to 20 digits.

It shares nothing with the program. Where the surfaces meet and part is known from normal_cycle.py, which finds the
closed cycle of the normal force by Newton's method. Sliding forward all the time, contact point, body and drive are then
one linear system while the surfaces touch and another one while they are apart (System of opening_friction.py, with
omega = 1), and the steady motion is the one that both matrix exponentials bring back to where it began. v* is the highest
speed against the drive that the contact point has while the surfaces touch: looked for at 2000 times, then by golden
sections. A program by others, which marches with two step lengths in 34 digits, agrees to 4e-16 (it rounds omega first).

    opening_onset.py         compares, and prints the largest relative difference
    opening_onset.py write   writes the table
"""

import csv
import sys
from pathlib import Path

from mpmath import eye, expm, lu_solve, matrix, mp, mpf, nstr, pi

from normal_cycle import solved
from opening_friction import System, moved

TABLE = Path(__file__).with_suffix(".csv")
SAMPLES = 2000


def in_radians(network, omega):
    """A network with omega t for the time."""
    k, c, *branches = network.split()
    times = [(mpf(each.split(":")[0]), mpf(each.split(":")[1]) * omega) for each in branches]
    return mpf(k), mpf(c) * omega, times


def text_of(network):
    k, c, branches = network
    return " ".join([nstr(k, 30), nstr(c, 30)] + [f"{nstr(a, 30)}:{nstr(b, 30)}" for a, b in branches])


def onset(row):
    omega = mpf(row["omega"]) if row["omega"] else 2 * pi * mpf(row["frequency"])
    tangential, normal = in_radians(row["tangential"], omega), in_radians(row["normal"], omega)
    drive = text_of(in_radians(row["drive"], omega)) if row["drive"] else ""
    mass = nstr(mpf(row["mass"]) * omega**2, 30) if row["mass"] else ""
    # Stiffnesses in units of K_t, lengths in units of the amplitude, which v* is proportional to.
    mean = mpf(row["mean"]) / mpf(row["amplitude"])
    k, c, branches = normal
    begin, end, _ = solved(c / k, [(a / k, tau) for a, tau in branches], mean, 1)
    system = System(text_of(tangential), text_of(normal), drive, mass, nstr(mean, 30), 1, row["mu"], 0)
    slip, apart = system.motions["slip"][0], system.motions["apart"][0]
    # The states that come back: not 1, cos, sin, the indentation, which is given, nor the integrals. Without a direct
    # damper nothing depends on the deformation of the tangential network, which follows the force.
    others = {"1", "cos", "sin", "en", "F", "Fn"} | ({"et"} if tangential[1] == 0 else set())
    kept = [i for name, i in system.at.items() if name not in others]
    start = matrix(len(system.at), 1)
    start[0], start[1], start[2] = 1, mp.cos(begin), mp.sin(begin)
    start[system.at["en"]] = mean + mp.cos(begin)
    touching = expm(slip * (end - begin))
    period = expm(apart * (2 * pi - (end - begin))) * touching
    after = period * start
    part = matrix([[period[i, j] for j in kept] for i in kept])
    own = lu_solve(eye(len(kept)) - part, matrix([after[i] for i in kept]))
    for i, value in zip(kept, own):
        start[i] = value
    return omega * mpf(row["amplitude"]) * highest(system, slip, start, end - begin)


def highest(system, slip, start, duration):
    """The largest -(contact velocity) of the motion, in the time that the surfaces touch."""
    step = expm(slip * (duration / SAMPLES))
    states, speeds = [start], [-system.velocity("slip", start)]
    for _ in range(SAMPLES):
        states.append(step * states[-1])
        speeds.append(-system.velocity("slip", states[-1]))
    i = max(range(len(speeds)), key=speeds.__getitem__)
    low = states[max(i - 1, 0)]
    length = duration / SAMPLES * (2 if 0 < i < SAMPLES else 1)
    best = lambda t: -system.velocity("slip", moved(slip, t, low))
    share = (mp.sqrt(5) - 1) / 2
    a, b = mpf(0), length
    while b - a > mpf(10) ** -13 * length:  # a maximum is flat: twice as many digits
        first, second = b - share * (b - a), a + share * (b - a)
        if best(first) > best(second):
            b = second
        else:
            a = first
    return max(best((a + b) / 2), speeds[i])


def main():
    with TABLE.open() as file:
        rows = list(csv.DictReader(file))
    largest = mpf(0)
    for row in rows:
        found = onset(row)
        difference = abs(found / mpf(row["velocity"]) - 1)
        largest = max(largest, difference)
        print(row["name"], nstr(found, 25), nstr(difference, 3), flush=True)
        row["velocity"] = nstr(found, 25)
    print("largest relative difference", nstr(largest, 3))
    if sys.argv[1:] == ["write"]:
        with TABLE.open("w", newline="") as file:
            writer = csv.DictWriter(file, rows[0], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
