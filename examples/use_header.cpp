// Problem         v* of the slider in scenes/elastic_drive.toml, with other numbers at each call,
//                 in a program that knows nothing of vcrit but the header that generate.cpp has
//                 written.
// Exact solution  Eq. (30). At kn = 12, kt = 10, kd = 2, m omega^2 = 4 (N/um), and
//                 mu0 omega du_z = 1 mm/s: 1.2 |10 + 2 - 4|/|2 - 4| = 4.8 mm/s. Its relative
//                 derivative by kn is 1.
// Method          The generated accurate grade with its bound, and the generated gradient.
//
//     use_header
#include <cstdio>

#include "slider.hpp"

int main() {
  const slider::Parameters p{
      .mu0 = 0.25, .omega = 4e4, .du_z = 1e-7, .m = 2.5e-3, .kn = 12e6, .kt = 10e6, .kd = 2e6};
  const slider::Certified v = slider::critical_velocity_certified(p);
  const slider::Gradient gradient = slider::critical_velocity_gradient(p);
  std::printf("critical velocity %.17g m/s, relative error below %.2g\n", v.value,
              v.relative_error_bound);
  std::printf("relative derivative by kn %.17g\n", gradient.partial.kn * p.kn / gradient.value);
}
