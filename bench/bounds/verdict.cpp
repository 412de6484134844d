#include "bounds/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.hpp"

namespace vcrit::bounds {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double unknown = 0x1p-104;   // of v*, to relative_error
constexpr int least_exponent = -1074;  // of the smallest double

bool is_above_doubles(const Exact& exact) {
  const double nearest = std::ldexp(exact.high, exact.exponent);
  return nearest > largest || (nearest == largest && exact.low > 0);
}

// (high + low) 2^exponent < 2^-1074
bool is_below_doubles(const Exact& exact) {
  const int missing = least_exponent - exact.exponent;
  const double smallest = std::ldexp(1.0, std::clamp(missing, -2, 2));
  return exact.high < smallest || (exact.high == smallest && exact.low < 0);
}

/// 2^exponent over the distance of doubles at v*.
double last_places(const Exact& exact) {
  return std::ldexp(1.0, exact.exponent - std::max(exact.exponent - 53, least_exponent));
}

/// error/bound; nothing where nothing is known.
std::optional<double> ratio(double value, double bound, const Exact& exact) {
  if (!std::isfinite(bound)) return std::nullopt;
  const bool is_number = exact.kind == Exact::Kind::number;
  const double known = exact.kind == Exact::Kind::zero ? 0 : infinity;
  if (!is_number) return value == known ? 0 : infinity;
  const double error = relative_error(value, exact);
  return error < unknown ? 0 : error / bound;
}

// What rounding in relative_error cannot have made; NaN is more.
bool is_more_than_one(const std::optional<double>& ratio) {
  return ratio && !(*ratio <= 1 + 0x1p-48);
}

bool is_false_bound(double bound) { return std::isnan(bound) || bound < 0; }

bool is_normal(const Exact& exact) { return exact.exponent > -1022; }

bool certifies(double bound, const Exact& exact) {
  return is_normal(exact) ? bound <= 0x1p-52 : bound * exact.high * last_places(exact) <= 1;
}

std::optional<Violation> violation(const CertifiedAnswers& a, const Exact& exact,
                                   const Verdict& verdict) {
  const bool is_number = exact.kind == Exact::Kind::number;
  if (is_false_bound(a.bound) || is_more_than_one(verdict.ratio)) return Violation::bound;
  if (is_false_bound(a.fast_bound) || is_more_than_one(verdict.fast_ratio))
    return Violation::fast_bound;
  if (verdict.certified && verdict.ulps > 1) return Violation::ulp;
  if (std::isnan(a.value)) return Violation::nan;
  if (std::isinf(a.value) && exact.kind != Exact::Kind::pole &&
      !(is_number && is_above_doubles(exact)))
    return Violation::infinity;
  if (a.value == 0 && exact.kind != Exact::Kind::zero && !(is_number && is_below_doubles(exact)))
    return Violation::zero;
  return std::nullopt;
}

}  // namespace

std::string_view name_of(Violation violation) {
  constexpr std::array<std::string_view, violation_kinds> names{"bound", "fast bound", "ulp",
                                                                "NaN",   "infinity",   "zero"};
  return names[static_cast<std::size_t>(violation)];
}

// value/2^exponent - high is exact where they are near each other.
double relative_error(double value, const Exact& exact) {
  const double scaled = std::ldexp(value, -exact.exponent);
  return std::abs((scaled - exact.high) - exact.low) / exact.high;
}

Verdict judge(const CertifiedAnswers& answers, const Exact& exact) {
  Verdict verdict;
  verdict.ratio = ratio(answers.value, answers.bound, exact);
  verdict.fast_ratio = ratio(answers.fast_value, answers.fast_bound, exact);
  verdict.is_double =
      exact.kind == Exact::Kind::number && !is_above_doubles(exact) && !is_below_doubles(exact);
  if (verdict.is_double) {
    verdict.certified = certifies(answers.bound, exact);
    verdict.ulps = relative_error(answers.value, exact) * exact.high * last_places(exact);
  }
  verdict.violation = violation(answers, exact, verdict);
  return verdict;
}

void TrialTally::add(const Verdict& verdict) {
  ++cases;
  doubles += verdict.is_double ? 1 : 0;
  bounded += verdict.is_double && verdict.ratio ? 1 : 0;
  fast_bounded += verdict.is_double && verdict.fast_ratio ? 1 : 0;
  ratio = std::max(ratio, verdict.ratio.value_or(0));
  fast_ratio = std::max(fast_ratio, verdict.fast_ratio.value_or(0));
  if (verdict.certified) {
    ++certified;
    ulps = std::max(ulps, verdict.ulps);
  }
  if (verdict.violation) ++violations[static_cast<std::size_t>(*verdict.violation)];
}

TrialTally& TrialTally::operator+=(const TrialTally& other) {
  cases += other.cases;
  undefined += other.undefined;
  doubles += other.doubles;
  certified += other.certified;
  bounded += other.bounded;
  fast_bounded += other.fast_bounded;
  ulps = std::max(ulps, other.ulps);
  ratio = std::max(ratio, other.ratio);
  fast_ratio = std::max(fast_ratio, other.fast_ratio);
  for (std::size_t i = 0; i < violation_kinds; ++i) {
    violations[i] += other.violations[i];
    const auto& theirs = other.firsts[i];
    if (theirs && (!firsts[i] || theirs->number < firsts[i]->number)) firsts[i] = theirs;
  }
  return *this;
}

}  // namespace vcrit::bounds
