"""Pictures and what is shown of objects: those of `vcrit plot`, matplotlib's with the same points, and short texts."""

import json
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from unittest import mock

import matplotlib
import numpy as np
import vcrit
from support import PROJECT, program
from vcrit import wrong_python

matplotlib.use("agg")
ZENER = "scenes/zener.toml"
SCENE = vcrit.Scene(ZENER)
# Of each picture: arguments of Python and of the program.
ASKED = [(("friction",), {}, ()), (("friction",), {"to": "3 mm/s"}, ("--to", "3 mm/s")), (("frequency",), {}, ()),
         (("cycle",), {}, ()), (("cycle",), {"velocity": "1 mm/s"}, ("--velocity", "1 mm/s")),
         (("cycle",), {"velocity_ratio": 0.2}, ("--velocity-ratio", "0.2"))]


class Pictures(unittest.TestCase):
    def test_are_those_of_the_program(self):
        for of, named, options in ASKED:
            with self.subTest(of=of, **named), tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "a.svg"
                result = program("plot", ZENER, "--of", *of, *options, "--out", file)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(SCENE.svg(*of, **named), file.read_text())

    def test_by_matplotlib_have_the_same_points(self):
        for of, named, options in ASKED:
            with self.subTest(of=of, **named):
                figures = json.loads(program("plot", ZENER, "--of", *of, *options, "--json").stdout)["figures"]
                drawn = SCENE.plot(*of, **named)
                for figure, axes in zip(figures, np.atleast_1d(drawn), strict=True):
                    self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), (figure["x"], figure["y"]))
                    for series, line in zip(figure["series"], axes.lines):
                        points = np.array([[np.nan if value is None else value for value in point[:2]]
                                           for point in series["points"]], float)
                        # Seven digits are drawn.
                        np.testing.assert_allclose(line.get_xydata(), points, rtol=1e-6, atol=1e-12)

    def test_go_into_axes_of_the_caller(self):
        from matplotlib import pyplot
        figure, axes = pyplot.subplots()
        self.assertIs(SCENE.plot(ax=axes), axes)
        with tempfile.TemporaryDirectory() as folder:
            figure.savefig(Path(folder) / "a.png")  # all of it can be drawn
        pyplot.close("all")

    def test_say_what_is_missing(self):
        with mock.patch.dict(sys.modules, {"matplotlib.pyplot": None}):
            with self.assertRaisesRegex(ImportError, r"python3-matplotlib.*svg\(\) needs nothing"):
                SCENE.plot()

    def test_of_other_kinds_are_refused(self):
        for words, arguments in [('^of: found "map"; expected one of friction, frequency, cycle', {"of": "map"}),
                                 ("^to: found a speed of -1 m/s; expected a speed above 0", {"to": -1.0}),
                                 ("^velocity: found a speed of 0 m/s", {"of": "cycle", "velocity": 0.0})]:
            with self.subTest(words), self.assertRaisesRegex(vcrit.InputError, words):
                SCENE.svg(**arguments)


class Notebooks(unittest.TestCase):
    def test_show_title_answer_and_curve(self):
        shown = ElementTree.fromstring(SCENE._repr_html_())
        texts = "".join(shown.itertext())
        self.assertIn(SCENE.title, texts)
        self.assertIn("Vibration lowers friction below 4.095 mm/s", texts)  # tests/data/scenes_expected.csv
        self.assertIn("20 kHz, 0.1 µm amplitude, 0.5 µm indentation", texts)  # the scene's own
        self.assertIn(SCENE.in_words, texts)
        self.assertIsNotNone(shown.find("{http://www.w3.org/2000/svg}svg"))

    def test_escape_titles(self):
        text = (PROJECT / ZENER).read_text().replace('title = "', 'title = "<b>&')
        self.assertIn("<b>&", "".join(ElementTree.fromstring(vcrit.Scene.from_text(text)._repr_html_()).itertext()))

    def test_say_why_there_is_no_answer(self):
        inadmissible = "".join(ElementTree.fromstring(vcrit.Scene("scenes/inadmissible.toml")._repr_html_()).itertext())
        self.assertIn("the contact would open", inadmissible)
        text = (PROJECT / ZENER).read_text().replace('"5 g"', '"m"')
        self.assertIn("no value for m", vcrit.Scene.from_text(text)._repr_html_())


class ShortTexts(unittest.TestCase):
    def test_show_units(self):
        # By tests/python/test_page.py to more digits.
        self.assertEqual(repr(SCENE.simulate("2 mm/s")),
                         "<vcrit.SteadyState at 2 mm/s (0.4884 v*): friction ratio 0.951, stick-slip>")
        self.assertIn(" at 10 m/s (", repr(SCENE.simulate(10)))
        self.assertEqual(repr(SCENE.friction_curve(["1 mm/s", "2 mm/s"]))[:58],
                         "<vcrit.FrictionCurve of 2 speeds from 1 mm/s to 2 mm/s: fr")
        self.assertEqual(repr(SCENE.critical_onset), "<vcrit.CriticalOnset: v* = 4.095 mm/s, by formula>")
        self.assertRegex(repr(SCENE.solve("velocity", 0.9)), r"^<vcrit.Solution: velocity \S+ [mµ]m/s for a friction ratio of 0.9>$")

    def test_are_of_curves_without_answers_too(self):
        self.assertEqual(repr(SCENE.friction_curve([])), "<vcrit.FrictionCurve of 0 speeds>")
        self.assertEqual(repr(SCENE.friction_curve([np.nan])), "<vcrit.FrictionCurve of 1 speeds>")
        self.assertIn("of 2 speeds from 1 mm/s to 1 mm/s",
                      repr(SCENE.friction_curve(np.ma.masked_array([1e-3, 2e-3], [False, True]))))


class AnotherPython(unittest.TestCase):
    def test_is_told_in_a_sentence(self):
        with tempfile.TemporaryDirectory() as folder:
            def why(error):
                return wrong_python.why(error, Path(folder))
            self.assertIn("build it with ./dev build", why(ImportError("no _vcrit", name="vcrit._vcrit")))
            (Path(folder) / "_vcrit.cpython-399-x86_64-linux-gnu.so").touch()
            self.assertRegex(why(ImportError("no _vcrit", name="vcrit._vcrit")),
                             r"built for Python 3\.99 \(Debian's /usr/bin/python3\); you run Python 3\.\d+ \(.*\./dev build")
            self.assertRegex(why(ModuleNotFoundError("No module named 'numpy'", name="numpy")),
                             "cannot import numpy .*apt-get install python3-numpy")


if __name__ == "__main__":
    unittest.main()
