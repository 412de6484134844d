#include "normal/quadrature_rules.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace vcrit {

namespace {

template <class Rule>
SymmetricRule rule() {
  return {Rule::abscissa(), Rule::weights()};
}

}  // namespace

SymmetricRule gauss_10() { return rule<boost::math::quadrature::gauss<double, 10>>(); }
SymmetricRule gauss_20() { return rule<boost::math::quadrature::gauss<double, 20>>(); }
SymmetricRule gauss_30() { return rule<boost::math::quadrature::gauss<double, 30>>(); }
SymmetricRule kronrod_21() { return rule<boost::math::quadrature::gauss_kronrod<double, 21>>(); }

}  // namespace vcrit
