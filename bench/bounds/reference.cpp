#include "bounds/reference.hpp"

#include <algorithm>
#include <optional>

#include "bounds/formulas.hpp"

namespace vcrit::bounds {

namespace {

// Wanted are the two doubles of an Exact, 2 x 53 bits, and six to
// round by. The first try has 80 bits to lose to cancellation. From the third on a ball around 0 is
// most likely an exact zero, which arithmetic modulo a prime tells for less than more bits.
constexpr slong least_precision = 192, modular_precision = 768, wanted_bits = 112;
constexpr slong most_precision = slong{1}
                                 << 20;  // sums of products of some ten doubles cancel less

/// K_n, K_t, K_d + (K_t and) inertia in any arithmetic; the ratio K_t/K_n of an isotropic contact
/// is 2 (1 - nu)/(2 - nu).
template <class Arithmetic>
struct Parts {
  using Value = typename Arithmetic::Value;
  Value normal, tangential;
  std::optional<Value> body, whole;  ///< K_d - m omega^2, and K_t more

  Parts(const TrialSystem& system, Arithmetic& a, std::span<const double> x)
      : normal(Formulas<Arithmetic>(a).stiffness(system.contact, system.normal.of(x))),
        tangential(of_contact(system, a, x)) {
    if (!system.drive) return;
    body = Formulas<Arithmetic>(a).stiffness(*system.drive, system.driving.of(x));
    if (system.mass) {
      const Value omega = a.element(x[omega_slot]);
      const Value inertia = a.multiply(a.multiply(a.element(x[*system.mass]), omega), omega);
      body = a.subtract(*body, inertia);
    }
    whole = a.add(tangential, *body);
  }

 private:
  Value of_contact(const TrialSystem& system, Arithmetic& a, std::span<const double> x) {
    if (!system.poisson)
      return Formulas<Arithmetic>(a).stiffness(system.contact, system.tangential.of(x));
    const Value nu = a.element(x[*system.poisson]), one = a.element(1), two = a.element(2);
    const Value ratio = a.divide(a.multiply(two, a.subtract(one, nu)), a.subtract(two, nu));
    return a.multiply(ratio, normal);
  }
};

/// Which of the factors of v* are exactly zero.
struct Zeros {
  bool above = false, below = false;
};

Zeros zeros_modulo(ulong prime, const TrialSystem& system, std::span<const double> x) {
  ModularArithmetic modular(prime, x[omega_slot]);
  const Parts<ModularArithmetic> parts(system, modular, x);
  const auto zero = [](const auto& value) { return value && ModularArithmetic::is_zero(*value); };
  return {ModularArithmetic::is_zero(parts.normal) || zero(parts.whole),
          ModularArithmetic::is_zero(parts.tangential) || zero(parts.body)};
}

Zeros exact_zeros(const TrialSystem& system, std::span<const double> x) {
  constexpr ulong first = (ulong{1} << 61) - 1, second = (ulong{1} << 61) - 45;
  const Zeros one = zeros_modulo(first, system, x), two = zeros_modulo(second, system, x);
  return {one.above && two.above, one.below && two.below};
}

bool may_be_zero(acb_srcptr z) { return acb_contains_zero(z) != 0; }

/// factor |z|^2
void multiply_norm(arb_t product, acb_srcptr z, arb_t square, slong precision) {
  arb_mul(square, acb_realref(z), acb_realref(z), precision);
  arb_addmul(square, acb_imagref(z), acb_imagref(z), precision);
  arb_mul(product, product, square, precision);
}

}  // namespace

ExactReference::ExactReference(const TrialSystem& system) : system_(system) {
  for (arb_ptr each : {above_, below_, factor_, velocity_}) arb_init(each);
  arf_init(rest_);
  arf_init(high_);
}

ExactReference::~ExactReference() {
  for (arb_ptr each : {above_, below_, factor_, velocity_}) arb_clear(each);
  arf_clear(rest_);
  arf_clear(high_);
}

Exact ExactReference::velocity(std::span<const double> x) {
  for (slong precision = least_precision; precision <= most_precision; precision *= 2)
    if (const auto exact = at(precision, x)) return *exact;
  throw Bug("a velocity that is not zero is known at some precision");
}

std::optional<Exact> ExactReference::at(slong precision, std::span<const double> x) {
  balls_.begin(x[omega_slot], precision);
  const Parts<BallArithmetic> parts(system_, balls_, x);
  const bool unsure = may_be_zero(parts.normal) || may_be_zero(parts.tangential) ||
                      (parts.body && (may_be_zero(*parts.body) || may_be_zero(*parts.whole)));
  if (unsure) {
    if (precision < modular_precision) return std::nullopt;
    const Zeros zeros = exact_zeros(system_, x);
    if (zeros.above && zeros.below) return Exact{};
    if (zeros.above) return Exact{Exact::Kind::zero};
    if (zeros.below) return Exact{Exact::Kind::pole};
    return std::nullopt;
  }
  arb_one(above_);
  arb_one(below_);
  multiply_norm(above_, parts.normal, factor_, precision);
  multiply_norm(below_, parts.tangential, factor_, precision);
  if (parts.body) {
    multiply_norm(above_, *parts.whole, factor_, precision);
    multiply_norm(below_, *parts.body, factor_, precision);
  }
  arb_div(velocity_, above_, below_, precision);
  arb_sqrt(velocity_, velocity_, precision);
  for (const std::size_t slot : {coefficient_slot, omega_slot, amplitude_slot}) {
    arb_set_d(factor_, x[slot]);
    arb_mul(velocity_, velocity_, factor_, precision);
  }
  if (arb_rel_accuracy_bits(velocity_) < wanted_bits) return std::nullopt;
  return rounded();
}

Exact ExactReference::rounded() {
  Exact exact{Exact::Kind::number};
  exact.exponent = static_cast<int>(fmpz_get_si(ARF_EXPREF(arb_midref(velocity_))));
  arf_mul_2exp_si(rest_, arb_midref(velocity_), -exact.exponent);
  exact.high = arf_get_d(rest_, ARF_RND_NEAR);
  arf_set_d(high_, exact.high);
  arf_sub(rest_, rest_, high_, ARF_PREC_EXACT, ARF_RND_NEAR);
  exact.low = arf_get_d(rest_, ARF_RND_NEAR);
  return exact;
}

double ExactReference::mass_near_resonance(std::span<const double> x, bool with_tangential,
                                           double part) {
  constexpr slong precision = 128;  // a double is wanted: 75 bits may cancel
  balls_.begin(x[omega_slot], precision);
  Formulas<BallArithmetic> formulas(balls_);
  acb_srcptr stiffness = formulas.stiffness(*system_.drive, system_.driving.of(x));
  if (with_tangential) {
    const Parts<BallArithmetic> parts(system_, balls_, x);
    stiffness = balls_.add(stiffness, parts.tangential);
  }
  arb_set_d(factor_, x[omega_slot]);
  arb_mul(factor_, factor_, factor_, precision);
  arb_div(velocity_, acb_realref(stiffness), factor_, precision);
  arb_set_d(factor_, part);
  arb_submul(velocity_, velocity_, factor_, precision);
  return arf_get_d(arb_midref(velocity_), ARF_RND_NEAR);
}

}  // namespace vcrit::bounds
