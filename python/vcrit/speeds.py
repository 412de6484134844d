"""Speeds as callers give them: velocities of the drive, or their ratios to v*."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _vcrit
from .inputs import characters, is_text, text_with_unit

Array = npt.NDArray[np.float64]


class Speeds(NamedTuple):
    """What a caller gives as speeds."""

    given: Any
    are_ratios: bool

    @classmethod
    def of(cls, velocities: Any, ratios: Any) -> "Speeds":
        if (velocities is None) == (ratios is None):
            raise TypeError("either velocities or their ratios to v* must be given")
        return cls(velocities if ratios is None else ratios, ratios is not None)

    @property
    def name(self) -> str:
        return "velocity_ratios" if self.are_ratios else "velocities"

    @property
    def argument(self) -> str:
        return "velocity_ratio" if self.are_ratios else "velocity"

    def parse(self, text: str) -> float:
        parse = _vcrit.parse_ratio if self.are_ratios else _vcrit.parse_velocity
        return parse(characters(text, self.name), self.argument)

    def one(self, scene: _vcrit.Scene) -> tuple[float, float]:
        """Velocity and ratio of a single speed, which must be known."""
        text = text_with_unit(self.given, self.name)
        number = self.parse(text) if is_text(self.given) or " " in text else float(text)
        speed, ratio = map(float, self.in_both_units(scene, np.array(number)))
        if np.isnan(speed):
            _vcrit.refuse_speed(speed, number if self.are_ratios else None, self.argument)
        return speed, ratio

    def in_both_units(self, scene: _vcrit.Scene, given: npt.NDArray[Any]) -> tuple[Array, Array]:
        """Velocities and their ratios to v*, as contiguous arrays."""
        speeds = np.array(given, dtype=np.float64, order="C")
        critical, _, _, reason = _vcrit.critical_onset(scene)
        if self.are_ratios:
            if np.isinf(critical):
                raise _vcrit.ModelError(f"{reason}: velocity_ratio has no meaning, give velocity")
            if critical == 0:
                _vcrit.require_motion(scene)
                raise _vcrit.ModelError("v* is 0 here: velocity_ratio has no meaning, give velocity")
            speeds *= critical
        self._refuse_wrong(speeds, np.asarray(given))
        with np.errstate(divide="ignore"):  # v* = 0 at antiresonance
            return speeds, np.divide(speeds, critical, out=np.empty_like(speeds))

    def _refuse_wrong(self, speeds: Array, given: npt.NDArray[Any]) -> None:
        first = _vcrit.first_refused_speed(speeds)
        if first is None:
            return
        place = "" if speeds.ndim == 0 else "at index " + ", ".join(
            str(int(each)) for each in np.unravel_index(first, speeds.shape)) + ": "
        ratio = float(given.flat[first]) if self.are_ratios else None
        _vcrit.refuse_speed(float(speeds.flat[first]), ratio, place + self.argument)
