"""The bytes of every command's output on every scene of scenes/, as transcripts beside this file.

    test_golden.py VCRIT               compares
    test_golden.py VCRIT --update      takes the new output: read the difference before you commit it

A transcript shows short outputs as they are and long ones, files among them, by size and SHA-256, reports part by
part. Times, the machine and the commit are left out of reports, and so are generated evaluators: no compiler is
found. Of pages the words count, not scripts and style. Numbers are printed with all digits, so the library of
elementary functions has to be the same on every processor: it is told to use nothing newer than SSE2, as vcrit's own
results do not depend on the processor.
"""

import concurrent.futures
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1] / folder) for folder in ("languages", "support")]  # by hand
import drivers
from program import PROGRAM, PROJECT

FOLDER = PROJECT / "tests/golden"
UPDATE = "--update" in sys.argv
ENVIRONMENT = {**os.environ, "LC_ALL": "C.UTF-8", "PATH": "/nowhere",
               "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX512F"}
SHOWN = 2000  # bytes: what is longer is told by its hash

METHODS = ("moreau", "tanh", "rkf45", "msbdf")

SCENE = [
    "eval {scene}",
    "eval {scene} --json",
    "eval {scene} --set mu0=0.2 --set amplitude=0.11um --json",
    "derive {scene}",
    "derive {scene} --limits --sensitivities",
    "derive {scene} --limits --sensitivities --format latex",
    "derive {scene} --limits --sensitivities --format latex --standalone",
    "derive {scene} --limits --sensitivities --format markdown",
    "derive {scene} --limits --sensitivities --format html",
    "derive {scene} --limits --sensitivities --format json",
    *(f"derive {{scene}} --form {form}" for form in ("nested", "storage-loss", "rational", "dimensionless", "expanded")),
    "derive {scene} --material",
    "derive {scene} --equal scenes/zener.toml",
    "generate {scene} --out {out} --quantities --name other --json",
    "generate {scene} --out {out} --fix mu0",
    *(f"simulate {{scene}} --velocity-ratio {ratio} --json" for ratio in (0.05, 0.5, 0.97, 1.5)),
    "simulate {scene} --velocity-ratio 0.5",
    "simulate {scene} --velocity 1mm/s --start rest --json",
    "critical {scene}",
    "critical {scene} --json",
    "sweep {scene} --over frequency=log:1kHz:1MHz:7 --quantity critical_velocity --quantity admissible --out {out}/a.csv",
    "sweep {scene} --over amplitude=lin:0.01um:0.3um:4 --over velocity_ratio=lin:0.1:0.9:3 "
    "--quantity friction_ratio --quantity regime --out {out}/b.csv",
    "sweep {scene} --over coefficient=lin:0.1:0.3:2 --quantity sensitivity:amplitude --out {out}/c.csv",
    "solve {scene} --for velocity --friction-ratio 0.8 --json",
    "solve {scene} --for amplitude --friction-ratio 0.8 --velocity 1mm/s --json",
    "solve {scene} --for frequency --friction-ratio 0.8 --velocity 1mm/s",
    "validate {scene} --out {out} --json",
]
METHODS_OF = {"zener.toml": METHODS, "kelvin_rigid.toml": METHODS, "separation.toml": ("moreau",)}

ALONE = [
    "--help",
    *(f"{command} --help" for command in
      ("derive", "eval", "generate", "simulate", "critical", "plot", "explore", "sweep", "solve", "fit", "new", "check",
       "validate")),
    "",
    "frobnicate",
    "eval",
    "eval scenes/none.toml",
    "--completion bash",
    "--completion zsh",
    "derive --catalogue",
    "fit scenes/measured_pad.csv --out {out}/pad.toml --json",
    "fit scenes/measured_pad.csv --out {out}/pad.toml",
    "validate --paper --out {out}",
]
# Beside the help, which lists the languages: a new one changes one transcript.
LANGUAGES = [
    f"generate scenes/{path.name} --out {{out}} --language {language}"
    for language in drivers.LANGUAGES for path in sorted((PROJECT / "scenes").glob("*.toml"))
]


class Words(HTMLParser):
    """What a reader of a page sees, without what scripts draw."""

    def __init__(self):
        super().__init__()
        self.words, self.hidden = [], 0

    def handle_starttag(self, tag, attributes):
        self.hidden += tag in ("script", "style")

    def handle_endtag(self, tag):
        self.hidden -= tag in ("script", "style")

    def handle_data(self, data):
        if not self.hidden:
            self.words += data.split()


def words_of(page):
    reader = Words()
    reader.feed(page)
    return " ".join(reader.words)


def shown(data):
    text = data.decode("utf-8", "backslashreplace")
    if len(data) <= SHOWN:
        return text if text.endswith("\n") or not text else text + "\n[no line end]\n"
    return f"[{len(data)} bytes, sha256 {hashlib.sha256(data).hexdigest()}]\n"


# Keys, as whole words: "ns" is in "comparisons", too.
MEASURED = re.compile(r"(^|_)(time|seconds|nanoseconds|machine|commit|program|versions?|command|cost|run|ns|flags|cores)($|_)"
                      r"|on_front")


def without_measurements(value):
    """A report's JSON less times, what follows from them, and the machine."""
    if isinstance(value, dict):
        return {key: without_measurements(part) for key, part in value.items() if not MEASURED.search(key)}
    if isinstance(value, list):
        return [without_measurements(part) for part in value]
    return value


def sizes(value, key=""):
    """A line for each part of a report."""
    if isinstance(value, dict) and key.count("/") < 2:
        return "".join(sizes(part, f"{key}/{name}") for name, part in value.items())
    if isinstance(value, list) and key == "/scenes":
        return "".join(sizes(part, key) for part in value)
    data = json.dumps(value).encode()
    return f"{key}: {len(data)} bytes, sha256 {hashlib.sha256(data).hexdigest()}\n"


def shown_file(path, clean):
    data = clean(path.read_bytes())
    if path.name == "report.json":
        return sizes(without_measurements(json.loads(data)))
    return shown(words_of(data.decode()).encode() if path.suffix == ".html" else data)


def transcript(command, scene=""):
    """What `vcrit COMMAND` prints and writes, as text."""
    with tempfile.TemporaryDirectory() as out:
        words = [word.replace("{scene}", f"scenes/{scene}").replace("{out}", out) for word in command.split(" ") if word]
        done = subprocess.run([PROGRAM, *words], cwd=PROJECT, env=ENVIRONMENT, capture_output=True, timeout=600)
        clean = lambda data: data.replace(out.encode(), b"OUT")
        stdout = clean(done.stdout)
        if "--catalogue" in command or "--material" in command:
            stdout = words_of(stdout.decode()).encode()
        line = " ".join(words).replace(out, "OUT")
        text = f"$ vcrit {line}\n".replace(" \n", "\n") + shown(stdout)
        if done.stderr:
            text += "[stderr]\n" + shown(clean(done.stderr))
        if done.returncode:
            text += f"[status {done.returncode}]\n"
        for path in sorted(Path(out).rglob("*")):
            if path.is_file() and not ("validate" in command and path.suffix == ".html"):
                text += f"[{path.relative_to(out)}]\n" + shown_file(path, clean)
        return text + "\n"


def commands(scene):
    methods = [f"simulate {{scene}} --velocity-ratio 0.4 --method {name} --json" for name in METHODS_OF.get(scene, ())]
    return SCENE + methods


def plan():
    """Name of the transcript -> its commands and their scene."""
    scenes = {path.stem: [(command, path.name) for command in commands(path.name)]
              for path in sorted((PROJECT / "scenes").glob("*.toml"))}
    return {**scenes, "program": [(command, "") for command in ALONE + LANGUAGES]}


def differing(expected, found):
    """The first command whose output is another: expected and found."""
    pairs = zip(re.split(r"(?m)^(?=\$ vcrit)", expected), re.split(r"(?m)^(?=\$ vcrit)", found))
    return next(((a, b) for a, b in pairs if a != b), (expected[-500:], found[-500:]))


class Golden(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        flat = [(name, *entry) for name, entries in plan().items() for entry in entries]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            texts = pool.map(lambda entry: transcript(*entry[1:]), flat)
            cls.found = {}
            for (name, *_), text in zip(flat, texts):
                cls.found[name] = cls.found.get(name, "") + text

    def file(self, name):
        return FOLDER / (name + ".txt")

    def test_every_command_on_every_scene(self):
        for name, found in self.found.items():
            with self.subTest(scene=name):
                if UPDATE:
                    self.file(name).write_text(found)
                expected = self.file(name).read_text()
                if expected != found:
                    self.assertEqual(*differing(expected, found))
                    self.assertEqual(expected, found)

    def test_every_transcript_belongs_to_a_scene(self):
        expected = {path.stem for path in FOLDER.glob("*.txt")} - {"CMakeLists"}
        self.assertEqual(expected, set(self.found))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
