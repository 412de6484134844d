// Cells of a half-space under an indenter, and scenes that have none.
#include "indenter/half_space.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "base/errors.hpp"
#include "indenter/half_spaces.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_half_space)

namespace {

using namespace vcrit;
using indenter::HalfSpace;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const std::string parabola = "shape = \"parabola\"\nradius = \"10 mm\"";
constexpr double modulus = 5e9 / (1 - 0.3 * 0.3), ratio = 2 * (1 - 0.3) / (2 - 0.3);

bool near(double value, double expected, double errors = 8) {
  return std::abs(value - expected) <= errors * epsilon * std::abs(expected);
}

bool refused(const Scene& scene, const std::string& part) {
  return test::refusal<ModelError>([&] { HalfSpace{scene}; }).find(part) != std::string::npos;
}

}  // namespace

// a^2 = R u_z0, and the same of the deepest and the least indentation.
BOOST_AUTO_TEST_CASE(widths) {
  const HalfSpace h(reference::scene_of(parabola, 5e-7, 3e-7));
  BOOST_TEST(near(h.radius(), std::sqrt(0.01 * 5e-7)));
  BOOST_TEST(near(h.edge(), std::sqrt(0.01 * 8e-7)));
  BOOST_TEST(near(h.closed_radius(), std::sqrt(0.01 * 2e-7)));
  BOOST_TEST(!h.uniform());
  BOOST_TEST(h.touches(0.999 * h.edge()));
  BOOST_TEST(!h.touches(1.001 * h.edge()));
  BOOST_TEST(h.stays_closed(0.999 * h.closed_radius()));
  BOOST_TEST(!h.stays_closed(1.001 * h.closed_radius()));
}

BOOST_AUTO_TEST_CASE(springs_of_a_cell) {
  const HalfSpace h(reference::scene_of(parabola, 5e-7, 3e-7));
  BOOST_TEST(near(h.static_modulus(), modulus));
  const double x = 8e-5, depth = 5e-7 - x * x / 0.01;
  const simulation::System open = h.cell(x);
  BOOST_REQUIRE(open.opening.has_value());
  BOOST_TEST(near(open.opening->network.equilibrium, modulus));
  BOOST_TEST(near(open.contact.equilibrium, ratio * modulus));
  BOOST_TEST(near(open.opening->mean, depth, 100));  // a small difference
  BOOST_TEST(open.opening->amplitude == 3e-7);
  BOOST_TEST(open.friction == 0.3);
  BOOST_TEST(near(open.omega, 4 * std::acos(0.0) * 20e3));
  const simulation::System closed = h.cell(0);
  BOOST_TEST(!closed.opening.has_value());
  BOOST_TEST(near(closed.mean_normal_force, modulus * 5e-7));
  BOOST_TEST(near(std::abs(closed.normal_force_amplitude), modulus * 3e-7));
  BOOST_CHECK_THROW(h.cell(1.001 * h.edge()), InputError);
}

// With |K(i omega)| = sqrt(2) K(0) the contact opens from du_z sqrt(2) > depth on.
BOOST_AUTO_TEST_CASE(viscous_cells) {
  const std::string elements =
      "k0 = \"5 GPa\"\nc0 = " + std::to_string(5e9 / (4 * std::acos(0.0) * 20e3));
  const HalfSpace h(reference::scene_of(parabola, 5e-7, 3e-7, "k0 | c0", elements));
  BOOST_TEST(!h.elastic());
  // The damper's value has 11 digits.
  BOOST_TEST(std::abs(h.closed_radius() / std::sqrt(0.01 * (5e-7 - std::sqrt(2.0) * 3e-7)) - 1) <=
             1e-9);
  // Where opening and staying closed are one within rounding, cells stay closed.
  const double x = h.gap().half_width(5e-7 - std::sqrt(2.0) * 3e-7 * (1 - 1e-15));
  const simulation::System cell = h.cell(std::min(x, h.closed_radius()));
  BOOST_TEST(!cell.opening.has_value());
  BOOST_TEST(std::abs(cell.normal_force_amplitude) < cell.mean_normal_force);
}

BOOST_AUTO_TEST_CASE(punch) {
  const HalfSpace h(reference::scene_of("shape = \"flat\"\nradius = \"2 mm\"", 5e-7, 3e-7));
  BOOST_TEST(h.uniform());
  BOOST_TEST(h.edge() == 2e-3);
  BOOST_TEST(h.radius() == 2e-3);
  BOOST_TEST(h.touches(2e-3));
}

BOOST_AUTO_TEST_CASE(from_above) {
  const HalfSpace h(reference::scene_of(parabola, 0, 3e-7));
  BOOST_TEST(h.radius() == 0);
  BOOST_TEST(h.closed_radius() == 0);
  BOOST_TEST(near(h.edge(), std::sqrt(0.01 * 3e-7)));
}

BOOST_AUTO_TEST_CASE(outside_the_model) {
  const std::string spring = "k0 = \"5 GPa\"";
  BOOST_TEST(refused(reference::scene_of(parabola, 5e-7, 5e-7, "k0", spring, false), "(Eq. 3)"));
  BOOST_TEST(!refused(reference::scene_of(parabola, 5e-7, 4.9e-7, "k0", spring, false), "("));
  BOOST_TEST(refused(reference::scene_of(parabola, 0, 0), "never closes"));
  BOOST_TEST(refused(
      reference::scene_of(parabola, 5e-7, 4e-7, "k0 | c0", spring + "\nc0 = \"100 kPa s\"", false),
      "(Eq. 4)"));
  BOOST_TEST(
      refused(reference::scene_of(parabola, 5e-7, 4e-7, "k0 - c0", spring + "\nc0 = \"100 kPa s\""),
              "no static load"));
  Scene scene = reference::scene_of(parabola, 5e-7, 3e-7);
  scene.coefficient.value = 0;
  BOOST_TEST(refused(scene, "mu0 = 0"));
  scene.coefficient.value.reset();
  BOOST_CHECK_THROW(HalfSpace{scene}, InputError);
  scene.indenter.reset();
  BOOST_TEST(refused(scene, "no [indenter]"));
}

BOOST_AUTO_TEST_SUITE_END()
