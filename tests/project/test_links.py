"""Every link from one Markdown page of the project to another file or heading leads somewhere."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv.pop(1))
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


def pages(root):
    for place in [root.glob("*.md"), (root / "docs").rglob("*.md"), (root / "validation").rglob("*.md")]:
        yield from sorted(place)


def anchors(page):
    """The headings of a page as a forge spells them in a link."""
    headings = re.findall(r"^#+\s+(.*)$", FENCE.sub("", page.read_text()), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(root):
    broken = []
    for page in pages(root):
        for link in LINK.findall(FENCE.sub("", page.read_text())):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            lost = not target.exists() or (anchor and anchor not in anchors(target))
            if lost:
                broken.append(f"{page.relative_to(root)}: {link}")
    return broken


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        self.assertEqual(broken_links(PROJECT), [])

    def test_there_are_some(self):
        self.assertIn("docs/physics.md", (PROJECT / "README.md").read_text())

    def test_a_broken_one_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "docs").mkdir()
            (root / "docs/page.md").write_text("# A page, at last\n[up](../README.md)\n")
            (root / "README.md").write_text(
                "[good](docs/page.md) [good](docs/page.md#a-page-at-last) [far](https://example.org)\n"
                "[lost](docs/other.md) [lost](docs/page.md#elsewhere)\n"
            )
            expected = ["README.md: docs/other.md", "README.md: docs/page.md#elsewhere"]
            self.assertEqual(broken_links(root), expected)


if __name__ == "__main__":
    unittest.main()
