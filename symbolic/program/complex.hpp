// Complex numbers in a Program, at one omega or as polynomials in i omega. A component that is the
// constant 0 costs nothing.
#pragma once

#include <utility>
#include <vector>

#include "program/program.hpp"

namespace vcrit::symbolic {

struct Complex {
  NodeId re = 0, im = 0;
  std::vector<NodeId> coefficients =
      {};  ///< of 1, i omega, ...: then a polynomial, without re and im
};

/// A sum of products and, for an error bound, how it was rounded: each component errs by at most
/// `roundings` roundings of the sum of its terms' absolute values.
struct ComplexSum {
  Complex value;
  int roundings = 0;
};

Complex real(Program& program, NodeId re);
Complex polynomial(std::vector<NodeId> coefficients);
/// The value of a polynomial by Horner's rule in omega^2, even and odd powers apart.
Complex at(Program& program, const Complex& polynomial, NodeId omega);
bool is_one(const Program& program, const Complex& z);
ComplexSum sum_of_products(Program& program,
                           const std::vector<std::pair<Complex, Complex>>& products);
Complex real_multiple(Program& program, NodeId factor, const Complex& z);

/// |z|^2.
NodeId square(Program& program, const Complex& z);
/// |re| + |im|, from |z| to sqrt(2) |z|, as a bound.
NodeId size_bound(Program& program, const Complex& z);

}  // namespace vcrit::symbolic
