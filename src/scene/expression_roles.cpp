#include "scene/expression_roles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/units.hpp"
#include "network/law.hpp"

namespace vcrit {

namespace {

/// kg^mass s^time, times powers of what unknown names measure. A stiffness of a half-space has 1/m
/// with each kg, and so needs no third exponent.
struct Powers {
  int mass = 0, time = 0;
  std::map<std::string, int> unknown = {};

  friend bool operator==(const Powers&, const Powers&) = default;
};

Powers product_of(const Powers& a, const Powers& b, int exponent) {
  Powers all{a.mass + exponent * b.mass, a.time + exponent * b.time, a.unknown};
  for (const auto& [name, power] : b.unknown)
    if ((all.unknown[name] += exponent * power) == 0) all.unknown.erase(name);
  return all;
}

const std::array<std::pair<NumberRole, Powers>, 5>& rows_of_roles() {
  static const std::array<std::pair<NumberRole, Powers>, 5> rows{{{NumberRole::stiffness, {1, -2}},
                                                                  {NumberRole::damping, {1, -1}},
                                                                  {NumberRole::time, {0, 1}},
                                                                  {NumberRole::mass, {1, 0}},
                                                                  {NumberRole::factor, {0, 0}}}};
  return rows;
}

Powers powers_of(NumberRole role) {
  for (const auto& [each, powers] : rows_of_roles())
    if (each == role) return powers;
  return {};  // a loss factor
}

/// Two that have to be one.
struct Equation {
  Powers first, second;
  const MeasuredExpression* of;
  bool is_sum;

  Powers quotient() const { return product_of(first, second, -1); }
};

class Roles {
 public:
  Roles(const std::vector<MeasuredExpression>& expressions, std::map<std::string, NumberRole> known,
        bool of_half_space)
      : known_(std::move(known)), of_half_space_(of_half_space) {
    find_all(expressions);
    // As in networks, what is left goes by its first letter.
    take_unknown(expressions, "k", NumberRole::stiffness);
    take_unknown(expressions, "c", NumberRole::damping);
    find_all(expressions);
    take_unknown(expressions, "", NumberRole::factor);
    write_equations(expressions);
    for (const MeasuredExpression& each : expressions) refuse_masses(each);
    for (const Equation& equation : equations_) check(equation);
  }

  std::map<std::string, NumberRole> result() && { return std::move(known_); }

 private:
  void write_equations(const std::vector<MeasuredExpression>& expressions) {
    equations_.clear();
    for (const MeasuredExpression& each : expressions) {
      Powers first = powers(*each.expression, each);
      equations_.push_back({std::move(first), powers_of(each.role), &each, false});
    }
  }

  void find_all(const std::vector<MeasuredExpression>& expressions) {
    do write_equations(expressions);
    while (find_some());
  }

  void take_unknown(const std::vector<MeasuredExpression>& expressions, const char* beginning,
                    NumberRole role) {
    for (const MeasuredExpression& each : expressions)
      for_each_symbol(Amount({}, each.expression), role, [&](const Symbol& symbol, NumberRole) {
        if (symbol.name.starts_with(beginning)) known_.emplace(symbol.name, role);
      });
  }

  // Sums on the way become equations.
  Powers powers(const AmountTree& e, const MeasuredExpression& of) {
    switch (e.kind) {
      case AmountTree::Kind::number:
        return {};
      case AmountTree::Kind::symbol: {
        const auto role = known_.find(e.symbol.name);
        return role == known_.end() ? Powers{0, 0, {{e.symbol.name, 1}}} : powers_of(role->second);
      }
      case AmountTree::Kind::product:
        return product_of(powers(*e.first, of), powers(*e.second, of), 1);
      case AmountTree::Kind::quotient:
        return product_of(powers(*e.first, of), powers(*e.second, of), -1);
      case AmountTree::Kind::sum:
        break;
    }
    Powers first = powers(*e.first, of);
    equations_.push_back({first, powers(*e.second, of), &of, true});
    return first;
  }

  // The one unknown of each equation, where that is something that a parameter may measure.
  bool find_some() {
    bool found = false;
    for (const Equation& equation : equations_) {
      const Powers all = equation.quotient();
      if (all.unknown.size() != 1) continue;
      const auto& [name, power] = *all.unknown.begin();
      for (const auto& [role, powers] : rows_of_roles())
        if (power * powers.mass == -all.mass && power * powers.time == -all.time)
          found = known_.emplace(name, role).second || found;
    }
    return found;
  }

  void refuse_masses(const MeasuredExpression& of) const {
    if (of.role == NumberRole::mass) return;
    for_each_symbol(
        Amount({}, of.expression), NumberRole::factor, [&](const Symbol& symbol, NumberRole) {
          if (known_.at(symbol.name) == NumberRole::mass)
            throw InputError(
                of.place,
                fmt::format("{} = \"{}\", of the mass {}", of.name, of.text, to_text(symbol)),
                "masses in expressions of masses alone");
        });
  }

  void check(const Equation& equation) const {
    if (equation.first == equation.second) return;
    const MeasuredExpression& of = *equation.of;
    const std::string what = fmt::format("{} = \"{}\"", of.name, of.text);
    if (equation.is_sum)
      throw InputError(of.place,
                       fmt::format("{}, which adds {} and {}", what, described(equation.first),
                                   described(equation.second)),
                       "terms of one unit");
    throw InputError(
        of.place, fmt::format("{}, {}", what, described(equation.first)),
        described(equation.second),
        "numbers without a unit whose expressions leave it open are stiffnesses (k...), "
        "dampers (c...) or plain numbers: give them a unit");
  }

  std::string described(const Powers& powers) const {
    for (const auto& [role, each] : rows_of_roles())
      if (each == powers) {
        const NumberRow& row = number_row(role);
        return describe(of_half_space_ ? row.in_half_space : row.dimension);
      }
    return fmt::format("something in kg^{}{} s^{}", powers.mass,
                       of_half_space_ ? fmt::format(" m^{}", -powers.mass) : "", powers.time);
  }

  std::map<std::string, NumberRole> known_;
  bool of_half_space_;
  std::vector<Equation> equations_;
};

}  // namespace

std::map<std::string, NumberRole> roles_of_names(const std::vector<MeasuredExpression>& expressions,
                                                 std::map<std::string, NumberRole> known,
                                                 bool of_half_space) {
  return Roles(expressions, std::move(known), of_half_space).result();
}

}  // namespace vcrit
