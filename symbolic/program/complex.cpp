#include "program/complex.hpp"

#include <algorithm>

namespace vcrit::symbolic {

namespace {

using Product = std::pair<NodeId, NodeId>;

bool is_zero(const Program& program, NodeId id) { return program.is_constant(id, 0); }

/// Terms without a factor first: what follows are multiply_adds.
NodeId sum(Program& program, std::vector<Product> terms, int& roundings) {
  std::erase_if(terms, [&](const Product& t) {
    return is_zero(program, t.first) || is_zero(program, t.second);
  });
  const auto is_product = [&](const Product& t) {
    return !program.is_constant(t.first, 1) && !program.is_constant(t.second, 1) &&
           !program.is_constant(t.first, -1) && !program.is_constant(t.second, -1);
  };
  std::stable_partition(terms.begin(), terms.end(), [&](const auto& t) { return !is_product(t); });
  NodeId whole = program.constant(0);
  for (const auto& [a, b] : terms) whole = program.multiply_add(a, b, whole);
  // A product and each addition round once; what stands first meets all additions.
  const int products = terms.empty() ? 0 : is_product(terms.back()) ? 1 : 0;
  const int additions = terms.empty() ? 0 : static_cast<int>(terms.size()) - 1;
  roundings = std::max(roundings, products + additions);
  return whole;
}

}  // namespace

Complex real(Program& program, NodeId re) { return {re, program.constant(0)}; }

bool is_one(const Program& program, const Complex& z) {
  return program.is_constant(z.re, 1) && is_zero(program, z.im);
}

ComplexSum sum_of_products(Program& program,
                           const std::vector<std::pair<Complex, Complex>>& products) {
  std::vector<Product> re, im;
  for (const auto& [a, b] : products) {
    re.emplace_back(a.re, b.re);
    re.emplace_back(program.negate(a.im), b.im);
    im.emplace_back(a.re, b.im);
    im.emplace_back(a.im, b.re);
  }
  ComplexSum result;
  result.value.re = sum(program, std::move(re), result.roundings);
  result.value.im = sum(program, std::move(im), result.roundings);
  return result;
}

Complex scaled(Program& program, NodeId factor, const Complex& z) {
  return {program.multiply(factor, z.re), program.multiply(factor, z.im)};
}

NodeId square(Program& program, const Complex& z) {
  return program.multiply_add(z.im, z.im, program.multiply(z.re, z.re));
}

NodeId size(Program& program, const Complex& z) {
  return program.add(program.size(z.re), program.size(z.im));
}

}  // namespace vcrit::symbolic
