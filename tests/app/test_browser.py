"""The report in a real browser: it opens without a network, every chart is drawn, and it can be read on a phone, in the
dark, on paper and by keyboard. tests/live moves the explorer.
"""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from browsing import PATIENCE, SHEET, browser, check_paper, draw_charts, load
from program import PROGRAM, PROJECT

SCENES = ["zener", "prony", "kelvin_rigid"]
OUTSIDE = ["inadmissible"]
MORE = ["sphere", "bridge", "tribometer"]
PHONE, NARROWEST = 390, 320  # pixels


class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="vcrit-browser-")
        cls.report = Path(cls.folder.name, "report")
        # What a compiler adds is on the page of evidence alone, and takes two thirds of the time.
        for names, place, path in [(SCENES, "", "/nowhere"), (OUTSIDE + MORE, "more", "/nowhere"),
                                   (["zener"], "compiled", os.environ["PATH"])]:
            subprocess.run([PROGRAM, "validate", *[f"scenes/{name}.toml" for name in names], "--out", cls.report / place],
                           cwd=PROJECT, env=os.environ | {"PATH": path}, check=True, capture_output=True)
        subprocess.run([PROGRAM, "validate", "--paper", "--out", cls.report / "paper"], check=True,
                       capture_output=True)
        cls.browser = browser(Path(cls.folder.name, "profile"), network=True)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def run_script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def open(self, name, draw=True):
        for kind in ["browser", "performance"]:
            self.browser.get_log(kind)  # what was left of other pages
        page = f"more/{name}" if name in OUTSIDE + MORE else name
        load(self.browser, (self.report / f"{page}.html").as_uri())
        if draw:
            draw_charts(self.browser)

    def width(self, pixels):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": pixels, "height": 800, "deviceScaleFactor": 1, "mobile": True})

    def test_all_is_drawn_without_the_network_and_nothing_goes_wrong(self):
        count = """return [...document.querySelectorAll('.chart')].map((chart) =>
            [...chart.querySelectorAll('.series path, .map path')].filter(
                (path) => (path.getAttribute('d') || '').length > 10).length)"""
        for name in [*SCENES, "index", "compiled/zener.evidence", "paper/index"]:
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
                self.assertGreaterEqual(len(marks), 0 if name == "index" else 5)
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

    def test_a_page_outside_the_model_shows_no_velocity_and_nothing_green(self):
        for name in OUTSIDE:
            self.open(name)
            self.assertNotIn("Critical speed", self.browser.find_element(By.CSS_SELECTOR, ".keys").text)
            self.browser.execute_script("document.getElementById('explorer').scrollIntoView()")
            self.browser.execute_async_script("vcrit_explorer.ready.then(arguments[0])")
            self.assertEqual(self.browser.find_element(By.ID, "explored-velocity").text, "No v*: outside the model")
            self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, ".badge.passed, .verdict.passed"), [])
            large = self.run_script("""return [...document.querySelectorAll('body *')].filter((e) =>
                parseFloat(getComputedStyle(e).fontSize) > 16 && e.children.length === 0 && e.checkVisibility() &&
                /\\d.* [nµm]?m\\/s/.test(e.textContent)).map((e) => e.textContent)""")
            self.assertEqual(large, [])
            self.assertGreater(len(self.browser.find_elements(By.CSS_SELECTOR, "#explored-messages li")), 0)
        self.open("more/index")
        for line in self.browser.find_elements(By.CSS_SELECTOR, ".scenes .outside"):
            self.assertNotIn("m/s", line.text)
            self.assertNotIn("passed", line.text)

    # On a system without a font for mathematics browsers have no glyphs for U+1D400 to U+1D7FF, as which they show a single
    # letter unless the page says otherwise.
    def check_formulas(self):
        # What innerText says is what is shown, capitals of text-transform and mathematical letters included. Words and Δ are upright.
        letters = r"""const all = [...document.querySelectorAll('math mi')];
            document.querySelectorAll('details').forEach((each) => { each.open = true; });
            const shown = [...document.body.innerText].filter((letter) => letter >= '\u{1D400}' && letter < '\u{1D800}');
            const of = (mi, name) => getComputedStyle(mi)[name];
            return [all.length, shown.length, all.filter((mi) => of(mi, 'textTransform') !== 'none').length,
                    all.filter((mi) => (of(mi, 'fontStyle') === 'italic') !== /^[^\P{L}Δ]$/u.test(mi.textContent)).map((mi) => mi.outerHTML)]"""
        scrolled = """return [...document.querySelectorAll('.scroll')].filter((e) =>
            e.scrollHeight > e.clientHeight && getComputedStyle(e).overflowY !== 'hidden' ||
            e.scrollWidth > e.clientWidth && e.scrollWidth < e.clientWidth + 3).map((e) => e.textContent)"""
        found, shown, transformed, of_other_style = self.run_script(letters)
        self.assertEqual(self.run_script(scrolled), [], "a formula has a scroll bar for nothing")
        self.assertGreater(found, 3)
        self.assertEqual((shown, transformed, of_other_style), (0, 0, []))

    def check_phone(self):
        self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), PHONE)
        lefts = self.run_script("return [...document.querySelectorAll('.explorer-parameters input[type=text]')].map("
                                "(field) => Math.round(field.getBoundingClientRect().left))")
        self.assertLessEqual(len(set(lefts)), 1, "the fields stand in one column")

    # Numbers of the answer stand side by side; a word wider than its half must not push the other out, nor a long name or path.
    def test_the_narrowest_phone_shows_all_without_scrolling_sideways(self):
        long = Path(self.folder.name, "a_folder_of_many_letters_in_one", "a_scene_of_many_letters_in_one.toml")
        long.parent.mkdir()
        # Beyond where its series was fitted: a warning that begins with the path.
        text = Path(PROJECT, "tests/matrix/kinds/fitted_beyond.toml").read_text()
        long.write_text(text)
        for kind, page in [(["validate", long, "--out"], "long"), (["explore", long, "--out"], "long/explored.html")]:
            subprocess.run([PROGRAM, *kind, self.report / page], env=os.environ | {"PATH": "/nowhere"}, check=True, capture_output=True)
        self.width(NARROWEST)
        for name in [*SCENES, *MORE, "index", "long/index", f"long/{long.stem}.evidence", "long/explored"]:
            with self.subTest(page=name):
                self.open(name)
                self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), NARROWEST)

    # Its creep is slower than the speeds that the page begins with, so there is nothing but sticking to draw.
    def test_a_contact_that_sticks_all_the_time_has_its_cycle(self):
        subprocess.run([PROGRAM, "explore", "tests/matrix/kinds/fluid.toml", "--out", self.report / "fluid.html"], cwd=PROJECT,
                       check=True, capture_output=True)
        self.open("fluid", draw=False)
        self.browser.execute_async_script("vcrit_explorer.ready.then(arguments[0])")
        self.run_script("vcrit_explorer.set({ amplitude: '0.001' })")
        self.assertIn("sticking", self.browser.find_element(By.ID, "explored-ratio").text)
        self.assertEqual(self.browser.get_log("browser"), [])

    # Loaded on a phone, and then shown on a desk.
    def test_a_phone_shows_all_without_scrolling_sideways_and_formulas_need_no_font_for_mathematics(self):
        pages = {"document": ["scenes/prony.toml", "--format", "html"], "material": ["scenes/prony.toml", "--material"], "catalogue": ["--catalogue"]}
        for name, words in pages.items():
            with open(self.report / f"{name}.html", "wb") as page:
                subprocess.run([PROGRAM, "derive", *words], cwd=PROJECT, check=True, stdout=page)
        for name in [*SCENES, *MORE, "index", "compiled/zener.evidence", "paper/index", *pages]:
            self.width(PHONE)
            with self.subTest(page=name):
                self.open(name)
                self.check_phone()
                if name != "index":  # has no formula
                    self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
                    WebDriverWait(self.browser, PATIENCE).until(lambda _: self.run_script("return innerWidth") > PHONE)
                    self.check_formulas()

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

    # The limits of its scene are wider than a sheet.
    def test_words_on_paper_can_be_read(self):
        self.open("bridge", draw=False)
        check_paper(self, self.browser)

    def test_formulas_of_other_pages_are_no_wider_than_a_sheet(self):
        for name, words in [("rheologies", ["--catalogue"]), ("material", ["--material", "scenes/burgers.toml"])]:
            with self.subTest(page=name):
                page = subprocess.run([PROGRAM, "derive", *words], cwd=PROJECT, check=True, capture_output=True).stdout
                (self.report / f"{name}.html").write_bytes(page)
                self.width(SHEET)
                self.open(name)
                # As a browser does before it lays out sheets.
                self.run_script("dispatchEvent(new Event('beforeprint'))")
                self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
                self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), SHEET)
                self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})

    def test_the_keyboard_reaches_what_can_be_used(self):
        self.open("zener")
        wanted, reached = {"skip", "field-0", "slider-0", "slider-8", "SUMMARY"}, set()
        for _ in range(120):
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
