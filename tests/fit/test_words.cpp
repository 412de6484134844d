// What is said of a fit, sentence by sentence: of fits made by hand, on both sides of each border.
#include "fit/words.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_words)

namespace {

using namespace vcrit;
using fit::Fit;
using test::has;

// Springs of 5 N/m and 3 N/m and a time of 2 s, with errors of 10 %.
Fit one_branch() {
  Fit fit;
  fit.equilibrium = {5, 0.5};
  fit.branches = {{{3, 0.3}, {2, 0.2}}};
  fit.series = {5, 0, {{3, 2}}};
  fit.rms_relative = 0.01;
  fit.noise = 0.01;
  return fit;
}

bool says(const Fit& fit, const std::string& part, std::size_t rows = 20) {
  StiffnessTable data{"made", {}, false};
  data.rows.resize(rows);
  const std::vector<std::string> words = fit::in_words(data, fit);
  return std::ranges::any_of(words, [&](const std::string& each) { return has(each, part); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_good_fit_is_told_by_its_length_and_its_misfit) {
  StiffnessTable data{"made", {}, false};
  data.rows.resize(20);
  const std::vector<std::string> expected{
      "1 branch and an equilibrium spring",
      "the root mean square misfit is 1 %; the noise of the data is estimated to 1 % of |K|"};
  BOOST_TEST(fit::in_words(data, one_branch()) == expected, boost::test_tools::per_element());
}

// More than half of a number is much.
BOOST_AUTO_TEST_CASE(numbers_that_are_poorly_known_are_named) {
  Fit fit = one_branch();
  fit.equilibrium->error = 2.4;
  fit.branches[0].stiffness.error = 1.4;
  fit.branches[0].time.error = 0.9;
  BOOST_TEST(!says(fit, "poorly known"));
  fit.equilibrium->error = 2.6;
  BOOST_TEST(says(fit, "the equilibrium spring is poorly known"));
  for (const bool of_time : {false, true}) {
    fit = one_branch();
    (of_time ? fit.branches[0].time.error : fit.branches[0].stiffness.error) = 1.6;
    BOOST_TEST(says(fit, "the branch at 2 s is poorly known"), of_time);
  }
  fit = one_branch();
  fit.damper = {4, 2.1};
  BOOST_TEST(says(fit, "the damper is poorly known"));
}

BOOST_AUTO_TEST_CASE(a_misfit_beyond_the_errors_given_is_told) {
  const std::string larger = "the misfit is larger than the errors given explain";
  Fit fit = one_branch();
  fit.noise.reset();
  fit.chance = 2e-4;
  BOOST_TEST(!says(fit, larger));
  fit.chance = 0.5e-4;
  BOOST_TEST(says(fit, larger));
}

BOOST_AUTO_TEST_CASE(what_leaves_doubt_is_told) {
  const auto changed = [](auto change) {
    Fit fit = one_branch();
    change(fit);
    return fit;
  };
  const auto only_with = [](const Fit& fit, const std::string& part) {
    BOOST_TEST(says(fit, part), part);
    BOOST_TEST(!says(one_branch(), part), part);
  };
  only_with(changed([](Fit& fit) { fit.exhausted = true; }), "still helped");
  only_with(changed([](Fit& fit) { fit.order_in_doubt = true; }),
            "another number of branches fits");
  only_with(changed([](Fit& fit) { fit.time_at_an_end = true; }), "is only a bound");
  only_with(changed([](Fit& fit) { fit.rms_relative = 0.21; }), "comes near these data");
  only_with(changed([](Fit& fit) { fit.equilibrium.reset(); }), "need no equilibrium spring");
}

// A spring, a branch and a damper are four numbers.
BOOST_AUTO_TEST_CASE(more_numbers_than_frequencies_are_told) {
  const std::string more = "there are more numbers in the series than frequencies";
  Fit fit = one_branch();
  BOOST_TEST(!says(fit, more, 3));
  BOOST_TEST(says(fit, more, 2));
  fit.damper = {4, 0.4};
  BOOST_TEST(!says(fit, more, 4));
  BOOST_TEST(says(fit, more, 3));
}

BOOST_AUTO_TEST_SUITE_END()
