#include "analysis/resonance.hpp"

#include <set>

#include "analysis/abbreviated.hpp"
#include "analysis/by_frequency.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Real and imaginary parts with more terms than this are not shown.
constexpr std::size_t readable_part_terms = 40;

/// The factor that vanishes, as (stiffness) + m s^2.
struct MassBalance {
  ex mass;
  ex stiffness;  ///< of K_n, K_t, K_d, or of K_m and K_n
  ex whole;
};

MassBalance per_mass(const ex& factor, const ex& m, const SymbolicModel& model) {
  const ex unit = factor.coeff(m, 1).coeff(laplace(), 2);
  ex stiffness = 0;
  for (const auto& [name, network] : model.networks())
    stiffness += factored(factor.coeff(quantity(name), 1) / unit) * quantity(name);
  return {m, stiffness, stiffness + m * GiNaC::pow(laplace(), 2)};
}

bool is_readable_part(const ex& polynomial) {
  return !GiNaC::is_a<GiNaC::add>(polynomial) || polynomial.nops() <= readable_part_terms;
}

/// p/q at s = i omega, times |q|^2 and without what both parts share.
Resonance::Parts real_and_imaginary(const ex& rational) {
  const ex fraction = rational.normal().numer_denom();
  const EvenOdd p = even_odd(fraction.op(0).expand()), q = even_odd(fraction.op(1).expand());
  const ex real = (p.even * q.even + GiNaC::pow(omega(), 2) * p.odd * q.odd).expand();
  const ex imaginary = (omega() * (p.odd * q.even - p.even * q.odd)).expand();
  ex real_left, imaginary_left;
  const ex shared = GiNaC::gcd(real, imaginary, &real_left, &imaginary_left);
  const int sign = is_negative(shared) ? -1 : 1;
  return {(sign * real_left).expand(), (sign * imaginary_left).expand()};
}

// A sum under the root: GiNaC would take the number of a product out of it.
ex root_of(const ex& stiffness, const ex& m) {
  const ex square = factored(stiffness / m);
  return GiNaC::sqrt(square.integer_content().is_equal(1) ? square : square.expand());
}

/// Where springs balance the inertia.
ex frequency_of(const MassBalance& balance, const SymbolicModel& model) {
  const std::optional<GiNaC::exmap> known = model.multiplied_out(balance.whole);
  return root_of(known ? balance.stiffness.subs(*known) : balance.stiffness, balance.mass);
}

/// What the elements in the stiffness have.
std::set<NumberRole> roles(const MassBalance& balance, const SymbolicModel& model) {
  std::set<NumberRole> found;
  for (const auto& [name, network] : model.networks())
    for (const Step& step : network.reduction().steps)
      if (step.kind == Step::Kind::element && balance.stiffness.has(quantity(name)))
        for_each_amount(step.element, [&](const Amount&, NumberRole role) { found.insert(role); });
  return found;
}

/// Without their numbers, by powers of omega.
Resonance::Parts without_numbers(const Resonance::Parts& parts) {
  const auto divided = [](const ex& part) {
    return part.is_zero() ? part : (part / part.integer_content()).expand();
  };
  return {by_frequency(divided(parts.real)), by_frequency(divided(parts.imaginary))};
}

/// The factor of the amplitude that the condition comes from: of the same mass and stiffnesses, and
/// on the same side of the bar.
std::optional<ex> factor_in(const Change& change, const ex& factor, Resonance::Kind kind,
                            const ex& m, const SymbolicModel& model) {
  const bool above = kind == Resonance::Kind::antiresonance;
  for (const auto& [other, exponent] : model.factors(change).parts()) {
    const bool same = std::all_of(
        model.networks().begin(), model.networks().end(), [&](const NamedNetwork& part) {
          return other.has(quantity(part.name)) == factor.has(quantity(part.name));
        });
    if (other.has(m) && same && (exponent > 0) == above) return other;
  }
  return std::nullopt;
}

/// K_n + g (K_d - m omega^2), say, and its parts.
void abbreviate(Resonance& resonance, const ex& factor, const ex& m, const SymbolicModel& model,
                const Abbreviations& names) {
  if (names.ratio) {
    const ex g = names.ratio->left;
    Change change;
    change.ratio = 1 / g;
    const auto other = factor_in(change, factor, resonance.kind, m, model);
    if (other && other->has(g)) {
      resonance.condition = other->subs(laplace() == GiNaC::I * omega()).expand().collect(g);
      if (resonance.frequency)
        resonance.frequency = frequency_of(per_mass(*other, m, model), model);
    }
  }
  if (!resonance.parts) return;
  resonance.parts = shortest_in(
      names, {},
      [&](const Change& change) {
        const auto other = factor_in(change, factor, resonance.kind, m, model);
        const auto known = model.multiplied_out(factor, change);
        return other && known ? without_numbers(real_and_imaginary(other->subs(*known)))
                              : *resonance.parts;
      },
      [](const Resonance::Parts& parts) {
        return printed_operations(parts.real) + printed_operations(parts.imaginary);
      });
}

Resonance resonance(const ex& factor, Resonance::Kind kind, const ex& m, const SymbolicModel& model,
                    const Abbreviations& names) {
  const MassBalance balance = per_mass(factor, m, model);
  Resonance found{kind, balance.whole.subs(laplace() == GiNaC::I * omega()), {}, {}, {}, {}, {}};
  const std::set<NumberRole> inside = roles(balance, model);
  found.damped = std::any_of(inside.begin(), inside.end(), [](NumberRole role) {
    return role != NumberRole::stiffness && role != NumberRole::mass;
  });
  found.absorbing = inside.contains(NumberRole::mass);
  const std::optional<GiNaC::exmap> known = model.multiplied_out(factor);
  if (!known) found.definitions = used_in(factor, model.nested_formula().definitions);
  if (inside == std::set{NumberRole::stiffness}) found.frequency = frequency_of(balance, model);
  if (found.damped && known) {
    const Resonance::Parts parts = real_and_imaginary(balance.whole.subs(*known));
    if (is_readable_part(parts.real) && is_readable_part(parts.imaginary)) found.parts = parts;
  }
  abbreviate(found, factor, m, model, names);
  return found;
}

/// The mass whose balance along the surface or, with K_m, along the normal may vanish.
std::optional<ex> mass_in(const Problem& problem, Resonance::Kind kind) {
  if (kind == Resonance::Kind::mount_resonance)
    return problem->mount_mass ? std::optional(symbol(problem->mount_mass->symbol)) : std::nullopt;
  if (!problem->mass || problem->receptance() != nullptr) return std::nullopt;
  return symbol(problem->mass->symbol);
}

}  // namespace

std::vector<Resonance> resonances(const Derivation& derivation, const Abbreviations& names) {
  using Kind = Resonance::Kind;
  const AlgebraLock lock;
  const SymbolicModel& model = *derivation.model;
  std::optional<Factors> amplitude;
  std::vector<Resonance> found;
  // How a measured contact changes with omega is in its table.
  if (!derivation.problem->measured.empty()) return found;
  for (const Kind kind : {Kind::resonance, Kind::antiresonance, Kind::mount_resonance}) {
    const std::optional<ex> mass = mass_in(derivation.problem, kind);
    if (!mass) continue;
    if (!amplitude) amplitude = model.factors({});
    for (const auto& [factor, exponent] : amplitude->parts()) {
      const bool along_normal = factor.has(quantity("K_m")), vanishes = exponent > 0;
      if (factor.has(*mass) && along_normal == (kind == Kind::mount_resonance) &&
          vanishes == (kind == Kind::antiresonance))
        found.push_back(resonance(factor, kind, *mass, model, names));
    }
  }
  return found;
}

}  // namespace vcrit::symbolic
