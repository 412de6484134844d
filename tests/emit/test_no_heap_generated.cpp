// Generated evaluators never take memory from the heap: not a single value, not a batch.
#include <boost/test/unit_test.hpp>

#include "derivation/scenes.hpp"
#include "emit/library.hpp"

BOOST_AUTO_TEST_SUITE(test_no_heap_generated)

using namespace vcrit;
using test::scene_of;

namespace {

// Prints how often memory is taken: within the calls, and by one new that shows the count at work.
// Among the columns are numbers beyond the usual range, which other code answers.
const char* const driver = R"(#include <cstdio>
#include <vector>
#include "library_batch.hpp"
#include "support/heap.hpp"
using namespace library;
int main() {
  constexpr std::size_t n = 1000;
  Parameters p;
  Columns columns;
  PartialColumns partials;
  std::vector<double> column(n), partial(n), v(n), bound(n);
  detail::each([&](double& x, const double*& c, double*& d) {
    x = 0.7, c = column.data(), d = partial.data();
  }, p, columns, partials);
  for (std::size_t i = 0; i < n; ++i) column[i] = i % 50 == 49 ? 1e200 : 0.2 + 0.001 * double(i);
  double sum = 0;
  const long calls = vcrit::test::heap_requests([&] {
    for (const double x : column) {
      p.mu0 = x;
      sum = sum + critical_velocity(p) + critical_velocity_certified(p).value;
      sum = sum + critical_velocity_gradient(p).value;
      sum = sum + fast::critical_velocity(p) + fast::critical_velocity_certified(p).value;
      sum = sum + fast::critical_velocity_gradient(p).value;
    }
    critical_velocity(p, column, v);
    fast::critical_velocity(p, column, v);
    critical_velocity(p, columns, v, std::span<double>(bound));
    fast::critical_velocity(p, columns, v, std::span<double>(bound));
    critical_velocity(p, columns, v, partials);
    fast::critical_velocity(p, columns, v, partials);
  });
  const long planted = vcrit::test::heap_requests([&] { v = std::vector<double>(n, sum); });
  std::printf("%ld %ld %d\n", calls, planted, v[0] == sum);
}
)";

}  // namespace

BOOST_AUTO_TEST_CASE(values_batches_and_gradients) {
  const std::string tests = VCRIT_TEST_DATA "/..";
  for (const Scene& scene :
       {test::kelvin_scene(), scene_of("normal = \"bridge\"\ntangential = \"prony(k, q, tau, 3)\"",
                                       "kd", "m", test::bridge_network)}) {
    const test::PrivateFolder folder;
    write_file(folder.path() / "library.hpp",
               symbolic::emit_header(symbolic::derive(scene), "library"));
    write_file(folder.path() / "library_batch.hpp",
               symbolic::emit_batch_header(symbolic::derive(scene), "library"));
    write_file(folder.path() / "driver.cpp", driver);
    const std::string program = (folder.path() / "program").string();
    const test::Outcome built =
        test::run({"g++", "-std=c++20", "-O1", "-I" + tests, "-o", program,
                   (folder.path() / "driver.cpp").string(), tests + "/support/heap.cpp"},
                  folder.path());
    BOOST_REQUIRE_MESSAGE(built.status == 0, built.output);
    BOOST_TEST(test::run({program}, folder.path()).output == "0 1 1\n");
  }
}

BOOST_AUTO_TEST_SUITE_END()
