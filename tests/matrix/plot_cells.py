"""Pictures of `vcrit plot`, read back by their own axes, and pages of `vcrit explore`."""

import math

import mpmath as mp

from cells import REFERENCES, onset, run, scene
from pictures import panels, value_at


def plot(test, kind, column):
    picture, references = test.folder / f"{kind} {column.replace('/', ' ')}.svg", REFERENCES[kind]
    velocity = references.text("velocity:0") if "velocity:0" in references else "1e-3"
    of = column.split("/")[1]
    how = {"speed": ("--to", 2 * float(velocity)), "cycle": ("--velocity", velocity)}.get(of, ())
    if not test.answered(kind, column, run("plot", scene(kind), "--of", of, *how, "--out", picture)):
        test.assertFalse(picture.exists())
        return
    lines = panels(picture.read_text())
    if of == "speed":
        # Drawn to a tenth of a pixel of 320, with straight lines between 160 speeds.
        test.near(value_at(lines[0].lines[0], float(velocity)), references("friction_ratio:0"), 3e-3, of)
    elif of == "frequency":
        check_drawn_onset(test, kind, lines[0].lines[-1])
    else:
        bound, minus, force = lines[0].lines
        # Two tenths of a pixel of 220 for some four times the largest bound.
        allowed = 0.005 * max(above for _, above in bound[0])
        for (_, above), (_, below), (_, between) in zip(*bound, *minus, *force):
            test.assertTrue(below - allowed <= between <= above + allowed, (kind, below, between, above))


def check_drawn_onset(test, kind, strokes):
    """Near an undamped resonance the line is too steep to be read."""
    value, _ = onset(kind)
    if "resonance" not in kind and 0 < value < mp.inf:
        frequency = float(REFERENCES[kind]("value:omega")) / (2 * math.pi)
        drawn = value_at(strokes, frequency)
        test.near(drawn / float(value), 1, 0.05, kind)


def explore(test, kind, column):
    """What the page answers, tests/live asks in a browser."""
    page = test.folder / f"{kind}.html"
    if test.answered(kind, column, run("explore", scene(kind), "--out", page)):
        test.assertIn('id="explorer"', page.read_text())
    else:
        test.assertFalse(page.exists())
