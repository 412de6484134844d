// Batches of generated headers: the same bits as one call at a time, and loops of vector
// instructions.
#include <boost/test/unit_test.hpp>

#include "derivation/scenes.hpp"
#include "emit/library.hpp"

BOOST_AUTO_TEST_SUITE(test_batches)

using namespace vcrit;
using test::scene_of;

namespace {

std::vector<Scene> scenes() {
  return {test::kelvin_scene(),
          scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = \"nu\"", "kd | cd", "m"),
          scene_of("normal = \"bridge\"\ntangential = \"k0 | (kt - ct)\"", "kd", "m",
                   test::bridge_network)};
}

// Columns for every second parameter in turn, lengths around the size of a block, values that leave
// the range of doubles (another grade answers), results in place of a column or of omega.
const char* const common = R"(#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>
// A compiler that contracts products and sums of the bounds, where it has fma, may do so in a loop and not in a call.
bool near(double a, double b) { return a == b || std::abs(a - b) <= 1e-12 * std::abs(b); }
bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }
)";
// Of one library, in a namespace that uses its.
const char* const check = R"(bool fails() {
  int failures = 0, unsafe = 0;
  for (std::size_t n : {1, 7, 31, 32, 33, 64, 100, 131, 1100})
    for (std::size_t step = 1; step < 4; ++step) {
      Parameters p;
      Columns c;
      PartialColumns g;
      std::vector<std::vector<double>> columns, partials;
      columns.reserve(500), partials.reserve(500);
      std::size_t k = 0;
      detail::each([&](double& x, const double*& column, double*& partial) {
        x = 0.3 + 0.01 * double(k);
        if (++k % step != 0) return;
        columns.emplace_back(n), partials.emplace_back(n);
        for (std::size_t i = 0; i < n; ++i)
          columns.back()[i] = i % 50 == 49 ? std::ldexp(1.0 + x, 250) : 0.2 + std::fmod(x * double(i * i + k), 0.7);
        column = columns.back().data(), partial = partials.back().data();
      }, p, c, g);
      std::vector<double> v(n), b(n), gv(n), f(n), fb(n);
      critical_velocity(p, c, v, std::span<double>(b));
      critical_velocity(p, c, gv, g);
      fast::critical_velocity(p, c, f, std::span<double>(fb));
      std::vector<double> aliased = columns.back();
      Columns d = c;
      detail::each([&](const double*& x) { if (x == columns.back().data()) x = aliased.data(); }, d);
      fast::critical_velocity(p, d, aliased);
      std::vector<double> omega(n), swept(n);
      for (std::size_t i = 0; i < n; ++i) omega[i] = 0.2 + 0.001 * double(i);
      fast::critical_velocity(p, omega, swept);
      fast::critical_velocity(p, omega, omega);
      for (std::size_t i = 0; i < n; ++i) {
        Parameters at = p;
        detail::each([i](double& x, const double* column) { if (column) x = column[i]; }, at, c);
        const Certified one = critical_velocity_certified(at), fast_one = fast::critical_velocity_certified(at);
        const Gradient gradient = critical_velocity_gradient(at);
        bool good = same(swept[i], omega[i]) && same(one.value, v[i]) && near(one.relative_error_bound, b[i]) && same(gradient.value, gv[i]);
        good = good && same(fast_one.value, f[i]) && near(fast_one.relative_error_bound, fb[i]) && same(f[i], aliased[i]);
        detail::each([&](double x, const double* partial) { if (partial) good = good && same(x, partial[i]); },
                     gradient.partial, g);
        failures += good ? 0 : 1;
        unsafe += detail::in_range(at) ? 0 : 1;
      }
    }
  std::printf("%d failures, %d out of range\n", failures, unsafe);
  return failures != 0 || unsafe == 0;
}
)";

/// What a user would call in a loop of his own.
const char* const sweeps = R"(#include "library_batch.hpp"
using namespace library;
void accurate_sweep(const Parameters& p, std::span<const double> w, std::span<double> v) { critical_velocity(p, w, v); }
void fast_sweep(const Parameters& p, std::span<const double> w, std::span<double> v) { fast::critical_velocity(p, w, v); }
void accurate_columns(const Parameters& p, const Columns& c, std::span<double> v) { critical_velocity(p, c, v); }
void fast_columns(const Parameters& p, const Columns& c, std::span<double> v) { fast::critical_velocity(p, c, v); }
)";

void write_library(const test::PrivateFolder& folder, const Scene& scene,
                   const std::string& name = "library") {
  write_file(folder.path() / (name + ".hpp"), symbolic::emit_header(symbolic::derive(scene), name));
  write_file(folder.path() / (name + "_batch.hpp"),
             symbolic::emit_batch_header(symbolic::derive(scene), name));
}

std::string name_of_batch(std::size_t i) { return fmt::format("library_{}", i); }

/// One program that checks so many libraries.
std::string driver(std::size_t count) {
  std::string text = common, calls;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = name_of_batch(i);
    text += fmt::format(
        "#include \"{0}_batch.hpp\"\nnamespace of_{0} {{\nusing namespace {0};\n{1}}}\n", name,
        check);
    calls += fmt::format("  if (!of_{0}::fails()) std::puts(\"{0} passes\");\n", name);
  }
  return text + "int main() {\n" + calls + "}\n";
}

}  // namespace

BOOST_AUTO_TEST_CASE(batches_give_the_same_bits_as_single_calls) {
  const test::PrivateFolder folder;
  const std::vector<Scene> all = scenes();
  for (std::size_t i = 0; i < all.size(); ++i) write_library(folder, all[i], name_of_batch(i));
  write_file(folder.path() / "driver.cpp", driver(all.size()));
  const std::string program = (folder.path() / "program").string();
  for (const std::string& compiler : test::compilers(folder)) {
    const test::Outcome built =
        test::run({compiler, "-std=c++20", "-O2", "-march=native", "-fno-math-errno", "-o", program,
                   (folder.path() / "driver.cpp").string()},
                  folder.path());
    BOOST_REQUIRE_MESSAGE(built.status == 0, built.output);
    const test::Outcome outcome = test::run({program}, folder.path());
    for (std::size_t i = 0; i < all.size(); ++i)
      BOOST_TEST(outcome.output.find(name_of_batch(i) + " passes\n") != std::string::npos,
                 compiler << ": " << outcome.output);
  }
}

// Division and square root of vectors, four doubles each, in each of the loops, and as the only way
// to divide but for what is left over: with -O3 and AVX2, which any such machine can compile for.
BOOST_AUTO_TEST_CASE(loops_are_vectorised) {
#ifndef __x86_64__
  BOOST_TEST_MESSAGE("the listing is of x86-64");
#else
  for (const Scene& scene : scenes()) {
    const test::PrivateFolder folder;
    write_library(folder, scene);
    const std::string source = (folder.path() / "sweeps.cpp").string();
    const std::string target = (folder.path() / "sweeps.s").string();
    write_file(source, sweeps);
    for (const std::string& compiler : test::compilers(folder)) {
      const test::Outcome built = test::run({compiler, "-std=c++20", "-O3", "-mavx2", "-mfma",
                                             "-fno-math-errno", "-S", "-o", target, source},
                                            folder.path());
      BOOST_REQUIRE_MESSAGE(built.status == 0, built.output);
      const std::string listing = test::contents(target);
      std::size_t divisions = 0, roots = 0;
      for (std::size_t at = listing.find("vdivpd"); at != std::string::npos;
           at = listing.find("vdivpd", at + 1))
        divisions += listing.substr(at, 40).find("%ymm") != std::string::npos ? 1 : 0;
      for (std::size_t at = listing.find("vsqrtpd"); at != std::string::npos;
           at = listing.find("vsqrtpd", at + 1))
        roots += listing.substr(at, 40).find("%ymm") != std::string::npos ? 1 : 0;
      // Four loops; in the accurate ones a division of Twofold numbers takes two.
      BOOST_TEST(roots >= 4U, compiler);
      BOOST_TEST(divisions >= 6U, compiler);
    }
  }
#endif
}

BOOST_AUTO_TEST_SUITE_END()
