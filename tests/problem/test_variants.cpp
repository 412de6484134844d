// Problems of another structure: each differs in what its name says, and leaves the first as it is.
#include "problem/variants.hpp"

#include <boost/test/unit_test.hpp>
#include <complex>

#include "critical/critical_velocity.hpp"
#include "stiffness/dynamic_stiffness.hpp"

BOOST_AUTO_TEST_SUITE(test_variants)

namespace {

using namespace vcrit;

const Problem& zener() {
  static const Problem problem = read_problem(VCRIT_SCENES "/zener.toml");
  return problem;
}

BOOST_AUTO_TEST_CASE(over_a_spring_v_is_the_stiffness_of_the_normal_network) {
  const Problem over = over_spring(zener(), zener()->normal, {"unit"});
  BOOST_TEST(over->rigid());
  BOOST_TEST(!over->mass.has_value());
  BOOST_TEST(!zener()->rigid());
  const double omega = over.value(over->angular_frequency);
  const double stiffness =
      std::abs(dynamic_stiffness(zener()->normal.reduction(), zener().values(), omega));
  // mu0 omega du_z |K_n|: three products, a modulus and a few operations of K_n.
  BOOST_TEST(critical_velocity(over) ==
                 over.value(over->coefficient) * omega * over.value(over->amplitude) * stiffness,
             boost::test_tools::tolerance(16 * 0x1p-53));
}

BOOST_AUTO_TEST_CASE(numbers_as_typed_names_and_warnings) {
  BOOST_TEST(!zener()->typed->empty());
  BOOST_TEST(as_doubles(zener())->typed->empty());
  const Problem called = called_otherwise(zener(), {{"k0", "k_0"}});
  BOOST_TEST(to_text(as_called(called, {"k0"})) == "k_0");
  BOOST_TEST(to_text(as_called(zener(), {"k0"})) == "k0");
  BOOST_TEST(warning_of(zener(), {"odd"})->source->warnings.size() == 1U);
  BOOST_TEST(zener()->source->warnings.empty());
}

BOOST_AUTO_TEST_CASE(the_ratio_of_an_isotropic_contact) {
  const Problem free = with_isotropic(zener(), {Isotropic::By::poisson, {{"nu"}, {}}});
  BOOST_CHECK_THROW(free.values(), InputError);
  BOOST_TEST(free.with({{{"nu"}, 0.25}}).values().at({"nu"}) == 0.25);
  const Problem by_ratio = with_isotropic(zener(), {Isotropic::By::ratio, {{"r"}, 14.0 / 17}});
  BOOST_TEST(critical_velocity(by_ratio) == critical_velocity(zener()),
             boost::test_tools::tolerance(4 * 0x1p-53));  // nu = 0.3
}

BOOST_AUTO_TEST_CASE(indenters_and_separation) {
  const Problem problem = read_problem(VCRIT_SCENES "/sphere.toml");
  using Shape = Indenter::Shape;
  const Problem flat = with_indenter(problem, {Shape::flat, {{{"radius"}, 1.0}}, {}});
  BOOST_TEST((flat->indenter->shape == Shape::flat));
  BOOST_TEST((problem->indenter->shape != Shape::flat));
  const Problem elastic = with_normal_spring(problem, {"E"}, 3);
  BOOST_TEST((elastic->normal.network() == spring({"E"})));
  BOOST_TEST(elastic->elements->size() == 1U);
  BOOST_TEST(!staying_closed(problem)->separation);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
