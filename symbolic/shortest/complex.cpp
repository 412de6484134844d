#include "shortest/complex.hpp"

#include <cstdlib>
#include <span>

namespace vcrit::symbolic::shortest {

namespace {

/// A node as factors.
std::vector<Item> factors(const Expressions& all, ExNode node) {
  if (node == 0) return {};
  const std::span<const Item> items = all[node].items;
  if (all[node].kind == ExpressionKind::product) return {items.begin(), items.end()};
  return {{node, 1, {}}};
}

/// What both products have in common.
std::vector<ExPower> common_factors(const Expressions& all, ExNode a, ExNode b) {
  std::vector<ExPower> common;
  for (const Item& x : factors(all, a))
    for (const Item& y : factors(all, b)) {
      if (x.node != y.node || (x.exponent > 0) != (y.exponent > 0)) continue;
      const int exponent = std::abs(x.exponent) < std::abs(y.exponent) ? x.exponent : y.exponent;
      common.push_back({{{}, x.node}, exponent});
    }
  return common;
}

}  // namespace

ComplexEx ComplexAlgebra::add(const ComplexEx& a, const ComplexEx& b) {
  return {all_.add(a.re, b.re), all_.add(a.im, b.im)};
}

ComplexEx ComplexAlgebra::multiply(const ComplexEx& a, const ComplexEx& b) {
  return {all_.subtract(all_.multiply(a.re, b.re), all_.multiply(a.im, b.im)),
          all_.add(all_.multiply(a.re, b.im), all_.multiply(a.im, b.re))};
}

ComplexEx ComplexAlgebra::multiply(const ComplexEx& a, const Ex& real) {
  return {all_.multiply(a.re, real), all_.multiply(a.im, real)};
}

Ex ComplexAlgebra::modulus(const ComplexEx& a) {
  if (a.im.is_zero()) return all_.magnitude(a.re);
  if (a.re.is_zero()) return all_.magnitude(a.im);
  const Ex common = all_.product(common_factors(all_, a.re.node, a.im.node));
  const Ex re = all_.divide(a.re, common), im = all_.divide(a.im, common);
  const Ex square = all_.add(all_.power(re, 2), all_.power(im, 2));
  return all_.multiply(all_.magnitude(common), all_.root(square));
}

ComplexQuotient ComplexAlgebra::cartesian(const ComplexQuotient& a) {
  if (a.under.is_one()) return a;
  if (a.under.is_real()) return {multiply(a.over, all_.power(a.under.re, -1))};
  if (a.under.re.is_zero())
    return {{all_.divide(a.over.im, a.under.im),
             Expressions::negative(all_.divide(a.over.re, a.under.im))}};
  const ComplexEx turned{a.under.re, Expressions::negative(a.under.im)};
  const Ex square = all_.add(all_.power(a.under.re, 2), all_.power(a.under.im, 2));
  return {multiply(multiply(a.over, turned), all_.power(square, -1))};
}

std::vector<ComplexQuotient> ComplexAlgebra::cartesians(const ComplexQuotient& a) {
  std::vector<ComplexQuotient> result{cartesian(a)};
  if (a.under.is_real() || a.under.re.is_zero()) return result;
  const Ex &re = a.under.re, &im = a.under.im, one = Expressions::number(1);
  const Ex slope = all_.divide(im, re), back = all_.divide(re, im);
  const Ex first = all_.add(re, all_.multiply(im, slope));
  const Ex second = all_.add(im, all_.multiply(re, back));
  const ComplexEx turned{one, Expressions::negative(slope)};
  const ComplexEx turned_back{back, Expressions::negative(one)};
  result.push_back({multiply(multiply(a.over, turned), all_.power(first, -1))});
  result.push_back({multiply(multiply(a.over, turned_back), all_.power(second, -1))});
  return result;
}

}  // namespace vcrit::symbolic::shortest
