"""`vcrit eval` on every row of tests/data/vstar_extreme.csv: the double nearest to v* to the last bit, whatever
the size of the scene's numbers, and the right words where there is no such double.
"""

import json
import unittest

import program

HALF_ULP, SMALLEST = 2.0**-53, 2.0**-1074

# Springs and dampers in the order of the table's numbers, and what is made of them.
SHAPES = {
    "kelvin": ("kc", "{0} | {1}"),
    "maxwell": ("kc", "{0} - {1}"),
    "zener": ("kkc", "{0} | ({1} - {2})"),
    "burgers": ("kckc", "{0} - {1} - ({2} | {3})"),
}
BRIDGE = ["A C", "A D", "C B", "D B", "C D"]


def ladder(names):
    inner = f"{names[9]} | {names[19]}"
    for j in range(8, -1, -1):
        inner = f"{names[10 + j]} | ({names[j]} - ({inner}))"
    return inner


def network(kind, letter, numbers):
    """A network of the table's kind: its expression, its elements, and its graphs."""
    values = [float.fromhex(x) for x in numbers.split(";")]
    if kind == "prony10":
        elements = {f"k{letter}0": values[0], f"k{letter}": values[1:11], f"tau{letter}": values[11:]}
        return f"prony(k{letter}0, k{letter}, tau{letter})", elements, {}
    roles, expression = SHAPES.get(kind, ("k" * (len(values) // 2) + "c" * (len(values) // 2), ""))
    names = [f"{role}{letter}{i}" for i, role in enumerate(roles)]
    elements = dict(zip(names, values))
    if expression:
        return expression.format(*names), elements, {}
    if kind == "ladder10":
        return ladder(names), elements, {}
    edges = [[f"{names[i]} | {names[5 + i]}", *ends.split()] for i, ends in enumerate(BRIDGE)]
    return f"bridge_{letter}", elements, {f"bridge_{letter}": (["A", "B"], edges)}


def scene(row):
    coefficient, frequency, amplitude, mass = (float.fromhex(row[name]) for name in ("mu0", "w", "duz", "m"))
    parts = [network(row["kind"], letter, row[column]) for letter, column in (("t", "kx"), ("n", "kz"), ("d", "ks"))]
    (tangential, normal, drive), elements, graphs = zip(*parts)
    return program.scene({name: value for each in elements for name, value in each.items()},
                         {name: graph for each in graphs for name, graph in each.items()}, normal=normal,
                         tangential=tangential, network=drive, mass=mass or None, angular_frequency=frequency,
                         amplitude=amplitude, coefficient=coefficient)


def has_empty_network(row):
    def carries(numbers):
        values = [float.fromhex(x) for x in numbers.split(";")]
        if row["kind"] == "maxwell":
            return all(values)
        if row["kind"] == "burgers":
            return all(values[:2]) and any(values[2:])
        return any(values)

    return not all(carries(row[column]) for column in ("kx", "kz", "ks"))


class Case(program.Case):
    def value(self, row):
        return self.answer("eval", self.write(scene(row)))

    def refused_with(self, status, row, words):
        self.refused(status, ["eval", self.write(scene(row))], words)


class TheTable(Case):
    rows = program.rows("vstar_extreme.csv", 247)

    def check(self, row):
        answer = self.value(row)
        value, bound, reasons = answer["critical_velocity"], answer["relative_error_bound"], answer["reasons"]
        if row["status"] == "pole":
            self.assertEqual(value, "inf")
            self.assertIn("resonance", " ".join(reasons))
            return
        self.assertEqual(value, float.fromhex(row["vstar_hex"]))
        if row["status"] == "normal":
            self.assertLessEqual(bound, HALF_ULP)
        elif row["status"] == "subnormal":
            self.assertLessEqual(bound * value, SMALLEST / 2)
        elif row["status"] == "underflow":
            self.assertGreaterEqual(bound, 1)
        else:
            self.assertEqual((row["status"], bound), ("zero", 0))

    def test_is_met_to_the_last_bit(self):
        rows = [row for row in self.rows if not has_empty_network(row)]
        for row in rows:
            with self.subTest(id=row["id"], kind=row["kind"], status=row["status"]):
                self.check(row)
        self.assertEqual(len(rows), 242)

    # What elements of value 0 cut in two is wrong input, as the reader of a scene sees it.
    def test_a_network_of_nothing_is_refused(self):
        rows = [row for row in self.rows if has_empty_network(row)]
        for row in rows:
            with self.subTest(id=row["id"]):
                self.refused_with(2, row, "value 0 cut in two")
        self.assertEqual(len(rows), 5)


class Beside(Case):
    """What the table has no row of."""

    ROW = {"kind": "kelvin", "mu0": "0x1p-1", "w": "0x1p+1", "duz": "0x1p-20", "m": "0x1p+1", "kx": "0x1p+0;0x0p+0",
           "kz": "0x1p+3;0x0p+0", "ks": "0x1p+3;0x0p+0"}

    def test_above_the_largest_double_it_is_infinite_and_says_why(self):
        answer = self.value(self.ROW | {"mu0": "0x1p+600", "duz": "0x1p+600", "m": "0x0p+0"})
        self.assertEqual(answer["critical_velocity"], "inf")
        self.assertIn("v* is above the largest double", answer["reasons"])

    def test_resonance_of_both_kinds_is_outside_the_model(self):
        self.refused_with(3, self.ROW | {"mu0": "0x0p+0"}, "0/0")

    def test_above_the_largest_double_there_is_infinity_with_its_reason(self):
        row = self.ROW | {"m": "0x1p+0", "duz": "0x1p+1023", "kz": "0x1p+10;0x0p+0"}
        answer = self.value(row)
        self.assertEqual((answer["critical_velocity"], answer["relative_error_bound"]), ("inf", "inf"))
        self.assertIn("largest double", " ".join(answer["reasons"]))


# Forces of inf and of 0 N, a stiffness of nan N/m: they were refused as options that no command has, after a sweep had
# begun its file. Under 0 N the search of a speed crashed.
class Motion(Case):
    COMMANDS = [["simulate", "--velocity-ratio", "0.5"], ["critical"], ["plot", "--of", "friction", "--out", "p.svg"],
                ["solve", "--for", "velocity", "--friction-ratio", "0.8"],
                ["sweep", "--over", "velocity_ratio=lin:0.5:0.9:2", "--quantity", "friction_ratio", "--out", "s.csv"]]

    def test_beyond_doubles_is_outside_the_model(self):
        for scene in ("admissible_overflow", "admissible_underflow", "drive_velocity_nan"):
            for command, *options in self.COMMANDS:
                with self.subTest(scene=scene, command=command):
                    self.refused(3, [command, program.PROJECT / f"tests/data/range_ends/{scene}.toml", *options],
                                 "in SI units the numbers of this motion leave the range of doubles")

    # What the search came to was refused as the scene's: "found du_z = inf", "W = inf". With an upper end of subnormal
    # speeds it crashed.
    def test_what_a_search_comes_to_is_no_fault_of_the_scene(self):
        zener, load = program.example("zener"), program.example("tribometer")
        speed = ["--friction-ratio", "0.5", "--velocity", "1e-3"]
        for scene, *options in [(zener, "--for", "amplitude", *speed, "--set", "indentation=1e307"),
                                (zener, "--for", "frequency", *speed, "--set", "indentation=1e307"),
                                (zener, "--for", "amplitude", *speed, "--to", "1e-320"),
                                (load, "--for", "force", *speed, "--set", "amplitude=1e308"),
                                (zener, "--for", "velocity", "--friction-ratio", "0.5", "--to", "1e-320")]:
            with self.subTest(options=options):
                self.refused(3, ["solve", scene, *options], "leave the range of doubles")

    def test_advice_is_finite(self):
        for options in (["--for", "frequency", "--velocity", "1e300"], ["--for", "amplitude", "--velocity", "1e308"]):
            told = self.refused(3, ["solve", program.example("zener"), *options, "--friction-ratio", "0.5"],
                                "a velocity below that")
            self.assertNotIn("∞", told)

    # --drive.lead.equilibrium was refused, which no command has.
    def test_springs_of_a_drive_with_masses_may_be_too_stiff_together(self):
        scene = program.scene({"k": 8, "ka": 1.5e308, "kb": 1.5e308, "k2": 3, "m2": 1}, normal="k",
                              network="(ka | kb) - (mass(m2) | k2)")
        self.refused(3, ["simulate", self.write(scene), "--velocity", "1"], "leave the range of doubles")

    # The motion had lost a mass in rounding: 1313 m/s by simulation for 4.8 mm/s, and 9.79 mm/s for 9.71 mm/s.
    def test_masses_far_apart_are_right_or_refused(self):
        for name in ("measured_drive", "sonotrode"):
            scene = program.example(name)
            near = self.answer("critical", scene, "--set", "mass=1e-20")
            self.assertTrue(near["agree"])
            for mass in ("1e-36", "1e-60"):
                self.refused(3, ["critical", scene, "--set", f"mass={mass}"], "so different in stiffness, damping or mass")

    # A slow branch beside a stiff damper was lost on the way to the masses: v* was off by 2.5e-6 with no word on it.
    def test_a_branch_far_slower_than_another_is_no_disagreement(self):
        scene = self.write(program.scene(
            {"k": 1e4, "k4": 20, "k6": 1, "kp": [4e21], "tp": [4e-23], "m1": 5e-29, "c1": 3e-5}, normal="k",
            tangential_ratio=0.5, network="k4 - prony(k6, kp, tp, 1) - (mass(m1) | c1)", mass=1e-22, angular_frequency=3e8,
            amplitude=1e-7, indentation=1e-4))
        self.refused(3, ["critical", scene], "so different in stiffness, damping or mass")
        near = self.answer("critical", scene, "--set", "c1=1e-3")
        self.assertTrue(near["agree"])
        self.assertGreater(near["relative_difference"], 1e-9)
        self.assertLess(near["tolerance"], 1e-4)

    # Squares of the slow branch's rate left the doubles: 0.9596 with an error of 2e-15 for 0.9736, which the spring
    # alone has. With the fast ones "the motion grows beyond all bounds", and friction of 1 with an error of 0.06.
    def test_times_without_end_and_without_length_have_their_friction(self):
        elements = {"kn": 5e6, "k4": 1e6, "k1": 3e6, "c2": 20.0, "k5": 2e6, "kd": 1e6, "cd": 3.0}
        common = {"normal": "kn", "angular_frequency": 1.2e5, "amplitude": 3e-8, "indentation": 5e-7}
        contacts, drives = ("spring(k4)", "k4 | (k1 - c2)"), ({}, {"network": "kd | cd", "mass": 1e-5})
        both = [({"tangential": f"{contact} | {{0}}"}, drive) for contact in contacts for drive in drives]
        both += [({"tangential": contact}, {"network": "kd | {0}", "mass": 1e-5}) for contact in contacts]
        for parts, drive in both:
            for part, limit, values in (("(k5 - c1)", "k5", (1e155, 1e160, 1e200)), ("(k5 - c1)", "", (1e-165, 1e-250)),
                                        ("damper(c1)", "", (1e-165, 1e-200, 1e-300))):
                def friction(part, **more):
                    keys = {name: value.format(part).removesuffix(" | ") if isinstance(value, str) else value
                            for name, value in {**parts, **drive}.items()}
                    used = {name: value for name, value in {**elements, **more}.items()
                            if name in " ".join(str(key) for key in keys.values()) + "kn"}
                    return self.answer("simulate", self.write(program.scene(used, **keys, **common)), "--velocity", "4e-4")
                right = friction(limit)
                for value in values:
                    with self.subTest(**parts, **drive, part=part, c1=value):
                        found = friction(part, c1=value)
                        self.assertLess(found["friction_ratio_error"], 1e-13)
                        self.assertAlmostEqual(found["friction_ratio"], right["friction_ratio"], delta=1e-13)

    # It was said that v* is 0.
    def test_a_speed_far_above_v_star_is_told_as_that(self):
        self.assertIn("At 1 × 10³⁰⁸ m/s, more than 10³⁰⁸ times v*",
                      self.out("simulate", program.example("leaf_spring"), "--velocity", "1e308"))

    # It was said that the motion drifts.
    def test_a_drive_that_hardly_moves_is_named(self):
        for speed in ("1e-20", "1e-100", "1e-300"):
            self.refused(3, ["simulate", program.example("zener"), "--velocity", speed], "the drive is so slow")

    def test_a_ratio_to_no_v_star_is_outside_the_model(self):
        for command, *options in (["simulate", "--velocity-ratio", "0.5"], ["plot", "--cycle"]):
            told = self.refused(3, [command, program.example("zener"), *options, "--set", "amplitude=0"],
                                "v* is 0 here")
            self.assertIn("give --velocity", told)

    # A speed of ∞ was found, which nobody had given.
    def test_a_ratio_beyond_doubles_is_repeated(self):
        told = self.refused(2, ["simulate", program.example("zener"), "--set", "mu0=1e12", "--velocity-ratio", "1e300"],
                            "--velocity-ratio: found 1e300; expected a ratio to v* = ")
        self.assertNotIn("∞", told)

    def test_frequencies_are_named_as_they_were_given(self):
        self.refused(2, ["eval", program.example("zener"), "--set", "frequency=1e308"],
                     "--set frequency: found frequency = 1e+308; expected a finite value above 0, and 2 pi f within")

    # A method has one name: "rkf45 rkf45 cannot go on".
    def test_methods_say_their_name_once(self):
        for method in ("rkf45", "rk8pd", "msbdf", "tanh"):
            command = ["simulate", program.example("kelvin_rigid"), "--velocity", "1e308", "--method", method]
            told = self.refused(3, command)
            self.assertRegex(told, f"^{method} cannot go on")

    # A motion that cannot begin is no comparison that failed. Random sets around such values were refused as those of
    # the scene.
    def test_a_report_says_not_run(self):
        scene = self.write(program.scene({"k": 1.5e308}, normal="k", amplitude=0.1, indentation=2))
        self.out("validate", scene, "--out", "out")
        report = json.loads((self.folder / "out/report.json").read_text())
        compared = {each["key"]: each for each in report["scenes"][0]["comparisons"]}
        self.assertEqual(compared["simulation"]["outcome"], "not run")
        self.assertIn("leave the range of doubles", compared["simulation"]["detail"])

    # The force of friction, 1e-344 N, is no double; v* is.
    def test_a_speed_is_not_sought_in_an_endless_range(self):
        scene = program.scene({"k1": 1e6, "k2": 1e6}, normal="k1", tangential="k2", angular_frequency=1e150,
                              amplitude=1e-150, indentation=2e-150, coefficient=1e-200)
        self.refused(3, ["solve", self.write(scene), "--for", "velocity", "--friction-ratio", "0.8"],
                     "no steady state was found", "leave the range of doubles")


if __name__ == "__main__":
    unittest.main()
