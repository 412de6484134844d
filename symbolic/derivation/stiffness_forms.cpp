#include "derivation/stiffness_forms.hpp"

#include "derivation/leading_reduction.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

/// An element's leading term as coefficient (storage), coefficient * s (loss) or coefficient * s^2
/// (inertia), or a whole Maxwell branch k tau s/(1 + tau s). Written only where it is asked for.
struct ElementForm {
  enum class Kind { storage, loss, inertia, maxwell };
  Kind kind;
  const Element& of;

  /// k, or k tau of a Maxwell branch that is slow.
  ex coefficient() const {
    const ex k = symbol(of.coefficient);
    const bool slow = kind == Kind::loss && of.kind == ElementKind::maxwell;
    return slow ? k * tau() : k;
  }
  ex tau() const { return symbol(of.time); }
};

/// Rates of symbols, that of omega at hand.
class GrowthRates {
 public:
  explicit GrowthRates(const Rates& rates) : rates_(rates), frequency_(of({"omega"})) {}
  int of(const Symbol& symbol) const {
    const auto found = rates_.find(symbol);
    return found == rates_.end() ? 0 : found->second;
  }
  int frequency() const { return frequency_; }

 private:
  const Rates& rates_;
  int frequency_;
};

Leading<ElementForm> leading_element(const Element& element, const GrowthRates& rates) {
  using Kind = ElementForm::Kind;
  const int power = rates.of(element.coefficient);
  const auto form = [&](int degree, Kind kind) {
    return Leading<ElementForm>{degree, {kind, element}};
  };
  if (element.kind == ElementKind::spring) return form(power, Kind::storage);
  if (element.kind == ElementKind::damper) return form(power + rates.frequency(), Kind::loss);
  if (element.kind == ElementKind::mass) return form(power + 2 * rates.frequency(), Kind::inertia);
  const int slow = rates.of(element.time) + rates.frequency();
  if (slow > 0) return form(power, Kind::storage);
  if (slow < 0) return form(power + slow, Kind::loss);
  return form(power, Kind::maxwell);
}

/// Runs `Base` on leading terms.
template <class Base>
struct LeadingAlgebra {
  using Value = Leading<typename Base::Value>;
  Base base;
  GrowthRates rates;

  Value element(const Element& element) {
    const Leading<ElementForm> form = leading_element(element, rates);
    return {form.power, base.element(form.value)};
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
  static Value element(const ElementForm& e) {
    const ex s = laplace();
    switch (e.kind) {
      case ElementForm::Kind::storage:
        return {e.coefficient(), 1};
      case ElementForm::Kind::loss:
        return {(e.coefficient() * s).expand(), 1};
      case ElementForm::Kind::inertia:
        return {(e.coefficient() * s * s).expand(), 1};
      case ElementForm::Kind::maxwell:
        break;
    }
    return {e.coefficient() * e.tau() * s, 1 + e.tau() * s};
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
    Value left;
    GiNaC::gcd(whole.numerator, whole.denominator, &left.numerator, &left.denominator);
    return {left.numerator.expand(), left.denominator.expand()};
  }
};

struct Counts {
  using Value = TermCount;
  void next_step() const {}
  static Value element(const ElementForm& e) {
    return {1, e.kind == ElementForm::Kind::maxwell ? 2.0 : 1.0};
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
    int size = 1;  ///< elements in it since the last name
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
  static Value element(const ElementForm& e) {
    const ex s = laplace();
    switch (e.kind) {
      case ElementForm::Kind::storage:
        return {e.coefficient(), 1};
      case ElementForm::Kind::loss:
        return {e.coefficient() * s, 1};
      case ElementForm::Kind::inertia:
        return {e.coefficient() * s * s, 1};
      case ElementForm::Kind::maxwell:
        break;
    }
    return {e.coefficient() * e.tau() * s / (1 + e.tau() * s), 1};
  }
  Value parallel(const Value& a, const Value& b) { return named({a.k + b.k, a.size + b.size}, 24); }
  Value series(const Value& a, const Value& b) {
    return named({1 / (1 / a.k + 1 / b.k), a.size + b.size}, 6);
  }
  Value mesh(const Value& a, const Value& b, const Value& total) {
    return named({a.k * b.k / total.k, a.size + b.size + total.size}, 6);
  }

 private:
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
Leading<typename Base::Value> run(const Reduction& reduction, const Rates& rates, Base base) {
  LeadingAlgebra<Base> algebra{std::move(base), GrowthRates(rates)};
  return evaluate(reduction, algebra);
}

Reduction leading(const Reduction& reduction, const Rates& rates) {
  if (rates.empty()) return reduction;
  const GrowthRates growth(rates);
  return leading_reduction(
      reduction, [&](const Element& element) { return leading_element(element, growth).power; });
}

}  // namespace

Leading<Fraction> fraction(const Reduction& reduction, const Rates& rates) {
  const AlgebraLock lock;
  Leading<Fraction> k = run(leading(reduction, rates), rates, Fractions{});
  Fraction left;
  GiNaC::gcd(k.value.numerator, k.value.denominator, &left.numerator, &left.denominator);
  return {k.power, {left.numerator.expand(), left.denominator.expand()}};
}

Leading<TermCount> term_count(const Reduction& reduction, const Rates& rates) {
  const AlgebraLock lock;
  return run(leading(reduction, rates), rates, Counts{});
}

Leading<GiNaC::ex> nested(const Reduction& reduction, const Rates& rates,
                          std::vector<Line>& definitions) {
  const AlgebraLock lock;
  const Reduction left = leading(reduction, rates);
  const auto k = run(left, rates, Nested(left, definitions));
  return {k.power, k.value.k};
}

}  // namespace vcrit::symbolic
