#include "critical/certified.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "base/constants.hpp"
#include "critical/balls.hpp"
#include "critical/drive_response.hpp"
#include "network/reduction.hpp"

namespace vcrit {

namespace {

/// Eq. 24 as prefactor |numerator|/|denominator|, each a ball.
struct Quotient {
  Ball prefactor, numerator, denominator;
};

Ball ratio_ball(const Isotropic& isotropic, const Arithmetic& balls) {
  Ball value(*isotropic.quantity.value);
  if (isotropic.by == Isotropic::By::ratio) return value;
  const Ball above = balls.multiply(Ball(2), balls.subtract(Ball(1), value));
  return balls.divide(above, balls.subtract(Ball(2), value));
}

class Evaluation {
 public:
  explicit Evaluation(const Scene& scene)
      : scene_(scene), values_(values_of(scene)), normal_(reduce(scene.normal)) {
    if (const auto* tangential = std::get_if<Network>(&scene.tangential))
      tangential_ = reduce(*tangential);
    if (has_drive(scene)) drive_ = drive_in_balls(scene);
  }

  Quotient at(slong precision) const {
    Balls balls{{precision}, values_, Ball(values_.at(scene_.angular_frequency.symbol))};
    const Ball outer =
        balls.multiply(balls.of(scene_.coefficient.symbol), balls.of(scene_.amplitude.symbol));
    Quotient q{balls.multiply(outer, balls.omega), Ball(1), Ball(1)};
    if (tangential_) {
      const Ball normal = evaluate(normal_, balls), tangential = evaluate(*tangential_, balls);
      q.prefactor = balls.multiply(q.prefactor, balls.modulus(balls.divide(normal, tangential)));
      if (drive_) put_drive(q, tangential, balls);
    } else {
      const Ball ratio = ratio_ball(std::get<Isotropic>(scene_.tangential), balls);
      q.prefactor = balls.divide(q.prefactor, ratio);
      if (drive_) put_drive(q, balls.multiply(ratio, evaluate(normal_, balls)), balls);
    }
    return q;
  }

  // Enough bits to tell an exact zero of K_d - m omega^2 (or with K_t) from a tiny number: both are
  // quotients of integers after scaling; every operation on doubles adds at most their whole range.
  slong most_precision() const {
    const std::size_t steps = normal_.steps.size() + (tangential_ ? tangential_->steps.size() : 0) +
                              (drive_ ? drive_->steps() : 0);
    return static_cast<slong>(2200 * (steps + 4));
  }

 private:
  // With K_d = force/deflection, both sides of the quotient times the deflection: neither is ever
  // infinite.
  void put_drive(Quotient& q, const Ball& tangential, Balls& balls) const {
    const DriveResponse drive = drive_->at(balls);
    q.denominator = drive.force;
    if (scene_.mass)
      q.denominator = balls.subtract(
          q.denominator, balls.multiply(balls.inertia(scene_.mass->symbol), drive.deflection));
    q.numerator = balls.add(balls.multiply(tangential, drive.deflection), q.denominator);
  }

  const Scene& scene_;
  Values values_;
  Reduction normal_;
  std::optional<Reduction> tangential_;
  std::unique_ptr<const DriveInBalls> drive_;
};

/// The double that every number of the real ball rounds to, if there is one.
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

CertifiedVelocity exact_zeros(const Scene& scene, const Quotient& q) {
  const char* const resonance = scene.mass ? "K_d = m omega^2" : "K_d = 0";
  const bool zero_above = may_be_zero(q.prefactor) || may_be_zero(q.numerator);
  if (may_be_zero(q.denominator) && zero_above)
    throw ModelError(
        fmt::format("v* is 0/0: the drive is at resonance ({}) where the numerator of Eq. 24 "
                    "vanishes too",
                    resonance));
  if (may_be_zero(q.denominator))
    return {infinity, 0, fmt::format("resonance: {}, so that v* is infinite", resonance)};
  return {0, 0, {}};
}

}  // namespace

CertifiedVelocity certified_critical_velocity(const Scene& scene) {
  const Evaluation evaluation(scene);
  const slong most = evaluation.most_precision();
  for (slong precision = 128;; precision = std::min(2 * precision, most)) {
    const Quotient q = evaluation.at(precision);
    const Arithmetic balls{precision};
    const Ball quotient = balls.divide(balls.modulus(q.numerator), balls.modulus(q.denominator));
    if (const auto value = unique_double(balls.multiply(q.prefactor, quotient));
        value && !may_be_zero(q.numerator) && !may_be_zero(q.prefactor)) {
      if (std::isinf(*value)) return {infinity, infinity, "v* is above the largest double"};
      return {*value, rounding_bound(*value), {}};
    }
    const bool zero =
        may_be_zero(q.prefactor) || may_be_zero(q.numerator) || may_be_zero(q.denominator);
    if (precision == most && zero) return exact_zeros(scene, q);
    ensure(precision < most,
           "a nonzero critical velocity rounds uniquely within the precision of its operands");
  }
}

}  // namespace vcrit
