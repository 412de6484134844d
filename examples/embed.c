/* Problem         The same as use_header.cpp in C99, as for a controller: v* over four frequencies.
 *
 * Exact solution  Eq. (30). At kn = 12, kt = 10, kd = 2 (N/um), m = 2.5 g, mu0 = 0.25 and
 *                 du_z = 0.1 um: v* = 2.5e-8 omega 1.2 |12 - x|/|2 - x| m/s with
 *                 x = 2.5e-9 omega^2.
 *
 * Method          slider.h, which generate.cpp has written.
 *
 *     embed
 */
#include <stdio.h>

#include "slider.h"

int main(void) {
  slider_Parameters p = {
      .mu0 = 0.25, .omega = 0, .du_z = 1e-7, .m = 2.5e-3, .kn = 12e6, .kt = 10e6, .kd = 2e6};
  for (int i = 1; i <= 4; ++i) {
    p.omega = 2e4 * i;
    printf("%g,%.17g\n", p.omega, slider_critical_velocity(&p));
  }
  return 0;
}
