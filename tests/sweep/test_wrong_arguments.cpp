// What a caller in C++ may hand over by mistake is wrong input, named as such, whatever is called:
// no bug, no crash and no number. Systems made by hand are tried in simulation/system/test_check.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "answers/closed_share.hpp"
#include "answers/critical_onset.hpp"
#include "answers/critical_onsets.hpp"
#include "base/constants.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "indenter/friction.hpp"
#include "network/graph.hpp"
#include "scene/receptance.hpp"
#include "scene/scene.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/mass_amplitudes.hpp"
#include "stiffness/drive_motion.hpp"
#include "stiffness/dynamic_matrix.hpp"
#include "stiffness/relaxation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(test_wrong_arguments)

using namespace vcrit;
using test::refused;

namespace {

using Column = std::span<const double>;
using Columns = std::vector<Column>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

Problem shipped(const std::string& name) { return read_problem(VCRIT_SCENES "/" + name + ".toml"); }

const std::vector<double> one{2e4}, two{2e4, 3e4};

Sweep sweep_of(const Problem& problem) {
  return {problem,
          {axis_of("frequency", {2e4}, problem)},
          {parse_swept_quantity("friction_ratio", problem)},
          1e-3,
          {}};
}

// Of two springs between the terminals and one inner node.
Graph chain() {
  const Network part = spring(Amount{Symbol{"k"}});
  return {{"a", "b", "c"}, {part, part}, {{0, 2}, {2, 1}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(columns_of_other_numbers_and_lengths) {
  const Problem zener = shipped("zener"), separation = shipped("separation");
  std::vector<double> out(3);
  for (const Problem& problem : {zener, separation}) {
    const CriticalOnsets onsets(problem, {"frequency"});
    BOOST_TEST(refused([&] { onsets({}, out); }, "columns: found 0 of them; expected 1"));
    BOOST_TEST(refused([&] { onsets(Columns{two}, out); }, "frequency: found 2 values"));
    BOOST_TEST(refused([&] { onsets.first_refused({}, 3); }, "columns: found 0 of them"));
    BOOST_TEST(refused([&] { onsets.first_refused(Columns{two}, 3); }, "found 2 values"));
  }
  const ClosedShare share(zener, {"amplitude", "frequency"});
  BOOST_TEST(refused([&] { share(Columns{one}, out); }, "columns: found 1 of them"));
}

BOOST_AUTO_TEST_CASE(symbols_of_no_scene) {
  const Problem zener = shipped("zener");
  const Symbol none{"none"};
  BOOST_TEST(refused([&] { zener.with({{none, 1}}); }, "values: found one for none"));
  BOOST_TEST(refused([&] { certified_log_derivative(zener, none); }, "symbol: found none"));
  for (const char* name : {"zener", "separation"})
    BOOST_TEST(refused([&] { onset_log_derivative(shipped(name), none); }, "symbol: found none"));
}

// v* of frequencies at which its factors are beyond doubles: a number or its limit, and no NaN.
BOOST_AUTO_TEST_CASE(frequencies_at_the_end_of_doubles) {
  const Problem zener = shipped("zener");
  for (const double omega : {1e300, 1e308, 5e-324})
    BOOST_TEST(critical_velocity(zener, omega) ==
               certified_critical_velocity(zener.with({{Symbol{"omega"}, omega}})).value);
}

BOOST_AUTO_TEST_CASE(sweeps) {
  const Problem zener = shipped("zener");
  const auto refuses = [&](const std::string& words, const auto& change) {
    Sweep sweep = sweep_of(zener);
    change(sweep);
    return refused([&] { swept(sweep); }, words);
  };
  BOOST_TEST(refuses("over frequency: found an axis without values",
                     [](Sweep& sweep) { sweep.axes[0].values.clear(); }));
  BOOST_TEST(
      refuses("velocity: found a speed of ∞", [](Sweep& sweep) { sweep.velocity = infinity; }));
  BOOST_TEST(refuses("symbol: found ; expected a symbol", [](Sweep& sweep) {
    sweep.quantities[0].kind = SweptQuantity::Kind::sensitivity;
  }));
  const Sweeping sweeping(sweep_of(zener));
  BOOST_TEST(refused([&] { sweeping.answer(1); }, "block: found 1; expected one of 1"));
}

// An element that an axis takes to 0 is none of the network: no share of it changes v*.
BOOST_AUTO_TEST_CASE(the_sensitivity_to_an_element_of_value_0) {
  test::SceneText two = test::slow_zener();
  two.normal = "k0 | (k1 - c1) | (k2 - c2)";
  two.indentation = 3e-7;
  two.elements.insert(two.elements.end(), {{"k2", 1e6}, {"c2", 10}});
  const Problem two_branches = test::scene_of(two);
  const SweptTable table = swept({two_branches,
                                  {axis_of("k1", {0, 2e6}, two_branches)},
                                  {parse_swept_quantity("sensitivity:k1", two_branches)},
                                  {},
                                  {}});
  BOOST_TEST(table.values[1] == 0);
  BOOST_TEST(table.values[3] < 0);
}

BOOST_AUTO_TEST_CASE(graphs_made_by_hand) {
  BOOST_TEST(springs_alone(Network{chain()}).has_value());
  const auto refuses = [](const std::string& words, const auto& change) {
    Graph graph = chain();
    change(graph);
    return refused([&] { springs_alone(Network{graph}); }, words) &&
           refused([&] { load_carrying(graph); }, words);
  };
  BOOST_TEST(refuses("a graph of 0 nodes", [](Graph& graph) { graph.nodes.clear(); }));
  BOOST_TEST(
      refuses("2 wires with 3 parts", [](Graph& graph) { graph.parts.push_back(graph.parts[0]); }));
  BOOST_TEST(refuses("a wire from -1 to 2", [](Graph& graph) { graph.wires[0] = {-1, 2}; }));
  BOOST_TEST(refuses("a wire from 0 to 7", [](Graph& graph) { graph.wires[0] = {0, 7}; }));
}

BOOST_AUTO_TEST_CASE(forms_and_structures_made_by_hand) {
  const Network part = spring(Amount{Symbol{"k"}});
  for (const double body : {-1.0, no_number, infinity})
    BOOST_TEST(refused([&] { drive_structure(part, {{Symbol{"k"}, 1}}, body); }, "body: found"));
  BOOST_TEST(refused([] { drive_motion({}); }, "drive: found masses, matrices and vectors"));
  BOOST_TEST(refused([] { displacements({}, 1); }, "drive: found masses, matrices and vectors"));
  BOOST_TEST(refused([] { parallel(std::vector<Relaxation>{}); }, "parts: found none"));
  BOOST_TEST(refused([] { series(std::vector<Relaxation>{}); }, "parts: found none"));
  BOOST_TEST(refused([] { dual({1, {1, 2}, {1}}); }, "weights: found 1 for 2 poles"));
  BOOST_TEST(refused([] { positive_roots({1, 1, {1, 2}, {1}}); }, "weights: found 1 for 2"));
  BOOST_TEST(refused([] { bracket({}, 1); }, "receptance: found a table without rows"));
}

BOOST_AUTO_TEST_CASE(speeds_samples_and_cells) {
  const simulation::System system = simulation::system_of(shipped("zener"));
  for (const double velocity : {-1.0, 0.0, no_number, infinity})
    BOOST_TEST(refused([&] { simulation::mass_amplitudes(system, velocity); },
                       "expected a finite speed above 0"));
  BOOST_TEST(
      refused([&] { simulation::steady_state(system, 1e-3, simulation::Start::sliding, -1); },
              "samples: found -1 points"));
  const indenter::HalfSpace sphere(shipped("sphere"));
  BOOST_TEST(refused([&] { sphere.cell_under(infinity); }, "a mean indentation of ∞ there"));
}

BOOST_AUTO_TEST_SUITE_END()
