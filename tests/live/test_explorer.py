"""The explorer in a real browser: its answers are those of the program for all parameters, its state is in the address,
it is used by keyboard, says all that is wrong at once, and needs nothing but itself.
"""

import json
import math
import os
import random
import shlex
import subprocess
import tempfile
import unittest
from pathlib import Path

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from browsing import PATIENCE, browser, load
from program import PROGRAM, PROJECT

MOVING = ["zener", "prony", "kelvin_rigid", "separation", "burgers", "elastic_drive", "kelvin", "inadmissible",
          "sonotrode", "tribometer", "mount"]
STILL = {"measured_drive": "cannot simulate a measured drive", "bridge": "a network with a bridge"}
SETTINGS = 200
# k_d = 0.63 N/um = 0.7 g omega^2, and k_t + k_d = 0.9 N/um = 1 g omega^2
RESONANT = """
contact = { normal = "kn", tangential = "kt" }
drive.network = "kd"
body.mass = "0.7 g"
oscillation = { angular_frequency = 3e4, amplitude = "0.1 um", indentation = "1 um" }
friction.coefficient = 0.3
elements = { kn = "0.5 N/um", kt = "0.27 N/um", kd = "0.63 N/um" }
"""

ROWS = """return vcrit_explorer.rows.map(({ name, unit, exponent, own, array, linear, values }) =>
    ({ name, unit, exponent, own, array, linear, values }))"""
ANSWERED = "return [vcrit_explorer.answer, vcrit_explorer.answered, vcrit_explorer.settled()]"


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=PROJECT, capture_output=True, text=True)


class Explorer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="vcrit-explorer-")
        for name in [*MOVING, *STILL]:
            ran = run("explore", f"scenes/{name}.toml", "--out", cls.page(name))
            assert ran.returncode == 0, ran.stderr
        cls.browser = browser(Path(cls.folder.name, "profile"), network=True)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    @classmethod
    def page(cls, name):
        return Path(cls.folder.name, f"{name}.html")

    def explore(self, name, text):
        scene = Path(self.folder.name, f"{name}.toml")
        scene.write_text(text)
        self.assertEqual(run("explore", scene, "--out", self.page(name)).returncode, 0)
        return str(scene)

    def run_script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def open(self, name, fragment=""):
        for kind in ["browser", "performance"]:
            self.browser.get_log(kind)  # what was left of other pages
        load(self.browser, "about:blank")
        self.browser.get(self.page(name).as_uri() + fragment)  # the page writes its address in its own way
        WebDriverWait(self.browser, PATIENCE).until(lambda _: self.run_script("return typeof vcrit_explorer === 'object'"))
        self.browser.execute_async_script("vcrit_explorer.ready.then(arguments[0])")
        self.rows = self.run_script(ROWS)
        self.names = [row["name"] for row in self.rows]

    def answer(self):
        return self.run_script(ANSWERED)[0]

    def after(self, change):
        """What the page answers then."""
        before = self.run_script(ANSWERED)[1]
        change()
        WebDriverWait(self.browser, PATIENCE).until(lambda _: self.settled_after(before))
        return self.answer()

    def settled_after(self, before):
        _, answered, settled = self.run_script(ANSWERED)
        return settled and answered > before

    def element(self, kind, name):
        return self.browser.find_element(By.ID, f"{kind}-{self.names.index(name)}")

    def type(self, name, text):
        field = self.element("field", name)

        def typed():
            field.send_keys(Keys.CONTROL, "a", Keys.NULL, text)
            WebDriverWait(self.browser, PATIENCE).until(lambda _: field.get_attribute("value") == text)

        return self.after(typed)

    def messages(self):
        return [item.text for item in self.browser.find_elements(By.CSS_SELECTOR, "#explored-messages li")]

    def set_options(self, texts):
        options = []
        for row in self.rows:
            if row["name"] not in texts:
                continue
            factor = float(texts[row["name"]])
            if row["array"]:
                named = {f"{row['name']}[{entry}]": value * factor for entry, value in enumerate(row["values"], start=1)}
            else:
                named = {row["name"]: float(f"{texts[row['name']]}e{row['exponent']}")}
            options += [word for name, value in named.items() for word in ("--set", f"{name}={value!r}")]
        return options

    def random_texts(self, generator):
        texts = {}
        for row in self.rows:
            value = generator.uniform(0, 0.5) if row["linear"] else float(row["own"]) * 10 ** generator.uniform(-0.5, 0.5)
            texts[row["name"]] = f"{value:.4g}"
        return texts

    def test_two_hundred_random_settings_are_those_of_the_program(self):
        generator, inside, refused = random.Random(35), 0, 0
        named = [MOVING[number * len(MOVING) // SETTINGS] for number in range(SETTINGS)]
        for name in MOVING:
            self.open(name)
            drawn = [(self.random_texts(generator), generator.choice([0.05, 0.2, 0.5, 0.8, 0.97, 1.1]))
                     for _ in range(named.count(name))]
            # At once: nothing is painted in between, and what nobody asks for stays in the page.
            answers = self.run_script("""return arguments[0].map(([texts, share]) => {
                vcrit_explorer.set(texts);
                const { outside, velocity, drive } = vcrit_explorer.answer, speed = drive > 0 ? drive * share : 1e-3;
                const { status, message, numbers } = vcrit_explorer.simulate(speed);
                return { outside, velocity, speed, status, message, numbers: numbers && [...numbers].slice(0, 2) };
            });""", drawn)
            for (texts, share), found in zip(drawn, answers, strict=True):
                with self.subTest(scene=name, texts=texts, share=share):
                    options = self.set_options(texts)
                    ran = run("simulate", f"scenes/{name}.toml", "--json", "--velocity", repr(found["speed"]), *options)
                    self.assertEqual(found["status"], ran.returncode, ran.stderr)
                    evaluated = json.loads(run("eval", f"scenes/{name}.toml", "--json", *options).stdout)
                    self.assertEqual(found["outside"], not evaluated["admissible"])
                    if ran.returncode != 0:
                        refused += 1
                        self.assertIn(found["message"], json.loads(ran.stderr)["message"])
                        continue
                    inside += 1
                    expected = json.loads(ran.stdout)
                    ratio, error = found["numbers"]
                    # The same algorithm with another libm: both are within their own estimates of the steady value.
                    allowed = error + expected["friction_ratio_error"] + 1e-12
                    self.assertLessEqual(abs(ratio - expected["friction_ratio"]), allowed)
                    # Doubles, of which v* is some 10 times as sensitive as each rounding.
                    self.assertLessEqual(abs(found["velocity"] - evaluated["critical_velocity"]),
                                         1e-12 * evaluated["critical_velocity"])
        self.assertGreater(inside, SETTINGS / 2)
        self.assertGreater(refused, SETTINGS / 20)

    def test_each_parameter_moves_friction(self):
        self.open("zener")
        curve = "return vcrit_explorer.answer.curve.points.map(({ ratio }) => ratio)"
        own = self.run_script(curve)
        for row in self.rows:
            if row["name"] == "coefficient":  # of both, friction and its bound
                continue
            self.run_script("vcrit_explorer.set({ [arguments[0]]: String(0.7 * Number(arguments[1])) })", row["name"], row["own"])
            now = self.run_script(curve)
            self.assertGreater(max(abs(a - b) for a, b in zip(own, now)), 1e-6, row["name"])

    def test_only_v_star_where_there_is_no_motion(self):
        for name, reason in STILL.items():
            self.open(name)
            evaluated = json.loads(run("eval", f"scenes/{name}.toml", "--json").stdout)["critical_velocity"]
            self.assertLessEqual(abs(self.answer()["velocity"] - evaluated), 1e-12 * evaluated, name)
            self.assertTrue(any("No friction curve" in line and reason in line for line in self.messages()), self.messages())
            self.assertFalse(self.browser.find_element(By.ID, "explored-friction").is_displayed())
            self.assertFalse(self.browser.find_element(By.ID, "explored-cycle").is_displayed())

    def test_an_indenter_has_no_explorer(self):
        ran = run("explore", "scenes/sphere.toml", "--out", self.page("sphere"))
        self.assertEqual(ran.returncode, 3)
        self.assertIn("an indenter has no single contact motion", ran.stderr)
        self.assertFalse(self.page("sphere").exists())

    def test_the_state_is_in_the_address(self):
        self.open("zener")
        self.type("frequency", "25")
        moved = self.type("k0", "9.1")
        address = self.browser.current_url
        self.assertTrue(address.endswith("#frequency=25kHz&k0=9.1N/um"), address)
        fields = self.run_script("return vcrit_explorer.rows.map(({ field }) => field.value)")
        self.open("zener", "#" + address.split("#")[1])
        self.assertEqual(self.answer()["velocity"], moved["velocity"])
        self.assertEqual(self.run_script("return vcrit_explorer.rows.map(({ field }) => field.value)"), fields)
        for other in ["#frequency=25000&k0=9.1e6", "#frequency=0.025MHz&k0=9100000N/m"]:  # bare numbers are in SI
            self.open("zener", other)
            self.assertEqual(self.answer()["velocity"], moved["velocity"], other)
        own = self.after(lambda: self.browser.find_element(By.ID, "explorer-reset").send_keys(Keys.ENTER))
        self.assertNotIn("frequency", self.browser.current_url)
        self.open("zener", "#frequency=nonsense&k9=1&amplitude=-1um&=&%")
        self.assertEqual(self.answer()["velocity"], own["velocity"])

    def test_the_command_gives_the_same(self):
        # Equal networks are isotropic, with no ratio that could be set.
        equal = self.explore("equal", RESONANT.replace('"kt"', '"kn"').replace('kt = "0.27 N/um", ', ""))
        for name, file in [("zener", "scenes/zener.toml"), ("prony", "scenes/prony.toml"), ("equal", equal)]:
            self.open(name)
            velocity = self.run_script("""const { rows } = vcrit_explorer;
                vcrit_explorer.set(Object.fromEntries(rows.map(({ name, own }) => [name, String(0.9 * Number(own))])));
                return vcrit_explorer.answer.velocity""")
            words = shlex.split(self.browser.find_element(By.ID, "explored-command").text)
            self.assertEqual(words[:3], ["vcrit", "eval", file])
            evaluated = json.loads(run(*words[1:], "--json").stdout)["critical_velocity"]
            self.assertLessEqual(abs(velocity - evaluated), 1e-12 * evaluated)

    def test_now_is_the_scene_until_something_moves(self):
        self.open("zener")
        drawn = "return ['now', 'own'].map((name) => document.querySelectorAll(`#explored-friction path.${name}`).length)"
        back = self.element("back", "amplitude")
        self.assertEqual(self.run_script(drawn), [1, 0])
        self.assertEqual(self.messages(), [])
        self.assertFalse(back.is_displayed() or self.browser.find_element(By.ID, "explored-moved").is_displayed())
        own = self.answer()["velocity"]
        self.type("amplitude", "0.112")
        self.assertEqual(self.run_script(drawn), [1, 1])
        now, was = (self.run_script(f"return document.querySelector('#explored-friction path.{each}').getAttribute('d')")
                    for each in ["now", "own"])
        self.assertNotEqual(now, was)
        self.assertIn("(+12 %)", self.browser.find_element(By.ID, "explored-was").text)
        self.assertEqual(self.after(back.click)["velocity"], own)
        self.assertFalse(back.is_displayed())

    def test_no_message_hides_another(self):
        self.open("zener")
        self.type("c1", "45")
        self.assertEqual(self.messages(), [])
        self.type("amplitude", "1")
        told = self.messages()
        # u_z0 k0/|k0 + k1 T i/(1 + T i)| with T = omega c1/k1 = 1.41372: 4 N over 10.8315 N/um.
        self.assertEqual(told, ["Outside the model: the contact opens. It stays closed up to an amplitude of 0.3693 µm (now 1 µm)."])
        velocity = self.browser.find_element(By.ID, "explored-velocity")
        self.assertEqual(velocity.text, "No v*: outside the model")
        self.assertEqual(velocity.get_attribute("aria-live"), "off")
        self.assertFalse(self.browser.find_element(By.ID, "explored-friction").is_displayed())
        self.type("k0", ",5")
        self.assertIn("write a decimal point", self.messages()[0])
        self.assertEqual(self.messages()[1:], told)
        self.assertEqual(self.element("field", "k0").get_attribute("aria-invalid"), "true")

    # k_d = m omega^2, then k_t + k_d = m omega^2, in numbers as typed, of which doubles hold neither.
    def test_an_exact_resonance_is_one_and_so_is_an_antiresonance(self):
        scene = self.explore("resonance", RESONANT)
        self.open("resonance")
        self.assertEqual(json.loads(run("eval", scene, "--json").stdout)["critical_velocity"], "inf")
        velocity = self.browser.find_element(By.ID, "explored-velocity")
        self.assertEqual(velocity.text, "∞")
        self.assertIn("at every speed (undamped resonance", self.messages()[0])
        self.type("mass", "900")  # mg
        self.assertEqual(velocity.text, "833.3 µm/s")  # 0.9e-3 m/s, times 0.5/0.27, times 0.09/0.18
        self.type("mass", "1000")
        self.assertEqual(json.loads(run("eval", scene, "--json", "--set", "mass=1 g").stdout)["critical_velocity"], 0)
        self.assertEqual(velocity.text, "0 m/s")
        self.assertIn("(antiresonance)", self.messages()[0])

    def test_whoever_hears_the_page_can_tell_the_controls_apart(self):
        for name in ["zener", "prony", "mount"]:
            self.open(name)
            self.run_script("for (const { back } of vcrit_explorer.rows) back.hidden = false")
            for kind in ["input[type=text]", "input[type=range]", "button"]:
                controls = self.browser.find_elements(By.CSS_SELECTOR, f".explorer-parameters {kind}")
                said = [control.accessible_name for control in controls]
                self.assertEqual(len(set(said) - {""}), len(said), said)
        self.open("zener")
        self.assertEqual(self.element("field", "k0").accessible_name, "spring k0, N/µm")

    def paste(self, field, text):
        self.after(lambda: self.run_script("""arguments[0].focus();
            arguments[0].value = arguments[1];
            arguments[0].dispatchEvent(new Event('input'))""", field, text))

    def test_what_is_no_number_of_the_scene_is_said(self):
        self.open("zener")
        own = self.answer()["velocity"]
        above, within = "no number above 0", "outside the range from −1 to 0.5"
        for name, text, words in [("frequency", "1e999", "beyond the range"), ("k0", "1e-999", "beyond the range"), ("mass", "0", above),
                                  ("k1", "", above), ("amplitude", "NaN", above), ("poisson", "-1", within), ("poisson", ".7", within)]:
            with self.subTest(name=name, text=text):
                self.paste(self.element("field", name), text)
                self.assertEqual(self.answer()["velocity"], own)
                self.assertEqual(len(self.messages()), 1)
                self.assertRegex(self.messages()[0], f'({name}|ratio): "{text}" is .*{words}.* The last one stays.')
                self.paste(self.element("field", name), self.rows[self.names.index(name)]["own"])
        self.assertEqual(self.messages(), [])

    def test_a_number_that_doubles_do_not_reach_has_its_reason(self):
        self.open("zener")
        self.run_script("vcrit_explorer.set({ frequency: '1e300' })")
        self.assertEqual(self.browser.find_element(By.ID, "explored-velocity").text, "unknown")
        self.assertIn("No v*: doubles have no digit of v* here", self.messages()[0])
        self.run_script("vcrit_explorer.set({ coefficient: '1e-300' })")  # own curve: 300 decades away
        self.assertEqual(self.browser.get_log("browser"), [])

    def test_poissons_ratio_may_be_0_or_as_of_auxetic_materials_negative(self):
        for text in ["-0.25", "0"]:
            self.open("zener", f"#poisson={text}")
            evaluated = json.loads(run("eval", "scenes/zener.toml", "--json", "--set", f"poisson={text}").stdout)
            for _ in ["by its address", "typed"]:
                self.assertLessEqual(abs(self.answer()["velocity"] / evaluated["critical_velocity"] - 1), 1e-12)
                self.type("poisson", text)

    def test_the_sliding_speed_is_read_as_all_numbers_are(self):
        self.open("zener")
        field, words = (self.browser.find_element(By.ID, f"explored-{each}") for each in ["speed", "ratio"])
        found = {self.paste(field, text) or words.text for text in ["2", "0.2e1", ",5"]}
        self.assertEqual(len(found), 1, found)
        self.assertEqual(self.messages(), ['sliding speed: ",5" is no number above 0; write a decimal point. The last one stays.'])

    def test_the_keyboard(self):
        self.open("zener")
        slider, field = self.element("slider", "frequency"), self.element("field", "frequency")

        def press(*keys):
            self.after(lambda: slider.send_keys(*keys))
            return float(field.get_attribute("value"))

        self.assertEqual(press(Keys.ARROW_RIGHT), 20.1)
        self.assertEqual(press(Keys.SHIFT, Keys.ARROW_RIGHT, Keys.NULL), 22.11)
        self.assertEqual(press(Keys.ARROW_LEFT), 22)
        self.assertAlmostEqual(press(Keys.PAGE_UP) / (22 * 10**(10 / 200)), 1, delta=1e-4)
        self.assertEqual(press(Keys.HOME), 0.2)
        self.assertEqual(press(Keys.END), 2000)
        self.type("frequency", "25")
        self.assertEqual(slider.get_attribute("aria-valuetext"), "25 kilohertz")
        self.assertTrue(math.isclose(float(slider.get_attribute("value")), 200 * math.log10(25 / 20), rel_tol=1e-6))
        sizes = self.run_script("""return [...document.querySelectorAll('.explorer input, .explorer button')]
            .filter((each) => each.checkVisibility()).map((each) => each.getBoundingClientRect().height)""")
        self.assertGreaterEqual(min(sizes), 24)

    def test_one_cycle(self):
        self.open("zener")
        steady = json.loads(run("simulate", "scenes/zener.toml", "--velocity", "2 mm/s", "--json").stdout)
        field = self.browser.find_element(By.ID, "explored-speed")
        self.after(lambda: field.send_keys(Keys.CONTROL, "a", Keys.NULL, "2"))
        ratio = format(float(format(steady["friction_ratio"], ".4g")), "g")
        self.assertIn(f"{ratio} of the friction", self.browser.find_element(By.ID, "explored-ratio").text)
        events = {event["to"]: event["phase"] for event in steady["events"]}
        share = (events["slip"] - events["stick"]) % (2 * math.pi) / (2 * math.pi)
        words = self.browser.find_element(By.ID, "explored-period").text
        self.assertIn(f"sticks {round(100 * share)} %", words)
        instant = self.browser.find_element(By.ID, "explored-instant")
        before = instant.text
        self.browser.find_element(By.ID, "explorer-time").send_keys(Keys.PAGE_UP)
        self.assertNotEqual(instant.text, before)
        play = self.browser.find_element(By.ID, "explorer-play")
        self.assertTrue(play.is_displayed())
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-reduced-motion", "value": "reduce"}]})
        WebDriverWait(self.browser, PATIENCE).until(lambda _: not play.is_displayed())
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def test_it_needs_nothing_but_itself(self):
        self.open("zener")
        self.type("frequency", "25")
        self.assertEqual(self.browser.get_log("browser"), [])
        messages = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        asked = [message["params"]["request"]["url"] for message in messages if message["method"] == "Network.requestWillBeSent"]
        self.assertEqual({url.split("#")[0] for url in asked if not url.startswith(("data:", "blob:", "about:"))},
                         {self.page("zener").as_uri()})
        policy = self.browser.find_element(By.CSS_SELECTOR, "meta[http-equiv]").get_attribute("content")
        self.assertIn("default-src 'none'", policy)
        self.assertIn(" 'wasm-unsafe-eval'", policy)
        self.assertNotIn(" 'unsafe-eval'", policy)
        inline = """const script = document.createElement('script');
            script.textContent = 'window.ran = true';
            document.body.append(script);
            return window.ran"""
        self.assertIsNone(self.run_script(inline))
        self.assertLess(self.page("zener").stat().st_size, 2e6)

    def test_a_phone_shows_all_without_scrolling_sideways(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": True})
        self.open("prony")
        self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), 390)
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


if __name__ == "__main__":
    os.environ.setdefault("HOME", tempfile.gettempdir())
    unittest.main(verbosity=2)
