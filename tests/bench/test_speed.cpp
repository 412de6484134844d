// The loops by hand that the generated evaluators are compared with are right on every problem, and
// the table has a row for every method. Nothing is timed.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "record/json_text.hpp"
#include "speed/tables.hpp"

BOOST_AUTO_TEST_SUITE(test_speed)

using namespace vcrit;
using namespace vcrit::speed;

namespace {

constexpr Plan tiny{16, 0};

std::filesystem::path compiler() { return validation::find_compiler().value(); }

Subject subject_named(const std::string& name) {
  for (Subject& subject : all_subjects())
    if (subject.name == name) return std::move(subject);
  throw std::logic_error("no problem " + name);
}

}  // namespace

// Three networks of three elements take less than a hundred operations with complex numbers; each
// errs by no more than five roundings of the result's absolute value (a quotient). Polynomials have
// degree four at most and no zero near the imaginary axis: their terms add up to less than
// sqrt(2)^4 = 4 times the sum, for all factors have positive coefficients but the one with the
// mass, whose damping is of the size of its stiffness.
BOOST_AUTO_TEST_CASE(loops_by_hand_are_right) {
  const Subject subject = subject_named("Zener");
  const std::vector<TimedMethod> loops = loops_by_hand(subject, compiler());
  for (const CallMode mode : both_modes) {
    const std::vector<Result> results = measure(subject, mode, loops, tiny);
    BOOST_TEST(results.size() == (mode == CallMode::sweep ? 6u : 4u));
    for (const Result& each : results) BOOST_TEST(each.error < 4 * 500, each.method);
  }
}

// The fractions of a ladder are scaled lest they overflow.
BOOST_AUTO_TEST_CASE(loops_by_hand_are_right_for_large_networks) {
  const Subject subject = subject_named("ladder-10");
  const std::vector<TimedMethod> loops = loops_by_hand(subject, compiler());
  for (const CallMode mode : both_modes)
    for (const Result& each : measure(subject, mode, loops, tiny))
      BOOST_TEST(!each.wrong(), each.method);
}

BOOST_AUTO_TEST_CASE(the_error_counts_units_of_the_last_place) {
  BOOST_TEST(worst_error({1 + 0x1p-50, 1}, {1, 1}) == 4);
  BOOST_TEST(worst_error({1 - 0x1p-53}, {1}) == 0.5);
  BOOST_TEST(std::isinf(worst_error({1, NAN}, {1, 1})));
  BOOST_TEST(!(Result{"", "", CallMode::sweep, MethodFamily::peer, 1, 4e5}.wrong()));
  BOOST_TEST((Result{"", "", CallMode::sweep, MethodFamily::peer, 1, 5e5}.wrong()));
}

BOOST_AUTO_TEST_CASE(a_wrong_value_is_seen) {
  const Subject subject = subject_named("Kelvin");
  TimedMethod wrong;
  wrong.method = "SymPy cse";
  wrong.run = [](const Samples& samples, double* out, double*) {
    for (std::size_t i = 0; i < samples.size(); ++i) out[i] = 1;
  };
  SpeedComparison all;
  all.subjects = {subject.name};
  all.results = measure(subject, CallMode::sweep, {wrong}, tiny);
  BOOST_TEST(all.results.at(0).wrong());
  BOOST_TEST(table(all, CallMode::sweep, TableStyle::markdown).find("| SymPy cse | wrong |") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(every_method_has_its_row) {
  const Subject subject = subject_named("Kelvin");
  SpeedComparison all;
  all.subjects = {subject.name};
  const std::vector<TimedMethod> methods = evaluators(subject, compiler(), all.missing);
  for (const CallMode mode : both_modes)
    for (const Result& each : measure(subject, mode, methods, tiny)) all.results.push_back(each);
  const std::string text = table(all, CallMode::sweep, TableStyle::markdown);
  for (const std::string& method : all_methods())
    BOOST_TEST(text.find("| " + method + " |") != std::string::npos, method);
  for (const Result& each : all.results) {
    const std::vector<std::string> names = all_methods();
    BOOST_TEST((std::find(names.begin(), names.end(), each.method) != names.end()), each.method);
    // A Kelvin contact and drive, damped: roundings of some thirty operations.
    BOOST_TEST(each.error < 200, each.method);
  }
  BOOST_TEST(record::read_json(as_json(all))["results"].size() == all.results.size());
}

BOOST_AUTO_TEST_SUITE_END()
