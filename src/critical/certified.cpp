#include "critical/certified.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "base/constants.hpp"
#include "critical/balls.hpp"
#include "critical/decimals.hpp"
#include "critical/drive_response.hpp"
#include "critical/eq24.hpp"
#include "critical/log_derivative.hpp"
#include "network/reduction.hpp"

namespace vcrit {

Ball Balls::decimal(const TypedNumber& number) const {
  return decimals != nullptr ? decimals->of(number, precision) : read_decimal(number, precision);
}

namespace {

/// Eq. 24 as prefactor |numerator|/|denominator|, each a ball.
struct Quotient {
  Ball prefactor, numerator, denominator;
  Ball free_numerator;  ///< the numerator where the denominator is 0
};

Ball ratio_ball(const Isotropic& isotropic, const Balls& balls) {
  Ball value = balls.shifted(isotropic.quantity.symbol, *isotropic.quantity.value);
  if (isotropic.by == Isotropic::By::ratio) return value;
  const Ball above = balls.multiply(Ball(2), balls.subtract(Ball(1), value));
  return balls.divide(above, balls.subtract(Ball(2), value));
}

class Evaluation {
 public:
  explicit Evaluation(const Problem& problem, ReadDecimals* decimals = nullptr)
      : problem_(problem),
        values_(problem_.values()),
        drive_(drive_in_balls(problem_)),
        decimals_(decimals) {
    for (const Amount& amount : problem_->expressions) operations_ += amount_operations(amount);
  }

  Quotient at(slong precision, const Shift* shift = nullptr) const {
    Balls balls = arithmetic(precision);
    if (shift != nullptr) {
      balls.shift = shift;
      if (shift->symbol == problem_->angular_frequency.symbol)
        balls.omega = balls.multiply(balls.omega, shift->factor);
    }
    return eq24(problem_, InBalls{*this, balls});
  }

  // Enough bits to tell an exact zero of K_t + K_d - m omega^2 from a tiny number: it is a quotient
  // of integers after scaling; every operation on doubles adds at most their whole range.
  slong most_precision() const {
    const auto* tangential = std::get_if<ReducedNetwork>(&problem_->tangential);
    const std::size_t contact =
        problem_->normal.reduction().steps.size() +
        (tangential != nullptr ? tangential->reduction().steps.size() : 0) +
        (problem_->mount ? problem_->mount->reduction().steps.size() + 2 : 0);
    return precision_for(contact + operations_ + (drive_ ? drive_->steps() : 0));
  }

  // Whether K_d - m omega^2 is 0: a question of the drive alone, whatever the size of the contact.
  bool resonant() const {
    if (!drive_) return false;
    const slong most = precision_for(operations_ + drive_->steps());
    for (slong precision = 128;; precision = std::min(2 * precision, most)) {
      Balls balls = arithmetic(precision);
      if (acb_contains_zero(inertial(drive_->at(balls), balls).get()) == 0) return false;
      if (precision == most) return true;
    }
  }

 private:
  /// Eq. (24) in balls.
  struct InBalls {
    const Evaluation& of;
    Balls& balls;

    Quotient outer() const {
      const Ball friction = balls.multiply(balls.of(of.problem_->coefficient.symbol),
                                           balls.of(of.problem_->amplitude.symbol));
      return {balls.multiply(friction, balls.omega), Ball(1), Ball(1), Ball(1)};
    }
    Ball ratio(const Isotropic& isotropic) const { return ratio_ball(isotropic, balls); }
    Ball normal() const { return evaluate(of.problem_->normal.reduction(), balls); }
    Ball tangential(const ReducedNetwork& own) const { return evaluate(own.reduction(), balls); }
    Ball scaled(const Ball& ratio, const Ball& normal) const {
      return balls.multiply(ratio, normal);
    }
    void times_mount(Quotient& q, const Ball& normal, const ReducedNetwork& network) const {
      const Ball mount = evaluate(network.reduction(), balls);
      Ball whole = balls.add(mount, normal);
      if (of.problem_->mount_mass)
        whole = balls.subtract(whole, balls.inertia(of.problem_->mount_mass->symbol));
      q.prefactor = balls.multiply(q.prefactor, balls.modulus(balls.divide(mount, whole)));
    }
    void divide(Quotient& q, const Ball& ratio) const {
      q.prefactor = balls.divide(q.prefactor, ratio);
    }
    void times_quotient(Quotient& q, const Ball& normal, const Ball& tangential) const {
      q.prefactor = balls.multiply(q.prefactor, balls.modulus(balls.divide(normal, tangential)));
    }
    // With K_d = force/deflection, both sides of the quotient times the deflection: neither is ever
    // infinite.
    void times_drive(Quotient& q, const Ball& tangential, const auto& /*drive_ has it*/) const {
      const DriveResponse drive = of.drive_->at(balls);
      q.denominator = of.inertial(drive, balls);
      q.free_numerator = balls.multiply(tangential, drive.deflection);
      q.numerator = balls.add(q.free_numerator, q.denominator);
    }
  };

  static slong precision_for(std::size_t steps) { return static_cast<slong>(2200 * (steps + 4)); }

  Balls arithmetic(slong precision) const {
    Balls balls{{precision}, values_, Ball(), nullptr, problem_->typed.get(), decimals_};
    balls.omega = omega(balls);
    return balls;
  }

  // Of what was given as a frequency 2 pi f, not the double of that.
  Ball omega(const Balls& balls) const {
    const Symbol& symbol = problem_->angular_frequency.symbol;
    const double value = values_.at(symbol);
    const std::optional<TypedNumber>& frequency = problem_->frequency;
    if (!frequency || two_pi * frequency->value != value) return balls.exact(symbol, value);
    Ball turn;
    arb_const_pi(acb_realref(turn.get()), balls.precision);
    return balls.multiply(balls.multiply(Ball(2), turn), balls.exact(*frequency));
  }

  // (K_d - m omega^2) times the deflection.
  Ball inertial(const DriveResponse& drive, const Balls& balls) const {
    if (!problem_->mass) return drive.force;
    return balls.subtract(drive.force,
                          balls.multiply(balls.inertia(problem_->mass->symbol), drive.deflection));
  }

  Problem problem_;
  const Values& values_;  // its
  std::unique_ptr<const DriveInBalls> drive_;
  ReadDecimals* decimals_;
  std::size_t operations_ = 0;  // in expressions of its elements
};

/// The double that every number of the real ball rounds to, if there is one.
double nearest_double(const Ball& ball) {
  return arf_get_d(arb_midref(acb_realref(ball.get())), ARF_RND_NEAR);
}

std::optional<double> unique_double(const Ball& ball) {
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  arb_get_lbound_arf(lower, acb_realref(ball.get()), 2 * 53 + 64);
  arb_get_ubound_arf(upper, acb_realref(ball.get()), 2 * 53 + 64);
  const double low = arf_get_d(lower, ARF_RND_NEAR), high = arf_get_d(upper, ARF_RND_NEAR);
  arf_clear(lower);
  arf_clear(upper);
  return low == high ? std::optional(low) : std::nullopt;
}

// Relative error of a correctly rounded double; a subnormal one is known to half its last place
// only.
double rounding_bound(double value) {
  constexpr double half_ulp = epsilon / 2;
  if (value >= std::numeric_limits<double>::min()) return half_ulp;
  return value == 0 ? 1 : std::numeric_limits<double>::denorm_min() / 2 / value;
}

bool may_be_zero(const Ball& ball) { return acb_contains_zero(ball.get()) != 0; }

CertifiedVelocity at_resonance(const Problem& problem, const Quotient& q) {
  const std::string resonance = problem->mass
                                    ? fmt::format("K_d = {} {}^2", name_in(problem, *problem->mass),
                                                  name_in(problem, problem->angular_frequency))
                                    : "K_d = 0";
  if (may_be_zero(q.prefactor) || may_be_zero(q.free_numerator))
    throw ModelError(
        fmt::format("v* is 0/0: the drive is at resonance ({}) where the numerator of Eq. 24 "
                    "vanishes too",
                    resonance));
  return {infinity, 0, fmt::format("resonance: {}, so that v* is infinite", resonance)};
}

// Of the symbol, relative. Differences of second order err by its square, far below a double.
constexpr slong shift_bits = 128;

// ln of Eq. 24, or of what a shift makes of it.
Ball log_velocity(const Evaluation& evaluation, slong precision, const Shift* shift = nullptr) {
  const Quotient q = evaluation.at(precision, shift);
  const Arithmetic balls{precision};
  const Ball quotient = balls.divide(balls.modulus(q.numerator), balls.modulus(q.denominator));
  Ball result = balls.modulus(balls.multiply(q.prefactor, quotient));
  arb_log(acb_realref(result.get()), acb_realref(result.get()), precision);
  return result;
}

Shift shift_of(const Symbol& symbol, int direction, slong precision) {
  Shift shift{symbol, Ball(direction)};
  acb_mul_2exp_si(shift.factor.get(), shift.factor.get(), -shift_bits);
  shift.factor = Arithmetic{precision}.add(Ball(1), shift.factor);
  return shift;
}

}  // namespace

double certified_log_derivative(const Problem& problem, const Symbol& symbol) {
  check_symbol(problem, symbol);
  const double value = certified_critical_velocity(problem).value;
  if (!(value > 0 && std::isfinite(value)))
    throw ModelError("v* is 0 or infinite, so that it has no relative sensitivity");
  const Evaluation evaluation(problem);
  const slong most = 16 * shift_bits + evaluation.most_precision();
  for (slong precision = 4 * shift_bits; precision <= most; precision *= 2) {
    const Shift up = shift_of(symbol, 1, precision), down = shift_of(symbol, -1, precision);
    Ball change = Arithmetic{precision}.subtract(log_velocity(evaluation, precision, &up),
                                                 log_velocity(evaluation, precision, &down));
    acb_mul_2exp_si(change.get(), change.get(), shift_bits - 1);
    arb_srcptr real = acb_realref(change.get());
    const double middle = arf_get_d(arb_midref(real), ARF_RND_NEAR);
    if (mag_get_d(arb_radref(real)) <= epsilon * std::max(std::abs(middle), epsilon)) return middle;
  }
  throw Bug("the logarithm of a nonzero critical velocity has digits");
}

double certified_difference(const Problem& a, const Problem& b) {
  // Differences down to the smallest double, and some digits of them.
  constexpr slong enough_bits = 4096;
  const Evaluation first(a), second(b);
  for (slong precision = 256; precision <= enough_bits; precision *= 2) {
    const Ball difference = Arithmetic{precision}.subtract(log_velocity(first, precision),
                                                           log_velocity(second, precision));
    if (acb_is_finite(difference.get()) == 0 || acb_contains_zero(difference.get()) != 0) continue;
    const double middle = arf_get_d(arb_midref(acb_realref(difference.get())), ARF_RND_NEAR);
    return std::max(std::abs(middle), std::numeric_limits<double>::denorm_min());
  }
  return 0;
}

namespace {

CertifiedVelocity rounded_correctly(const Evaluation& evaluation, const Problem& problem) {
  const slong most = evaluation.most_precision();
  for (slong precision = 128;; precision = std::min(2 * precision, most)) {
    const Quotient q = evaluation.at(precision);
    if (acb_is_finite(q.prefactor.get()) == 0) {
      if (precision < most) continue;
      return {infinity, 0,
              "resonance: K_m + K_n = m_n omega^2, so that the contact's amplitude is infinite"};
    }
    if (may_be_zero(q.denominator) && evaluation.resonant()) return at_resonance(problem, q);
    const Arithmetic balls{precision};
    const Ball quotient = balls.divide(balls.modulus(q.numerator), balls.modulus(q.denominator));
    const Ball velocity = balls.multiply(q.prefactor, quotient);
    if (const auto value = unique_double(velocity);
        value && !may_be_zero(q.numerator) && !may_be_zero(q.prefactor)) {
      if (std::isinf(*value)) return {infinity, infinity, "v* is above the largest double"};
      return {*value, rounding_bound(*value), {}};
    }
    if (acb_is_zero(q.prefactor.get()) != 0 || (precision == most && may_be_zero(q.numerator)))
      return {0, 0, {}};
    // Half-way between two doubles, as simple numbers may be: both are as near.
    if (precision == most) {
      const double value = nearest_double(velocity);
      return {value, rounding_bound(value), {}};
    }
  }
}

}  // namespace

CertifiedVelocity certified_critical_velocity(const Problem& problem) {
  return rounded_correctly(Evaluation(problem), problem);
}

CertifiedVelocity certified_critical_velocity(const Problem& problem, ReadDecimals& decimals) {
  return rounded_correctly(Evaluation(problem, &decimals), problem);
}

}  // namespace vcrit
