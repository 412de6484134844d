#include "critical/log_derivative.hpp"

#include <cmath>

#include "base/complex.hpp"
#include "base/errors.hpp"
#include "critical/certified.hpp"
#include "critical/eq24.hpp"
#include "network/reduction.hpp"
#include "rules/kinds.hpp"

namespace vcrit {

namespace {

/// A number and p times its derivative by p.
struct Dual {
  ComplexDouble value, change{};

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.change + b.change};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.change - b.change};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.change * b.value + a.value * b.change};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const ComplexDouble quotient = a.value / b.value;
    return {quotient, (a.change - quotient * b.change) / b.value};
  }
  /// p d ln|value|/dp
  double log_change() const { return (change / value).real(); }
};

/// The algebra of a reduction with derivatives by one symbol.
struct Duals {
  using Value = Dual;
  const Values& values;
  Symbol omega_symbol, by;
  Values following = {};  ///< omega times the slopes of what follows a table

  Dual of(const Symbol& symbol) const {
    const double value = values.at(symbol);
    if (const double* const slope = following.find(symbol); slope != nullptr && by == omega_symbol)
      return {value, *slope};
    return {value, symbol == by ? value : 0};
  }
  static Dual constant(const TypedNumber& number) { return {number.value}; }
  static Dual plus(const Dual& a, const Dual& b) { return a + b; }
  static Dual times(const Dual& a, const Dual& b) { return a * b; }
  static Dual over(const Dual& a, const Dual& b) { return a / b; }
  Dual s() const { return Dual{{0, 1}} * of(omega_symbol); }
  Dual inertia(const Symbol& mass) const { return of(mass) * s() * s(); }

  Dual times_s(const Dual& k) const { return k * s(); }
  Dual relaxing(const Dual& k, const Dual& tau) const {
    const Dual x = s() * tau;
    return k * x / (Dual{1} + x);
  }
  static Dual lossy(const Dual& k, const Dual& eta) { return k * (Dual{1} + Dual{{0, 1}} * eta); }
  static Dual parallel(const Dual& a, const Dual& b) { return a + b; }
  static Dual series(const Dual& a, const Dual& b) { return mesh(a, b, a + b); }
  static Dual mesh(const Dual& a, const Dual& b, const Dual& total) { return a / total * b; }
};

Dual ratio_of(const Isotropic& isotropic, const Duals& duals) {
  const Dual value = duals.of(isotropic.quantity.symbol);
  if (isotropic.by == Isotropic::By::ratio) return value;
  return Dual{2} * (Dual{1} - value) / (Dual{2} - value);
}

/// R_d, and how it goes along the line between two rows of its table.
Dual receptance_of(const Receptance& measured, const Duals& duals) {
  const double omega = duals.values.at(duals.omega_symbol);
  const auto [below, above] = bracket(measured, omega);
  const ComplexDouble first(below.re, below.im);
  const double width = above.omega - below.omega;
  const bool varies = duals.by == duals.omega_symbol;
  if (varies && width == 0)
    throw ModelError("at a row of a measured drive's table v* has a slope on each side of omega");
  if (width == 0) return {first};
  const ComplexDouble rise = (ComplexDouble(above.re, above.im) - first) / width;
  return {first + (omega - below.omega) * rise, varies ? omega * rise : 0};
}

/// ln of Eq. (24): what it changes by.
struct LogChanges {
  Problem problem;
  const Duals& duals;

  double outer() const {
    const Dual product = duals.of(problem->coefficient.symbol) *
                         duals.of(problem->amplitude.symbol) *
                         duals.of(problem->angular_frequency.symbol);
    return product.log_change();
  }
  Dual ratio(const Isotropic& isotropic) const { return ratio_of(isotropic, duals); }
  Dual normal() const { return evaluate(problem->normal.reduction(), duals); }
  Dual tangential(const ReducedNetwork& own) const { return evaluate(own.reduction(), duals); }
  static Dual scaled(const Dual& ratio, const Dual& normal) { return ratio * normal; }
  void times_mount(double& change, const Dual& normal, const ReducedNetwork& network) const {
    const Dual mount = evaluate(network.reduction(), duals);
    Dual whole = mount + normal;
    if (problem->mount_mass) whole = whole + duals.inertia(problem->mount_mass->symbol);
    change += mount.log_change() - whole.log_change();
  }
  static void divide(double& change, const Dual& ratio) { change -= ratio.log_change(); }
  static void times_quotient(double& change, const Dual& normal, const Dual& tangential) {
    change += normal.log_change() - tangential.log_change();
  }
  void times_drive(double& change, const Dual& tangential, const ReducedNetwork& drive) const {
    times_drive(change, tangential, Dual{1}, evaluate(drive.reduction(), duals));
  }
  void times_drive(double& change, const Dual& tangential, const Receptance& drive) const {
    times_drive(change, tangential, receptance_of(drive, duals), Dual{1});
  }

 private:
  // K_d = below/receptance.
  void times_drive(double& change, const Dual& tangential, const Dual& receptance,
                   Dual below) const {
    if (problem->mass) below = below + duals.inertia(problem->mass->symbol) * receptance;
    change += (tangential * receptance + below).log_change() - below.log_change();
  }
};

Values slopes_of_tables(const Problem& problem, double omega) {
  Values slopes;
  for (const MeasuredStiffness& measured : problem->measured) {
    const auto numbers = numbers_at(measured, omega);
    if (!numbers || !numbers->slopes)
      throw ModelError(
          "at a row of a measured contact's table v* has a slope on each side of omega");
    slopes[measured.storage] = omega * numbers->slopes->first;
    slopes[measured.loss_factor] = omega * numbers->slopes->second;
  }
  return slopes;
}

// Balls let omega vary below numbers that stand still: the chain rule adds what these do.
double certified_change(const Problem& problem, const Symbol& symbol) {
  const Values& values = problem.values();
  double change = certified_log_derivative(problem, symbol);
  if (symbol != problem->angular_frequency.symbol) return change;
  for (const auto& [following, slope] : slopes_of_tables(problem, values.at(symbol)))
    if (slope != 0)
      change += certified_log_derivative(problem, following) * slope / values.at(following);
  return change;
}

// In doubles.
double direct(const Problem& problem, const Symbol& symbol) {
  Values values = problem.values();
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential)) {
    if (isotropic->quantity.symbol.name.empty()) throw Bug("an isotropic contact without a ratio");
    values.emplace(isotropic->quantity.symbol, tangential_ratio(*isotropic));
  }
  const Symbol& omega = problem->angular_frequency.symbol;
  Duals duals{values, omega, symbol};
  if (symbol == omega) duals.following = slopes_of_tables(problem, values.at(omega));
  return eq24(problem, LogChanges{problem, duals});
}

}  // namespace

void check_symbol(const Problem& problem, const Symbol& symbol) {
  if (problem.known_values().contains(symbol)) return;
  const std::string name = to_text(as_called(problem, symbol));
  if (!problem->source->settable.contains(name))  // an element of value 0 is one
    throw InputError(argument("symbol"), name, "a symbol of the scene");
}

// Next to a resonance inside the drive doubles cancel.
double log_derivative(const Problem& problem, const Symbol& symbol) {
  check_symbol(problem, symbol);
  if (rules::drive_resonates(problem)) return certified_change(problem, symbol);
  const double change = direct(problem, symbol);
  const bool by_table = problem->receptance() != nullptr || !problem->measured.empty();
  if (by_table && !std::isfinite(change))
    throw ModelError("v* is 0 or infinite, so that it has no relative sensitivity");
  return std::isfinite(change) ? change : certified_log_derivative(problem, symbol);
}

}  // namespace vcrit
