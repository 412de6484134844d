#include "analysis/logarithmic.hpp"

#include <utility>
#include <vector>

#include "derivation/factors.hpp"
#include "formula/text.hpp"
#include "polynomial/symbol_ring.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

struct Power {
  ex base;
  GiNaC::numeric exponent;
};

/// |f| and f have one logarithmic derivative; numbers have none.
void flatten(const ex& f, const GiNaC::numeric& exponent, std::vector<Power>& powers) {
  if (GiNaC::is_a<GiNaC::numeric>(f)) return;
  if (GiNaC::is_a<GiNaC::mul>(f)) {
    for (const ex& factor : f) flatten(factor, exponent, powers);
  } else if (GiNaC::is_a<GiNaC::power>(f)) {
    flatten(f.op(0), exponent * GiNaC::ex_to<GiNaC::numeric>(f.op(1)), powers);
  } else if (GiNaC::is_a<GiNaC::function>(f)) {
    flatten(f.op(0), exponent, powers);
  } else {
    powers.push_back({f, exponent});
  }
}

std::size_t terms(const ex& polynomial) {
  return GiNaC::is_a<GiNaC::add>(polynomial) ? polynomial.nops() : 1;
}

/// sum of exponent x f'/f over the powers that depend on x, over one denominator.
class LogarithmicSum {
 public:
  LogarithmicSum(ex x, const std::vector<Line>& letters) : x_(std::move(x)), letters_(letters) {}

  void add(const Power& power) {
    const ex slope = (x_ * slope_of(power.base)).expand();
    if (slope.is_zero()) return;
    if (power.base.is_equal(x_)) {
      numerator_ += power.exponent * product_;
      return;
    }
    const ex base = power.base.expand();
    numerator_ = numerator_ * base + power.exponent * slope * product_;
    product_ *= base;
    bases_.push_back({power.base, base});
  }

  void add(const LogarithmicSum& other) {
    numerator_ = numerator_ * other.product_ + other.numerator_ * product_;
    product_ *= other.product_;
    bases_.insert(bases_.end(), other.bases_.begin(), other.bases_.end());
  }

  /// How many terms there are before like ones are put together.
  double size() const {
    double size = 1;
    for (const auto& [base, expanded] : bases_) size *= static_cast<double>(terms(expanded));
    return size;
  }

  ex numerator() const { return numerator_.expand(); }

  ex value() const {
    Factors over;
    ex rest = numerator(), under = 1;
    for (const auto& [base, expanded] : bases_) {
      const CommonFactor shared = common_factor(rest, expanded);
      if (GiNaC::is_a<GiNaC::numeric>(shared.common)) {
        under *= base;
        continue;
      }
      rest = shared.a_left;
      over.multiply(shared.b_left, -1);
    }
    over.multiply(rest, 1);
    over.cancel();
    return over.value() / under;
  }

 private:
  ex slope_of(const ex& base) const {
    const auto& x = GiNaC::ex_to<GiNaC::symbol>(x_);
    ex slope = base.diff(x);
    for (const Line& letter : letters_)
      slope += base.diff(GiNaC::ex_to<GiNaC::symbol>(letter.left)) * letter.right.diff(x);
    return slope;
  }

  ex x_, numerator_ = 0, product_ = 1;
  std::vector<std::pair<ex, ex>> bases_;  ///< as they are, and expanded
  const std::vector<Line>& letters_;
};

// Longer ones are not worth the time, as nobody reads them.
constexpr double quick = 3000;
constexpr std::size_t readable_derivative_terms = 40;
constexpr std::size_t readable_derivative_text = 600;

}  // namespace

std::optional<ex> logarithmic_derivative(const ex& f, const ex& x,
                                         const std::vector<Line>& letters) {
  std::vector<Power> powers;
  flatten(f, 1, powers);
  LogarithmicSum whole(x, letters);
  ex sum = 0;
  for (const Power& power : powers) {
    LogarithmicSum alone(x, letters);
    alone.add(power);
    whole.add(alone);
    if (terms(alone.numerator()) > readable_derivative_terms) return std::nullopt;
    sum += alone.value();
  }
  const std::size_t length = to_text(sum).size();
  if (length > readable_derivative_text) return std::nullopt;
  if (whole.size() <= quick && terms(whole.numerator()) <= readable_derivative_terms)
    if (const ex one = whole.value(); 2 * to_text(one).size() <= 3 * length) return one;
  return sum;
}

}  // namespace vcrit::symbolic
