// The steady stick-slip motion by SUNDIALS CVODE: an oracle for tests and a peer in the benchmark,
// which shares nothing with the exact simulator but the system it is asked about.
//
// Slip, stick and backslip are ODEs of their own (switched_system.hpp); CVODE's root finding ends
// each. The cycle is found by marching from rest until the friction of a period stays, or by
// Newton's method on the period map with derivatives by finite differences.
#pragma once

#include "simulators/cvode_integrator.hpp"

namespace vcrit::simulators {

struct CvodeOptions {
  Multistep formula = Multistep::bdf;
  double relative_tolerance = 1e-11;
  bool newton = true;
  int most_periods = 20'000;
};

struct CvodeSteady {
  double friction_ratio = 0;  ///< <F>/(mu0 <F_n>) over the last period
  int periods = 0;            ///< integrated in all
  int events = 0;             ///< of the last period
};

/// velocity: of the drive, m/s. Throws NotFinished.
CvodeSteady cvode_steady_state(const simulation::System& system, double velocity,
                               const CvodeOptions& options);

}  // namespace vcrit::simulators
