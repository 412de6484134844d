// The table of usual units against udunits, which is asked wherever a unit stands in brackets.
#include "base/usual_units.hpp"

#include <boost/test/unit_test.hpp>
#include <set>
#include <string>
#include <utility>

#include "base/units.hpp"

BOOST_AUTO_TEST_SUITE(test_usual_units)

using namespace vcrit;

namespace {

const Place place{"scene.toml", 3, 8};

TypedNumber typed(const std::string& text, Dimension dimension) {
  return parse_typed(text, dimension, place);
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_unit_is_what_udunits_says) {
  for (const TabledUnit& unit : tabled_units()) {
    const std::string name(unit.name);
    for (const char* number : {"1", "-0.30", "2.54e3"}) {
      const TypedNumber by_table = typed(number + (" " + name), unit.dimension);
      const TypedNumber by_udunits = typed(number + (" (" + name + ")"), unit.dimension);
      BOOST_TEST(by_table.value == by_udunits.value, name);
      BOOST_TEST(by_table.decimal == by_udunits.decimal, name);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_unit_is_one_of_its_own_dimension) {
  BOOST_TEST(usual_power("N/um", Dimension::stiffness).value() == 6);
  BOOST_TEST(usual_power("rad/s", Dimension::angular_frequency).value() == 0);
  BOOST_TEST(!usual_power("rad/s", Dimension::frequency));
  BOOST_TEST(!usual_power("(N/um)", Dimension::stiffness));
  BOOST_TEST(!usual_power("", Dimension::none));
}

// The second of two rows would never be met.
BOOST_AUTO_TEST_CASE(a_unit_has_one_row) {
  std::set<std::pair<Dimension, std::string_view>> rows;
  for (const TabledUnit& unit : tabled_units())
    BOOST_TEST(rows.emplace(unit.dimension, unit.name).second, unit.name);
}

BOOST_AUTO_TEST_SUITE_END()
