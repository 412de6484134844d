"""What C++ sources declare at namespace level, read without a compiler: enough for clang-formatted code."""

import re
from dataclasses import dataclass

TOKEN = re.compile(
    r"""//[^\n]* | /\*.*?\*/ | R"(?P<tag>[^(\s]*)\(.*?\)(?P=tag)" | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+'
      | ^[ \t]*\#(?:\\\n|[^\n])* | [A-Za-z_]\w* | \d[\w.']* | :: | -> | \S""", re.S | re.X | re.M)
IDENTIFIER = re.compile(r"[A-Za-z_]\w*\Z")
TYPES = {"struct", "class", "enum", "union"}
SPECIFIERS = {"template", "extern", "static", "inline", "constexpr", "consteval", "constinit", "typedef"}
CLOSING = {"(": ")", "[": "]", "{": "}"}
DEPTH = {bracket: 1 for bracket in CLOSING} | {bracket: -1 for bracket in CLOSING.values()}
NOT_A_NAME = {"noexcept", "const", "requires", "decltype", "alignas", "__attribute__", "static_assert", "defined"}


@dataclass(frozen=True)
class Declaration:
    namespace: tuple  # ("vcrit", "symbolic"); "" is an anonymous one
    name: str
    kind: str  # "function", "type", "nested" (a type within one), "variable" or "using" (of a name from elsewhere)
    line: int


def tokens(text):
    line, counted = 1, 0
    for match in TOKEN.finditer(text):
        word = match.group()
        line, counted = line + text.count("\n", counted, match.start()), match.start()
        if not word.lstrip().startswith(("//", "/*", "#")):
            yield ('""' if word[-1] in "\"'" and len(word) > 1 else word), line


def past(words, at):
    """The place behind the bracket that opens at `at`."""
    depth = 0
    while at < len(words):
        depth += DEPTH.get(words[at][0], 0)
        at += 1
        if depth == 0:
            break
    return at


def without_templates(words):
    """The words less every <...> that follows `template` or a name."""
    result, depth = [], 0
    for i, word in enumerate(words):
        if word == "<" and (depth or (i and IDENTIFIER.match(words[i - 1]) and words[i - 1] != "operator")):
            depth += 1
        elif word == ">" and depth:
            depth -= 1
        elif not depth:
            result.append(word)
    return result


def name_of(words):
    """Kind and name of a declaration that is no namespace; None where it declares none of its own."""
    words = without_templates(words)
    while words and (words[0] == "[" or words[0] in SPECIFIERS):
        words = words[past([(word, 0) for word in words], 0):] if words[0] == "[" else words[1:]
    if not words or words[0] in ("static_assert", "friend", "asm", "requires") or "operator" in words:
        return None
    if words[0] == "using":
        if "=" in words:
            return "type", words[1]
        return None if "namespace" in words else ("using", words[-1])
    head = words[:words.index("=")] if "=" in words else words
    if "(" in head:
        for i, word in enumerate(head):
            if word == "(" and i and IDENTIFIER.match(head[i - 1]) and head[i - 1] not in NOT_A_NAME:
                return "function", head[i - 1]
        return None
    if words[0] in TYPES:
        names = [w for w in words[1:] if IDENTIFIER.match(w) and w not in ("class", "struct", "final", "alignas")]
        return ("type", names[0]) if names else None
    names = [w for i, w in enumerate(head) if IDENTIFIER.match(w) and not (i and head[i - 1] == "[")]
    return ("variable", names[-1]) if len(names) > 1 else None


def others(words):
    """The names behind the first in `constexpr int least = 1, most = 9`."""
    words = without_templates(words)
    return [words[i + 1] for i, word in enumerate(words[:-1]) if word == "," and IDENTIFIER.match(words[i + 1])]


def nested_types(words):
    """Types declared within the body of one, and their lines; those of functions in it, too."""
    for (word, _), (name, line), (behind, _) in zip(words, words[1:], words[2:]):
        if (word in TYPES or word == "using") and IDENTIFIER.match(name) and behind in ("{", ":", "=", "final"):
            yield name, line


def declarations(text):
    words, result, namespace, at = list(tokens(text)), [], [], 0
    blocks = []  # the namespaces that each open brace added
    while at < len(words):
        word = words[at][0]
        if word == "}":
            for _ in range(blocks.pop() if blocks else 0):
                namespace.pop()
            at += 1
            continue
        if word == ";":
            at += 1
            continue
        if word in ("namespace", "inline") and "namespace" in (word, words[min(at + 1, len(words) - 1)][0]):
            end = at
            while words[end][0] not in ("{", ";"):
                end += 1
            names = [w for w, _ in words[at:end] if IDENTIFIER.match(w) and w not in ("namespace", "inline")] or [""]
            if words[end][0] == "{":
                namespace += names
                blocks.append(len(names))
            at = end + 1
            continue
        if word == "extern" and words[at + 1][0] == '""' and words[at + 2][0] == "{":
            blocks.append(0)
            at += 3
            continue
        start, head = at, []
        while at < len(words) and words[at][0] not in (";", "{", "}"):
            if words[at][0] in ("(", "["):
                end = past(words, at)
                head += [w for w, _ in words[at:end]] if words[at][0] == "[" else ["(", ")"]
                at = end
            else:
                head.append(words[at][0])
                at += 1
        found = name_of(head)
        if found:
            names = [found[1], *(others(head) if found[0] == "variable" else [])]
            result += [Declaration(tuple(namespace), name, found[0], words[start][1]) for name in names]
        if at < len(words) and words[at][0] == "{":
            body, at = at, past(words, at)
            if found and found[0] == "type":
                result += [Declaration(tuple(namespace), name, "nested", line) for name, line in nested_types(words[body:at])]
            if (not found or found[0] != "function") or "=" in head:
                while at < len(words) and words[at][0] not in (";", "}"):
                    at = past(words, at) if words[at][0] in CLOSING else at + 1
        elif at < len(words) and words[at][0] == ";":
            at += 1
    return result
