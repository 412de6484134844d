"""Thousands of documents of `vcrit derive` from one process (tests/document/print_asked.cpp), which finds out once what
is printed in several formats: the same functions of the library, without the command's own start for each.
"""

import json
import subprocess


def documents(program, asked, **options):
    """[{format: text}] of each {"scene", "form", "limits", "sensitivities", "formats"}."""
    lines = "".join(json.dumps(each) + "\n" for each in asked)
    done = subprocess.run([program, "asked"], input=lines, capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"print_documents asked: status {done.returncode}: {done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]
