#include "compare/held_velocity.hpp"

#include <fmt/core.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "compare/held_cells.hpp"
#include "compare/indented.hpp"
#include "compare/velocity_comparisons.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::validation {

namespace {

using indenter::HalfSpace;

// Samples of a period of the finest series of three, each twice as fine; and cells of those that
// are pressed step by step.
constexpr int finest_samples = 2048, finest_cells = 400;

// Of sums of so many terms, in doubles.
constexpr double rounding_of_series = 1e-13;

// A series of a rate that jumps runs past it however many harmonics it has: a direct damper meets
// the surface with a speed, and on a spring alone the body follows at once.
bool rate_jumps(const HalfSpace& half_space) {
  const indenter::Holder& holder = half_space.holder().value();
  return half_space.normal().damper > 0 && !(holder.mass > 0) && !(holder.drive.damper > 0);
}

std::vector<double> sampled_force(const HalfSpace& half_space, int part) {
  const int samples = finest_samples / part;
  if (!half_space.elastic()) return pressed_in_steps(half_space, finest_cells / part, samples);
  std::vector<double> force;
  for (int i = 0; i < samples; ++i)
    force.push_back(static_force(
        half_space,
        half_space.indentation() + half_space.amplitude() * std::cos(two_pi * i / samples)));
  return force;
}

/// What sliding takes at each phase, u_z/kappa + R_b * F_n, by its rate.
class SlidingSeries {
 public:
  SlidingSeries(const HalfSpace& half_space, std::vector<double> force)
      : force_(std::move(force)),
        pressing_(half_space.omega() * half_space.amplitude() / half_space.shear_ratio()) {
    const std::size_t samples = force_.size();
    std::vector<std::complex<double>> turns;
    for (std::size_t i = 0; i < samples; ++i)
      turns.push_back(std::polar(1.0, two_pi * static_cast<double>(i) / double(samples)));
    const indenter::Holder& holder = half_space.holder().value();
    for (std::size_t n = 1; n < samples / 2; ++n) {
      std::complex<double> harmonic = 0;
      for (std::size_t i = 0; i < samples; ++i)
        harmonic += force_[i] * std::conj(turns[n * i % samples]);
      const double s = static_cast<double>(n) * half_space.omega();
      const std::complex<double> drive = dynamic_stiffness(holder.drive, s) - holder.mass * s * s;
      rates_.push_back(2.0 / static_cast<double>(samples) * std::complex<double>(0, s) / drive *
                       harmonic);
    }
  }

  /// Largest while the indenter touches, m/s over mu0.
  double largest() const {
    const std::size_t samples = force_.size();
    std::size_t best = 0;
    double most = -infinity;
    for (std::size_t i = 0; i < samples; ++i)
      if (const double found = at(phase(i)); force_[i] > 0 && found > most) best = i, most = found;
    if (!(force_[(best + 1) % samples] > 0 && force_[(best + samples - 1) % samples] > 0))
      return most;
    constexpr int bits = 26;  // half of a double's: the maximum is flat
    const double step = two_pi / static_cast<double>(samples);
    return -boost::math::tools::brent_find_minima([&](double t) { return -at(t); },
                                                  phase(best) - step, phase(best) + step, bits)
                .second;
  }

  /// Both parts, as large as they become.
  double size() const {
    double sum = pressing_;
    for (const std::complex<double>& rate : rates_) sum += std::abs(rate);
    return sum;
  }

 private:
  double phase(std::size_t i) const {
    return two_pi * static_cast<double>(i) / static_cast<double>(force_.size());
  }

  double at(double t) const {
    double sum = 0;
    for (std::size_t n = rates_.size(); n > 0; --n)
      sum += (rates_[n - 1] * std::polar(1.0, static_cast<double>(n) * t)).real();
    return sum - pressing_ * std::sin(t);
  }

  std::vector<double> force_;
  double pressing_;
  std::vector<std::complex<double>> rates_;  ///< of R_b * F_n, harmonic by harmonic
};

}  // namespace

Comparison compare_held_velocity(const HalfSpace& half_space, const CriticalOnset& onset) {
  Comparison comparison;
  comparison.key = "harmonics";
  comparison.name = "v* by the harmonics of the normal force";
  comparison.reference = "maximum over the phase, of the motion in time";
  comparison.unit = "m/s";
  comparison.expected = onset.contact_velocity;
  if (rate_jumps(half_space))
    return not_run(comparison, "the rate of the normal force jumps, which no series follows");
  const auto series = [&](int part) {
    return SlidingSeries(half_space, sampled_force(half_space, part));
  };
  const SlidingSeries finest = series(1);
  const double mu0 = half_space.friction();
  const double coarse = series(4).largest(), middle = series(2).largest(), fine = finest.largest();
  comparison.found = mu0 * fine;
  comparison.tolerance =
      onset.relative_error + (rounding_of_series * finest.size() + 2 * std::abs(fine - middle) +
                              std::abs(middle - coarse) / 2) *
                                 mu0 / onset.contact_velocity;
  comparison.reason = fmt::format(
      "what twice as many samples of a period change, twice; rounding of the sums, "
      "{:.0e} of them; and the error stated",
      rounding_of_series);
  return comparison;
}

}  // namespace vcrit::validation
