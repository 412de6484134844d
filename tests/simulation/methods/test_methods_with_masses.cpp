// The methods that share no code with the exact one, on drives that hold masses: friction of chains
// of two and three masses from a table of two other simulators (tests/data/two_mass_chains.md).
#include <boost/test/unit_test.hpp>

#include <cmath>

#include "simulation/chains.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/system/system.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_methods_with_masses)

using namespace vcrit;
using namespace vcrit::simulation;

namespace {

// Each of all rows in turn, so that every group is met: two and three masses, absorbers, undamped
// drives, several sticks in a period.
constexpr std::size_t every = 6;

struct Asked {
  Method method;
  MethodOptions options;
  double largest;  ///< error that it may state
};

}  // namespace

// What a method states covers its error; the largest is what it has at these options, and rounding
// of the table's velocities, of 1e-15, is far below all.
BOOST_AUTO_TEST_CASE(friction_is_that_of_the_table) {
  MethodOptions steps, smooth;
  steps.steps_per_period = 6000;
  smooth.regularisation = 1e-4;
  int compared = 0;
  for (const Asked& asked : {Asked{Method::rk8pd, {}, 1e-8}, Asked{Method::moreau, steps, 1e-3},
                             Asked{Method::tanh, smooth, 1e-2}}) {
    std::size_t row = 0;
    for (const reference::Chain& chain : reference::chains()) {
      if (row++ % every != 0 || chain.group == "undamped") continue;
      const auto state =
          steady_state(asked.method, system_of(chain.scene), chain.velocity, asked.options);
      BOOST_TEST_CONTEXT(to_text(asked.method) << " " << chain.id) {
        BOOST_TEST(state.friction_ratio_error < asked.largest);
        BOOST_TEST(std::abs(state.friction_ratio - chain.friction_ratio) <=
                   state.friction_ratio_error + 1e-12);
      }
      ++compared;
    }
  }
  BOOST_TEST(compared >= 30);
}

BOOST_AUTO_TEST_CASE(the_reduced_model_knows_none) {
  const auto chain = reference::chains().front();
  BOOST_CHECK_THROW(steady_state(Method::reduced, system_of(chain.scene), chain.velocity),
                    ModelError);
}

// So slow a body that its speed says nothing of the period: a march that slid ahead of the drive
// repeats to rounding, but its friction would push the drive on, and v0 <F> is what is lost.
BOOST_AUTO_TEST_CASE(friction_pushes_no_drive_on) {
  const test::SceneText text{.normal = "k1 | (k2 - c3)",
                             .poisson = 0.3096,
                             .separation = true,
                             .network = "(kd4 | cd5) - (mass(md6) | (kd7 | cd8))",
                             .mass = 46867.00967610571,
                             .angular_frequency = 151243638.88847274,
                             .amplitude = 1.5331645987538705e-07,
                             .force = 65982.98732472933,
                             .coefficient = 0.3,
                             .elements = {{"k1", 176638464.4017339},
                                          {"k2", 3.3897675162676846},
                                          {"c3", 5.485356807234443e-09},
                                          {"kd4", 0.011327318306121208},
                                          {"cd5", 5.658572134051975e-11},
                                          {"md6", 655497.3565770627},
                                          {"kd7", 4677684613031603.0},
                                          {"cd8", 5.583465731964918}}};
  const System system = system_of(test::scene_of(text));
  BOOST_CHECK_EXCEPTION(steady_state(Method::moreau, system, 8.056325363255551), ModelError,
                        [](const ModelError& error) {
                          return test::has(error.what(), "friction pushes the drive on");
                        });
}

BOOST_AUTO_TEST_SUITE_END()
