"""`vcrit critical`: its verdict, printed and as an exit status."""

import json
import unittest

from program import Case, example


class Verdicts(Case):
    def body(self, drive, contact, elements, mass):
        return self.scene({"kn": 3} | elements, tangential=contact, network=drive, mass=mass)

    def compared(self, *parts):
        scene = self.body(*parts)
        return self.run_program("critical", scene, "--json"), self.run_program("critical", scene)

    # Doubles lose digits there like the inverse of the distance, and no more than that: the tolerance is derived in
    # src/critical/conditioning.hpp. Cycles that close to a few roundings leave hardly anything of the last stick open.
    def test_near_resonance_all_ways_agree(self):
        for contact, elements in (("kt", {"kt": 2}), ("kt | ct", {"kt": 1.6, "ct": 0.4})):
            for drive in ("kd", "kd | cd"):
                for exponent in range(3, 14):
                    for sign in (1, -1):
                        off = sign * 10.0**-exponent
                        each = elements | {"kd": 4} | ({"cd": abs(off)} if "cd" in drive else {})
                        with self.subTest(contact=contact, drive=drive, off=off):
                            scene = self.body(drive, contact, each, 1 - off)
                            answer = self.answer("critical", scene)
                            self.assertTrue(answer["agree"])
                            # 32 roundings times the condition number, some (sqrt(2) + 3) / off.
                            self.assertLessEqual(answer["tolerance"], max(1e-9, 1.7e-14 / abs(off)))
                            self.assertLessEqual(answer.get("stick_onset_tolerance", 0), 2 * answer["tolerance"])
                # The text is of the same numbers: of those with the fewest digits left.
                self.assertNotIn("ABOVE", self.out("critical", scene))

    # v* is finite there: the swing is large, and grows no more.
    def test_near_resonance_no_swing_grows_without_bound(self):
        found = self.answer("critical", self.body("kd", "kt", {"kt": 2, "kd": 4}, 1 - 1e-12))
        self.assertIn("so near an undamped resonance", found["stick_onset_missing"])

    def test_status_3_where_doubles_have_no_digit(self):
        for mass in (1 - 2**-53, 1 + 2**-52):
            result, text = self.compared("kd", "kt", {"kt": 2, "kd": 4}, mass)
            self.assertEqual((result.returncode, text.returncode), (3, 3))
            self.assertIn("has no digit of v*", text.stderr)

    # v* is 0 there by each way. What doubles leave is a rounding of the speeds that cancel: no failure, though any
    # share of 0 would be infinite.
    def test_an_exact_antiresonance_agrees(self):
        for kn, kt, kd, mass in ((10, 12, 8, 5), (3, 2, 3, 1.25), (7, 0.75, 0.5, 0.3125)):
            with self.subTest(kt=kt, kd=kd):
                result, text = self.compared("kd", "kt", {"kn": kn, "kt": kt, "kd": kd}, mass)
                self.assertEqual((result.returncode, text.returncode), (0, 0))
                found = json.loads(result.stdout)
                self.assertEqual((found["formula"], found["agree"]), (0, True))
                self.assertLess(found["relative_difference"], 64 * 2**-53)  # 32 roundings of each compliance
                self.assertIn("antiresonance", found["stick_onset_missing"])
                self.assertNotIn("ABOVE", text.stdout)

    # Where nothing oscillates v* is 0 by each way. Of a measured drive they did not agree, within a tolerance of nan.
    def test_nothing_that_oscillates_agrees(self):
        for name in ("measured_drive", "zener", "sphere"):
            with self.subTest(scene=name):
                command = ["critical", example(name), "--set", "amplitude=0"]
                found = self.answer(*command)
                self.assertEqual((found["formula"], found["simulated"], found["agree"]), (0, 0, True))
                self.assertLess(found["tolerance"], 1e-6)
                self.assertNotIn("resonance", found["stick_onset_missing"])
                self.assertNotIn("nan", self.out(*command))

    # A free swing at the second harmonic: steady sliding from v*/sqrt(2) on.
    def test_a_free_swing_slides_from_below_the_critical_velocity(self):
        result, text = self.compared("kd", "kt", {"kt": 2, "kd": 16}, 1)
        self.assertEqual((result.returncode, text.returncode), (0, 0))
        answer = json.loads(result.stdout)
        self.assertTrue(answer["agree"])
        for key in ("sliding_from", "simulated"):
            # two roundings of the formula, and one of the root
            self.assertAlmostEqual(answer[key], answer["formula"] / 2**0.5, delta=4 * 2**-52 * answer["formula"])
        self.assertIn("the undamped drive swings freely", text.stdout)


if __name__ == "__main__":
    unittest.main()
