"""The columns of `sweep`: all quantities that a kind has in one table, and by turns a quantity alone, which has to have
the very texts of that table."""

import csv

from cells import KINDS, REFERENCES, U, contact_amplitude, onset, refusal, run, scene, settable

TURNS = 4  # of which a quantity is asked for alone in one


def velocities(kind):
    references = REFERENCES[kind]
    return [references.text(f"velocity:{i}") if f"velocity:{i}" in references else f"1e-{3 + i}" for i in (0, 1)]


def asked_for(kind, quantity):
    references = REFERENCES[kind]
    if quantity == "sensitivity:NAME":
        return [f"sensitivity:{name}" for name in settable(references.begin("sensitivity:") or references.begin("value:"))]
    return ["friction_ratio", "friction_ratio_error"] if quantity == "friction_ratio" else [quantity]


def swept(test, kind, quantities):
    """What has run, and the rows that it has written."""
    axis, table = test.folder / "axis", test.folder / "table.csv"
    axis.write_text("\n".join(velocities(kind)) + "\n")
    table.unlink(missing_ok=True)
    ran = run("sweep", scene(kind), "--over", f"velocity=list:{axis}", "--out", table, "--threads", "1",
              *(word for each in quantities for word in ("--quantity", each)))
    if not table.exists():
        return ran, []
    with table.open() as file:
        return ran, list(csv.DictReader(file))


def sweep(test, columns):
    together = {}

    def rows_of_all(kind):
        """The table of all quantities that are not refused."""
        if kind not in together:
            quantities = dict.fromkeys(each for column in columns if refusal(kind, column) is None
                                       for each in asked_for(kind, column.split("/")[1]))
            ran, rows = swept(test, kind, quantities)
            test.assertEqual(ran.returncode, 0, ran.stderr)
            test.assertEqual([float(row["velocity"]) for row in rows], [float(velocity) for velocity in velocities(kind)])
            together[kind] = rows
        return together[kind]

    def cell(kind, column):
        quantity = column.split("/")[1]
        if refusal(kind, column) is not None or (KINDS.index(kind) + columns.index(column)) % TURNS == 0:
            ran, alone = swept(test, kind, asked_for(kind, quantity))
            if not test.answered(kind, column, ran):
                return
            test.assertEqual(alone, [{name: row[name] for name in alone[0]} for row in rows_of_all(kind)])
        test.looked_at(kind, column)
        for i, row in enumerate(rows_of_all(kind)):
            check_row(test, kind, quantity, i, row)

    test.over(columns, cell)


def check_row(test, kind, quantity, i, row):
    references = REFERENCES[kind]
    value, error = onset(kind)
    if quantity == "critical_velocity":
        test.near(row[quantity], value, error, quantity)
    elif quantity == "admissible":
        outside = kind in ("not_admissible", "no_static_load")
        test.assertEqual(row[quantity], "no" if outside else "yes")
    elif quantity in ("indentation", "mean_normal_force"):
        test.near_pressed(kind, i, quantity, float(row[quantity]))
    elif quantity == "contact_amplitude":
        test.near(row[quantity], contact_amplitude(kind)[0], 8 * U * float(row[quantity]), quantity)
    elif quantity == "sensitivity:NAME":
        simulated = references.begin("simulated_sensitivity:")
        for name in settable(references.begin("sensitivity:")):
            start = "simulated_sensitivity" if name in simulated else "sensitivity"
            reference = references(f"{start}:{name}")
            # Differentiated in doubles, or by differences good to 1e-9.
            allowed = references.error(f"{start}:{name}") + 1e-8 + 1e-10 * abs(reference)
            test.near(row[f"sensitivity_{name}"], reference, allowed, name)
    elif quantity == "regime":
        test.assertEqual(row[quantity], references.text(f"regime:{i}"))
    elif quantity == "friction_ratio_error":
        test.assertLess(float(row[quantity]), 1e-3 if kind == "indenter_drive_viscoelastic" else 1e-9)  # steps of time
    else:
        name = f"{quantity}:{i}"
        test.near(row[quantity], references(name), references.error(name) + float(row["friction_ratio_error"]), name)
