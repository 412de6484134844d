#include "formula/names.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "formula/form.hpp"
#include "formula/notation.hpp"

namespace vcrit::symbolic {

namespace {

constexpr char own_mark = '\x1f';

// Of symbols of the program that are named after one of the scene.
constexpr std::array group_prefixes{"S_", "kappa_", "theta_", "beta_"};

thread_local const NamesOfScene* printing = nullptr;

/// What a reader sees of a name: its parts without the underscores between them.
std::string setting_of(const std::string& name) {
  if (is_sensitivity(name)) return "S " + setting_of(name.substr(2));
  const Notation n = notation(name);
  std::string setting = n.before + " " + n.base + n.above;
  for (const std::string& part : n.index) setting += "," + part;
  return setting;
}

}  // namespace

std::string own_name(const std::string& base) { return base + own_mark; }
bool is_own(const std::string& name) { return name.ends_with(own_mark); }
std::string base_name(const std::string& name) {
  return is_own(name) ? name.substr(0, name.size() - 1) : name;
}

NamesOfScene::NamesOfScene(const Problem& problem) : names_(problem->names), before_(printing) {
  std::vector<std::string> names;
  for (const Symbol& symbol : *problem->elements) {
    const Symbol called = as_called(problem, symbol);
    names.push_back(called.name);
    if (called.entry > 0) entries_.insert(setting_of(to_text(called)));
  }
  for (const Quantity& quantity : quantities(problem)) names.push_back(name_in(problem, quantity));
  if (const auto f = names_.find(frequency_symbol.name); f != names_.end())
    names.push_back(f->second);
  std::sort(names.begin(), names.end(), natural_less);
  for (const std::string& name : names) {
    by_setting_.try_emplace(setting_of(name), name);
    for (const char* prefix : group_prefixes)
      groups_by_setting_.try_emplace(setting_of(prefix + name), prefix + name);
  }
  for (const Symbol& symbol : *problem->elements) {
    const Symbol called = as_called(problem, symbol);
    if (called.entry > 0 && by_setting_.contains(setting_of(to_text(called))))
      ambiguous_.insert(called.name);
  }
  printing = this;
}

NamesOfScene::~NamesOfScene() { printing = before_; }

// "k[3]" by what "k" is called; kappa_k[3] of the program by what k is called that it is named
// after.
std::string NamesOfScene::written(const std::string& name) const {
  for (const char* prefix : group_prefixes)
    if (is_own(name) && name.starts_with(prefix))
      return prefix + with_entry(base_name(name).substr(std::strlen(prefix)));
  return is_own(name) ? base_name(name) : with_entry(name);
}

std::string NamesOfScene::with_entry(const std::string& name) const {
  const std::size_t entry = std::min(name.find('['), name.size());
  const auto found = names_.find(name.substr(0, entry));
  return found == names_.end() ? name : found->second + name.substr(entry);
}

bool NamesOfScene::taken(const std::string& name) const {
  const std::string setting = setting_of(name);
  return by_setting_.contains(setting) || entries_.contains(setting);
}

// The imaginary unit has a second name of its own; a derivative (x'') is called after its function.
std::string NamesOfScene::printed(const std::string& name) const {
  const std::string base = written(name);
  if (!is_own(name)) return base;
  const std::size_t entry =
      std::min(base.find_first_of("['"), base.size());  // of an array's groups
  std::string printed = base.substr(0, entry);
  if (taken(printed)) printed = printed == "i" ? "j" : printed + "_own";
  while (taken(printed)) printed += "_own";
  return printed + base.substr(entry);
}

std::string printed_name(const std::string& name) {
  if (printing == nullptr) return base_name(name);
  const auto [known, is_new] = printing->printed_.try_emplace(name);
  if (is_new) known->second = printing->printed(name);
  return known->second;
}

bool is_set_apart(const std::string& name) {
  if (printing == nullptr || is_own(name)) return false;
  const std::string scalar = name.substr(0, name.find('['));
  const std::string setting = setting_of(scalar);
  const auto first = printing->by_setting_.find(setting);
  if (first != printing->by_setting_.end()) return first->second != scalar;
  const auto group = printing->groups_by_setting_.find(setting);
  return group != printing->groups_by_setting_.end() && group->second != scalar;
}

bool has_bare_entry(const std::string& name) {
  if (printing == nullptr) return true;
  std::string array = name.substr(0, name.find('['));
  for (const char* prefix : group_prefixes)  // kappa_k[1] is set as k[1] is
    if (array.starts_with(prefix)) array.erase(0, std::strlen(prefix));
  return !printing->ambiguous_.contains(array);
}

bool is_taken(const std::string& name) { return printing != nullptr && printing->taken(name); }

}  // namespace vcrit::symbolic
