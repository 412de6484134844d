// The relaxation form of any network gives its K(i omega): against nodal analysis of the same
// wiring in 250 digits.
#include "property.hpp"
#include "random_networks.hpp"
#include "stiffness/relaxation.hpp"
#include "support/nodal.hpp"

BOOST_AUTO_TEST_SUITE(test_relaxation_form)

namespace {

using namespace vcrit;
using namespace vcrit::properties;

// What the simulator is promised. Each crossing between stiffness and compliance costs some 10
// rounding errors, each element at most two crossings: 40 elements would be needed to reach it.
constexpr double tolerance = 1e-13;

void check_form(const Wired& wired, double omega) {
  const Relaxation form = relaxation_form(wired.network, wired.values);
  const auto exact = test::Nodal(wired.values, test::Real(omega)).stiffness(wired.network);
  RC_ASSERT(test::relative_error(dynamic_stiffness(form, omega), exact) <= tolerance);
}

}  // namespace

RC_BOOST_PROP(trees, ()) {
  const auto drawn = *pieces(*rc::gen::element(1, 4, 10), 12);
  check_form(tree_of(drawn), *magnitude(12));
}

RC_BOOST_PROP(graphs_with_bridges, ()) {
  const auto drawn = *edges(*rc::gen::element(1, 6), 8);
  check_form(graph_of(drawn), *magnitude(8));
}

BOOST_AUTO_TEST_SUITE_END()
