// Modes of a linear motion y' = A y that has any number of oscillating pairs, from the eigenvalues
// of A: those of a body on a drive with masses, in slip and in stick.
//
// A pair of modes s = -p +- sqrt(q) is a plane in which (A + p)^2 = q. It is spanned by any vector
// X_a of it and X_b = (A + p) X_a, so that y = a X_a + b X_b obeys a' = -p a + q b, b' = a - p b,
// as pair_number.hpp has it: through critical damping, q = 0, this is smooth. Two real rates near
// each other are such a pair, too. Where more modes merge than two, their numbers grow like the
// inverse of their distance and cancel. They are then kept apart by a change of A within some
// roundings.
#pragma once

#include <complex>
#include <memory>

#include "modes/spectrum.hpp"
#include "stiffness/dense.hpp"

namespace vcrit::simulation {

struct GeneralModes {
  Modes modes;
  /// By how much rounding errors of doubles grow on the way to the modes and back, in units of y,
  /// and a share by which A was changed.
  double amplification = 1, change = 0;
};

/// The modes of the last few A, whatever the unit. Whoever asks for many motions of one drive holds
/// this memory and hands it on; it serves one thread at a time.
class KnownModes {
 public:
  KnownModes();
  ~KnownModes();
  KnownModes(const KnownModes&) = delete;
  KnownModes& operator=(const KnownModes&) = delete;

  /// As general_modes().
  GeneralModes of(const Dense<long double>& a, double unit);

 private:
  class Last;
  std::unique_ptr<Last> last_;  ///< made for the first A
};

/// Of A/unit: A in units in which all numbers of y are alike, with no growing mode but by rounding.
/// By that memory, if there is one. Throws ModelError where the eigenvalues do not converge.
GeneralModes general_modes(const Dense<long double>& a, double unit = 1,
                           KnownModes* known = nullptr);

/// (s - A)^-1 e_1.
List<std::complex<double>> response(const Dense<long double>& a, std::complex<double> s);

}  // namespace vcrit::simulation
