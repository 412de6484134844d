#include "design/range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "critical/admissibility.hpp"
#include "design/places.hpp"
#include "design/rows_below_indenter.hpp"
#include "normal/mount.hpp"
#include "problem/variants.hpp"
#include "rules/kinds.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::design {

namespace {

// Down to the largest speed over this they are tried evenly, below by even ratios.
constexpr double even_down_to = 20;

// An end that nobody gave is the search's own.
void refuse_empty(const DesignQuestion& question, double from, double to) {
  if (from < to && std::isfinite(to)) return;
  require_si_doubles(question.from || question.to);
  const auto [low, high] = rounded_apart(from, to, unit_of(question.sought));
  if (!question.to)
    throw InputError(argument("from"), low, "a number below " + high + ", where the search ends");
  if (!question.from || from != *question.from)
    throw InputError(argument("to"), high, "a number above " + low + ", where the search begins");
  throw InputError(argument("from, to"), fmt::format("from {} to {}", low, high),
                   "a finite upper end above the lower end");
}

// v* grows in proportion to the amplitude, the creep does not: below some amplitude friction is
// full.
SearchRange amplitudes(const DesignQuestion& question, const NormalContact& contact) {
  const Problem problem = with_amplitude(question.problem, 1);
  const double omega = problem.value(problem->angular_frequency);
  const double most = contact.largest_amplitude(omega);
  SearchRange range{question.from.value_or(0),
                    std::min(question.to.value_or(most), inside_the_bound * most),
                    {},
                    0,
                    0};
  refuse_empty(question, range.from, range.to);
  require_si_doubles(slowest * range.to > 0);
  range.largest_velocity = reduced_up_to(with_amplitude(problem, range.to));
  range.largest_at = range.to;
  if (finds_each_onset(problem)) {
    add_amplitude_rows(question, range);
    return range;
  }
  const Problem closed = staying_closed(problem);  // as it is at all amplitudes of the range
  const double first = std::max(
      range.from, (question.velocity - creep_velocity(problem)) / quick_onset(closed, omega));
  if (!(question.velocity < range.largest_velocity) || !(first < range.to)) return range;
  if (first > 0)
    range.rows.push_back(even(first, range.to, samples_of(question)));
  else
    range.rows.push_back(even_ratios(slowest * range.to, range.to, samples_of(question)));
  return range;
}

// Each stretch gets its part of the samples by its width, and enough to show its shape.
SearchRange frequencies(const DesignQuestion& question, const NormalContact& contact) {
  const auto omega = question.problem->angular_frequency.value;
  if (!omega && !(question.from && question.to))
    throw InputError(argument("for frequency"), "a scene without a frequency",
                     "`from` and `to`, the range to search");
  const double amplitude = *question.problem->amplitude.value;
  const bool bounded = contact.closes_up_to_a_frequency();
  const auto most = bounded ? contact.largest_angular_frequency(amplitude) : std::nullopt;
  SearchRange range{question.from ? *question.from : *omega / two_pi / 100,
                    question.to ? *question.to : *omega / two_pi * 100,
                    {},
                    0,
                    0};
  refuse_empty(question, range.from, range.to);
  if (!std::isfinite(range.to / range.from))
    throw InputError(
        argument("from, to"),
        fmt::format("from {} to {}", rounded(range.from, "Hz"), rounded(range.to, "Hz")),
        "ends whose ratio is within the range of doubles");
  require_si_doubles(std::isfinite(two_pi * range.to));
  if (most && range.from >= *most / two_pi)
    throw ModelError(
        fmt::format("the contact opens at all frequencies from {} on, and the range begins at {}",
                    rounded(*most / two_pi, "Hz"), rounded(range.from, "Hz")));
  if (most) range.to = std::min(range.to, inside_the_bound * *most / two_pi);
  refuse_empty(question, range.from, range.to);
  if (finds_each_onset(question.problem)) {
    add_frequency_rows(question, range);
    return range;
  }
  OpeningShare share;
  if (!bounded)
    share = [&contact, amplitude](double at) {
      return contact.oscillating_part(amplitude, at) / inside_the_bound;
    };
  const Stretches found =
      reducing_stretches(with_angular_frequency(question.problem, two_pi * range.from),
                         two_pi * range.from, two_pi * range.to, question.velocity, share);
  if (!found.closed)
    throw ModelError(fmt::format("the contact opens at all frequencies from {} to {}",
                                 rounded(range.from, "Hz"), rounded(range.to, "Hz")),
                     "take a smaller amplitude, or another range: `from`, `to`");
  range.largest_velocity = found.largest_velocity;
  range.largest_at = found.largest_at / two_pi;
  for (const FrequencyRange& part : found.parts) {
    if (!(part.from < part.to)) continue;
    const double width = std::log(part.to / part.from) / std::log(range.to / range.from);
    const int samples = std::max(32, static_cast<int>(std::ceil(width * samples_of(question))));
    // 2 pi f / 2 pi is not f to the last bit either.
    const auto in_hertz = [](double at, double end) {
      return at == two_pi * end ? end : at / two_pi;
    };
    range.rows.push_back(
        even_ratios(in_hertz(part.from, range.from), in_hertz(part.to, range.to), samples));
  }
  return range;
}

// What the contact point's velocity oscillates by as long as body and drive are out of resonance.
// At one v* grows without end, while friction rises where it would without. Infinite if a product
// leaves the range of doubles.
double usual_speed(const Problem& problem) {
  const Values& values = problem.values();
  const double omega = values.at(problem->angular_frequency.symbol);
  const auto size = [&](const ReducedNetwork& network) {
    return std::abs(dynamic_stiffness(network.reduction(), values, omega));
  };
  const ScaledNetwork tangential = tangential_network(problem);
  double compliance = 1 / (tangential.factor * size(tangential.network));
  const double mass = problem->mass ? values.at(problem->mass->symbol) : 0;
  if (const ReducedNetwork* drive = problem->drive_network())
    compliance += 1 / (size(*drive) + mass * omega * omega);
  const double force =
      values.at(problem->coefficient.symbol) * contact_amplitude(problem) * size(problem->normal);
  const double speed = force * omega * compliance;
  return speed > 0 ? speed : infinity;
}

// From `to` down to `end`.
std::vector<double> falling_speeds(double to, double end, int samples) {
  const double joint = std::max(end, to / even_down_to);
  std::vector<double> row = even(to, joint, samples);
  if (!(joint > end)) return row;
  const double spans = std::log(joint / end) / -std::log(even_down_to * slowest);
  const int slow_samples = static_cast<int>(std::ceil(samples / 2 * std::max(1.0, spans)));
  const std::vector<double> slow = even_ratios(joint, end, slow_samples + 2);
  row.insert(row.end(), slow.begin() + 1, slow.end());
  return row;
}

// As the speed vanishes the ratio tends to 1 - least/W, below which it does not fall: a load above
// least/(1 - ratio) does not reach it but for a body that rings, for which there is some room.
constexpr double room_for_ringing = 2;

double most_force(const DesignQuestion& question, double least) {
  if (rules::cells_move(question.problem)) return largest_force(question, least);
  return room_for_ringing * least / (1 - question.friction_ratio);
}

// Downwards, as friction rises with the load.
SearchRange forces(const DesignQuestion& question, const NormalContact& contact) {
  const Problem problem = with_load(question.problem, 1);
  const Values& values = problem.values();
  const double least = contact.least_force(values.at(question.problem->amplitude.symbol),
                                           values.at(question.problem->angular_frequency.symbol));
  SearchRange range{std::max(question.from.value_or(0), least / inside_the_bound),
                    question.to ? *question.to : most_force(question, least),
                    {},
                    0,
                    0};
  require_si_doubles(range.from > 0);
  refuse_empty(question, range.from, range.to);
  const Problem last = with_load(question.problem, range.to);
  if (!question.to && creep_velocity(last) > 0)
    throw ModelError(
        "the path creeps: under a load that is large enough it does so at any speed without a "
        "slip, and friction falls towards 0, so that the search has no upper end: give one with "
        "`to`");
  range.largest_velocity = reduced_up_to(last);
  range.largest_at = range.to;
  if (question.velocity < range.largest_velocity || finds_each_onset(question.problem))
    range.rows.push_back(even_ratios(range.to, range.from, samples_of(question)));
  return range;
}

// From the fastest on, which is worth most: finely where friction begins to fall, then by even
// ratios. Above the limit it is full.
SearchRange velocities(const DesignQuestion& question) {
  const double limit = reduced_up_to(question.problem);
  SearchRange range{
      question.from.value_or(0), std::min(question.to.value_or(limit), limit), {}, 0, 0};
  if (std::isinf(range.to))
    throw ModelError(
        "v* is infinite here, so that the search has no upper end: give one with `to`");
  if (!(range.to > 0))
    throw ModelError(
        "v* is 0 here: at an antiresonance the oscillation reduces friction at no speed");
  range.largest_velocity = range.largest_at = limit;
  if (range.from < limit) refuse_empty(question, range.from, range.to);
  if (!(range.from < range.to)) return range;
  // A lower end so small that it is 0 would be no end.
  require_si_doubles(slowest * range.to > 0);
  if (rules::cells_move(question.problem)) {
    range.from = std::max(range.from, slowest * range.to);
    add_velocity_rows(question, range);
    return range;
  }
  range.from = std::max(range.from, slowest * std::min(range.to, usual_speed(question.problem)));
  require_si_doubles(range.from > 0 && std::isfinite(range.to / range.from));
  range.rows.push_back(falling_speeds(range.to, range.from, samples_of(question)));
  return range;
}

}  // namespace

SearchRange range_of(const DesignQuestion& question, const NormalContact& contact) {
  switch (question.sought) {
    case Sought::amplitude:
      return amplitudes(question, contact);
    case Sought::frequency:
      return frequencies(question, contact);
    case Sought::velocity:
      return velocities(question);
    case Sought::force:
      return forces(question, contact);
  }
  throw Bug("something sought without a range");
}

}  // namespace vcrit::design
