"""Templates of pages and documents: each is used, each that is asked for is there, and what they show is escaped for the
place where it stands."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv.pop(1))
FOLDERS = ["validation/report", "validation/figures", "symbolic/document"]
# Within a script or a style only what was made for it (record::Markup): escapes of HTML mean nothing there.
MADE_FOR_IT = {"page.style", "drawing", "data", "module", "."}


def templates(root, folder):
    return {file.stem: file.read_text() for file in sorted((root / folder / "templates").glob("*.mustache"))}


def code_of(root, folder):
    return "".join(file.read_text() for file in sorted((root / folder).glob("*.[ch]pp")))


def keys(text):
    """What a template asks its record for, word by word: {{#drive.mass | .3g}} for drive and mass."""
    tag = r"<<[#^/]?\s*(.*?)\s*>>" if text.startswith("{{=") else r"{{[#^/]?\s*(.*?)\s*}}"
    tags = re.findall(tag, re.sub(r"{{=.*?=}}|{{[>!].*?}}|<<[>!].*?>>", "", text))
    paths = {path.split("|")[0].strip() for path in tags}
    paths |= {argument for path in tags for argument in re.findall(r"@(?!any|count|last|number|place)(\w+)", path)}
    return {key for path in paths for key in path.split(".") if key and not key.startswith("@")}


def names_problems(root, folder):
    texts = templates(root, folder)
    code = code_of(root, folder)
    asked = {name for text in texts.values() for name in re.findall(r"(?:{{|<<)> (\w+)(?:}}|>>)", text)}
    problems = [f"{name}: no such template" for name in sorted(asked - set(texts))]
    return problems + [f"{name}: used by none" for name in texts if name not in asked and f'"{name}"' not in code]


def place_problems(name, text):
    problems = []
    if re.search(r"{{{|{{&", text):
        problems.append(f"{name}: braces that ask for no escape")
    problems += [f"{name}: {found} without quotes" for found in re.findall(r"[\w-]+={{[^}]*}}", text)]
    for inside in re.findall(r"<(?:script|style)[^>]*>(.*?)</(?:script|style)>", text, re.S):
        problems += [f"{name}: {tag} in a script" for tag in re.findall(r"{{([^}]*)}}", inside) if tag not in MADE_FOR_IT]
    return problems


class Templates(unittest.TestCase):
    def test_are_used_and_there(self):
        for folder in FOLDERS:
            self.assertGreater(len(templates(PROJECT, folder)), 0)
            self.assertEqual(names_problems(PROJECT, folder), [])

    def test_ask_for_what_records_have(self):
        """One that is asked for in a rare case only would be a Bug on that day."""
        for folder in FOLDERS:
            code = code_of(PROJECT, folder)
            for name, text in templates(PROJECT, folder).items():
                self.assertEqual([key for key in sorted(keys(text)) if f'"{key}"' not in code], [], name)

    def test_keys_are_found(self):
        text = "{{> part}}{{! no }}{{#a.b.@any}}{{c | quantity @unit}}{{. | .3f}}{{^@last}}{{/@last}}{{/a.b.@any}}"
        self.assertEqual(keys(text), {"a", "b", "c", "unit"})
        self.assertEqual(keys("{{=<< >>=}}{<<#x>><<y>><</x>>}"), {"x", "y"})

    def test_show_what_is_escaped_for_its_place(self):
        for name, text in templates(PROJECT, "validation/report").items():
            self.assertEqual(place_problems(name, text), [])

    def test_a_planted_tree_shows_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "room/templates").mkdir(parents=True)
            (root / "room/page.cpp").write_text('document("page", record)\n')
            (root / "room/templates/page.mustache").write_text("{{> prat}}")
            (root / "room/templates/part.mustache").write_text("x")
            self.assertEqual(names_problems(root, "room"), ["prat: no such template", "part: used by none"])
        self.assertEqual(len(place_problems("a", '{{{b}}}<p id={{c}}><p id="{{d}}"><script>{{e}}{{.}}</script>')), 3)


if __name__ == "__main__":
    unittest.main()
