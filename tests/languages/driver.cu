// As driver.c. With nvcc and a device, batches go through the kernels.
#include <cstdio>
#include <cstdlib>
#include <cstring>
//: each
#include "LIBRARY.cuh"
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
#define GRADIENT(TYPE, CALL)              \
  {                                       \
    const TYPE g = CALL;                  \
    print(&g.value, 1);                   \
    std::memcpy(x, &g.partial, sizeof p); \
    print(x, sizeof p / sizeof(double));  \
  }
#else
#define GRADIENT(TYPE, CALL)
#endif
#ifdef __CUDACC__
#define BATCH(NAME, FREQUENCY) { \
  int devices = 0; \
  double *memory = nullptr; \
  if (cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0 && \
      cudaMallocManaged(&memory, 5 * sizeof(double)) == cudaSuccess) { \
    memory[0] = p.FREQUENCY; \
    NAME::critical_velocity_kernel<<<1, 32>>>(p, 1, memory, memory + 1, memory + 2); \
    NAME::fast::critical_velocity_kernel<<<1, 32>>>(p, 1, memory, memory + 3, nullptr); \
    if (cudaDeviceSynchronize() != cudaSuccess) std::exit(1); \
    batch[0] = memory[1], batch[1] = memory[3]; \
    cudaFree(memory); \
  } \
}
#else
#define BATCH(NAME, FREQUENCY)
#endif
#define CALL(NAME, FREQUENCY) { \
  NAME::Parameters p; \
  numbers(sizeof p / sizeof(double)); \
  std::memcpy(&p, x, sizeof p); \
  const NAME::Certified a = NAME::critical_velocity_certified(p); \
  const NAME::Certified f = NAME::fast::critical_velocity_certified(p); \
  double batch[2]; \
  NAME::critical_velocity(p, 1, &p.FREQUENCY, batch); \
  NAME::fast::critical_velocity(p, 1, &p.FREQUENCY, batch + 1); \
  BATCH(NAME, FREQUENCY) \
  const double all[] = {a.value, a.relative_error_bound, f.value, f.relative_error_bound, \
    NAME::critical_velocity(p), NAME::fast::critical_velocity(p), batch[0], batch[1]}; \
  print(all, sizeof all / sizeof all[0]); \
  GRADIENT(NAME::Gradient, NAME::critical_velocity_gradient(p)) \
  GRADIENT(NAME::Gradient, NAME::fast::critical_velocity_gradient(p)) \
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
