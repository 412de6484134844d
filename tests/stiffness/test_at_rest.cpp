// The leading term of K(s), s -> 0, against the relaxation form, which gets there by eigenvalues.
#include "stiffness/at_rest.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "random_networks.hpp"
#include "stiffness/relaxation.hpp"

BOOST_AUTO_TEST_SUITE(test_at_rest)

namespace {

using namespace vcrit;

const Element spring{ElementKind::spring, {"k"}, {}}, damper{ElementKind::damper, {"c"}, {}},
    mass{ElementKind::mass, {"m"}, {}};
const Values values{{{"k"}, 3}, {{"c"}, 5}, {{"m"}, 7}};

AtRest of(const Network& network) { return at_rest(reduce(network), values); }

BOOST_AUTO_TEST_CASE(elements_side_by_side_and_in_line) {
  BOOST_TEST(of({spring}).stiffness() == 3);
  BOOST_TEST(of({damper}).stiffness() == 0);
  BOOST_TEST(static_cast<double>(of({damper}).fluidity()) == 1 / 5.);
  BOOST_TEST(of({Parallel{{{spring}, {damper}}}}).stiffness() == 3);
  BOOST_TEST(static_cast<double>(of({Series{{{spring}, {damper}}}}).fluidity()) == 1 / 5.);
  BOOST_TEST(of({Series{{{damper}, {mass}}}}).order == 2);
  BOOST_TEST(of({Parallel{{{damper}, {Series{{{spring}, {mass}}}}}}}).order == 1);
}

// Two dampers that meet at a node which a spring ties to nothing but them.
BOOST_AUTO_TEST_CASE(graphs) {
  const Graph bridge{{"a", "b", "1", "2"},
                     {{damper}, {damper}, {spring}, {damper}, {spring}},
                     {{0, 2}, {2, 1}, {2, 3}, {0, 3}, {3, 1}}};
  // c at 1 and 2 from a, at 1 to b, k from 2 to b: the node 2 is held by the spring, but only
  // dampers hold a: 2 c/... : the spring is stiff beside them, 1 follows 2 by the spring between.
  const AtRest rest = of({bridge});
  BOOST_TEST(rest.order == 1);
  BOOST_TEST(static_cast<double>(rest.coefficient) == 10);
}

// The relaxation form is known to some 300 u at 12 elements (test_relaxation).
BOOST_AUTO_TEST_CASE(random_networks_against_their_relaxation_form) {
  int solid = 0, fluid = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    reference::RandomNetworks random(9100 + seed, 2);
    const int size = 1 + static_cast<int>(seed % 12);
    const Network network = seed % 4 == 0 ? random.graph(1 + size / 3) : random.tree(size);
    const Relaxation form = relaxation_form(network, random.values());
    const AtRest rest = at_rest(reduce(network), random.values());
    double viscosity = form.damper;
    for (const MaxwellBranch& branch : form.branches) viscosity += branch.stiffness * branch.time;
    const double expected = form.equilibrium > 0 ? form.equilibrium : viscosity;
    BOOST_TEST(rest.order == (form.equilibrium > 0 ? 0 : 1));
    BOOST_TEST(std::abs(static_cast<double>(rest.coefficient) / expected - 1) <= 1e-13);
    (rest.order == 0 ? solid : fluid) += 1;
  }
  BOOST_TEST(solid >= 50);
  BOOST_TEST(fluid >= 50);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
