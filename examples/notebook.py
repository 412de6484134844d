# Up to which speed can oscillation reduce friction? One scene from formula to friction, as a notebook
# in cells (# %%), which Jupyter (by Jupytext), VS Code and Spyder open; it runs as a script as well.
#
# Exact solution: Eq. (24); beside it a simulation of stick-slip that knows nothing of Eq. (24).

# %% A scene: a polymer pad, pulled through an elastic drive
from pathlib import Path

import numpy as np
import vcrit

scene = vcrit.Scene(Path(__file__).parent.parent / "scenes/zener.toml")
print(scene.title)
for name, (value, unit) in scene.parameters.items():
    print(f"  {name:8} {value:10.4g} {unit}")

# %% Its critical velocity, with a bound on the error
velocity, bound, _ = scene.certified_critical_velocity
print(f"v* = {velocity} m/s, relative error at most {bound:.1e}")
print("admissible:", scene.admissible)

# %% The formula, derived for exactly this scene
formula = vcrit.derive(scene)
formula

# %% One of its limits: the drive becomes rigid
rigid = next(limit for limit in formula.limits if limit.name == "kd -> infinity")
rigid

# %% A map: v* over frequency and stiffness of the drive
frequency = np.linspace(1e3, 12e3, 67)  # Hz
drive = np.linspace(9e6, 1e6, 9)[:, np.newaxis]  # N/m
v_star = scene.critical_velocity(frequency=frequency, kd=drive)

# %% Drawn in letters: @ at the resonance kd = m omega^2, blank at the antiresonance
shades = " .:-=+*#%@"
level = np.interp(np.log10(v_star), [-4, 0], [0, len(shades) - 1]).astype(int)
for stiffness, row in zip(drive.flat, level):
    print(f"{stiffness / 1e6:4.1f} N/um |" + "".join(shades[i] for i in row) + "|")
print(f"          {frequency[0] / 1e3:.0f} kHz{'':57}{frequency[-1] / 1e3:.0f} kHz")

# %% Friction by simulation: reduced below v*, and not above
curve = scene.friction_curve(velocity_ratios=np.array([0.05, 0.1, 0.2, 0.5, 0.8, 0.95, 1.05, 1.5]))
for ratio, friction, regime in zip(curve.velocity_ratio, curve.friction_ratio, curve.regime):
    print(f"v = {ratio:4.2f} v*   friction {friction:.6f}   {regime}")

# %% Where the formula says that sliding begins, the simulation begins to slide
just = scene.friction_curve(velocity_ratios=[1 - 1e-6, 1 + 1e-6])
print("just below v*:", just.regime[0])
print("just above v*:", just.regime[1])
