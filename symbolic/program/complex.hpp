// Complex numbers in a Program, at one omega or as polynomials in i omega. A component that is the
// constant 0 costs nothing.
#pragma once

#include <utility>
#include <vector>

#include "program/program.hpp"

namespace vcrit::symbolic {

struct ComplexNode {
  NodeId re = 0, im = 0;
  std::vector<NodeId> coefficients =
      {};  ///< of 1, i omega, ...: then a polynomial, without re and im
};

/// A sum of products and, for an error bound, how it was rounded: each component errs by at most
/// `roundings` roundings of the sum of its terms' absolute values.
struct ComplexSum {
  ComplexNode value;
  int roundings = 0;
};

ComplexNode real(Program& program, NodeId re);
ComplexNode polynomial(std::vector<NodeId> coefficients);
/// The value of a polynomial by Horner's rule in omega^2, even and odd powers apart.
ComplexNode at(Program& program, const ComplexNode& polynomial, NodeId omega);
bool is_one(const Program& program, const ComplexNode& z);
ComplexSum sum_of_products(Program& program,
                           const std::vector<std::pair<ComplexNode, ComplexNode>>& products);
ComplexNode real_multiple(Program& program, NodeId factor, const ComplexNode& z);

/// |z|^2.
NodeId square(Program& program, const ComplexNode& z);
/// |re| + |im|, from |z| to sqrt(2) |z|, as a bound.
NodeId size_bound(Program& program, const ComplexNode& z);

}  // namespace vcrit::symbolic
