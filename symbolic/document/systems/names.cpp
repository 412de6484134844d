#include "document/systems/names.hpp"

#include <set>
#include <sstream>
#include <unordered_set>
#include <utility>
#include <vector>

#include "document/systems/system.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

/// Which names are still free.
class FreeNames {
 public:
  explicit FreeNames(const AlgebraSystem& system) : system_(system) {
    std::istringstream words{std::string(system.reserved)};
    for (std::string word; words >> word;) taken_.insert(word);
    taken_.emplace(system.result);
  }

  bool take(const std::string& name) {
    if (system_.has_meaning != nullptr && system_.has_meaning(name)) return false;
    return taken_.insert(name).second;
  }

 private:
  const AlgebraSystem& system_;
  std::unordered_set<std::string> taken_;
};

}  // namespace

SystemNames::SystemNames(const AlgebraSystem& system, const TakenFormula& formula) {
  std::vector<std::string> symbols;
  for (const TakenParameter& each : formula.parameters) symbols.push_back(each.symbol);
  for (const TakenDefinition& each : formula.definitions) symbols.push_back(each.symbol);
  FreeNames names(system);
  for (const std::string& symbol : symbols)
    if (const std::string name = printed_name(symbol);
        system.spelled(name) == name && names.take(name))
      names_[symbol] = name;
  for (const std::string& symbol : symbols) {
    if (names_.contains(symbol)) continue;
    const std::string spelled = system.spelled(printed_name(symbol));
    std::string name = spelled;
    for (int attempt = 1; !names.take(name); ++attempt) name = system.another(spelled, attempt);
    names_[symbol] = name;
  }
}

std::string with_index(const std::string& name) {
  std::string spelled = name;
  if (const std::size_t primes = name.find('\''); primes != std::string::npos)
    spelled = name.substr(0, primes) + (name.ends_with("''") ? "_loss" : "_storage");
  const std::size_t open = spelled.find('[');
  if (open == std::string::npos) return spelled;
  return spelled.substr(0, open) + "_" + spelled.substr(open + 1, spelled.size() - open - 2);
}

std::string with_underscore(const std::string& name, int attempt) {
  return name + "_" + (attempt == 1 ? "" : std::to_string(attempt));
}

}  // namespace vcrit::symbolic
