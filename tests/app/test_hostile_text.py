"""Texts from scenes stay texts: in terminals, in documents, in the code of every language, and on pages in a browser."""

import ast
import html
import html.parser
import json
import os
import re
import shutil
import subprocess
import tempfile
import unicodedata
import unittest
from pathlib import Path

import drivers
import program
from browsing import browser, draw_charts, load

SCENE = Path(program.example("kelvin_rigid")).read_text()
# One title that would do harm in a terminal, HTML, a shell, LaTeX, Markdown, TOML, and in comments of C (the trigraph
# of a backslash), C++, JavaScript (U+2028 ends a line there) and Python.
HOSTILE = ('"></title></script><script>window.hostile=1</script><img src=x onerror="window.hostile=1">'
           '<meta http-equiv="refresh" content="0;url=https://vcrit.invalid/"> ${window.hostile=1} $(touch intruder) '
           '`touch intruder` ../../intruder */ \\input{/etc/passwd} ~ [a](javascript:alert(1)) '
           "\u2028window.hostile=1;// \u2029window.hostile=1;// \u202eturned\u2066 \x1b[2J\x1b]0;intruder\x07 \x85\x9b "
           '\nimport os\r#error intruder\n\x0b\x0c"""\n[contact]\n<!-- --> ???/')
PLAIN = "A contact"
LANGUAGES = {name: f"critical.{row['file']}" for name, row in drivers.LANGUAGES.items()}
# A Zener element, to a per mille.
DATA = "frequency,storage,loss\n" + "".join(f"{1e4 * x},{8e6 + 4e6 * x * x / (1 + x * x) + 1e4 * (i % 3)},"
                                             f"{4e6 * x / (1 + x * x)}\n"
                                             for i in range(17) for x in [10 ** (i / 8 - 1)])


def scene(title):
    # A string of JSON is one of TOML, but for DEL.
    return re.sub(r"^title = .*$", lambda _: "title = " + json.dumps(title), SCENE, count=1, flags=re.M)


def steering(text):
    """Characters that are not shown, but for newlines and tabulators."""
    return [c for c in text if unicodedata.category(c) in ("Cc", "Zl", "Zp") and c not in "\n\t"
            or unicodedata.bidirectional(c) in ("LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI")]


class Case(program.Case):
    def setUp(self):
        super().setUp()
        self.addCleanup(self.no_intruder)

    def no_intruder(self):
        self.assertEqual(list(self.folder.rglob("intruder*")), [])

    def file(self, title, name="scene.toml"):
        return self.write(scene(title), name)


class Documents(Case):
    def documents(self, form):
        plain, hostile = (self.out("derive", self.file(title), "--format", form) for title in (PLAIN, HOSTILE))
        self.assertEqual(steering(hostile), [])
        # All but the title is the same, and that is one line.
        self.assertEqual(plain.splitlines()[1:], hostile.split("\n")[1:-1])
        return hostile.split("\n")[0]

    def test_text(self):
        self.assertIn("\\u{1b}[2J\\u{1b}]0;intruder\\u{7} \\u{85}\\u{9b}", self.documents("text"))

    def test_latex(self):
        title = self.documents("latex")
        self.assertIn("\\textbackslash{}input\\{/etc/passwd\\} \\~{}", title)
        begin, end = "\\section*{", "}"
        self.assertTrue(title.startswith(begin) and title.endswith(end))
        # Every command in it is one of those that print a character.
        commands = set(re.findall(r"\\(?:[a-zA-Z]+|.)", title[len(begin):-len(end)]))
        self.assertLessEqual(commands, {"\\textbackslash", "\\textless", "\\textgreater", "\\textbar",
                                        *(f"\\{c}" for c in "_%&#${}^~")})

    def test_an_article_that_compiles(self):
        article = self.out("derive", self.file(HOSTILE + " ひ ą € é"), "--format", "latex", "--standalone")
        title = next(line for line in article.splitlines() if line.startswith("\\section*{"))
        # Beyond ASCII, what the standard fonts have.
        self.assertEqual({c for c in title if ord(c) > 0x7F}, {"é"})

    def test_a_page(self):
        pages = [self.out("derive", self.file(title), "--format", "html") for title in (PLAIN, HOSTILE)]
        self.assertEqual(*(Tags(page).tags for page in pages))
        self.assertEqual(steering(pages[1]), [])

    def test_markdown(self):
        title = self.documents("markdown")
        self.assertIn("\\[a\\](javascript", title)
        self.assertIsNone(re.search(r"(?<!\\)(\\\\)*[`*_\[\]<>&$~]", title))

    def test_json(self):
        for command in [["derive", "--format", "json"], ["eval", "--json"]]:
            text = self.out(command[0], self.file(HOSTILE), *command[1:])
            told = json.loads(text)
            self.assertEqual(told.get("title", HOSTILE), HOSTILE)

    def test_messages(self):
        for broken in [scene(HOSTILE).replace("normal", '"\\u001b[2J\\u202e\\u0085"'),
                       scene(HOSTILE).replace('"k', '"\\u001b[2J\\u202e\\u0085k'), "\x1b[2J", "a = '\u202e'"]:
            self.assertEqual(steering(self.refused(2, ["eval", self.write(broken)])), [])
        self.assertNotIn("\x1b", self.refused(2, ["eval", b"absent\x1b[2J\xff.toml"]))

    def test_a_fitted_scene(self):
        self.write(DATA, "data.csv")
        fitted = self.folder / "fitted.toml"
        self.out("fit", self.folder / "data.csv", "--title", HOSTILE.replace("\x85\x9b", ""), "--out", fitted)
        self.assertEqual(len(re.findall(r"(?m)^\[contact\]", fitted.read_text())), 1)
        self.assertIn('title = "\\"></title>', fitted.read_text())


class Code(Case):
    def generated(self, title, language, file="scene.toml"):
        folder = self.folder / "generated"
        shutil.rmtree(folder, ignore_errors=True)  # what another language's compiler left
        self.out("generate", self.file(title, file), "--language", language, "--out", folder)
        return {name.name: name.read_text() for name in folder.iterdir()}

    def without_comments(self, text):
        """By the widest meaning of an end of line, and of a line that goes on with the next one."""
        lines = re.sub(r"(\\|\?\?/)\n", "", text)
        return [line for line in re.split("[\n\r\v\f\x85\u2028\u2029]", lines)
                if not line.startswith(("//", "#include <", "# ")) and "VCRIT_GENERATED" not in line]

    def test_comments_stay_comments(self):
        for language, main in LANGUAGES.items():
            with self.subTest(language):
                plain, hostile = self.generated(PLAIN, language)[main], self.generated(HOSTILE, language)[main]
                self.assertIn("window.hostile", hostile)
                self.assertEqual(self.without_comments(hostile), self.without_comments(plain))
                self.assertEqual(steering(hostile), [])
                self.assertIsNone(re.search("</script|<!--", hostile, re.I))
                if language == "python":
                    self.assertEqual(ast.dump(ast.parse(hostile)), ast.dump(ast.parse(plain)))

    # Only the compiler knows all that ends a comment.
    def test_it_compiles(self):
        library = ("critical", drivers.members(self.generated(HOSTILE, "c++")["critical.hpp"]))
        for language in LANGUAGES:
            with self.subTest(language):
                self.generated(HOSTILE, language)
                drivers.answers(language, self.folder / "generated", [library], [(0, [1.0] * len(library[1]))])

    def test_names_of_files(self):
        odd = "odd \"><img src=x>\n$(touch intruder) ';`touch intruder`;'??\u2028.toml"
        text = self.generated("", "c++", odd)["critical.hpp"]
        self.assertEqual(self.without_comments(text), self.without_comments(self.generated("", "c++")["critical.hpp"]))

    def test_names_are_refused(self):
        path, out = self.file(PLAIN), self.folder / "out"
        for name in ["../intruder", "a/b", "a b", "$(touch intruder)", "a;b", "", ".", "-O3", "x\ny", "é", "a\u2028b",
                     "int", "/tmp/intruder"]:
            for language in LANGUAGES:
                self.refused(2, ["generate", path, "--language", language, f"--name={name}", "--out", out])
        for name in ["k 0", "k/0", "../k", "$(k)", "k\\\"", "k\\n", "<b>", "k}", "é"]:
            for text in [re.sub('(?m)^normal .*$', lambda _: f"normal = {json.dumps(name)}", f'{SCENE}\n"{name}" = 1'),
                         f'{SCENE}\n[networks]\n"{name}" = "k"']:
                path.write_text(text)
                self.refused(2, ["generate", path, "--out", out])
        self.assertFalse(out.exists())


class Tags(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, sorted(name for name, _ in attributes)))


class Pages(Case):
    @classmethod
    def setUpClass(cls):
        profile = cls.enterClassContext(tempfile.TemporaryDirectory(prefix="vcrit-profile-"))
        cls.browser = browser(profile, network=True)
        cls.addClassCleanup(cls.browser.quit)

    def opened(self, page):
        for kind in ["browser", "performance"]:
            self.browser.get_log(kind)  # what was left of other pages
        load(self.browser, page.as_uri())
        draw_charts(self.browser)

    def nothing_happened(self, page):
        self.opened(page)
        self.assertEqual(self.browser.current_url, page.as_uri())
        self.assertIsNone(self.browser.execute_script("return window.hostile ?? null"))
        self.assertEqual(self.browser.get_log("browser"), [])  # nor has the policy had anything to forbid
        messages = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        asked = {message["params"]["request"]["url"] for message in messages
                 if message["method"] == "Network.requestWillBeSent"}
        outward = {url for url in asked if not url.startswith(("data:", "blob:", "chrome:"))}
        self.assertEqual(outward, {page.as_uri()})
        self.policy_is_kept(page.read_text())

    def policy_is_kept(self, text):
        """It comes before all that it is for, and lets nothing but the page's own scripts run."""
        policy = re.search(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">', text)
        self.assertLess(policy.start(), text.index("<style"))
        rules = dict(rule.strip().split(" ", 1) for rule in html.unescape(policy[1]).split(";"))
        self.assertEqual(rules["default-src"], "'none'")
        # Pages with the explorer compile one module, the simulator that they hold.
        scripts = rules.get("script-src", "").replace("'wasm-unsafe-eval'", "", "simulator-module" in text)
        self.assertTrue(all(source.startswith("'sha256-") for source in scripts.split()))
        self.assertLessEqual(set(rules), {"default-src", "script-src", "img-src", "style-src", "base-uri",
                                          "form-action"})

    # What is wrong with a title, a name of a file and a comment of the scene is wrong on the page and in the index.
    def test_a_report(self):
        # Without a compiler it takes half the time; what one says of a scene is in the page's tests.
        environment = os.environ | {"PATH": "/nowhere"}
        files = [self.file(HOSTILE, "a\"><img src=x onerror='window.hostile=1'>$(touch intruder).toml"),
                 self.file(PLAIN, "b.toml")]
        files[0].write_text(files[0].read_text() + "\n# </script><script>window.hostile=1</script>\n")
        out = self.folder / "out"
        self.out("validate", *files, "--out", out, env=environment)
        pages = sorted(path.name for path in out.iterdir())
        self.assertEqual(len(pages), 6)
        for name in pages:
            self.assertRegex(name, r"^[A-Za-z0-9_-]+(\.evidence)?\.(html|json)$")
            if name.endswith(".html"):
                self.nothing_happened(out / name)
        # Tag by tag the pages of both scenes are the same.
        hostile, evidence = (out / next(name for name in pages if re.fullmatch(rf"a[^.]*{end}", name))
                             for end in [r"\.html", r"\.evidence\.html"])
        for own, plain in [(hostile, "b.html"), (evidence, "b.evidence.html")]:
            self.assertEqual(Tags(own.read_text()).tags, Tags((out / plain).read_text()).tags)
        self.assertIn("window.hostile", hostile.read_text())

    def test_a_fit(self):
        data = self.folder / "d\"><img src=x onerror='window.hostile=1'>.csv"
        data.write_text(DATA)
        self.out("fit", data, "--title", HOSTILE.replace("\x85\x9b", ""), "--out", self.folder / "f.toml")
        self.nothing_happened(self.folder / "f.html")

    def test_the_page_about_networks(self):
        page = self.folder / "material.html"
        page.write_text(self.out("derive", self.file(HOSTILE, "m.toml"), "--material"))
        self.nothing_happened(page)

    def test_pages_without_a_scene(self):
        catalogue = self.folder / "catalogue.html"
        catalogue.write_text(self.out("derive", "--catalogue"))
        self.nothing_happened(catalogue)


if __name__ == "__main__":
    os.environ.setdefault("HOME", tempfile.gettempdir())
    unittest.main()
