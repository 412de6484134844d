// v* under a measured drive: as under the network that the table was sampled from, and exactly by
// the linear interpolation between two rows.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "problem/problem.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "support/nodal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_measured_drive)

using namespace vcrit;

namespace {

using Complex = std::complex<double>;

Scene driven(const char* drive, test::Elements elements) {
  for (const auto& [name, value] :
       {std::pair("kn", 3.0), std::pair("cn", 0.2), std::pair("kt", 4.0), std::pair("ct", 0.1)})
    elements.emplace_back(name, value);
  return test::scene_of({.normal = "kn | cn",
                         .tangential = "kt | ct",
                         .network = drive,
                         .mass = 0.7,
                         .angular_frequency = 2.3,
                         .indentation = 2,
                         .elements = std::move(elements)});
}

Scene known_drive() {
  return driven("k1 - (mass(m1) | k2 | c2)", {{"k1", 5}, {"m1", 1.2}, {"k2", 6}, {"c2", 0.4}});
}

Scene measured(std::vector<Receptance::Row> rows, double omega) {
  Scene scene = driven("k1", {{"k1", 1}});
  scene.drive.reset();
  scene.receptance = Receptance{"r.csv", std::move(rows)};
  scene.angular_frequency.value = omega;
  std::erase_if(scene.elements, [](const auto& element) { return element.first.name == "k1"; });
  scene.typed.clear();
  return scene;
}

test::Complex number(Complex z) { return {test::Real(z.real()), test::Real(z.imag())}; }

/// Eq. 24 with K_d = 1/R, at 250 digits.
double expected(const Scene& scene, const test::Complex& receptance) {
  const Values values = resolve(scene).values();
  const test::Real omega(values.at({"omega"}));
  test::Nodal nodal(values, omega);
  const test::Complex normal = nodal.stiffness(scene.normal);
  const test::Complex tangential = nodal.stiffness(std::get<Network>(scene.tangential));
  const test::Complex inertia(test::Real(values.at({"m"})) * omega * omega, test::Real(0));
  const test::Complex d = number(1) - inertia * receptance;
  const test::Real factor = test::Real(abs(test::Complex(tangential * receptance + d))) /
                            test::Real(abs(d)) * test::Real(abs(normal)) /
                            test::Real(abs(tangential));
  return static_cast<double>(test::Real(test::Real(values.at({"mu0"})) * omega *
                                        test::Real(values.at({"du_z"})) * factor));
}

}  // namespace

BOOST_AUTO_TEST_CASE(on_its_rows_a_table_is_the_drive_it_was_sampled_from) {
  Scene drive = known_drive();
  std::vector<Receptance::Row> rows;
  for (double omega = 0.5; omega < 4; omega += 0.25) {
    const Complex r = 1.0 / dynamic_stiffness(*drive.drive, resolve(drive).values(), omega);
    rows.push_back({omega, r.real(), r.imag()});
  }
  for (const Receptance::Row& row : rows) {
    const Scene scene = measured(rows, row.omega);
    drive.angular_frequency.value = row.omega;
    const double found = certified_critical_velocity(scene).value;
    const double reference = certified_critical_velocity(drive).value;
    // R = 1/K_d in doubles: 16 roundings grown by what cancels inside the drive, and one division.
    const Values values = resolve(drive).values();
    const double loss = sensitivity(reduce(*drive.drive), values, row.omega);
    const Complex r(row.re, row.im);
    const double error = 0x1p-53 * (16 * loss * std::abs(r) + 4) * std::abs(r);
    // d log v*/dR = (K_t - m omega^2)/(K_t R + D) + m omega^2/D with D = 1 - m omega^2 R.
    const Complex tangential =
        dynamic_stiffness(std::get<Network>(drive.tangential), values, row.omega);
    const double inertia = 0.7 * row.omega * row.omega;
    const Complex d = 1.0 - inertia * r;
    const double slope =
        std::abs((tangential - inertia) / (tangential * r + d)) + inertia / std::abs(d);
    BOOST_TEST_CONTEXT("omega " << row.omega) {
      BOOST_TEST(std::abs(found / reference - 1) <= error * slope + 0x1p-52);
      BOOST_TEST(found == expected(scene, number(r)));
    }
  }
}

BOOST_AUTO_TEST_CASE(between_rows_the_receptance_is_linear) {
  const Receptance::Row a{1.7, 0.3, -0.01}, b{2.9, -0.2, -0.07};
  for (const double omega : {1.7000000000000002, 2.0, 2.3, 2.8999999999999995}) {
    const Scene scene = measured({{1, 5, -5}, a, b, {3, 9, -9}}, omega);
    const test::Real share =
        (test::Real(omega) - test::Real(a.omega)) / (test::Real(b.omega) - test::Real(a.omega));
    const test::Complex along(share, test::Real(0));
    const test::Complex receptance =
        number({a.re, a.im}) + (number({b.re, b.im}) - number({a.re, a.im})) * along;
    const double value = expected(scene, receptance);
    BOOST_TEST(certified_critical_velocity(scene).value == value);
    BOOST_TEST(certified_critical_velocity(scene).relative_error_bound == 0x1p-53);
    BOOST_TEST(std::abs(critical_velocity(scene) / value - 1) <= 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(no_receptance_is_a_rigid_drive) {
  const Scene scene = measured({{1, 0, 0}, {3, 0, 0}}, 2);
  Scene rigid = scene;
  rigid.receptance.reset();
  rigid.mass.reset();
  BOOST_TEST(certified_critical_velocity(scene).value == certified_critical_velocity(rigid).value);
}

// 1 = m omega^2 R with m = 1/2 and omega = 2; and K_t R + 1 = m omega^2 R with K_t = 1.
BOOST_AUTO_TEST_CASE(exact_resonance_and_antiresonance) {
  const auto at = [](double receptance) {
    Scene scene = measured({{1, receptance, 0}, {3, receptance, 0}}, 2);
    scene.mass->value = 0.5;
    scene.tangential = spring({"kt"});
    for (auto& [symbol, value] : scene.elements)
      if (symbol.name == "kt") value = 1.0;
    return certified_critical_velocity(scene);
  };
  BOOST_TEST(std::isinf(at(0.5).value));
  BOOST_TEST(at(1).value == 0);
}

BOOST_AUTO_TEST_CASE(outside_the_table_nothing_is_known) {
  for (const double omega : {0.9, 3.1}) {
    const Scene scene = measured({{1, 1, 0}, {3, 1, 0}}, omega);
    BOOST_CHECK_THROW(certified_critical_velocity(scene), ModelError);
    BOOST_CHECK_THROW(critical_velocity(scene), ModelError);
  }
}

BOOST_AUTO_TEST_CASE(a_measured_drive_adds_no_creep) {
  BOOST_TEST(creep_velocity(measured({{1, 1, 0}, {3, 1, 0}}, 2)) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
