#include "emit/options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/errors.hpp"
#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "base/numbers.hpp"

namespace vcrit::symbolic {

namespace {

/// What the names of --fix stand for.
class Fixable {
 public:
  explicit Fixable(const Problem& problem) : problem_(problem) {
    for (const auto& [name, length] : problem->source->arrays)
      known_[as_called(problem, {name}).name];
    for (const auto& [symbol, value] : elements_with_values(problem)) {
      add({symbol, value});
      if (symbol.entry > 0) known_[as_called(problem, symbol).name].push_back({symbol, value});
    }
    if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential))
      add(isotropic->quantity);
    if (problem->mass) add(*problem->mass);
    if (problem->mount_mass) add(*problem->mount_mass);
  }

  FixedValues all() const {
    FixedValues fixed;
    for (const auto& [name, quantities] : known_)
      for (const Quantity& quantity : quantities)
        if (quantity.value) fixed[quantity.symbol] = *quantity.value;
    return fixed;
  }

  FixedValues named(const std::string& name) const {
    FixedValues fixed;
    const auto found = known_.find(name);
    if (found == known_.end()) {
      // What has the value 0 is in no network, and so in no code.
      if (!problem_->source->settable.contains(name) || is_always(name)) refuse(name);
      return fixed;
    }
    for (const Quantity& quantity : found->second) {
      if (!quantity.value)
        throw InputError(
            argument("fix"), fmt::format("\"{}\", which has no number in the scene", name),
            fmt::format("a number for it, as by `set {}=VALUE`", name_in(problem_, quantity)));
      fixed[quantity.symbol] = *quantity.value;
    }
    return fixed;
  }

 private:
  /// By all names that it has.
  void add(const Quantity& quantity) {
    known_[name_in(problem_, quantity)] = {quantity};
    for (const auto& [name, symbol] : problem_->source->named)
      if (symbol == quantity.symbol) known_[name] = {quantity};
  }

  /// Friction and oscillation.
  bool is_always(const std::string& name) const {
    const auto named = problem_->source->named.find(name);
    if (named == problem_->source->named.end()) return false;
    const Symbol& symbol = named->second;
    return symbol == frequency_symbol || symbol == problem_->coefficient.symbol ||
           symbol == problem_->angular_frequency.symbol || symbol == problem_->amplitude.symbol ||
           symbol == pressing(problem_).symbol;
  }

  [[noreturn]] void refuse(const std::string& name) const {
    std::vector<std::string> names{"all"};
    for (const auto& [known, quantities] : known_) names.push_back(known);
    const std::string one_of = fmt::format("one of {}", joined(names, ", "));
    if (is_always(name))
      throw InputError(argument("fix"),
                       fmt::format("\"{}\", which is a parameter of every call", name), one_of);
    const auto meant = nearest(name, names);
    throw InputError(argument("fix"), fmt::format("\"{}\", which this scene does not have", name),
                     meant ? fmt::format("\"{}\"", *meant) : one_of);
  }

  Problem problem_;
  std::map<std::string, std::vector<Quantity>> known_;
};

}  // namespace

FixedValues fixed_values(const Problem& problem, const std::vector<std::string>& names) {
  const Fixable fixable(problem);
  FixedValues fixed;
  for (const std::string& name : names)
    fixed.merge(name == "all" ? fixable.all() : fixable.named(name));
  return fixed;
}

std::string command_line(const Problem& problem, const std::string& name,
                         const GenerateOptions& options) {
  const std::string file = std::filesystem::path(problem->source->file).filename().string();
  std::string text = fmt::format("vcrit generate {} --out DIR --name {}", file, name);
  if (options.language != "c++") text += " --language " + options.language;
  if (!options.fixed.empty()) text += fmt::format(" --fix {}", joined(options.fixed, ","));
  if (options.quantities) text += " --quantities";
  return text;
}

std::string fixed_text(const Problem& problem, const FixedValues& fixed) {
  std::vector<std::string> texts;
  for (const auto& [symbol, value] : fixed)
    texts.push_back(fmt::format("{} = {}", to_text(as_called(problem, symbol)), to_text(value)));
  return texts.empty() ? "" : fmt::format("Fixed: {}.", joined(texts, ", "));
}

}  // namespace vcrit::symbolic
