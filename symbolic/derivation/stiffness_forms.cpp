#include "derivation/stiffness_forms.hpp"

#include "derivation/leading_reduction.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "polynomial/symbol_ring.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

/// Exponents of symbols, that of omega at hand.
class GrowthRates {
 public:
  explicit GrowthRates(const GrowthExponents& rates) : rates_(rates), frequency_(of({"omega"})) {}
  int of(const Symbol& symbol) const {
    const auto found = rates_.find(symbol);
    return found == rates_.end() ? 0 : found->second;
  }
  int frequency() const { return frequency_; }

 private:
  const GrowthExponents& rates_;
  int frequency_;
};

/// Runs `Base` on leading terms.
template <class Base>
struct LeadingAlgebra {
  using Value = Leading<typename Base::Value>;
  Base base;
  GrowthRates rates;

  Value of(const Symbol& symbol) const { return {rates.of(symbol), base.of(symbol)}; }
  Value constant(const TypedNumber& number) const { return {0, base.constant(number)}; }
  Value plus(const Value& a, const Value& b) const {
    if (a.power != b.power) return a.power > b.power ? a : b;
    return {a.power, base.plus(a.value, b.value)};
  }
  Value times(const Value& a, const Value& b) const {
    return {a.power + b.power, base.multiply(a.value, b.value)};
  }
  Value over(const Value& a, const Value& b) const {
    return {a.power - b.power, base.over(a.value, b.value)};
  }
  Value times_s(const Value& k) const {
    return {k.power + rates.frequency(), base.times_s(k.value)};
  }
  Value relaxing(const Value& k, const Value& tau) const {
    const int slow = tau.power + rates.frequency();
    if (slow > 0) return k;
    if (slow < 0) return {k.power + slow, base.times_s(base.multiply(k.value, tau.value))};
    return {k.power, base.relaxing(k.value, tau.value)};
  }
  Value lossy(const Value& k, const Value& eta) const {
    if (eta.power < 0) return k;
    if (eta.power > 0) return {k.power + eta.power, base.loss(k.value, eta.value)};
    return {k.power, base.lossy(k.value, eta.value)};
  }
  Value parallel(const Value& a, const Value& b) {
    base.next_step();
    if (a.power != b.power) return a.power > b.power ? a : b;
    return {a.power, base.parallel(a.value, b.value)};
  }
  Value series(const Value& a, const Value& b) {
    base.next_step();
    if (a.power != b.power) return a.power < b.power ? a : b;
    return {a.power, base.series(a.value, b.value)};
  }
  Value mesh(const Value& a, const Value& b, const Value& total) {
    base.next_step();
    return {a.power + b.power - total.power, base.mesh(a.value, b.value, total.value)};
  }
};

struct Fractions {
  using Value = Fraction;
  void next_step() const {}
  static Value of(const Symbol& name) { return {symbol(name), 1}; }
  static Value constant(const TypedNumber& number) {
    const GiNaC::numeric exact = exact_decimal(number.decimal);
    return {exact.numer(), exact.denom()};
  }
  static Value plus(const Value& a, const Value& b) { return parallel(a, b); }
  static Value multiply(const Value& a, const Value& b) {
    return {(a.numerator * b.numerator).expand(), (a.denominator * b.denominator).expand()};
  }
  static Value over(const Value& a, const Value& b) {
    return multiply(a, {b.denominator, b.numerator});
  }
  static Value times_s(const Value& k) {
    return {(k.numerator * laplace()).expand(), k.denominator};
  }
  static Value relaxing(const Value& k, const Value& tau) {
    const ex turn = tau.numerator * laplace();
    return {(k.numerator * turn).expand(), (k.denominator * (tau.denominator + turn)).expand()};
  }
  // With s/omega for i: what follows knows polynomials in s with real coefficients.
  static Value loss(const Value& k, const Value& eta) {
    return {(k.numerator * eta.numerator * laplace()).expand(),
            (k.denominator * eta.denominator * omega()).expand()};
  }
  static Value lossy(const Value& k, const Value& eta) {
    return {(k.numerator * (eta.denominator * omega() + eta.numerator * laplace())).expand(),
            (k.denominator * eta.denominator * omega()).expand()};
  }
  static Value parallel(const Value& a, const Value& b) {
    return {(a.numerator * b.denominator + b.numerator * a.denominator).expand(),
            (a.denominator * b.denominator).expand()};
  }
  static Value series(const Value& a, const Value& b) {
    return {(a.numerator * b.numerator).expand(),
            (a.numerator * b.denominator + b.numerator * a.denominator).expand()};
  }
  static Value mesh(const Value& a, const Value& b, const Value& total) {
    const Value whole{(a.numerator * b.numerator * total.denominator).expand(),
                      (a.denominator * b.denominator * total.numerator).expand()};
    const CommonFactor common = common_factor(whole.numerator, whole.denominator);
    return {common.a_left, common.b_left};
  }
};

struct Counts {
  using Value = TermCount;
  void next_step() const {}
  static Value of(const Symbol&) { return {1, 1}; }
  static Value constant(const TypedNumber&) { return {1, 1}; }
  static Value plus(const Value& a, const Value& b) { return parallel(a, b); }
  static Value multiply(const Value& a, const Value& b) {
    return {a.numerator * b.numerator, a.denominator * b.denominator};
  }
  static Value over(const Value& a, const Value& b) {
    return multiply(a, {b.denominator, b.numerator});
  }
  static Value times_s(const Value& k) { return k; }
  static Value relaxing(const Value& k, const Value& tau) {
    return {k.numerator * tau.numerator, k.denominator * (tau.denominator + tau.numerator)};
  }
  static Value loss(const Value& k, const Value& eta) { return multiply(k, eta); }
  static Value lossy(const Value& k, const Value& eta) {
    return {k.numerator * (eta.denominator + eta.numerator), k.denominator * eta.denominator};
  }
  static Value parallel(const Value& a, const Value& b) {
    return {a.numerator * b.denominator + b.numerator * a.denominator,
            a.denominator * b.denominator};
  }
  static Value series(const Value& a, const Value& b) {
    return {a.numerator * b.numerator, a.numerator * b.denominator + b.numerator * a.denominator};
  }
  static Value mesh(const Value& a, const Value& b, const Value& total) {
    return {a.numerator * b.numerator * total.denominator,
            a.denominator * b.denominator * total.numerator};
  }
};

/// The reduction written as nested fractions; a result is named when it is used more than once, or
/// when it is the end of a chain too long to read.
class Nested {
 public:
  struct Value {
    ex k;
    int size = 1;       ///< elements in it since the last name
    ex compliance = 0;  ///< of what is one behind the other, as a sum; else 0
    bool lone = true;   ///< an element without a fraction, or a name
  };

  Nested(const Reduction& reduction, std::vector<Line>& definitions)
      : uses_(reduction.steps.size()), definitions_(definitions) {
    for (const Step& step : reduction.steps) {
      if (step.kind == Step::Kind::element) continue;
      ++uses_[step.a];
      ++uses_[step.b];
      if (step.kind == Step::Kind::mesh) ++uses_[step.total];
      combining_.push_back(static_cast<std::size_t>(&step - reduction.steps.data()));
    }
  }

  void next_step() { step_ = combining_[next_++]; }
  static Value of(const Symbol& name) { return {symbol(name), 1}; }
  static Value constant(const TypedNumber& number) { return {exact_decimal(number.decimal), 1}; }
  static Value plus(const Value& a, const Value& b) { return {a.k + b.k, 1}; }
  static Value multiply(const Value& a, const Value& b) { return {a.k * b.k, 1}; }
  static Value over(const Value& a, const Value& b) { return {a.k / b.k, 1}; }
  static Value times_s(const Value& k) { return {k.k * laplace(), 1}; }
  static Value relaxing(const Value& k, const Value& tau) {
    const ex turn = tau.k * laplace();
    return {k.k * turn / (1 + turn), 1, 0, false};
  }
  static Value loss(const Value& k, const Value& eta) { return {GiNaC::I * k.k * eta.k, 1}; }
  static Value lossy(const Value& k, const Value& eta) { return {k.k * (1 + GiNaC::I * eta.k), 1}; }
  Value parallel(const Value& a, const Value& b) {
    return named({a.k + b.k, a.size + b.size, 0, false}, 24);
  }
  /// Two elements as a b/(a + b), more by their compliances.
  Value series(const Value& a, const Value& b) {
    const ex compliance = softness(a) + softness(b);
    const bool two = a.lone && b.lone;
    return named(
        {two ? a.k * b.k / (a.k + b.k) : 1 / compliance, a.size + b.size, compliance, false}, 6);
  }
  Value mesh(const Value& a, const Value& b, const Value& total) {
    return named({a.k * b.k / total.k, a.size + b.size + total.size, 0, false}, 6);
  }

 private:
  static ex softness(const Value& value) {
    return value.compliance.is_zero() ? 1 / value.k : value.compliance;
  }

  Value named(const Value& value, int readable) {
    if (uses_[step_] < 2 && (value.size <= readable || uses_[step_] == 0)) return value;
    const ex name = quantity("K_" + std::to_string(definitions_.size() + 1));
    definitions_.push_back({"", name, value.k});
    return {name, 1};
  }

  std::vector<int> uses_;
  std::vector<std::size_t> combining_;
  std::vector<Line>& definitions_;
  std::size_t next_ = 0, step_ = 0;
};

template <class Base>
Leading<typename Base::Value> run(const Reduction& reduction, const GrowthExponents& rates,
                                  Base base) {
  LeadingAlgebra<Base> algebra{std::move(base), GrowthRates(rates)};
  return evaluate(reduction, algebra);
}

Reduction leading(const Reduction& reduction, const GrowthExponents& rates) {
  if (rates.empty()) return reduction;
  LeadingAlgebra<Counts> algebra{{}, GrowthRates(rates)};
  return leading_reduction(reduction,
                           [&](const Element& element) { return law(element, algebra).power; });
}

}  // namespace

Leading<Fraction> fraction(const Reduction& reduction, const GrowthExponents& rates) {
  const AlgebraLock lock;
  Leading<Fraction> k = run(leading(reduction, rates), rates, Fractions{});
  Fraction left;
  GiNaC::gcd(k.value.numerator, k.value.denominator, &left.numerator, &left.denominator);
  return {k.power, {left.numerator.expand(), left.denominator.expand()}};
}

Leading<TermCount> term_count(const Reduction& reduction, const GrowthExponents& rates) {
  const AlgebraLock lock;
  return run(leading(reduction, rates), rates, Counts{});
}

Leading<GiNaC::ex> nested(const Reduction& reduction, const GrowthExponents& rates,
                          std::vector<Line>& definitions) {
  const AlgebraLock lock;
  const Reduction left = leading(reduction, rates);
  const auto k = run(left, rates, Nested(left, definitions));
  return {k.power, k.value.k};
}

}  // namespace vcrit::symbolic
