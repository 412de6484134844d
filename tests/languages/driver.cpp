// As driver.c.
#include <cstdio>
#include <cstdlib>
#include <cstring>
//: each
#include "LIBRARY.hpp"
//: end

static double x[256];
static void numbers(std::size_t n) {
  char word[64];
  for (std::size_t i = 0; i < n; ++i) {
    if (std::scanf("%63s", word) != 1) std::exit(1);
    x[i] = std::strtod(word, nullptr);
  }
}
static void print(const double* y, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) std::printf("%a ", y[i]);
}

#if WITH_GRADIENTS
#define GRADIENT(CALL)                    \
  {                                       \
    const auto g = CALL;                  \
    print(&g.value, 1);                   \
    std::memcpy(x, &g.partial, sizeof p); \
    print(x, sizeof p / sizeof(double));  \
  }
#else
#define GRADIENT(CALL)
#endif
#define CALL(NAME, FREQUENCY)                                             \
  {                                                                       \
    NAME::Parameters p;                                                   \
    numbers(sizeof p / sizeof(double));                                   \
    std::memcpy(&p, x, sizeof p);                                         \
    const NAME::Certified a = NAME::critical_velocity_certified(p);       \
    const NAME::Certified f = NAME::fast::critical_velocity_certified(p); \
    double batch[2];                                                      \
    NAME::critical_velocity(p, {&p.FREQUENCY, 1}, {batch, 1});            \
    NAME::fast::critical_velocity(p, {&p.FREQUENCY, 1}, {batch + 1, 1});  \
    const double all[] = {a.value,                                        \
                          a.relative_error_bound,                         \
                          f.value,                                        \
                          f.relative_error_bound,                         \
                          NAME::critical_velocity(p),                     \
                          NAME::fast::critical_velocity(p),               \
                          batch[0],                                       \
                          batch[1]};                                      \
    print(all, sizeof all / sizeof all[0]);                               \
    GRADIENT(NAME::critical_velocity_gradient(p))                         \
    GRADIENT(NAME::fast::critical_velocity_gradient(p))                   \
  }

int main() {
  unsigned library = 0;
  while (std::scanf("%u", &library) == 1) {
    //: each
    if (library == NUMBER) CALL(LIBRARY, OMEGA)
    //: end
    std::printf("\n");
  }
}
