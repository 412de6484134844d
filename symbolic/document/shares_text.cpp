#include "document/shares_text.hpp"

#include <fmt/core.h>

#include <vector>

#include "answers/shares.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"

namespace vcrit::symbolic {

namespace {

/// The numbers that v* may depend on. Two networks that are equal have a ratio of 1, which no scene
/// has as a number.
std::vector<Symbol> numbers_of(const Problem& problem) {
  const auto& known = problem->source->settable;
  std::vector<Symbol> symbols;
  for (const Quantity& quantity : quantities(problem))
    if (quantity.value && known.contains(to_text(as_called(problem, quantity.symbol))))
      symbols.push_back(quantity.symbol);
  for (const Symbol& symbol : *problem->elements) symbols.push_back(symbol);
  return symbols;
}

}  // namespace

std::string shares_text(const Problem& problem) {
  std::vector<Share> shares;
  try {
    problem.values();
    shares = shares_of(problem, numbers_of(problem));
  } catch (const InputError&) {
    return {};  // letters have formulas alone
  }
  if (shares.empty()) return {};
  std::string text =
      "\nSensitivities of this scene, per cent in v* for one per cent in the parameter:\n";
  for (const Share& share : shares)
    text +=
        fmt::format("    {:<7} {}\n", to_text(share.called), rounded(share.share, "", few_digits));
  return text;
}

}  // namespace vcrit::symbolic
