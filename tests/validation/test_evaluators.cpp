// The derived formula and the generated evaluator give the known value of a scene whose answer is
// exact in binary: v* = mu0 omega du_z kn/kt = 1/4 x 4096 x 2^-20 x 3/2 = 3/2^11 (31).
#include "evaluators.hpp"

#include <boost/test/unit_test.hpp>

#include "base/files.hpp"
#include "compiler.hpp"

BOOST_AUTO_TEST_SUITE(test_evaluators)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

const Scene exact = parse_scene(R"(
[contact]
normal = "kn"
tangential = "kt"
[oscillation]
angular_frequency = 4096
amplitude = 9.5367431640625e-7
indentation = 1e-5
[friction]
coefficient = 0.25
[elements]
kn = 3e6
kt = 2e6
)",
                                "exact.toml");

constexpr double expected = 3.0 / 2048;

}  // namespace

BOOST_AUTO_TEST_CASE(the_derived_formula_has_its_exact_value) {
  BOOST_TEST(derived_velocity(exact, symbolic::derive(exact), values_of(exact)) == expected);
}

BOOST_AUTO_TEST_CASE(the_working_precision_is_put_back) {
  const long before = GiNaC::Digits;
  derived_velocity(exact, symbolic::derive(exact), values_of(exact));
  BOOST_TEST(static_cast<long>(GiNaC::Digits) == before);
}

// Three products and a quotient: at most four roundings of 2^-53 in plain doubles, doubled for a
// scaled evaluation.
BOOST_AUTO_TEST_CASE(the_generated_evaluator_answers_each_call) {
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const PrivateFolder folder;
  const GeneratedVelocities found = generated_velocities(
      exact, symbolic::derive(exact), values_of(exact), *compiler, folder.path());
  const double tolerance = 8 * 0x1p-53 * expected;
  BOOST_TEST(std::abs(found.accurate - expected) <= tolerance);
  BOOST_TEST(std::abs(found.batch - expected) <= tolerance);
  BOOST_TEST(std::abs(found.fast - expected) <= tolerance);
  BOOST_TEST(std::abs(found.certified - expected) <= tolerance);
  BOOST_TEST(found.certified_bound >= 0);
  BOOST_TEST(found.certified_bound < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_compiler_that_fails_is_reported_with_its_words) {
  const PrivateFolder folder;
  const auto broken = folder.path() / "broken";
  write_file(broken, "#!/bin/sh\necho out of coffee\nexit 1\n");
  std::filesystem::permissions(broken, std::filesystem::perms::owner_all);
  BOOST_CHECK_EXCEPTION(
      generated_velocities(exact, symbolic::derive(exact), values_of(exact), broken, folder.path()),
      std::runtime_error, [](const std::runtime_error& error) {
        return std::string(error.what()).find("out of coffee") != std::string::npos;
      });
}

BOOST_AUTO_TEST_CASE(numbers_reach_the_generated_library_unrounded) {
  const Values values{{{"k", 2}, 0.1}, {{"mu0", 0}, 1e22}};
  const std::string program = asking_program({{"k", 2}, {"mu0", 0}}, values);
  BOOST_TEST(program.find("p.k[1] = 0x1.999999999999ap-4;") != std::string::npos);
  BOOST_TEST(program.find("p.mu0 = 0x1.0f0cf064dd592p+73;") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
