"""A contact whose stiffness is typed in as K(s), through all commands, against mpmath's K(i omega)."""
import unittest

import mpmath as mp

from program import Case, scene, unbroken

OMEGA, MU, AMPLITUDE, KT = 1.25e5, 0.3, 1e-7, 3e6
TYPED = "(12e6*s + 8e9)/(s + 1e3) + 2*s + 3e6*s/(s + 2e5)"


def stiffness(omega):
    s = mp.mpc(0, omega)
    return (mp.mpf("12e6") * s + mp.mpf("8e9")) / (s + 1000) + 2 * s + 3000000 * s / (s + 200000)


class TypedStiffness(Case):
    def pad(self, typed=TYPED, **changed):
        self.write(scene({"kt": KT}, normal="pad", tangential="pad | kt", amplitude=AMPLITUDE, indentation=1e-5,
                         angular_frequency=OMEGA, **changed) + f'[networks.pad]\nstiffness = "{typed}"\n')

    def test_v_is_that_of_the_function(self):
        self.pad()
        with mp.workdps(40):
            k = stiffness(OMEGA)
            expected = mp.mpf("0.3") * OMEGA * mp.mpf("1e-7") * abs(k) / abs(k + KT)
            self.assertLess(abs(self.answer("eval", "s.toml")["critical_velocity"] / expected - 1), 3e-16)

    def test_the_formula_has_its_elements_and_other_frequencies_follow(self):
        self.pad()
        text = unbroken(self.out("derive", "s.toml", "--form", "nested"))
        self.assertIn("K_n = k0_pad + c_pad*s + k_pad[1]*tau_pad[1]*s/(1 + tau_pad[1]*s)", text)
        for row in self.table("s.toml", "--over", "omega=log:1e2:1e7:5", "--quantity", "critical_velocity"):
            omega = float(row["omega"])
            k = stiffness(omega)
            v = MU * omega * AMPLITUDE * abs(k) / abs(k + KT)
            self.assertLess(abs(float(row["critical_velocity"]) / v - 1), 1e-14)

    def test_the_motion_is_that_of_the_network_written_out(self):
        self.pad()
        typed = self.answer("simulate", "s.toml", "--velocity-ratio", 0.4)
        self.write(scene({"kt": KT, "k0": 8e6, "c0": 2, "k": [4e6, 3e6], "tau": [1e-3, 5e-6]},
                         normal="c0 | prony(k0, k, tau)", tangential="c0 | prony(k0, k, tau) | kt", amplitude=AMPLITUDE,
                         indentation=1e-5, angular_frequency=OMEGA))
        written = self.answer("simulate", "s.toml", "--velocity-ratio", 0.4)
        self.assertAlmostEqual(typed["friction_ratio"], written["friction_ratio"], delta=1e-12)

    def test_what_is_not_passive_or_cannot_be_read_gets_one_line(self):
        for typed, words in (("(4e6*s + 8e9)/(s + 1e3)", "s = -1000 rad/s, a Maxwell branch of stiffness -4e+06"),
                             ("8e6 + s/(s^2 + 2*s + 5)", "2 of the 2 poles of K(s) off the negative real axis"),
                             ("8e6 + s^2", "K(s) that grows as s^2"), ("8e6 +", 'found the end in "8e6 +"'),
                             ("8e6 + 3 N/um", 'found "N"')):
            self.pad(typed)
            for command in (["eval"], ["derive"], ["generate", "--language", "c99", "--out", "x"]):
                message = self.refused(2, [command[0], "s.toml", *command[1:]], words, "; expected ")
                self.assertRegex(message, r"s\.toml:\d+:\d+: found ")


if __name__ == "__main__":
    unittest.main()
