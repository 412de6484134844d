"""A scene: the system that a file describes, and the answers about it."""

import os
import warnings
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, TypeAlias, overload

import numpy as np
import numpy.typing as npt

from . import _vcrit, pictures
from .batch import evaluated
from .inputs import (
    characters,
    is_labelled,
    is_text,
    labelled,
    ma,
    name_of_file,
    number_with_unit,
    numbers,
    refused,
    text_with_unit,
)
from .results import (
    CertifiedVelocity,
    CriticalOnset,
    Event,
    FrictionCurve,
    Parameter,
    SteadyState,
)
from .solving import Solution, solution
from .speeds import Speeds
from .sweeping import Sweep, sweep

Value: TypeAlias = float | str
Array: TypeAlias = npt.NDArray[np.float64]


class Scene:
    """A contact, its drive and its oscillation, from a TOML file. Does not change.

    Scenes of one text, file and settings are equal, and may be keys of a dict.
    Raises InputError for whatever is wrong with the file; warns of what has no effect in it.
    """

    _text: str
    _file: str
    _settings: Mapping[str, str]
    _handle: _vcrit.Scene

    def __init__(self, file: "str | os.PathLike[str]") -> None:
        name = os.fspath(file)
        self._read(_vcrit.read_file(name_of_file(name)), os.fsdecode(name), {})
        self._warn()

    @classmethod
    def from_text(cls, text: str, file: str = "scene") -> "Scene":
        """A scene from TOML text; `file` names it in messages, and a measured drive is looked for
        beside it."""
        scene = cls._made(characters(text, "text"), file, {})
        scene._warn()
        return scene

    @classmethod
    def _made(cls, text: str, file: str, settings: Mapping[str, str]) -> "Scene":
        scene = cls.__new__(cls)
        scene._read(text, file, settings)
        return scene

    def _read(self, text: str, file: str, settings: Mapping[str, str]) -> None:
        handle = _vcrit.Scene(text, name_of_file(file), list(settings.items()))
        # A table is beside the file, wherever the process goes or the scene is sent to.
        if handle.reads_tables and not os.path.isabs(file):
            return self._read(text, os.path.abspath(file), settings)
        for name, value in {"_text": text, "_file": file, "_handle": handle,
                            "_settings": MappingProxyType(dict(settings))}.items():
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"a scene does not change ({name}); with_values() makes another")

    def __delattr__(self, name: str) -> None:
        self.__setattr__(name, None)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return NotImplemented
        return self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def _identity(self) -> tuple[Any, ...]:
        return self._text, self._file, frozenset(self._settings.items())

    def _warn(self, known: tuple[str, ...] = ()) -> None:
        for warning in self._handle.warnings:
            if warning not in known:
                warnings.warn(warning, stacklevel=3)

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene._made, (self._text, self._file, dict(self._settings))

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
            characters(name, "name of a value")
            settings[name] = (characters(value, name) if isinstance(value, str)
                              else number_with_unit(value, name))
        scene = Scene._made(self._text, self._file, settings)
        scene._warn(known=self.warnings)
        return scene

    @property
    def title(self) -> str:
        """As the file says; may be empty."""
        return self._handle.title

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings: entries of the file that have no effect, and a frequency beyond its
        fitted_range."""
        return tuple(self._handle.warnings)

    @property
    def parameters(self) -> Mapping[str, Parameter]:
        """The numbers of the scene by the symbols of its formulas: mu0, omega, du_z, u_z0, m, or
        what the scene calls them, and the elements, as far as they are there."""
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
    def in_words(self) -> str:
        """What vibration does: "Vibration lowers friction below 4.095 mm/s, by at most 25 %."

        Raises InputError for missing values, ModelError where v* is 0/0.
        """
        return _vcrit.in_words(self._handle)[0]

    @property
    def certified_critical_velocity(self) -> CertifiedVelocity:
        """v* as `vcrit eval` prints it: of Eq. (24), correctly rounded, with a bound on its error.

        Where the contact opens and Eq. (24) does not hold, it is simulated, and its bound is NaN.
        Raises InputError for missing values, ModelError where v* is 0/0 or the scene is outside
        the model.
        """
        return CertifiedVelocity(*_vcrit.certified(self._handle))

    @property
    def critical_onset(self) -> CriticalOnset:
        """v* of the motion: by Eq. (24) where that holds, by simulation where the contact opens.

        Raises InputError for missing values, ModelError where v* is 0/0 or the scene is outside
        the model.
        """
        return CriticalOnset(*_vcrit.critical_onset(self._handle))

    @property
    def drive_velocity(self) -> float:
        """m/s: speed of the drive at v*. It is larger than v* where a network on the path creeps."""
        return self.critical_onset.drive_velocity

    @overload
    def critical_velocity(  # type: ignore[misc]  # numbers are array-like, too
            self, values: Mapping[str, Value] | None = None, /, **named: Value) -> float: ...

    @overload
    def critical_velocity(self, values: Mapping[str, npt.ArrayLike] | None = None, /, *,
                          out: Array | None = None, **named: npt.ArrayLike) -> Array: ...

    def critical_velocity(self, values: Mapping[str, Any] | None = None, /, *,
                          out: Any = None, **named: Any) -> Any:
        """v* in m/s: as `vcrit eval` prints it, or over arrays of any parameters.

        critical_velocity(frequency=f, k0=k[:, np.newaxis]) takes the names of `settable`; arrays
        (SI) are broadcast as in NumPy, texts carry a unit, and names that are none in Python go
        in a mapping. Arrays of float64 are used where they lie; `out` takes the result. Other
        threads run meanwhile. It is Eq. (24), and where the contact opens and that does not hold,
        one simulation a point. Infinite at resonance, NaN where v* is 0/0, the point is outside
        the model or one of its values is NaN.

        Masks, units of quantities (pint, astropy), the dimensions of xarray and the index of a
        pandas Series are kept. Raises InputError, with the index of the first wrong value and
        `out` as it was, ModelError.
        """
        if out is not None and "out" in self.settable:
            raise refused("out", "one name for the array of results and for an element of this scene",
                          'the element in a mapping, critical_velocity({"out": values}), without out')
        given = {**(values or {}), **named}
        if not given and out is None:
            return self.certified_critical_velocity.value
        for name in given:
            characters(name, "name of a value")
        texts = {name: value for name, value in given.items() if is_text(value)}
        scene = self.with_values(texts) if texts else self
        arrays = {name: value for name, value in given.items() if name not in texts}
        return evaluated(scene._handle, arrays, out)

    def friction_curve(self, velocities: npt.ArrayLike | None = None, *,
                       velocity_ratios: npt.ArrayLike | None = None) -> FrictionCurve:
        """Friction at each speed of an array, by exact event-driven simulation.

        velocities: mean velocities of the drive, m/s, or velocity_ratios: the same in units of
        v*. A speed without an answer, NaN among them, is NaN and has a reason. Masks, units and
        labels of the speeds are kept. Other threads run meanwhile. Raises InputError, ModelError.
        """
        speeds = Speeds.of(velocities, velocity_ratios)
        if not is_labelled(speeds.given):
            return self._curve(speeds)
        return FrictionCurve(*labelled(
            lambda plain: tuple(self._curve(speeds._replace(given=plain[speeds.name]))),
            {speeds.name: speeds.given}, len(FrictionCurve._fields), lambda name: speeds.parse))

    def _curve(self, speeds: Speeds) -> FrictionCurve:
        given = numbers(speeds.given, speeds.name, speeds.parse)
        velocity, ratio = speeds.in_both_units(self._handle, given.values)
        known = ~np.isnan(velocity)
        friction, error = np.full(velocity.shape, np.nan), np.full(velocity.shape, np.nan)
        regime = np.full(velocity.shape, "", dtype=object)
        reason = np.full(velocity.shape, "the speed is no number", dtype=object)
        found = np.empty((2, np.count_nonzero(known)))
        regimes, reasons = _vcrit.friction_curve(self._handle, velocity[known], *found)
        friction[known], error[known] = found
        regime[known], reason[known] = regimes, reasons
        curve = (velocity, ratio, friction, error, regime.astype(np.str_), reason.astype(np.str_))
        if given.mask is None:
            return FrictionCurve(*curve)
        return FrictionCurve(*(ma.MaskedArray(values, given.mask) for values in curve))

    def simulate(self, velocity: Value | None = None, *, velocity_ratio: Value | None = None,
                 method: str = "exact", start: str = "sliding") -> SteadyState:
        """The steady motion at one speed, as `vcrit simulate`.

        velocity: mean velocity of the drive, m/s or a text with a unit, or velocity_ratio: the
        same in units of v*. method: "exact", or one beside it. start: "sliding" or "rest".
        Raises InputError, ModelError.
        """
        speed, ratio = Speeds.of(velocity, velocity_ratio).one(self._handle)
        friction, error, regime, periods, events, agree = _vcrit.simulate(
            self._handle, speed, characters(method, "method"), characters(start, "start"))
        state = SteadyState(speed, ratio, friction, error, regime, method, periods,
                            tuple(Event(*event) for event in events), agree)
        return state._in(self) if method == "exact" else state

    def solve(self, sought: str, friction_ratio: Value, *, velocity: Value | None = None,
              from_: Value | None = None, to: Value | None = None,
              samples: int | None = None) -> Solution:
        """What reaches mu_macro/mu0 = `friction_ratio`, as `vcrit solve`.

        sought: "amplitude" or "frequency", of which the smallest is found at this `velocity` of the
        drive, or "velocity", of which the largest is. from_, to: the range to search. samples: how
        many values of it are tried, 400 or, below an indenter, 32. Numbers in SI or texts with a
        unit, a ratio "80%" as well. Raises InputError, and ModelError where nothing in the range
        reaches the ratio: it says why, and what would.
        """
        return solution(self._handle, sought, friction_ratio, velocity, from_, to, samples)

    def sweep(self, over: Mapping[str, npt.ArrayLike], quantity: str | Sequence[str], *,
              velocity: Value | None = None, velocity_ratio: Value | None = None) -> Sweep:
        """Quantities over a grid, as `vcrit sweep`, in memory and on all cores.

        over: names of `settable`, "velocity" or "velocity_ratio", each with its values (SI, or texts
        with a unit) or a text: "log:1 kHz:1 MHz:31", "lin:0.1:1:10", "list:FILE". quantity: one or
        several of "critical_velocity", "friction_ratio", "friction_ratio_error", "regime",
        "admissible", "sensitivity:NAME". velocity, velocity_ratio: one speed for all points.
        Warns of points outside the model, which are NaN. Raises InputError.
        """
        return sweep(self._handle, over, quantity, velocity, velocity_ratio)

    def svg(self, of: str = "friction", *, to: Value | None = None, velocity: Value | None = None,
            velocity_ratio: Value | None = None) -> str:
        """A picture as SVG, as `vcrit plot` draws it.

        of: "friction" over the speed, up to `to`; "frequency", v* over it; or "cycle", force and
        velocity over one period at a speed, half of v* unless it is given.
        Raises InputError, ModelError.
        """
        return _vcrit.svg(self._handle, characters(of, "of"), *self._shown(of, to, velocity, velocity_ratio))

    def plot(self, of: str = "friction", *, to: Value | None = None, velocity: Value | None = None,
             velocity_ratio: Value | None = None, ax: Any = None) -> Any:
        """The same by matplotlib: its axes, two of a cycle, or into those given as `ax`.

        Raises InputError, ModelError, and ImportError where there is no matplotlib.
        """
        return pictures.drawn(self._handle, characters(of, "of"),
                              *self._shown(of, to, velocity, velocity_ratio), ax)

    def _shown(self, of: str, to: Any, velocity: Any, ratio: Any) -> tuple[float | None, float]:
        end = None if to is None else _vcrit.parse_velocity(text_with_unit(to, "to"), "to")
        if of != "cycle":
            return end, 0.0
        if velocity is None and ratio is None:
            ratio = 0.5
        return end, Speeds.of(velocity, ratio).one(self._handle)[0]

    def _repr_html_(self) -> str:
        """For notebooks: what vibration does here, and the curve of friction."""
        title = self.title or self._file
        try:
            words = _vcrit.in_words(self._handle)
        except _vcrit.Error as error:
            return pictures.notebook(title, [str(error)], "")
        try:
            return pictures.notebook(title, words, self.svg())
        except _vcrit.ModelError:  # nothing to draw, as the words say
            return pictures.notebook(title, words, "")
