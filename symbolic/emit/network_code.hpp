// A network's reduction as straight-line real C++: K = re + i im with re, im >= 0, so that nothing
// cancels in series-parallel parts, and how far rounding can take it.
//
// Error bound. Let every operation of the arithmetic err by at most eps, relative. A step's formula
// then errs by `local` eps of its own result, in norm. Tellegen: K = sum |T_j|^2 z_j over the
// elements, dK/dz = T_z^2 for any subnetwork z, and in the first quadrant sum |T_j|^2 |z_j| <=
// sqrt(2) |K|. As |T_z|^2 |z| <= sum over the elements j in z of |T_j|^2 |z_j|, the error of K is
// at most
//   sqrt(2) |K| eps max over the paths from K to an element of (sum of `local` on the path).
// After star-mesh elimination edges may leave the first quadrant; there the bound is carried along
// at run time, step by step.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "network/reduction.hpp"

namespace vcrit::symbolic {

/// An error bound counted in roundings: a number and C++ expressions (doubles) to be added to it.
struct Roundings {
  int constant = 0;
  std::string variable;
};
Roundings operator+(const Roundings& a, const Roundings& b);
std::string expression(const Roundings& roundings);

/// Straight-line code for one network. Variables are named after a prefix: n1, n2, ...
struct NetworkCode {
  std::vector<std::string> lines;     ///< statements of evaluate<T>(), T the number type
  std::optional<std::string> re, im;  ///< expressions of type T; absent: exactly 0
  Roundings roundings;                ///< |error of K| <= roundings eps |K|
  std::vector<std::string>
      ranges;           ///< expressions that must be neither huge nor tiny for the bound
  int operations = 0;   ///< on numbers of type T
  bool meshed = false;  ///< needs the header's Edge arithmetic
};

/// `symbol` gives the C++ expression (a double) of an element's coefficient or time.
NetworkCode network_code(const Reduction& reduction, const std::string& prefix,
                         const std::function<std::string(const Symbol&)>& symbol);

}  // namespace vcrit::symbolic
