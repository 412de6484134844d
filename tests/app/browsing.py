"""For tests of pages: Debian's Chromium without a window, and what the charts in it show."""

import math
import re

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

PATIENCE = 60  # seconds, for what takes one; the machine may be busy

# Chromium's sandbox does not work for root, and the small /dev/shm of containers is not enough for it.
ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu",
             "--window-size=1200,900", "--disable-background-networking", "--no-first-run",
             "--disable-component-update", "--disable-sync", "--renderer-process-limit=1", "--in-process-gpu",
             "--disable-extensions", "--disable-breakpad", "--disable-features=SpareRendererForSitePerProcess"]

DRAWN = "return [...document.querySelectorAll('.chart')].every((chart) => chart.querySelector('svg:not(.still)'))"

CHARTS = """return [...document.querySelectorAll('.chart')].map((chart) => {
    const beside = chart.nextElementSibling;
    const all = (selector, told) => [...chart.querySelectorAll(selector)].map(told);
    const ticks = (axis) => all(`.axis.${axis} .tick`, (tick) => ({ words: tick.textContent,
        at: tick.transform.baseVal[0].matrix[axis === 'x' ? 'e' : 'f'] }));
    return {
        record: chart.record ?? JSON.parse(beside.textContent),
        x: ticks('x'), y: ticks('y'), right: ticks('right'),
        titles: all('.axis .title', (title) => title.textContent),
        legend: all('.legend .entry', (entry) => entry.textContent),
        series: all('.series path:not(.edge)', (path) => path.getAttribute('d')),
        map: all('.map path', (path) => [path.getAttribute('fill'), path.getAttribute('d')]),
        inner: Number(chart.querySelector('clipPath rect').getAttribute('width')),
    };
})"""

# On a sheet: the least size of words in its drawing and charts, in points, and how far anything reaches, in pixels.
ON_PAPER = """dispatchEvent(new Event('beforeprint'));
    const sizes = (selector) => [...document.querySelectorAll(selector)].filter((text) => text.textContent.trim() && text.checkVisibility())
        .map((text) => 0.75 * Math.hypot(text.getScreenCTM().a, text.getScreenCTM().b) * parseFloat(getComputedStyle(text).fontSize));
    const found = [Math.min(...sizes('.system text')), Math.min(...sizes('.chart text')), document.documentElement.scrollWidth];
    dispatchEvent(new Event('afterprint'));
    return found;"""
SHEET = round((210 - 2 * 12) * 96 / 25.4)  # of A4 between margins of 12 mm


def lightness(colour):
    """CIE L* of "#rrggbb"."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
              for c in (int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5))]
    y = sum(w * c for w, c in zip([0.2126, 0.7152, 0.0722], linear))
    return 116 * y ** (1 / 3) - 16


def browser(profile, network=False):
    """With a record of what it asks the network for ("performance"), which costs each page a fifth."""
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in [*ARGUMENTS, f"--user-data-dir={profile}"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"} | ({"performance": "ALL"} if network else {}))
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    load(driver, "about:blank")
    return driver


def load(driver, address):
    """The driver may take the end of what Chromium opens by itself for this page's."""

    def there(_):
        return driver.execute_script("return location.href === arguments[0] && document.readyState === 'complete'", address)

    driver.get(address)
    WebDriverWait(driver, PATIENCE).until(there)


def draw_charts(driver):
    """All of them, also those far from the screen: as before printing, which the page may not have been ready for."""

    def drawn(_):
        driver.execute_script("for (const kind of ['beforeprint', 'afterprint']) dispatchEvent(new Event(kind))")
        return driver.execute_script(DRAWN)

    WebDriverWait(driver, PATIENCE).until(drawn)


def check_paper(test, driver):
    """Chromium makes a page smaller that is wider than the sheet, and all its words with it."""
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    test.addCleanup(driver.execute_cdp_cmd, "Emulation.setEmulatedMedia", {"media": ""})
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": SHEET, "height": 1000, "deviceScaleFactor": 1, "mobile": False})
    drawing, charts, width = driver.execute_script(ON_PAPER)
    test.assertGreaterEqual(drawing, 6)
    test.assertGreaterEqual(charts, 6)
    test.assertLessEqual(width, SHEET)
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


def number(words):
    """A tick's words: 0.5, −2, 10⁻³, 5·10⁷."""
    plain = words.replace("−", "-")
    power = re.fullmatch(r"(-?)(?:([\d.]+)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", plain)
    if not power:
        return float(plain)
    exponent = power[3].translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    return float(f"{power[1]}{power[2] or 1}e{exponent}")


class Ruler:
    """Says by an axis's first and last words where a value must lie. Lengths are written with two decimals, so each
    tick is off by 0.005 pixels at most, and between ticks (or as far again beyond them) a place is by less than 0.02."""

    EXACT = 0.03

    def __init__(self, ticks, axis):
        self.logarithmic = axis["logarithmic"]
        self.named = [(number(tick["words"]), tick["at"]) for tick in ticks if tick["words"]]
        (low, self.start), (high, end) = self.named[0], self.named[-1]
        self.low = self.measure(low)
        self.step = (end - self.start) / (self.measure(high) - self.low)

    def measure(self, value):
        return math.log10(value) if self.logarithmic else value

    def place(self, value):
        return self.start + (self.measure(value) - self.low) * self.step

    def value(self, place):
        measured = self.low + (place - self.start) / self.step
        return 10**measured if self.logarithmic else measured


def places(style, path):
    """Where a series' path goes: (whether it begins anew, x, y)."""
    found = {"circles": r"(M)([-\d.]+) ([-\d.]+)a3\.3 ", "dots": r"(M)([-\d.]+) ([-\d.]+)a3\.1 ",
             "crosses": r"(M)([-\d.]+) ([-\d.]+)h8", "squares": r"(M)([-\d.]+) ([-\d.]+)h6v",
             "triangles": r"(M)([-\d.]+) ([-\d.]+)l4 7", "diamonds": r"(M)([-\d.]+) ([-\d.]+)l4\.2 "}.get(style, r"([ML])([-\d.]+) ([-\d.]+)")
    aside, below = {"circles": (3.3, 0), "dots": (3.1, 0), "crosses": (4, 0), "squares": (3, 3), "triangles": (0, 4.2),
                    "diamonds": (0, 4.6)}.get(style, (0, 0))
    return [(begin == "M", float(x) + aside, float(y) + below) for begin, x, y in re.findall(found, path)]
