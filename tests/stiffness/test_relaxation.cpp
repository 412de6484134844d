// The relaxation form against the nodal equations of the same network, solved with 250 digits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "random_networks.hpp"
#include "stiffness/relaxation.hpp"
#include "support/nodal.hpp"

BOOST_AUTO_TEST_SUITE(test_relaxation)

namespace {

using namespace vcrit;

void check_order(const Relaxation& form) {
  BOOST_TEST(form.equilibrium >= 0);
  BOOST_TEST(form.damper >= 0);
  for (std::size_t j = 0; j < form.branches.size(); ++j) {
    BOOST_TEST(form.branches[j].stiffness > 0);
    BOOST_TEST(form.branches[j].time > (j == 0 ? 0 : form.branches[j - 1].time));
  }
}

double largest_difference(const Network& network, const Values& values, double decades) {
  const Relaxation form = relaxation_form(network, values);
  check_order(form);
  double largest = 0;
  for (double exponent = -decades; exponent <= decades; exponent += decades / 7) {
    const double omega = std::pow(10.0, exponent);
    largest = std::max(
        largest, test::relative_error(dynamic_stiffness(form, omega),
                                      test::Nodal(values, test::Real(omega)).stiffness(network)));
  }
  return largest;
}

// Rounding an element moves K by no more than the same relative amount (Tellegen). Each element is
// met once a level of the tree, twice (there and back) at series; 12 elements, 2 x 11 crossings of
// about 10 rounding errors each: 220 u = 2.4e-14.
constexpr double tree_tolerance = 220 * std::numeric_limits<double>::epsilon() / 2;

// A graph's own part is exact to the last bit of each branch; its parts are trees of <= 3 elements
// with 2 x 2 crossings, and reading the form out is one rounding a branch: 50 u = 6e-15.
constexpr double graph_tolerance = 50 * std::numeric_limits<double>::epsilon() / 2;

}  // namespace

BOOST_AUTO_TEST_CASE(elements_are_their_own_form) {
  const Symbol k{"k", 0}, c{"c", 0}, tau{"t", 0};
  const Values values{{k, 3.0}, {c, 0.5}, {tau, 7.0}};
  BOOST_TEST(relaxation_form(spring(k), values).equilibrium == 3.0);
  BOOST_TEST(relaxation_form(damper(c), values).damper == 0.5);
  BOOST_TEST(relaxation_form(maxwell(k, tau), values).branches.at(0).stiffness == 3.0);
  BOOST_TEST(relaxation_form(maxwell(k, tau), values).branches.at(0).time == 7.0);
}

// A spring behind a damper is a Maxwell branch with tau = c/k: exact numbers here.
BOOST_AUTO_TEST_CASE(spring_behind_damper_is_a_branch) {
  const Symbol k{"k", 0}, c{"c", 0};
  const Relaxation form = relaxation_form(series({spring(k), damper(c)}), {{k, 4.0}, {c, 32.0}});
  BOOST_TEST(form.equilibrium == 0.0);
  BOOST_TEST(form.damper == 0.0);
  BOOST_TEST(form.branches.size() == 1U);
  BOOST_TEST(form.branches.at(0).stiffness == 4.0);
  BOOST_TEST(form.branches.at(0).time == 8.0);
}

BOOST_AUTO_TEST_CASE(equal_times_become_one_branch) {
  const Symbol k{"k", 0}, h{"h", 0}, tau{"t", 0};
  const Values values{{k, 3.0}, {h, 2.0}, {tau, 7.0}};
  const Relaxation form = relaxation_form(parallel({maxwell(k, tau), maxwell(h, tau)}), values);
  BOOST_TEST(form.branches.size() == 1U);
  BOOST_TEST(form.branches.at(0).stiffness == 5.0);
}

BOOST_AUTO_TEST_CASE(random_trees) {
  constexpr unsigned seed = 20240601;
  BOOST_TEST_MESSAGE("seed " << seed);
  double worst = 0;
  for (unsigned i = 0; i < 300; ++i) {
    const double decades = i % 3 == 0 ? 1 : (i % 3 == 1 ? 4 : 10);
    reference::RandomNetworks networks(seed + i, decades);
    const Network network = networks.tree(2 + static_cast<int>(i % 11));
    const double difference = largest_difference(network, networks.values(), 12);
    BOOST_TEST_CONTEXT("tree " << i) { BOOST_TEST(difference < tree_tolerance); }
    worst = std::max(worst, difference);
  }
  BOOST_TEST_MESSAGE("largest relative difference " << worst);
}

BOOST_AUTO_TEST_CASE(random_graphs) {
  constexpr unsigned seed = 777;
  BOOST_TEST_MESSAGE("seed " << seed);
  double worst = 0;
  for (unsigned i = 0; i < 24; ++i) {
    reference::RandomNetworks networks(seed + i, i % 2 == 0 ? 3 : 10);
    const Network network = networks.graph(2 + static_cast<int>(i % 4));
    const double difference = largest_difference(network, networks.values(), 12);
    BOOST_TEST_CONTEXT("graph " << i) { BOOST_TEST(difference < graph_tolerance); }
    worst = std::max(worst, difference);
  }
  BOOST_TEST_MESSAGE("largest relative difference " << worst);
}

// Ten branches behind one another, rates over 20 decades, as a chain of Kelvin elements.
// Two networks of one shape in series, which have nearly equal rates: between two of these the path
// has a branch that carries nearly nothing, a share g^2 of the others. The way back from there has
// the compliances of both, 1/K, to a rounding and not to that over g.
BOOST_AUTO_TEST_CASE(nearly_equal_networks_in_series) {
  const Relaxation one{8e6, 0, {{4e6, 7.5e-6}}};
  for (const double g : {0.0, 1e-15, 2e-15, 5e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4}) {
    const Relaxation other{16e6, 0, {{8e6, 7.5e-6 * (1 + g)}}};
    const DualPoles path = dual(stiffness_poles(series({one, other})));
    for (const double omega : {1e3, 1e5, 1e7}) {
      std::complex<double> compliance{path.direct, -path.at_rest / omega};
      for (std::size_t j = 0; j < path.weights.size(); ++j)
        compliance += path.weights[j] / std::complex<double>{path.rates[j].value(), omega};
      const std::complex<double> right =
          1.0 / dynamic_stiffness(one, omega) + 1.0 / dynamic_stiffness(other, omega);
      // Some ten roundings on each of the three ways.
      BOOST_TEST(std::abs(compliance - right) <= 30 * 0x1p-53 * std::abs(right), "g = " << g);
    }
  }
}

BOOST_AUTO_TEST_CASE(kelvin_chain_over_twenty_decades) {
  Values values;
  std::vector<Network> units;
  for (int j = 0; j <= 10; ++j) {
    const Symbol k{"k", j + 1}, c{"c", j + 1};
    values[k] = 1 + 0.1 * j;
    values[c] = std::pow(10.0, 2 * j - 10);
    units.push_back(parallel({spring(k), damper(c)}));
  }
  BOOST_TEST(largest_difference(series(units), values, 12) < tree_tolerance);
}

// Kelvin elements and a damper in series. Two of the elements hardly deform, and the stiffness of
// their branches underflows: these branches must be absent. 1/K is a sum of few terms whose real
// and imaginary parts have one sign each; reading K from the form adds as many roundings again: 30
// u.
BOOST_AUTO_TEST_CASE(stiffness_below_all_doubles_is_left_out) {
  const std::vector<std::pair<double, double>> units{
      {0, 3e-47}, {1.2e126, 1e230}, {1.5e221, 3e222}, {2.8e35, 1e-39}, {3e65, 1.7e-39}};
  Values values;
  std::vector<Network> row;
  for (const auto& [stiffness, damping] : units) {
    const Symbol k{"k", static_cast<int>(row.size())}, c{"c", k.entry};
    values[c] = damping;
    if (stiffness > 0) values[k] = stiffness;
    row.push_back(stiffness > 0 ? parallel({spring(k), damper(c)}) : damper(c));
  }
  const Relaxation form = relaxation_form(series(row), values);
  check_order(form);
  for (const double omega : {1e-150, 1e-104, 1e-3, 1.0, 1e74, 1e90, 1e104}) {
    std::complex<double> compliance = 0;
    for (const auto& [k, c] : units) compliance += 1.0 / std::complex<double>{k, omega * c};
    const std::complex<double> stiffness = dynamic_stiffness(form, omega);
    BOOST_TEST(std::abs(stiffness * compliance - 1.0) < 3.3e-15);
  }
}

// The dual of the dual is the sum itself. Both ways cost about 10 rounding errors a pole.
BOOST_AUTO_TEST_CASE(dual_is_an_involution) {
  const PoleSum sum{0.25, {0, 1e-9, 1e-3, 1, 1.0000001, 1e9}, {2, 3, 1, 1e-6, 4, 1e3}};
  const DualPoles there = dual(sum);
  BOOST_TEST(there.direct == 0.0);
  BOOST_TEST(there.at_rest == 0.0);
  PoleSum rounded{0, {}, there.weights};
  for (const OffsetRate& rate : there.rates) rounded.rates.push_back(rate.value());
  const DualPoles back = dual(rounded);
  BOOST_TEST(back.rates.size() + 1 == sum.rates.size());
  BOOST_TEST(back.at_rest == 2.0, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
