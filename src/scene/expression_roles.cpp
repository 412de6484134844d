#include "scene/expression_roles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/units.hpp"
#include "network/law.hpp"

namespace vcrit {

namespace {

/// kg^mass m^length s^time, times powers of what unknown names measure.
struct Powers {
  int mass = 0, length = 0, time = 0;
  std::map<std::string, int> unknown = {};

  friend bool operator==(const Powers&, const Powers&) = default;
};

Powers product_of(const Powers& a, const Powers& b, int exponent) {
  Powers all{a.mass + exponent * b.mass, a.length + exponent * b.length, a.time + exponent * b.time,
             a.unknown};
  for (const auto& [name, power] : b.unknown)
    if ((all.unknown[name] += exponent * power) == 0) all.unknown.erase(name);
  return all;
}

/// Of what a number in an expression may measure; of others, a loss factor, none.
Powers powers_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::stiffness:
      return {1, 0, -2};
    case Dimension::damping:
      return {1, 0, -1};
    case Dimension::modulus:
      return {1, -1, -2};
    case Dimension::viscosity:
      return {1, -1, -1};
    case Dimension::time:
      return {0, 0, 1};
    case Dimension::mass:
      return {1, 0, 0};
    default:
      return {};
  }
}

constexpr std::array roles_of_numbers{NumberRole::stiffness, NumberRole::damping, NumberRole::time,
                                      NumberRole::mass, NumberRole::factor};

/// Two that have to be one.
struct Equation {
  Powers first, second;
  const MeasuredExpression* of;
  bool is_sum;

  Powers quotient() const { return product_of(first, second, -1); }
};

class Roles {
 public:
  Roles(const std::vector<MeasuredExpression>& expressions,
        std::map<std::string, NumberMeasure> known, MeasuredParts parts)
      : known_(std::move(known)), parts_(parts), rows_(measures_in(parts)) {
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

  std::map<std::string, NumberMeasure> result() && { return std::move(known_); }

 private:
  void write_equations(const std::vector<MeasuredExpression>& expressions) {
    equations_.clear();
    for (const MeasuredExpression& each : expressions) {
      Powers first = powers(*each.expression, each);
      equations_.push_back({std::move(first), powers_of(each.measure.dimension), &each, false});
    }
  }

  void find_all(const std::vector<MeasuredExpression>& expressions) {
    do write_equations(expressions);
    while (find_some());
  }

  void take_unknown(const std::vector<MeasuredExpression>& expressions, const char* beginning,
                    NumberRole role) {
    for (const MeasuredExpression& each : expressions) {
      const bool by_moduli = of_half_space(each);
      const NumberRow& row = number_row(role);
      for_each_symbol(Amount({}, each.expression), role, [&](const Symbol& symbol, NumberRole as) {
        if (symbol.name.starts_with(beginning))
          known_.emplace(symbol.name,
                         NumberMeasure{as, by_moduli ? row.in_half_space : row.dimension});
      });
    }
  }

  // A time is the same in both, and its expression may be of either.
  bool of_half_space(const MeasuredExpression& of) const {
    const Dimension dimension = of.measure.dimension;
    return parts_ == MeasuredParts::half_space || dimension == Dimension::modulus ||
           dimension == Dimension::viscosity;
  }

  // Sums on the way become equations.
  Powers powers(const AmountTree& e, const MeasuredExpression& of) {
    switch (e.kind) {
      case AmountTree::Kind::number:
        return {};
      case AmountTree::Kind::symbol: {
        const auto known = known_.find(e.symbol.name);
        return known == known_.end() ? Powers{0, 0, 0, {{e.symbol.name, 1}}}
                                     : powers_of(known->second.dimension);
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
      for (const NumberMeasure& measure : rows_)
        if (product_of(all, powers_of(measure.dimension), power) == Powers{0, 0, 0, all.unknown})
          found = known_.emplace(name, measure).second || found;
    }
    return found;
  }

  void refuse_masses(const MeasuredExpression& of) const {
    if (of.measure.role == NumberRole::mass) return;
    for_each_symbol(
        Amount({}, of.expression), NumberRole::factor, [&](const Symbol& symbol, NumberRole) {
          if (known_.at(symbol.name).role == NumberRole::mass)
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
    throw InputError(of.place, fmt::format("{}, {}", what, described(equation.first)),
                     described(equation.second), advice(equation));
  }

  static const char* advice(const Equation& equation) {
    Powers apart = equation.quotient();
    apart.length = 0;
    if (apart == Powers{})
      return "elements of the half-space are per length, in Pa and Pa s, and those of the drive, "
             "which holds all of the contact, in N/m and N s/m";
    return "numbers without a unit whose expressions leave it open are stiffnesses (k...), "
           "dampers (c...) or plain numbers: give them a unit";
  }

  std::string described(const Powers& powers) const {
    for (const NumberMeasure& measure : rows_)
      if (powers_of(measure.dimension) == powers) return describe(measure.dimension);
    return fmt::format("something in kg^{}{} s^{}", powers.mass,
                       powers.length == 0 ? "" : fmt::format(" m^{}", powers.length), powers.time);
  }

  std::map<std::string, NumberMeasure> known_;
  MeasuredParts parts_;
  std::vector<NumberMeasure> rows_;
  std::vector<Equation> equations_;
};

}  // namespace

std::vector<NumberMeasure> measures_in(MeasuredParts parts) {
  std::vector<NumberMeasure> all;
  for (const NumberRole role : roles_of_numbers) {
    const NumberRow& row = number_row(role);
    all.push_back({role, parts == MeasuredParts::half_space ? row.in_half_space : row.dimension});
  }
  if (parts == MeasuredParts::both)
    for (const NumberRole role : roles_of_numbers)
      if (const NumberRow& row = number_row(role); row.in_half_space != row.dimension)
        all.push_back({role, row.in_half_space});
  return all;
}

std::map<std::string, NumberMeasure> measures_of_names(
    const std::vector<MeasuredExpression>& expressions, std::map<std::string, NumberMeasure> known,
    MeasuredParts parts) {
  return Roles(expressions, std::move(known), parts).result();
}

}  // namespace vcrit
