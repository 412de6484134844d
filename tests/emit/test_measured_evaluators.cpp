// Evaluators of measured drives: the table in the code, its linear interpolation, and nothing
// outside of it; in all languages, against Eq. (24) at 250 digits.
#include <boost/test/unit_test.hpp>

#include <limits>
#include <random>

#include "derivation/scenes.hpp"
#include "emit/language_files.hpp"
#include "emit/library.hpp"

BOOST_AUTO_TEST_SUITE(test_measured_evaluators)

using namespace vcrit;
using test::Asked;
using test::Call;
using test::LanguageCall;
using test::Real;
using test::scene_of;
using test::Tool;

namespace {

constexpr unsigned seed = 29;

using Rows = std::vector<Receptance::Row>;

Scene measured(const std::string& contact, const std::string& mass, Rows rows) {
  Scene scene = scene_of(contact, "kd", mass);
  scene.drive.reset();
  std::erase_if(scene.elements, [](const auto& element) { return element.first.name == "kd"; });
  scene.receptance = Receptance{"drive.csv", std::move(rows)};
  return scene;
}

/// Two resonances of a stiff tool, and a row in which it does not give at all.
Rows two_modes() {
  Rows rows;
  for (int i = 0; i < 41; ++i) {
    const double omega = 1e5 + 2e3 * i + 37.0 * (i % 3);
    std::complex<double> r = 4e-9;
    for (const auto& [mode, compliance] : {std::pair(1.3e5, 3e-9), std::pair(1.62e5, 1e-9)})
      r +=
          compliance / (1.0 - omega * omega / mode / mode + std::complex(0.0, 0.01 * omega / mode));
    rows.push_back({omega, i == 30 ? 0.0 : r.real(), i == 30 ? 0.0 : r.imag()});
  }
  return rows;
}

std::vector<Scene> scenes() {
  return {measured("normal = \"kn | cn\"\ntangential = \"kt | ct\"", "m", two_modes()),
          measured("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "", two_modes())};
}

/// R_d by the two rows around omega, which is inside of the table.
test::Complex receptance_at(const Rows& rows, double omega) {
  std::size_t i = 0;
  while (i + 2 < rows.size() && rows[i + 1].omega <= omega) ++i;
  const Real share =
      (Real(omega) - Real(rows[i].omega)) / (Real(rows[i + 1].omega) - Real(rows[i].omega));
  const auto mixed = [&](double a, double b) { return Real(a) * (1 - share) + Real(b) * share; };
  return {mixed(rows[i].re, rows[i + 1].re), mixed(rows[i].im, rows[i + 1].im)};
}

/// Eq. (24) with 1/R_d for K_d: the rigid scene's v* times |K_t R + 1 - m omega^2 R|/|1 - m omega^2
/// R|.
Real exact_velocity(const Scene& scene) {
  Scene rigid = scene;
  rigid.receptance.reset();
  const Values values = test::numbers_of(scene);
  const double omega = *scene.angular_frequency.value;
  const test::Nodal nodal(values, Real(omega));
  test::Complex contact;
  if (const auto* own = std::get_if<Network>(&scene.tangential)) {
    contact = nodal.stiffness(*own);
  } else {
    const Real nu(*std::get<Isotropic>(scene.tangential).quantity.value);
    contact = nodal.stiffness(scene.normal) * test::Complex(2 * (1 - nu) / (2 - nu), Real(0));
  }
  const test::Complex r = receptance_at(scene.receptance->rows, omega);
  test::Complex below(Real(1), Real(0));
  if (scene.mass)
    below -= r * test::Complex(Real(*scene.mass->value) * Real(omega) * Real(omega), Real(0));
  return test::critical_velocity_by_nodes(rigid) * Real(abs(test::Complex(contact * r + below))) /
         Real(abs(below));
}

/// Ordinary devices at a frequency of the table: a row, the first one or the last one among them.
class Devices {
 public:
  Scene values_for(Scene scene, int kind) {
    const auto near = [this](double size) {
      return size * std::pow(10, std::uniform_real_distribution(-1.0, 1.0)(random_));
    };
    for (auto& [symbol, value] : scene.elements) value = near(symbol.name[0] == 'c' ? 20 : 1e7);
    scene.coefficient.value = 0.3;
    scene.amplitude.value = 1e-7;
    scene.indentation.value = 1.0;
    if (scene.mass) scene.mass->value = near(3e-4);
    const Rows& rows = scene.receptance->rows;
    const double first = rows.front().omega, last = rows.back().omega;
    const auto row = std::uniform_int_distribution<std::size_t>(0, rows.size() - 1)(random_);
    scene.angular_frequency.value = kind == 0   ? rows[row].omega
                                    : kind == 1 ? first
                                    : kind == 2 ? last
                                    : kind == 3
                                        ? std::nextafter(rows[row].omega, 1.4e5)
                                        : std::uniform_real_distribution(first, last)(random_);
    return scene;
  }

 private:
  std::mt19937 random_{seed};
};

std::vector<LanguageCall> calls_of(const std::vector<Scene>& shapes, int count) {
  Devices devices;
  std::vector<LanguageCall> calls;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (int n = 0; n < count; ++n) {
      LanguageCall call;
      call.library = i;
      call.scene = devices.values_for(shapes[i], n % 8);
      call.exact = exact_velocity(call.scene);
      calls.push_back(std::move(call));
    }
  return calls;
}

/// Below the table, above it, and no number.
std::vector<LanguageCall> calls_outside(const std::vector<Scene>& shapes) {
  Devices devices;
  std::vector<LanguageCall> calls;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Rows& rows = shapes[i].receptance->rows;
    for (const double omega :
         {0.0, std::nextafter(rows.front().omega, 0.0), std::nextafter(rows.back().omega, 1e9),
          1e12, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
      LanguageCall call;
      call.library = i;
      call.scene = devices.values_for(shapes[i], 4);
      call.scene.angular_frequency.value = omega;
      calls.push_back(std::move(call));
    }
  }
  return calls;
}

void check_inside(const LanguageCall& call) {
  BOOST_TEST(test::relative_error(call.value(), call.exact) <= call.bound());
  BOOST_TEST(test::relative_error(call.fast_value(), call.exact) <= call.fast_bound());
  // Losses keep conditions below 1e3 or so: 60 roundings of that.
  BOOST_TEST(call.bound() <= 0x1.001p-53);
  BOOST_TEST(call.fast_bound() < 1e-11);
}

void check_outside(const LanguageCall& call) {
  for (const double value : {call.value(), call.fast_value()}) BOOST_TEST(std::isnan(value));
  for (const double bound : {call.bound(), call.fast_bound()})
    BOOST_TEST(bound == std::numeric_limits<double>::infinity());
}

std::vector<Call> in_cpp(const std::vector<LanguageCall>& calls) {
  std::vector<Call> found;
  for (const LanguageCall& call : calls) {
    found.emplace_back();
    found.back().library = call.library;
    found.back().scene = call.scene;
  }
  return found;
}

LanguageCall answered(LanguageCall call, const Call& found) {
  call.answers = {found.value, found.bound, found.fast_value, found.fast_bound};
  return call;
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_bounds_and_gradients_in_cpp) {
  const std::vector<Scene> shapes = scenes();
  const test::Libraries libraries(shapes, Asked::values_and_gradients);
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O1"}), "");
  const std::vector<LanguageCall> inside = calls_of(shapes, 200), outside = calls_outside(shapes);
  std::vector<Call> found = in_cpp(inside), none = in_cpp(outside);
  libraries.evaluate(found);
  for (std::size_t i = 0; i < inside.size(); ++i)
    BOOST_TEST_CONTEXT("scene " << inside[i].library << ", call " << i) {
      check_inside(answered(inside[i], found[i]));
      // By omega: of the table's line, too. Off the rows, where the next interval is another line.
      if (i % 8 < 4) continue;
      Scene low = inside[i].scene, high = low;
      const double omega = *low.angular_frequency.value;
      low.angular_frequency.value = omega * (1 - 0x1p-40);
      high.angular_frequency.value = omega * (1 + 0x1p-40);
      const Real slope = (exact_velocity(high) - exact_velocity(low)) /
                         (Real(*high.angular_frequency.value) - Real(*low.angular_frequency.value));
      // The reference errs by the square of 2^-40 times 1e2, the sharpness of a resonance.
      const double scale = std::abs(static_cast<double>(slope)) + found[i].value / omega;
      BOOST_TEST(std::abs(found[i].partials[1] - static_cast<double>(slope)) <= 1e-13 * scale);
      BOOST_TEST(std::abs(found[i].fast_partials[1] - static_cast<double>(slope)) <= 1e-9 * scale);
    }
  libraries.evaluate(none);
  for (std::size_t i = 0; i < outside.size(); ++i) check_outside(answered(outside[i], none[i]));
}

BOOST_AUTO_TEST_CASE(other_languages) {
  const std::vector<Scene> shapes = scenes();
  std::vector<LanguageCall> inside = calls_of(shapes, 40), outside = calls_outside(shapes);
  const test::LanguageFiles files(shapes);
  files.with_each_tool(
      [&](const Tool& tool) {
        files.evaluate(tool, inside);
        for (const LanguageCall& call : inside) {
          check_inside(call);
          BOOST_TEST(test::relative_error(call.answers[6], call.exact) <= call.bound());
          BOOST_TEST(test::relative_error(call.answers[7], call.exact) <= call.fast_bound());
        }
        files.evaluate(tool, outside);
        for (const LanguageCall& call : outside) check_outside(call);
      },
      test::LanguageFiles::Length::very_large);
}

// Between rows without loss every step is exact: R_d = 1/2 at omega = 2.
BOOST_AUTO_TEST_CASE(resonance_antiresonance_and_no_deflection) {
  const Scene scene = measured("normal = \"kn\"\ntangential = \"kt\"", "m",
                               {{1, 0.25, 0}, {3, 0.75, 0}, {4, 0, 0}, {5, 0, 0}});
  const auto at = [&](double omega, double mass) {
    Call call;
    call.scene = scene;
    call.scene.elements = {{{"kn"}, 4.0}, {{"kt"}, 1.0}};
    call.scene.coefficient.value = 0.25;
    call.scene.angular_frequency.value = omega;
    call.scene.amplitude.value = 1.0;
    call.scene.mass->value = mass;
    return call;
  };
  // K_d = 2; m omega^2 = 2, 3 and 1, then a drive that does not give.
  std::vector<Call> calls{at(2, 0.5), at(2, 0.75), at(2, 0.25), at(4, 0.25), at(4.5, 7)};
  const test::Libraries libraries({scene});
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {}), "");
  libraries.evaluate(calls);
  constexpr double inf = std::numeric_limits<double>::infinity();
  BOOST_TEST(calls[0].value == inf);
  BOOST_TEST(calls[0].bound == inf);
  BOOST_TEST(calls[1].value == 0.0);
  BOOST_TEST(calls[1].bound == inf);
  BOOST_TEST(calls[2].value == 4.0);  // omega kn/kt/4 (1 + 2 - 1)/(2 - 1)
  BOOST_TEST(calls[3].value == 4.0);  // omega kn/kt/4
  BOOST_TEST(calls[4].value == 4.5);
  for (const int i : {2, 3, 4}) BOOST_TEST(calls[static_cast<std::size_t>(i)].bound <= 0x1.001p-53);
}

BOOST_AUTO_TEST_CASE(the_file_tells_of_its_table) {
  for (const std::string& language : symbolic::language_names()) {
    const std::string text =
        symbolic::emit(symbolic::derive(scenes().front()), "tool", {.language = language});
    BOOST_TEST(text.find("R_d: 41 rows from 100000 to 180037 rad/s, linear between two rows") !=
                   std::string::npos,
               language);
    BOOST_TEST(text.find("NaN for 0/0 alone") == std::string::npos, language);
  }
}

BOOST_AUTO_TEST_SUITE_END()
