#include "critical/kernels.hpp"

namespace vcrit::kernels {

namespace baseline {
extern const Kernels table;
}

#if defined(__x86_64__)

namespace x86_64_v3 {
extern const Kernels table;
}
namespace x86_64_v4 {
extern const Kernels table;
}

namespace {

std::size_t runnable() {
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return 1;
  const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                  __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd");
  return v4 ? 3 : 2;
}

}  // namespace

std::span<const Kernels* const> all_kernels() {
  static constexpr const Kernels* levels[]{&baseline::table, &x86_64_v3::table, &x86_64_v4::table};
  static const std::size_t count = runnable();
  return {levels, count};
}

#else

std::span<const Kernels* const> all_kernels() {
  static constexpr const Kernels* levels[]{&baseline::table};
  return levels;
}

#endif

const Kernels& kernels() { return *all_kernels().back(); }

}  // namespace vcrit::kernels
