"""A picture of `vcrit plot` read back: what its lines mean on its own axes."""

import math
import re
import xml.etree.ElementTree as tree

SVG = "{http://www.w3.org/2000/svg}"
SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
UNITS = {"nm/s": 1e-9, "µm/s": 1e-6, "mm/s": 1e-3, "m/s": 1, "km/s": 1e3, "mHz": 1e-3, "Hz": 1, "kHz": 1e3, "MHz": 1e6,
         "GHz": 1e9, "pN": 1e-12, "nN": 1e-9, "µN": 1e-6, "mN": 1e-3, "N": 1, "kN": 1e3, "MN": 1e6, "GN": 1e9, "ps": 1e-12,
         "ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1, "ks": 1e3, "Mm/s": 1e6, "Gm/s": 1e9, "pm/s": 1e-12}


def number(words):
    power = re.fullmatch(r"10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", words)
    return 10.0 ** int(power[1].translate(SUPERSCRIPTS)) if power else float(words)


class Axis:
    """Of ticks with words: pixels and values, evenly spaced themselves or in their logarithms."""

    def __init__(self, ticks, title):
        (self.at, low), *_, (end, high) = ticks
        self.logarithmic = low > 0 and len(ticks) > 1 and not self.even(ticks)
        self.low = math.log(low) if self.logarithmic else low
        self.slope = ((math.log(high) if self.logarithmic else high) - self.low) / (end - self.at)
        unit = title.rsplit(", ", 1)[-1]
        self.unit = UNITS[unit] if ", " in title else 1

    @staticmethod
    def even(ticks):
        slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(ticks, ticks[1:])]
        return len(slopes) > 1 and max(slopes) - min(slopes) < 0.1 * abs(max(slopes, key=abs))

    def __call__(self, pixel):
        """In SI units."""
        value = self.low + self.slope * (pixel - self.at)
        return (math.exp(value) if self.logarithmic else value) * self.unit


class Panel:
    def __init__(self, group):
        texts = group.findall(f"{SVG}text")
        *_, x_title, y_title = (text.text or "" for text in texts)
        ticks = {"middle": [], "end": []}
        for text in group.findall(f"{SVG}g/{SVG}text[@text-anchor]"):
            anchor = text.get("text-anchor")
            if text.text:
                ticks[anchor].append((float(text.get("x" if anchor == "middle" else "y")), number(text.text)))
        self.x, self.y = Axis(ticks["middle"], x_title), Axis(ticks["end"], y_title)
        self.title = texts[0].text or ""
        self.lines = [self.strokes(path.get("d")) for path in group.findall(f"{SVG}g[@clip-path]/{SVG}g/{SVG}path")]
        self.words = [text.text for text in group.findall(f"{SVG}g/{SVG}text") if not text.get("text-anchor")]

    def strokes(self, path):
        """Of a line, what lies between two gaps."""
        return [[(self.x(float(x)), self.y(float(y))) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", stroke)]
                for stroke in path.split("M") if stroke]


def panels(text):
    """Of an SVG; it has to be XML."""
    return [Panel(group) for group in tree.fromstring(text).findall(f"{SVG}g")]


def value_at(strokes, x):
    """By straight lines between points; nothing in a gap."""
    for points in strokes:
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            if x0 <= x <= x1:
                return y0 + (y1 - y0) * ((x - x0) / (x1 - x0) if x1 > x0 else 0)
    return None
