// The stiffness of a drive that has no quadrant of its own, K_d = T/Q: one that holds masses, and a
// measured one, whose Q is its receptance. T and Q may each vanish, at the resonances and
// antiresonances of the drive; K_d is then 0 or infinite, and Eq. (24) still a number.
//
// Error bound. Beside T stands S_T, which is made as T is, but of absolute values: where T is
// T1 Q2 + T2 Q1, S_T is S_T1 S_Q2 + S_T2 S_Q1. No sum of those cancels, so that n roundings on the
// longest path move T by at most n S_T, and Q by at most n S_Q, whatever cancels in them. Whoever
// divides by T or Q knows both and divides the bound by what is left.
//
// Exact differences. k - m omega^2 of one spring and one mass, side by side (in T) or one behind
// the other (in Q), is formed by Program::less_inertia and keeps all its digits: S is what is left
// of it.
#pragma once

#include <optional>
#include <vector>

#include "network/network.hpp"
#include "program/stiffness.hpp"

namespace vcrit::symbolic {

struct DrivePair {
  ComplexNode t, q;
  NodeId t_size = 0, q_size = 0;  ///< S_T and S_Q, bounds
  /// From where S lies, if it is not 0, to where T and Q lie. Numbers that cancel may be smaller:
  /// what they lose below the doubles is far less than a rounding of S.
  ExponentRange t_range, q_range;
  ExponentRange elements;  ///< of |K| of its parts, as far as they are numbers of the program
  int count = 1;           ///< of parts
  int errors = 0;          ///< roundings n
  std::optional<NodeId> more_errors;  ///< those of meshes, known at run time
  bool fits = true;                   ///< no number on the way leaves the range of doubles
  bool exact_re = false;              ///< Q = 1 and Re T as it was given
  struct Inertia {
    NodeId mass, size;  ///< the mass as it was given; m omega^2 as a bound
  };
  std::optional<Inertia> inertia;  ///< where it is one mass and nothing else
};

/// n as a bound.
NodeId pair_errors(Program& program, const DrivePair& pair);

class PairWriter {
 public:
  /// `stiffness` writes into the same program and omega.
  PairWriter(Program& program, NodeId omega, StiffnessWriter& stiffness, Zeros zeros)
      : program_(program), omega_(omega), stiffness_(stiffness), zeros_(zeros) {}

  /// Of a network without masses.
  DrivePair massless(const Network& network);
  DrivePair mass(const Element& element);
  DrivePair parallel(DrivePair a, DrivePair b);
  DrivePair series(DrivePair a, DrivePair b);
  /// The whole with and without one edge of a graph: T = Q_e T_without + T_e T_contracted,
  /// Q likewise.
  DrivePair by_edge(const DrivePair& edge, const DrivePair& without, const DrivePair& contracted);
  /// T and Q each times the T of another one, as sums over spanning trees have a common factor.
  DrivePair times(const DrivePair& pair, const DrivePair& factor);
  /// T and Q times a common power of two that brings the larger one near 1.
  DrivePair normalised(const DrivePair& pair);

 private:
  struct Term {
    const ComplexNode &a, &b;
    NodeId size_a, size_b;
    ExponentRange range;
  };
  struct Sum {
    ComplexNode value;
    NodeId size;
    ExponentRange range;
    int local;
  };
  Sum sum(const std::vector<Term>& terms);
  static DrivePair with(DrivePair whole, const Sum& t, const Sum& q);
  void fit_products(DrivePair& a, DrivePair& b);
  DrivePair joined(const DrivePair& a, const DrivePair& b);
  /// K + m s^2 of a spring, with or without a damper, and a mass.
  Sum difference(const DrivePair& spring, const DrivePair& mass);
  DrivePair side_by_side(const DrivePair& spring, const DrivePair& mass);
  DrivePair one_behind_the_other(const DrivePair& spring, const DrivePair& mass);

  Program& program_;
  NodeId omega_;
  StiffnessWriter& stiffness_;
  Zeros zeros_;
};

/// D = K_d - m omega^2 and N = K_t + D, each times Q of the drive, and N times that of K_t, too.
struct PairBalance {
  ComplexNode d, n;
  ExponentRange d_range, n_range;
  NodeId errors;  ///< of |N|/|D|, relative, in roundings; a bound
  bool fits;      ///< whether all products on the way are in the range of doubles
};

/// `mass`: of the body, if there is one; exact.
PairBalance balance_of(Program& program, StiffnessWriter& stiffness, const DrivePair& drive,
                       const Stiffness& tangential, std::optional<NodeId> mass, NodeId omega,
                       Zeros zeros);

}  // namespace vcrit::symbolic
