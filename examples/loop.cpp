// Problem         v* over frequency in a loop of one's own, of a Zener contact without a drive
//                 network: K_n = k0 + i w k1 c1/(k1 + i w c1), K_t = kt.
// Exact solution  Eq. (24) with a rigid drive, v* = mu0 w du_z |K_n|/kt; k0, k1 and c1 are chosen
//                 for a relaxation time of 10 us.
// Method          The scene is parsed once from text; each value is Eq. (24) in doubles.
//
//     loop
#include <cstdio>
#include <numbers>
#include <vcrit/critical/critical_velocity.hpp>

namespace {

constexpr const char* text = R"toml(
[contact]
normal     = "zener(k0, k1, c1)"
tangential = "kt"

[oscillation]
frequency   = "20 kHz"
amplitude   = "0.1 um"
indentation = "0.5 um"

[friction]
coefficient = 0.25

[elements]
k0 = "8 N/um"
k1 = "4 N/um"
c1 = "40 N.s/m"
kt = "10 N/um"
)toml";

}  // namespace

int main() {
  const vcrit::Problem problem = vcrit::parse_problem(text, "loop.cpp");
  std::printf("frequency,critical_velocity\n");
  for (double frequency = 1e3; frequency < 2e6; frequency *= 10) {
    const double omega = 2 * std::numbers::pi * frequency;
    std::printf("%.17g,%.17g\n", frequency, vcrit::critical_velocity(problem, omega));
  }
}
