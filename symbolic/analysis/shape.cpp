#include "analysis/shape.hpp"

#include <functional>
#include <map>
#include <numeric>
#include <type_traits>

#include "formula/symbols.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic {

namespace {

/// Which element of the second network stands where one of the first does.
class Pairing {
 public:
  bool match(const Network& a, const Network& b) {
    if (a.form.index() != b.form.index()) return false;
    return std::visit(
        [&](const auto& form) {
          return match_forms(form, std::get<std::decay_t<decltype(form)>>(b.form));
        },
        a.form);
  }

  std::optional<GiNaC::ex> ratio() const {
    const std::pair<Symbol, Symbol>* best = nullptr;
    for (const auto& [role, pair] : coefficients_)
      if (best == nullptr || (best_is_damper(*best) && role != NumberRole::damping)) best = &pair;
    if (best == nullptr) return std::nullopt;
    return symbol(best->second) / symbol(best->first);
  }

 private:
  bool best_is_damper(const std::pair<Symbol, Symbol>& pair) const {
    for (const auto& [role, known] : coefficients_)
      if (known == pair) return role == NumberRole::damping;
    return false;
  }

  bool bind(const Symbol& a, const Symbol& b) {
    const auto [forth, is_new_a] = forth_.try_emplace(a, b);
    const auto [back, is_new_b] = back_.try_emplace(b, a);
    return forth->second == b && back->second == a;
  }

  bool match_forms(const Element& a, const Element& b) {
    if (a.kind != b.kind || !is_plain(a) || !is_plain(b)) return false;
    if (follows_table(a)) return false;  // whether one is a multiple of the other is in the tables
    std::vector<Symbol> others;
    for_each_number(b, [&](const Symbol& symbol, NumberRole) { others.push_back(symbol); });
    auto other = others.begin();
    bool match = true;
    for_each_number(a, [&](const Symbol& symbol, NumberRole role) {
      match = bind(symbol, *other) && match;
      if (role != NumberRole::time) coefficients_.push_back({role, {symbol, *other}});
      ++other;
    });
    return match;
  }
  bool match_forms(const Series& a, const Series& b) { return match_parts(a.parts, b.parts); }
  bool match_forms(const Parallel& a, const Parallel& b) { return match_parts(a.parts, b.parts); }
  bool match_forms(const Graph& a, const Graph& b) {
    if (a.wires != b.wires || a.parts.size() != b.parts.size()) return false;
    for (std::size_t i = 0; i < a.parts.size(); ++i)
      if (!match(a.parts[i], b.parts[i])) return false;
    return true;
  }

  /// The first order of b's parts in which each matches: greedy, each part of `a` takes the first
  /// part of `b` left that fits.
  bool match_parts(const std::vector<Network>& a, const std::vector<Network>& b) {
    if (a.size() != b.size()) return false;
    std::vector<bool> taken(b.size());
    for (const Network& part : a) {
      std::size_t i = 0;
      for (; i < b.size(); ++i) {
        if (taken[i]) continue;
        Pairing attempt = *this;
        if (!attempt.match(part, b[i])) continue;
        *this = std::move(attempt);
        taken[i] = true;
        break;
      }
      if (i == b.size()) return false;
    }
    return true;
  }

  std::map<Symbol, Symbol> forth_, back_;
  std::vector<std::pair<NumberRole, std::pair<Symbol, Symbol>>> coefficients_;
};

}  // namespace

std::optional<GiNaC::ex> ratio_of_same_shape(const Network& network, const Network& other) {
  Pairing pairing;
  if (!pairing.match(network, other)) return std::nullopt;
  return pairing.ratio();
}

}  // namespace vcrit::symbolic
