#include "network/foster.hpp"

#include <arb.h>
#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/numbers.hpp"
#include "network/real_roots.hpp"

namespace vcrit {

namespace {

constexpr slong digits_of_elements = 60;
constexpr slong first_precision = 256;  // bits: those digits, and some to decide signs

const char* const springs_and_dampers =
    "poles on the negative real axis, each once, as springs and dampers have";

/// A real ball that frees itself.
class RealBall {
 public:
  RealBall() { arb_init(x_); }
  RealBall(const RealBall& other) : RealBall() { arb_set(x_, other.x_); }
  RealBall(RealBall&& other) noexcept : RealBall() { arb_swap(x_, other.x_); }
  RealBall& operator=(RealBall other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~RealBall() { arb_clear(x_); }
  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }

 private:
  arb_t x_{};
};

std::string shown(const RealBall& ball, slong digits) {
  const std::unique_ptr<char, void (*)(void*)> text(
      arb_get_str(ball.get(), digits, ARB_STR_NO_RADIUS), flint_free);
  return text.get();
}

/// To six digits, as people write it.
std::string short_number(const RealBall& ball) {
  return fmt::format("{:.6g}", arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR));
}

std::optional<TypedNumber> element_value(const RealBall& ball) {
  std::string decimal = shown(ball, digits_of_elements);
  const auto value = to_double(decimal);
  if (!value || !std::isnormal(*value)) return std::nullopt;
  return TypedNumber{*value, std::move(decimal)};
}

RealBall ball_of(const ExactPolynomial& polynomial, slong power, slong precision) {
  RealBall ball;
  fmpq_t coefficient;
  fmpq_init(coefficient);
  fmpq_poly_get_coeff_fmpq(coefficient, polynomial.raw(), power);
  arb_set_fmpq(ball.get(), coefficient, precision);
  fmpq_clear(coefficient);
  return ball;
}

RealBall quotient(const RealBall& a, const RealBall& b, slong precision) {
  RealBall c;
  arb_div(c.get(), a.get(), b.get(), precision);
  return c;
}

/// An integer polynomial that frees itself: of the poles, with x = -s.
class PolePolynomial {
 public:
  explicit PolePolynomial(const ExactPolynomial& below) {
    fmpz_poly_init(integers_);
    fmpq_poly_get_numerator(integers_, below.raw());
    fmpz_poly_primitive_part(integers_, integers_);
    for (slong i = 1; i < integers_->length; i += 2)
      fmpz_neg(integers_->coeffs + i, integers_->coeffs + i);
  }
  PolePolynomial(const PolePolynomial&) = delete;
  PolePolynomial& operator=(const PolePolynomial&) = delete;
  ~PolePolynomial() { fmpz_poly_clear(integers_); }

  bool has_simple_roots() const { return fmpz_poly_is_squarefree(integers_) != 0; }
  const fmpz_poly_struct* get() const { return integers_; }

 private:
  fmpz_poly_t integers_;
};

/// sum_i coefficient_i x^i, of the polynomial or its derivative.
RealBall polynomial_at(const ExactPolynomial& polynomial, const RealBall& x, slong precision) {
  RealBall sum;
  for (slong i = polynomial.degree(); i >= 0; --i) {
    arb_mul(sum.get(), sum.get(), x.get(), precision);
    const RealBall coefficient = ball_of(polynomial, i, precision);
    arb_add(sum.get(), sum.get(), coefficient.get(), precision);
  }
  return sum;
}

struct Branch {
  RealBall stiffness, pole;
};

class Foster {
 public:
  Foster(const RationalFunction& stiffness, std::string name)
      : k_(stiffness.reduced()), pole_polynomial_(k_.below), name_(std::move(name)) {
    fmpq_poly_derivative(slope_.raw(), k_.below.raw());
  }

  std::variant<FosterForm, NoFosterForm> form() {
    if (auto none = not_of_that_form()) return *std::move(none);
    for (slong precision = first_precision; !signs_known(precision);) precision *= 2;
    if (auto none = element_below_zero()) return *std::move(none);
    return elements();
  }

 private:
  std::optional<NoFosterForm> not_of_that_form() {
    if (k_.above.is_zero()) return NoFosterForm{"K(s) = 0", "a stiffness other than 0"};
    const slong excess = k_.above.degree() - k_.below.degree();
    if (excess > 1)
      return NoFosterForm{fmt::format("K(s) that grows as s^{}", excess),
                          "a numerator of at most one degree more than the denominator",
                          "s alone is a damper; masses stand in a [drive] as mass(m)"};
    if (coefficient_sign(k_.below, 0) == 0)
      return NoFosterForm{"a pole at s = 0", springs_and_dampers, "K(0) is the stiffness at rest"};
    if (!pole_polynomial_.has_simple_roots())
      return NoFosterForm{"a pole of K(s) that is repeated", springs_and_dampers};
    const PositiveRoots poles(pole_polynomial_.get());
    auto isolated = poles.isolated();
    if (!isolated)
      return NoFosterForm{"poles that agree in more than 100 digits",
                          "poles that are farther apart"};
    poles_ = *std::move(isolated);
    const auto count = static_cast<slong>(poles_.size());
    if (const slong off = k_.below.degree() - count; off > 0)
      return NoFosterForm{fmt::format("{} of the {} poles of K(s) off the negative real axis", off,
                                      k_.below.degree()),
                          springs_and_dampers};
    return std::nullopt;
  }

  // K/s = k0/s + c + sum k_j/(s - p_j): the residues k_j = N(p_j)/(p_j D'(p_j)), none of them 0.
  bool signs_known(slong precision) {
    branches_.clear();
    const PositiveRoots poles(pole_polynomial_.get());
    for (RootInterval& interval : poles_) {
      poles.refine(interval, precision);
      Branch branch;
      arb_set_interval_arf(branch.pole.get(), interval.low.get(), interval.high.get(),
                           precision + 32);
      arb_neg(branch.pole.get(), branch.pole.get());
      RealBall below = polynomial_at(slope_, branch.pole, precision);
      arb_mul(below.get(), below.get(), branch.pole.get(), precision);
      branch.stiffness =
          quotient(polynomial_at(k_.above, branch.pole, precision), below, precision);
      if (arb_rel_accuracy_bits(branch.stiffness.get()) < first_precision - 32) return false;
      branches_.push_back(std::move(branch));
    }
    std::sort(branches_.begin(), branches_.end(), [](const Branch& a, const Branch& b) {
      return arf_cmp(arb_midref(a.pole.get()), arb_midref(b.pole.get())) > 0;
    });
    return true;
  }

  std::optional<NoFosterForm> element_below_zero() const {
    const char* const positive = "springs and dampers above 0";
    const char* const passive =
        "no network of springs and dampers has this K(s): check the signs of its coefficients, or "
        "fit a Prony series to the data (vcrit fit)";
    if (coefficient_sign(k_.above, 0) * coefficient_sign(k_.below, 0) < 0)
      return NoFosterForm{fmt::format("the stiffness {} at rest", short_number(at_rest())),
                          positive, passive};
    if (has_dashpot() && arb_is_negative(dashpot().get()) != 0)
      return NoFosterForm{fmt::format("K(s) = {} s at high frequency", short_number(dashpot())),
                          positive, passive};
    for (const Branch& branch : branches_)
      if (arb_is_negative(branch.stiffness.get()) != 0)
        return NoFosterForm{fmt::format("the pole s = {} rad/s, a Maxwell branch of stiffness {}",
                                        short_number(branch.pole), short_number(branch.stiffness)),
                            positive, passive};
    return std::nullopt;
  }

  RealBall at_rest() const {
    return quotient(ball_of(k_.above, 0, first_precision), ball_of(k_.below, 0, first_precision),
                    first_precision);
  }

  bool has_dashpot() const { return k_.above.degree() > k_.below.degree(); }
  RealBall dashpot() const {
    return quotient(ball_of(k_.above, k_.above.degree(), first_precision),
                    ball_of(k_.below, k_.below.degree(), first_precision), first_precision);
  }

  std::variant<FosterForm, NoFosterForm> elements() {
    std::vector<Network> parts;
    if (coefficient_sign(k_.above, 0) != 0) {
      parts.push_back(spring("k0_" + name_));
      give({"k0_" + name_}, at_rest());
    }
    if (has_dashpot()) {
      parts.push_back(damper("c_" + name_));
      give({"c_" + name_}, dashpot());
    }
    RealBall minus_one;
    arb_set_si(minus_one.get(), -1);
    for (int j = 1; const Branch& branch : branches_) {
      parts.push_back(maxwell({"k_" + name_, j}, {"tau_" + name_, j}));
      give({"k_" + name_, j}, branch.stiffness);
      give({"tau_" + name_, j}, quotient(minus_one, branch.pole, 2 * first_precision));
      ++j;
    }
    if (beyond_) return *beyond_;
    form_.network = parallel(std::move(parts));
    return std::move(form_);
  }

  void give(Symbol symbol, const RealBall& ball) {
    if (auto value = element_value(ball))
      form_.values.emplace_back(std::move(symbol), *std::move(value));
    else
      beyond_ = NoFosterForm{fmt::format("an element {} = {}", to_text(symbol), shown(ball, 6)),
                             "elements that doubles can hold"};
  }

  static int coefficient_sign(const ExactPolynomial& polynomial, slong power) {
    return arb_sgn_nonzero(ball_of(polynomial, power, first_precision).get());
  }

  RationalFunction k_;  // without common factors
  ExactPolynomial slope_;
  PolePolynomial pole_polynomial_;
  std::vector<RootInterval> poles_;  // of -s
  std::string name_;
  std::vector<Branch> branches_;
  FosterForm form_;
  std::optional<NoFosterForm> beyond_;
};

}  // namespace

std::variant<FosterForm, NoFosterForm> foster_form(const RationalFunction& stiffness,
                                                   const std::string& name) {
  return Foster(stiffness, name).form();
}

std::optional<TypedNumber> quotient_value(const std::string& a, const std::string& b) {
  RealBall above, below;
  arb_set_str(above.get(), a.c_str(), first_precision);
  arb_set_str(below.get(), b.c_str(), first_precision);
  return element_value(quotient(above, below, first_precision));
}

}  // namespace vcrit
