// A network's dynamic stiffness as K = T/Q with complex T and Q, without any division:
//   spring k/1, damper i w c/1, Maxwell branch i x k/(1 + i x) with x = w tau,
//   parallel (T1 Q2 + T2 Q1)/(Q1 Q2), series T1 T2/(T1 Q2 + T2 Q1).
// A graph that these do not reduce is taken apart at an edge e (K is a quotient of sums over
// spanning trees, which hold e or do not):
//   T = Q_e T(G without e) + T_e T(G with the ends of e joined), and Q likewise.
// Where that grows too long: star-mesh elimination with quotients, Q = 1.
//
// Error bound. K's of springs and dampers lie in the first quadrant, so that |K1| + |K2| <=
// sqrt(2) |K1 + K2|: no sum above loses digits, measured by its absolute value. A step whose sums
// err by `local` roundings of their own size changes the K of that part of the network by that
// much; as K = sum |T_j|^2 z_j over the elements (T_j: deformation ratio), dK/dz = T_z^2 for any
// part z (Tellegen) and sum |T_j|^2 |z_j| <= sqrt(2) |K|, the error of K is at most
//   sqrt(2) |K| max over the paths from K to an element of (sum of `local` on the path).
// After star-mesh elimination edges may leave the first quadrant; there the bound is carried along
// at run time, step by step.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "network/network.hpp"
#include "program/complex.hpp"
#include "program/range.hpp"

namespace vcrit::symbolic {

/// `expression`, a bound, has to lie between 2^-exponent and 2^exponent.
struct Guard {
  NodeId expression;
  int exponent;
};

struct Stiffness {
  ComplexNode t, q;  ///< K = t/q
  ExponentRange t_range, q_range, range;
  int path = 0;                     ///< roundings on the longest path
  std::optional<NodeId> roundings;  ///< those of meshes, known at run time, on top of `path`
  bool exact_re = false;            ///< q = 1, Re t as it was given, and Im t nearly so
  ExponentRange elements;           ///< of the elements' |K|
  int count = 1;                    ///< of elements
};

/// That of any network of such elements: from 1/n of the softest to n times the stiffest, and
/// sqrt(2) for the complex sums.
ExponentRange network_range(ExponentRange elements, int count);

/// The error of K as a bound, in roundings of |K|.
NodeId roundings(Program& program, const Stiffness& k);

class StiffnessWriter {
 public:
  /// Of an element: its value, its absolute value as a bound, and its error in roundings.
  struct ElementNumber {
    NodeId value, size;
    int roundings = 0;
  };

  /// Elements lie within 2^-exponent to 2^exponent or are 0, as the guards will check. `value`
  /// gives an element's number: a parameter or a constant.
  StiffnessWriter(Program& program, NodeId omega, int exponent,
                  std::function<NodeId(const Symbol&)> value, Zeros zeros = Zeros::out_of_range)
      : program_(program),
        omega_(omega),
        exponent_(exponent),
        value_(std::move(value)),
        zeros_(zeros) {}
  StiffnessWriter(const StiffnessWriter&) = delete;
  StiffnessWriter& operator=(const StiffnessWriter&) = delete;

  Stiffness write(const Network& network);
  /// The coefficient of an element, a mass for instance.
  ElementNumber number(const Element& element);
  /// With polynomials in i omega for T and Q, whose coefficients do not depend on omega. They are
  /// positive and the roots are real and negative, so that the terms' absolute values add up to at
  /// most 2^(n/2) times the polynomial's. Guards are of the parameters as they are, ranges those of
  /// ordinary devices.
  /// Nothing for a graph that needs too many spanning trees, nor for more than `longest`
  /// coefficients.
  std::optional<Stiffness> write_polynomials(const Network& network, std::size_t longest);
  /// T and Q times a common power of two that brings the larger one near 1.
  Stiffness normalised(const Stiffness& k);
  /// The range of an expression that is checked or, a constant, known.
  ExponentRange guarded(NodeId size);

  const std::vector<Guard>& guards() const { return guards_; }

 private:
  using Combine = Stiffness (StiffnessWriter::*)(Stiffness, Stiffness);
  Stiffness fold(std::span<const Network> parts, Combine combine);
  Stiffness element(const Element& element);
  Stiffness polynomial_element(const Element& element);
  Stiffness relaxing_element(const ElementNumber& k, const ElementNumber& tau);
  static void join_elements(Stiffness& whole, const Stiffness& a, const Stiffness& b);
  Stiffness parallel(Stiffness a, Stiffness b);
  Stiffness series(Stiffness a, Stiffness b);
  Stiffness graph(const Graph& graph);
  bool is_too_long(const Stiffness& k) const;
  Stiffness no_polynomials();
  Stiffness meshed(const Graph& graph, const std::vector<Stiffness>& parts);
  std::optional<NodeId> sum_of_roundings(const Stiffness& a, const Stiffness& b);
  void fit_products(Stiffness& a, Stiffness& b);

  Program& program_;
  NodeId omega_;
  int exponent_;
  std::function<NodeId(const Symbol&)> value_;
  Zeros zeros_;
  std::vector<Guard> guards_;
  std::function<void(NodeId)> guard_ = [this](NodeId size) { guarded(size); };
  bool polynomials_ = false;
  std::size_t longest_ = 0;  ///< of polynomials
};

}  // namespace vcrit::symbolic
