/* Reads lines "NUMBER x x ...", a library and all numbers of its Parameters, and answers one line each,
     value bound fast_value fast_bound critical_velocity fast_critical_velocity batch fast_batch
   and with gradients
     gradient.value partials fast_gradient.value partials. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
//: each
#include "LIBRARY.h"
//: end

static double x[256];
static void numbers(size_t n) {
  char word[64];
  for (size_t i = 0; i < n; ++i) {
    if (scanf("%63s", word) != 1) exit(1);
    x[i] = strtod(word, NULL);
  }
}
static void print(const double *y, size_t n) {
  for (size_t i = 0; i < n; ++i) printf("%a ", y[i]);
}

#if WITH_GRADIENTS
#define GRADIENT(TYPE, CALL) { \
  const TYPE g = CALL; \
  print(&g.value, 1); \
  memcpy(x, &g.partial, sizeof p); \
  print(x, sizeof p / sizeof(double)); \
}
#else
#define GRADIENT(TYPE, CALL)
#endif
#define CALL(NAME, FREQUENCY) { \
  NAME##_Parameters p; \
  numbers(sizeof p / sizeof(double)); \
  memcpy(&p, x, sizeof p); \
  const NAME##_Certified a = NAME##_critical_velocity_certified(&p); \
  const NAME##_Certified f = NAME##_fast_critical_velocity_certified(&p); \
  double batch[2]; \
  NAME##_critical_velocity_batch(&p, 1, &p.FREQUENCY, batch); \
  NAME##_fast_critical_velocity_batch(&p, 1, &p.FREQUENCY, batch + 1); \
  const double all[] = {a.value, a.relative_error_bound, f.value, f.relative_error_bound, \
    NAME##_critical_velocity(&p), NAME##_fast_critical_velocity(&p), batch[0], batch[1]}; \
  print(all, sizeof all / sizeof all[0]); \
  GRADIENT(NAME##_Gradient, NAME##_critical_velocity_gradient(&p)) \
  GRADIENT(NAME##_Gradient, NAME##_fast_critical_velocity_gradient(&p)) \
}

int main(void) {
  unsigned library = 0;
  while (scanf("%u", &library) == 1) {
//: each
    if (library == NUMBER) CALL(LIBRARY, OMEGA)
//: end
    printf("\n");
  }
  return 0;
}
