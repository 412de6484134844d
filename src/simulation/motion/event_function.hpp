// A function of time whose first zero is an event: start values and the `order`-fold integral from
// t = 0 of a sum of decaying modes and one sinusoid,
//   f(t) = f_0 + I^order [ sum_i A_i e^{-r_i t} + pair + Re(H e^{it}) ],   order 1 or 2.
// With f = 0 or f = f' = 0 at the start as exact numbers, a stick is resolved however short it is.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "simulation/motion/spectrum.hpp"

namespace vcrit::simulation {

class EventFunction {
 public:
  /// order 1: f = value + ..., order 2: f = value + 0 t + ...; `size` of what was added to make the
  /// value tells its rounding error.
  EventFunction(int order, double value, double size);

  /// Adds factor * row * (modes z), differentiated in time `derivative` times (0 or 1).
  void add_modes(const Spectrum& spectrum, const Vector& row, const Vector& z, double factor,
                 int derivative = 0);
  /// Adds Re(amplitude e^{it}).
  void add_sinusoid(std::complex<double> amplitude);

  struct Point {
    double time = 0;
    double value = 0, slope = 0, curvature = 0;
    double noise = 0;  ///< bound on the rounding error of value
  };
  /// f at t, which becomes the present point.
  Point move_to(double t);

  /// A duration up to h during which f stays negative after the present point, where its value is
  /// `value` < 0 (or where it leaves 0 downwards); 0 if none can be shown. `finer` says that a
  /// smaller h may show more.
  struct Safe {
    double duration = 0;
    bool finer = false;
  };
  Safe safe_duration(double value, double h) const;

 private:
  struct Decay {
    double amplitude, rate, now;
  };
  struct Pair {
    PairNumber amplitude, exponent, inverse;
    double rate;  ///< size of the exponent
    PairNumber now;
  };

  struct Cubic;
  bool bound_decays(Cubic& bound, double h) const;
  bool bound_pairs(Cubic& bound, double h) const;

  int order_;
  double value_, size_;
  double slope_ = 0;  ///< at the present point
  std::vector<Decay> decays_;
  std::vector<Pair> pairs_;
};

/// The first t in (0, end] where f, negative before, reaches 0; nothing if it stays negative. With
/// `leaving`, f(0) = 0 does not count. Zeros at which f only touches 0 within rounding are passed.
/// Where no zero is expected, `first_step` = end may settle it at once.
std::optional<double> first_zero(EventFunction& f, double end, bool leaving, double first_step = 1);

}  // namespace vcrit::simulation
