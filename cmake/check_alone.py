"""Compiles each source file of the build folder BUILD on its own, for errors and warnings alone: no code is made.

    check_alone.py BUILD [FOLDER...]     only files below these folders of the project

Files that are compiled together (cmake/unity.cmake) may lack an include without anybody noticing.
"""

import concurrent.futures
import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

build, folders = Path(sys.argv[1]), sys.argv[2:]
project = Path(__file__).resolve().parent.parent


def alone(entry):
    words = shlex.split(entry["command"])
    if Path(words[0]).name == "ccache":
        words = words[1:]
    del words[words.index("-o"):words.index("-o") + 2]
    return subprocess.run([*words, "-fsyntax-only"], cwd=entry["directory"], capture_output=True, text=True)


entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
           if entry["file"].endswith(".cpp") and project in Path(entry["file"]).parents
           and (not folders or Path(entry["file"]).relative_to(project).parts[0] in folders)]
failed = 0
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for done, (entry, result) in enumerate(zip(entries, pool.map(alone, entries)), 1):
        print(f"[{done}/{len(entries)}] {Path(entry['file']).relative_to(project)}", flush=True)
        if result.returncode:
            failed += 1
            print(result.stderr, flush=True)
if failed or not entries:
    sys.exit(f"{failed} of {len(entries)} files do not compile on their own")
