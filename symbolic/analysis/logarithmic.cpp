#include "analysis/logarithmic.hpp"

#include <utility>

#include "base/errors.hpp"
#include "derivation/factors.hpp"
#include "formula/text.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Longer ones are not worth the time, as nobody reads them.
constexpr double quick = 3000;
constexpr std::size_t readable_derivative_terms = 40;
constexpr std::size_t readable_derivative_text = 600;

std::string name_of_symbol(const ex& symbol) {
  return GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
}

std::vector<ex> all_of(const ex& product, const std::vector<Line>& letters) {
  std::vector<ex> all{product};
  for (const Line& letter : letters) all.insert(all.end(), {letter.left, letter.right});
  return all;
}

}  // namespace

/// The sum of exponent x f'/f over powers f^exponent, over one denominator.
class LogarithmicDerivatives::Sum {
 public:
  explicit Sum(const Ring& ring) : twice_(ring, 0), product_(ring, 1) {}

  void add(const PowerSlope& slope) {
    const Polynomial weight(product_.ring(), slope.power->twice);
    if (slope.of_itself) {
      twice_ += weight * product_;
      return;
    }
    twice_ = twice_ * slope.power->polynomial + weight * slope.value * product_;
    product_ *= slope.power->polynomial;
    powers_.push_back(slope.power);
  }

  std::size_t terms() const { return twice_.terms(); }

  ex value(const SymbolRing& symbols) const {
    Factors over;
    over.multiply(GiNaC::numeric(1, 2), 1);
    Polynomial rest = twice_;
    ex under = 1;
    for (const Power* power : powers_) {
      SharedFactor shared = shared_factor(rest, power->polynomial);
      if (shared.factor.is_number()) {
        under *= power->base;
        over.multiply(power->number, 1);
        continue;
      }
      rest = std::move(shared.a_left);
      over.multiply(symbols.sum(shared.b_left), -1);
    }
    over.multiply(symbols.sum(rest), 1);
    over.cancel();
    return over.value() / under;
  }

 private:
  Polynomial twice_, product_;  ///< twice the numerator, and the denominator
  std::vector<const Power*> powers_;
};

LogarithmicDerivatives::LogarithmicDerivatives(const ex& product, const std::vector<Line>& letters)
    : symbols_(all_of(product, letters)) {
  put(product, 1);
  for (const Line& letter : letters)
    letters_.push_back({name_of_symbol(letter.left), symbols_.polynomial(letter.right.expand())});
}

void LogarithmicDerivatives::put(const ex& factor, const GiNaC::numeric& exponent) {
  if (GiNaC::is_a<GiNaC::numeric>(factor)) return;
  if (GiNaC::is_a<GiNaC::mul>(factor)) {
    for (const ex& each : factor) put(each, exponent);
  } else if (GiNaC::is_a<GiNaC::power>(factor)) {
    put(factor.op(0), exponent * GiNaC::ex_to<GiNaC::numeric>(factor.op(1)));
  } else if (GiNaC::is_a<GiNaC::function>(factor)) {
    put(factor.op(0), exponent);
  } else {
    const GiNaC::numeric twice = 2 * exponent;
    ensure(twice.is_integer(), "only square roots occur");
    const WholePolynomial whole = whole_of(factor.expand());
    powers_.push_back({factor, whole.number, symbols_.polynomial(whole.whole), twice.to_long()});
  }
}

Polynomial LogarithmicDerivatives::slope_of(const Polynomial& f, const std::string& x) const {
  Polynomial slope = f.derivative(x);
  for (const Letter& letter : letters_)
    slope += f.derivative(letter.name) * letter.meaning.derivative(x);
  return Polynomial::variable(symbols_.ring(), x) * slope;
}

std::optional<ex> LogarithmicDerivatives::by(const ex& x) const {
  const Ring& ring = symbols_.ring();
  ex sum = 0;
  if (!ring.holds(name_of_symbol(x))) return sum;
  std::vector<PowerSlope> slopes;
  double terms = 1;  // of all together, before like ones are put together
  for (const Power& power : powers_) {
    PowerSlope slope{&power, slope_of(power.polynomial, name_of_symbol(x)), power.base.is_equal(x)};
    if (slope.value.is_zero()) continue;
    Sum alone(ring);
    alone.add(slope);
    if (alone.terms() > readable_derivative_terms) return std::nullopt;
    sum += alone.value(symbols_);
    if (!slope.of_itself) terms *= static_cast<double>(power.polynomial.terms());
    slopes.push_back(std::move(slope));
  }
  const std::size_t length = to_text(sum).size();
  if (length > readable_derivative_text) return std::nullopt;
  if (terms > quick) return sum;
  Sum whole(ring);
  for (const PowerSlope& slope : slopes) whole.add(slope);
  if (whole.terms() > readable_derivative_terms) return sum;
  const ex one = whole.value(symbols_);
  return 2 * to_text(one).size() <= 3 * length ? one : sum;
}

}  // namespace vcrit::symbolic
