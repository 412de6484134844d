"""Does the suite notice a fault? Some forty of them, each one token in one room, are planted one after the other
into a copy of the sources; the test that stands beside each has to fail. One that runs out of time is no catch.

    plant_faults.py [--folder FOLDER] [NUMBER...]

Builds in FOLDER (build/mutation), from the last commit. Prints a line for each fault and how many were
caught; ends with status 1 if one was not. Takes a minute or two for each, and is no part of the suite.
`--list` checks only that each place is still there, which the suite does.
"""

import argparse
import subprocess
import sys
import time
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]

# File, where (the only place with this text), its token, what is planted, the test that has to fail.
FAULTS = [
    ("src/base/csv.cpp", "begin = comma + 1;", "1", "2", "base/test_csv"),
    ("src/base/units.cpp", "dimension == Dimension::frequency && angular", "&&", "||", "base/test_units"),
    ("src/network/reduction.cpp", "is_new) known->second = combine(Step::Kind::parallel", "parallel", "series",
     "network/test_reduction"),
    ("src/network/masses.cpp", "!from_is_far && !to_is_far", "!from", "from", "network/test_mass_networks"),
    ("src/scene/bracket.hpp", "return {&*(above - 1), &*above};", "1", "2", "scene/test_receptance"),
    ("src/stiffness/graph_relaxation.cpp", "form_.damper -= mode.squared_coupling / nu;", "-=", "+=",
     "stiffness/test_graph_relaxation"),
    ("src/stiffness/secular.cpp", "((value > 0) == rising ? high : low) = d;", ">", "<", "stiffness/test_secular"),
    ("src/rules/kinds.cpp", "return !separating && !problem_->indenter && mean_force() > 0 &&", ">", "<",
     "critical/test_admissibility"),
    ("src/critical/log_derivative.cpp", "return Dual{2} * (Dual{1} - value) / (Dual{2} - value)", "Dual{1}", "Dual{2}",
     "sweep/test_sweep"),
    ("src/normal/mean_indentation.cpp", "return static_stiffness * problem.value(problem->indentation);", "*", "/",
     "simulation/system/test_system"),
    ("src/simulation/motion/switching.cpp", "dx[i] -= rate_after[i] * shifts[j]", "-=", "+=",
     "simulation/steady/test_exact"),
    ("src/simulation/steady/energy.cpp", "heat.add(state.x[2 + j], drive.rates[j] / drive.weights[j]", "/", "*",
     "simulation/steady/test_energy"),
    ("src/simulation/methods/moreau.cpp", "y[0] += (top - y[0]) / theta_;", "/", "*", "simulation/methods/test_moreau"),
    ("src/sweep/axis.cpp", "a * (1 - share) + b * share", "+", "-", "sweep/test_axis"),
    ("src/maps/csv_map.cpp", "if (whole.bytes == 0) append(header);", "==", "!=", "maps/test_maps"),
    ("src/design/first_reach.cpp", "if (reached) search_.reach = refined(before, *reached)", "before", "after",
     "design/test_first_reach"),
    ("src/fit/nnls.cpp", "return x_.cwiseQuotient(size_);", "cwiseQuotient", "cwiseProduct", "fit/test_nnls"),
    ("src/fit/refine.cpp", "result.col(branches_ + i++) = branch.stiffness *", "stiffness", "time", "fit/test_fit"),
    ("symbolic/formula/form.cpp", "return !prefactor && has_base(form, \"omega\") ? 3", "!prefactor", "prefactor",
     "document/test_print"),
    ("src/network/polynomial.cpp", "lowest = std::min(lowest, exponents(i)[index])", "min", "max",
     "network/test_polynomial"),
    ("symbolic/derivation/leading_reduction.cpp", "(a > b) == (step.kind == Step::Kind::parallel)", ">", "<",
     "analysis/test_limits"),
    ("symbolic/analysis/resonance.cpp", "(p.odd * q.even - p.even * q.odd)", "-", "+", "analysis/test_resonance"),
    ("symbolic/program/star_mesh.cpp", "program_.multiply(b.roundings, b.size)", "b.size", "a.size",
     "emit/test_graphs"),
    ("symbolic/program/gradient.cpp", "add(b, change, c);", "change, c", "change, b", "emit/test_gradients"),
    ("symbolic/emit/languages/cpp/groups.cpp", "program_.divide(product(monomial.above), product(monomial.below))", "below", "above",
     "emit/test_quantities"),
    ("symbolic/document/displays.cpp", "block.asymptotic && &line == &block.lines.back()", "block.asymptotic &&",
     "!block.asymptotic &&", "document/test_print"),
    ("validation/compare/agreement.cpp", "if (closed_form) report.curve.back().closed_form", "closed_form", "!closed_form",
     "validation/test_validate"),
    ("validation/compare/reduced_difference.cpp", "percent / 100.0", "100.0", "10.0", "validation/test_reduced_difference"),
    ("src/answers/critical_onset.cpp", "value + creep_velocity(problem)", "+", "-", "project/test_scenes"),
    ("python/batch.cpp", "return std::pair(refused->lane, refused->why);", "refused->lane", "lanes",
     "python/test_arrays"),
    ("app/critical.cpp", "return apart(simulated, sliding_from);", "sliding_from", "formula", "app/test_critical"),
    ("src/network/law.hpp", "return algebra.times_s(algebra.times_s(coefficient));", "algebra.times_s(coefficient)",
     "coefficient", "critical/test_log_derivative"),
    ("src/design/solve.cpp", "std::abs(step) * state.friction_ratio_error / rise", "state.friction_ratio_error", "0",
     "design/test_solve"),
    ("src/rules/kinds.cpp", "!problem->mass && problem->receptance()", "!problem->mass", "true",
     "answers/test_critical_onset"),
    ("src/normal/normal_motion.hpp", "below_indenter ? 1e-8 : 1e-14", "1e-14", "1e-4",
     "simulation/system/test_system"),
    ("src/indenter/friction.cpp", "return (half_space.edge() - edge) *", "(half_space", "0 * (half_space",
     "indenter/test_indenter_friction"),
    ("src/simulation/steady/steady_cycle.cpp", "model_.bound_error() + model_.merging;", "model_.bound_error()", "0",
     "simulation/steady/test_separation"),
    ("src/critical/conditioning.hpp", "inline constexpr double motion_promise = 1e-9;", "1e-9", "1e-5",
     "validation/test_planted_faults"),
    ("validation/compare/border.cpp", "if (below.sticks && !above.sticks) return comparison;", "!above.sticks", "true",
     "validation/test_planted_faults"),
    ("src/critical/conditioning.cpp", "infinity : condition;", ": condition", ": 300 * condition", "critical/test_conditioning"),
    ("src/rules/kinds.hpp", "return oscillating_force() > mean_force();", ">", "<", "rules/test_rulebook"),
]


def planted(number):
    """The file's text with the fault; refuses a place that is not there, or not alone."""
    file, where, token, fault, _ = FAULTS[number - 1]
    text = (PROJECT / file).read_text()
    if text.count(where) != 1:
        sys.exit(f"fault {number}: {file} has {text.count(where)} places \"{where}\", expected one")
    if token not in where:
        sys.exit(f"fault {number}: no \"{token}\" in \"{where}\"")
    return text.replace(where, where.replace(token, fault, 1))


# A fault that makes a test run on without end is not noticed by what the test compares.
VERDICTS = {"failed": "caught", "passed": "MISSED", "timed out": "TIMED OUT"}
LONGEST = 600  # seconds; the longest of the tests take 200 without a fault


class Copy:
    """The last commit, in a folder of its own, with its build."""

    def __init__(self, folder):
        self.folder, self.build = folder, folder / "build/release"
        if not (folder / ".git").exists():
            self.run("git", "clone", "--quiet", "--shared", PROJECT, folder, place=PROJECT)
        head = self.run("git", "rev-parse", "HEAD", place=PROJECT).stdout.strip()
        self.run("git", "fetch", "--quiet", "origin", head)
        self.run("git", "checkout", "--quiet", "--force", "--detach", head)
        self.run("cmake", "--preset", "release")
        self.targets = set(self.run("ninja", "-C", self.build, "-t", "targets", "all").stdout.split())

    def run(self, *words, place=None, check=True):
        ended = subprocess.run([str(word) for word in words], cwd=place or self.folder, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if check and ended.returncode != 0:
            sys.exit(f"{' '.join(map(str, words))} ended with {ended.returncode}:\n{ended.stdout[-4000:]}")
        return ended

    def built(self, test):
        room = test.split("/")[0]
        own = f"test_{room}"
        targets = [own] if f"{own}:" in self.targets else ["_vcrit"] if room == "python" else ["vcrit"]
        return self.run("ninja", "-C", self.build, *targets, check=False)

    def outcome(self, test):
        """passed, failed, or timed out, which says nothing of what the test noticed."""
        ended = self.run("ctest", "--preset", "release", "--timeout", str(LONGEST), "-R", f"^{test}$",
                         "--no-tests=error", check=False)
        return outcome_of(ended.returncode, ended.stdout, test)


def outcome_of(status, printed, test):
    if "No tests were found" in printed:
        sys.exit(f"there is no test {test}")
    if "(Timeout)" in printed or "***Timeout" in printed:
        return "timed out"
    if "(Not Run)" in printed:
        sys.exit(f"{test} could not be run:\n{printed[-3000:]}")
    return "passed" if status == 0 else "failed"


def outcome_with(copy, number):
    file, _, _, _, test = FAULTS[number - 1]
    place = copy.folder / file
    sound = place.read_text()
    try:
        place.write_text(planted(number))
        built = copy.built(test)
        if built.returncode != 0:
            sys.exit(f"fault {number} does not compile:\n{built.stdout[-3000:]}")
        return copy.outcome(test)
    finally:
        place.write_text(sound)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--folder", type=Path, default=PROJECT / "build/mutation")
    options.add_argument("--list", action="store_true")
    options.add_argument("numbers", nargs="*", type=int, metavar="NUMBER")
    chosen = options.parse_args()
    numbers = chosen.numbers or range(1, len(FAULTS) + 1)
    for number in numbers:
        planted(number)
    if chosen.list:
        return
    copy, caught = Copy(chosen.folder.resolve()), 0
    for number in numbers:
        file, where, token, fault, test = FAULTS[number - 1]
        began = time.monotonic()
        built = copy.built(test)
        if built.returncode != 0 or copy.outcome(test) != "passed":
            sys.exit(f"{test} fails without a fault:\n{built.stdout[-3000:]}")
        found = VERDICTS[outcome_with(copy, number)]
        caught += found == "caught"
        print(f"{number:2} {found}  {test}: {token} -> {fault} in {file}: {where}"
              f"  ({time.monotonic() - began:.0f} s)", flush=True)
    print(f"{caught} of {len(numbers)} caught")
    sys.exit(0 if caught == len(numbers) else 1)


if __name__ == "__main__":
    main()
