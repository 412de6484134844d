#include "program/complex.hpp"

#include <algorithm>

namespace vcrit::symbolic {

namespace {

using Product = std::pair<NodeId, NodeId>;

bool is_zero(const Program& program, NodeId id) { return program.is_constant(id, 0); }

/// Terms without a factor first: what follows are multiply_adds.
NodeId sum_of_terms(Program& program, std::vector<Product> terms, int& roundings) {
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

ComplexNode real(Program& program, NodeId re) { return {re, program.constant(0)}; }

ComplexNode polynomial(std::vector<NodeId> coefficients) { return {0, 0, std::move(coefficients)}; }

ComplexNode at(Program& program, const ComplexNode& polynomial, NodeId omega) {
  const std::vector<NodeId>& c = polynomial.coefficients;
  const NodeId minus_square = program.negate(program.multiply(omega, omega));
  const auto horner = [&](std::size_t lowest) {
    NodeId sum = program.constant(0);
    for (std::size_t i = c.size(); i-- > 0;)
      if (i % 2 == lowest) sum = program.multiply_add(minus_square, sum, c[i]);
    return sum;
  };
  return {horner(0), program.multiply(omega, horner(1))};
}

bool is_one(const Program& program, const ComplexNode& z) {
  if (!z.coefficients.empty())
    return z.coefficients.size() == 1 && program.is_constant(z.coefficients[0], 1);
  return program.is_constant(z.re, 1) && is_zero(program, z.im);
}

static ComplexSum sum_of_polynomials(
    Program& program, const std::vector<std::pair<ComplexNode, ComplexNode>>& products) {
  std::vector<std::vector<Product>> terms;
  for (const auto& [a, b] : products)
    for (std::size_t i = 0; i < a.coefficients.size(); ++i)
      for (std::size_t j = 0; j < b.coefficients.size(); ++j) {
        terms.resize(std::max(terms.size(), i + j + 1));
        terms[i + j].emplace_back(a.coefficients[i], b.coefficients[j]);
      }
  ComplexSum result;
  for (std::vector<Product>& coefficient : terms)
    result.value.coefficients.push_back(
        sum_of_terms(program, std::move(coefficient), result.roundings));
  return result;
}

ComplexSum sum_of_products(Program& program,
                           const std::vector<std::pair<ComplexNode, ComplexNode>>& products) {
  if (!products.front().first.coefficients.empty()) return sum_of_polynomials(program, products);
  std::vector<Product> re, im;
  for (const auto& [a, b] : products) {
    re.emplace_back(a.re, b.re);
    re.emplace_back(program.negate(a.im), b.im);
    im.emplace_back(a.re, b.im);
    im.emplace_back(a.im, b.re);
  }
  ComplexSum result;
  result.value.re = sum_of_terms(program, std::move(re), result.roundings);
  result.value.im = sum_of_terms(program, std::move(im), result.roundings);
  return result;
}

ComplexNode real_multiple(Program& program, NodeId factor, const ComplexNode& z) {
  return {program.multiply(factor, z.re), program.multiply(factor, z.im)};
}

NodeId square(Program& program, const ComplexNode& z) {
  return program.multiply_add(z.im, z.im, program.multiply(z.re, z.re));
}

NodeId size_bound(Program& program, const ComplexNode& z) {
  return program.add(program.size(z.re), program.size(z.im));
}

}  // namespace vcrit::symbolic
