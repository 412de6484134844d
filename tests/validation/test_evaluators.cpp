// The derived formula and the generated evaluator give the known value of a scene whose answer is
// exact in binary: v* = mu0 omega du_z kn/kt = 1/4 x 4096 x 2^-20 x 3/2 = 3/2^11 (31).
#include "compare/evaluators.hpp"

#include <boost/test/unit_test.hpp>

#include "base/files.hpp"
#include "problem/problem.hpp"
#include "run/compiler.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_evaluators)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

const Scene exact = test::scene_of({.tangential = "kt",
                                    .angular_frequency = 4096,
                                    .amplitude = 9.5367431640625e-7,
                                    .indentation = 1e-5,
                                    .coefficient = 0.25,
                                    .elements = {{"kn", 3e6}, {"kt", 2e6}}});

constexpr double expected = 3.0 / 2048;

}  // namespace

BOOST_AUTO_TEST_CASE(the_derived_formula_has_its_exact_value) {
  BOOST_TEST(derived_velocity(symbolic::derive(exact), resolve(exact).values()) == expected);
}

BOOST_AUTO_TEST_CASE(the_working_precision_is_put_back) {
  const long before = GiNaC::Digits;
  derived_velocity(symbolic::derive(exact), resolve(exact).values());
  BOOST_TEST(static_cast<long>(GiNaC::Digits) == before);
}

// Three products and a quotient: at most four roundings of 2^-53 in plain doubles, doubled for a
// scaled evaluation.
BOOST_AUTO_TEST_CASE(the_generated_evaluator_answers_each_call) {
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const GeneratedVelocities found =
      generated_velocities(Driver(symbolic::derive(exact), *compiler), resolve(exact).values());
  const double tolerance = 8 * 0x1p-53 * expected;
  BOOST_TEST(std::abs(found.accurate - expected) <= tolerance);
  BOOST_TEST(std::abs(found.batch - expected) <= tolerance);
  BOOST_TEST(std::abs(found.fast - expected) <= tolerance);
  BOOST_TEST(std::abs(found.certified - expected) <= tolerance);
  BOOST_TEST(found.certified_bound >= 0);
  BOOST_TEST(found.certified_bound < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_compiler_that_fails_is_reported_with_its_words_and_not_asked_again) {
  const PrivateFolder folder;
  const auto broken = folder.path() / "broken";
  write_file(broken, "#!/bin/sh\necho one >>" + (folder.path() / "tries").string() +
                         "\necho out of coffee\nexit 1\n");
  std::filesystem::permissions(broken, std::filesystem::perms::owner_all);
  write_file(folder.path() / "tries", "");
  Driver driver(symbolic::derive(exact));
  for (int i = 0; i < 2; ++i)
    BOOST_CHECK_EXCEPTION(driver.compile(broken), std::runtime_error, [](const auto& error) {
      return std::string(error.what()).find("out of coffee") != std::string::npos;
    });
  BOOST_TEST(read_file(folder.path() / "tries") == "one\n");
}

// 0.1 and 1e22/3 have no short decimals: v* = mu0 omega du_z kn/kt with all but mu0 = 0.1 and the
// scale of the stiffnesses powers of two is 0.1 itself, to the last bit.
BOOST_AUTO_TEST_CASE(numbers_reach_the_generated_library_unrounded) {
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const Driver driver(symbolic::derive(exact), *compiler);
  Values values = resolve(exact).values();
  values[{"mu0"}] = 0.1;
  values[{"omega"}] = values[{"du_z"}] = 1;
  values[{"kn"}] = values[{"kt"}] = 1e22 / 3;
  BOOST_TEST(generated_velocities(driver, values).accurate == 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
