#include "fit/chances.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

namespace vcrit::fit {

namespace {

// Of a 95 % interval.
constexpr double upper_end = 0.975;

}  // namespace

double chance_of_mean(const StiffnessTable& data, double sign) {
  const auto rows = static_cast<double>(data.rows.size());
  double sum = 0, squares = 0;
  for (const StiffnessRow& row : data.rows) {
    const double unit = data.has_errors ? row.loss_error : std::hypot(row.storage, row.loss);
    const double part = sign * row.loss / unit;
    sum += part;
    squares += part * part;
  }
  if (!(sum > 0)) return 1;
  if (data.has_errors) return cdf(complement(boost::math::normal(), sum / std::sqrt(rows)));
  const double scatter = std::sqrt(std::max(0.0, squares - sum * sum / rows) / (rows - 1));
  if (scatter == 0) return 0;
  const boost::math::students_t student(rows - 1);
  return cdf(complement(student, sum / rows / (scatter / std::sqrt(rows))));
}

double chance_of_misfit(double sum_of_squares, int degrees) {
  return boost::math::gamma_q(degrees / 2.0, sum_of_squares / 2);
}

double chance_of_fall(double before, double after, int more, int degrees, bool errors_known) {
  if (!(after < before)) return 1;
  if (more == 0) return 0;
  if (errors_known) return chance_of_misfit(before - after, more);
  return boost::math::ibeta(degrees / 2.0, more / 2.0, after / before);
}

double chance_with_usual_noise(double before, double after, int more, int degrees) {
  constexpr double usual = usual_degrees * usual_error * usual_error;
  return chance_of_fall(before + usual, after + usual, more, degrees + usual_degrees, false);
}

Judgement judgement_of_fall(double before, double after, int more, int degrees, bool errors_known) {
  const double plain = chance_of_fall(before, after, more, degrees, errors_known);
  if (errors_known) return {plain, significance};
  const Judgement alone{plain, level(degrees)};
  const Judgement with_usual{chance_with_usual_noise(before, after, more, degrees),
                             level(degrees + usual_degrees)};
  return with_usual.chance / with_usual.level < alone.chance / alone.level ? with_usual : alone;
}

bool shows_loss(const StiffnessTable& data) {
  const double few = data.has_errors ? 0 : level(static_cast<int>(data.rows.size()) - 1);
  return chance_of_mean(data, 1) < std::max(two_deviations, few);
}

double level(int degrees) {
  return std::clamp(std::pow(clear_fall, -degrees), significance, largest_chance);
}

double widening(int degrees) {
  const boost::math::students_t few(degrees);
  const boost::math::normal many;
  return quantile(few, upper_end) / quantile(many, upper_end);
}

}  // namespace vcrit::fit
