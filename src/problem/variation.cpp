#include "problem/variation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/numbers.hpp"
#include "scene/settings.hpp"

namespace vcrit {

namespace {

// Whether the network stays as it is, and the number is one that the scene may have.
bool fits(const Variation::Target& target, double value) {
  if (target.is_left_out) return false;
  if (target.is_poisson) return value > -1 && value <= 0.5;
  return value > 0 && std::isfinite(target.factor * value);
}

}  // namespace

Variation::Variation(Problem problem, std::vector<std::string> names)
    : problem_(std::move(problem)),
      names_(std::move(names)),
      settings_(problem_->source->settings) {
  const Source& source = *problem_->source;
  std::map<Symbol, std::string> seen;
  for (const std::string& name : names_) {
    refuse_expression(source, name, OverridingValues::place(name));
    known_dimension(name, source.settable, OverridingValues::place(name), source.named);
    targets_.push_back(target(name));
    changes_[symbol_of(targets_.back())] = 0;
    const auto [other, is_new] = seen.emplace(targets_.back().symbol, name);
    if (!is_new)
      throw InputError(OverridingValues::place(name),
                       fmt::format("{} as well as {}", name, other->second), "one of the two");
    std::erase_if(settings_, [&](const auto& setting) {
      return target(setting.first).symbol == targets_.back().symbol;
    });
  }
}

const Symbol& Variation::symbol_of(const Target& target) {
  return target.factor == 1 ? target.symbol : frequency_symbol;
}

Variation::Target Variation::target(const std::string& name) const {
  // A scene that was not read from a text has no list of names.
  const auto& listed = problem_->source->named;
  const auto named = listed.find(name);
  const Symbol symbol = named == listed.end() ? Symbol{name} : named->second;
  if (symbol == frequency_symbol) return {problem_->angular_frequency.symbol, two_pi};
  if (const auto* isotropic = std::get_if<Isotropic>(&problem_->tangential))
    if (isotropic->quantity.symbol == symbol)
      return {symbol, 1, isotropic->by == Isotropic::By::poisson};
  for (const Quantity& quantity : quantities(problem_))
    if (quantity.symbol == symbol) return {symbol};
  for (const Symbol& element : *problem_->elements)
    if (element == symbol || to_text(element) == symbol.name) return {element};
  return {symbol, 1, false, true};
}

bool Variation::fit(std::span<const double> values) const {
  if (values.size() != targets_.size())
    throw InputError(argument("values"), fmt::format("{} values", values.size()),
                     fmt::format("{}, one for each name", targets_.size()));
  return std::ranges::equal(targets_, values, fits);
}

void Variation::refuse(std::span<const double> values) const {
  // An expression of several numbers may leave the doubles.
  if (!fit(values) || !problem_->expressions.empty()) at(values);
}

Problem Variation::at(std::span<const double> values) const {
  if (fit(values)) {
    Values changed = changes_;
    for (std::size_t i = 0; i < values.size(); ++i) changed[symbol_of(targets_[i])] = values[i];
    return problem_.with(changed);
  }
  Settings settings = settings_;
  for (std::size_t i = 0; i < values.size(); ++i)
    settings.emplace_back(names_[i], to_text(values[i]));
  return parse_problem(problem_->source->text, problem_->source->file, settings);
}

Variation::Target target_of(const Problem& problem, const std::string& name) {
  return Variation(problem, {name}).targets().front();
}

}  // namespace vcrit
