// Random parameters of a problem, and v* there to the last digit.
#pragma once

#include <cstddef>
#include <vector>

#include "speed/problems.hpp"

namespace vcrit::speed {

/// sweep: omega varies, all else is fixed. varying: every parameter varies.
enum class CallMode { sweep, varying };
inline constexpr CallMode both_modes[] = {CallMode::sweep, CallMode::varying};

/// Structure of arrays: one column a parameter, with `size` values in each of them. In a sweep only
/// that of omega is read beyond its first value.
class Samples {
 public:
  Samples(const Subject& subject, CallMode mode, std::size_t size);

  CallMode mode() const { return mode_; }
  std::size_t size() const { return columns_.front().size(); }
  const double* const* columns() const { return pointers_.data(); }
  double value(std::size_t column, std::size_t i) const {
    return columns_[column][mode_ == CallMode::sweep && column != omega_column ? 0 : i];
  }

 private:
  CallMode mode_;
  std::vector<std::vector<double>> columns_;
  std::vector<const double*> pointers_;
};

/// v* correctly rounded, of each set.
std::vector<double> reference(const Subject& subject, const Samples& samples);

/// The largest distance in units of the last place of the reference; infinite if one is no number.
double worst_error(const std::vector<double>& values, const std::vector<double>& reference);

}  // namespace vcrit::speed
