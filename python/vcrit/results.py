"""Results of a scene."""

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _vcrit
from .inputs import ma


def speed(velocity: float) -> str:
    """With a unit that it reads well in: "4.095 mm/s"."""
    return _vcrit.quantity(velocity, "m/s")


def known(values: Any) -> npt.NDArray[np.float64]:
    """Those that are numbers and not masked, in one row."""
    return np.asarray(ma.masked_invalid(values).compressed(), dtype=np.float64)


class Parameter(NamedTuple):
    """A number of a scene."""

    value: float | None
    """In `unit`; None for a symbol without a value."""
    unit: str
    """SI: "N/m", "rad/s"; "1" for a plain number."""


class CertifiedVelocity(NamedTuple):
    """v* of Eq. (24), correctly rounded, or, where that does not hold, simulated."""

    value: float
    """m/s; infinite at resonance."""
    relative_error_bound: float
    """Of `value`; 0 where it is exact, NaN where it is simulated."""
    reason: str
    """Why the value is infinite, else empty."""


class CriticalOnset(NamedTuple):
    """v* of the motion."""

    contact_velocity: float
    """m/s; may be infinite."""
    drive_velocity: float
    """m/s, of the drive there; larger only where a network on the path creeps."""
    by: str
    """"formula" (Eq. 24) or, where the contact opens and it does not hold, "simulation"."""
    reason: str
    """Why the velocity is infinite, else empty."""

    def __repr__(self) -> str:
        return f"<vcrit.CriticalOnset: v* = {speed(self.contact_velocity)}, by {self.by}>"


class Event(NamedTuple):
    """Where the contact point begins to slip or to stick, or the contact opens."""

    phase: float
    """omega t in [0, 2 pi)."""
    to: str
    """"slip", "stick", "backslip" or "apart"."""


class Energy(NamedTuple):
    """Where the work of the drive goes in one oscillation period, in J."""

    drive: float
    friction: float
    dampers: float
    error: float
    """Estimate of the error of each."""


class _SteadyMotion(NamedTuple):
    velocity: float
    """Mean velocity of the drive, m/s."""
    velocity_ratio: float
    """Drive speed as a multiple of v*."""
    friction_ratio: float
    """Mean friction over that without vibration, mu/mu0."""
    friction_ratio_error: float
    """Estimate of its absolute error."""
    regime: str
    """"sliding", "stick-slip", "stick-slip-backslip" or "stick"; the first three end in "-apart"
    where the contact opens for a part of the period."""
    method: str
    periods: int | None
    """Length of the steady cycle in oscillation periods, where it is one."""
    events: tuple[Event, ...]
    """Of one cycle, by time."""
    starts_agree: bool | None = None
    """Of a contact that opens, by the exact method: whether the search from the other start led
    to the same friction. Where it did not, the error covers both."""


class SteadyState(_SteadyMotion):
    """The steady motion at one speed, by simulation."""

    _scene: Any = None

    def _in(self, scene: Any) -> "SteadyState":
        """With the scene that the energy is asked of."""
        self._scene = scene
        return self

    def __repr__(self) -> str:
        return (f"<vcrit.SteadyState at {speed(self.velocity)} ({self.velocity_ratio:.4g} v*): "
                f"friction ratio {self.friction_ratio:.4g}, {self.regime}>")

    @cached_property
    def energy(self) -> Energy | None:
        """Found when first asked for. Known for the exact method alone, and for no indenter."""
        if self._scene is None:
            return None
        found = _vcrit.energy(self._scene._handle, self.velocity)
        return None if found is None else Energy(*found)


class FrictionCurve(NamedTuple):
    """Friction over the speed, by simulation: arrays of one shape, a value for each speed."""

    velocity: npt.NDArray[np.float64]
    """Mean velocity of the drive, m/s."""
    velocity_ratio: npt.NDArray[np.float64]
    """Drive speed as a multiple of v*."""
    friction_ratio: npt.NDArray[np.float64]
    """Mean friction over that without vibration, mu/mu0; NaN where no steady state is found."""
    friction_ratio_error: npt.NDArray[np.float64]
    """Estimate of its absolute error."""
    regime: npt.NDArray[np.str_]
    """As in SteadyState; empty where no steady state is found."""
    reason: npt.NDArray[np.str_]
    """Why none is found, else empty."""

    def __repr__(self) -> str:
        velocities, ratios = known(self.velocity), known(self.friction_ratio)
        text = f"<vcrit.FrictionCurve of {np.size(self.velocity)} speeds"
        if velocities.size > 0:
            text += f" from {speed(velocities.min())} to {speed(velocities.max())}"
        if ratios.size > 0:
            text += f": friction ratio {ratios.min():.4g} to {ratios.max():.4g}"
        return text + ">"
