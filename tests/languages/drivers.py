"""Evaluators of any language compiled and run, by the rows of languages.toml."""
import json
import re
import subprocess
import tomllib
from pathlib import Path

HERE = Path(__file__).parent
PLAIN_ANSWERS = 8  # see driver.c


def read_table():
    table = tomllib.loads((HERE / "languages.toml").read_text())
    strict = table.pop("STRICT")
    for row in table.values():
        for tool in row["tools"]:
            tool["compile"] = [each for word in tool.get("compile", []) for each in (strict if word == "STRICT" else [word])]
    return table


LANGUAGES = read_table()


def members(header, struct="Parameters"):
    """[(name, length or 0)] of a struct of a C++ header."""
    body = re.search(rf"struct {struct} \{{(.*?)\}};", header, re.S)
    if not body:
        return []
    found = []
    # A declaration of many names has several lines.
    for length, names in re.findall(r"^\s*(?:double|std::array<double, (\d+)>) ([\w,\s]+);", body[1], re.M):
        found += [(name, int(length or 0)) for name in re.split(r",\s+", names)]
    return found


def driver(language, libraries, gradients):
    """The driver's text for [(name, members)]."""
    def each(match):
        texts = []
        for number, (name, layout) in enumerate(libraries):
            marks = {"LIBRARY": name, "NUMBER": str(number), "MEMBERS": json.dumps(layout), "OMEGA": layout[1][0]}
            texts.append(re.sub(r"\b(LIBRARY|NUMBER|MEMBERS|OMEGA)\b", lambda mark: marks[mark[0]], match[1]))
        return "".join(texts)

    text = (HERE / LANGUAGES[language]["driver"]).read_text()
    text = re.sub(r"^ *(?://|#): each\n(.*?)^ *(?://|#): end\n", each, text, flags=re.S | re.M)
    return text.replace("WITH_GRADIENTS", "1" if gradients else "0")


def ran(words, folder, text=""):
    done = subprocess.run(words, cwd=folder, input=text, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        raise AssertionError(done.stderr[:3000] + done.stdout[:500])
    return done.stdout


def number(word):
    return float.fromhex(word) if "0x" in word else float(word)


def answers(language, folder, libraries, rows, gradients=False):
    """Of the libraries [(name, members)] in `folder`: a list of numbers, see driver.c, for each row (library, numbers)."""
    row = LANGUAGES[language]
    (folder / row["driver"]).write_text(driver(language, libraries, gradients))
    tool = next(tool for tool in row["tools"] if not tool.get("optional"))
    command = lambda words: [word.replace("FOLDER/", f"{folder}/") for word in words]
    if tool["compile"]:
        ran(command(tool["compile"] + row["quick"]), folder)
    text = "".join(f"{library} {' '.join(map(repr, numbers))}\n" for library, numbers in rows)
    return [[number(word) for word in line.split()] for line in ran(command(tool["run"]), folder, text).splitlines()]
