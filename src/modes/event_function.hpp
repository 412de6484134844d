// A function of time whose first zero is an event: start values and the `order`-fold integral from
// t = 0 of a sum of decaying modes and one sinusoid,
//   f(t) = f_0 + I^order [ sum_i A_i e^{-r_i t} + pair + Re(H e^{it}) ],   order 1 or 2.
// With f = 0 or f = f' = 0 at the start as exact numbers, a stick is resolved however short it is.
#pragma once

#include <complex>

#include "base/effort.hpp"
#include "modes/bernstein.hpp"
#include "modes/spectrum.hpp"

namespace vcrit::simulation {

class EventFunction {
 public:
  /// order 1: f = value + ..., order 2: f = value + 0 t + ...; `size` of what was added to make the
  /// value tells its rounding error. The spectrum must outlive the function, as must the effort
  /// that all that is done with it is taken from.
  EventFunction(const Spectrum& spectrum, int order, double value, double size,
                Effort* effort = nullptr);

  /// Adds factor * row * (modes z), differentiated in time `derivative` times (0 or 1).
  void add_modes(ConstView row, ConstView z, double factor, int derivative = 0);
  /// Adds Re(amplitude e^{it}).
  void add_sinusoid(std::complex<double> amplitude);

  struct Point {
    double time = 0;
    double value = 0, slope = 0, curvature = 0;
    double noise = 0;  ///< bound on the rounding error of value
  };
  /// f after the duration of the factors, which are those of its spectrum.
  Point at(const ModalFactors& factors) const;

  const Spectrum& spectrum() const { return *spectrum_; }

  /// f at t, which becomes the present point.
  Point move_to(double t);

  /// A bound from above on f over [0, t], from the size of each term alone.
  double ceiling(double t) const;

  /// A duration up to h during which f stays negative after the present point, where its value is
  /// `value` < 0 (or where it leaves 0 downwards); 0 if none can be shown. `finer` says that a
  /// smaller h may show more.
  struct Safe {
    double duration = 0;
    bool finer = false;
  };
  Safe safe_duration(double value, double h) const;

  /// The longest such duration that `h` leads to, and with it the h to try next: intervals are
  /// narrowed while they hide fast terms and show little, and grow when all is safe.
  double safe_step(double value, double& h) const;

 private:
  void count() const;
  bool bound_decays(Derivatives& bound, double h) const;
  bool bound_pair(Derivatives& bound, double h, PairNumber now, const ModePair& pair) const;
  bool bound_sinusoid(Derivatives& bound, double h) const;

  const Spectrum* spectrum_;
  std::size_t order_;
  double value_, size_;
  Effort* effort_;
  Vector singles_;
  List<PairNumber, usual_pairs> pairs_;
  PairNumber sinusoid_;

  ModalFactors here_;  ///< of the present point
  double slope_ = 0;
};

}  // namespace vcrit::simulation
