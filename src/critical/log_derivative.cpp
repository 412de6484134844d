#include "critical/log_derivative.hpp"

#include <cmath>

#include "base/complex.hpp"
#include "base/errors.hpp"
#include "critical/certified.hpp"
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

  Dual element(const Element& e) const {
    const Dual coefficient = of(e.coefficient);
    if (e.kind == ElementKind::spring) return coefficient;
    if (e.kind == ElementKind::damper) return coefficient * s();
    ensure(e.kind != ElementKind::mass, "drives with masses are differentiated by balls");
    const Dual x = s() * of(e.time);
    return coefficient * x / (Dual{1} + x);
  }
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

// In doubles.
double direct(const Scene& scene, const Symbol& symbol) {
  Values values = values_of(scene);
  Duals duals{values, scene.angular_frequency.symbol, symbol};
  const Dual outer = duals.of(scene.coefficient.symbol) * duals.of(scene.amplitude.symbol) *
                     duals.of(scene.angular_frequency.symbol);
  double change = outer.log_change();
  Dual tangential;
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential)) {
    if (isotropic->quantity.symbol.name.empty()) throw Bug("an isotropic contact without a ratio");
    values.emplace(isotropic->quantity.symbol, tangential_ratio(*isotropic));
    const Dual ratio = ratio_of(*isotropic, duals);
    change -= ratio.log_change();
    if (has_drive(scene)) tangential = ratio * evaluate(reduce(scene.normal), duals);
  } else {
    tangential = evaluate(reduce(std::get<Network>(scene.tangential)), duals);
    change += evaluate(reduce(scene.normal), duals).log_change() - tangential.log_change();
  }
  if (!has_drive(scene)) return change;
  if (scene.receptance) {
    const Dual receptance = receptance_of(scene, duals);
    Dual below{1};
    if (scene.mass) below = below + duals.inertia(scene.mass->symbol) * receptance;
    return change + (tangential * receptance + below).log_change() - below.log_change();
  }
  Dual below = evaluate(reduce(*scene.drive), duals);
  if (scene.mass) below = below + duals.inertia(scene.mass->symbol);
  return change + (tangential + below).log_change() - below.log_change();
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
