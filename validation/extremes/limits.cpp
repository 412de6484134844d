#include "extremes/limits.hpp"

#include <fmt/core.h>

#include <cmath>
#include <complex>

#include "analysis/limits.hpp"
#include "compare/evaluators.hpp"
#include "critical/certified.hpp"
#include "extremes/comparing.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation::extremes {

namespace {

// Both sides are rounded once, and the tolerance is computed in doubles.
constexpr double limit_roundings = 4 * 0x1p-53;
constexpr long limit_digits = 120;

std::string name_of(const Approach& approach) {
  return to_text(approach.what) + (approach.to == Approach::To::zero ? " -> 0" : " -> infinity");
}

std::complex<double> contact_of(const Problem& problem, const Values& values, double omega) {
  const auto [network, factor] = tangential_network(problem);
  return factor * dynamic_stiffness(network.reduction(), values, omega);
}

/// The remaining scene's values at the cell, where it has them.
Problem remaining(const Approach& approach, const Problem& problem, const Values& values) {
  const Problem rest = parse_problem(approach.text, "the limit");
  return rest.with({{rest->angular_frequency.symbol, values.at(problem->angular_frequency.symbol)},
                    {rest->amplitude.symbol, values.at(problem->amplitude.symbol)}});
}

const symbolic::Limit& limit_of(const std::vector<symbolic::Limit>& limits,
                                const Approach& approach) {
  for (const symbolic::Limit& limit : limits)
    if (limit.name == name_of(approach)) return limit;
  throw Bug("an approach is none of the scene's limits");
}

}  // namespace

// With x = m omega^2, D = K_d, N = K_t + K_d: | |N - x|/|N| - 1 | <= x/|N|, and |D|/|D - x| - 1 is
// at most 2 x/|D| while x <= |D|/2. With a drive of k_d: |K_t + D|/|D| is 1 within |K_t|/|D|. A
// damper c beside a spring, or behind one (whose branch is weaker than its damper), changes K_t by
// at most i omega c; beside the only spring, |N| by the root of 1 + (omega c/N)^2. A damper that
// grows behind a spring k leaves k^2/(omega c) at most of its give.
double distance_allowed(const Problem& problem, const Approach& approach, const Values& values) {
  const double omega = values.at(problem->angular_frequency.symbol),
               value = values.at(approach.what);
  const double inertia = problem->mass ? values.at(problem->mass->symbol) * omega * omega : 0;
  const std::complex<double> drive =
      dynamic_stiffness(problem->drive_network()->reduction(), values, omega);
  const double factor = tangential_network(problem).factor;
  if (problem->mass && approach.what == problem->mass->symbol) {
    const std::complex<double> contact = contact_of(problem, values, omega);
    return limit_roundings + 2 * inertia * (1 / std::abs(contact + drive) + 1 / std::abs(drive));
  }
  if (approach.what.name == "kd")
    return limit_roundings +
           std::abs(contact_of(problem, values, omega)) / std::abs(drive - inertia);
  const std::complex<double> contact = contact_of(problem, values, omega);
  const double left = std::abs(contact.real() + drive - inertia);
  const double loss = factor * omega * value;
  if (approach.what.name == "c") return limit_roundings + loss / left * (loss / left) / 2;
  if (approach.to == Approach::To::zero) return limit_roundings + loss / left;
  const double k = values.at({"k1"});
  return limit_roundings + factor * k / (omega * value / k) / left;
}

std::vector<Comparison> compare_limits(const Family& family, const symbolic::Derivation& derivation,
                                       const CellsOf& made, const std::vector<double>& found,
                                       const std::string& what) {
  const Problem& problem = derivation.problem;
  const std::vector<symbolic::Limit> limits = symbolic::limits(derivation);
  std::vector<Comparison> result;
  for (std::size_t k = 0; k < family.approaches.size(); ++k) {
    const Approach& approach = family.approaches[k];
    const symbolic::Limit& limit = limit_of(limits, approach);
    const Words of_rest{"limit_derived",
                        fmt::format("{}: derived limit {}", family.title, limit.name),
                        "v* of what remains, correctly rounded", "both are rounded once"};
    const Words words{"limit", fmt::format("{}: {} as {}", family.title, what, limit.name),
                      "the derived limit", "how fast Eq. 24 approaches it"};
    std::vector<Comparison> rests, points;
    for (std::size_t i = 0; i < made.approach.size(); ++i) {
      if (made.approach[i] != k) continue;
      const Values& values = made.cells.values[i];
      const double there = value_in_digits(limit.result, limit.definitions, values, limit_digits);
      const double rest = certified_critical_velocity(remaining(approach, problem, values)).value;
      rests.push_back(relative(of_rest, rest, there, limit_roundings, {}));
      points.push_back(relative(words, there, found[i], distance_allowed(problem, approach, values),
                                fmt::format("at {:g}", values.at(approach.what))));
    }
    result.push_back(worst(of_rest, rests));
    result.push_back(worst(words, points));
  }
  return result;
}

}  // namespace vcrit::validation::extremes
