"""What the columns of the matrix share: kinds, references, refusals, and the record of the cells that were looked at."""

import csv
import fnmatch
import json
import re
import subprocess
from pathlib import Path

import mpmath as mp

from program import PROGRAM

FOLDER = Path(__file__).parent
KINDS = sorted(file.stem for file in (FOLDER / "kinds").glob("*.toml"))
# v* so near to (anti)resonance is 0, or infinite by its inverse.
TINY = mp.mpf(10)**-25
# Of a double; a value is correctly rounded, and a reference has some digits more.
U = 2.0**-53


def run(*arguments, timeout=120, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=timeout,
                          cwd=FOLDER / "kinds", **options)


def scene(kind):
    return f"{kind}.toml"


class References:
    """Rows of references.csv of one kind."""

    def __init__(self, rows):
        self.values = {row["quantity"]: row["value"] for row in rows}
        self.errors = {row["quantity"]: float(row["error"]) for row in rows}

    def __contains__(self, quantity):
        return quantity in self.values

    def __call__(self, quantity):
        return mp.mpf(self.values[quantity])

    def text(self, quantity):
        return self.values[quantity]

    def error(self, quantity):
        return self.errors[quantity]

    def begin(self, start):
        """What follows in the names of all quantities that begin so."""
        return [name[len(start):] for name in self.values if name.startswith(start)]

    def parameters(self):
        values = {name: self(f"value:{name}") for name in self.begin("value:") if not name.startswith("R_d")}
        if "value:R_d real" in self:
            values["R_d"] = mp.mpc(self("value:R_d real"), self("value:R_d imaginary"))
        return values


def read_references():
    found = {}
    with (FOLDER / "references.csv").open() as file:
        for row in csv.DictReader(file):
            found.setdefault(row["kind"], []).append(row)
    return {kind: References(rows) for kind, rows in found.items()}


REFERENCES = read_references()
with (FOLDER / "refusals.csv").open() as file:
    REFUSALS = list(csv.DictReader(file))
LOOKED_AT = set()


def refusal(kind, column):
    """(status, part of the message) of the first row that fits, else nothing."""
    for row in REFUSALS:
        if fnmatch.fnmatch(kind, row["kind"]) and fnmatch.fnmatch(column, row["column"]):
            row["used"] = True
            return row["status"], row["message"]
    return None


def choices(command, option):
    """The values that an option takes, by the help; its first line may be broken."""
    text = run(command, "--help").stdout
    return re.search(rf"--{option} {{([^}}]*)}}", text)[1].split(",")


def commands():
    text = run("--help").stdout
    section = text[text.index("Subcommands:"):text.index("Examples:")]
    return re.findall(r"^  (\w+)", section, re.M)


class Cells:
    """Mixed into test cases: `answered` says whether a cell has values, and `near` compares them."""

    def looked_at(self, kind, column):
        LOOKED_AT.add((kind, column))

    def answered(self, kind, column, ran):
        """False where the cell is a refusal, which `ran` then has to be; a refusal unasked fails."""
        self.looked_at(kind, column)
        expected = refusal(kind, column)
        if expected is None:
            self.assertEqual(ran.returncode, 0, ran.stderr)
            return True
        status, message = expected
        self.assertEqual((str(ran.returncode), message in ran.stderr), (status, True), f"{ran.stderr}{ran.stdout[:200]}")
        if ran.returncode > 1:
            self.assertEqual(ran.stdout, "")
        return status == "0"

    def answer(self, kind, column, *arguments):
        """The JSON object of a command, or nothing where it is to refuse."""
        ran = run(*arguments, "--json")
        return json.loads(ran.stdout) if self.answered(kind, column, ran) else None

    def near_pressed(self, kind, i, quantity, found):
        """The mean indentation or normal force of row i. The force by steps; where nothing moves in time, that given, or
        K_n(0) u_z0: the amplitude that opens the contact times |K_n|."""
        references, name = REFERENCES[kind], f"mean_normal_force:{i}"
        if quantity == "indentation":
            under_load = "indentation" in references
            reference = references("indentation" if under_load else "value:u_z0")
            allowed = references.error("indentation") + 1e-12 * abs(reference) if under_load else U * abs(reference)
            self.near(found, reference, allowed, quantity)
        elif name in references:
            # Below an indenter also the program's own quadrature, good to 1e-12.
            self.near(found, references(name), references.error(name) + 1e-12 * found, name)
        elif "value:W" in references:
            self.near(found, references("value:W"), 0, name)
        else:
            stiffness = abs(mp.mpc(references("normal_stiffness:storage"), references("normal_stiffness:loss")))
            self.near(found, references("admissible_amplitude") * contact_amplitude(kind)[1] * stiffness, 8 * U * found, name)

    def near(self, found, reference, allowed, words=""):
        """Absolutely; infinite only where both are."""
        found = mp.mpmathify(found)
        if reference == mp.inf or found == mp.inf:
            self.assertEqual(found, reference, words)
            return
        self.assertLessEqual(abs(found - reference), allowed,
                             f"{words}: found {mp.nstr(found, 17)}, expected {mp.nstr(reference, 17)}")

    def near_in_digits(self, value, reference, words):
        """Of 80 digits, of which long sums lose some; so near to (anti)resonance a value is 0, or infinite."""
        if abs(reference) > 1 / TINY:
            self.assertGreater(abs(value), 1 / TINY, words)
        else:
            self.near(value, reference, abs(reference) * mp.mpf(10)**-18 + TINY, words)

    def near_formula(self, found, kind, roundings=3, words=""):
        reference = REFERENCES[kind]("formula")
        self.near(found, reference, abs(reference) * roundings * U if reference != mp.inf else 0, words or kind)


def settable(names):
    """But what follows omega by a table, which nobody sets."""
    return [name for name in names if name not in ("k_n", "eta_n", "k_t", "eta_t")]


def contact_amplitude(kind):
    """du_z, and its share of the amplitude given."""
    references = REFERENCES[kind]
    if "normal_oscillation:amplitude" not in references:
        return references("value:du_z"), 1
    found = references("normal_oscillation:amplitude")
    return found, found / references("value:U")


def receptance(omega):
    """Of the measured drive, at a row of its table."""
    with (FOLDER / "kinds/chain.csv").open() as file:
        rows = {float(row["omega"]): mp.mpc(row["Re"], row["Im"]) for row in csv.DictReader(file)}
    return rows[float(omega)]


def onset(kind):
    """v* and its error: of a contact that is open for a while by time steps, else Eq. (24)."""
    references = REFERENCES[kind]
    if "critical_velocity" in references:
        return references("critical_velocity"), references.error("critical_velocity")
    value = references("formula")
    return value, 3 * U * float(value) if value != mp.inf else 0


def free_share(kind):
    """From which share of v* on sliding is steady: the body swings freely at 2 omega, or with its drive at 2 and 3
    omega: cos(pi/4) and, by Fejer, 1/(2 cos(pi/5))."""
    return {"free_harmonic": mp.cos(mp.pi / 4), "drive_free_harmonics": 1 / (2 * mp.cos(mp.pi / 5))}.get(kind)
