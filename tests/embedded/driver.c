/* Evaluators under test, as C99 or as C++: reads rows of doubles, the number of a scene and its
   parameters, and answers each with six: value and bound of both grades, and a batch of one in both
   grades. No more of a C library is needed than that of mathematics, read and write. */
#include <string.h>
#include <unistd.h>
#include "scenes.h" /* written by the trial: the headers, and SCENES(CASE) */

enum { answers = 6, largest = 64 };
static double x[largest], y[answers];

#ifdef __cplusplus
#define CASE(NUMBER, NAME)                                                                        \
  case NUMBER: {                                                                                  \
    NAME::Parameters p;                                                                           \
    if (!numbers(sizeof p)) return 2;                                                             \
    memcpy(&p, x, sizeof p);                                                                      \
    const auto a = NAME::critical_velocity_certified(p);                                          \
    const auto f = NAME::fast::critical_velocity_certified(p);                                    \
    y[0] = a.value, y[1] = a.relative_error_bound, y[2] = f.value, y[3] = f.relative_error_bound; \
    NAME::critical_velocity(p, {&p.omega, 1}, {y + 4, 1});                                        \
    NAME::fast::critical_velocity(p, {&p.omega, 1}, {y + 5, 1});                                  \
    break;                                                                                        \
  }
#else
#define CASE(NUMBER, NAME)                                                                        \
  case NUMBER: {                                                                                  \
    NAME##_Parameters p;                                                                          \
    if (!numbers(sizeof p)) return 2;                                                             \
    memcpy(&p, x, sizeof p);                                                                      \
    const NAME##_Certified a = NAME##_critical_velocity_certified(&p);                            \
    const NAME##_Certified f = NAME##_fast_critical_velocity_certified(&p);                       \
    y[0] = a.value, y[1] = a.relative_error_bound, y[2] = f.value, y[3] = f.relative_error_bound; \
    NAME##_critical_velocity_batch(&p, 1, &p.omega, y + 4);                                       \
    NAME##_fast_critical_velocity_batch(&p, 1, &p.omega, y + 5);                                  \
    break;                                                                                        \
  }
#endif

static int numbers(size_t size) { return size <= sizeof x && read(0, x, size) == (ssize_t)size; }

static int answer(void) {
  switch ((int)x[0]) {
    SCENES(CASE)
    default:
      return 2;
  }
  return write(1, y, sizeof y) == (ssize_t)sizeof y ? 0 : 3;
}

int main(void) {
  while (numbers(sizeof x[0])) {
    const int failed = answer();
    if (failed) return failed;
  }
  return 0;
}
