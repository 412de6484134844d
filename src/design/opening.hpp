// How far a scene may oscillate before its contact opens, as bounds on amplitude and frequency:
// (3), (4) and (35) of the paper solved for them. |K_n| never falls with the frequency, so both are
// single bounds, but below a mount: there the amplitude at the contact depends on the frequency. Of
// an indenter, whose rim may open, they are those of its centre.
#pragma once

#include <optional>

#include "problem/problem.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::design {

class NormalContact {
 public:
  /// Amplitude, frequency and load of the scene need no values. Throws InputError for other missing
  /// values, ModelError where the normal network carries no static load.
  explicit NormalContact(const Problem& problem);

  /// The amplitude (m) below which the contact stays closed at omega (rad/s).
  double largest_amplitude(double omega) const;
  /// Whether there is one largest frequency to ask for, whatever the amplitude.
  bool closes_up_to_a_frequency() const;
  /// The angular frequency (rad/s) below which it does with this amplitude (m); nothing without a
  /// bound. Throws ModelError where it opens at any.
  std::optional<double> largest_angular_frequency(double amplitude) const;
  /// The load (N) above which it does with this amplitude (m) at omega (rad/s).
  double least_force(double amplitude, double omega) const;
  /// Amplitude of F_n over its mean, at omega (rad/s).
  double oscillating_part(double amplitude, double omega) const;

 private:
  /// An indenter under a load, whose depth has to be found.
  bool pressed_tip() const;
  std::optional<double> largest_of_pressed_tip(double amplitude) const;

  Problem problem_;  // with any value of amplitude and frequency where it has none
  Relaxation normal_;
  double mean_force_ = 0;  // N
};

/// The scene with another load (N). Throws InputError for one without [load].
Problem with_load(const Problem& problem, double force);

/// The scene with other values of what oscillates: amplitude (m) and omega (rad/s).
Problem with_amplitude(const Problem& problem, double amplitude);
Problem with_angular_frequency(const Problem& problem, double omega);

/// The drive velocity (m/s) up to which the oscillation reduces friction: v* and the creep.
double reduced_up_to(const Problem& problem);

}  // namespace vcrit::design
