// A half-space and the indenter that is pressed into it with an oscillation, as the independent
// contacts of the method of dimensionality reduction: springs at x, of normal stiffness E* dx with
// E* = E/(1 - nu^2), each of which is a contact of the simulator under the indentation
// u_z0 + du_z cos(omega t) - g(x).
#pragma once

#include <optional>

#include "normal/gap.hpp"
#include "problem/problem.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::indenter {

/// What holds an indenter on a drive that gives.
struct Holder {
  Relaxation drive;
  double mass = 0;  ///< kg, of the body

  /// Whether it swings without end while the cells stick.
  bool rings() const { return mass > 0 && drive.damper == 0 && drive.branches.empty(); }
};

class HalfSpace {
 public:
  /// A scene with an indenter. Throws InputError for missing values, ModelError where there is no
  /// friction, no static load, no contact, or one that opens all over without scene.separation.
  explicit HalfSpace(const Problem& problem);

  /// The mean indentation at x, u_z0 - g(x), m.
  double depth(double x) const { return indentation_ - gap_.at(x); }

  /// The same, whose cells share an effort that outlives it.
  HalfSpace within(simulation::SharedEffort& effort) const;
  simulation::SharedEffort* effort() const { return effort_; }

  /// The contact at x, where the contact is closed; forces per length, N/m. Throws InputError where
  /// it never is.
  simulation::System cell(double x) const { return cell_under(depth(x)); }
  /// The same by its mean indentation.
  simulation::System cell_under(double depth) const;

  /// The part of the normal force's amplitude that is left out of a cell under this indentation,
  /// which would hardly open and is taken for closed; at most 1e-8.
  double neglected(double depth) const;

  /// Whether the contact closes at x at all.
  bool touches(double x) const { return closes(depth(x)); }

  /// Whether it stays closed at x, or opens by less than 1e-8 of the indentation.
  bool stays_closed(double x) const { return never_opens(depth(x)); }

  double edge() const { return gap_.half_width(indentation_ + amplitude_); }  ///< m
  /// Half the width (m) of contact under the mean indentation.
  double radius() const { return gap_.half_width(indentation_); }
  /// Half the width (m) of where the contact never opens.
  double closed_radius() const { return gap_.half_width(indentation_ - swing_); }

  /// Whether all cells are the same: under a flat punch.
  bool uniform() const { return gap_.flat(); }

  /// Nothing under a rigid drive.
  const std::optional<Holder>& holder() const { return holder_; }

  /// All cells as one contact on its drive, where they are the same; forces in N.
  simulation::System whole() const;

  const Gap& gap() const { return gap_; }
  double indentation() const { return indentation_; }  ///< u_z0, m
  double amplitude() const { return amplitude_; }      ///< du_z, m

  double omega() const { return omega_; }        ///< rad/s
  double friction() const { return friction_; }  ///< mu0
  double shear_ratio() const { return ratio_; }  ///< K_t/K_n of each cell

  const Relaxation& normal() const { return normal_; }  ///< E*, Pa
  /// |E*(i omega)|, Pa.
  double dynamic_modulus() const { return std::abs(response_); }
  /// E*(0), Pa.
  double static_modulus() const { return normal_.equilibrium; }
  /// Of all cells at rest under this mean indentation (m), N; nothing above the surface.
  double static_force(double depth) const;
  /// The least that each cell carries in a period, of all of them, N: all that stay closed carry
  /// it at the same instant, and what opens carries nothing then.
  double least_force() const { return static_force(indentation_ - swing_); }
  /// Whether E* is the same at all frequencies.
  bool elastic() const { return normal_.branches.empty() && normal_.damper == 0; }

 private:
  bool closes(double depth) const { return depth + amplitude_ > 0; }
  bool never_opens(double depth) const;

  Gap gap_;
  Relaxation normal_, tangential_;  ///< E* and ratio E*
  std::optional<Holder> holder_;
  double ratio_ = 1;
  double omega_ = 0, friction_ = 0;
  double indentation_ = 0, amplitude_ = 0;
  std::complex<double> response_;  ///< E*(i omega)
  double swing_ = 0;               ///< du_z |E*(i omega)|/E*(0), m
  simulation::SharedEffort* effort_ = nullptr;
};

}  // namespace vcrit::indenter
