"""The report in a real browser: it opens without a network, every chart is drawn, the explorer's numbers
are those of the C++ program, and it can be read on a phone, in the dark, on paper and by keyboard.
"""

import itertools
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from browsing import CHARTS, PATIENCE, Ruler, browser, draw_charts, load, places
from program import PROGRAM, PROJECT

SCENES = ["zener", "prony", "kelvin_rigid"]
OUTSIDE = ["inadmissible"]
MORE = ["sphere", "bridge"]

# In one question, as each takes the browser's time: the sliders' (name, values of an array, value) and v*, as text.
EXPLORED = """const { sliders } = JSON.parse(document.getElementById('explorer-data').textContent);
    const value = (id) => document.getElementById(id).dataset.value;
    return [sliders.map(({ name, array, values }, i) => [name, array ? values.map(String) : null, value(`value-${i}`)]),
        value('explored-velocity')];"""


class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="vcrit-browser-")
        cls.report = Path(cls.folder.name, "report")
        subprocess.run([PROGRAM, "validate", *[f"scenes/{name}.toml" for name in SCENES], "--out",
                        cls.report], cwd=PROJECT, check=True, capture_output=True)
        # Without a compiler it takes half the time.
        subprocess.run([PROGRAM, "validate", *[f"scenes/{name}.toml" for name in OUTSIDE + MORE], "--out",
                        cls.report / "more"], cwd=PROJECT, env=os.environ | {"PATH": "/nowhere"}, check=True,
                       capture_output=True)
        subprocess.run([PROGRAM, "validate", "--paper", "--out", cls.report / "paper"], check=True,
                       capture_output=True)
        cls.browser = browser(Path(cls.folder.name, "profile"))

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def run_script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def open(self, name):
        for kind in ["browser", "performance"]:
            self.browser.get_log(kind)  # what was left of other pages
        page = f"more/{name}" if name in OUTSIDE + MORE else name
        load(self.browser, (self.report / f"{page}.html").as_uri())
        draw_charts(self.browser)

    def width(self, pixels):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": pixels, "height": 800, "deviceScaleFactor": 1, "mobile": True})

    def test_all_is_drawn_without_the_network_and_nothing_goes_wrong(self):
        count = """return [...document.querySelectorAll('.chart')].map((chart) =>
            [...chart.querySelectorAll('.series path, .map path')].filter(
                (path) => (path.getAttribute('d') || '').length > 10).length)"""
        for name in [*SCENES, "index", "zener.evidence", "paper/index"]:
            with self.subTest(page=name):
                self.open(name)
                self.assertEqual(self.browser.get_log("browser"), [])
                messages = [json.loads(entry["message"])["message"]
                            for entry in self.browser.get_log("performance")]
                asked = [message["params"]["request"]["url"] for message in messages
                         if message["method"] == "Network.requestWillBeSent"]
                page = (self.report / f"{name}.html").as_uri()
                self.assertIn(page, asked)
                outside = [url for url in asked if url != page and not url.startswith(("data:", "blob:"))]
                self.assertEqual(outside, [])
                marks = self.run_script(count)
                self.assertGreaterEqual(len(marks), 0 if name == "index" else 7)
                self.assertTrue(all(number > 0 for number in marks), marks)

    def test_an_index_leads_to_every_page_and_back(self):
        self.open("index")
        links = [link.get_attribute("href") for link in
                 self.browser.find_elements(By.CSS_SELECTOR, ".scenes a")]
        self.assertEqual(links, [(self.report / f"{name}.html").as_uri() for name in SCENES])
        self.browser.find_element(By.CSS_SELECTOR, ".scenes a").send_keys(Keys.ENTER)
        self.assertIn("Zener", self.browser.find_element(By.CSS_SELECTOR, ".title").text)
        self.browser.find_element(By.LINK_TEXT, "All scenes").send_keys(Keys.ENTER)
        self.assertEqual(self.browser.current_url, (self.report / "index.html").as_uri())

    def evaluated(self, name, settings, what="critical_velocity"):
        """v* by the program, with parameters set to these doubles."""
        options = [word for key, value in settings.items() for word in ["--set", f"{key}={value!r}"]]
        result = subprocess.run([PROGRAM, "eval", f"scenes/{name}.toml", "--json", *options],
                                cwd=PROJECT, check=True, capture_output=True, text=True)
        return json.loads(result.stdout)[what]

    def explored(self):
        """The explorer's parameters as the program takes them, and its v*."""
        sliders, velocity = self.run_script(EXPLORED)
        settings = {}
        for name, values, text in sliders:
            value = float(text)
            if values:
                for entry, own in enumerate(values, start=1):
                    settings[f"{name}[{entry}]"] = float(own) * value
            else:
                settings[name] = value
        if "omega" in settings:  # the scenes give a frequency, for which it may be set all the same
            settings["angular_frequency"] = settings.pop("omega")
        return settings, float(velocity)

    def test_the_explorer_agrees_with_the_program(self):
        for name in SCENES:
            with self.subTest(page=name):
                self.open(name)
                sliders = self.browser.find_elements(By.CSS_SELECTOR, "#explorer input[type=range]")
                seen, own = set(), self.explored()[1]
                for number, slider in enumerate(sliders):
                    # The page draws all anew after each key.
                    keys = [Keys.ARROW_RIGHT, Keys.PAGE_UP] if number % 2 else [Keys.ARROW_LEFT, Keys.PAGE_DOWN]
                    slider.send_keys(*keys)
                    settings, velocity = self.explored()
                    expected = self.evaluated(name, settings)
                    # Each is within one unit in the last place; the program takes numbers as typed, the page doubles
                    # of them, which v* is some 10 times as sensitive to.
                    self.assertLessEqual(abs(velocity - expected), 1e-12 * expected, settings)
                    seen.add(velocity)
                self.assertGreaterEqual(len(seen), 3)  # kelvin_rigid: v* knows three of its four
                self.browser.find_element(By.ID, "explorer-reset").send_keys(Keys.ENTER)
                self.assertEqual(self.explored()[1], own)
                self.assertLessEqual(abs(own / self.evaluated(name, {}) - 1), 1e-12)

    def test_the_explorers_charts_follow(self):
        self.open("zener")
        data = json.loads(self.browser.find_element(By.ID, "explorer-data").get_attribute("textContent"))
        self.browser.find_element(By.ID, "slider-1").send_keys(Keys.ARROW_LEFT * 4)  # the amplitude
        settings, velocity = self.explored()
        self.assertLess(velocity, 0.7 * self.evaluated("zener", {}))
        response, friction = [chart for chart in self.run_script(CHARTS) if "now" in chart["legend"]]
        omegas = data["omegas"][::40]
        self.is_drawn(response, [[omega, self.evaluated("zener", {**settings, "angular_frequency": omega})]
                                 for omega in omegas])
        self.is_drawn(friction, self.run_script("return vcrit_explorer.friction()"))

    def is_drawn(self, chart, points):
        """Each of these points is one of the series named "now"."""
        x, y = (Ruler(chart[name], chart["record"][name]) for name in ["x", "y"])
        names = [series["name"] for series in chart["record"]["series"]]
        line = places("line", chart["series"][names.index("now")])
        self.assertGreater(len(points), 3)
        for value_x, value_y in points:
            self.assertTrue(any(abs(at_x - x.place(value_x)) < Ruler.EXACT and abs(at_y - y.place(value_y)) < Ruler.EXACT
                                for _, at_x, at_y in line), (value_x, value_y))

    def warnings(self):
        return [item.text for item in self.browser.find_elements(By.CSS_SELECTOR, "#explored-warnings li")]

    def slide(self, number, value, alone=False):
        """Moves one slider; `alone`: from where all others are at rest."""
        self.run_script("""const slider = document.getElementById(`slider-${arguments[0]}`);
            if (arguments[2])
                for (const other of document.querySelectorAll("#explorer input[type=range]")) other.value = 0;
            slider.value = arguments[1];
            slider.dispatchEvent(new Event("input"));""", number, value, alone)

    def slider_of(self, name):
        data = json.loads(self.browser.find_element(By.ID, "explorer-data").get_attribute("textContent"))
        return next(n for n, slider in enumerate(data["sliders"]) if slider["name"] == name)

    # Each reason, and that the curve is missing, has a line of its own; no speed is shown.
    def test_the_explorer_says_all_that_is_wrong_at_once(self):
        self.open("zener")
        self.assertEqual(self.warnings(), [])
        amplitude, mass = self.slider_of("du_z"), self.slider_of("m")
        self.slide(mass, 0.5)
        self.assertEqual(self.warnings(), ["No friction curve: it was simulated for the scene’s own elements."])
        self.assertEqual(self.run_script("return vcrit_explorer.friction().length"), 0)
        shown = self.browser.find_element(By.ID, "explored-velocity")
        self.assertIn("/s", shown.text)
        self.slide(amplitude, 0.7)
        words = self.warnings()
        self.assertEqual(len(words), 3)
        for line, part in zip(words, ["below the indentation (3)", "the contact would open (4)", "No friction curve"]):
            self.assertIn(part, line)
        self.assertEqual(shown.text, "No v*: outside the model")
        self.assertFalse(self.browser.find_element(By.ID, "explored-label").is_displayed())
        self.browser.find_element(By.ID, "explorer-reset").send_keys(Keys.ENTER)
        self.assertEqual(self.warnings(), [])
        self.assertTrue(self.browser.find_element(By.ID, "explored-label").is_displayed())

    # Whatever parameter moves: the page calls outside the model what the program calls not admissible, among it
    # scenes without a friction curve, as below an indenter, and elements that v* does not know.
    def test_the_explorer_knows_what_is_admissible(self):
        for name in [*SCENES, *OUTSIDE, *MORE]:
            self.open(name)
            sliders = self.browser.find_elements(By.CSS_SELECTOR, "#explorer input[type=range]")
            seen = set()
            for number, value in itertools.product(range(len(sliders)), [-2, -0.6, 0.6, 2]):
                self.slide(number, value, alone=True)
                settings, _ = self.explored()
                inside = self.evaluated(name, settings, "admissible")
                with self.subTest(page=name, settings=settings):
                    self.assertEqual([words for words in self.warnings() if "Outside" in words] == [], inside)
                seen.add(inside)
            self.assertEqual(seen, {True, False}, name)

    def test_two_curves_can_be_told_apart_where_they_are_one(self):
        self.open("kelvin_rigid")
        looks = """return [...document.querySelectorAll('.explored-chart')].map((chart) =>
            ['now', 'this scene'].map((name) => {
                const path = chart.querySelector(`.series path[data-name="${name}"]`), style = getComputedStyle(path);
                const place = [...path.parentNode.children].indexOf(path);
                return [style.stroke, style.strokeDasharray, parseFloat(style.strokeWidth), place, path.getAttribute('d')];
            }))"""
        charts = self.run_script(looks)
        self.assertEqual(len(charts), 2)
        for now, own in charts:
            self.assertNotEqual(now[0], own[0])
            self.assertEqual(now[1], "none")
            self.assertRegex(own[1], r"\d")
            # The dashed one is the thinner and on top, or it would hide the other one or be hidden.
            self.assertGreater(now[2], 2 * own[2])
            self.assertLess(now[3], own[3])
            self.assertTrue(now[4])
        for chart in self.run_script(CHARTS):
            if "now" in chart["legend"]:
                self.assertIn("this scene", chart["legend"])

    def test_a_page_outside_the_model_shows_no_velocity_and_nothing_green(self):
        for name in OUTSIDE:
            self.open(name)
            self.assertNotIn("Critical speed", self.browser.find_element(By.CSS_SELECTOR, ".keys").text)
            self.assertEqual(self.browser.find_element(By.ID, "explored-velocity").text, "No v*: outside the model")
            self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, ".badge.passed, .verdict.passed"), [])
            large = self.run_script("""return [...document.querySelectorAll('body *')].filter((e) =>
                parseFloat(getComputedStyle(e).fontSize) > 16 && e.children.length === 0 && e.checkVisibility() &&
                /\\d.* [nµm]?m\\/s/.test(e.textContent)).map((e) => e.textContent)""")
            self.assertEqual(large, [])
            self.assertGreater(len(self.warnings()), 0)
        self.open("more/index")
        for line in self.browser.find_elements(By.CSS_SELECTOR, ".scenes .outside"):
            self.assertNotIn("m/s", line.text)
            self.assertNotIn("passed", line.text)

    # The simulator's friction at the scene's own speed and amplitude, read from the page's curve.
    def test_the_explorers_friction_is_the_simulators(self):
        self.open("kelvin_rigid")
        self.browser.find_element(By.ID, "slider-1").send_keys(Keys.ARROW_LEFT * 6)
        settings, _ = self.explored()
        data = json.loads(self.browser.find_element(By.ID, "explorer-data").get_attribute("textContent"))
        column = data["grid"]["ratios"].index(0.5)
        shown = self.run_script("""return new Promise((done) => requestAnimationFrame(() => done(
            vcrit_explorer.friction()[arguments[0]][1])))""", column)
        options = [word for key, value in settings.items() for word in ["--set", f"{key}={value!r}"]]
        result = subprocess.run([PROGRAM, "simulate", "scenes/kelvin_rigid.toml", "--velocity-ratio", "0.5",
                                 "--json", *options], cwd=PROJECT, check=True, capture_output=True, text=True)
        # Each steady value is promised to 1e-9, and that of the grid is scaled by less than 1.
        self.assertLessEqual(abs(shown - json.loads(result.stdout)["friction_ratio"]), 2e-9)

    def test_a_phone_shows_all_without_scrolling_sideways(self):
        self.width(390)
        for name in [*SCENES, "index", "zener.evidence", "paper/index"]:
            with self.subTest(page=name):
                self.open(name)
                self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), 390)

    def brightness(self, selector, style):
        rgb = self.run_script("return getComputedStyle(document.querySelector(arguments[0]))[arguments[1]]",
                              selector, style)
        return sum(float(part) for part in rgb[rgb.index("(") + 1:-1].split(",")[:3]) / 765

    def test_dark_and_light(self):
        self.open("zener")
        for scheme, dark in [("light", False), ("dark", True)]:
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                "features": [{"name": "prefers-color-scheme", "value": scheme}]})
            paper, ink = self.brightness("body", "backgroundColor"), self.brightness("body", "color")
            self.assertGreater(abs(paper - ink), 0.7)
            self.assertEqual(paper < 0.2, dark)
            labels = self.brightness(".chart .axis text", "fill")
            self.assertGreater(abs(paper - labels), 0.5)

    def test_on_paper_what_cannot_be_moved_is_left_out(self):
        self.open("zener")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        hidden = "return getComputedStyle(document.querySelector(arguments[0])).display === 'none'"
        for selector in ["#explorer", "button.copy", ".skip", ".save"]:
            self.assertTrue(self.run_script(hidden, selector), selector)
        self.assertFalse(self.run_script(hidden, ".chart"))
        folded = "return document.querySelectorAll('details:not([open]):not(.latex):not(.data):not(.save):not(.derivation):not(.screen)').length"
        self.run_script("document.querySelector('details:not(.latex):not(.data):not(.save):not(.derivation):not(.screen)').open = false")
        before = self.run_script(folded)
        self.assertGreater(before, 0)
        self.run_script("dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.run_script(folded), 0)
        self.run_script("dispatchEvent(new Event('afterprint'))")
        self.assertEqual(self.run_script(folded), before)
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})

    def test_the_keyboard_reaches_what_can_be_used(self):
        self.open("zener")
        wanted, reached = {"skip", "slider-0", "slider-8", "explorer-reset", "SUMMARY"}, set()
        for _ in range(60):
            self.browser.switch_to.active_element.send_keys(Keys.TAB)
            reached.add(self.run_script("""const e = document.activeElement;
                return e.id || e.className || e.tagName"""))
            if wanted <= reached:
                break
        self.assertEqual(wanted - reached, set())

    def test_a_formula_can_be_copied(self):
        self.open("zener")
        self.browser.find_element(By.CSS_SELECTOR, ".latex summary").send_keys(Keys.ENTER)
        button = self.browser.find_element(By.CSS_SELECTOR, "button.copy")
        button.send_keys(Keys.ENTER)
        WebDriverWait(self.browser, PATIENCE).until(lambda _: button.text in ["Copied", "Selected"])


if __name__ == "__main__":
    os.environ.setdefault("HOME", tempfile.gettempdir())
    unittest.main(verbosity=2)
