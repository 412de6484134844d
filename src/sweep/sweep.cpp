#include "sweep/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "critical/certified.hpp"
#include "simulation/steady/curve.hpp"
#include "sweep/grid.hpp"

namespace vcrit {

namespace {

// Speeds that are found one from another. Fixed, so that the answers do not depend on the number
// of threads.
constexpr std::size_t speeds_at_once = 32;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Answer {
  double critical_velocity = nothing, friction_ratio = nothing, friction_ratio_error = nothing;
  std::string outside;  // why there is nothing

  double operator[](SweptQuantity quantity) const {
    switch (quantity) {
      case SweptQuantity::critical_velocity:
        return critical_velocity;
      case SweptQuantity::friction_ratio:
        return friction_ratio;
      case SweptQuantity::friction_ratio_error:
        return friction_ratio_error;
    }
    throw Bug("a quantity without an answer");
  }
};

class Sweeping {
 public:
  explicit Sweeping(const Sweep& sweep)
      : sweep_(sweep), grid_(sweep.axes), friction_(wants_friction()) {
    refuse_settings();
    refuse_speeds();
  }

  SweptTable run() const {
    std::vector<Answer> answers(grid_.rows());
    const std::size_t parts = (grid_.speeds() + speeds_at_once - 1) / speeds_at_once;
    tbb::parallel_for(std::size_t{0}, grid_.scenes() * parts, [&](std::size_t task) {
      const std::size_t scene = task / parts, first = task % parts * speeds_at_once;
      const std::size_t last = std::min(first + speeds_at_once, grid_.speeds());
      std::vector<Answer> found = answered(scene, first, last);
      for (std::size_t speed = first; speed < last; ++speed)
        answers[grid_.row(scene, speed)] = std::move(found[speed - first]);
    });
    return table(answers);
  }

 private:
  bool wants_friction() const {
    return std::any_of(
        sweep_.quantities.begin(), sweep_.quantities.end(),
        [](SweptQuantity quantity) { return quantity != SweptQuantity::critical_velocity; });
  }

  void refuse_settings() const {
    for (const auto& [name, value] : sweep_.settings)
      for (const Axis& axis : sweep_.axes)
        if (axis.name == name)
          throw InputError({fmt::format("--over {}", name)}, fmt::format("--set {} as well", name),
                           "one of the two");
  }

  void refuse_speeds() const {
    const int speeds = (grid_.speed() != nullptr ? 1 : 0) + (sweep_.velocity ? 1 : 0) +
                       (sweep_.velocity_ratio ? 1 : 0);
    if (speeds > 1 || (friction_ && speeds == 0))
      throw InputError({"sweep"}, speeds == 0 ? "a friction ratio at no speed" : "several speeds",
                       "velocity or velocity_ratio, as an axis (--over) or as one value");
    std::vector<double> values;
    if (grid_.speed() != nullptr) values = grid_.speed()->values;
    for (const auto& speed : {sweep_.velocity, sweep_.velocity_ratio})
      if (speed) values.push_back(*speed);
    for (const double value : values)
      if (!(value > 0))
        throw InputError({"sweep"}, fmt::format("a speed of {}", value), "speeds above 0");
  }

  // One scene at the speeds first to last.
  std::vector<Answer> answered(std::size_t scene_index, std::size_t first, std::size_t last) const {
    Settings settings = grid_.settings(scene_index);
    settings.insert(settings.end(), sweep_.settings.begin(), sweep_.settings.end());
    const Scene scene = parse_scene(sweep_.scene.text, sweep_.scene.file, settings);
    std::vector<Answer> answers(last - first);
    try {
      const double critical = certified_critical_velocity(scene).value;
      for (Answer& answer : answers) answer.critical_velocity = critical;
      if (friction_) add_friction(scene, velocities(critical, first, last), answers);
    } catch (const ModelError& error) {
      for (Answer& answer : answers) answer.outside = error.what();
    }
    return answers;
  }

  std::vector<double> velocities(double critical, std::size_t first, std::size_t last) const {
    if (grid_.speed() == nullptr)
      return {sweep_.velocity ? *sweep_.velocity : *sweep_.velocity_ratio * critical};
    std::vector<double> values;
    for (std::size_t i = first; i < last; ++i)
      values.push_back(grid_.speed()->values[i] *
                       (grid_.speed()->name == "velocity" ? 1 : critical));
    return values;
  }

  static void add_friction(const Scene& scene, const std::vector<double>& velocities,
                           std::vector<Answer>& answers) {
    if (!std::all_of(velocities.begin(), velocities.end(),
                     [](double v) { return v > 0 && std::isfinite(v); }))
      throw ModelError("v* is 0 or infinite, so that velocity_ratio has no meaning");
    const auto curve = simulation::friction_curve(simulation::system_of(scene), velocities);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      answers[i].outside = curve[i].reason;
      if (!curve[i].state) continue;
      answers[i].friction_ratio = curve[i].state->friction_ratio;
      answers[i].friction_ratio_error = curve[i].state->friction_ratio_error;
    }
  }

  SweptTable table(const std::vector<Answer>& answers) const {
    SweptTable table;
    table.rows = answers.size();
    for (const Axis& axis : sweep_.axes) table.columns.push_back(axis.name);
    for (const SweptQuantity quantity : sweep_.quantities)
      table.columns.emplace_back(to_text(quantity));
    for (std::size_t row = 0; row < answers.size(); ++row) {
      const std::vector<double> point = grid_.point(row);
      table.values.insert(table.values.end(), point.begin(), point.end());
      for (const SweptQuantity quantity : sweep_.quantities)
        table.values.push_back(answers[row][quantity]);
      if (answers[row].outside.empty()) continue;
      if (table.outside++ == 0) table.reason = answers[row].outside;
    }
    return table;
  }

  const Sweep& sweep_;
  Grid grid_;
  bool friction_;
};

}  // namespace

const char* to_text(SweptQuantity quantity) {
  switch (quantity) {
    case SweptQuantity::critical_velocity:
      return "critical_velocity";
    case SweptQuantity::friction_ratio:
      return "friction_ratio";
    case SweptQuantity::friction_ratio_error:
      return "friction_ratio_error";
  }
  throw Bug("a quantity without a name");
}

SweptTable swept(const Sweep& sweep) { return Sweeping(sweep).run(); }

std::string to_csv(const SweptTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    text += to_text(table.values[i]);
    text += (i + 1) % table.columns.size() == 0 ? '\n' : ',';
  }
  return text;
}

}  // namespace vcrit
