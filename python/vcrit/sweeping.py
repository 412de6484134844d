"""Quantities over a grid of parameters and speeds, as `vcrit sweep` finds them."""

import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _vcrit
from .batch import parser
from .inputs import Parse, characters, is_text, numbers, refused, text_with_unit


@dataclass(frozen=True, repr=False, eq=False)
class Sweep:
    """Quantities on a grid: sweep["friction_ratio"] has an index for each axis, in their order."""

    axes: Mapping[str, npt.NDArray[np.float64]]
    """What was varied, by name, SI."""
    quantities: Mapping[str, npt.NDArray[Any]]
    """What was found, by name: numbers, NaN outside the model; of "regime" texts, empty there; of
    "admissible" truth values."""
    units: Mapping[str, str]
    """Of axes and quantities, SI."""
    outside: int
    """How many points are outside the model."""
    reason: str
    """Why the first of them is, else empty."""

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self.quantities[name] if name in self.quantities else self.axes[name]

    def __iter__(self) -> Iterator[str]:
        """The names of axes, then of quantities."""
        yield from self.axes
        yield from self.quantities

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values each axis has."""
        return tuple(values.size for values in self.axes.values())

    def __repr__(self) -> str:
        axes = " and ".join(f"{name} ({values.size})" for name, values in self.axes.items())
        return f"<vcrit.Sweep: {', '.join(self.quantities)} over {axes}>"


def sweep(scene: _vcrit.Scene, over: Mapping[str, Any], quantity: str | Sequence[str],
          velocity: Any, velocity_ratio: Any) -> Sweep:
    if not hasattr(over, "items"):
        raise refused("over", f"a {type(over).__name__}", "names and their values: {'frequency': values}")
    axes = [_axis(scene, characters(name, "over"), values) for name, values in over.items()]
    if not axes:
        raise refused("over", "no axis", "names and their values: {'frequency': values}")
    names = [characters(name, "quantity") for name in _several(quantity)]
    table, columns, outside, reason, warned = _vcrit.sweep(
        scene, axes, names, text_with_unit(velocity, "velocity"),
        text_with_unit(velocity_ratio, "velocity_ratio"))
    if outside > 0:
        warned.append(f"{outside} of {len(table)} points are outside the model (nan); the first: {reason}")
    for warning in warned:
        warnings.warn(warning, stacklevel=3)
    shape = [len(axis.values) for axis in axes]
    found = {name: _values(table[:, len(axes) + i].reshape(shape), words, first)
             for i, (name, _, words, first) in enumerate(columns)}
    units = {axis.name: axis.unit for axis in axes} | {name: unit for name, unit, _, _ in columns}
    return Sweep({axis.name: np.array(axis.values) for axis in axes}, found, units, outside, reason)


def _several(quantity: Any) -> Iterable[Any]:
    return quantity if isinstance(quantity, Iterable) and not is_text(quantity) else [quantity]


def _axis(scene: _vcrit.Scene, name: str, values: Any) -> _vcrit.Axis:
    if is_text(values):
        return _vcrit.axis_of_text(scene, f"{name}={characters(values, name)}")
    plain = numbers(values, name, _parser(scene, name))
    if plain.values.ndim != 1 or plain.mask is not None:
        raise refused(f"over {name}", f"an array of shape {plain.values.shape}" if plain.mask is None
                      else "a masked array", "values in one row")
    return _vcrit.axis_of_array(scene, name, np.ascontiguousarray(plain.values, dtype=np.float64))


def _parser(scene: _vcrit.Scene, name: str) -> Parse:
    if name == "velocity":
        return lambda text: _vcrit.parse_velocity(text, name)
    if name == "velocity_ratio":
        return lambda text: _vcrit.parse_ratio(text, name)
    return parser(scene, name)


def _values(flags: npt.NDArray[np.float64], words: list[str], first: int) -> npt.NDArray[Any]:
    """Numbers as they are; of flags what they mean, from the first one on, before it nothing."""
    if not words:
        return flags
    if words == ["no", "yes"]:
        answers: npt.NDArray[Any] = flags == 1
        return answers
    meanings: npt.NDArray[Any] = np.array([""] * first + words)[flags.astype(np.intp)]
    return meanings
