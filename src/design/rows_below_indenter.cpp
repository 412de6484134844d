#include "design/rows_below_indenter.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "critical/admissibility.hpp"
#include "design/places.hpp"
#include "indenter/friction.hpp"
#include "indenter/half_space.hpp"
#include "rules/kinds.hpp"

namespace vcrit::design {

namespace {

// Where the range begins at no amplitude: the first that is asked for, over the last.
constexpr double smallest_amplitude = 1e-6;

// A body that rings can take friction below its limit at rest.
constexpr double room_below_rest = 2;

constexpr int most_doublings = 60;

// 1 less the friction ratio at rest is the mean of F_n less its least, over the mean. A cell that
// stays closed has du_z |E*| for that, one that opens has its mean, which is less.
double most_reduction(const Problem& problem) {
  const indenter::HalfSpace half_space(problem);
  return 2 * half_space.edge() * half_space.amplitude() * half_space.dynamic_modulus() /
         problem.value(*problem->load);
}

}  // namespace

bool finds_each_onset(const Problem& problem) { return rules::cells_move_one_another(problem); }

void add_amplitude_rows(const DesignQuestion& question, SearchRange& range) {
  const double first = range.from > 0 ? range.from : smallest_amplitude * range.to;
  range.rows.push_back(even(first, range.to, samples_of(question)));
}

void add_frequency_rows(const DesignQuestion& question, SearchRange& range) {
  const double decades = std::max(1.0, std::log10(range.to / range.from));
  const int samples = static_cast<int>(std::ceil(decades * samples_of(question)));
  range.rows.push_back(even_ratios(range.from, range.to, samples));
}

// Friction never falls with the speed: decades down to where it is low enough, and one search
// between two of them. On a compliant drive slow states take long. One that creeps carries ever
// less.
void add_velocity_rows(const DesignQuestion& question, SearchRange& range) {
  range.monotonic = true;
  const indenter::HalfSpace half_space(question.problem);
  const auto& holder = half_space.holder();
  if (!holder || !(holder->rings() || creep_velocity(question.problem) > 0)) {
    const indenter::Pressed pressed = indenter::pressed(question.problem);
    range.at_rest = pressed.least / pressed.mean;
    if (question.friction_ratio < *range.at_rest) return;
  }
  std::vector<double> places;
  for (double place = range.to; place > range.from; place /= 10) places.push_back(place);
  places.push_back(range.from);
  range.rows.push_back(std::move(places));
}

double largest_force(const DesignQuestion& question, double least) {
  const double wanted = (1 - question.friction_ratio) / room_below_rest;
  double force = least;
  try {
    for (int i = 0; i < most_doublings; ++i) {
      if (most_reduction(with_load(question.problem, 2 * force)) < wanted) return 2 * force;
      force *= 2;
    }
  } catch (const ModelError&) {
    if (!(force > least)) throw;  // else the tip ends before it carries more
  }
  return force;
}

}  // namespace vcrit::design
