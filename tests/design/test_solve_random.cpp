// What solve answers, of random scenes of each kind: simulated again it has the ratio that was
// asked for, a little before it does not, and nothing nearer to the beginning of the search does.
// Ratios are asked for that some value is known to reach.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "answers/critical_onset.hpp"
#include "critical/admissibility.hpp"
#include "design/opening.hpp"
#include "design/solve.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/system/system.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_solve_random)

namespace {

using namespace vcrit;
using design::DesignAnswer;
using design::DesignQuestion;
using design::Sought;
using test::SceneText;

constexpr int samples = 60;
constexpr double two_turns = 4 * 3.14159265358979323846;

// Neither series nor parallel: c1 between the middles of k1 - ct and kt - k2.
constexpr const char* bridge = R"([networks.bridge]
terminals = ["a", "b"]
edges = [["k1", "a", "x"], ["ct", "x", "b"], ["kt", "a", "y"], ["k2", "y", "b"], ["c1", "x", "y"]]
)";

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  double magnitude() { return std::pow(10, uniform(-0.7, 0.7)); }

  /// A scene of these networks, of elements of about 1; at omega = 1.
  SceneText scene(const char* normal, const char* tangential, const char* drive, bool body) {
    SceneText text{.normal = normal, .tangential = tangential, .angular_frequency = 1};
    if (drive != nullptr) text.network = drive;
    if (body) text.mass = magnitude();
    std::string used = std::string(normal) + tangential + (drive != nullptr ? drive : "");
    if (tangential == std::string("bridge")) {
      text.more = bridge;
      used += bridge;
    }
    for (const char* name : {"kn", "k1", "c1", "kt", "ct", "kd", "cd", "k2"})
      if (used.find(name) != std::string::npos) text.elements.emplace_back(name, magnitude());
    return text;
  }

 private:
  std::mt19937 random_;
};

double ratio_of(const Problem& problem, double velocity) {
  return simulation::steady_state(simulation::system_of(problem), velocity).friction_ratio;
}

/// The scene with a value of what is sought, and its speed.
double ratio_with(const DesignQuestion& asked, double value) {
  if (asked.sought == Sought::velocity) return ratio_of(asked.problem, value);
  return ratio_of(asked.sought == Sought::amplitude
                      ? design::with_amplitude(asked.problem, value)
                      : design::with_angular_frequency(asked.problem, two_turns / 2 * value),
                  asked.velocity);
}

/// `reached`: a value that has the ratio that is asked for.
void check(const DesignQuestion& asked, double reached, Random& random) {
  const DesignAnswer answer = design::solve(asked);
  const double wanted = asked.friction_ratio, error = answer.state.friction_ratio_error;
  const double side = asked.sought == Sought::velocity ? 1 : -1;
  BOOST_TEST(ratio_with(asked, answer.value) <= wanted + error);
  BOOST_TEST(side * (answer.value - reached) >= -answer.value_error - 1e-9 * reached);
  if (answer.at_start) return;
  const double begin = asked.sought == Sought::velocity ? answer.to : answer.from;
  const double before = answer.value + side * (2 * answer.value_error + 1e-7 * answer.value);
  if (side * (begin - before) <= 0) return;
  BOOST_TEST(ratio_with(asked, before) > wanted - error);
  for (int i = 0; i < 5; ++i) {
    const double there = before + random.uniform(0, 1) * (begin - before);
    if (there > 0) BOOST_TEST(ratio_with(asked, there) > wanted - error, there);
  }
}

DesignQuestion question(const Scene& scene, Sought sought, double ratio, double velocity) {
  return {scene, sought, ratio, velocity, {}, {}, samples};
}

/// All that may be sought of a scene, at a part of its v*; false where friction is nearly full
/// there.
bool ask(const Scene& scene, Random& random) {
  const CriticalOnset onset = critical_onset(scene);
  BOOST_REQUIRE((onset.contact_velocity > 0 && std::isfinite(onset.contact_velocity)));
  const double velocity = onset.drive_velocity - random.uniform(0.1, 0.9) * onset.contact_velocity;
  const double ratio = ratio_of(scene, velocity);
  if (!(ratio > 0 && ratio < 1 - 1e-6)) return false;
  check(question(scene, Sought::velocity, ratio, 0), velocity, random);
  if (opens(scene)) return true;
  check(question(scene, Sought::amplitude, ratio, velocity), *scene.amplitude.value, random);
  DesignQuestion frequency = question(scene, Sought::frequency, ratio, velocity);
  const double here = *scene.angular_frequency.value / (two_turns / 2);
  frequency.from = 0.8 * here, frequency.to = 1.25 * here;
  check(frequency, here, random);
  return true;
}

struct Kind {
  const char *name, *normal, *tangential, *drive;
  bool body, separation;
};
constexpr Kind kinds[]{
    {"closed", "kn | (k1 - c1)", "kt | ct", nullptr, false, false},
    {"driven", "kn", "kt | (k2 - ct)", "kd | cd", false, false},
    {"mass", "kn | c1", "kt | ct", "kd | cd", true, false},
    {"undamped mass", "kn", "kt", "kd", true, false},
    {"creeping", "kn", "kt - ct", nullptr, false, false},
    {"graph", "kn", "bridge", "kd | cd", true, false},
    {"separation elastic", "kn", "kt", nullptr, false, true},
    {"separation with memory", "kn | (k1 - c1)", "kt | ct", nullptr, false, true},
    {"separation with body", "kn", "kt | ct", "kd | cd", true, true},
};

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_answered_is_what_was_asked_for) {
  constexpr unsigned seed = 20;
  BOOST_TEST_MESSAGE("seed " << seed);
  Random random(seed);
  int asked = 0;
  for (const Kind& kind : kinds)
    for (int i = 0; i < 4; ++i) {
      SceneText text = random.scene(kind.normal, kind.tangential, kind.drive, kind.body);
      text.separation = kind.separation;
      text.amplitude = kind.separation ? random.uniform(1.2, 4) : 1;
      Scene scene = test::scene_of(text);
      const design::NormalContact contact(scene);
      if (!kind.separation)
        scene.amplitude.value = random.uniform(0.2, 0.7) * contact.largest_amplitude(1);
      BOOST_TEST_CONTEXT(kind.name << " " << i) { asked += ask(scene, random) ? 1 : 0; }
    }
  BOOST_TEST(asked >= 30);
}

// A contact that only taps has a largest speed as others, but no amplitude that keeps it closed.
// Springs, rigid drive, u_z0 = 0: the contact sticks from its meeting at -pi/2 until vbar (t +
// pi/2) = cos t and then slips, by hand with a ratio of [vbar (t + pi/2)^2/2 + 1 - sin t]/2.
BOOST_AUTO_TEST_CASE(a_tapping_contact) {
  const Scene scene = test::scene_of({.tangential = "kt",
                                      .separation = true,
                                      .angular_frequency = 1,
                                      .amplitude = 3,
                                      .indentation = 0,
                                      .elements = {{"kn", 3}, {"kt", 2}}});
  const double critical = 2.25, quarter = two_turns / 8;
  for (const double slip : {-0.5, 0.0, 0.3246979, 1.2}) {
    const double part = std::cos(slip) / (slip + quarter);
    const double ratio = (part * (slip + quarter) * (slip + quarter) / 2 + 1 - std::sin(slip)) / 2;
    BOOST_TEST(std::abs(ratio_of(scene, part * critical) - ratio) <= 1e-13);
    const DesignAnswer answer = design::solve(question(scene, Sought::velocity, ratio, 0));
    BOOST_TEST(std::abs(answer.value / (part * critical) - 1) <= 1e-11);
    BOOST_TEST(answer.largest_amplitude == 0);
  }
  for (const Sought sought : {Sought::amplitude, Sought::frequency})
    BOOST_TEST(test::has(
        test::refusal<ModelError>([&] { design::solve(question(scene, sought, 0.5, 1)); }),
        "without an indentation u_z0 the contact opens at every amplitude"));
}

// Next to resonance v* is 1e16 times the speed at which friction rises, and what lies between is
// lost in rounding: the ratio is found, and not said to be reached by none.
BOOST_AUTO_TEST_CASE(next_to_resonance_speeds_are_sought_where_friction_rises) {
  SceneText text{.tangential = "kt | ct",
                 .network = "kd",
                 .mass = 1e-3,
                 .angular_frequency = 1e5,
                 .amplitude = 1e-7,
                 .indentation = 5e-7,
                 .coefficient = 0.3,
                 .elements = {{"kn", 1e7}, {"kt", 8e6}, {"ct", 20}, {"kd", 1e7}}};
  for (const double mass : {1e-3, 0x1p-10}) {
    text.mass = mass;
    text.elements.back().second = mass == 1e-3 ? 1e7 : 9765625.0;
    const Scene scene = test::scene_of(text);
    DesignQuestion asked = question(scene, Sought::velocity, 0.85, 0);
    if (std::isinf(critical_onset(scene).contact_velocity)) {
      BOOST_TEST(test::has(test::refusal<ModelError>([&] { design::solve(asked); }),
                           "the search has no upper end"));
      asked.to = 1e12;
    }
    BOOST_TEST(test::has(test::refusal<ModelError>([&] { design::solve(asked); }),
                         "whether that is the largest velocity is not known"));
    asked.to = 0.1;
    const DesignAnswer answer = design::solve(asked);
    BOOST_TEST(ratio_of(scene, answer.value) <= 0.85);
    BOOST_TEST(ratio_of(scene, answer.value * (1 + 1e-6)) > 0.85);
  }
}

BOOST_AUTO_TEST_SUITE_END()
