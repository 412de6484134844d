// How a normal network moves while the contact is closed, and while it is open: in both of them
// one linear motion, up to where it opens or closes.
#pragma once

#include <complex>
#include <optional>

#include "base/effort.hpp"
#include "modes/contact_modes.hpp"

namespace vcrit::simulation {

/// d(t) = mean + amplitude cos t of what lies above the network, amplitude > 0, mean of any sign;
/// m, or any other length.
struct Indentation {
  double mean = 0, amplitude = 0;
};

/// Column 0 holds the strains of the Kelvin units, the others changes of these at fixed time.
struct NormalState {
  double time = 0;
  Matrix strains;
  bool released = false;  ///< the contact opens at this very instant
  /// The column of a change of the mean indentation by 1, and not of the strains to begin with.
  std::optional<Index> deeper = {};
};

/// What is integrated on the way: force and strains, by the same columns, and the sum of the sizes
/// of all that the impulse is made of.
struct NormalIntegrals {
  NormalIntegrals(Index units, Index columns) : impulse(columns), strains(units, columns) {}

  Vector impulse;
  Matrix strains;
  double size = 0;
};

struct NormalStay {
  bool closed = false;
  double begin = 0, duration = 0;
  Vector decays = {};  ///< of a touch
};

class NormalStays {
 public:
  /// The network with time in units of 1/omega; both it and the effort must outlive the object.
  NormalStays(const ContactModes& network, const Indentation& indentation, Effort& effort);
  NormalStays(const NormalStays&) = delete;
  NormalStays& operator=(const NormalStays&) = delete;

  Index units() const { return units_.singles(); }
  /// Amplitude of e^{it} of the force while the contact is closed.
  std::complex<double> swing() const { return swing_; }
  double gap(const NormalState& now) const;
  /// Separated at the top, the network as if pressed for good to where it is pressed at most.
  NormalState start() const;

  /// Until the contact closes, or opens, at most to the end. Whether they did.
  bool stay_apart(NormalState& now, double end, NormalStay& stay, NormalIntegrals& sums) const;
  bool stay_closed(NormalState& now, double end, NormalStay& stay, NormalIntegrals& sums) const;

 private:
  double depth(double time) const;
  std::complex<double> branch_swing(Index i) const;
  static double raised(const NormalState& now, Index column);
  void strike(NormalState& now, NormalIntegrals& sums) const;
  Matrix decays_at(const NormalState& now) const;
  bool has_fast_unit() const;
  std::optional<double> touch_down(const NormalState& now, double horizon) const;
  std::optional<double> lift_off(const NormalState& now, ConstView decays, double horizon) const;
  void press(NormalState& now, const Matrix& decays, double duration, NormalIntegrals& sums) const;

  const ContactModes& network_;
  Indentation indentation_;
  Effort& effort_;
  Spectrum branches_, units_;
  std::complex<double> swing_;
};

}  // namespace vcrit::simulation
