"""The report's pages as a reader meets them: the answer on the first screen, pages that are short on a screen, a phone
and on paper, no speed where there is none, and a failed check above everything.
"""

import base64
import itertools
import json
import math
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from browsing import CHARTS, PATIENCE, browser, check_paper, draw_charts, load
from program import PROGRAM, PROJECT

SCENES = ["zener", "inadmissible", "sonotrode", "burgers"]
# With a mount, a drive and loss of contact: of all pages the one with most on it.
FULL = "tests/matrix/kinds/separation_mount.toml"
# v* has no digits to compare: the body of the first does not move, so that there is friction to simulate, and in the second,
# next to a resonance, there is none.
STILL, RINGING = (f"tests/matrix/kinds/{kind}.toml" for kind in ["drive_absorber", "near_resonance"])
PHONE, DESK = 390, 1200  # pixels

# Words that stand on a curve of a chart; how many words there are, and how many rules.
ON_CURVES = """
    const svg = document.getElementById(arguments[0]).querySelector('.chart > svg'), found = [];
    const texts = [...svg.querySelectorAll('.words text')].map((text) => [text.textContent, text.getBoundingClientRect()]);
    for (const path of svg.querySelectorAll('.series path')) {
        const place = path.getScreenCTM();
        for (let at = 0; at < path.getTotalLength(); at += 2) {
            const { x, y } = path.getPointAtLength(at).matrixTransform(place);
            for (const [words, box] of texts)
                if (x > box.left + 2 && x < box.right - 2 && y > box.top + 3 && y < box.bottom - 4) found.push(words);
        }
    }
    return [[...new Set(found)], texts.length, svg.querySelectorAll('.rule').length];"""

# A compiler that compiles nothing: what it should have compiled is a check that failed.
BROKEN_COMPILER = "#!/bin/sh\necho broken >&2\nexit 1\n"


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="vcrit-pages-")
        cls.report = Path(cls.folder.name, "report")
        compiler = Path(cls.folder.name, "bin/g++")
        compiler.parent.mkdir()
        compiler.write_text(BROKEN_COMPILER)
        compiler.chmod(0o755)
        scenes = [f"scenes/{name}.toml" for name in SCENES]
        cls.validate([*scenes, FULL], cls.report, "/nowhere", 0)
        cls.validate([STILL, RINGING], cls.report / "lost", "/nowhere", 0)
        cls.validate(["scenes/elastic.toml"], cls.report / "failed", f"{compiler.parent}:/usr/bin:/bin", 1)
        cls.browser = browser(Path(cls.folder.name, "profile"))
        cls.own_tab, cls.visited = cls.browser.current_window_handle, {}

    @classmethod
    def validate(cls, scenes, out, path, status):
        result = subprocess.run([PROGRAM, "validate", *scenes, "--out", out],
                                cwd=PROJECT, env=os.environ | {"PATH": path}, capture_output=True, text=True)
        if result.returncode != status:
            raise AssertionError(f"status {result.returncode}: {result.stderr}")

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def test_a_chart_of_friction_has_its_curve_or_is_not_there(self):
        report = json.loads((self.report / "lost/report.json").read_text())
        curves = {scene["file"]: scene.get("friction_curve", []) for scene in report["scenes"]}
        simulated = json.loads(subprocess.run([PROGRAM, "simulate", STILL, "--velocity-ratio", "0.5", "--json"], cwd=PROJECT,
                                              check=True, capture_output=True, text=True).stdout)
        half = min(curves[STILL], key=lambda point: abs(point["velocity_ratio"] - 0.5))
        self.assertEqual(half["velocity_ratio"], 0.5)
        self.assertAlmostEqual(half["friction_ratio"], simulated["friction_ratio"], delta=2e-9)
        self.assertEqual(curves[RINGING], [])
        pages = [(self.report / f"lost/{Path(scene).stem}.html").read_text() for scene in [STILL, RINGING]]
        self.assertEqual(["friction_over_speed" in re.sub("(?s)<script>.*?</script>", "", page) for page in pages], [True, False])

    def test_sensitivities_are_those_of_derive(self):
        report = json.loads((self.report / "report.json").read_text())
        for scene in report["scenes"]:
            if "influences" not in scene:
                continue
            printed = subprocess.run([PROGRAM, "derive", scene["file"], "--sensitivities"], cwd=PROJECT, check=True,
                                     capture_output=True, text=True).stdout
            listed = printed.split("per cent in v* for one per cent in the parameter:\n")[1].strip("\n").splitlines()
            found = [each["name"] for each in scene["influences"]]
            self.assertEqual(sorted(found), sorted(line.split()[0] for line in listed), scene["file"])
            self.assertTrue("poisson" in found or scene["file"] == "scenes/burgers.toml", found)

    def load(self, page, width, draw):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 600})
        self.browser.get_log("browser")  # what was left of other pages
        load(self.browser, (self.report / f"{page}.html").as_uri())
        if draw:
            draw_charts(self.browser)

    def front(self, tab):
        self.browser.switch_to.window(tab)
        self.browser.execute_cdp_cmd("Page.bringToFront", {})

    def open(self, page, width=DESK, draw=True):
        """Afresh, for a test that moves something."""
        self.front(self.own_tab)
        self.load(page, width, draw)

    def visit(self, page, width=DESK):
        """In a tab for all tests that only look at it; what the browser complained of when it was loaded."""
        if (page, width) not in self.visited:
            self.browser.switch_to.new_window("tab")
            self.load(page, width, True)
            self.visited[page, width] = self.browser.current_window_handle, self.browser.get_log("browser")
        tab, complaints = self.visited[page, width]
        self.front(tab)
        return complaints

    def height(self):
        return self.script("return document.documentElement.scrollHeight")

    def text(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector).text

    # At most 4500 and 6500 pixels, and nothing scrolls sideways.
    def test_a_page_is_short(self):
        for page, width, most in [("zener", DESK, 4500), ("zener", PHONE, 6500), ("inadmissible", DESK, 4500),
                                  ("sonotrode", DESK, 4500), ("index", DESK, 900)]:
            with self.subTest(page=page, width=width):
                complaints = self.visit(page, width)
                self.assertLessEqual(self.height(), most)
                self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), width)
                self.assertEqual(complaints, [])

    def test_the_first_screen_has_the_answer(self):
        self.open("zener", draw=False)
        self.assertEqual(self.text("h1"), "Vibration lowers friction below 4.095 mm/s, by at most 25 %.")
        for selector in ["h1", ".operating", "#friction_over_speed svg", ".system svg", ".keys", ".sure"]:
            with self.subTest(selector=selector):
                bottom = self.script("return document.querySelector(arguments[0]).getBoundingClientRect().bottom", selector)
                self.assertLessEqual(bottom, 800)
        self.assertIn("10 % in", self.text(".sure"))
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".keys > div")), 5)

    def test_the_answer_needs_no_script(self):
        page = (self.report / "zener.html").read_text()
        body = re.sub(r"<script.*?</script>", "", page, flags=re.S)
        self.assertIn('<svg class="still"', body)
        self.assertIn('<svg class="drawing"', body)
        self.assertLess(len(page.encode()), 2_000_000)

    def test_friction_is_also_in_newtons(self):
        program = [PROGRAM, "simulate", PROJECT / "scenes/zener.toml", "--velocity-ratio", "1.05", "--json"]
        sliding = json.loads(subprocess.run(program, check=True, capture_output=True, text=True).stdout)
        force = sliding["energy"]["drive"] * 20e3 / sliding["velocity"]  # work of a period over its way
        for width, drawn in [(DESK, True), (PHONE, False)]:  # no room for it on a phone
            self.visit("zener", width)
            chart = next(chart for chart in self.script(CHARTS) if "right" in chart["record"])
            self.assertEqual(chart["right"] != [], drawn)
            y, newtons = chart["record"]["y"], chart["record"]["right"]
            self.assertEqual(newtons["title"], "mean friction force, N")
            self.assertAlmostEqual(newtons["range"][1] / y["range"][1], force, delta=1e-5)  # six digits of a record

    def test_words_of_resonances_keep_off_the_curve(self):
        for page in ("zener", "sonotrode"):
            for width in (DESK, PHONE):
                self.visit(page, width)
                with self.subTest(page=page, width=width):
                    crossed, words, rules = self.script(ON_CURVES, "critical_velocity")
                    self.assertEqual(crossed, [])
                    self.assertEqual(words, rules)

    def test_words_of_shades_keep_off_the_curve(self):
        for page, width in itertools.product(("zener", "sonotrode", "burgers"), (DESK, PHONE)):
            self.visit(page, width)
            for chart in ("friction_over_speed", "cycle_force", "cycle_velocity"):
                with self.subTest(page=page, width=width, chart=chart):
                    crossed, words, _ = self.script(ON_CURVES, chart)
                    self.assertEqual(crossed, [])
                    self.assertGreaterEqual(words, 1)

    # From v* and the creep on the drive slides; v* alone is a speed of the contact point.
    def test_speeds_of_a_path_that_creeps_are_those_of_the_drive(self):
        self.visit("burgers")
        self.assertIn("half of (v* + creep)", self.text("#cycle"))
        self.assertIn("Above v* + creep vibration changes nothing", self.text("#answer"))

    def test_storage_and_loss_are_told_apart_without_colour(self):
        self.visit("zener")
        records = [chart["record"] for chart in self.script(CHARTS)]
        series = next(each for each in records if each["name"] == "stiffness")["series"]
        dashes = {each["name"]: each["dashes"] for each in series}
        self.assertEqual(len(dashes), 5)
        self.assertFalse({dashes[name] for name in dashes if name.endswith("storage")} &
                         {dashes[name] for name in dashes if name.endswith("loss")})

    # A map is light in the dark, too.
    def test_lines_on_a_map_are_dark(self):
        strokes = """return [...document.querySelectorAll('.map ~ .series path:not(.edge)')].map((path) =>
            getComputedStyle(path).stroke)"""
        for scheme in ("light", "dark"):
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
                {"name": "prefers-color-scheme", "value": scheme}]})
            self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.setEmulatedMedia", {"features": []})
            self.open("zener.evidence")
            found = set(self.script(strokes))
            self.assertLessEqual({"rgb(179, 38, 30)", "rgb(29, 33, 38)"}, found)  # resonance, antiresonance
            self.assertNotIn("rgb(228, 231, 234)", found)

    def test_words_of_a_drawing_can_be_read(self):
        smallest = """return Math.min(...[...document.querySelectorAll('.system text')].map((text) =>
            text.getScreenCTM().a * parseFloat(getComputedStyle(text).fontSize)))"""
        for page, width in itertools.product([*SCENES, "separation_mount"], (PHONE, DESK)):
            self.visit(page, width)
            with self.subTest(page=page, width=width):
                self.assertGreaterEqual(self.script(smallest), 11)

    # Two sheets, on which the chart and the formula are; the explorer is not.
    def test_two_sheets_of_paper(self):
        for page in [*SCENES, "separation_mount"]:
            self.visit(page)
            pdf = base64.b64decode(self.browser.execute_cdp_cmd("Page.printToPDF", {
                "printBackground": True, "preferCSSPageSize": True})["data"])
            self.assertLessEqual(len(re.findall(rb"/Type\s*/Page[^s]", pdf)), 2, page)

    def test_words_on_paper_can_be_read(self):
        for page in [*SCENES, "separation_mount"]:
            with self.subTest(page=page):
                self.open(page, draw=False)
                check_paper(self, self.browser)

    def test_one_cycle_has_a_slider(self):
        self.open("zener")
        slider, instant = (self.browser.find_element(By.ID, name) for name in ("cycle-time", "cycle-instant"))
        play = self.browser.find_element(By.ID, "cycle-play")
        cursors = "return [...document.querySelectorAll('#cycle .cursor')].map((path) => path.getAttribute('d'))"
        move = "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input'))"
        motion = json.loads(subprocess.run([PROGRAM, "simulate", PROJECT / "scenes/zener.toml", "--velocity-ratio", "0.5", "--json"],
                                           check=True, capture_output=True, text=True).stdout)
        phases = {event["to"]: event["phase"] / (2 * math.pi) for event in motion["events"]}
        sliding = (phases["slip"] + phases["stick"]) / 2
        places = set()
        for part, sticks in [(sliding, False), (phases["stick"] + 0.01, True), (0.999, True)]:
            self.script(move, slider, 1000 * part)
            self.assertRegex(instant.text, rf"^{50 * round(part, 3):.3g} µs: tangential force [\d.]+ N, contact speed [\d.]+ mm/s")
            self.assertEqual(instant.text.endswith(", sticks"), sticks)
            self.assertEqual("contact speed 0 mm/s" in instant.text, sticks)
            self.assertEqual(slider.get_attribute("aria-valuetext"), instant.text)
            places.add(tuple(self.script(cursors)))
        self.assertEqual([len(place) for place in places], [2, 2, 2])
        before = instant.text
        self.script("arguments[0].click()", play)
        WebDriverWait(self.browser, PATIENCE).until(lambda _: instant.text != before)
        self.assertEqual(play.text, "Pause")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-reduced-motion", "value": "reduce"}]})
        self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.setEmulatedMedia", {"features": []})
        WebDriverWait(self.browser, PATIENCE).until(lambda _: not play.is_displayed())
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_outside_the_model_there_is_no_speed_and_nothing_green(self):
        self.visit("inadmissible")
        self.assertRegex(self.text("h1"), "^No answer")
        large = self.script("""return [...document.querySelectorAll('body *')].filter((e) => e.children.length === 0 &&
            parseFloat(getComputedStyle(e).fontSize) > 16 && e.checkVisibility() && /\\d.* [nµm]?m\\/s/.test(e.textContent))
            .map((e) => e.textContent)""")
        self.assertEqual(large, [])
        green = self.script("""const probe = document.createElement('i');
            probe.style.color = 'var(--good)';
            document.body.append(probe);
            const good = getComputedStyle(probe).color;
            probe.remove();
            return [...document.querySelectorAll('main *')].filter((e) => getComputedStyle(e).color === good)
                .map((e) => e.outerHTML.slice(0, 60))""")
        self.assertEqual(green, [])
        self.assertEqual(len(self.browser.find_elements(By.ID, "normal_force")), 1)
        self.assertEqual(self.browser.find_elements(By.ID, "friction_over_speed"), [])
        self.assertIn("Stays closed up to\n0.2236 µm\nnow 0.36 µm", self.text(".keys"))

    def test_a_failed_check_is_red_above_everything(self):
        self.open("failed/index")
        banner = self.browser.find_element(By.CSS_SELECTOR, ".failed-checks")
        self.assertRegex(banner.text, r"^Do not use these numbers: 1 of \d+ checks failed\.")
        self.assertIn("generated C++ code", banner.text)
        above = "return arguments[0].getBoundingClientRect().bottom < document.querySelector('h1').getBoundingClientRect().top"
        self.assertTrue(self.script(above, banner))
        red, green, blue = [int(part) for part in re.findall(r"\d+", banner.value_of_css_property("color"))[:3]]
        self.assertGreater(red, 2 * max(green, blue))
        banner.find_element(By.TAG_NAME, "a").click()
        self.assertIn("elastic.evidence.html", self.browser.current_url)
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".claims .badge.failed")), 1)
        self.visit("zener")
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, ".failed-checks"), [])

    def test_the_index_says_what_came_out(self):
        self.visit("index")
        self.assertEqual(self.text("h1"), "5 scenes. 4 answered, 1 outside the model, 0 checks failed.")
        self.assertIn("Friction is lower below", self.text(".columns"))
        lines = self.browser.find_elements(By.CSS_SELECTOR, ".scenes > li")
        for line, parts in zip(lines, [["zener.toml", "4.095 mm/s", "−25 %", "20 kHz"],
                                       ["inadmissible.toml", "would open above"], ["sonotrode.toml", "4.65 mm/s"]]):
            for part in parts:
                self.assertIn(part, line.text)
        # From 0.748 at rest up to the top, which is full friction.
        points = re.findall(r"([\d.]+) ([\d.]+)", lines[0].find_elements(By.CSS_SELECTOR, ".spark path")[1].get_attribute("d"))
        self.assertAlmostEqual(float(points[0][1]), 4 + 22 * (1 - 0.748), delta=0.1)
        self.assertAlmostEqual(float(points[-1][1]), 4, delta=0.05)
        self.assertEqual(len(lines[1].find_elements(By.CSS_SELECTOR, ".spark path")), 1)

    def test_the_index_can_be_filtered(self):
        self.open("index")
        shown = "return [...document.querySelectorAll('.scenes > li')].filter((e) => e.checkVisibility()).length"
        field = self.browser.find_element(By.ID, "filter")
        for typed, left in [("ZENER", 1), ("", 5), (".toml", 5), ("nothing of that name", 0)]:
            field.clear()
            field.send_keys(typed)
            self.script("document.getElementById('filter').dispatchEvent(new Event('input'))")
            self.assertEqual(self.script(shown), left)
        self.assertTrue(self.browser.find_element(By.ID, "none-left").is_displayed())

    def test_evidence_is_one_click_away(self):
        self.open("zener")
        self.browser.find_element(By.CSS_SELECTOR, ".sure a").click()
        self.assertIn("v* from the formula = v* from stick-slip simulation", self.text(".claims"))
        self.assertIn("not independent:", self.text(".claims"))
        # A map that shows nothing is a sentence.
        self.open("failed/elastic.evidence")
        self.assertIn("no digit lost in 768 cells", self.text("main"))

    # All pages are of one folder, whatever they show.
    def test_links_lead_somewhere(self):
        for page in self.report.glob("*.html"):
            for link in re.findall(r'href="([^#"]+)"', page.read_text()):
                self.assertTrue((self.report / link).exists(), (page.name, link))


if __name__ == "__main__":
    os.environ.setdefault("HOME", tempfile.gettempdir())
    unittest.main(verbosity=2)
