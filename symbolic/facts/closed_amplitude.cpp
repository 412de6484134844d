#include "facts/closed_amplitude.hpp"

#include <algorithm>

#include "analysis/residues.hpp"
#include "base/errors.hpp"
#include "derivation/loaded.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/order.hpp"
#include "formula/rational.hpp"
#include "network/law.hpp"
#include "rules/kinds.hpp"
#include "shortest/alphabet.hpp"
#include "shortest/complex.hpp"
#include "shortest/proof.hpp"

namespace vcrit::symbolic {

namespace {

using namespace shortest;

// A bound stands beside v*, so that a tenth of its search has to do.
constexpr SearchEffort bound_effort{20, 500'000};

// Operations of some ten lines.
constexpr int readable_operations = 60;

/// The mean normal force: the load, or u_z0 times K_n(0).
struct Pressed {
  Symbol by;
  GiNaC::ex stiffness;
};

class ClosedAmplitude {
 public:
  ClosedAmplitude(const Problem& problem, const Thrift& thrift)
      : problem_(problem),
        alphabet_(problem),
        all_(alphabet_.expressions()),
        complex_(all_),
        presentations_(alphabet_.presentations(thrift)) {
    alphabet_.mark_letters("_c");
  }

  /// Throws TooLarge.
  FoundForm form(const Pressed& pressed) {
    all_.allow(bound_effort.work);
    const Ex load = all_.multiply(alphabet_.quantity(pressed.by), of(pressed.stiffness));
    std::vector<Ex> starts;
    for (const ComplexQuotient& way : presentations_.of(problem_->normal.network()))
      starts.push_back(all_.divide(load, complex_.modulus(way)));
    all_.allow(2 * bound_effort.work);
    const Ex best = shortest_of(all_, starts, bound_effort);
    if (operations(all_, best) > readable_operations) return {{}, "its formula fits no page"};
    return {alphabet_.written(best), ""};
  }

 private:
  /// A rational function of the elements.
  Ex of(const GiNaC::ex& function) {
    if (GiNaC::is_a<GiNaC::numeric>(function)) {
      const auto& number = GiNaC::ex_to<GiNaC::numeric>(function);
      return Expressions::number(number.numer().to_long(), number.denom().to_long());
    }
    if (GiNaC::is_a<GiNaC::symbol>(function))
      return alphabet_.element(GiNaC::ex_to<GiNaC::symbol>(function).get_name());
    if (GiNaC::is_a<GiNaC::power>(function))
      return all_.power(of(function.op(0)), GiNaC::ex_to<GiNaC::numeric>(function.op(1)).to_int());
    const bool sum = GiNaC::is_a<GiNaC::add>(function);
    ensure(sum || GiNaC::is_a<GiNaC::mul>(function), "rational functions have nothing but + * /");
    Ex result = Expressions::number(sum ? 0 : 1);
    for (const GiNaC::ex& part : in_order_of_text(function))
      result = sum ? all_.add(result, of(part)) : all_.multiply(result, of(part));
    return result;
  }

  Problem problem_;
  Alphabet alphabet_;
  Expressions& all_;
  ComplexAlgebra complex_;
  Presentations presentations_;
};

/// W^2/|K(i omega)|^2 or u_z0^2 K(0)^2/|K(i omega)|^2 at a point.
GaussianResidue square_of_bound(const Problem& problem, const Pressed& pressed,
                                const ResiduePoint& point) {
  NumberAlgebra<GaussianResidue> algebra;
  algebra.point = [&point](const std::string& name) { return GaussianResidue(point(name)); };
  const GaussianResidue load =
      algebra.point(to_text(pressed.by)) * evaluate_rational(pressed.stiffness, algebra);
  algebra.s = GaussianResidue({}, Residue(1)) * algebra.point("omega");
  const GaussianResidue k = evaluate(problem->normal.reduction(), algebra);
  return load * load * inverse(k * conjugate(k));
}

}  // namespace

FoundForm find_closed_amplitude(const Problem& problem) {
  const AlgebraLock lock;
  const bool by_load = rules::load_is_mean_force(problem);
  if (!by_load && !carries_load(problem)) return {{}, "the contact carries no load at rest"};
  const auto at_rest = by_load ? std::optional<GiNaC::ex>(1) : stiffness_at_rest(problem);
  if (!at_rest) return {{}, "its formula fits no page"};
  const Pressed pressed{by_load ? problem->load->symbol : problem->indentation.symbol, *at_rest};
  FoundForm found = first_that_fits(
      [&](const Thrift& thrift) { return ClosedAmplitude(problem, thrift).form(pressed); });
  if (found.form)
    prove_at_points(*found.form, [&](const ResiduePoint& point) {
      return square_of_bound(problem, pressed, point);
    });
  return found;
}

}  // namespace vcrit::symbolic
