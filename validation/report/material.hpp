// A network as a material in numbers: spectra, and how it answers to a step and to a frequency.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/figure.hpp"
#include "network/network.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::validation::report {

/// j = compliance (m/N) at the retardation time (s).
struct KelvinUnit {
  double compliance = 0, time = 0;
};

/// 1/K(s) = glassy + fluidity/s + sum_i j_i/(1 + lambda_i s).
struct Retardation {
  double glassy = 0;              ///< m/N, 0 beside a damper
  double fluidity = 0;            ///< m/(N s), 0 of what does not flow
  std::vector<KelvinUnit> units;  ///< by increasing time
};

struct MaterialNumbers {
  Relaxation relaxation;
  Retardation retardation;

  /// Force of a unit step of displacement at t > 0 (N/m), without the impulse of a direct damper.
  double relaxation_function(double t) const;
  /// Displacement under a unit step of force (m/N).
  double creep_function(double t) const;
};

/// Of a network without masses and lossy springs whose elements all have positive values.
MaterialNumbers material_numbers(const Network& network, const Values& values);

/// "N/m" and "N.s/m", or of the moduli of a half-space "Pa" and "Pa.s".
struct MaterialUnits {
  const char *stiffness = "N/m", *damper = "N.s/m";
  bool moduli = false;
};

/// "0.25 µm/N", "0.5 1/GPa": of 1/value, by the unit of the value.
std::string inverse_words(double inverse, const char* unit);

/// Storage and loss, loss factor, relaxation and creep over the times of the spectra; none where
/// these do not depend on time: a spring or a damper alone.
std::vector<figures::Figure> material_figures(const MaterialNumbers& numbers,
                                              const MaterialUnits& units);

}  // namespace vcrit::validation::report
