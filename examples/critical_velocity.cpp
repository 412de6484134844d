// Problem         An elastic contact has a rigid drive: up to which speed does the oscillation
//                 reduce friction? scenes/elastic.toml: kn = 11.5 N/um, kt = 9.47 N/um, 20 kHz,
//                 0.1 um, mu0 = 0.3.
// Exact solution  Eq. (31): v* = mu0 omega du_z kn/kt = 4.578034... mm/s
// Method          Eq. (24) in ball arithmetic of growing precision until one double is left, and
//                 the conditions under which it holds.
//
//     critical_velocity scenes/elastic.toml
#include <cstdio>
#include <exception>
#include <vcrit/vcrit.hpp>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: critical_velocity SCENE\n"), 2;
  try {
    const vcrit::Problem problem = vcrit::read_problem(argv[1]);
    const vcrit::CertifiedVelocity v = vcrit::certified_critical_velocity(problem);
    std::printf("critical velocity %.17g m/s\n", v.value);
    std::printf("relative error at most %.2g\n", v.relative_error_bound);
    for (const std::string& reason : vcrit::inadmissible_reasons(problem))
      std::printf("not admissible: %s\n", reason.c_str());
  } catch (const vcrit::InputError& error) {  // says file, line, what was found and expected
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const vcrit::ModelError& error) {  // a scene that the model does not cover
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
