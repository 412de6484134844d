"""vcrit check: all that is wrong with scenes, at once; vcrit new: scenes to be filled in."""

import json
import re
import unittest

from program import PROJECT, Case, example

BAD = """title = "Five errors"
[contact]
normal = "E0 | (k1 + c1)"
poisson = 0.3
[oscillation]
frequency = 28 kHz
amplitud = "0.1 um"
indentation = "12 um pp"
[friction]
coefficient = 0.3
[elements]
k1 = "0.5 MPa"
c1 = "6 Ns/m"
"""
# Line, column and a part of what is said, by hand.
ERRORS = [(3, 11, 'element "E0" of unknown kind'), (3, 20, 'parallel is written "|"'),
          (6, 16, 'a value with a unit needs quotes: "28 kHz"'), (7, 1, 'expected "amplitude"'),
          (8, 15, 'an amplitude is half of peak to peak: "6 um"'), (12, 6, "k = 2 a E/(1 - nu^2)"),
          (13, 6, 'did you mean "6 N.s/m"?')]


class Check(Case):
    def test_all_errors_at_once(self):
        scene = self.write(BAD)
        lines = self.out("check", scene, status=2).splitlines()
        self.assertEqual(lines[-1], f"{scene}: {len(ERRORS)} errors, 0 warnings. Nothing was computed.")
        self.assertEqual(len(lines), len(ERRORS) + 1)
        for line, (row, column, words) in zip(lines, ERRORS):
            self.assertRegex(line, rf"^{scene}:{row}:{column} +error +")
            self.assertIn(words, line)

    def test_the_first_error_is_that_of_other_commands(self):
        told = self.run_program("eval", self.write(BAD)).stderr
        self.assertEqual(told.count("\n"), 1)
        self.assertIn("s.toml:6:16: found frequency = 28 kHz", told)

    def test_errors_in_json(self):
        scene = self.write(BAD)
        told = self.answer("check", scene, status=2)
        self.assertEqual((told["error_count"], told["warning_count"], told["status"]), (len(ERRORS), 0, 2))
        (of_scene,) = told["scenes"]
        self.assertEqual(of_scene["file"], str(scene))
        self.assertEqual(of_scene["commands"], [])
        for problem, (row, column, words) in zip(of_scene["problems"], ERRORS):
            self.assertEqual((problem["file"], problem["line"], problem["column"], problem["kind"]),
                             (str(scene), row, column, "error"))
            self.assertIn(words, problem["text"])
            self.assertIn(problem["found"], problem["text"])
            self.assertIn(problem["expected"], problem["text"])

    def test_a_terminal_shows_the_line(self):
        lines = self.on_terminal("check", self.write(BAD)).splitlines()
        row = lines.index('    6 | frequency = 28 kHz')
        self.assertEqual(lines[row + 1].index("^"), lines[row].index("kHz"))
        self.assertNotIn("| frequency", self.run_program("check", self.folder / "s.toml").stdout)

    def test_scenes_without_problems(self):
        told = self.out("check", example("zener"), example("measured_drive"))
        self.assertIn(f"{example('zener')}: no problems; these commands answer: derive, eval, generate, simulate, "
                      "critical, plot, sweep, solve, validate\n", told)
        self.assertNotIn("  not critical", told)
        self.assertIn("  validate leaves out the stability maps: available only for networks of springs and dampers, without masses or tables", told)

    def test_indenters(self):
        told = self.out("check", example("sphere"), example("leaf_spring"))
        self.assertIn(f"{example('sphere')}: no problems; these commands answer: derive, eval, generate, simulate, "
                      "critical, plot, sweep, solve, validate\n", told)
        self.assertIn(f"{example('leaf_spring')}: no problems; these commands answer: eval, simulate, plot, sweep, solve, "
                      "validate\n", told)

    def test_outside_the_model(self):
        told = self.out("check", example("inadmissible"), status=3)
        self.assertIn("warning  outside the model: the contact opens", told)
        self.assertIn("(Eq. 4); take an amplitude below 0.2236 µm, or let the contact open: separation = true", told)
        self.assertIn("inadmissible.toml: 1 warning, outside the model; these commands answer: derive, eval", told)
        # An error goes before.
        self.out("check", self.write(BAD), example("inadmissible"), status=2)

    def test_the_amplitude_that_is_told_closes_the_contact(self):
        for amplitude, status in (("0.2235 um", 0), ("0.2237 um", 3)):
            self.out("simulate", example("inadmissible"), "--velocity-ratio", "0.5", "--set", f"amplitude={amplitude}",
                     status=status)

    def test_missing_values_leave_what_needs_none(self):
        told = self.out("check", self.scene({"kn": "k_of_pad"}))
        self.assertIn("these commands answer: derive, generate\n", told)
        self.assertIn("no value for k_of_pad; a number for each, in the scene or by --set NAME=VALUE", told)

    def test_missing_numbers_have_the_names_of_their_keys(self):
        text = (PROJECT / "scenes/zener.toml").read_text()
        for line in ('frequency   = "20 kHz"', 'coefficient = 0.3'):
            self.assertIn(line, text)
            text = text.replace(line, "")
        told = self.out("check", self.write(text.replace('amplitude   = "0.1 um"', 'amplitude   = "swing"')))
        self.assertIn("no value for mu0 (coefficient), omega (frequency), swing (amplitude)", told)

    def test_an_element_of_another_case_is_the_one_that_is_missing(self):
        scene = self.write((PROJECT / "scenes/zener.toml").read_text().replace('k1 = "4 N/um"', 'K1 = "4 N/um"'))
        told = self.out("check", scene)
        self.assertIn('element "K1" is in no network of this scene; did you mean "k1"?', told)

    def test_what_toml_cannot_read_is_named(self):
        zener = (PROJECT / "scenes/zener.toml").read_text()
        for wrong, line, words in [
                ('k1 = "4 N/um', 27, 'k1 = "4 N/um without its closing quote; expected a text in quotes; write k1 = "4 N/um"'),
                ('k1 = "4 N/um # stiff', 27, 'write k1 = "4 N/um"'),
                ('k0 = "4 N/um"', 27, '"k0" for the second time; expected each name once; leave one of them out'),
                ("[friction]", 27, '"friction" for the second time')]:
            told = self.out("check", self.write(zener.replace('k1 = "4 N/um"', wrong)), status=2)
            self.assertRegex(told, rf"s\.toml:{line}:\d+ +error +")
            self.assertIn(words, told)

    def test_bare_numbers_of_another_size(self):
        scene = self.write(re.sub("frequency.*", "frequency = 28", (PROJECT / "scenes/kelvin.toml").read_text(), count=1))
        told = self.out("check", scene)
        self.assertRegex(told, r"s\.toml:\d+:\d+ +warning +frequency 28 Hz: a bare number is in hertz; if kHz are meant")
        self.assertIn(": 1 warning; these commands answer", told)
        self.assertIn("vcrit: warning: ", self.run_program("eval", scene).stderr)

    def test_a_file_that_is_not_there(self):
        self.write((PROJECT / "scenes/zener.toml").read_text(), "zener.toml")
        self.refused(2, ["check", "zener.toml", "zenner.toml"], "zenner.toml: found no such file", "did you mean zener.toml?")

    def test_texts_that_steer_a_terminal(self):
        told = self.out("check", self.write(BAD.replace("amplitud ", '"\\u001b[31m" ')), status=2)
        self.assertNotIn("\x1b", told)


class New(Case):
    def choices(self, option):
        help_text = self.out("new", "--help")
        return re.search(rf"--{option} [^{{]*{{([^}}]*)}}", help_text)[1].split(",")

    def filled(self, text):
        """Each question mark replaced by the typical value that its line tells."""
        lines = []
        for line in text.splitlines():
            marks = line.count('"?"')
            typical = re.findall(r'"([^"]+)"', line.partition("# e.g. ")[2])
            self.assertEqual(marks, len(typical), line)
            for value in typical:
                line = line.replace('"?"', f'"{value}"', 1)
            lines.append(line)
        return "\n".join(lines) + "\n"

    def filled_in(self, rheology, drive, body):
        """The file of a new scene with its typical values."""
        words = ["--mass"] if body else []
        text = self.out("new", "--rheology", rheology, "--drive", drive, *words)
        self.assertEqual(("[body]" in text, "[drive]\n" in text), (body, drive != "rigid"))
        return self.write(self.filled(text), f"{rheology}_{drive}_{body}.toml")

    def test_a_tip_and_moduli_from_a_data_sheet(self):
        text = self.filled(self.out("new"))
        for mark in ('[indenter]', 'shape = "parabola"', 'radius = "5 mm"', '[load]', 'force = "50 N"'):
            text = text.replace(f"# {mark}", mark)
        for name, value in (("k0", "2.9 GPa"), ("k1", "0.6 GPa"), ("c1", "3.5 kPa.s")):
            text = re.sub(f'{name} = "[^"]*"', f'{name} = "{value}"', text)
        scene = self.write(re.sub("indentation = .*", "", text))
        self.assertIn("no problems; these commands answer: derive, eval, generate, simulate", self.out("check", scene))
        self.assertNotIn("[indenter]", self.out("new", "--drive", "spring"))
        self.assertIn('no shape in [indenter]; expected shape = "flat", "cone",',
                      self.out("check", self.write(text.replace('shape = "parabola"', "")), status=2))

    def test_every_scene_is_well_formed_once_it_is_filled_in(self):
        rheologies, drives = self.choices("rheology"), self.choices("drive")
        self.assertEqual(rheologies[0], "zener")
        self.assertEqual(drives[0], "rigid")
        self.assertEqual(sorted(drives[1:]), sorted(rheologies))
        files = [self.filled_in(rheology, drive, body) for rheology in rheologies for drive in drives
                 for body in (False, True) if drive != "rigid" or not body]
        self.assertEqual(len(files), len(rheologies) * (2 * len(drives) - 1))
        ran = self.run_program("check", *files, "--json")
        self.assertIn(ran.returncode, (0, 3))  # a fluid carries no mean load
        told = json.loads(ran.stdout)
        self.assertEqual((len(told["scenes"]), told["error_count"]), (len(files), 0))

    def test_every_contact_and_every_drive_has_an_answer(self):
        for rheology in self.choices("rheology"):
            for drive, body in (("rigid", False), ("spring", False), ("spring", True)):
                self.out("eval", self.filled_in(rheology, drive, body))
        for drive in self.choices("drive")[1:]:
            for body in (False, True):
                self.out("eval", self.filled_in("zener", drive, body))

    def test_a_file_is_written_and_told(self):
        told = self.out("new", "my.toml", "--rheology", "zener", "--drive", "spring", "--mass")
        self.assertEqual(told, "Wrote my.toml: contact zener, drive spring, with a body.\n"
                               'Fill in the 10 numbers marked "?"; then: vcrit check my.toml\n')
        text = (self.folder / "my.toml").read_text()
        self.assertEqual(text, self.out("new", "--rheology", "zener", "--drive", "spring", "--mass"))
        self.assertIn("half of peak to peak", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 100)
        told = self.out("check", "my.toml", status=2)
        self.assertEqual(told.count("still has its question mark"), 10)
        self.assertIn("k0 still has its question mark", told)
        self.assertIn("10 errors, 0 warnings", told)

    def test_nothing_is_written_over(self):
        self.write("mine", "my.toml")
        self.refused(2, ["new", "my.toml"], "vcrit new writes over nothing")
        self.assertEqual((self.folder / "my.toml").read_text(), "mine")

    def test_what_does_not_fit_is_refused(self):
        self.refused(2, ["new", "--mass"], "a body under a rigid drive", "--drive spring")
        for wrong in (["--rheology", "mass"], ["--drive", "mass"], ["--rheology", "zenner"]):
            self.assertEqual(self.run_program("new", *wrong).returncode, 2)

    def test_a_contact_that_may_open(self):
        self.assertIn("separation = true", self.out("new", "--separation"))
        self.assertNotIn("separation", self.out("new"))

    def test_in_json(self):
        told = self.answer("new", "my.toml", "--drive", "kelvin")
        self.assertEqual((told["file"], told["rheology"], told["drive"], told["body"], told["numbers_to_fill_in"]),
                         ("my.toml", "zener", "kelvin", False, 10))
        self.assertEqual(told["text"], (self.folder / "my.toml").read_text())
        self.assertIsNone(self.answer("new")["file"])


if __name__ == "__main__":
    unittest.main()
