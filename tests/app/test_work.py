"""Work is bounded whatever a scene asks for: contacts of very many branches, and bodies on drives next to harmonics of the
oscillation. The program counts what it does, so each command ends with an answer or with the reason on every machine."""

import random
import unittest

from program import Case, run, scene


def branches(name, count, generator, decades):
    """An array of stiffnesses and one of relaxation times for prony()."""
    times = [10 ** generator.uniform(-decades, decades) for _ in range(count)]
    return {f"{name}k": [generator.uniform(0.5, 1.5) / count for _ in range(count)], f"{name}tau": times}


def series(count, **changed):
    elements = {"k0": 1, "kt": 1, "ct": 0.5, "kd": 1} | branches("n", count, random.Random(count), 3)
    return scene(elements, **({"normal": "prony(k0, nk, ntau)"} | changed))


BODY = {"network": "kd", "mass": 0.3}
OPEN = {"tangential": "kt | ct", "separation": True, "amplitude": 0.9}
HALF = ["--velocity-ratio", 0.5]


class ManyBranches(Case):
    def test_a_closed_contact_of_3000_is_evaluated_and_not_simulated(self):
        for body in ({}, BODY):
            file = self.write(series(3000, **body))
            self.answer("eval", file)
            self.refused(3, ["simulate", file, *HALF], "too many branches")

    def test_the_normal_force_of_3000_is_not_found(self):
        for body in ({}, BODY):
            file = self.write(series(3000, **OPEN, **body))
            self.refused(3, ["eval", file], "normal network has too many branches")
        self.refused(3, ["simulate", file, *HALF], "normal network has too many branches")

    def test_more_than_4000_are_not_simulated_at_all(self):
        self.refused(3, ["eval", self.write(series(4001, **OPEN))], "at most 4000")

    def test_300_are_simulated(self):
        self.answer("simulate", self.write(series(300)), *HALF)
        self.answer("eval", self.write(series(300, **OPEN)))


class DrivesAtHarmonics(Case):
    """kd = m (n omega)^2 (1 +- 10^-k), with and without a faint damper, under networks of up to 20 branches."""

    def drawn(self, seed):
        generator = random.Random(seed)
        elements = {}
        for name in ("n", "t"):
            elements |= {f"k{name}": 1} | branches(name, generator.choice([1, 3, 8, 20]), generator, 3)
        mass, omega = 10 ** generator.uniform(-3, 2), 10 ** generator.uniform(-1, 1)
        share = generator.choice([-1, 1]) * 10.0 ** -generator.randint(3, 15)
        elements["kd"] = mass * (generator.randint(1, 10) * omega) ** 2 * (1 + share)
        elements["cd"] = elements["kd"] / omega * 10 ** generator.uniform(-15, -3)
        return self.write(scene(elements, normal="prony(kn, nk, ntau)", tangential="prony(kt, tk, ttau)",
                                network=generator.choice(["kd", "kd | cd"]), mass=mass, separation=True,
                                angular_frequency=omega, amplitude=generator.uniform(0.3, 3)))

    def test_end_with_an_answer_or_a_reason(self):
        answered = 0
        for seed in range(8):
            file = self.drawn(seed)
            for command in (["eval", file], ["simulate", file, "--velocity", 0.05]):
                done = run(*command)
                self.assertIn(done.returncode, (0, 3), done.stderr)
                self.assertTrue(done.stderr or done.returncode == 0)
                answered += done.returncode == 0
        self.assertGreater(answered, 8)


if __name__ == "__main__":
    unittest.main()
