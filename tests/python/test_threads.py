"""Other threads run while C++ works, several may call at once, and Ctrl-C is heard."""

import sys
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import vcrit
from support import PROJECT, in_python
from vcrit import _vcrit

# A drive with a mass of its own: each v* takes microseconds.
SLOW = vcrit.Scene("scenes/sonotrode.toml")
KELVIN = vcrit.Scene("scenes/kelvin.toml")
ATTEMPTS = 200


class Watched:
    """A call in a thread of its own, while Python is never made to change threads: another one
    sees it under way only if the call itself lets go of the interpreter."""

    def __init__(self, call):
        self.call, self.under_way, self.done, self.error = call, False, False, None

    def run(self):
        self.under_way = True
        try:
            self.call()
        except Exception as error:  # told by who waits
            self.error = error
        self.done = True

    def seen_under_way(self):
        worker = threading.Thread(target=self.run)
        worker.start()
        seen = False
        while not self.done:
            seen = seen or (self.under_way and not self.done)
            time.sleep(0)
        worker.join()
        if self.error:
            raise self.error
        return seen


def lets_others_run(call):
    before = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    try:
        return any(Watched(call).seen_under_way() for _ in range(ATTEMPTS))
    finally:
        sys.setswitchinterval(before)


class OtherThreads(unittest.TestCase):
    # Below 500 values NumPy itself does not let go.
    def test_run_while_arrays_are_evaluated(self):
        formula = _vcrit.CriticalVelocities(SLOW._handle, ["frequency"])
        frequency, out = np.linspace(10e3, 30e3, 400), np.empty(400)
        self.assertTrue(lets_others_run(lambda: formula([frequency], out)))

    def test_run_during_a_simulation(self):
        speeds = np.linspace(0.01, 0.02, 30)
        room = np.empty(30), np.empty(30)
        self.assertTrue(lets_others_run(lambda: _vcrit.friction_curve(KELVIN._handle, speeds, *room)))
        self.assertTrue(lets_others_run(lambda: _vcrit.simulate(KELVIN._handle, 0.01, "moreau", "sliding")))

    def test_run_while_solving_sweeping_and_fitting(self):
        self.assertTrue(lets_others_run(lambda: _vcrit.solve(KELVIN._handle, "velocity", 0.9, "", "", "", 50)))
        axis = _vcrit.axis_of_array(KELVIN._handle, "velocity_ratio", np.linspace(0.1, 0.9, 50))
        self.assertTrue(lets_others_run(lambda: _vcrit.sweep(KELVIN._handle, [axis], ["friction_ratio"], "", "")))
        table = "frequency,storage,loss\n1,2,0.2\n4,2.2,0.2\n16,2.5,0.2\n63,2.9,0.3\n250,3.3,0.3\n1000,3.8,0.4\n"
        self.assertTrue(lets_others_run(lambda: _vcrit.fit(table, b"data", "", False, 20, {})))
        self.assertTrue(lets_others_run(lambda: _vcrit.svg(KELVIN._handle, "friction", None, 0.0)))

    def test_run_while_one_value_is_certified(self):
        self.assertTrue(lets_others_run(lambda: [_vcrit.certified(SLOW._handle) for _ in range(20)]))

    def test_run_during_a_derivation(self):
        self.assertTrue(lets_others_run(
            lambda: _vcrit.document(KELVIN._handle, "text", "nested", False, False, False)))

    def test_wait_while_a_scene_is_read(self):
        # This shows that what is asserted above can fail.
        text = (PROJECT / "scenes/kelvin.toml").read_text()
        self.assertFalse(lets_others_run(lambda: _vcrit.Scene(text, b"kelvin", [])))


class SeveralThreads(unittest.TestCase):
    FILES = [f"scenes/{name}.toml" for name in ["zener", "kelvin", "elastic", "burgers", "bridge"]]

    def everything(self, file):
        scene = vcrit.Scene(file)
        frequency = np.linspace(10e3, 12e3, 70_000)
        curve = scene.friction_curve(velocity_ratios=np.linspace(0.1, 1.1, 40))
        return [scene.critical_velocity(frequency=frequency), curve.friction_ratio, curve.regime,
                scene.certified_critical_velocity, scene.simulate(velocity_ratio=0.5).friction_ratio,
                vcrit.derive(scene).latex, scene.with_values(mu0=0.1).critical_velocity()]

    def test_get_the_answers_of_one(self):
        alone = [self.everything(file) for file in self.FILES]
        with ThreadPoolExecutor(10) as pool:
            together = list(pool.map(self.everything, self.FILES * 4))
        self.assertEqual(len(together), 4 * len(alone))
        for found, expected in zip(together, alone * 4):
            for one, other in zip(found, expected):
                np.testing.assert_array_equal(one, other)

    def test_may_share_a_scene_and_a_formula(self):
        formula = _vcrit.CriticalVelocities(KELVIN._handle, ["frequency"])
        frequency = np.linspace(10e3, 30e3, 10_000)

        def run(_):
            out = np.empty_like(frequency)
            formula([frequency], out)
            return out

        with ThreadPoolExecutor(8) as pool:
            for out in pool.map(run, range(64)):
                np.testing.assert_array_equal(out, KELVIN.critical_velocity(frequency=frequency))


class KeyboardInterrupts(unittest.TestCase):
    """A thread watches the first value appear and presses Ctrl-C."""

    def assert_interrupted(self, call, scene='vcrit.Scene("scenes/sonotrode.toml")', number="10**6"):
        result = in_python(INTERRUPTED.replace("CALL", call).replace("SCENE", scene).replace("NUMBER", number))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "interrupted\n")

    def test_end_an_evaluation(self):
        self.assert_interrupted("scene.critical_velocity(frequency=values, out=out)")

    def test_end_a_friction_curve(self):
        self.assert_interrupted("vcrit._vcrit.friction_curve("
                                "vcrit.Scene('scenes/kelvin.toml')._handle, values / 1e6, out, np.empty(n))")


    def assert_heard_inside(self, name, call):
        result = in_python(HEARD_INSIDE.replace("NAME", name).replace("CALL", call))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "c_exception\n")

    def test_end_a_simulation(self):
        self.assert_heard_inside("simulate", "slow.simulate(velocity_ratio=0.5)")
        self.assert_heard_inside("simulate", "slow.simulate(velocity_ratio=0.5, method='moreau')")
        self.assert_heard_inside("simulate", "slow.simulate(velocity_ratio=0.5, method='rk8pd')")

    def test_end_simulations_of_the_critical_velocity(self):
        # Fewer values than a block of the package: one call of C++.
        self.assert_interrupted(
            "scene.critical_velocity(frequency=values, out=out)", number="50_000",
            scene='vcrit.Scene.from_text(open("scenes/separation.toml").read()'
                  '.replace("poisson    = 0.3", "tangential = \\"kelvin(k0, c1)\\""))')

    def test_end_a_derivation(self):
        self.assert_heard_inside("document", "derived.document('json', sensitivities=True)")

    def test_end_solving_sweeping_and_fitting(self):
        self.assert_heard_inside("solve", "slow.solve('velocity', 0.9)")
        self.assert_heard_inside("sweep", "slow.sweep({'velocity_ratio': np.linspace(0.1, 0.9, 2000)}, 'friction_ratio')")
        self.assert_heard_inside("fit", "vcrit.fit(many_branches)")

    def test_end_the_search_for_a_normal_force(self):
        self.assert_heard_inside("critical_onset", "separating.critical_onset")
        self.assert_heard_inside("certified", "separating.certified_critical_velocity")

    def test_end_the_search_for_free_harmonics(self):
        self.assert_heard_inside("critical_onset", "dense.critical_onset")


# Many relaxation times: a simulation takes a second, sensitivities more.
HEARD_INSIDE = """
import signal, sys, threading, time
import numpy as np
import vcrit
from scene_text import scene

n = 200
slow = vcrit.Scene.from_text(scene(
    {"k0": 8e6, "kt": 1e6, "kd": 2e6, "cd": 3, "k": [1e5 + i for i in range(n)], "tau": [1e-6 * 1.01**i for i in range(n)]},
    normal="prony(k0, k, tau)", tangential="kt | prony(k0, k, tau)", network="kd | cd", mass=5e-3, frequency=2e4,
    amplitude=1e-7, indentation=5e-7))
# Of a contact that opens the normal force is searched for, with more branches.
m = 500
separating = vcrit.Scene.from_text(scene(
    {"k0": 8e6, "kt": 1e6, "ct": 3, "k": [1e5 + i for i in range(m)], "tau": [1e-6 * 1.01**i for i in range(m)]},
    normal="prony(k0, k, tau)", tangential="kt | ct", separation=True, frequency=2e4, amplitude=4e-7, indentation=5e-7))
# Each two of a hundred nodes with masses, at a hundred harmonics.
nodes = ["a", "b", *(f"n{i}" for i in range(100))]
pairs = [(a, b) for i, a in enumerate(nodes) for b in nodes[i + 1:]][1:]
edges = [[f"k{i}", *pair] for i, pair in enumerate(pairs)] + [[f"mass(m{i})", f"n{i}", "b"] for i in range(100)]
values = {f"k{i}": 1 + i % 7 for i in range(len(pairs))} | {f"m{i}": 1 + i % 5 for i in range(100)}
dense = vcrit.Scene.from_text(scene({"kn": 1, "kt": 1} | values, {"g": (["a", "b"], edges)}, tangential="kt", network="g",
                                    mass=1, angular_frequency=3))
times = 2j * np.pi * np.geomspace(1, 1e6, 400)[:, np.newaxis] * np.geomspace(1e-6, 1, 12)
stiffness = 1e6 + (1e5 * times / (1 + times)).sum(axis=1)
many_branches = {"frequency": np.geomspace(1, 1e6, 400), "storage": stiffness.real, "loss": stiffness.imag}
derived = vcrit.derive(slow)  # which asks for a document, too
under_way, ended = threading.Event(), []

def press():
    under_way.wait()
    time.sleep(0.05)
    signal.raise_signal(signal.SIGINT)

# How the call ends: by an exception of its own, or first it returns and then Ctrl-C is heard.
def watch(frame, event, function):
    if event.startswith("c_") and getattr(function, "__name__", "") == "NAME":
        under_way.set() if event == "c_call" else ended.append(event)

threading.Thread(target=press).start()
sys.setprofile(watch)
try:
    CALL
except KeyboardInterrupt:
    pass
sys.setprofile(None)
print(*ended[-1:])
"""

INTERRUPTED = """
import signal, threading, time
import numpy as np
import vcrit

n = NUMBER
scene = SCENE
values, out = np.linspace(10e3, 30e3, n), np.full(n, -1.0)

def press():
    while out[0] == -1:
        time.sleep(0.001)
    signal.raise_signal(signal.SIGINT)

threading.Thread(target=press).start()
try:
    CALL
except KeyboardInterrupt:
    print("interrupted" if out[-1] == -1 else "too late")
"""

if __name__ == "__main__":
    unittest.main()
