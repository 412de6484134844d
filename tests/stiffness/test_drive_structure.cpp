// The structure of a drive with masses, and its realisation, against nodal analysis of its network
// at 250 digits: 1/(K_d - m omega^2) of the drive with the body.
#include "stiffness/drive_structure.hpp"

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <random>

#include "base/errors.hpp"
#include "linear/elimination.hpp"
#include "network/expression.hpp"
#include "problem/problem.hpp"
#include "stiffness/drive_motion.hpp"
#include "stiffness/dynamic_matrix.hpp"
#include "support/nodal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_drive_structure)

namespace {

using namespace vcrit;
using Complex = std::complex<double>;

struct Drive {
  Network network;
  Values values;
};

Drive drive(const std::string& network, const test::Elements& elements,
            const std::string& more = {}) {
  test::SceneText text{.network = network, .elements = {{"kn", 1}}, .more = more};
  text.elements.insert(text.elements.end(), elements.begin(), elements.end());
  const Problem problem = test::scene_of(text);
  return {problem->drive_network()->network(), problem.values()};
}

Complex narrow(std::complex<long double> wide) {
  return {static_cast<double>(wide.real()), static_cast<double>(wide.imag())};
}

Complex exact_receptance(const Drive& drive, double body, double omega) {
  const auto stiffness = test::Nodal(drive.values, test::Real(omega)).stiffness(drive.network);
  const test::Complex free =
      test::Complex(1) /
      (stiffness - test::Complex(test::Real(body) * test::Real(omega) * test::Real(omega)));
  return {static_cast<double>(free.real()), static_cast<double>(free.imag())};
}

// p.(M s^2 + ...)^-1 p, with the lead in series.
Complex receptance(const DriveStructure& structure, double omega) {
  const auto ways = displacements(structure, {0, omega});
  std::complex<long double> sum = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) sum += structure.port[i] * ways[i];
  Complex result = narrow(sum);
  if (structure.lead) result += 1.0 / dynamic_stiffness(*structure.lead, omega);
  return result;
}

// e_1.(s - A)^-1 e_1/(m s)
Complex receptance(const DriveMotion& motion, double omega) {
  using Wide = std::complex<long double>;
  const auto n = static_cast<Eigen::Index>(motion.rest.size());
  linear::DenseMatrix<Wide> a(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      a(i, j) = (i == j ? Wide(0, omega) : 0) -
                motion.rates(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  const linear::DenseVector<Wide> first = linear::DenseVector<Wide>::Unit(n, 0);
  return narrow(linear::solve_fully_pivoted(a, first)(0)) / Complex(0, motion.mass * omega);
}

// As a share; roundings of doubles in the network's numbers alone are 1e-15 near its resonances.
constexpr double same = 1e-13;

void compare(const Drive& drive, double body) {
  const DriveStructure structure = drive_structure(drive.network, drive.values, body, {"m"});
  const DriveMotion motion = drive_motion(structure);
  const Complex lead = structure.lead ? Complex(1) : Complex(0);
  for (const double omega : {0.01, 0.3, 1.0, 2.7, 40.0}) {
    const Complex exact = exact_receptance(drive, body, omega);
    BOOST_TEST(std::abs(receptance(structure, omega) - exact) <= same * std::abs(exact));
    Complex seen = receptance(motion, omega);
    if (structure.lead) seen += lead / dynamic_stiffness(*structure.lead, omega);
    BOOST_TEST(std::abs(seen - exact) <= same * std::abs(exact));
  }
  for (const auto& pole : motion.poles) BOOST_TEST(pole.real() <= 1e-15L);
}

const test::Elements numbers{{"k1", 2.5}, {"k2", 0.7}, {"k3", 3},   {"c1", 0.2}, {"c2", 0.05},
                             {"c3", 1.3}, {"m1", 1.7}, {"m2", 0.4}, {"m3", 2.2}};

test::Elements only(const std::string& text) {
  test::Elements result;
  for (const auto& each : numbers)
    if (text.find(each.first) != std::string::npos) result.push_back(each);
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(trees_against_nodal_analysis) {
  for (const char* network :
       {"(k1 | c1) - (mass(m1) | k2 | c2)", "k1 - (mass(m1) | (k2 - (mass(m2) | k3)))",
        "(k1 - c1) - (mass(m1) | k2)", "((k1 | c1) - (k2 | c2)) - (mass(m1) | (k3 - c3))",
        "c1 - (mass(m1) | k1)", "k1 - (mass(m1) | (c1 - (mass(m2) | c2)))",
        "mass(m1) | k1 | ((k2 - c2) - (mass(m2) | c3))"})
    for (const double body : {0.0, 0.6}) BOOST_TEST_CONTEXT(network << ", body " << body)
  compare(drive(network, only(network)), body);
}

BOOST_AUTO_TEST_CASE(an_absorber_against_nodal_analysis) {
  const std::string network = "k1 | c1 | ((k2 | c2) - mass(m1))";
  compare(drive(network, only(network)), 0.6);
}

// Inner nodes without masses: springs alone, dampers alone, both; a bridge between masses.
BOOST_AUTO_TEST_CASE(graphs_with_massless_nodes) {
  const auto frame = [](const std::string& edges) {
    return drive("frame", only(edges),
                 "[networks.frame]\nterminals = [\"body\", \"far\"]\nedges = [" + edges + "]\n");
  };
  for (const char* edges :
       {"[\"k1\", \"body\", \"a\"], [\"k2 | c1\", \"body\", \"b\"], [\"k3\", \"a\", \"b\"],"
        " [\"c2\", \"a\", \"far\"], [\"mass(m1)\", \"b\", \"ground\"], [\"c3\", \"b\", \"far\"]",
        "[\"k1\", \"body\", \"a\"], [\"k2\", \"a\", \"b\"], [\"k3\", \"a\", \"far\"],"
        " [\"mass(m1)\", \"b\", \"ground\"], [\"c1\", \"b\", \"far\"]",
        "[\"c1\", \"body\", \"a\"], [\"c2\", \"a\", \"b\"], [\"c3\", \"a\", \"far\"],"
        " [\"mass(m1)\", \"b\", \"ground\"], [\"k1\", \"b\", \"far\"], [\"k2\", \"body\", \"b\"]"})
    BOOST_TEST_CONTEXT(edges) compare(frame(edges), 0.6);
}

// The body's end without a mass on two springs is what lies between them in proportion, on both.
BOOST_AUTO_TEST_CASE(an_end_without_mass_that_springs_hold) {
  const std::string edges =
      "[\"k1\", \"body\", \"a\"], [\"k2\", \"body\", \"far\"], [\"mass(m1)\", \"a\", "
      "\"ground\"], [\"k3 | c3\", \"a\", \"far\"]";
  compare(drive("frame", only(edges),
                "[networks.frame]\nterminals = [\"body\", \"far\"]\nedges = [" + edges + "]\n"),
          0);
}

BOOST_AUTO_TEST_CASE(an_end_without_mass_that_moves_in_no_proportion_is_refused) {
  const std::string network = "((k1 | c1) - (mass(m1) | k3)) | k2";
  const Drive two = drive(network, only(network));
  BOOST_CHECK_THROW(drive_structure(two.network, two.values), ModelError);
  BOOST_CHECK_NO_THROW(drive_structure(two.network, two.values, 0.1));
}

// Two equal absorbers are one of twice the mass, as the body sees them: 2 masses, 4 numbers.
BOOST_AUTO_TEST_CASE(what_the_body_does_not_see_is_left_out) {
  const Drive twice =
      drive("k1 | c1 | (k2 - mass(m1)) | (k3 - mass(m2))",
            {{"k1", 2}, {"c1", 0.1}, {"k2", 0.7}, {"k3", 0.7}, {"m1", 1.3}, {"m2", 1.3}});
  const Drive once =
      drive("k1 | c1 | (k2 - mass(m1))", {{"k1", 2}, {"c1", 0.1}, {"k2", 1.4}, {"m1", 2.6}});
  const DriveMotion one = drive_motion(drive_structure(once.network, once.values, 0.5));
  const DriveMotion two = drive_motion(drive_structure(twice.network, twice.values, 0.5));
  BOOST_TEST(one.poles.size() == 4u);
  BOOST_TEST(two.poles.size() == 4u);
  for (const double omega : {0.2, 0.73, 1.0, 3.0})
    BOOST_TEST(std::abs(receptance(one, omega) - receptance(two, omega)) <=
               same * std::abs(receptance(one, omega)));
}

// A node of the drive at the body: two equal halves that swing against each other.
BOOST_AUTO_TEST_CASE(fluidity_is_that_of_a_constant_force) {
  const auto fluidity = [](const std::string& network) {
    const Drive one = drive(network, only(network));
    return drive_motion(drive_structure(one.network, one.values, 0.6)).fluidity;
  };
  BOOST_TEST(fluidity("k1 - (mass(m1) | k2)") == 0);
  BOOST_TEST(std::abs(fluidity("k1 - (mass(m1) | c2)") - 1 / 0.05) < 1e-12);
  BOOST_TEST(std::abs(fluidity("c1 - (mass(m1) | c2)") - (1 / 0.2 + 1 / 0.05)) < 1e-12);
  BOOST_TEST(std::abs(fluidity("(k1 - c1) - (mass(m1) | c2)") - (1 / 0.2 + 1 / 0.05)) < 1e-12);
  BOOST_TEST(fluidity("k1 | (c1 - mass(m1))") == 0);
}

// A body of 4 t on a spring of 1 N/m, and behind it 1 ug on one of 50 kN/um: what holds the body is
// 1e-26 of the stiffest for its mass, and no less a spring for that. The body swings at
// sqrt(1/4000) rad/s.
BOOST_AUTO_TEST_CASE(a_soft_spring_of_a_heavy_mass_is_one) {
  const Drive one = drive("k1 - (mass(m1) | k2)", {{{"k1"}, 1}, {{"k2"}, 5e10}, {{"m1"}, 1e-9}});
  const DriveMotion motion = drive_motion(drive_structure(one.network, one.values, 4000));
  BOOST_TEST(motion.fluidity == 0);
  long double slowest = std::abs(motion.poles.front());
  for (const auto& pole : motion.poles) slowest = std::min(slowest, std::abs(pole));
  BOOST_TEST(std::abs(static_cast<double>(slowest) / std::sqrt(1 / 4000.0) - 1) < 1e-3);
}

// Two masses joined by 1 N/m, the second held by k = 17/2^64 N/m: p.q = 1 + 1/k at rest. A long
// double of 1 + k holds 16/2^64 of k, so that a seventeenth is lost.
BOOST_AUTO_TEST_CASE(a_receptance_knows_what_rounding_takes) {
  constexpr long double k = 17 * 0x1p-64L;
  DriveStructure structure{.mass = {1, 1},
                           .damping = Dense<long double>(2, 2),
                           .stiffness = Dense<long double>(2, 2),
                           .branches = {},
                           .port = {1, 0},
                           .together = {1, 1}};
  structure.stiffness(0, 0) = 1;
  structure.stiffness(0, 1) = structure.stiffness(1, 0) = -1;
  structure.stiffness(1, 1) = 1 + k;
  const RoundedReceptance found = rounded_receptance(structure, 0);
  const long double off = std::abs(found.value - (1 + 1 / k));
  BOOST_TEST(off > 0.05L / k);
  BOOST_TEST(off <= found.error);
  BOOST_TEST(found.error < 2 / k);
}

BOOST_AUTO_TEST_SUITE_END()
