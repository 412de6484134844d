#include "formula/names.hpp"

#include <algorithm>
#include <vector>

#include "formula/form.hpp"
#include "formula/notation.hpp"

namespace vcrit::symbolic {

namespace {

constexpr char own_mark = '\x1f';

thread_local const NamesOfScene* printing = nullptr;

/// What a reader sees of a name: its parts without the underscores between them.
std::string setting_of(const std::string& name) {
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

NamesOfScene::NamesOfScene(const Scene& scene) : before_(printing) {
  std::vector<std::string> names;
  for (const auto& [symbol, value] : scene.elements) names.push_back(symbol.name);
  for (const Quantity* quantity : quantities(scene)) names.push_back(quantity->symbol.name);
  std::sort(names.begin(), names.end(), natural_less);
  for (const std::string& name : names) by_setting_.try_emplace(setting_of(name), name);
  printing = this;
}

NamesOfScene::~NamesOfScene() { printing = before_; }

// The imaginary unit has a second name of its own.
std::string printed_name(const std::string& name) {
  if (!is_own(name)) return name;
  const std::string base = base_name(name);
  const std::size_t entry = std::min(base.find('['), base.size());  // of an array's groups
  std::string printed = base.substr(0, entry);
  const auto taken = [](const std::string& candidate) {
    return printing != nullptr && printing->by_setting_.contains(setting_of(candidate));
  };
  if (taken(printed)) printed = printed == "i" ? "j" : printed + "_own";
  while (taken(printed)) printed += "_own";
  return printed + base.substr(entry);
}

bool is_set_apart(const std::string& name) {
  if (printing == nullptr || is_own(name)) return false;
  const std::string scalar = name.substr(0, name.find('['));
  const auto first = printing->by_setting_.find(setting_of(scalar));
  return first != printing->by_setting_.end() && first->second != scalar;
}

}  // namespace vcrit::symbolic
