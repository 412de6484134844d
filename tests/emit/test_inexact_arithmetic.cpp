// Generated C++ and C99 where compilers or libraries do not compute as IEEE 754 says: sums that are
// regrouped, registers of more digits, an fma that is a product and a sum. Every such build has to
// end in #error or keep its bounds, against nodal elimination at 250 digits.
#include <boost/test/unit_test.hpp>

#include <map>

#include "derivation/scenes.hpp"
#include "emit/draw.hpp"
#include "emit/library.hpp"

BOOST_AUTO_TEST_SUITE(test_inexact_arithmetic)

using namespace vcrit;
using test::scene_of;

namespace {

constexpr unsigned seed = 31;
constexpr int cases = 60;

// Compiled with the flags under test.
const char* const cpp_side = R"(#include "kelvin_batch.hpp"
extern "C" void evaluate(const double* x, double* out) {
  const kelvin::Parameters p{X};
  const auto c = kelvin::critical_velocity_certified(p);
  const auto f = kelvin::fast::critical_velocity_certified(p);
  out[0] = c.value, out[1] = c.relative_error_bound, out[2] = f.value, out[3] = f.relative_error_bound;
  kelvin::critical_velocity(p, {.omega = &p.omega}, {out + 4, 1}, std::span<double>(out + 5, 1));
  kelvin::fast::critical_velocity(p, {.omega = &p.omega}, {out + 6, 1}, std::span<double>(out + 7, 1));
}
)";
const char* const c_side = R"(#include "kelvin.h"
void evaluate(const double* x, double* out) {
  const kelvin_Parameters p = {X};
  const kelvin_Certified c = kelvin_critical_velocity_certified(&p);
  const kelvin_Certified f = kelvin_fast_critical_velocity_certified(&p);
  out[0] = out[4] = c.value, out[1] = out[5] = c.relative_error_bound;
  out[2] = out[6] = f.value, out[3] = out[7] = f.relative_error_bound;
}
)";

// Compiled plainly: "violations finite", the latter of accurate bounds. v* is the sum of two
// doubles, and its difference to a near value exact but for its last digits.
const char* const judge = R"(#include <math.h>
#include <stdio.h>
void evaluate(const double* x, double* out);
static const double rows[][N + 2] = {ROWS};
int main(void) {
  int violations = 0, finite = 0;
  for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
    double out[8];
    evaluate(rows[i], out);
    for (int g = 0; g < 8; g += 2) {
      const volatile double difference = out[g] - rows[i][N];
      const volatile double error = fabs((difference - rows[i][N + 1]) / rows[i][N]);
      if (isfinite(out[g + 1]) && !(error <= out[g + 1] * (1 + 1e-9))) ++violations;
    }
    finite += isfinite(out[1]) ? 1 : 0;
  }
  printf("%d %d\n", violations, finite);
  return 0;
}
)";

const char* const false_fma = R"(double fma(double a, double b, double c) {
  const volatile double p = a * b;
  return p + c;
}
)";

using Words = std::vector<std::string>;

struct Compiler {
  std::string name;
  bool is_cpp;
};

/// Of the cases and of the wrong rows: bounds that do not hold; accurate bounds that are finite.
struct Judged {
  int violations = -1, finite = -1;
};

/// Each parameter as no scene has it. No value is right, so that a finite bound does not hold.
std::string wrong_rows(const std::vector<double>& right) {
  std::string rows;
  for (std::size_t i = 0; i < right.size(); ++i)
    for (const char* wrong : {"NAN", "INFINITY", "-INFINITY", "-1"}) {
      for (std::size_t j = 0; j < right.size(); ++j)
        rows += (j == 0 ? "{" : ", ") + (i == j ? wrong : fmt::format("{:a}", right[j]));
      rows += ", NAN, NAN},\n";
    }
  return rows;
}

/// What has to be the same for all that is linked.
Words target_of(Words flags) {
  std::erase_if(flags, [](const std::string& flag) { return flag != "-m32"; });
  return flags;
}

class Builds {
 public:
  Builds() {
    const Scene scene = scene_of(test::kelvin_contact, "kd | cd", "m");
    const symbolic::Derivation derivation = symbolic::derive(scene);
    const symbolic::ParameterList parameters(scene, derivation);
    symbolic::generate(derivation, folder_.path(), "kelvin");
    symbolic::generate(derivation, folder_.path(), "kelvin", {.language = "c99"});
    test::Draw draw(seed);
    std::string rows;
    std::size_t count = 0;
    for (int i = 0; i < cases; ++i) {
      const Scene drawn = draw.values_for(scene, i % 3 == 2 ? 2 : 0);
      std::vector<double> row = test::members(drawn, parameters);
      count = row.size();
      const test::Real exact = test::critical_velocity_by_nodes(drawn);
      row.push_back(static_cast<double>(exact));
      row.push_back(static_cast<double>(exact - test::Real(row.back())));
      rows += fmt::format("{{{:a}}},\n", fmt::join(row, ", "));
    }
    rows += wrong_rows(test::members(draw.values_for(scene, 0), parameters));
    Words members;
    for (std::size_t i = 0; i < count; ++i) members.push_back(fmt::format("x[{}]", i));
    const auto with = [&](const std::string& text, const std::string& mark, const std::string& by) {
      std::string whole = text;
      return whole.replace(whole.find(mark), mark.size(), by);
    };
    const std::string all = fmt::format("{{{}}}", fmt::join(members, ", "));
    write("evaluate.cpp", with(cpp_side, "{X}", all));
    write("evaluate.c", with(c_side, "{X}", all));
    write("judge.c", fmt::format("enum {{ N = {} }};\n", count) + with(judge, "ROWS", rows));
    write("fma.c", false_fma);
    write("nothing", "");
    write("empty.cpp", "#include <cmath>\nint main() {}\n");
    write("empty.c", "#include <math.h>\nint main(void) { return 0; }\n");
  }

  /// Whether the compiler that answered with `complaints` has these flags, and what it takes to
  /// link for their target.
  bool knows(const Compiler& compiler, const Words& flags, const std::string& complaints) {
    Words command{compiler.name, "-fsyntax-only", "-x", compiler.is_cpp ? "c++" : "c",
                  path("nothing")};
    command.insert(command.end(), flags.begin(), flags.end());
    Words link{compiler.name, path(compiler.is_cpp ? "empty.cpp" : "empty.c"), "-o", path("empty")};
    for (const std::string& flag : target_of(flags)) link.push_back(flag);
    return (complaints.empty() || once(command).status == 0) && once(link).status == 0;
  }

  /// In both languages.
  std::vector<Compiler> compilers() const {
    std::vector<Compiler> found;
    for (const auto& [name, is_cpp] : {std::pair("g++", true), std::pair("clang++", true),
                                       std::pair("gcc", false), std::pair("clang", false)}) {
      test::require_tool(name, folder_.path());
      found.push_back({name, is_cpp});
    }
    return found;
  }

  /// The compiler's complaints, where an #error is the last.
  std::string compile(const Compiler& compiler, const Words& flags) {
    Words command{compiler.name, compiler.is_cpp ? "-std=c++20" : "-std=c99", "-Wfatal-errors",
                  "-I", path("")};
    command.insert(command.end(), flags.begin(), flags.end());
    evaluate_ = path(fmt::format("{}{}.o", compiler.name, fmt::join(flags, "")));
    for (const std::string& word :
         {std::string("-c"), path(compiler.is_cpp ? "evaluate.cpp" : "evaluate.c"),
          std::string("-o"), evaluate_})
      command.push_back(word);
    const test::Outcome& outcome = once(command);
    return outcome.status == 0 ? "" : outcome.output + " ";
  }

  /// Of what was compiled last, linked with `more` objects.
  Judged judged(const Words& flags, const Words& more = {}) {
    Words link{"g++", evaluate_};
    const auto add = [&](const std::string& name) {
      link.push_back(path(fmt::format("{}{}.o", name, fmt::join(flags, ""))));
      Words command{"gcc", "-O1", "-fno-builtin", "-c", path(name + ".c"), "-o", link.back()};
      command.insert(command.end(), flags.begin(), flags.end());
      BOOST_REQUIRE_EQUAL(once(command).output, "");
    };
    add("judge");
    for (const std::string& name : more) add(name);
    link.insert(link.end(), flags.begin(), flags.end());
    for (const std::string& word : {std::string("-lm"), std::string("-o"), path("judge")})
      link.push_back(word);
    BOOST_REQUIRE_EQUAL(run(link).output, "");
    Judged result;
    std::istringstream(run({path("judge")}).output) >> result.violations >> result.finite;
    return result;
  }

 private:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    write_file(folder_.path() / name, text);
  }
  test::Outcome run(const Words& command) const { return test::run(command, folder_.path()); }
  /// Compilers make the same of the same.
  const test::Outcome& once(const Words& command) {
    const auto known = outcomes_.find(command);
    return known != outcomes_.end() ? known->second
                                    : outcomes_.emplace(command, run(command)).first->second;
  }

  test::PrivateFolder folder_;
  std::map<Words, test::Outcome> outcomes_;
  std::string evaluate_;  // the object of the last compilation
};

/// One for all cases.
Builds& builds_of_kelvin() {
  static Builds builds;
  return builds;
}

}  // namespace

BOOST_AUTO_TEST_CASE(inexact_arithmetic_is_refused_or_has_no_bound) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const std::vector<Words> hostile{
      {"-O2", "-ffast-math"},
      {"-O2", "-ffast-math", "-fno-finite-math-only"},
      {"-O2", "-funsafe-math-optimizations"},
      {"-O2", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"},
      {"-O2", "-freciprocal-math"},
      {"-O2", "-mfpmath=387"},
      {"-O2", "-mfpmath=sse+387"},
      {"-O2", "-m32"},
      {"-O2", "-m32", "-mfpmath=387"},
      {"-O0", "-m32", "-march=i386"},
      {"-O2", "-m32", "-ffloat-store"},
      {"-O2", "-m32", "-fexcess-precision=fast"},
      {"-O2", "-m32", "-mpc64"}};
  Builds& builds = builds_of_kelvin();
  int refused = 0, judged = 0;
  for (const Compiler& compiler : builds.compilers())
    for (const Words& flags : hostile)
      BOOST_TEST_CONTEXT(fmt::format("{} {}", compiler.name, fmt::join(flags, " "))) {
        const std::string complaints = builds.compile(compiler, flags);
        const bool is_ours =
            complaints.find("-ffast-math destroys the arithmetic") != std::string::npos ||
            complaints.find("doubles have to be rounded as doubles") != std::string::npos;
        if (!is_ours && !builds.knows(compiler, flags, complaints)) {
          BOOST_TEST(flags[1].starts_with("-m"));  // another processor's, or no library for 32 bits
          continue;
        }
        if (!complaints.empty()) {
          BOOST_TEST(complaints.find("error") != std::string::npos);
          BOOST_TEST(is_ours, complaints);
          ++refused;
          continue;
        }
        BOOST_TEST(builds.judged(target_of(flags)).violations == 0);
        ++judged;
      }
  BOOST_TEST_MESSAGE(refused << " refused, " << judged << " judged");
  BOOST_TEST(refused > 0);
}

BOOST_AUTO_TEST_CASE(exact_arithmetic_keeps_its_bounds) {
  Builds& builds = builds_of_kelvin();
  for (const Compiler& compiler : builds.compilers())
    for (const Words& flags : {Words{"-O2"},
                               {"-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno"},
                               {"-O2", "-ffinite-math-only"},
                               {"-O3", "-march=native", "-ffinite-math-only", "-fno-signed-zeros"},
                               {"-O2", "-m32", "-msse2", "-mfpmath=sse"}})
      BOOST_TEST_CONTEXT(fmt::format("{} {}", compiler.name, fmt::join(flags, " "))) {
        const std::string complaints = builds.compile(compiler, flags);
        if (!builds.knows(compiler, flags, complaints)) {
          BOOST_TEST(flags[1].starts_with("-m"));  // another processor's, or no library for 32 bits
          continue;
        }
        BOOST_REQUIRE_EQUAL(complaints, "");
        const Judged judged = builds.judged(target_of(flags));
        BOOST_TEST(judged.violations == 0);
        BOOST_TEST(judged.finite == cases);
      }
}

// As in a libm of machines without one. Linked before the real one.
BOOST_AUTO_TEST_CASE(a_false_fma_leaves_no_bound) {
  Builds& builds = builds_of_kelvin();
  for (const Compiler& compiler : builds.compilers()) BOOST_TEST_CONTEXT(compiler.name) {
      BOOST_REQUIRE_EQUAL(builds.compile(compiler, {"-O2"}), "");
      const Judged judged = builds.judged({}, {"fma"});
      BOOST_TEST(judged.violations == 0);
      BOOST_TEST(judged.finite <= cases);
#if defined __x86_64__ && !defined __FMA__
      BOOST_TEST(judged.finite == 0);
#endif
    }
}

BOOST_AUTO_TEST_SUITE_END()
