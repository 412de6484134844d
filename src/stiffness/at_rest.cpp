#include "stiffness/at_rest.hpp"

#include "network/law.hpp"
#include "network/reduction.hpp"
#include "network/wiring.hpp"

namespace vcrit {

namespace {

/// The algebra of a reduction in leading terms: sides by side the stiffer one is left, one behind
/// the other the softer.
struct LeadingTerms {
  using Value = AtRest;
  const Values& values;

  AtRest of(const Symbol& symbol) const { return {0, value_of(values, symbol)}; }
  static AtRest constant(const TypedNumber& number) { return {0, number.value}; }
  static AtRest plus(const AtRest& a, const AtRest& b) {
    return {0, a.coefficient + b.coefficient};
  }
  static AtRest times(const AtRest& a, const AtRest& b) {
    return {0, a.coefficient * b.coefficient};
  }
  static AtRest over(const AtRest& a, const AtRest& b) {
    return {0, a.coefficient / b.coefficient};
  }
  static AtRest times_s(const AtRest& k) { return {k.order + 1, k.coefficient}; }
  static AtRest relaxing(const AtRest& k, const AtRest& tau) {
    return {1, k.coefficient * tau.coefficient};
  }
  AtRest element(const Element& e) {
    const auto rest = is_rational(e) ? std::nullopt : vcrit::at_rest(e);
    return law(rest ? *rest : e, *this);
  }
  static AtRest parallel(const AtRest& a, const AtRest& b) {
    if (a.order != b.order) return a.order < b.order ? a : b;
    return {a.order, a.coefficient + b.coefficient};
  }
  static AtRest series(const AtRest& a, const AtRest& b) { return mesh(a, b, parallel(a, b)); }
  static AtRest mesh(const AtRest& a, const AtRest& b, const AtRest& total) {
    return {a.order + b.order - total.order, a.coefficient / total.coefficient * b.coefficient};
  }
};

}  // namespace

AtRest at_rest(const Reduction& reduction, const Values& values) {
  LeadingTerms terms{values};
  return evaluate(reduction, terms);
}

}  // namespace vcrit
