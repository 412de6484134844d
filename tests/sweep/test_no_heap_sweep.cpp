// Points of a sweep take no memory from the heap, but what each stretch of 4096 rows of formula, or
// of 32 speeds, takes for itself, and each row of another scene for its numbers and its motion.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "answers/friction.hpp"
#include "critical/critical_velocity.hpp"
#include "modes/general_modes.hpp"
#include "problem/variation.hpp"
#include "scene/scene.hpp"
#include "simulation/system/system.hpp"
#include "stiffness/relaxation.hpp"
#include "support/heap.hpp"
#include "support/scene_text.hpp"
#include "sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(test_no_heap_sweep)

namespace {

using namespace vcrit;

long requests(const std::string& scene, const std::vector<std::string>& axes,
              const std::vector<std::string>& quantities,
              std::optional<double> velocity_ratio = std::nullopt) {
  Sweep sweep{read_scene(VCRIT_SCENES "/" + scene), {}, {}, {}, {}};
  sweep.velocity_ratio = velocity_ratio;
  for (const std::string& axis : axes) sweep.axes.push_back(parse_axis(axis, sweep.problem));
  for (const std::string& quantity : quantities)
    sweep.quantities.push_back(parse_swept_quantity(quantity, sweep.problem));
  const Sweeping sweeping(sweep);
  BOOST_TEST_REQUIRE(sweeping.grid().blocks() == 1U);
  BlockAnswer answer = sweeping.answer(0);
  BOOST_TEST(answer.outside == 0U);
  return test::heap_requests([&] { answer = sweeping.answer(0); });
}

constexpr double velocity_share = 0.5;

struct Amplitudes {
  const char *scene, *range;
  double one;
};
constexpr Amplitudes swept_amplitudes[] = {{"kelvin_rigid.toml", "10 nm:90 nm", 50e-9},
                                           {"zener.toml", "10 nm:90 nm", 50e-9},
                                           {"kelvin.toml", "10 nm:90 nm", 50e-9},
                                           {"bridge.toml", "10 nm:90 nm", 50e-9},
                                           {"sonotrode.toml", "50 nm:450 nm", 200e-9}};

// Of 100 rows more, without what sets the sweep up.
long requests_of_100_rows(const Amplitudes& swept, const std::string& quantity, int before = 100) {
  const auto rows = [&](int count) {
    return requests(swept.scene, {fmt::format("amplitude=lin:{}:{}", swept.range, count)},
                    {quantity},
                    quantity == "critical_velocity" ? std::nullopt : std::optional(velocity_share));
  };
  return rows(before + 100) - rows(before);
}

// What a row takes beside v*: for its problem, and for the motion of that, where the modes of its
// drive are known already and where they are not.
struct RowParts {
  long problem = 0, motion = 0, motion_of_new_modes = 0;
};

RowParts parts_of_row(const Amplitudes& swept) {
  const Variation varied(read_scene(std::string(VCRIT_SCENES "/") + swept.scene), {"amplitude"});
  const Problem there = varied.at({&swept.one, 1});
  const double velocity = velocity_share * critical_velocity(there);
  double ratio = 0, error = 0;
  const char* reason = nullptr;
  simulation::KnownModes known;
  const auto motion = [&] {
    return test::heap_requests([&] {
      SteadyFriction(there, nullptr, &known)
          .curve({&velocity, 1}, [&ratio, &error, &reason](auto, const auto& point) {
            ratio = point.state->friction_ratio;  // three references, as a sweep's row has: they
            error = point.state->friction_ratio_error;  // are on the heap
            reason = point.reason;
          });
    });
  };
  RowParts found;
  found.problem = test::heap_requests([&] { varied.at({&swept.one, 1}); });
  found.motion_of_new_modes = motion();
  found.motion = motion();
  return found;
}

}  // namespace

// Four stretches each, 4000 rows apart.
BOOST_AUTO_TEST_CASE(rows_of_formula) {
  const auto rows = [](int count) {
    return requests("zener.toml", {fmt::format("frequency=log:1 kHz:100 kHz:{}", count)},
                    {"critical_velocity"});
  };
  const long few = rows(12'300);
  BOOST_TEST(rows(16'300) == few);
  BOOST_TEST(few > 0);
}

BOOST_AUTO_TEST_CASE(speeds_of_a_scene) {
  for (const char* scene : {"zener.toml", "kelvin.toml", "kelvin_rigid.toml", "bridge.toml"}) {
    const auto speeds = [scene](int count) {
      return requests(scene, {fmt::format("velocity_ratio=lin:0.05:1.2:{}", count)},
                      {"friction_ratio", "friction_ratio_error", "regime", "critical_velocity"});
    };
    const long few = speeds(8), full = speeds(32);
    BOOST_TEST(full == few);
    // The second stretch costs no more than the first, which sets up the scene as well.
    BOOST_TEST(speeds(64) <= 2 * few);
  }
}

// The hundred rows behind two hundred take what those behind one hundred did. Each row takes what
// its v*, its problem and its motion take, once each, and nothing else.
BOOST_AUTO_TEST_CASE(rows_of_other_scenes) {
  for (const Amplitudes& swept : swept_amplitudes) {
    const long rows = requests_of_100_rows(swept, "friction_ratio");
    const RowParts row = parts_of_row(swept);
    BOOST_TEST(rows == requests_of_100_rows(swept, "friction_ratio", 200), swept.scene);
    BOOST_TEST(
        rows <= requests_of_100_rows(swept, "critical_velocity") + 100 * (row.problem + row.motion),
        swept.scene);
  }
}

// Its problem takes three: what it is, the array of its numbers, and that of the numbers of the
// row.
BOOST_AUTO_TEST_CASE(the_problem_of_a_row_takes_no_more_for_more_numbers) {
  for (const std::size_t branches : {3U, 100U}) {
    std::vector<double> numbers(branches);
    std::iota(numbers.begin(), numbers.end(), 1.0);
    const Variation varied(
        test::scene_of({.normal = "prony(k0, k, tau)",
                        .elements = {{"k0", 1}, {"k", numbers}, {"tau", numbers}}}),
        {"amplitude", "frequency"});
    const double row[] = {0.05, 3};
    BOOST_TEST(test::heap_requests([&] { varied.at(row); }) == 3, branches);
  }
}

// Their modes, in slip and in stick, are found for the first row alone: the bound above is that of
// known modes, which is less.
BOOST_AUTO_TEST_CASE(modes_of_a_drive_with_masses) {
  const RowParts row = parts_of_row(swept_amplitudes[4]);
  BOOST_TEST(row.motion < row.motion_of_new_modes);
}

// Of the two networks of a contact each is relaxed; of an isotropic one the normal network alone,
// and the tangential one takes a copy.
BOOST_AUTO_TEST_CASE(an_isotropic_contact_is_relaxed_once) {
  test::SceneText text{.normal = "zener(k, k1, c)", .elements = {{"k", 1}, {"k1", 1}, {"c", 1}}};
  const auto system = [&] {
    const Problem problem = test::scene_of(text);
    simulation::system_of(problem);  // from here on both networks are reduced
    return test::heap_requests([&] { simulation::system_of(problem); });
  };
  const Problem problem = test::scene_of(text);
  const auto relaxed = [&] { return relaxation_form(problem->normal.network(), problem.values()); };
  const Relaxation normal = relaxed();
  const long relaxation = test::heap_requests(relaxed);
  const long copy = test::heap_requests([&] { const Relaxation other = normal; });
  const long isotropic = system();
  text.tangential = "zener(kt, kt1, ct)";
  for (const char* name : {"kt", "kt1", "ct"}) text.elements.push_back({name, 1});
  BOOST_TEST(copy < relaxation);
  BOOST_TEST(isotropic - copy <= system() - relaxation);
}

BOOST_AUTO_TEST_SUITE_END()
