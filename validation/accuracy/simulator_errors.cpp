#include "accuracy/simulator_errors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "accuracy/front.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "compare/friction.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"

namespace vcrit::validation::accuracy {

namespace {

using simulation::SteadyState;
using simulation::System;

// Short solves are repeated for so many seconds, and the median taken.
constexpr double repeat = 3e-3;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& run) {
  const double begin = processor_time();
  run();
  return processor_time() - begin;
}

double median_time(const std::function<void()>& run, double first) {
  std::vector<double> times{first};
  for (double spent = first; spent < repeat && times.size() < 9; spent += times.back())
    times.push_back(seconds_of(run));
  std::nth_element(times.begin(), times.begin() + static_cast<long>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

bool sticks(const SteadyState& state) { return state.regime != simulation::Regime::sliding; }

Solve unsolved(const Setting& setting) {
  Solve solve;
  solve.method = setting.method;
  solve.setting = setting.name;
  return solve;
}

struct Solved {
  const Setting* setting;
  Solve solve;
  bool sticks = false;
};

Solved solved(const Setting& setting, const System& system, double velocity) {
  Solved result{&setting, unsolved(setting)};
  Solve& solve = result.solve;
  try {
    SteadyState state;
    const auto run = [&] { state = setting.solve(system, velocity); };
    const double first = seconds_of(run);
    solve.answered = true;
    solve.friction_ratio = state.friction_ratio;
    result.sticks = sticks(state);
    solve.seconds = median_time(run, first);
  } catch (const ModelError& error) {
    solve.failure = error.what();
  }
  return result;
}

bool elastic(const Relaxation& form) {
  return form.damper == 0 && form.branches.empty() && form.equilibrium > 0;
}

/// The elastic contact's closed form, where the scene is one.
std::optional<double> closed_form(const Problem& problem, const System& system, double ratio) {
  if (system.opening || system.drive || system.masses || !elastic(system.contact) ||
      !elastic(relaxation_form(problem->normal.network(), problem.values())))
    return std::nullopt;
  return elastic_friction(std::abs(system.normal_force_amplitude) / system.mean_normal_force,
                          ratio);
}

/// The tightest setting of a method with an order high enough to be a witness.
const Solved* witness(const std::vector<Solved>& all) {
  const Solved* best = nullptr;
  for (const Solved& each : all)
    if (each.solve.answered && each.solve.method != "exact" && !each.setting->idealised &&
        (best == nullptr || each.setting->allowed < best->setting->allowed))
      best = &each;
  return best;
}

std::optional<FrictionReference> friction_reference(const std::vector<Solved>& all,
                                                    std::optional<double> closed) {
  if (closed)
    return FrictionReference{*closed, *closed < 1, "closed form of the elastic contact", {}};
  const Solved& exact = all.front();
  if (!exact.solve.answered) return std::nullopt;
  FrictionReference result{
      exact.solve.friction_ratio, exact.sticks, "exact motion between events", {}};
  if (const Solved* other = witness(all)) {
    result.agreement = std::abs(other->solve.friction_ratio - exact.solve.friction_ratio);
    result.words += fmt::format("; {} {} differs by {}", other->solve.method, other->solve.setting,
                                rounded(*result.agreement, "", 2));
  } else {
    result.words += "; no other method answered";
  }
  return result;
}

std::string spent(const Solve& coarser) {
  return fmt::format("not tried: with {} it gave up", coarser.setting);
}

std::vector<Solved> solve_all(const std::vector<Setting>& settings, const System& system,
                              double velocity) {
  std::vector<Solved> all;
  for (const Setting& setting : settings) {
    const Solve* coarser = all.empty() ? nullptr : &all.back().solve;
    if (coarser != nullptr && coarser->method == setting.method && !coarser->answered) {
      Solve skipped = unsolved(setting);
      skipped.failure =
          coarser->failure.starts_with("not tried") ? coarser->failure : spent(*coarser);
      all.push_back({&setting, skipped});
    } else {
      all.push_back(solved(setting, system, velocity));
    }
  }
  return all;
}

}  // namespace

void judge(Solve& solve, const Setting& setting, bool sticks, const FrictionReference& reference) {
  if (!solve.answered) return;
  solve.error = std::abs(solve.friction_ratio - reference.friction_ratio);
  if (reference.sticks && !sticks && !setting.idealised)
    solve.failure = "misses the sticking phase: answers continuous sliding";
  else if (!(solve.error <= setting.allowed))
    solve.failure =
        fmt::format("wrong: off by {:.1e}, allowed {:.1e}", solve.error, setting.allowed);
}

void mark_front(std::vector<Solve>& solves) {
  std::vector<Solve*> ranked;
  std::vector<CostAndError> points;
  for (Solve& solve : solves)
    if (solve.failure.empty()) {
      ranked.push_back(&solve);
      points.push_back({solve.seconds, solve.error});
    }
  const std::vector<bool> front = on_front(points);
  for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i]->on_front = front[i];
}

std::vector<SpeedSolves> simulator_errors(const Problem& problem,
                                          const std::vector<double>& ratios) {
  const System system = simulation::system_of(problem);
  const double threshold = certified_critical_velocity(problem).value + creep_velocity(problem);
  if (!(threshold > 0) || !std::isfinite(threshold))
    throw ModelError("v* is infinite or 0: there is no speed to simulate at");
  const std::vector<Setting> settings = all_settings(system);
  std::vector<SpeedSolves> result;
  for (const double ratio : ratios) {
    std::vector<Solved> all = solve_all(settings, system, ratio * threshold);
    const auto reference = friction_reference(all, closed_form(problem, system, ratio));
    SpeedSolves speed;
    speed.ratio = ratio;
    if (reference) {
      speed.friction_ratio = reference->friction_ratio;
      speed.reference = reference->words;
      speed.agreement = reference->agreement;
      for (Solved& each : all) {
        judge(each.solve, *each.setting, each.sticks, *reference);
        // Its own reference: what is known of its error is how well the other one agrees.
        if (&each == &all.front() && reference->agreement) each.solve.error = *reference->agreement;
        speed.solves.push_back(each.solve);
      }
      mark_front(speed.solves);
    } else {
      speed.reference = "none: the exact method found no steady state";
      for (Solved& each : all) {
        if (each.solve.answered) each.solve.failure = "there is nothing to compare it with";
        speed.solves.push_back(each.solve);
      }
    }
    result.push_back(std::move(speed));
  }
  return result;
}

}  // namespace vcrit::validation::accuracy
