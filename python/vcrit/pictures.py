"""The pictures of `vcrit plot`, as SVG and by matplotlib."""

import html
import importlib
import json
from collections.abc import Sequence
from typing import Any

from . import _vcrit

_SHAPES = {"line": {"linestyle": "-"}, "dashed": {"linestyle": "--"}, "dotted": {"linestyle": ":"},
           "circles": {"linestyle": "", "marker": "o", "fillstyle": "none"},
           "dots": {"linestyle": "", "marker": "."}, "crosses": {"linestyle": "", "marker": "x"}}


def drawn(scene: _vcrit.Scene, of: str, to: float | None, velocity: float, axes: Any) -> Any:
    """By matplotlib, into its axes (one for each panel) where they are given."""
    figures = json.loads(_vcrit.figures(scene, of, to, velocity))
    if axes is None:
        axes = _pyplot().subplots(len(figures), squeeze=False, sharex=True, layout="constrained",
                                  figsize=(6.4, 1.2 + 3.2 * len(figures)))[1][:, 0]
    all_axes = list(axes) if hasattr(axes, "__len__") else [axes]
    for figure, each in zip(figures, all_axes, strict=True):
        _draw(figure, each)
    return all_axes[0] if len(all_axes) == 1 else all_axes


def _pyplot() -> Any:
    try:
        return importlib.import_module("matplotlib.pyplot")
    except ImportError as error:
        raise ImportError("plot() draws with matplotlib, which this Python does not have: "
                          "apt-get install python3-matplotlib (Debian) or pip install matplotlib; "
                          "svg() needs nothing") from error


def _draw(figure: dict[str, Any], axes: Any) -> None:
    axes.set_title(figure["title"], loc="left")
    for name in ("x", "y"):
        axis = figure[name]
        axes.set(**{f"{name}label": axis["title"]},
                 **({f"{name}scale": "log"} if axis["logarithmic"] else {}))
        if "range" in axis:
            axes.set(**{f"{name}lim": axis["range"]})
    for band in figure["bands"]:
        axes.axvspan(band["from"], band["to"], color="black", alpha=0.07, linewidth=0)
    named = set()
    for series in figure["series"]:
        points = [[float("nan") if number is None else number for number in point[:2]]
                  for point in series["points"]]
        label = series["name"] if series["name"] not in named else ""
        named.add(label)
        axes.plot(*zip(*points), color=series["colour"], label=label or None, **_SHAPES[series["style"]])
    for rule in figure["rules"]:
        _rule(rule, axes)
    if named - {""}:
        axes.legend(frameon=False)


def _rule(rule: dict[str, Any], axes: Any) -> None:
    """A line across the picture, and its words beside it."""
    line = {"color": rule["colour"], "linestyle": "--", "linewidth": 1}
    if rule["horizontal"]:
        axes.axhline(rule["at"], **line)
        axes.annotate(rule["words"], (0.01, rule["at"]), xycoords=axes.get_yaxis_transform(),
                      xytext=(0, 3), textcoords="offset points")
    else:
        axes.axvline(rule["at"], **line)
        axes.annotate(rule["words"], (rule["at"], 0.01), xycoords=axes.get_xaxis_transform(),
                      xytext=(3, 3), textcoords="offset points")


def notebook(title: str, words: Sequence[str], picture: str) -> str:
    """What a notebook shows of a scene."""
    lines = "<br/>".join(html.escape(line) for line in words)
    return f"<div><p><b>{html.escape(title)}</b></p><p>{lines}</p>{picture}</div>"
