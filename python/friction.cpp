// Friction by simulation: what `vcrit simulate` answers, at one speed or at many.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>

#include "answers/friction.hpp"
#include "answers/realised_friction.hpp"
#include "arrays.hpp"
#include "base/speeds.hpp"
#include "base/units.hpp"
#include "bindings.hpp"
#include "interrupt.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/steady/energy.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using simulation::SteadyState;

// The index of the first invalid speed. NaN stands for an unknown speed and is allowed.
std::optional<std::size_t> first_refused_speed(const Array& velocities) {
  const std::span<const double> all = values(velocities);
  const auto wrong = std::find_if(all.begin(), all.end(), [](double velocity) {
    return velocity <= 0 || std::isinf(velocity);
  });
  if (wrong == all.end()) return std::nullopt;
  return static_cast<std::size_t>(wrong - all.begin());
}

void refuse_speed(double velocity, std::optional<double> ratio, const std::string& name) {
  if (ratio) check_speed_ratio(*ratio, argument(name));
  check_speed(velocity, argument(name));
}

void require_motion(const Problem& problem) {
  rules::require(rules::motion_question(problem), problem);
}

double parse_velocity(const std::string& text, const std::string& name) {
  return parse_quantity(text, Dimension::velocity, argument(name));
}

double parse_ratio(const std::string& text, const std::string& name) {
  return parse_quantity(text, Dimension::none, argument(name));
}

SteadyState found_by(const Problem& problem, double velocity, const std::string& method,
                     const simulation::MethodOptions& options) {
  if (method == "exact") return SteadyFriction(problem).at(velocity, options.start);
  rules::require(rules::Question::other_methods, problem, method + " ");
  if (const auto other = simulation::method_named(method))
    return simulation::steady_state(*other, simulation::system_of(problem), velocity, options);
  std::string known = "exact";
  for (const simulation::Method each : simulation::all_methods())
    known += std::string(", ") + to_text(each);
  throw InputError(argument("method"), '"' + method + '"', "one of " + known);
}

SteadyState steady_state(const Problem& problem, double velocity, const std::string& method,
                         const std::string& start) {
  if (start != "sliding" && start != "rest")
    throw InputError(argument("start"), '"' + start + '"', "sliding or rest");
  simulation::MethodOptions options;
  if (start == "rest") options.start = simulation::Start::rest;
  SteadyState state = found_by(problem, velocity, method, options);
  if (problem->receptance() != nullptr)
    state.friction_ratio_error += realised_friction(problem, velocity).error;
  return state;
}

SteadyState simulated(const Problem& problem, double velocity, const std::string& method,
                      const std::string& start) {
  const OthersRun others_run;
  return steady_state(problem, velocity, method, start);
}

py::tuple simulate(const Problem& problem, double velocity, const std::string& method,
                   const std::string& start) {
  const SteadyState state = simulated(problem, velocity, method, start);
  py::list events;
  for (const simulation::Event& event : state.events)
    events.append(py::make_tuple(event.phase, to_text(event.to)));
  return py::make_tuple(
      state.friction_ratio, state.friction_ratio_error, to_text(state.regime), state.periods,
      events, state.other_start ? std::optional(state.other_start->agrees) : std::nullopt);
}

// Drive, friction, dampers, error.
std::optional<std::tuple<double, double, double, double>> energy(const Problem& problem,
                                                                 double velocity) {
  if (rules::cells_move(problem)) return std::nullopt;
  const OthersRun others_run;
  const auto balance = simulation::energy_balance(simulation::system_of(problem), velocity);
  if (!balance) return std::nullopt;
  return std::tuple(balance->drive, balance->friction, balance->dampers, balance->error);
}

struct Curve {
  std::span<double> ratio, error;
  std::vector<std::string> regimes, reasons;

  void put(std::size_t i, const simulation::PassingPoint& point) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    ratio[i] = point.state ? point.state->friction_ratio : nothing;
    error[i] = point.state ? point.state->friction_ratio_error : nothing;
    regimes[i] = point.state ? to_text(point.state->regime) : "";
    reasons[i] = point.reason;
  }
};

// Each speed starts from the one before, as in `vcrit sweep`. Ctrl-C is noticed between two lots.
constexpr std::size_t speeds_at_once = 32;

py::tuple friction_curve(const Problem& problem, const Array& velocities, Array ratio,
                         Array error) {
  const std::span<const double> speeds = values(velocities);
  const std::vector<std::string> room(speeds.size());
  Curve curve{values(ratio), values(error), room, room};
  ensure(curve.ratio.size() == speeds.size() && curve.error.size() == speeds.size(),
         "friction_curve has room for all its answers");
  const SteadyFriction friction(problem);
  for (std::size_t first = 0; first < speeds.size(); first += speeds_at_once) {
    {
      const OthersRun others_run;
      const auto lot = speeds.subspan(first, std::min(speeds_at_once, speeds.size() - first));
      friction.curve(lot, [&](std::size_t i, const simulation::PassingPoint& point) {
        curve.put(first + i, point);
      });
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return py::make_tuple(curve.regimes, curve.reasons);
}

}  // namespace

void add_friction(py::module_& module) {
  using py::arg;
  module.def("require_motion", &require_motion, arg("scene"));
  module.def("parse_velocity", &parse_velocity, arg("text"), arg("argument"));
  module.def("parse_ratio", &parse_ratio, arg("text"), arg("argument"));
  module.def("first_refused_speed", &first_refused_speed, arg("velocities").noconvert());
  module.def("refuse_speed", &refuse_speed, arg("velocity"), arg("ratio"), arg("argument"));
  module.def("simulate", &simulate, arg("scene"), arg("velocity"), arg("method"), arg("start"));
  module.def("energy", &energy, arg("scene"), arg("velocity"));
  module.def("friction_curve", &friction_curve, arg("scene"), arg("velocities").noconvert(),
             arg("ratio").noconvert(), arg("error").noconvert());
}

}  // namespace vcrit::python
