"""vcrit validate --paper as a user meets it: exit status, files, what is in them."""

import csv
import json
import re
import unittest
from decimal import Decimal

from program import PROJECT, Case, example


class Paper(Case):
    def test_the_paper_is_gone_through(self):
        report, page = self.reported("--paper")
        known = list(csv.DictReader((PROJECT / "tests/data/paper_claims.csv").read_text().splitlines()))
        told = {str(claim["number"]): claim for claim in report["paper"]["claims"]}
        self.assertEqual({number: claim["verdict"] for number, claim in told.items()},
                         {row["number"]: row["verdict"].replace("not decidable", "not legible") for row in known})
        for claim in told.values():
            self.assertIn(f'id="claim-{claim["number"]}"', page)
        # docs/physics.md, elastic contact and delta = 10, both promised to 1e-14 and given to 17 digits.
        rows = {(row["delta"], row["velocity_ratio"]): row for row in report["paper"]["evidence"]["rows"]}
        self.assertAlmostEqual(rows[10, 0.1]["exact"], 0.43472823801559018, delta=2e-14)
        self.assertAlmostEqual(rows[10, 0.1]["reduced"], 0.7207052919138, delta=1e-13)
        for part in ["figure4", "difference", "jump_limits", "static_limit", "flat_punch"]:
            self.assertNotRegex(json.dumps(report["paper"][part]), r"mass|\bbody\b")
        self.assertIn("153 comparisons passed", page)

    def test_the_docs_say_the_same(self):
        page = (PROJECT / "docs/physics.md").read_text()
        for row in csv.DictReader((PROJECT / "tests/data/paper_claims.csv").read_text().splitlines()):
            verdict = row["verdict"].replace("not decidable", "not legible")
            self.assertTrue(re.search(rf"(?m)^\| {row['number']} \| [^|]* \| {verdict}\b", page), row)
        table = [line for line in (PROJECT / "tests/data/paper_crossings.csv").read_text().splitlines()[1:]]
        for delta, ratio, weak, at, strong, there in csv.reader(table):
            delta = {"0": "-> 0", "inf": "infinity"}.get(delta, delta)
            cells = [f"{Decimal(ratio):.16f}", weak and f"{float(weak):.10f}", at and f"{float(at):.4f}",
                     strong and f"{float(strong):.10f}", there and f"{float(there):.4f}"]
            cells = ["0" if cell == "0.0000000000" else cell for cell in cells]
            line = rf"(?m)^\| {delta} \| " + r" *\| *".join(map(re.escape, cells)) + r" *\|$"
            self.assertTrue(re.search(line, page), cells)

    def test_it_is_the_same_in_every_run(self):
        for folder in ["first", "again"]:
            self.out("validate", "--paper", "--out", folder)
        for name in ["index.html", "report.json"]:
            self.assertEqual(*((self.folder / folder / name).read_text() for folder in ["first", "again"]))

    def test_scenes_or_the_paper(self):
        for arguments, words in [((), ["SCENE", "--paper"]), (("--paper", example("kelvin")), ["--paper", "scene files"])]:
            self.refused(2, ["validate", *arguments, "--out", "out"], *words)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
