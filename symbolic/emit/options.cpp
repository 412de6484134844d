#include "emit/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "base/errors.hpp"
#include "base/identifiers.hpp"
#include "base/numbers.hpp"

namespace vcrit::symbolic {

namespace {

/// What the names of --fix stand for.
class Fixable {
 public:
  explicit Fixable(const Scene& scene) : scene_(scene) {
    for (const auto& [name, length] : scene.arrays) known_[as_called(scene, {name}).name];
    for (const auto& [symbol, value] : scene.elements) {
      add({symbol, value});
      if (symbol.entry > 0) known_[as_called(scene, symbol).name].push_back({symbol, value});
    }
    if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential)) add(isotropic->quantity);
    if (scene.mass) add(*scene.mass);
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
      if (!scene_.settable.contains(name) || is_always(name)) refuse(name);
      return fixed;
    }
    for (const Quantity& quantity : found->second) {
      if (!quantity.value)
        throw InputError(
            argument("fix"), fmt::format("\"{}\", which has no number in the scene", name),
            fmt::format("a number for it, as by --set {}=VALUE", name_in(scene_, quantity)));
      fixed[quantity.symbol] = *quantity.value;
    }
    return fixed;
  }

 private:
  /// By all names that it has.
  void add(const Quantity& quantity) {
    known_[name_in(scene_, quantity)] = {quantity};
    for (const auto& [name, symbol] : scene_.named)
      if (symbol == quantity.symbol) known_[name] = {quantity};
  }

  /// Friction and oscillation.
  bool is_always(const std::string& name) const {
    const auto named = scene_.named.find(name);
    if (named == scene_.named.end()) return false;
    const Symbol& symbol = named->second;
    return symbol == frequency_symbol || symbol == scene_.coefficient.symbol ||
           symbol == scene_.angular_frequency.symbol || symbol == scene_.amplitude.symbol ||
           symbol == scene_.indentation.symbol;
  }

  [[noreturn]] void refuse(const std::string& name) const {
    std::vector<std::string> names{"all"};
    for (const auto& [known, quantities] : known_) names.push_back(known);
    const std::string one_of = fmt::format("one of {}", fmt::join(names, ", "));
    if (is_always(name))
      throw InputError(argument("fix"),
                       fmt::format("\"{}\", which is a parameter of every call", name), one_of);
    const auto meant = nearest(name, names);
    throw InputError(argument("fix"), fmt::format("\"{}\", which this scene does not have", name),
                     meant ? fmt::format("\"{}\"", *meant) : one_of);
  }

  const Scene& scene_;
  std::map<std::string, std::vector<Quantity>> known_;
};

}  // namespace

FixedValues fixed_values(const Scene& scene, const std::vector<std::string>& names) {
  const Fixable fixable(scene);
  FixedValues fixed;
  for (const std::string& name : names)
    fixed.merge(name == "all" ? fixable.all() : fixable.named(name));
  return fixed;
}

std::string command_line(const Scene& scene, const std::string& name,
                         const GenerateOptions& options) {
  const std::string file = std::filesystem::path(scene.file).filename().string();
  std::string text = fmt::format("vcrit generate {} --out DIR --name {}", file, name);
  if (options.language != "c++") text += " --language " + options.language;
  if (!options.fixed.empty()) text += fmt::format(" --fix {}", fmt::join(options.fixed, ","));
  if (options.quantities) text += " --quantities";
  return text;
}

std::string fixed_text(const Scene& scene, const FixedValues& fixed) {
  std::vector<std::string> texts;
  for (const auto& [symbol, value] : fixed)
    texts.push_back(fmt::format("{} = {}", to_text(as_called(scene, symbol)), to_text(value)));
  return texts.empty() ? "" : fmt::format("Fixed: {}.", fmt::join(texts, ", "));
}

}  // namespace vcrit::symbolic
