// The retardation spectrum of a network in its elements. However wired, 1/K(s) = J_g + 1/(eta s) +
// sum_i j_i/(1 + lambda_i s) with all j_i, lambda_i > 0: a spring, a damper and Kelvin units one
// behind the other.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <vector>

#include "formula/line.hpp"
#include "network/network.hpp"

namespace vcrit::symbolic {

/// One retardation time: the lines lambda_i = ... (s) and j_i = ... (m/N) in the elements. Where
/// two times are the roots of one quadratic, the compliances are written in lambda_i.
struct RetardationLine {
  Line time, compliance;
};

struct RetardationSpectrum {
  Expression glassy;    ///< J_g (m/N), 0 beside a damper
  Expression fluidity;  ///< 1/eta (m/(N s)), 0 of what does not flow
  std::vector<RetardationLine> lines;

  /// 1/K(s) as that sum.
  GiNaC::ex sum() const;
};

/// In closed form. Parts one behind the other are taken one by one; nothing if a part has more than
/// two retardation times of its own, or if there are masses or lossy springs.
std::optional<RetardationSpectrum> retardation_spectrum(const Network& network);

}  // namespace vcrit::symbolic
