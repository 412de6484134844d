"""`vcrit critical`: its verdict, printed and as an exit status.

    test_critical.py PROGRAM
"""

import json
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


class Verdicts(unittest.TestCase):
    # Springs and a body a few 1e-7 from resonance: simulated, v* loses more than the 1e-9 that are allowed.
    def test_is_status_1_where_the_ways_differ(self):
        statuses = []
        for detuning in [1e-5, 5e-7, 4e-7, 3e-7, 2.5e-7, 2e-7, 1.5e-7]:
            with tempfile.NamedTemporaryFile("w", suffix=".toml") as scene:
                scene.write('[contact]\nnormal = "kn"\ntangential = "kt"\n[drive]\nnetwork = "kd"\n'
                            f"[body]\nmass = {1 - detuning!r}\n[oscillation]\nangular_frequency = 2.0\n"
                            "amplitude = 0.1\nindentation = 1.0\n[friction]\ncoefficient = 0.3\n"
                            "[elements]\nkn = 3\nkt = 2\nkd = 4\n")
                scene.flush()
                result, text = run("critical", scene.name, "--json"), run("critical", scene.name)
            agree = json.loads(result.stdout)["agree"]
            self.assertEqual((result.returncode, text.returncode), (0, 0) if agree else (1, 1), detuning)
            self.assertEqual("ABOVE 1e-09" in text.stdout, not agree)
            statuses.append(result.returncode)
        self.assertEqual(set(statuses), {0, 1})


if __name__ == "__main__":
    unittest.main()
