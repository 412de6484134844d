"""What amplitude, frequency or speed reaches a wanted friction ratio, as `vcrit solve` finds it."""

import warnings
from typing import Any, NamedTuple

from . import _vcrit
from .inputs import characters, is_text, plain_number, refused, text_with_unit, whole_number
from .results import speed


class Solution(NamedTuple):
    """The smallest amplitude or frequency, or the largest speed, that reaches a friction ratio."""

    sought: str
    """"amplitude", "frequency" or "velocity"."""
    value: float
    """In `unit`: reaches the wanted ratio."""
    unit: str
    """"m", "Hz" or "m/s"."""
    value_error: float
    """Estimate: by this much less (of a speed: more) may do as well."""
    at_start: bool
    """The range begins with it: what lies before was not searched."""
    friction_ratio: float
    """mu_macro/mu0 there."""
    friction_ratio_error: float
    """Estimate of its absolute error."""
    regime: str
    """As in SteadyState."""
    velocity: float
    """Of the drive, m/s."""
    critical_velocity: float
    """v* there, m/s."""
    largest_amplitude: float
    """m: below it the contact stays closed, at this frequency."""
    largest_frequency: float | None
    """Hz: below it the contact stays closed, at this amplitude; None where none opens it."""
    searched: tuple[float, float]
    """From and to, in `unit`."""
    evaluations: int
    """Steady states that were asked for."""
    unanswered: int
    """Of them, without an answer."""

    def __repr__(self) -> str:
        at = "" if self.sought == "velocity" else f" at {speed(self.velocity)}"
        return (f"<vcrit.Solution: {self.sought} {_vcrit.quantity(self.value, self.unit)} for a "
                f"friction ratio of {self.friction_ratio:.4g}{at}>")


def solution(scene: _vcrit.Scene, sought: str, friction_ratio: Any, velocity: Any, from_: Any,
             to: Any, samples: int | None) -> Solution:
    characters(sought, "sought")
    ratio = (_vcrit.parse_ratio(characters(friction_ratio, "friction_ratio"), "friction_ratio")
             if is_text(friction_ratio) else plain_number(friction_ratio, "friction_ratio"))
    if velocity is None and sought in ("amplitude", "frequency"):
        raise refused("velocity", "none", "the velocity of the drive")
    if velocity is not None and sought == "velocity":
        raise refused("velocity", "a velocity, which is sought", "none")
    found, warning = _vcrit.solve(
        scene, sought, ratio, text_with_unit(velocity, "velocity"),
        text_with_unit(from_, "from_"), text_with_unit(to, "to"),
        None if samples is None else whole_number(samples, "samples"))
    if warning is not None:
        warnings.warn(warning, stacklevel=3)
    return Solution(**found)
