// The members of a scene are public: what reading would have refused is refused where a changed
// one is evaluated or simulated, as wrong input and never as a bug. What has to be refused is by
// the comments of scene.hpp and network.hpp.
#include "scene/members.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "indenter/half_space.hpp"
#include "normal/gap.hpp"
#include "problem/problem.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/relaxation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_members)

using namespace vcrit;
using test::refused;

namespace {

Scene with_drive() {
  return test::scene_of(
      {.normal = "k", .network = "kd", .mass = 1, .elements = {{"k", 3}, {"kd", 2}}});
}

Scene with_indenter() {
  return test::scene_of({.normal = "spring(E)",
                         .indenter = "shape = \"parabola\"\nradius = 1\n",
                         .elements = {{"E", 3}}});
}

/// By whatever evaluates or simulates a scene.
template <class Change>
void check_refused(Scene scene, const std::string& found, const Change& change) {
  resolve(scene).values();  // right as it was read
  change(scene);
  const std::string words = "s.toml: found " + found;
  BOOST_TEST_CONTEXT(found) {
    BOOST_TEST(refused([&] { resolve(scene).values(); }, words));
    BOOST_TEST(refused([&] { critical_onset(scene); }, words));
    try {
      BOOST_TEST(refused([&] { SteadyFriction(scene).at(0.01); }, words));
    } catch (const ModelError&) {
      // Masses and tables have no motion, whatever else is wrong.
    }
  }
}

void set_radius(Scene& scene, std::optional<double> radius) {
  scene.indenter->sizes.front().value = radius;
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_of_networks_are_among_the_elements) {
  check_refused(with_drive(), "k2 in the normal network but not in elements",
                [](Scene& s) { s.normal = spring({"k2"}); });
  check_refused(with_drive(), "c in the drive network but not in elements", [](Scene& s) {
    s.drive = parallel({*s.drive, damper({"c"})});
  });
  check_refused(with_drive(), "k in the normal network but not in elements",
                [](Scene& s) { s.elements.erase(s.elements.begin()); });
  // omega is a number of the scene, but no element.
  check_refused(with_drive(), "omega in the tangential network but not in elements",
                [](Scene& s) { s.tangential = spring({"omega"}); });
}

BOOST_AUTO_TEST_CASE(masses_belong_to_the_far_end_of_a_drive) {
  check_refused(with_drive(), "a mass in the normal network",
                [](Scene& s) { s.normal = mass({"k"}); });
  check_refused(with_drive(), "mass kd in the drive between two moving points", [](Scene& s) {
    s.drive = series({mass({"kd"}), spring({"k"})});
  });
  check_refused(with_drive(), "a drive in which only masses lead to the far end", [](Scene& s) {
    s.drive = series({spring({"k"}), mass({"kd"})});
  });
}

BOOST_AUTO_TEST_CASE(parts_that_do_not_fit_together) {
  check_refused(with_drive(), "drive and receptance",
                [](Scene& s) { s.receptance = Receptance{}; });
  check_refused(with_indenter(), "indenter with a tangential contact by other means than poisson",
                [](Scene& s) {
                  s.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, 0.8}};
                });
  check_refused(with_indenter(), "indenter with a tangential contact by other means than poisson",
                [](Scene& s) { s.tangential = spring({"E"}); });
}

BOOST_AUTO_TEST_CASE(indenters_have_their_sizes) {
  check_refused(with_indenter(), "indenter parabola with 0 sizes",
                [](Scene& s) { s.indenter->sizes.clear(); });
  check_refused(with_indenter(), "indenter power with 1 sizes",
                [](Scene& s) { s.indenter->shape = Indenter::Shape::power; });
  check_refused(with_indenter(), "no value for radius",
                [](Scene& s) { set_radius(s, std::nullopt); });
  for (const double radius : {0.0, -1.0})
    check_refused(with_indenter(), radius == 0 ? "radius = 0" : "radius = -1",
                  [radius](Scene& s) { set_radius(s, radius); });
  check_refused(with_indenter(), "an indenter by a table without profile", [](Scene& s) {
    s.indenter = Indenter{Indenter::Shape::table, {}, {}};
  });
  const auto with_rows = [](std::vector<Profile::Row> rows) {
    return [rows](Scene& s) {
      s.indenter = Indenter{Indenter::Shape::table, {}, Profile{"", rows}};
    };
  };
  check_refused(with_indenter(), "no row of numbers", with_rows({}));
  check_refused(with_indenter(), "r = 0 after 1", with_rows({{0, 0}, {1, 1}, {0, 2}}));
  check_refused(with_indenter(), "f = nan after 0", with_rows({{0, 0}, {1, NAN}}));
}

BOOST_AUTO_TEST_CASE(an_indenter_and_a_place_below_it_by_themselves) {
  BOOST_TEST(refused([] { indenter::Gap(Indenter{}); }, "indenter: found indenter flat"));
  const indenter::HalfSpace half_space(with_indenter());
  BOOST_TEST(refused([&] { half_space.cell(2 * half_space.edge()); }, "x: found a mean"));
}

BOOST_AUTO_TEST_CASE(a_ratio_without_a_value) {
  BOOST_TEST(refused(
      [] {
        tangential_ratio({Isotropic::By::poisson, {{"nu"}, {}}});
      },
      "nu: found no value"));
}

// Networks and values by hand, as in docs/library.md.
BOOST_AUTO_TEST_CASE(networks_by_themselves) {
  const Values values{{{"k"}, 1.0}};
  const auto wrong = [&](const Network& network, const Values& given, const std::string& words) {
    BOOST_TEST(refused([&] { dynamic_stiffness(network, given, 1); }, words));
    BOOST_TEST(refused([&] { relaxation_form(network, given); }, words));
  };
  const auto graph = [](std::vector<Wire> wires) {
    return Network{Graph{{"a", "b", "c", "d"}, {wires.size(), spring({"k"})}, std::move(wires)}};
  };
  wrong(spring({"k"}), {}, "values: found none for k");
  wrong(Network{Series{}}, values, "network: found series without parts");
  wrong(series({spring({"k"}), Network{Parallel{}}}), values, "network: found parallel without");
  wrong(graph({{0, 4}}), values, "network: found a wire from 0 to 4");
  wrong(graph({{0, 0}}), values, "network: found a wire from 0 to 0");
  wrong(Network{Graph{{"a", "b"}, {spring({"k"})}, {}}}, values, "network: found a graph of 2");
  BOOST_TEST(refused(
      [] {
        relaxation_form(mass({"k"}), {{{"k"}, 1.0}});
      },
      "network: found a mass"));
  BOOST_TEST(refused(
      [] {
        relaxation_form(spring({"k"}), {{{"k"}, -1.0}});
      },
      "values: found k = "));
  // A part that leads nowhere; no path between the terminals.
  for (const auto& wires : {std::vector<Wire>{{0, 1}, {1, 2}, {2, 3}}, {{0, 2}, {1, 3}}})
    BOOST_TEST(
        refused([&] { dynamic_stiffness(graph(wires), values, 1); }, "network: found a graph w"));
}

BOOST_AUTO_TEST_SUITE_END()
