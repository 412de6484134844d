"""The charts of the report's pages in a real browser: what is drawn is what their records say."""

import itertools
import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from browsing import CHARTS, PATIENCE, Ruler, browser, draw_charts, lightness, load, number, places
from program import PROGRAM, PROJECT

PAGES = ["zener", "separation", "zener.evidence", "paper/index"]
MARKS = ["circles", "dots", "crosses", "squares", "triangles", "diamonds"]
HOSTILE = "</script><img src=x onerror=window.hostile=1> & \"it's\""


def axis(title, logarithmic=False, **more):
    return {"title": title, "logarithmic": logarithmic, **more}


def line(points, name="line", style="line", **more):
    return {"name": name, "style": style, "colour": "#2090ad", "points": points, **more}


def figure(**parts):
    return {"name": "planted", "title": "Planted", "height": 200, "x": axis("x", range=[0, 10]),
            "y": axis("y", range=[0, 1]), "bands": [], "series": [], "rules": [], **parts}


def rule(at, words, horizontal=False):
    return {"at": at, "horizontal": horizontal, "colour": "#8a8f98", "words": words}


class Charts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="vcrit-charts-")
        cls.report = Path(cls.folder.name, "report")
        # Without a compiler it takes half the time.
        environment = os.environ | {"PATH": "/nowhere"}
        for what, out in [(["scenes/zener.toml", "scenes/separation.toml"], cls.report),
                          (["--paper"], cls.report / "paper")]:
            subprocess.run([PROGRAM, "validate", *what, "--out", out], cwd=PROJECT, env=environment, check=True,
                           capture_output=True)
        cls.browser = browser(Path(cls.folder.name, "profile"))

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def setUp(self):
        self.width(1200)

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait(self, text):
        WebDriverWait(self.browser, PATIENCE).until(lambda _: self.script(f"return {text}"))

    def load(self, page):
        self.browser.get_log("browser")  # what was left of other pages
        load(self.browser, (self.report / f"{page}.html").as_uri())

    def open(self, page):
        self.load(page)
        draw_charts(self.browser)
        return self.script(CHARTS)

    def width(self, pixels):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": pixels, "height": 900, "deviceScaleFactor": 1, "mobile": False})

    def plant(self, record):
        """A chart of its own at the begin of the page."""
        if self.script("return document.getElementById('planted')") is None:
            self.load("zener")
        else:
            self.script("document.getElementById('planted').remove()")
        self.script("""const chart = document.createElement('div');
            chart.className = 'chart';
            chart.id = 'planted';
            chart.record = arguments[0];
            document.querySelector('main').prepend(chart);
            vcrit_charts.show(chart, arguments[0]);
            chart.scrollIntoView({ block: 'center', behavior: 'instant' });""", record)
        self.wait("document.querySelector('#planted svg')")
        self.script("document.querySelectorAll('.chart:not(#planted)').forEach((chart) => chart.remove())")
        return self.script(CHARTS)[0]

    def words(self, ticks):
        return [tick["words"] for tick in ticks if tick["words"]]

    # The axes' words say where each value lies; a point must lie there.
    def check_axis(self, ticks, axis):
        ruler = Ruler(ticks, axis)
        self.assertGreaterEqual(len(ruler.named), 2)
        for value, at in ruler.named:
            self.assertAlmostEqual(ruler.place(value), at, delta=Ruler.EXACT)
        return ruler

    def check_series(self, chart, x, y, series, path):
        marks = series["style"] in MARKS
        expected, begins = [], True
        for value_x, value_y, *_ in series["points"]:
            if value_x is None or value_y is None:
                begins = True
                continue
            at = (x.place(value_x), y.place(value_y))
            beyond = not (-1 <= at[0] <= chart["inner"] + 1 and -1 <= at[1] <= chart["record"]["height"] + 1)
            if not (marks and beyond):
                expected.append((begins or marks, *at))
            begins = False
        found = places(series["style"], path)
        self.assertEqual([begin for begin, *_ in found], [begin for begin, *_ in expected])
        for (_, *at), (_, *right) in zip(found, expected):
            self.assertAlmostEqual(at[0], right[0], delta=Ruler.EXACT)
            self.assertAlmostEqual(at[1], right[1], delta=Ruler.EXACT)

    def check_map(self, chart, x, y):
        cells = {}
        for colour, path in chart["map"]:
            for left, low, right, high in re.findall(r"M([-\d.]+) ([-\d.]+)H([-\d.]+)V([-\d.]+)H[-\d.]+Z", path):
                cells[float(left), float(low), float(right), float(high)] = colour
        record = chart["record"]["map"]
        columns = len(record["x"]) - 1
        expected = [n for n, value in enumerate(record["values"]) if value is not None]
        self.assertEqual(len(cells), len(expected))
        by_place = {}
        for cell, colour in cells.items():
            by_place.setdefault((round(cell[0]), round(cell[1])), []).append((cell, colour))
        by_value = {}
        for n in expected:
            row, column = divmod(n, columns)
            right = (x.place(record["x"][column]), y.place(record["y"][row]),
                     x.place(record["x"][column + 1]), y.place(record["y"][row + 1]))
            # Ruler.EXACT is below a pixel: the cell's corner lies in this bucket or in one beside it.
            left, low = round(right[0]), round(right[1])
            beside = itertools.chain.from_iterable(
                by_place.get(bucket, []) for bucket in itertools.product((left - 1, left, left + 1), (low - 1, low, low + 1)))
            near = [colour for cell, colour in beside
                    if max(abs(a - b) for a, b in zip(cell, right)) <= Ruler.EXACT]
            self.assertEqual(len(near), 1)
            self.assertEqual(by_value.setdefault(record["values"][n], near[0]), near[0])
        if "colours" in record:
            self.assertEqual(by_value, {at: colour for (at, _), colour in
                                        zip(record["value"]["ticks"], record["colours"]) if at in by_value})
        else:  # from light to dark
            light = [lightness(by_value[value]) for value in sorted(by_value)]
            self.assertEqual(light, sorted(light, reverse=True))

    def check(self, chart):
        record = chart["record"]
        axes = [axis for axis in ("x", "y", "right") if axis in record]
        x, y, *_ = [self.check_axis(chart[axis], record[axis]) for axis in axes]
        self.assertEqual(chart["titles"], [record[axis]["title"] for axis in axes])
        names = [words for _, words in record.get("map", {}).get("value", {}).get("ticks", [])]
        names += [series["name"] for series in record["series"] if series["name"]]
        self.assertEqual(chart["legend"], list(dict.fromkeys(names)))
        self.assertEqual(len(chart["series"]), len(record["series"]))
        for series, path in zip(record["series"], chart["series"]):
            if series["style"] != "bars":
                self.check_series(chart, x, y, series, path)
        if "map" in record:
            self.check_map(chart, x, y)

    def test_what_is_drawn_is_what_the_records_say(self):
        for page in PAGES:
            charts = self.open(page)
            self.assertGreaterEqual(len(charts), 5)
            for chart in charts:
                with self.subTest(page=page, chart=chart["record"]["name"]):
                    self.check(chart)
            self.assertEqual(self.browser.get_log("browser"), [])

    def test_ticks(self):
        for record, x, y in [
                (figure(x=axis("x", True, range=[1e-4, 1e4]), y=axis("y", range=[0, 1.05])),
                 ["10⁻⁴", "0.001", "0.01", "0.1", "1", "10", "100", "1000", "10⁴"],
                 ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
                (figure(x=axis("x", range=[-1, 1]), y=axis("y", True, range=[2e4, 9e4])),
                 ["−1.0", "−0.8", "−0.6", "−0.4", "−0.2", "0.0", "0.2", "0.4", "0.6", "0.8", "1.0"],
                 ["2·10⁴", "3·10⁴", "4·10⁴", "5·10⁴", "6·10⁴", "7·10⁴", "8·10⁴", "9·10⁴"]),
                # What the data need, to whole steps: by powers of ten, by ones.
                (figure(x=axis("x", True), y=axis("y"), series=[line([[2e-7, 0.3], [5e-5, 3.7]])]),
                 ["10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴"], ["0", "1", "2", "3", "4"]),
                (figure(x=axis("x", ticks=[[1, "one"], [2, HOSTILE], [70, "beyond"]], range=[0, 10])),
                 ["one"], ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
                (figure(series=[line([])], x=axis("x"), y=axis("y", True)), None, ["1", "2", "5", "10"])]:
            chart = self.plant(record)
            if x:
                self.assertEqual(self.words(chart["x"])[:len(x)], x)
            self.assertEqual(self.words(chart["y"]), y)
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_gaps_and_points_beyond_the_frame(self):
        points = [[0, 0.5], [1, None], [2, 0.5], [3, 0.7], [None, 0.1], [4, 1.5], [5, 0.2], [12, 0.2]]
        record = figure(series=[line(points, style, style) for style in
                                ["line", "dashed", "dotted", *MARKS]])
        chart = self.plant(record)
        self.check(chart)
        self.assertEqual([path.count("M") for path in chart["series"][:3]], [3, 3, 3])
        self.assertEqual([len(places(name, path)) for name, path in zip(chart["legend"], chart["series"])][3:], [4] * len(MARKS))

    def test_bars(self):
        chart = self.plant(figure(series=[line([[1, 0.2], [3, None], [4, 0.8]], style="bars", edges=[0, 2, 3.5, 5])]))
        x, y = Ruler(chart["x"], axis("x")), Ruler(chart["y"], axis("y"))
        found = [[float(part) for part in bar] for bar in
                 re.findall(r"M([\d.]+) ([\d.]+)V([\d.]+)H([\d.]+)V([\d.]+)Z", chart["series"][0])]
        expected = [[x.place(low), 200, y.place(top), x.place(high), 200] for low, top, high in [(0, .2, 2), (3.5, .8, 5)]]
        self.assertEqual(len(found), len(expected))
        for bar, right in zip(found, expected):
            for part, own in zip(bar, right):
                self.assertAlmostEqual(part, own, delta=Ruler.EXACT)

    # From 0 each step is twice the one before, so that the first lost digit is seen; others are even. Lightness from 95 to 20
    # in six steps is 15 a step, and 2 of CIE L* are the least that eyes tell apart.
    def test_a_map(self):
        digits = [0, 0.4, 0.6, 1.5, 3, 7, 9, 16, None]
        for value, values, steps, bounds in [
                (axis("v", range=[0, 16]), digits, [0, 0, 1, 2, 3, 4, 5, 5], ["0", "0.5", "1", "2", "4", "8", "16"]),
                (axis("v", True), [1e-3, 5e-3, 2e-2, 0.5, 5, 50, 500, 1e3, None], [0, 0, 1, 2, 3, 4, 5, 5],
                 ["0.001", "0.01", "0.1", "1", "10", "100", "1000"])]:
            edges = [0, 3, 6, 10]
            chart = self.plant(figure(map={"value": value, "x": edges, "y": [y / 10 for y in edges], "values": values}))
            self.check(chart)
            legend = self.script("return [...document.querySelectorAll('#planted .colours rect')].map((box) => box.getAttribute('fill'))")
            self.assertEqual(self.script("return [...document.querySelectorAll('#planted .colours text')].map((text) => text.textContent)"),
                             ["v", *bounds])
            self.assertEqual(len(legend), 6)
            for n, colour in enumerate(legend):
                self.assertAlmostEqual(lightness(colour), 95 - 15 * n, delta=2)
            found = {colour: path.count("M") for colour, path in chart["map"]}
            self.assertEqual(found, {colour: steps.count(n) for n, colour in enumerate(legend)})

    def ends(self, *lines):
        """[name, where its foot is] of those at ends of lines."""
        chart = self.plant(figure(series=list(lines)))
        found = self.script("return [...document.querySelectorAll('#planted .ends .entry')].map((entry) => "
                            "[entry.textContent, entry.transform.baseVal[0].matrix.f])")
        self.assertEqual(chart["legend"], [each["name"] for each in lines])
        return found

    # The words' foot is 4 pixels below the end of the line; they are 15 high, and the frame is 200.
    def test_names_at_the_ends_of_lines(self):
        low, high = line([[0, 0], [10, 0.2]], name="low"), line([[0, 0], [10, 0.7]], name="high")
        self.assertEqual(self.ends(low, high), [["low", 164], ["high", 64]])
        near = line([[0, 1], [10, 0.21]], name="near")
        self.assertEqual(self.ends(low, near), [["low", 177], ["near", 162]])  # 13 further than its line's end
        self.assertEqual(self.ends(low, near, line([[0, 1], [10, 0.22]], name="third")), [])
        for other in (line([[0, 1], [10, 0.5]], name="low"), line([[0, 1], [10, 0.3]], style="circles", name="marks"),
                      line([[0, 1], [5, 0.3]], name="ends early"), line([[0, 1], [10, 0.3]], name="a name " * 40)):
            self.plant(figure(series=[low, other]))
            self.assertEqual(self.script("return document.querySelectorAll('#planted .ends .entry').length"), 0, other["name"])

    def overlaps(self):
        return self.script("""
            const found = [], box = (text) => text.getBoundingClientRect();
            for (const svg of document.querySelectorAll('.chart > svg')) {
                const outer = box(svg), inner = box(svg.querySelector('.frame clipPath, .axis.x path'));
                for (const kind of ['.words text', '.axis.x .tick text', '.axis.y .tick text', '.legend .entry text']) {
                    const texts = [...svg.querySelectorAll(kind)];
                    for (const text of texts) {
                        const a = box(text), name = `${svg.getAttribute('aria-label')}: ${text.textContent}`;
                        if (a.left < outer.left - 1 || a.right > outer.right + 1) found.push(`${name} leaves the picture`);
                        if (kind === '.words text' && (a.left < inner.left - 1 || a.right > inner.right + 1))
                            found.push(`${name} leaves the frame`);
                        for (const other of texts) {
                            const b = box(other);
                            // A line of text is some 14 pixels high, and lines are 15 apart.
                            if (other !== text && a.left < b.right && b.left < a.right && a.top < b.bottom - 3 &&
                                b.top < a.bottom - 3) found.push(`${name} over ${other.textContent}`);
                        }
                    }
                }
            }
            return found;""")

    def test_words_keep_off_each_other(self):
        crowd = [rule(5 + n / 50, f"rule number {n}") for n in range(6)] + [rule(9.9, "at the end"), rule(0, "at the begin")]
        crowd += [rule(0.5, "level", True), rule(0.51, "nearly so", True), rule(1, "top", True), rule(0, "ground", True)]
        # At the narrower width the words "ground" have no place left.
        for width, shown in [(1200, 13), (390, 12)]:
            self.width(width)
            self.plant(figure(rules=crowd, bands=[{"from": 1, "to": 4, "colour": "#d07a28", "words": "stick"}]))
            self.assertEqual(self.overlaps(), [])
            self.assertEqual(self.script("return document.querySelectorAll('#planted .words text').length"), shown)
            for page in PAGES:
                self.open(page)
                self.assertEqual(self.overlaps(), [])

    def test_the_width_of_the_page(self):
        self.open("zener")
        for width in [700, 390, 1100]:
            self.width(width)
            self.wait("""[...document.querySelectorAll(".chart")].every((chart) =>
                chart.closest("details:not([open])") ||
                Number(chart.querySelector('svg').getAttribute('width')) === chart.clientWidth)""")
            self.assertLess(self.script("return document.querySelector('.chart').clientWidth"), width)
            for chart in self.script(CHARTS):
                for name in ["x", "y"]:
                    if len(self.words(chart[name])) > 1:
                        self.check_axis(chart[name], chart["record"][name])
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_charts_are_drawn_when_they_come_near(self):
        self.load("zener")
        drawn = "[...document.querySelectorAll('.chart')].map((chart) => chart.querySelector('svg:not(.still)') !== null)"
        self.assertFalse(self.script(f"return {drawn}")[-1])
        self.script("document.querySelectorAll('details').forEach((part) => { part.open = true; })")
        self.script("""[...document.querySelectorAll('.chart')].pop().scrollIntoView({ behavior: 'instant' })""")
        self.wait(f"{drawn}.pop()")
        self.assertIn(False, self.script(f"return {drawn}"))
        self.script("dispatchEvent(new Event('beforeprint'))")
        self.assertNotIn(False, self.script(f"return {drawn}"))

    def hover(self, x, y):
        """Of the frame, in its pixels."""
        corner = self.script("""const matrix = document.querySelector('#planted .frame').getScreenCTM();
            return [matrix.e, matrix.f]""")
        self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
            "type": "mouseMoved", "x": corner[0] + x, "y": corner[1] + y})
        return self.told()

    def told(self):
        return self.script("""const told = document.querySelector('#planted .told');
            return told.hidden ? [] : [...told.children].map((line) => line.textContent)""")

    def test_what_is_under_the_pointer(self):
        record = figure(series=[line([[2, 0.5, HOSTILE], [4, 0.123456789]], "<b>curve</b>", "circles")],
                        bands=[{"from": 7, "to": 9, "colour": "#d07a28", "words": "stick"}],
                        rules=[rule(6, "level")],
                        map={"value": axis("digits"), "x": [0, 5, 10], "y": [0, 1], "values": [3.25, 1]})
        chart = self.plant(record)
        x, y = Ruler(chart["x"], record["x"]), Ruler(chart["y"], record["y"])
        self.assertEqual(self.hover(x.place(2) + 5, y.place(0.5) - 5), [f"<b>curve</b> {HOSTILE}", "digits 3.25"])
        self.assertEqual(self.hover(x.place(4), y.place(0.123)), ["<b>curve</b>", "x 4", "y 0.1234568", "digits 3.25"])
        self.assertEqual(self.hover(x.place(8), y.place(0.9)), ["digits 1", "stick"])
        self.assertEqual(self.hover(x.place(6) + 2, y.place(0.9)), ["digits 1", "level"])
        self.assertEqual(self.hover(x.place(8), -60), [])
        self.assertIsNone(self.script("return window.hostile ?? null"))

    def test_the_keyboard_goes_from_point_to_point(self):
        self.plant(figure(series=[line([[2, 0.5, "first"], [4, None], [6, 0.7, "second"]], "curve")]))
        chart = self.browser.find_element(By.ID, "planted")
        for key, told in [(Keys.ARROW_RIGHT, ["curve first"]), (Keys.ARROW_RIGHT, ["curve second"]),
                          (Keys.ARROW_RIGHT, ["curve second"]), (Keys.ARROW_LEFT, ["curve first"]), (Keys.ESCAPE, [])]:
            chart.send_keys(key)
            self.assertEqual(self.told(), told)

    def test_texts_stay_texts(self):
        classes = {"value": axis(HOSTILE, ticks=[[0, HOSTILE]]), "colours": ["#2090ad"], "x": [0, 5, 10], "y": [0, 1],
                   "values": [0, 0]}
        for form in [classes, {**classes, "value": axis(HOSTILE)}]:
            form = form if "ticks" in form["value"] else {key: part for key, part in form.items() if key != "colours"}
            self.plant(figure(title=HOSTILE, x=axis(HOSTILE, range=[0, 10]), y=axis(HOSTILE, ticks=[[0.5, HOSTILE]]),
                              map=form, series=[line([[1, 0.5, HOSTILE]], HOSTILE)],
                              bands=[{"from": 0, "to": 9, "colour": "#d07a28", "words": HOSTILE}],
                              rules=[rule(3, HOSTILE), rule(0.4, HOSTILE, True)]))
            self.assertGreaterEqual(self.script("return document.getElementById('planted').textContent").count(HOSTILE), 7)
            self.assertEqual(self.script("return document.querySelectorAll('#planted img, #planted script').length"), 0)
            self.assertIsNone(self.script("return window.hostile ?? null"))
        self.assertEqual(self.browser.get_log("browser"), [])

    def saved(self, kind):
        self.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {
            "behavior": "allow", "downloadPath": str(Path(self.folder.name, "saved"))})
        self.browser.find_element(By.CSS_SELECTOR, "#planted summary").click()
        next(button for button in self.browser.find_elements(By.CSS_SELECTOR, "#planted button")
             if kind in button.text).click()
        file = Path(self.folder.name, "saved", f"planted.{kind.lower()}")
        WebDriverWait(self.browser, PATIENCE).until(lambda _: file.exists() and file.stat().st_size > 0)
        return file.read_bytes()

    def test_a_chart_can_be_saved(self):
        self.plant(figure(series=[line([[0, 0], [10, 1]], HOSTILE)]))
        width, height = self.script("""const svg = document.querySelector('#planted svg');
            return [Number(svg.getAttribute('width')), Number(svg.getAttribute('height'))]""")
        picture = xml.etree.ElementTree.fromstring(self.saved("SVG"))
        self.assertEqual((picture.get("width"), picture.get("height")), (str(width), str(height)))
        self.assertIn(HOSTILE, list(picture.itertext()))
        pixels = self.saved("PNG")
        self.assertEqual(pixels[:8], b"\x89PNG\r\n\x1a\n")
        # Its header: width and height.
        self.assertEqual((int.from_bytes(pixels[16:20], "big"), int.from_bytes(pixels[20:24], "big")),
                         (2 * width, 2 * height))
        self.assertEqual(self.browser.get_log("browser"), [])


if __name__ == "__main__":
    os.environ.setdefault("HOME", tempfile.gettempdir())
    unittest.main(verbosity=2)
