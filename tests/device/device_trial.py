"""Generated CUDA code on a device, beside its own host code, which the suite holds against 250 digits.

    device_trial.py write PROGRAM FOLDER    evaluators of the scenes in tests/matrix/kinds, a driver and numbers for each
    device_trial.py run FOLDER [FLAG ...]   compiles them with nvcc and these flags, and runs them

The two can be on two machines: FOLDER, with a copy of this file in it, is all that the second takes. Numbers are those of
the scene, then within a decade of them, within fifteen decades, and with zeros. Ends with status 1 where a value of the
device leaves its bound, or an accurate one or a gradient has not the bits of the host's.
"""

import os
import random
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
COLUMNS = ("calls", "value", "bound", "fast value", "fast bound", "partials", "outside bounds")


def rows(numbers, generator):
    """Lists of parameters. mu0, omega and the amplitude come first, and are not 0."""
    yield numbers
    for decades, share, count in ((1, 1, 60), (15, 0.5, 30)):
        for _ in range(count):
            yield [x * 10 ** generator.uniform(-decades, decades) if generator.random() < share else x for x in numbers]
    for _ in range(9):
        yield [0.0 if i > 2 and generator.random() < 0.2 else x for i, x in enumerate(numbers)]


def write(program, folder):
    sys.argv = [sys.argv[0], str(HERE.parents[1]), str(program)]
    sys.path[:0] = [str(HERE.parent / "matrix"), str(HERE.parent / "support"), str(HERE.parent / "languages")]
    import cells
    import evaluators

    folder.mkdir(parents=True)
    shutil.copy(__file__, folder)
    driver = (HERE / "device_trial.cu").read_text()
    for kind in cells.KINDS:
        name = f"x_{kind}"
        generated = [cells.run("generate", cells.scene(kind), "--out", folder, "--name", name, "--language", language)
                     for language in ("c++", "cuda")]
        if any(ran.returncode != 0 for ran in generated):
            continue
        layout = evaluators.members((folder / f"{name}.hpp").read_text())
        numbers = list(map(float, evaluators.flat(kind, layout)))
        (folder / f"{name}.rows").write_text(
            "\n".join(" ".join(map(repr, row)) for row in rows(numbers, random.Random(kind))) + "\n")
        (folder / f"{name}.cu").write_text(driver.replace("LIBRARY", name).replace("OMEGA", layout[1][0]))
    print(f"{len(list(folder.glob('*.rows')))} evaluators in {folder}")


def compiled_and_ran(source, flags):
    program = source.with_suffix("")
    command = ["nvcc", "-std=c++17", "-O2", "-arch=native", *flags, "-o", program, source]
    built = subprocess.run(command, capture_output=True, text=True)
    if built.returncode != 0:
        return source.stem, built.stderr[-1000:]
    with source.with_suffix(".rows").open() as numbers:
        ended = subprocess.run([program], stdin=numbers, capture_output=True, text=True)
    return source.stem, list(map(int, ended.stdout.split())) if ended.returncode == 0 else ended.stderr


def run(folder, flags):
    print("calls, and of these how many have not the bits of the host's, and how many are outside their bounds")
    print(f"{'':32}" + "".join(f"{each:>15}" for each in COLUMNS))
    total, failed = [0] * len(COLUMNS), []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, found in pool.map(lambda source: compiled_and_ran(source, flags), sorted(folder.glob("*.cu"))):
            if isinstance(found, str):
                failed.append(name)
                print(f"{name:32} {found}")
                continue
            total = [a + b for a, b in zip(total, found)]
            print(f"{name:32}" + "".join(f"{each:15}" for each in found), flush=True)
    print(f"{'all':32}" + "".join(f"{each:15}" for each in total))
    return not failed and total[0] > 0 and total[1] == total[5] == total[6] == 0


def main():
    match sys.argv[1:]:
        case ["write", program, folder]:
            write(Path(program).resolve(), Path(folder))
        case ["run", folder, *flags]:
            sys.exit(0 if run(Path(folder), flags) else 1)
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
