#include "fit/words.hpp"

#include <fmt/core.h>

#include "base/rounded.hpp"
#include "fit/chances.hpp"

namespace vcrit::fit {

namespace {

// A chance below this says that the misfit is more than noise of the errors given.
constexpr double beyond_the_errors_given = significance;

std::string length_in_words(const Fit& fit) {
  const std::size_t n = fit.branches.size();
  std::string text = fmt::format("{} branch{}", n, n == 1 ? "" : "es");
  if (fit.equilibrium)
    text += n == 0 ? ", an equilibrium spring alone" : " and an equilibrium spring";
  if (fit.damper) text += " and a damper";
  return text;
}

std::string noise_in_words(const Fit& fit) {
  if (fit.noise)
    return fmt::format("the noise of the data is estimated to {:.2g} % of |K|", 100 * *fit.noise);
  return fmt::format("chi-squared is {:.4g} with {} degrees of freedom ({:.3g} each)",
                     fit.sum_of_squares, fit.degrees_of_freedom,
                     fit.sum_of_squares / fit.degrees_of_freedom);
}

bool is_poorly_known(const Uncertain& number) { return number.error > number.value / 2; }

std::string in_numbers(const Interval& interval, const char* unit) {
  return fmt::format("{} to {}", rounded(interval.low, unit, 2), rounded(interval.high, unit, 2));
}

}  // namespace

std::vector<std::string> in_words(const StiffnessTable& data, const Fit& fit) {
  std::vector<std::string> words{length_in_words(fit),
                                 fmt::format("the root mean square misfit is {:.3g} %; {}",
                                             100 * fit.rms_relative, noise_in_words(fit))};
  if (fit.exhausted)
    words.push_back(
        fmt::format("the last of {} branches still helped: more may be needed (`max_branches`)",
                    fit.branches.size()));
  if (fit.order_in_doubt)
    words.emplace_back(
        "with this noise another number of branches fits as well: the errors of the branches "
        "assume "
        "this number, the intervals of the stiffness do not");
  if (fit.time_at_an_end)
    words.emplace_back(
        "the relaxation time is only a bound: the data show no more than the tail of the loss");
  if (fit.rms_relative > far_off)
    words.emplace_back("no series of springs and dampers comes near these data");
  if (fit.chance && *fit.chance < beyond_the_errors_given)
    words.emplace_back(
        "the misfit is larger than the errors given explain: they are too small, or no series "
        "fits");
  if (!fit.equilibrium)
    words.emplace_back(
        "the data need no equilibrium spring; without one this contact carries no static load and "
        "is not admissible as a normal contact");
  const auto judge = [&](const std::optional<Uncertain>& number, const char* name,
                         const char* unit) {
    if (number && is_poorly_known(*number))
      words.push_back(fmt::format("the {} is poorly known: {} (95 %)", name,
                                  in_numbers(interval_of(*number), unit)));
  };
  judge(fit.equilibrium, "equilibrium spring", "N/m");
  judge(fit.damper, "damper", "N s/m");
  for (const auto& [k, tau] : fit.branches)
    if (is_poorly_known(k) || is_poorly_known(tau))
      words.push_back(fmt::format("the branch at {} is poorly known: {}, {} (95 %)",
                                  rounded(tau.value, "s"), in_numbers(interval_of(k), "N/m"),
                                  in_numbers(interval_of(tau), "s")));
  const std::size_t numbers =
      2 * fit.branches.size() + (fit.equilibrium ? 1 : 0) + (fit.damper ? 1 : 0);
  if (data.rows.size() < numbers)
    words.emplace_back("there are more numbers in the series than frequencies in the data");
  words.insert(words.end(), data.notes.begin(), data.notes.end());
  return words;
}

}  // namespace vcrit::fit
