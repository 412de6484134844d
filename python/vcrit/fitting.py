"""A Prony series from measured stiffness, and the scene that it makes, as `vcrit fit` finds them."""

import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _vcrit
from .inputs import characters, flag, name_of_file, numbers, refused, text_with_unit, whole_number
from .scene import Array, Scene, Value

# Of columns that name none.
_UNITS = {"frequency": "Hz", "angular_frequency": "rad/s", "storage": "N/m", "loss": "N/m",
          "storage_error": "N/m", "loss_error": "N/m"}


class Uncertain(NamedTuple):
    """A number and one standard deviation of it."""

    value: float
    error: float


class Branches(NamedTuple):
    """The Maxwell branches of a series, by increasing time: an array each."""

    stiffness: Array
    """N/m"""
    time: Array
    """s"""
    stiffness_error: Array
    """One standard deviation, as time_error."""
    time_error: Array


class KnownStiffness(NamedTuple):
    """What the data say of the stiffness for any number of branches: intervals of 95 %, an array each."""

    frequency: Array
    """Hz, across the data."""
    storage: Array
    """N/m, of the fitted series, as loss."""
    loss: Array
    storage_low: Array
    storage_high: Array
    loss_low: Array
    loss_high: Array


@dataclass(frozen=True, repr=False, eq=False)
class Fit:
    """A Prony series with as few branches as the noise of the data allows. Made by `fit`."""

    text: str
    """A scene file, TOML: what `vcrit fit` writes."""
    equilibrium: Uncertain | None
    """The spring k0, N/m; None where the data need none."""
    damper: Uncertain | None
    """The damper c0, N s/m; None where the data need none."""
    branches: Branches
    known: KnownStiffness
    rms_relative_misfit: float
    """Root mean square of |fit - K|/|K|."""
    noise: float | None
    """Relative error of the data, estimated; None where the data have errors of their own."""
    degrees_of_freedom: int
    order_in_doubt: bool
    """With this noise another number of branches fits as well."""
    exhausted: bool
    """The last of max_branches branches still helped."""
    words: tuple[str, ...]
    """Remarks on the fit, one sentence each."""

    @cached_property
    def scene(self) -> Scene:
        """The scene of `text`; what no measurement of stiffness gives may be a symbol in it."""
        return Scene.from_text(self.text, "fit")

    def stiffness(self, frequency: npt.ArrayLike) -> npt.NDArray[np.complex128]:
        """K' + i K'' of the series at these frequencies (Hz), N/m."""
        i_omega = 2j * np.pi * np.asarray(frequency, dtype=np.float64)
        k0 = 0.0 if self.equilibrium is None else self.equilibrium.value
        c0 = 0.0 if self.damper is None else self.damper.value
        time = i_omega[..., np.newaxis] * self.branches.time
        return np.asarray(k0 + c0 * i_omega + (self.branches.stiffness * time / (1 + time)).sum(axis=-1))

    def __repr__(self) -> str:
        return f"<vcrit.Fit: {self.words[0]}, misfit {100 * self.rms_relative_misfit:.3g} %>"


def fit(data: "str | os.PathLike[str] | Mapping[str, npt.ArrayLike]", *, damper: bool = False,
        max_branches: int = 20, punch_radius: Value | None = None, title: str = "",
        poisson: Value | None = None, frequency: Value | None = None, amplitude: Value | None = None,
        indentation: Value | None = None, coefficient: Value | None = None) -> Fit:
    """Fits a Prony series to measured storage and loss stiffness.

    data: a table (CSV) as `vcrit fit` reads it, or its columns: {"frequency": f, "storage": k1,
    "loss": k2} or "tan_delta" in place of "loss", in SI unless a name has a unit ("storage [N/um]");
    errors of known size as "storage_error" and "loss_error". Moduli ("storage [MPa]") need the
    radius of a flat punch and Poisson's ratio. damper: tried from the start, not only where branches
    fail. The others are for the scene: numbers in SI or texts with a unit.
    Warns of how the table was read. Raises InputError.
    """
    text, file = _table(data)
    rest = {"title": characters(title, "title")} | {
        name: text_with_unit(value, name)
        for name, value in {"poisson": poisson, "frequency": frequency, "amplitude": amplitude,
                            "indentation": indentation, "coefficient": coefficient}.items()}
    found = _vcrit.fit(text, file, text_with_unit(punch_radius, "punch_radius"),
                       flag(damper, "damper"), whole_number(max_branches, "max_branches"), rest)
    notes = found.pop("notes")
    for note in notes if punch_radius is None else []:  # else that moduli are taken as asked for
        warnings.warn(note, stacklevel=2)
    made: dict[str, Any] = {
        "branches": Branches(*map(_array, found["branches"])),
        "known": KnownStiffness(*map(_array, found["known"])),
        "words": tuple(found["words"])}
    for name in ("equilibrium", "damper"):
        made[name] = None if found[name] is None else Uncertain(*found[name])
    return Fit(**{**found, **made})


def _array(values: list[float]) -> Array:
    return np.array(values, dtype=np.float64)


def _table(data: Any) -> tuple[str, bytes]:
    """The text of a table, and what messages call it."""
    if hasattr(data, "items"):
        return _text_of(dict(data.items())), b"data"
    name = name_of_file(os.fspath(data))
    return _vcrit.read_file(name), name


def _text_of(columns: Mapping[str, Any]) -> str:
    heads, arrays = [], []
    for name, values in columns.items():
        heads.append(f"{name} [{_UNITS[name]}]" if name in _UNITS else characters(str(name), "data"))
        arrays.append(np.asarray(numbers(values, heads[-1], _no_text).values, dtype=np.float64))
        if arrays[-1].shape != arrays[0].shape or arrays[-1].ndim != 1:
            raise refused(heads[-1], f"an array of shape {arrays[-1].shape}", "columns of one length")
    rows = (",".join(map(repr, map(float, row))) for row in zip(*arrays))
    return "\n".join([",".join(heads), *rows]) + "\n"


def _no_text(text: str) -> float:
    raise refused("data", repr(text), 'numbers; a unit stands in the name, "storage [N/um]"')
