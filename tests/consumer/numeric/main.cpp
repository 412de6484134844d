// Calls something of every room of the numeric library that links to another package: units, balls,
// integrators, threads. Prints v* of the scene file, and by simulation, and of a sweep.
#include <cstdio>
#include <string>
#include <vcrit/scene/scene.hpp>
#include <vcrit/vcrit.hpp>

int main(int, char** argv) {
  const vcrit::Scene scene = vcrit::read_scene(argv[1]);
  const double v = vcrit::certified_critical_velocity(scene).value;
  const auto system = vcrit::simulation::system_of(scene);
  const double simulated = vcrit::simulation::sliding_threshold(system).contact_velocity;
  const double above =
      vcrit::simulation::steady_state(vcrit::simulation::Method::rk8pd, system, 1.1 * v)
          .friction_ratio;
  vcrit::Sweep sweep{scene, {}, {vcrit::parse_swept_quantity("critical_velocity", scene)}, {}, {}};
  sweep.axes.push_back(vcrit::parse_axis("mu0=lin:0.3:0.6:2", scene));
  const vcrit::SweptTable table = vcrit::swept(sweep);
  std::printf("%.17g %.17g %.17g\n%s,%s\n", v, simulated, above, table.columns[0].c_str(),
              table.columns[1].c_str());
  for (std::size_t i = 0; i < table.values.size(); i += 2)
    std::printf("%.17g,%.17g\n", table.values[i], table.values[i + 1]);
}
