// A report that cannot turn red proves nothing: each witness in turn says something slightly wrong,
// and the scene's verdict, its line in the index and the names of what failed must show it.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <complex>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "compare/agreement.hpp"
#include "compare/without_formula.hpp"
#include "critical/critical_velocity.hpp"
#include "derivation/derivation.hpp"
#include "formula/symbols.hpp"
#include "problem/problem.hpp"
#include "report/index_page.hpp"
#include "report/scene_page.hpp"
#include "rules/rulebook.hpp"
#include "run/compiler.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "support/scene_text.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_planted_faults)

using namespace vcrit;
using symbolic::Derivation;
using namespace vcrit::validation;
using namespace vcrit::validation::report;

namespace {

const Derivation zener = symbolic::derive(read_scene(VCRIT_SCENES "/zener.toml"));

/// Without the curves of other methods, which no comparison is made of.
Witnesses compared_witnesses() {
  Witnesses witnesses = own_witnesses();
  witnesses.curves = [](const simulation::System&, double) { return std::vector<MethodCurve>(); };
  return witnesses;
}

SceneReport heard(const Witnesses& witnesses, const Derivation& derivation,
                  const Derivation& formula) {
  Driver driver(derivation);
  return agree(
      driver, formula, [](const std::string&) {}, witnesses);
}

SceneReport heard(const Witnesses& witnesses, const Derivation& derivation = zener) {
  return heard(witnesses, derivation, derivation);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// Red on its page and in the index, for these reasons and no others.
void check_red(const SceneReport& report, const std::vector<std::string>& keys) {
  std::vector<std::string> failed;
  for (const Comparison& comparison : report.comparisons)
    if (outcome(comparison) == Comparison::Outcome::failed) failed.push_back(comparison.key);
  BOOST_TEST(failed == keys, boost::test_tools::per_element());
  BOOST_TEST(has(scene_page({report, {}}, example::origin()), "Do not use these numbers"));
  BOOST_TEST(has(index_page({{scene_line(report), "zener.html"}}, example::origin()),
                 "<li class=\"failed\">"));
}

/// Eq. 24 with K_t - (K_d - m omega^2) where the paper has a sum.
double with_a_flipped_sign(const Problem& problem) {
  const Values& values = problem.values();
  const double omega = values.at({"omega", 0}), inertia = values.at({"m", 0}) * omega * omega;
  const double ratio = tangential_ratio(std::get<Isotropic>(problem->tangential));
  const auto contact = ratio * dynamic_stiffness(problem->normal.reduction(), values, omega);
  const auto drive =
      dynamic_stiffness(problem->drive_network()->reduction(), values, omega) - inertia;
  return values.at({"mu0", 0}) * omega * values.at({"du_z", 0}) / ratio *
         std::abs(contact - drive) / std::abs(drive);
}

/// Eq. 24 and the harmonic balance, off by so many thousandths; formula_off_by: as derived.
Witnesses balance_off_by(int thousandths) {
  const double fault = 1 + 1e-3 * thousandths;
  Witnesses witnesses = compared_witnesses();
  witnesses.certified = [fault](const Problem& problem) {
    CertifiedVelocity result = certified_critical_velocity(problem);
    result.value *= fault;
    return result;
  };
  witnesses.formula = [fault](const Problem& problem) {
    return fault * critical_velocity(problem);
  };
  witnesses.balance = [fault](const simulation::System& system) {
    simulation::Onset onset = simulation::sliding_threshold(system);
    onset.contact_velocity *= fault;
    onset.drive_velocity *= fault;
    return onset;
  };
  return witnesses;
}

Derivation formula_off_by(int thousandths, Derivation derivation) {
  derivation.critical_velocity *= GiNaC::numeric(1000 + thousandths, 1000);
  return derivation;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_a_fault_nothing_is_red) {
  const SceneReport report = heard(own_witnesses());
  BOOST_TEST(passed(report));
  BOOST_TEST(!has(scene_page({report, {}}, example::origin()), "Do not use these numbers"));
  // No more than what doubles lose: 32 roundings times the condition number, or the simulator's
  // promise; the last stick has its own error, below that.
  constexpr double u = 0x1p-53, promise = 1e-9;
  const double in_doubles = 32 * u * report.condition;
  BOOST_TEST(report.condition < 100);
  const std::map<std::string, double> allowed{
      {"formula", in_doubles},        {"derived", u * (2 + report.condition)},
      {"generated", in_doubles},      {"generated_batch", in_doubles},
      {"generated_fast", in_doubles}, {"generated_certified", 4 * u},
      {"balance", promise},           {"simulation", 2 * promise},
      {"evaluators", 2 * promise},    {"marched", 1e-3},
      {"starts", 2 * promise}};
  for (const Comparison& comparison : report.comparisons)
    BOOST_TEST(comparison.tolerance <= allowed.at(comparison.key), comparison.key);
}

BOOST_AUTO_TEST_CASE(a_flipped_sign_in_the_formula_is_red) {
  Witnesses witnesses = compared_witnesses();
  witnesses.formula = with_a_flipped_sign;
  check_red(heard(witnesses), {"formula", "evaluators"});
}

BOOST_AUTO_TEST_CASE(a_flipped_sign_in_the_derivation_is_red) {
  Derivation formula = zener;
  const GiNaC::ex kd = symbolic::symbol({"kd", 0});
  formula.critical_velocity = formula.critical_velocity.subs(kd == -kd);
  check_red(heard(compared_witnesses(), zener, formula), {"derived", "evaluators"});
}

// A thousandth is far above what any plotting width shows.
BOOST_AUTO_TEST_CASE(a_reduced_stiffness_in_the_simulator_is_red) {
  Witnesses witnesses = compared_witnesses();
  witnesses.system = [](const Problem& problem) {
    simulation::System system = simulation::system_of(problem);
    system.contact = scaled(system.contact, 0.999);
    return system;
  };
  const SceneReport report = heard(witnesses);
  BOOST_TEST(!passed(report));
  check_red(report, {"balance", "simulation", "evaluators", "marched"});
}

// Whatever stands on the harmonic balance says the same: only the motion knows better.
BOOST_AUTO_TEST_CASE(a_fault_in_formula_and_harmonic_balance_is_red) {
  const std::vector<std::string> red{
      "generated",  "generated_batch", "generated_fast", "generated_certified",
      "simulation", "evaluators",      "marched"};
  for (const int thousandths : {-2, 2})
    check_red(heard(balance_off_by(thousandths), zener, formula_off_by(thousandths, zener)), red);
  for (const char* file : {VCRIT_SCENES "/sonotrode.toml",
                           VCRIT_TEST_DATA "/../matrix/kinds/drive_graph_masses.toml"}) {
    const Derivation scene = symbolic::derive(read_scene(file));
    BOOST_TEST(passed(heard(compared_witnesses(), scene)));
    check_red(heard(balance_off_by(2), scene, formula_off_by(2, scene)), red);
  }
}

// The same where nothing marches in time: periodic motion on a grid knows better. Below a measured
// drive the last stick of the structure knows better, too.
BOOST_AUTO_TEST_CASE(without_a_march_the_same_fault_is_red) {
  for (const char* file :
       {VCRIT_SCENES "/measured_drive.toml", VCRIT_TEST_DATA "/../matrix/kinds/lossy.toml"}) {
    const Derivation scene = symbolic::derive(read_scene(file));
    BOOST_TEST_CONTEXT(file) {
      const SceneReport right = heard(compared_witnesses(), scene);
      BOOST_TEST(passed(right));
      BOOST_TEST((outcome(*std::ranges::find(right.comparisons, "periodic", &Comparison::key)) ==
                  Comparison::Outcome::passed));
      const SceneReport wrong = heard(balance_off_by(2), scene, formula_off_by(2, scene));
      const bool generated{rules::answer(rules::Question::evaluator, scene.problem)};
      std::vector<std::string> red{"periodic"};
      if (generated)
        red = {"generated", "generated_batch", "generated_fast", "generated_certified", "periodic"};
      if (scene.problem->receptance() != nullptr) red.insert(red.end() - 1, "simulation");
      check_red(wrong, red);
    }
  }
}

// Below an indenter the last stick of any cell, and another method on that cell, know better.
BOOST_AUTO_TEST_CASE(below_an_indenter_the_same_fault_is_red) {
  for (const char* file : {"/indenter_elastic.toml", "/indenter_viscoelastic.toml"})
    BOOST_TEST_CONTEXT(file) {
      const Derivation scene =
          symbolic::derive(read_scene(VCRIT_TEST_DATA "/../matrix/kinds" + std::string(file)));
      BOOST_TEST(passed(heard(compared_witnesses(), scene)));
      check_red(heard(balance_off_by(2), scene, formula_off_by(2, scene)),
                {"generated", "generated_batch", "generated_fast", "generated_certified",
                 "simulation", "evaluators", "marched"});
    }
}

// Less friction in the cells than in the scene: v* is smaller by as much.
BOOST_AUTO_TEST_CASE(a_fault_in_the_half_space_is_red) {
  const Derivation scene =
      symbolic::derive(read_scene(VCRIT_TEST_DATA "/../matrix/kinds/indenter_elastic.toml"));
  Witnesses witnesses = compared_witnesses();
  witnesses.half_space = [](const Problem& right) {
    const Symbol& friction = right->coefficient.symbol;
    return indenter::HalfSpace(right.with({{friction, 0.998 * right.values().at(friction)}}));
  };
  const SceneReport report = heard(witnesses, scene);
  for (const char* key : {"balance", "simulation", "evaluators", "marched"})
    BOOST_TEST((outcome(*std::ranges::find(report.comparisons, key, &Comparison::key)) ==
                Comparison::Outcome::failed),
               key);
}

// On a drive that gives there is no formula, and plain cells that march know better: with less
// friction in them v* is less, and at one speed friction another.
BOOST_AUTO_TEST_CASE(a_fault_below_an_indenter_on_a_drive_is_red) {
  const auto outcome_of = [](const SceneReport& report, const char* key) {
    return outcome(*std::ranges::find(report.comparisons, key, &Comparison::key));
  };
  for (const bool fault : {false, true}) {
    const Problem scene =
        read_problem(fault ? VCRIT_TEST_DATA "/../matrix/kinds/indenter_drive.toml"
                           : VCRIT_SCENES "/leaf_spring.toml");
    Witnesses witnesses = compared_witnesses();
    if (fault)
      witnesses.half_space = [](const Problem& of) {
        const Symbol& friction = of->coefficient.symbol;
        return indenter::HalfSpace(of.with({{friction, 0.998 * of.values().at(friction)}}));
      };
    const SceneReport report = report_without_formula(scene, "no formula", witnesses);
    BOOST_TEST(report.failure == "No formula.");
    const auto expected = fault ? Comparison::Outcome::failed : Comparison::Outcome::passed;
    for (const char* key : {"harmonics", "marched", "cells"})
      BOOST_TEST((outcome_of(report, key) == expected), key << " " << fault);
    // Friction's own, which the fault does not touch.
    BOOST_TEST((outcome_of(report, "rise") == Comparison::Outcome::passed));
  }
}

BOOST_AUTO_TEST_CASE(a_speed_of_zero_or_infinity_that_is_none_is_red) {
  for (const double wrong : {0.0, std::numeric_limits<double>::infinity()}) {
    Witnesses witnesses = compared_witnesses();
    witnesses.certified = [wrong](const Problem&) { return CertifiedVelocity{wrong, 0, {}}; };
    const SceneReport report = heard(witnesses);
    BOOST_TEST((outcome(*std::ranges::find(report.comparisons, "periodic", &Comparison::key)) ==
                Comparison::Outcome::failed));
  }
  for (const char* file : {"/antiresonance.toml", "/resonance.toml"}) {
    const SceneReport report =
        heard(compared_witnesses(),
              symbolic::derive(read_scene(VCRIT_TEST_DATA "/../matrix/kinds" + std::string(file))));
    BOOST_TEST((outcome(*std::ranges::find(report.comparisons, "periodic", &Comparison::key)) ==
                Comparison::Outcome::passed));
  }
}

// kd = m omega^2 as typed, but m is no double: of the doubles v* is 1e14 m/s, which nothing can be
// held against. The page says what vcrit eval says of the numbers as typed.
BOOST_AUTO_TEST_CASE(a_resonance_as_typed_is_one_on_the_page) {
  const auto report_of = [](double kn, double kd) {
    const test::SceneText scene{.tangential_ratio = 1,
                                .network = "kd",
                                .mass = "1 g",
                                .angular_frequency = 1e5,
                                .amplitude = 1e-7,
                                .indentation = 5e-7,
                                .coefficient = 0.3,
                                .elements = {{"kn", kn}, {"kd", kd}}};
    return heard(compared_witnesses(),
                 symbolic::derive(parse_problem(test::to_toml(scene), "typed.toml")));
  };
  const SceneReport resonance = report_of(8e6, 1e7);
  BOOST_TEST(std::isfinite(resonance.velocity_of_doubles));
  BOOST_TEST((resonance.effect->kind == Effect::Kind::all_speeds));
  const SceneReport antiresonance = report_of(4e6, 6e6);
  BOOST_TEST(antiresonance.velocity_of_doubles > 0);
  BOOST_TEST((antiresonance.effect->kind == Effect::Kind::never));
  for (const SceneReport& report : {resonance, antiresonance}) {
    BOOST_TEST(passed(report));
    BOOST_TEST((outcome(*std::ranges::find(report.comparisons, "periodic", &Comparison::key)) ==
                Comparison::Outcome::not_run));
    BOOST_TEST(report.influences.empty());
  }
}

// Its body swings freely at twice the frequency: friction is full from 0.707 of Eq. 24 on.
BOOST_AUTO_TEST_CASE(a_border_that_is_not_that_of_the_formula_is_red) {
  const Scene free_swing = read_scene(VCRIT_TEST_DATA "/undamped/undamped_harmonic_2.toml");
  check_red(heard(compared_witnesses(), symbolic::derive(free_swing)), {"balance"});
}

// What a report allows a v* that is computed again, by motion or by another start, is no more than
// the digits that it says it may lose.
BOOST_AUTO_TEST_CASE(a_simulated_velocity_off_by_a_hundred_millionth_is_red) {
  Witnesses witnesses = compared_witnesses();
  witnesses.system = [](const Problem& problem) {
    simulation::System system = simulation::system_of(problem);
    system.friction *= 1 + 1e-8;
    return system;
  };
  const SceneReport report = heard(witnesses);
  BOOST_TEST(!passed(report));
  BOOST_TEST((outcome(*std::ranges::find(report.comparisons, "simulation", &Comparison::key)) ==
              Comparison::Outcome::failed));
}

// A millionth from resonance a thousandth of v* is a billionth of the drive's stiffness. Tolerances
// grow with the condition number, 4 million there, and leave three digits more than that.
BOOST_AUTO_TEST_CASE(near_resonance_right_is_green_and_a_fault_is_red) {
  const Derivation near = symbolic::derive(
      test::scene_of({.tangential = "kt",
                      .network = "kd | cd",
                      .mass = 1e-3,
                      .angular_frequency = 1e5,
                      .amplitude = 1e-7,
                      .indentation = 5e-7,
                      .coefficient = 0.3,
                      .elements = {{"kn", 1e7}, {"kt", 8e6}, {"kd", 10000010}, {"cd", 1e-5}}}));
  Witnesses witnesses = compared_witnesses();
  // A body that rings for millions of periods: another method would march for long to say nothing.
  witnesses.march = [](const Border&, const simulation::System&) {
    Comparison comparison;
    comparison.key = "marched";
    comparison.not_run = true;
    return comparison;
  };
  BOOST_TEST(passed(heard(witnesses, near)));
  witnesses.system = [](const Problem& problem) {
    simulation::System system = simulation::system_of(problem);
    system.drive = scaled(*system.drive, 1 + 1e-9);
    return system;
  };
  const SceneReport report = heard(witnesses, near);
  for (const char* key : {"balance", "simulation", "evaluators"})
    BOOST_TEST((outcome(*std::ranges::find(report.comparisons, key, &Comparison::key)) ==
                Comparison::Outcome::failed));
}

// A compiler that changes what it compiles: v* off by 1e-8 in each call that has the words below.
BOOST_AUTO_TEST_CASE(an_evaluator_off_by_a_hundred_millionth_is_red) {
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const PrivateFolder folder;
  write_file(folder.path() / "g++",
             "#!/bin/sh\nfor file in scene.hpp; do [ ! -f $file ] || "
             "sed -i 's/(p)\\.value; }/(p).value * (1 + 1e-8); }/' $file; done\nexec " +
                 compiler->string() + " \"$@\"\n");
  std::filesystem::permissions(folder.path() / "g++", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
  const SceneReport report = heard(compared_witnesses());
  setenv("PATH", path.c_str(), 1);
  check_red(report, {"generated", "generated_fast", "evaluators"});
}

BOOST_AUTO_TEST_SUITE_END()
