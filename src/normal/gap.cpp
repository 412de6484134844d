#include "normal/gap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "scene/members.hpp"

namespace vcrit::indenter {

namespace {

// Of rounded heights; what g falls by is of second order in their error.
constexpr double harmless_fall = 1e-6;

double given_size(const Indenter& indenter, std::size_t i) { return *indenter.sizes[i].value; }

// sqrt(pi)/2 n Gamma(n/2)/Gamma((n + 1)/2)
double kappa(double n) {
  const double root = 1 / std::numbers::inv_sqrtpi;
  return 0.5 * root * n * boost::math::tgamma_delta_ratio(0.5 * n, 0.5);
}

// Right also where x hardly exceeds r, which arccos(r/x) is not.
double angle(double r, double x) { return std::atan2(std::sqrt((x - r) * (x + r)), r); }

}  // namespace

Gap::Gap(const Indenter& indenter) : end_(infinity) {
  check_indenter(indenter, argument("indenter"));
  switch (indenter.shape) {
    case Indenter::Shape::flat:
      end_ = given_size(indenter, 0);
      break;
    case Indenter::Shape::cone:
      set_power(std::tan(given_size(indenter, 0)), 1);
      break;
    case Indenter::Shape::parabola:
      set_power(0.5 / given_size(indenter, 0), 2);
      break;
    case Indenter::Shape::power:
      set_power(given_size(indenter, 0), given_size(indenter, 1));
      break;
    case Indenter::Shape::table:
      set_table(*indenter.profile);
  }
}

void Gap::set_power(double factor, double exponent) {
  factor_ = kappa(exponent) * factor;
  exponent_ = exponent;
}

// With the slopes changing by d_i at r_i, g(x) = |x| sum_{r_i < |x|} d_i arccos(r_i/|x|).
void Gap::set_table(const Profile& profile) {
  // Of a quotient of two differences of rows that lie on one line.
  constexpr double slope_rounding = 8 * epsilon;
  double before = 0;
  for (std::size_t i = 0; i + 1 < profile.rows.size(); ++i) {
    const Profile::Row &row = profile.rows[i], &next = profile.rows[i + 1];
    const double slope = (next.f - row.f) / (next.r - row.r);
    if (std::abs(slope - before) <= slope_rounding * slope) continue;
    radii_.push_back(row.r);
    changes_.push_back(slope - before);
    before = slope;
  }
  end_ = profile.rows.back().r;
  double highest = 0;
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    at_radii_.push_back(highest);
    highest = highest_after(highest, radii_[i], i + 1 < radii_.size() ? radii_[i + 1] : end_);
  }
}

Gap::Parts Gap::polygon(double x) const {
  Parts sum;
  for (std::size_t i = 0; i < radii_.size() && radii_[i] < x; ++i)
    (changes_[i] > 0 ? sum.rise : sum.fall) += x * std::abs(changes_[i]) * angle(radii_[i], x);
  return sum;
}

// Each term becomes less steep with x.
Gap::Parts Gap::polygon_slope(double x) const {
  Parts sum;
  for (std::size_t i = 0; i < radii_.size() && radii_[i] <= x; ++i) {
    const double r = radii_[i];
    const double steep = r > 0 ? r / std::sqrt((x - r) * (x + r)) : 0;
    (changes_[i] > 0 ? sum.rise : sum.fall) += std::abs(changes_[i]) * (angle(r, x) + steep);
  }
  return sum;
}

// The largest g up to `high`, between two radii, from that up to `low`. Halves until g surely grows
// or can fall no more than it may.
double Gap::highest_after(double highest, double low, double high) const {
  const double end = at(high), middle = 0.5 * (low + high);
  const Parts at_low = polygon(low), at_high = polygon(high);
  if (middle <= low || middle >= high ||
      at_high.fall - at_low.fall <= 0.5 * harmless_fall * highest ||
      polygon_slope(high).rise >= polygon_slope(low).fall) {
    if (end < (1 - harmless_fall) * highest) {
      const auto [from, to] = rounded_apart(highest, end, "m");
      throw ModelError(fmt::format(
          "the contact would have holes: the profile g(x) of the table falls from {} to "
          "{} near r = {}, where the slope of f decreases",
          from, to, rounded(high, "m")));
    }
    return std::max(highest, end);
  }
  return highest_after(highest_after(highest, low, middle), middle, high);
}

double Gap::at(double x) const {
  const double distance = std::abs(x);
  if (distance > end_) return infinity;
  if (radii_.empty()) return factor_ == 0 ? 0 : factor_ * std::pow(distance, exponent_);
  const Parts parts = polygon(distance);
  return parts.rise - parts.fall;
}

// int_r^x t arccos(r/t) dt = (x^2 arccos(r/x) - r sqrt(x^2 - r^2))/2
double Gap::area(double x) const {
  if (radii_.empty())
    return factor_ == 0 ? 0 : factor_ * std::pow(x, exponent_ + 1) / (exponent_ + 1);
  double sum = 0;
  for (std::size_t i = 0; i < radii_.size() && radii_[i] < x; ++i) {
    const double r = radii_[i];
    sum += 0.5 * changes_[i] * (x * x * angle(r, x) - r * std::sqrt((x - r) * (x + r)));
  }
  return sum;
}

double Gap::half_width(double depth) const {
  if (depth < 0) return 0;
  if (flat()) return end_;
  if (radii_.empty()) return std::pow(depth / factor_, 1 / exponent_);
  if (at(end_) <= depth) return end_;
  const auto above = std::upper_bound(at_radii_.begin(), at_radii_.end(), depth);
  const auto next = radii_.begin() + (above - at_radii_.begin());
  double low = *std::prev(next), high = next == radii_.end() ? end_ : *next;
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    (at(middle) <= depth ? low : high) = middle;
  return low;
}

}  // namespace vcrit::indenter
