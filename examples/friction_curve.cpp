// Problem         Friction of an elastic contact with a rigid drive, over the speed in units of
//                 v*. scenes/elastic.toml: D = du_z/u_z0 = 1/3.
// Exact solution  mu_macro/mu0 = 1 - D G(v0/v*), where G(x) = [sin t2 - sin t1 - (t2 - t1) cos t1
//                 - x (t2 - t1)^2/2]/(2 pi), t1 = pi + asin x, and t2 the first later root of
//                 x (t2 - t1) = cos t2 - cos t1. From v0 = v* on it is 1.
// Method          The steady stick-slip motion, event by event in closed form. The simulation does
//                 not know v*: it is asked for the lowest speed of continuous sliding.
//
//     friction_curve scenes/elastic.toml
#include <cstdio>
#include <vcrit/vcrit.hpp>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: friction_curve SCENE\n"), 2;
  namespace simulation = vcrit::simulation;
  const simulation::System system = simulation::system_of(vcrit::read_problem(argv[1]));
  const double onset = simulation::sliding_threshold(system).drive_velocity;

  const std::vector<double> ratios{0.001, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 1.01};
  std::vector<double> velocities;
  for (const double ratio : ratios) velocities.push_back(ratio * onset);
  const auto curve = simulation::friction_curve(system, velocities);

  std::printf("velocity_ratio,friction_ratio,regime\n");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!curve[i].state) return std::fprintf(stderr, "%s\n", curve[i].reason.c_str()), 3;
    std::printf("%g,%.17g,%s\n", ratios[i], curve[i].state->friction_ratio,
                to_text(curve[i].state->regime));
  }
}
