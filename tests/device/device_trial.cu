// Device code of one evaluator beside its host code. Reads rows of parameters; each is asked at many frequencies, by the
// kernels of batches and a kernel of gradients. Host code is what the suite holds against 250 digits. Prints
//   calls, then how often not the same bits: value, bound, fast value, fast bound, partials; then how often outside bounds
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "LIBRARY.cuh"

using Parameters = LIBRARY::Parameters;
constexpr std::size_t members = sizeof(Parameters) / sizeof(double);
// A decade below and above that of the row, which comes first.
constexpr std::size_t frequencies = 512;

static void check(cudaError_t error) {
  if (error == cudaSuccess) return;
  std::fprintf(stderr, "%s\n", cudaGetErrorString(error));
  std::exit(1);
}

class OnDevice {
 public:
  explicit OnDevice(std::size_t n) : size_(n) { check(cudaMalloc(&at_, n * sizeof(double))); }
  ~OnDevice() { cudaFree(at_); }
  OnDevice(const OnDevice&) = delete;
  OnDevice& operator=(const OnDevice&) = delete;
  double* at() { return at_; }
  void set(const std::vector<double>& x) {
    check(cudaMemcpy(at_, x.data(), size_ * sizeof(double), cudaMemcpyHostToDevice));
  }
  std::vector<double> get() {
    std::vector<double> x(size_);
    check(cudaMemcpy(x.data(), at_, size_ * sizeof(double), cudaMemcpyDeviceToHost));
    return x;
  }

 private:
  std::size_t size_;
  double* at_ = nullptr;
};

__global__ void partials(Parameters p, std::size_t n, const double* omega, double* out) {
  const std::size_t stride = std::size_t(gridDim.x) * blockDim.x;
  for (std::size_t i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += stride) {
    p.OMEGA = omega[i];
    const LIBRARY::Gradient gradient = LIBRARY::critical_velocity_gradient(p);
    memcpy(out + i * members, &gradient.partial, members * sizeof(double));
  }
}

static bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Further from the host's value than both bounds allow, that of the value rounded up, and a rounding of each.
static bool outside(double found, double bound, const LIBRARY::Certified& host) {
  if (!std::isfinite(bound) || !std::isfinite(host.relative_error_bound) || same(found, host.value)) return false;
  return !(std::fabs(found / host.value - 1) <= bound + host.relative_error_bound + 0x1p-52);
}

int main() {
  OnDevice omegas(frequencies), out(frequencies), bounds(frequencies), gradients(frequencies * members);
  std::vector<double> omega(frequencies), row(members);
  long calls = 0, value = 0, bound = 0, fast_value = 0, fast_bound = 0, partial = 0, broken = 0;
  char word[64];
  for (std::size_t i = 0; std::scanf("%63s", word) == 1;) {
    row[i] = std::strtod(word, nullptr);
    if (++i < members) continue;
    i = 0;
    Parameters p;
    std::memcpy(&p, row.data(), sizeof p);
    const double first = p.OMEGA;
    for (std::size_t k = 0; k < frequencies; ++k)
      omega[k] = k == 0 ? first : first * std::pow(10.0, 2.0 * double(k) / frequencies - 1);
    omegas.set(omega);
    LIBRARY::critical_velocity_kernel<<<4, 128>>>(p, frequencies, omegas.at(), out.at(), bounds.at());
    check(cudaGetLastError());
    const std::vector<double> found = out.get(), found_bounds = bounds.get();
    LIBRARY::fast::critical_velocity_kernel<<<4, 128>>>(p, frequencies, omegas.at(), out.at(), bounds.at());
    check(cudaGetLastError());
    const std::vector<double> fast = out.get(), fast_bounds = bounds.get();
    partials<<<4, 128>>>(p, frequencies, omegas.at(), gradients.at());
    check(cudaGetLastError());
    const std::vector<double> slopes = gradients.get();
    for (std::size_t k = 0; k < frequencies; ++k) {
      p.OMEGA = omega[k];
      const LIBRARY::Certified host = LIBRARY::critical_velocity_certified(p);
      const LIBRARY::Certified host_fast = LIBRARY::fast::critical_velocity_certified(p);
      const LIBRARY::Gradient gradient = LIBRARY::critical_velocity_gradient(p);
      double expected[members];
      std::memcpy(expected, &gradient.partial, sizeof expected);
      ++calls;
      value += !same(found[k], host.value);
      bound += !same(found_bounds[k], host.relative_error_bound);
      fast_value += !same(fast[k], host_fast.value);
      fast_bound += !same(fast_bounds[k], host_fast.relative_error_bound);
      broken += outside(found[k], found_bounds[k], host) || outside(fast[k], fast_bounds[k], host);
      bool all = true;
      for (std::size_t m = 0; m < members; ++m) all = all && same(slopes[k * members + m], expected[m]);
      partial += !all;
    }
  }
  std::printf("%ld %ld %ld %ld %ld %ld %ld\n", calls, value, bound, fast_value, fast_bound, partial, broken);
}
