"""Up to which sliding velocity can normal oscillation reduce friction?

    import vcrit

    scene = vcrit.Scene("scenes/zener.toml")
    scene.critical_velocity()                        # v* in m/s, correctly rounded
    scene.critical_velocity(frequency=frequencies)   # over an array
    scene.friction_curve(velocity_ratios=[0.1, 0.5]) # by simulation of stick-slip
    scene.solve("amplitude", 0.8, velocity="2 mm/s") # the smallest for a friction ratio
    scene.sweep({"frequency": frequencies}, "critical_velocity")
    scene.plot()                                     # by matplotlib; svg() needs nothing
    vcrit.derive(scene)                              # the formula; a notebook shows it
    vcrit.fit("data.csv")                            # a scene from measured stiffness

All numbers are in SI units. A text carries its unit: "8 N/um".
"""

try:
    import numpy as _numpy  # noqa: F401

    from . import _vcrit
except ImportError as error:
    from .wrong_python import why

    raise ImportError(why(error)) from error

from ._vcrit import Error, InputError, ModelError
from ._vcrit import version as __version__
from .derivation import Derivation, Equation, Limit, derive
from .fitting import Branches, Fit, KnownStiffness, Uncertain, fit
from .results import (
    CertifiedVelocity,
    CriticalOnset,
    Energy,
    Event,
    FrictionCurve,
    Parameter,
    SteadyState,
)
from .scene import Scene
from .solving import Solution
from .sweeping import Sweep

__all__ = [
    "Branches",
    "CertifiedVelocity",
    "CriticalOnset",
    "Derivation",
    "Energy",
    "Equation",
    "Error",
    "Event",
    "Fit",
    "FrictionCurve",
    "InputError",
    "KnownStiffness",
    "Limit",
    "ModelError",
    "Parameter",
    "Scene",
    "Solution",
    "SteadyState",
    "Sweep",
    "Uncertain",
    "__version__",
    "derive",
    "fit",
]
