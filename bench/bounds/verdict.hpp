// What an answer is worth beside the exact value, and the count over many.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bounds/evaluator.hpp"
#include "bounds/reference.hpp"

namespace vcrit::bounds {

enum class Violation {
  bound,       ///< the accurate value is farther off than its bound says
  fast_bound,  ///< the fast one is
  ulp,         ///< certified to one unit in the last place, and farther off
  nan,         ///< the accurate value is NaN where v* is not 0/0
  infinity,    ///< it is infinite below the largest double and away from a pole
  zero,        ///< it is 0 above the smallest double and away from a zero
};
inline constexpr std::size_t violation_kinds = 6;  // of the enumeration above
std::string_view name_of(Violation violation);

struct Verdict {
  std::optional<Violation> violation;       ///< the first of them in the order above
  bool is_double = false;                   ///< v* lies among the doubles that are not 0
  bool certified = false;                   ///< to one unit in the last place
  double ulps = 0;                          ///< error of the accurate value
  std::optional<double> ratio, fast_ratio;  ///< error over bound, where that is finite
};

/// `exact` must not be undefined.
Verdict judge(const CertifiedAnswers& answers, const Exact& exact);

/// |value - v*|/v* but for 2^-50 of itself and 2^-105; NaN stays NaN.
double relative_error(double value, const Exact& exact);

struct TrialTally {
  std::uint64_t cases = 0, undefined = 0;       ///< those with 0/0 are not tried
  std::uint64_t doubles = 0, certified = 0;     ///< v* is a double; and certified
  std::uint64_t bounded = 0, fast_bounded = 0;  ///< v* is a double; and the bound is finite
  double ulps = 0;                              ///< worst of the certified
  double ratio = 0, fast_ratio = 0;             ///< worst
  std::array<std::uint64_t, violation_kinds> violations{};
  /// For each kind the violation of least case number, in words.
  struct First {
    std::uint64_t number;
    std::string text;
  };
  std::array<std::optional<First>, violation_kinds> firsts;

  void add(const Verdict& verdict);
  TrialTally& operator+=(const TrialTally& other);
};

}  // namespace vcrit::bounds
