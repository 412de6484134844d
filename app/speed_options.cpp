#include "speed_options.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <cmath>

#include "answers/critical_onset.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "base/speeds.hpp"
#include "base/units.hpp"
#include "options.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::app {

void SpeedOptions::add_to(CLI::App& command, std::optional<double> usual_ratio) {
  CLI::Option_group* speed = command.add_option_group("speed");
  speed->add_option("--velocity", velocity_, "mean velocity of the drive: 0.02 or \"20 mm/s\"");
  CLI::Option* ratio =
      speed->add_option("--velocity-ratio", ratio_, "drive speed as a multiple of v*: 0.5 or 50%");
  ratio->type_name("RATIO");
  of_ratio_ = ratio;
  if (usual_ratio) {
    ratio_ = fmt::format("{}", *usual_ratio);
    ratio->default_str(fmt::format("{}", *usual_ratio));
    speed->require_option(0, 1);
  } else {
    speed->require_option(1);
  }
}

std::string SpeedOptions::given() const {
  if (!velocity_.empty()) return "--velocity";
  return of_ratio_->count() > 0 ? "--velocity-ratio" : "";
}

Speed SpeedOptions::of(const Problem& problem) const {
  rules::require(rules::motion_question(problem), problem);
  const CriticalOnset onset = critical_onset(problem);
  const double critical = onset.contact_velocity;
  const bool by_ratio = velocity_.empty();
  if (by_ratio && std::isinf(critical))
    throw ModelError(onset.reason + ": --velocity-ratio has no meaning, give --velocity");
  if (by_ratio && critical == 0)
    throw ModelError("v* is 0 here: --velocity-ratio has no meaning, give --velocity");
  const double ratio = by_ratio ? speed_ratio_of(ratio_) : 1;
  if (by_ratio) check_speed_ratio(ratio, {"--velocity-ratio"}, ratio_);
  const double velocity =
      by_ratio ? ratio * critical : parse_quantity(velocity_, Dimension::velocity, {"--velocity"});
  if (by_ratio && !(velocity > 0 && std::isfinite(velocity)))
    throw InputError({"--velocity-ratio"}, ratio_,
                     fmt::format("a ratio to v* = {} whose speed is within the range of doubles",
                                 rounded(critical, "m/s")));
  if (!by_ratio) check_speed(velocity, {"--velocity"});
  return {velocity, velocity / critical, critical};
}

}  // namespace vcrit::app
