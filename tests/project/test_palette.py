"""Colours of series can be told apart by all eyes, on paper and in the dark: read from the sources, and seen through the
matrices of Machado, Oliveira and Fernandes (2009) for eyes without one kind of cone."""

import itertools
import re
import sys
import unittest
from pathlib import Path

PROJECT = Path(sys.argv.pop(1))
EYES = {
    "normal": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "tritan": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]}
REFERENCE = "#6b7280"  # a thin dashed line without marks


def linear(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


def luminance(colour):
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear(colour)))


def contrast(one, other):
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def lab(colour, eyes):
    r, g, b = [min(1, max(0, sum(a * part for a, part in zip(row, linear(colour))))) for row in eyes]
    x, y, z = [(t ** (1 / 3) if t > 216 / 24389 else t * 841 / 108 + 4 / 29)
               for t in ((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047, 0.2126 * r + 0.7152 * g + 0.0722 * b,
                         (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883)]
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def least_distance(colours, eyes):
    return min(sum((a - b) ** 2 for a, b in zip(lab(one, eyes), lab(other, eyes))) ** 0.5
               for one, other in itertools.combinations(colours, 2))


class Palette(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        source, cls.style = ((PROJECT / "validation" / file).read_text() for file in ("figures/figure.cpp", "report/page.css"))
        listed = re.search(r"array colours\{([^}]*)\}", source)[1]
        cls.light = [colour for colour in re.findall(r"#[0-9a-f]{6}", listed) if colour != REFERENCE][:4]
        cls.dark = [re.search(rf'\[stroke="{colour}"\][^{{]*{{ stroke: (#[0-9a-f]{{6}})', cls.style)[1] for colour in cls.light]
        cls.paper = re.findall(r"--paper: (#[0-9a-f]{6})", cls.style)

    # Four series and no more; small multiples beyond. White and light grey paper ask for 3 (WCAG 2.1, 1.4.11).
    def test_stands_out_from_the_paper(self):
        for colours, paper, least in ((self.light, self.paper[0], 3.7), (self.dark, self.paper[1], 5.5)):
            self.assertEqual(len(set(colours)), 4)
            self.assertGreaterEqual(min(contrast(colour, paper) for colour in colours), least)

    # A difference of 2 can be seen side by side; lines lie apart, so ten times that and more.
    def test_is_told_apart_by_all_eyes(self):
        for colours, least in ((self.light, 29), (self.dark, 20)):
            for name, eyes in EYES.items():
                with self.subTest(eyes=name, colours=colours):
                    self.assertGreaterEqual(least_distance(colours, eyes), least)

    def test_would_find_what_merges(self):
        # Red and green of one lightness, to eyes without the middle cone.
        self.assertLess(least_distance(["#b3380a", "#6b6f00"], EYES["deutan"]), 20)


if __name__ == "__main__":
    unittest.main()
