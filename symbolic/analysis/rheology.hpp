// A network as a material: its dynamic stiffness as real functions of the frequency, what it is at
// rest and at once, and its relaxation spectrum. However wired, K(s) = k_inf + c_inf s +
// sum_j h_j tau_j s/(1 + tau_j s) with all h_j, tau_j > 0 (Maxwell branches side by side).
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <vector>

#include "derivation/stiffness_forms.hpp"
#include "formula/line.hpp"
#include "network/network.hpp"

namespace vcrit::symbolic {

/// One relaxation time: the lines tau_j = ... (s) and h_j = ... (N/m) in the network's elements.
/// Where two times are the roots of one quadratic, the strengths are written in tau_j. A Maxwell
/// branch given by its time keeps its names: both sides are the same.
struct RelaxationLine {
  Line time, strength;
};

struct RelaxationSpectrum {
  Expression equilibrium;  ///< k_inf (N/m)
  Expression damper;       ///< c_inf (N s/m)
  std::vector<RelaxationLine> lines;

  /// K(s) as that sum, in the names tau_j and h_j.
  GiNaC::ex sum() const;
  /// An expression in tau_j and h_j written in the elements.
  GiNaC::ex in_elements(const GiNaC::ex& expression) const;
};

/// In closed form. Parts side by side are taken one by one, so that branches stay as they are
/// given; nothing if a part has more than two relaxation times of its own, or if there are masses.
std::optional<RelaxationSpectrum> spectrum(const Network& network);

/// K(s) and K(i omega) = K' + i K'', in the elements, s and omega (N/m).
struct Response {
  Expression stiffness;  ///< K(s)
  Expression storage;    ///< K'
  Expression loss;       ///< K''
};

/// Each as one fraction if K(s) has at most a dozen terms above the bar, else as a sum over the
/// parts of a parallel combination.
Response response(const Network& network);

/// K(s) without common factors; all coefficients are positive. Multiplied out: for networks of
/// which a formula is readable.
Fraction stiffness_in_lowest_terms(const Network& network);

/// What a lasting load and a sudden one meet, in a network without masses. A loss factor is no law
/// of a sudden load: beside it only the stiffness at rest is one.
struct StiffnessExtremes {
  Expression equilibrium;  ///< K(0) (N/m); 0 for what flows
  Expression viscosity;    ///< K(s)/s for s to 0 (N s/m), of what flows, else 0
  Expression glassy;       ///< K(s) for s to infinity (N/m), 0 beside a damper
  Expression damper;       ///< K(s)/s for s to infinity (N s/m), 0 without a direct damper
};

StiffnessExtremes extremes(const Network& network);

}  // namespace vcrit::symbolic
