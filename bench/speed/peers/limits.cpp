// What the machine needs for a division, a square root, and one of each, vectorised. Compiled at
// run time.
#include <cmath>
#include <cstddef>

extern "C" void division(const double* const* x, std::size_t n, double* __restrict out, double*) {
  const double* __restrict const a = x[0];
  const double* __restrict const b = x[1];
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) out[i] = a[i] / b[i];
}

extern "C" void root(const double* const* x, std::size_t n, double* __restrict out, double*) {
  const double* __restrict const a = x[0];
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) out[i] = std::sqrt(a[i]);
}

extern "C" void both(const double* const* x, std::size_t n, double* __restrict out, double*) {
  const double* __restrict const a = x[0];
  const double* __restrict const b = x[1];
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) out[i] = std::sqrt(a[i] / b[i]);
}
