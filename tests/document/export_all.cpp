// Prints 200 scenes with random values as JSON lines: v* as `vcrit eval` has it, and its formula
// for every system, in one of the forms. For test_systems.py, which has other systems evaluate
// them.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "base/errors.hpp"
#include "critical/certified.hpp"
#include "document/findings.hpp"
#include "document/printed.hpp"
#include "document/systems/system.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "scene/scene.hpp"
#include "support/random_scene.hpp"

namespace vcrit::test {

namespace {

// The scenes of hand_forms.csv come from the caller: every rheology, drive and kind of Poisson's
// ratio.
constexpr int random_scenes = 92;

/// Of 8 bits: the decimal that the formula has of a number is the double itself, and exact
/// arithmetic stays short.
double rounded(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::round(mantissa * 256), exponent - 8);
}

std::mt19937 numbers(3);

double magnitude() {
  return rounded(std::pow(10, std::uniform_real_distribution(-1.0, 1.0)(numbers)));
}

Scene random_scene(RandomScenes& scenes, int i) {
  Scene scene = scenes.scene(4);
  if (i % 4 == 1) scene.drive = scenes.drive_with_masses(2, scene);
  if (i % 4 == 1 && !scene.mass) scene.mass = Quantity{{"m"}, 1.0};
  if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential)) {
    isotropic->quantity.value = std::round(*isotropic->quantity.value * 64) / 64;
    if (i % 2 == 0) isotropic->quantity.value.reset();
  }
  return scene;
}

Values random_values(const Problem& problem) {
  Values values;
  for (const Symbol& symbol : *problem->elements) values[symbol] = magnitude();
  for (const Quantity& quantity : quantities(problem)) values[quantity.symbol] = magnitude();
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential)) {
    values.erase(isotropic->quantity.symbol);
    if (!isotropic->quantity.value) values[isotropic->quantity.symbol] = 0.28125;
  }
  return values;
}

symbolic::Findings findings(const Problem& problem, int i) {
  using symbolic::ResultForm;
  constexpr std::array forms{ResultForm::shortest,      ResultForm::nested,
                             ResultForm::storage_loss,  ResultForm::rational,
                             ResultForm::dimensionless, ResultForm::expanded};
  symbolic::DocumentOptions options;
  options.form = forms.at(static_cast<std::size_t>(i) % forms.size());
  options.budget = 100;
  try {
    return symbolic::findings_of(problem, options);
  } catch (const ModelError&) {  // beyond the budget
    options.form = ResultForm::nested;
    return symbolic::findings_of(problem, options);
  }
}

void print(const Problem& problem, int i) {
  const Values values = random_values(problem);
  const CertifiedVelocity v = certified_critical_velocity(problem.with(values));
  const symbolic::AlgebraLock lock;
  const symbolic::NamesOfScene names(problem);
  const symbolic::Findings found = findings(problem, i);
  nlohmann::ordered_json line{{"velocity", v.value}, {"bound", v.relative_error_bound}};
  for (const auto& [symbol, value] : values) line["values"][to_text(symbol)] = value;
  for (const symbolic::AlgebraSystem* system : symbolic::systems()) {
    const std::string name(system->name);
    line["texts"][name] = symbolic::system_document(name, problem, found);
  }
  std::cout << line.dump() << '\n';
}

}  // namespace

void export_all() {
  int i = 0;
  for (std::string text; std::getline(std::cin, text, '\0'); ++i)
    print(parse_problem(text, "scene " + std::to_string(i)), i);
  RandomScenes scenes(7, 1);
  for (int last = i + random_scenes; i < last; ++i) print(random_scene(scenes, i), i);
}

}  // namespace vcrit::test
