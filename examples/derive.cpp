// Problem         The critical velocity of an elastic contact as a formula, to be set by LaTeX, and
//                 its limits. scenes/elastic_drive.toml: springs kn, kt, a drive kd and a mass m.
// Exact solution  Eq. (30): v* = mu0 omega du_z kn/kt |kt + kd - m omega^2|/|kd - m omega^2|;
//                 with a rigid drive, Eq. (31): mu0 omega du_z kn/kt.
// Method          The harmonic balance of body and contact point, solved by computer algebra.
//
//     derive scenes/elastic_drive.toml
#include <cstdio>
#include <vcrit/symbolic.hpp>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: derive SCENE\n"), 2;
  namespace symbolic = vcrit::symbolic;
  const vcrit::Problem problem = vcrit::read_problem(argv[1]);
  const symbolic::Derivation derivation = symbolic::derive(problem);
  std::printf("%s v* = %s\n", derivation.equation.c_str(),
              symbolic::to_latex(derivation.critical_velocity).c_str());
  for (const symbolic::Limit& limit : symbolic::limits(derivation))
    if (!limit.equation.empty())
      std::printf("%s %s: v* = %s\n", limit.equation.c_str(), limit.name.c_str(),
                  symbolic::to_latex(limit.result).c_str());
}
