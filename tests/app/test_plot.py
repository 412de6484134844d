"""vcrit plot as a user meets it: pictures say what the other commands say, and stand alone."""

import re
import unittest
from pathlib import Path

from pictures import panels, value_at
from program import Case, example

ZENER, SEPARATION, SPHERE, SONOTRODE = (example(name) for name in ("zener", "separation", "sphere", "sonotrode"))
# A curve is drawn to a tenth of a pixel, of 1.05/320 of a friction ratio each, with straight lines between 160 points.
DRAWN = 2e-3


class Plot(Case):
    def picture(self, *arguments):
        self.assertEqual(self.out("plot", *arguments, "--out", "picture.svg"), "picture.svg\n")
        return panels((self.folder / "picture.svg").read_text())

    def test_friction_is_that_of_simulate_and_v_star_that_of_eval(self):
        for scene in (ZENER, SEPARATION, SPHERE):
            with self.subTest(scene=scene):
                panel, = self.picture(scene)
                onset = self.answer("eval", scene)["critical_velocity"]
                self.assertIn(f"v* = {1e3 * onset:.4g} mm/s", panel.words)
                for ratio in (0.1, 0.5, 0.9, 1.2):
                    answer = self.answer("simulate", scene, "--velocity-ratio", ratio)
                    drawn = value_at(panel.lines[0], answer["velocity"])
                    self.assertAlmostEqual(drawn, answer["friction_ratio"], delta=DRAWN)

    def test_the_largest_speed_may_be_given(self):
        panel, = self.picture(ZENER, "--to", "2 mm/s")
        self.assertAlmostEqual(panel.lines[0][-1][-1][0], 2e-3, delta=1e-6)
        self.assertFalse([words for words in panel.words if words.startswith("v*")])

    def test_v_star_over_frequency_is_that_of_eval(self):
        for scene in (ZENER, SONOTRODE):
            panel, = self.picture(scene, "--of", "frequency")
            for frequency in ("1 kHz", "20 kHz", "150 kHz"):
                with self.subTest(scene=scene, frequency=frequency):
                    onset = self.answer("eval", scene, "--set", f"frequency={frequency}")["critical_velocity"]
                    drawn = value_at(panel.lines[-1], 1e3 * float(frequency.split()[0]))
                    # A tenth of a pixel of 320 for some decades is 0.5 %; the line is straight between points.
                    self.assertAlmostEqual(drawn / onset, 1, delta=0.02)

    def test_a_cycle_sticks_within_the_friction_bounds_and_has_the_mean_velocity_of_the_drive(self):
        force, velocity = self.picture(example("kelvin_rigid"), "--of", "cycle", "--velocity", "10 mm/s")
        bound, minus, drawn = force.lines
        for (_, above), (_, below), (_, between) in zip(*bound, *minus, *drawn):
            # A tenth of a pixel of 220 for the range of some four times the bound.
            self.assertTrue(below - 0.005 * above <= between <= above * 1.005, (below, between, above))
        speeds = [speed for _, speed in velocity.lines[0][0]]
        # 240 points of a period; a jump between two of them is missed by half a step at most.
        self.assertAlmostEqual(sum(speeds) / len(speeds) / 10e-3, 1, delta=0.03)
        self.assertLess(min(speeds), 1e-4)

    def test_each_picture_by_all_its_names(self):
        for names in ([["--over", "frequency"], ["--of", "frequency"], ["--over=frequency"]],
                      [["--cycle"], ["--over", "cycle"], ["--of", "cycle"]],
                      [[], ["--over", "speed"], ["--over", "velocity"], ["--of", "friction"]]):
            texts = [self.out("plot", ZENER, *each) for each in names]
            self.assertEqual(texts, [texts[0]] * len(texts), names)

    def test_the_help_names_pictures_as_the_documents_do(self):
        self.assertIn("{speed,frequency,cycle}=speed", self.out("plot", "--help"))

    def test_a_terminal_names_the_other_pictures(self):
        shown = self.on_terminal("plot", ZENER)
        self.assertEqual(shown.splitlines()[-1], "more: --over frequency | --cycle | --to SPEED | --out FILE.svg")
        self.assertEqual(shown.splitlines()[:-2], self.out("plot", ZENER).splitlines())

    def test_options_without_use_are_refused(self):
        self.refused(2, ["plot", ZENER, "--over", "frequency", "--to", "9 mm/s"], "--to: found", "expected friction over speed")
        self.refused(2, ["plot", ZENER, "--velocity", "2 mm/s"], "--velocity: found", "expected --cycle with it")
        self.refused(2, ["plot", ZENER, "--over", "frequency", "--velocity-ratio", "0.5"], "--velocity-ratio: found")

    def test_a_terminal_of_80_letters_has_room(self):
        for scene, of in ((ZENER, "friction"), (ZENER, "frequency"), (SEPARATION, "cycle"), (SPHERE, "friction")):
            lines = self.out("plot", scene, "--of", of).splitlines()
            self.assertLess(max(map(len, lines)), 80)
            self.assertFalse([line for line in lines if line != line.rstrip()])
        self.assertIn("v* = 4.095 mm/s |", self.out("plot", ZENER))

    def test_a_pdf_has_a_page_for_each_panel(self):
        self.out("plot", ZENER, "--of", "cycle", "--out", "cycle.pdf")
        content = (self.folder / "cycle.pdf").read_bytes()
        self.assertTrue(content.startswith(b"%PDF"))
        self.assertEqual(len(re.findall(rb"/Type /Page\b", content)), 2)

    def test_a_title_stays_text(self):
        text = Path(ZENER).read_text().replace('title = "Zener contact', 'title = "<b>&\\"\\u0007 ]]> {{x}} \'Zener contact')
        panel, = self.picture(self.write(text))
        self.assertEqual(panel.title, "<b>&\"\N{REPLACEMENT CHARACTER} ]]> {{x}} 'Zener contact under an elastic drive")

    # Its upper end was refused: "omega: found inf rad/s".
    def test_frequencies_end_within_the_range_of_doubles(self):
        self.out("plot", ZENER, "--over", "frequency", "--set", "frequency=1e307")

    def test_frequencies_far_below_those_of_the_scene_s_parts(self):
        """That their ratio leaves the range of doubles was told as an infinite omega."""
        for frequency in ("1e-300", "1e-150", "1e150", "1e300"):
            self.assertIn("this scene", self.out("plot", ZENER, "--over", "frequency", "--set", f"frequency={frequency}"))

    def test_what_cannot_be_drawn_is_refused_before_a_file_is_there(self):
        self.refused(2, ["plot", ZENER, "--out", "picture.png"], 'found "picture.png"; expected a file ending in .svg or .pdf')
        self.refused(2, ["plot", ZENER, "--to", "-1 mm/s"], "expected a speed above 0")
        for speed in ("1e308", "5e-324"):  # no room for the other speeds
            self.refused(2, ["plot", ZENER, "--to", speed], "--to: found a speed of")
        self.refused(3, ["plot", example("inadmissible"), "--out", "picture.svg"], "the contact opens")
        self.refused(3, ["plot", ZENER, "--cycle", "--set", "mu0=0"], "with mu0 = 0 there is no friction to compare with")
        self.refused(3, ["plot", SPHERE, "--of", "cycle", "--out", "picture.svg"], "an indenter has no single contact motion")
        self.refused(2, ["plot", ZENER, "--out", "picture.pdf"], "gnuplot", env={"PATH": "/nonexistent"})
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
