"""A scene: what is there, and what follows from it."""

import os
import warnings
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, TypeAlias, overload

import numpy as np
import numpy.typing as npt

from . import _vcrit
from .batch import evaluated
from .results import (
    CertifiedVelocity,
    CriticalOnset,
    Energy,
    Event,
    FrictionCurve,
    Parameter,
    SteadyState,
)

Value: TypeAlias = float | str
Array: TypeAlias = npt.NDArray[np.float64]


class Scene:
    """A contact, its drive and its oscillation, from a TOML file. Does not change.

    Raises InputError for whatever is wrong with the file; warns of what has no effect in it.
    """

    def __init__(self, file: "str | os.PathLike[str]") -> None:
        path = os.fspath(file)
        self._read(_vcrit.read_file(path), path, {})
        self._warn()

    @classmethod
    def from_text(cls, text: str, file: str = "scene") -> "Scene":
        """A scene from TOML text; `file` names it in messages, and a measured drive is looked for
        beside it."""
        scene = cls._made(text, file, {})
        scene._warn()
        return scene

    @classmethod
    def _made(cls, text: str, file: str, settings: dict[str, str]) -> "Scene":
        scene = cls.__new__(cls)
        scene._read(text, file, settings)
        return scene

    def _read(self, text: str, file: str, settings: dict[str, str]) -> None:
        self._text, self._file, self._settings = text, file, settings
        self._handle = _vcrit.Scene(text, file, list(settings.items()))

    def _warn(self, known: tuple[str, ...] = ()) -> None:
        for warning in self._handle.warnings:
            if warning not in known:
                warnings.warn(warning, stacklevel=3)

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene._made, (self._text, self._file, self._settings)

    def __repr__(self) -> str:
        values = "".join(f", {name}={value!r}" for name, value in self._settings.items())
        return f"<vcrit.Scene {self._file!r}{values}>"

    def with_values(self, values: Mapping[str, Value] | None = None, /, **named: Value) -> "Scene":
        """The scene with other values, as by `--set`: numbers in SI, or texts with a unit.

        with_values(k0="8 N/um", frequency=2e4); names that are none in Python go in a mapping,
        with_values({"k[3]": 1e5}). Raises InputError.
        """
        settings = dict(self._settings)
        for name, value in {**(values or {}), **named}.items():
            settings[name] = value if isinstance(value, str) else repr(float(value))
        scene = Scene._made(self._text, self._file, settings)
        scene._warn(known=self.warnings)
        return scene

    @property
    def title(self) -> str:
        """As the file says; may be empty."""
        return self._handle.title

    @property
    def warnings(self) -> tuple[str, ...]:
        """What stands in the file and has no effect; and that the frequency is beyond its
        fitted_range."""
        return tuple(self._handle.warnings)

    @property
    def parameters(self) -> Mapping[str, Parameter]:
        """The numbers of the scene by the symbols of its formulas: mu0, omega, du_z, u_z0, m and
        the elements, as far as they are there."""
        found = _vcrit.parameters(self._handle)
        return MappingProxyType({name: Parameter(value, unit) for name, value, unit in found})

    @property
    def settable(self) -> Mapping[str, str]:
        """Every name that `with_values` and `critical_velocity` take, and its SI unit."""
        return MappingProxyType(_vcrit.settable(self._handle))

    @property
    def admissible(self) -> bool:
        """Whether Eq. (24) applies: (3), (4), (35), and the contact carries its mean load."""
        return not self.reasons

    @property
    def reasons(self) -> tuple[str, ...]:
        """Why the scene is not admissible, a sentence each; empty when it is."""
        return tuple(_vcrit.reasons(self._handle))

    @property
    def certified_critical_velocity(self) -> CertifiedVelocity:
        """v* of Eq. (24), correctly rounded, with a bound on its error.

        Raises InputError for missing values, ModelError where v* is 0/0.
        """
        return CertifiedVelocity(*_vcrit.certified(self._handle))

    @property
    def critical_onset(self) -> CriticalOnset:
        """v* of the motion: by Eq. (24) where it holds, else, where surfaces part, simulated.

        Raises InputError for missing values, ModelError where v* is 0/0 or the scene is outside
        the model.
        """
        return CriticalOnset(*_vcrit.critical_onset(self._handle))

    @property
    def drive_velocity(self) -> float:
        """m/s: v*, and what the drive must run faster where a network on the path creeps."""
        return self.critical_onset.drive_velocity

    @overload
    def critical_velocity(  # type: ignore[misc]  # numbers are array-like, too
            self, values: Mapping[str, Value] | None = None, /, **named: Value) -> float: ...

    @overload
    def critical_velocity(self, values: Mapping[str, npt.ArrayLike] | None = None, /, *,
                          out: Array | None = None, **named: npt.ArrayLike) -> Array: ...

    def critical_velocity(self, values: Mapping[str, Any] | None = None, /, *,
                          out: Any = None, **named: Any) -> Any:
        """v* of Eq. (24) in m/s: correctly rounded, or over arrays of any parameters.

        critical_velocity(frequency=f, k0=k[:, np.newaxis]) takes the names of `settable`; arrays
        (SI) are broadcast as in NumPy, texts carry a unit, and names that are none in Python go
        in a mapping. Arrays of float64 are used where they lie; `out` takes the result. Other
        threads run meanwhile. Infinite at resonance, NaN where Eq. (24) is 0/0.
        Raises InputError, ModelError.
        """
        given = {**(values or {}), **named}
        if not given and out is None:
            return self.certified_critical_velocity.value
        texts = {name: value for name, value in given.items() if isinstance(value, str)}
        scene = self.with_values(texts) if texts else self
        arrays = {name: value for name, value in given.items() if name not in texts}
        return evaluated(scene._handle, arrays, out)

    def friction_curve(self, velocities: npt.ArrayLike | None = None, *,
                       velocity_ratios: npt.ArrayLike | None = None) -> FrictionCurve:
        """Friction at each speed of an array, by exact event-driven simulation.

        velocities: mean velocities of the drive, m/s, or velocity_ratios: the same in units of
        v*. A speed without an answer is NaN and has a reason. Other threads run meanwhile.
        Raises InputError, ModelError.
        """
        velocity, ratio = self._speeds(velocities, velocity_ratios)
        friction, error = np.empty_like(velocity), np.empty_like(velocity)
        regimes, reasons = _vcrit.friction_curve(self._handle, velocity, friction, error)
        return FrictionCurve(velocity, ratio, friction, error,
                             np.array(regimes, dtype=np.str_).reshape(velocity.shape),
                             np.array(reasons, dtype=np.str_).reshape(velocity.shape))

    def simulate(self, velocity: Value | None = None, *, velocity_ratio: float | None = None,
                 method: str = "exact", start: str = "sliding") -> SteadyState:
        """The steady motion at one speed, as `vcrit simulate`.

        velocity: mean velocity of the drive, m/s or a text with a unit, or velocity_ratio: the
        same in units of v*. method: "exact", or one beside it. start: "sliding" or "rest".
        Raises InputError, ModelError.
        """
        if isinstance(velocity, str):
            velocity = _vcrit.parse_velocity(velocity)
        speed, ratio = self._speeds(velocity, velocity_ratio)
        friction, error, regime, periods, events, energy = _vcrit.simulate(
            self._handle, float(speed), method, start)
        return SteadyState(float(speed), float(ratio), friction, error, regime, method, periods,
                           tuple(Event(*event) for event in events),
                           None if energy is None else Energy(*energy))

    def _speeds(self, velocities: npt.ArrayLike | None,
                ratios: npt.ArrayLike | None) -> tuple[Array, Array]:
        """Velocities and their ratios to v*, as contiguous arrays."""
        if (velocities is None) == (ratios is None):
            raise TypeError("either velocities or their ratios to v* must be given")
        given = velocities if ratios is None else ratios
        speeds = np.array(given, dtype=np.float64, order="C")
        critical, _, _, reason = self.critical_onset
        if ratios is not None:
            if np.isinf(critical):
                raise _vcrit.ModelError(
                    f"{reason}: --velocity-ratio has no meaning, give --velocity")
            speeds *= critical
        _vcrit.check_speeds(speeds, "--velocity" if ratios is None else "--velocity-ratio")
        with np.errstate(divide="ignore"):  # v* = 0 at antiresonance
            return speeds, speeds / critical
