#include "critical/log_derivative.hpp"

#include <cmath>

#include "base/complex.hpp"
#include "base/errors.hpp"
#include "critical/certified.hpp"
#include "critical/eq24.hpp"
#include "network/masses.hpp"
#include "network/reduction.hpp"

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

  Dual of(const Symbol& symbol) const {
    const double value = values.at(symbol);
    return {value, symbol == by ? value : 0};
  }
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
Dual receptance_of(const Scene& scene, const Duals& duals) {
  const double omega = duals.values.at(duals.omega_symbol);
  const auto [below, above] = bracket(*scene.receptance, omega);
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
  const Scene& scene;
  const Duals& duals;

  double outer() const {
    const Dual product = duals.of(scene.coefficient.symbol) * duals.of(scene.amplitude.symbol) *
                         duals.of(scene.angular_frequency.symbol);
    return product.log_change();
  }
  Dual ratio(const Isotropic& isotropic) const { return ratio_of(isotropic, duals); }
  Dual normal() const { return evaluate(reduce(scene.normal), duals); }
  Dual tangential() const { return evaluate(reduce(std::get<Network>(scene.tangential)), duals); }
  static Dual scaled(const Dual& ratio, const Dual& normal) { return ratio * normal; }
  static void divide(double& change, const Dual& ratio) { change -= ratio.log_change(); }
  static void times_quotient(double& change, const Dual& normal, const Dual& tangential) {
    change += normal.log_change() - tangential.log_change();
  }
  void times_drive(double& change, const Dual& tangential) const {
    const Dual receptance = scene.receptance ? receptance_of(scene, duals) : Dual{1};
    Dual below = scene.receptance ? Dual{1} : evaluate(reduce(*scene.drive), duals);
    if (scene.mass) below = below + duals.inertia(scene.mass->symbol) * receptance;
    change += (tangential * receptance + below).log_change() - below.log_change();
  }
};

// In doubles.
double direct(const Scene& scene, const Symbol& symbol) {
  Values values = values_of(scene);
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential)) {
    if (isotropic->quantity.symbol.name.empty()) throw Bug("an isotropic contact without a ratio");
    values.emplace(isotropic->quantity.symbol, tangential_ratio(*isotropic));
  }
  const Duals duals{values, scene.angular_frequency.symbol, symbol};
  return eq24(scene, LogChanges{scene, duals});
}

}  // namespace

// A drive with masses need not give at all at some frequency, and next to that doubles cancel.
double log_derivative(const Scene& scene, const Symbol& symbol) {
  if (scene.drive && has_masses(*scene.drive)) return certified_log_derivative(scene, symbol);
  const double change = direct(scene, symbol);
  if (scene.receptance && !std::isfinite(change))
    throw ModelError("v* is 0 or infinite, so that it has no relative sensitivity");
  return std::isfinite(change) ? change : certified_log_derivative(scene, symbol);
}

}  // namespace vcrit
