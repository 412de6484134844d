// The simulator in a page. The page loads a scene, sets its numbers and asks; every answer is that
// of the program's own sources. Functions return a status as the program does: 0, 2 for wrong
// input, 3 for what is outside the model, 1 for a bug; message() then says why. Numbers are left in
// results().
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/constants.hpp"
#include "critical/admissibility.hpp"
#include "critical/conditioning.hpp"
#include "critical/critical_velocity.hpp"
#include "live/scene_text.hpp"
#include "modes/general_modes.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/answers.hpp"
#include "simulation/steady/normal_force.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit::live {

namespace {

enum Status { fine = 0, bug = 1, wrong_input = 2, outside_the_model = 3 };

// A curve of a system that is hard to simulate ends with a reason after some seconds; a page must
// not hang.
constexpr std::size_t effort_of_page = 100'000'000;

struct Explored {
  explicit Explored(const Problem& loaded) : scene(loaded), now(loaded) {
    for (const auto& [symbol, value] : scene.known_values()) {
      symbols.push_back(symbol);
      values.push_back(value);
    }
  }

  Problem scene;
  std::vector<Symbol> symbols;  // in the order of known_values()
  std::vector<double> values;
  Problem now;
  simulation::KnownModes known_modes = {};  // over all values of the scene
  // Of `now`, made when something moves.
  std::optional<simulation::System> system = {};
  std::unique_ptr<SharedEffort> effort = {};
  std::unique_ptr<simulation::Answers> answers = {};
};

std::string text, said;
std::vector<double> numbers;
std::optional<Explored> explored;

template <class Ask>
int answered(const Ask& ask) {
  said.clear();
  numbers.clear();
  try {
    ask();
    return fine;
  } catch (const ModelError& error) {
    said = error.what();
    return outside_the_model;
  } catch (const InputError& error) {
    said = error.what();
    return wrong_input;
  } catch (const std::exception& error) {
    said = error.what();
    return bug;
  }
}

const simulation::System& system() {
  if (!explored->system) {
    explored->system = simulation::system_of(explored->now);
    explored->system->known_modes = &explored->known_modes;
  }
  return *explored->system;
}

simulation::Answers& answers() {
  if (!explored->answers) {
    simulation::System limited = system();
    explored->effort = std::make_unique<SharedEffort>(effort_of_page);
    limited.effort = explored->effort.get();
    explored->answers = std::make_unique<simulation::Answers>(limited);
  }
  return *explored->answers;
}

bool has_formula() { return bool{rules::answer(rules::Question::formula, explored->now)}; }

/// Eq. (24), infinite or 0 where an undamped resonance or antiresonance is so near that doubles do
/// not tell how near: v* grows or falls towards it.
double velocity_by_formula(const Problem& problem) {
  const Values& values = problem.values();
  double velocity = critical_velocity(problem);
  if (!leaves_digits(formula_tolerance(condition_number(problem, values)))) {
    const auto beside = [&, omega = values.at(problem->angular_frequency.symbol)](double share) {
      return critical_velocity(problem, omega * (1 + share));
    };
    // A hundredfold at a resonance, a hundredth at an antiresonance, 1 where neither is near.
    const double growth = beside(1e-8) / beside(1e-6);
    velocity = growth > 2 ? infinity : growth < 0.5 ? 0 : velocity;
  }
  if (std::isnan(velocity))
    throw ModelError("doubles have no digit of v* here; vcrit eval has all of them");
  return velocity;
}

void put(const simulation::SteadyState& state) {
  numbers.insert(numbers.end(), {state.friction_ratio, state.friction_ratio_error,
                                 static_cast<double>(state.regime)});
}

}  // namespace

}  // namespace vcrit::live

using namespace vcrit;        // NOLINT(google-build-using-namespace)
using namespace vcrit::live;  // NOLINT(google-build-using-namespace)

#define VCRIT_EXPORT(name) extern "C" __attribute__((export_name(#name)))

VCRIT_EXPORT(message) const char* message() { return said.c_str(); }
VCRIT_EXPORT(message_size) std::size_t message_size() { return said.size(); }
VCRIT_EXPORT(results) const double* results() { return numbers.data(); }
VCRIT_EXPORT(results_size) std::size_t results_size() { return numbers.size(); }

/// Room for the text of a scene, read by load().
VCRIT_EXPORT(room) char* room(std::size_t size) {
  text.assign(size, ' ');
  return text.data();
}

/// Takes the scene; results: its numbers in SI, in the order in which set() counts them.
VCRIT_EXPORT(load) int load() {
  return answered([] {
    explored.emplace(Problem(scene_of(text)));
    numbers = explored->values;
  });
}

/// Remembers a number; move() takes all of them.
VCRIT_EXPORT(set) void set(std::size_t place, double value) { explored->values[place] = value; }

VCRIT_EXPORT(move) int move() {
  return answered([] {
    explored->answers.reset();
    explored->system.reset();
    Values values;
    for (std::size_t i = 0; i < explored->symbols.size(); ++i)
      values[explored->symbols[i]] = explored->values[i];
    explored->now = explored->scene.with(values);
  });
}

/// Why v* or the motion is outside the model, a line a reason; empty where nothing is.
VCRIT_EXPORT(reasons) int reasons() {
  return answered([] {
    for (const std::string& reason : inadmissible_reasons(explored->now)) said += reason + "\n";
  });
}

/// v* of the contact point, the drive's speed there, and 1 where the formula gives it, 0 where the
/// simulated motion does.
VCRIT_EXPORT(critical) int critical() {
  return answered([] {
    if (has_formula()) {
      const double velocity = velocity_by_formula(explored->now);
      numbers = {velocity, velocity + creep_velocity(explored->now), 1};
    } else {
      const simulation::Onset onset = simulation::sliding_threshold(system());
      numbers = {onset.contact_velocity, onset.drive_velocity, 0};
    }
  });
}

/// The amplitude up to which the contact stays closed, of a linear normal network, and the mean
/// normal force of the contact as if closed.
VCRIT_EXPORT(closed) int closed() {
  return answered([] {
    const rules::Facts facts(explored->now);
    const double amplitude = explored->now.value(explored->now->amplitude);
    const auto mean = static_cast<double>(facts.mean_force()),
               oscillating = static_cast<double>(facts.oscillating_force());
    const double indentation = facts.indentation();
    const double by_force = amplitude * (mean / oscillating);
    numbers = {explored->now->mount ? by_force : std::min(indentation, by_force), mean};
  });
}

/// The mean normal force of the motion, N.
VCRIT_EXPORT(load_on_average) int load_on_average() {
  return answered([] { numbers = {simulation::mean_normal_force(system())}; });
}

/// Friction ratio, its error and the regime at a speed of the drive, found from the speed before.
VCRIT_EXPORT(friction_next) int friction_next(double velocity) {
  return answered([&] { put(answers().next(velocity)); });
}

/// The same by itself, as `vcrit simulate` has it; then the number of events and each of them,
/// phase and kind of motion, and the samples of one period: phase, contact velocity, force, its
/// bound.
VCRIT_EXPORT(friction) int friction(double velocity, int samples) {
  return answered([&] {
    const simulation::SteadyState& state =
        answers().at(velocity, simulation::Start::sliding, samples);
    put(state);
    numbers.push_back(static_cast<double>(state.events.size()));
    for (const auto& [phase, to] : state.events)
      numbers.insert(numbers.end(), {phase, static_cast<double>(to)});
    for (const auto& [phase, speed, force, bound] : state.cycle)
      numbers.insert(numbers.end(), {phase, speed, force, bound});
  });
}
