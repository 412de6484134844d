"""Up to which sliding velocity can normal oscillation reduce friction?

    import vcrit

    scene = vcrit.Scene("scenes/zener.toml")
    scene.critical_velocity()                        # v* in m/s, correctly rounded
    scene.critical_velocity(frequency=frequencies)   # over an array
    scene.friction_curve(velocity_ratios=[0.1, 0.5]) # by simulation of stick-slip
    vcrit.derive(scene)                              # the formula; a notebook shows it

All numbers are in SI units. A text carries its unit: "8 N/um".
"""

from ._vcrit import Error, InputError, ModelError
from ._vcrit import version as __version__
from .derivation import Derivation, Equation, Limit, derive
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

__all__ = [
    "CertifiedVelocity",
    "CriticalOnset",
    "Derivation",
    "Energy",
    "Equation",
    "Error",
    "Event",
    "FrictionCurve",
    "InputError",
    "Limit",
    "ModelError",
    "Parameter",
    "Scene",
    "SteadyState",
    "__version__",
    "derive",
]
