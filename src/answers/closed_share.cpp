#include "answers/closed_share.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "network/graph.hpp"
#include "problem/variants.hpp"
#include "problem/variation.hpp"

namespace vcrit {

namespace {

// No element of a scene has this name.
const Symbol unit_spring{"1", 0};

// v* = |K_n| omega
Problem rigidly_driven(const Problem& problem, const ReducedNetwork& normal) {
  return over_spring(problem, normal, unit_spring)
      .with({{problem->coefficient.symbol, 1},
             {problem->amplitude.symbol, 1},
             {pressing(problem).symbol, 1}});
}

}  // namespace

ClosedShare::Modulus ClosedShare::modulus(const Problem& problem, const ReducedNetwork& normal,
                                          const std::vector<std::string>& varying) {
  const std::vector<Symbol> symbols = symbols_of(normal.network());
  std::vector<std::string> names;
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < varying.size(); ++i) {
    const Symbol symbol = target_of(problem, varying[i]).symbol;
    const bool moves = std::find(symbols.begin(), symbols.end(), symbol) != symbols.end() ||
                       symbol == problem->angular_frequency.symbol;
    if (!moves) continue;
    names.push_back(varying[i]);
    columns.push_back(i);
  }
  return {CriticalVelocities(rigidly_driven(problem, normal), std::move(names)),
          std::move(columns)};
}

void ClosedShare::Modulus::operator()(std::span<const std::span<const double>> all,
                                      std::span<double> out) const {
  std::vector<std::span<const double>> chosen;
  for (const std::size_t column : columns) {
    if (column >= all.size())
      throw InputError({"columns"}, fmt::format("{} of them", all.size()),
                       "one for each varying parameter");
    chosen.push_back(all[column]);
  }
  velocities(chosen, out);
}

ClosedShare::ClosedShare(const Problem& problem, const std::vector<std::string>& varying)
    : oscillating_(modulus(problem, problem->normal, varying)) {
  const auto springs =
      problem->load ? spring(unit_spring) : springs_alone(problem->normal.network());
  if (springs) at_rest_ = modulus(problem, ReducedNetwork(*springs), varying);
}

void ClosedShare::operator()(std::span<const std::span<const double>> columns,
                             std::span<double> out) const {
  std::fill(out.begin(), out.end(), 0.0);
  if (!at_rest_) return;
  std::vector<double> oscillating(out.size());
  oscillating_(columns, oscillating);
  (*at_rest_)(columns, out);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] /= oscillating[i];
}

}  // namespace vcrit
