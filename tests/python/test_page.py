"""What docs/python.md shows is what Python prints.

    test_page.py PROGRAM             compares
    test_page.py PROGRAM --update    writes what is printed now into the page
"""

import doctest
import re
import sys
import unittest

from support import PROJECT

PAGE = PROJECT / "docs/python.md"
BLOCK = re.compile(r"(?<=^```pycon\n)(.*?)(?=^```$)", re.MULTILINE | re.DOTALL)


class Session(doctest.DocTestRunner):
    """The examples of a page, run in order in one interpreter; which of them print something else."""

    def __init__(self, text):
        super().__init__(verbose=False)
        self.differences = []
        self.examples = doctest.DocTestParser().get_doctest("\n".join(BLOCK.findall(text)), {}, "page", None, 0)
        self.run(self.examples, out=lambda text: None)

    def report_failure(self, out, test, example, got):
        self.differences.append((example, got))

    def report_unexpected_exception(self, out, test, example, exc_info):
        self.differences.append((example, repr(exc_info[1])))


def updated(text):
    for example, got in Session(text).differences:
        shown = "".join((">>> " if i == 0 else "... ") + line
                        for i, line in enumerate(example.source.splitlines(keepends=True)))
        text = text.replace(shown + example.want, shown + got)
    return text


class Page(unittest.TestCase):
    def test_shows_what_is_printed(self):
        session = Session(PAGE.read_text())
        self.assertEqual([(example.source, got) for example, got in session.differences], [])
        self.assertGreater(len(session.examples.examples), 20)

    def test_of_something_else_is_found_and_updated(self):
        text = "```pycon\n>>> for i in range(2):\n...     print(i)\n3\n```\n"
        self.assertEqual(len(Session(text).differences), 1)
        self.assertEqual(updated(text), text.replace("3\n", "0\n1\n"))


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        PAGE.write_text(updated(PAGE.read_text()))
    else:
        unittest.main()
