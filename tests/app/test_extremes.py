"""vcrit validate --extremes as a user meets it: exit status, files, what is in them."""

import unittest

from program import Case, example

REGIONS = ["relaxation", "stiffness", "corners", "resonance", "antiresonance", "limits"]


class Extremes(Case):
    def test_everything_is_taken_to_extremes(self):
        report, page = self.reported("--extremes")
        self.assertIn('class="verdict passed"', page)
        families = {family["key"]: family for family in report["extremes"]["families"]}
        self.assertEqual(len(families), 9)
        regions = {key: [region["key"] for region in family["regions"]] for key, family in families.items()}
        self.assertEqual(regions["zener"], REGIONS)
        self.assertEqual(regions["elastic"], REGIONS[1:])  # nothing relaxes
        self.assertEqual(regions["rigid"], REGIONS[:2])  # no drive and no body
        self.assertEqual(regions["burgers"], REGIONS[:3])  # no body
        for family in families.values():
            for region in family["regions"]:
                # 22 x 25 cells; four corners; 15 distances on both sides and none; nine values a limit.
                size = {"relaxation": {550}, "stiffness": {550}, "corners": {88}, "limits": {9, 18, 27}}
                for way in region["evaluators"]:
                    self.assertIn(way["values"], size.get(region["key"], {30, 31}))
                    self.assertEqual(way["violated"], 0)
                    if way["way"].startswith(("accurate", "certified")):
                        self.assertEqual(way["lost"] + way["no_number"] + way["uncertified"], 0)
                if region["key"] != "limits":
                    self.assertEqual(region["simulator"]["wrong"], 0)
                    self.assertGreater(region["simulator"]["right"], 12)

    def test_extremes_stand_alone(self):
        for argument, words in [(example("kelvin"), ["--extremes", "scene files"]), ("--paper", ["--extremes", "--paper"])]:
            self.refused(2, ["validate", "--extremes", argument, "--out", "out"], *words)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
