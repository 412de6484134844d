"""A contact given as a table of its dynamic stiffness, through the commands, against the table itself."""
import unittest

from program import Case, scene

PAD = "omega,storage,loss\n1,8,1\n3,16,2\n5,16,4\n"
CONTACT = 'normal = "kn"\n'
MU, AMPLITUDE, KT = 0.3, 0.1, 4


def stiffness(omega):
    rows = [tuple(map(float, line.split(","))) for line in PAD.splitlines()[1:]]
    for (left, *low), (right, *high) in zip(rows, rows[1:]):
        if left <= omega <= right:
            part = (omega - left) / (right - left)
            return complex(*(a + part * (b - a) for a, b in zip(low, high)))
    return None


class MeasuredContact(Case):
    def setUp(self):
        super().setUp()
        self.write(PAD, "pad.csv")
        text = scene({"kt": KT}, tangential="kt")
        self.write(text.replace(CONTACT, 'dynamic_stiffness = "pad.csv"\nstatic_stiffness = 6\n'))

    # Some roundings of doubles.
    def test_a_sweep_follows_the_table_and_has_no_number_beyond_it(self):
        rows = self.table("s.toml", "--over", "omega=lin:0.5:5.5:11", "--quantity", "critical_velocity", "--quantity",
                          "admissible")
        self.assertEqual(len(rows), 11)
        for row in rows:
            k = stiffness(omega := float(row["omega"]))
            self.assertEqual(row["critical_velocity"] == "nan", k is None, row)
            self.assertEqual(row["admissible"], "no" if k is None else "yes")
            if k is not None:
                v = MU * omega * AMPLITUDE * abs(k) / KT
                self.assertLess(abs(float(row["critical_velocity"]) / v - 1), 1e-15)

    # Of v* = mu0 omega du_z |K|/KT by hand: 1 + omega Re(K'/K). At a row there is a slope on each side.
    def test_the_sensitivity_to_omega_has_the_slope_of_the_table(self):
        rows = self.table("s.toml", "--over", "omega=lin:2:4:3", "--quantity", "sensitivity:omega")
        for row, slope in zip(rows, (4 + 0.5j, None, 1j)):
            if slope is None:
                self.assertEqual(row["sensitivity_omega"], "nan")
                continue
            expected = 1 + float(row["omega"]) * (slope / stiffness(float(row["omega"]))).real
            self.assertLess(abs(float(row["sensitivity_omega"]) / expected - 1), 1e-14)

    def test_beyond_the_table_is_outside_the_model(self):
        self.refused(3, ("eval", "s.toml", "--set", "omega=6"), "0.9549 Hz is outside the measured stiffness in",
                     "pad.csv, 0.1592 Hz to 0.7958 Hz")

    def test_what_needs_a_motion_names_the_way_to_one(self):
        for arguments in (("simulate", "s.toml", "--velocity", "1"), ("critical", "s.toml"),
                          ("solve", "s.toml", "--for", "velocity", "--friction-ratio", "0.9")):
            self.refused(3, arguments, "a table at some frequencies is no law in time", "vcrit fit")

    def test_numbers_of_the_table_are_not_set_and_those_of_the_scene_are(self):
        self.refused(2, ("eval", "s.toml", "--set", "k_n=5"), "k_n, which is in the table pad.csv")
        half = self.answer("eval", "s.toml", "--set", "k_n0=3")
        self.assertEqual(half["critical_velocity"], self.answer("eval", "s.toml")["critical_velocity"])

    def test_symbols_have_their_words(self):
        text = self.out("derive", "s.toml", "--format", "latex")
        for line in ("$k_{n}$ & storage stiffness of the normal contact & N/m",
                     "$k_{n0}$ & stiffness at rest of the normal contact & N/m",
                     "$\\eta_{n}$ & loss factor of the normal contact & 1"):
            self.assertIn(line, text)

    # Whether K_t is a multiple of K_n is in the tables: no special case of the formula.
    def test_limits_of_two_tables(self):
        text = (self.folder / "s.toml").read_text()
        text = text.replace('tangential = "kt"', 'tangential_dynamic_stiffness = "pad.csv"').replace("kt = 4\n", "")
        self.write(text)
        self.assertNotIn("isotropic", self.out("derive", "s.toml", "--limits"))


if __name__ == "__main__":
    unittest.main()
