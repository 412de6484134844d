"""Compiles each source file of the build folder BUILD on its own, for errors and warnings alone: no code is made. So
with each header of the libraries that no source file begins with.

    check_alone.py BUILD [FOLDER...]     only files below these folders of the project

Files that are compiled together (cmake/unity.cmake) may lack an include without anybody noticing.
"""

import concurrent.futures
import json
import os
import re
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


def headers_without_file(entries):
    """As entries: compiled as a source file of the same library would be."""
    begun_with = set()
    for entry in entries:
        first = re.search(r'^#include "(.*)"', Path(entry["file"]).read_text(), re.MULTILINE)
        begun_with.add(first[1] if first else "")
    for library in ("src", "symbolic"):
        like = [entry for entry in entries if Path(entry["file"]).relative_to(project).parts[0] == library]
        for header in sorted((project / library).rglob("*.hpp")) if like else []:
            if str(header.relative_to(project / library)) not in begun_with:
                command = like[0]["command"].replace(f"-c {like[0]['file']}", f"-x c++ -include {header} -c /dev/null")
                yield like[0] | {"file": str(header), "command": command}


entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
           if entry["file"].endswith(".cpp") and project in Path(entry["file"]).parents
           and (not folders or Path(entry["file"]).relative_to(project).parts[0] in folders)]
entries += headers_without_file(entries)
failures = []
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for done, (entry, result) in enumerate(zip(entries, pool.map(alone, entries)), 1):
        print(f"[{done}/{len(entries)}] {Path(entry['file']).relative_to(project)}", flush=True)
        if result.returncode:
            failures.append(result.stderr)
if failures or not entries:
    sys.exit("\n".join(failures) + f"{len(failures)} of {len(entries)} files do not compile on their own")
