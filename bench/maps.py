"""What maps cost, measured: `./dev bench maps [--points N] [--folder DIR]`.

Rates end to end into netCDF beside the disk's own, which the same number of bytes written and synced by itself shows in
the same minute; beside the generated batch evaluator, compiled and run alone; memory; and how friction maps scale
with cores, beside two processes that have nothing to do with each other. Markdown on standard output.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]
PROGRAM = str(PROJECT / "build/release/vcrit")
SCENES = [str(PROJECT / "scenes" / name) for name in ("kelvin.toml", "zener.toml", "prony.toml", "bridge.toml")]
BATCH = """
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>
#include "pad.hpp"
int main() {
  const pad::Parameters scene{0.3, 1, 1e-7};  // mu0, omega, du_z
  std::vector<double> omega(1 << 17), out(omega.size());
  for (std::size_t i = 0; i < omega.size(); ++i) omega[i] = 6e3 * (1 + 1e-3 * static_cast<double>(i));
  double best[2] = {1, 1};
  for (int round = 0; round < 40; ++round)
    for (int grade = 0; grade < 2; ++grade) {
      const auto start = std::chrono::steady_clock::now();
      if (grade == 0) pad::critical_velocity(scene, omega, out);
      else pad::fast::critical_velocity(scene, omega, out);
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      best[grade] = std::min(best[grade], time.count() / static_cast<double>(omega.size()));
    }
  std::printf("%.2f %.2f\\n", best[0] * 1e9, best[1] * 1e9);
}
"""


def timed(command):
    """Seconds, and the peak of memory in MB, of a command."""
    script = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True); "
              "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024)")
    start = time.perf_counter()
    ended = subprocess.run([sys.executable, "-c", script, *command], check=True, capture_output=True, text=True)
    return time.perf_counter() - start, float(ended.stdout)


def write_alone(file, size):
    block = os.urandom(1 << 20)
    start = time.perf_counter()
    with open(file, "wb") as out:
        for _ in range(size >> 20):
            out.write(block)
        out.flush()
        os.fsync(out.fileno())
    seconds = time.perf_counter() - start
    file.unlink()
    return seconds


def velocity_map(scene, side, file, *options):
    return [PROGRAM, "sweep", scene, "--over", f"frequency=log:1 kHz:1 MHz:{side}", "--over",
            f"amplitude=lin:10 nm:100 nm:{side}", "--quantity", "critical_velocity", "--out", str(file), *options]


def rates(folder, points):
    print("| scene | points | seconds | M points/s | MB/s | disk alone, MB/s | share | memory, MB |\n|---|---|---|---|---|---|---|---|")
    for scene, count in [(SCENES[1], 10**6), *[(scene, min(points, 10**8)) for scene in SCENES], (SCENES[1], points)]:
        side = round(count ** 0.5)
        file = folder / "map.h5"
        alone = write_alone(folder / "alone", 8 * side * side)
        seconds, memory = timed(velocity_map(scene, side, file))
        file.unlink()
        alone = (alone + write_alone(folder / "alone", 8 * side * side)) / 2
        size = 8e-6 * side * side
        print(f"| {Path(scene).stem} | {side * side} | {seconds:.2f} | {side * side / seconds / 1e6:.1f} | "
              f"{size / seconds:.0f} | {size / alone:.0f} | {alone / seconds:.2f} | {memory:.0f} |", flush=True)


def generated(folder):
    """The generated batch alone, on one core, with all parameters but omega folded in, against a map in memory."""
    memory = Path("/dev/shm")
    print("\n| scene | generated batch, accurate, ns | fast, ns | map without a disk, one thread, ns | two threads, ns |\n|---|---|---|---|---|")
    for scene in SCENES:
        subprocess.run([PROGRAM, "generate", scene, "--out", str(folder), "--name", "pad", "--fix", "all"],
                       check=True, stdout=subprocess.DEVNULL)
        (folder / "main.cpp").write_text(BATCH)
        subprocess.run(["g++", "-std=c++20", "-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math", "main.cpp",
                        "-o", "main"], cwd=folder, check=True)
        accurate, fast = subprocess.run([str(folder / "main")], check=True, capture_output=True, text=True).stdout.split()
        times = []
        for threads in ("1", "2"):
            best = min(timed(velocity_map(scene, 10_000, memory / "vcrit_map.h5", "--threads", threads))[0] for _ in range(3))
            times.append(f"{best / 1e8 * 1e9:.1f}")
        (memory / "vcrit_map.h5").unlink()
        print(f"| {Path(scene).stem} | {accurate} | {fast} | {' | '.join(times)} |", flush=True)


def friction(folder):
    command = [PROGRAM, "sweep", SCENES[1], "--over", "k1=lin:1e6:9e6:100", "--over", "amplitude=lin:10 nm:390 nm:80",
               "--over", "velocity_ratio=lin:0.1:1.1:50", "--quantity", "friction_ratio"]

    def run(processes, threads):
        start = time.perf_counter()
        running = [subprocess.Popen([*command, "--threads", str(threads), "--out", str(folder / f"{i}.h5")])
                   for i in range(processes)]
        for process in running:
            process.wait()
        seconds = time.perf_counter() - start
        for i in range(processes):
            (folder / f"{i}.h5").unlink()
        return seconds

    one, two, both = map(statistics.median, zip(*[(run(1, 1), run(1, 2), run(2, 1)) for _ in range(5)]))
    print("\n| friction map of 400,000 points | |\n|---|---|")
    print(f"| one thread | {one:.2f} s, {4e5 / one:.0f} points/s |")
    print(f"| two threads | {two:.2f} s, {4e5 / two:.0f} points/s |")
    print(f"| two threads against one | {one / two:.2f} |")
    print(f"| two processes of one thread against one | {2 * one / both:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", type=int, default=10**8, help="of the largest map")
    parser.add_argument("--folder", help="on the disk to be measured")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        rates(Path(folder), options.points)
        generated(Path(folder))
        friction(Path(folder))


if __name__ == "__main__":
    main()
