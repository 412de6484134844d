// Programs that call the evaluators of one language: they read lines "SCENE x x ..." with all
// numbers of Parameters, and answer one line each,
//   value bound fast_value fast_bound  critical_velocity fast_critical_velocity batch fast_batch
// and, where they are asked for,
//   gradient.value  partials  fast gradient.value  fast partials.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "emit/asked.hpp"
#include "emit/parameters.hpp"

namespace vcrit::test {

inline std::string library(std::size_t i) { return "scene_" + std::to_string(i); }

inline const std::string c_reading = R"(
static double x[64];
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
)";

/// GRADIENTS(NAME) by the names of the type and of the function in both grades.
inline std::string gradients_of_c(Asked asked, const std::string& type, const std::string& accurate,
                                  const std::string& fast, const std::string& argument) {
  if (asked == Asked::values) return "#define GRADIENTS(NAME)\n";
  std::string out = "#define GRADIENTS(NAME)";
  for (const std::string& function : {accurate, fast})
    out += fmt::format(
        " {{ const {} g = {}({}); print(&g.value, 1); memcpy(x, &g.partial, sizeof p); "
        "print(x, sizeof p / sizeof(double)); }}",
        type, function, argument);
  return out + "\n";
}

inline std::string main_of_c(std::size_t scenes) {
  std::string out =
      "int main(void) {\n  unsigned scene = 0;\n  while (scanf(\"%u\", &scene) == 1) {\n";
  for (std::size_t i = 0; i < scenes; ++i)
    out += fmt::format("    if (scene == {}) CALL({})\n", i, library(i));
  return out + "    printf(\"\\n\");\n  }\n  return 0;\n}\n";
}

inline std::string c99_driver(std::size_t scenes, Asked asked) {
  std::string out = "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n";
  for (std::size_t i = 0; i < scenes; ++i) out += "#include \"" + library(i) + ".h\"\n";
  return out + c_reading +
         gradients_of_c(asked, "NAME##_Gradient", "NAME##_critical_velocity_gradient",
                        "NAME##_fast_critical_velocity_gradient", "&p") +
         R"(
#define CALL(NAME) { \
  NAME##_Parameters p; \
  numbers(sizeof p / sizeof(double)); \
  memcpy(&p, x, sizeof p); \
  const NAME##_Certified a = NAME##_critical_velocity_certified(&p); \
  const NAME##_Certified f = NAME##_fast_critical_velocity_certified(&p); \
  double batch[2]; \
  NAME##_critical_velocity_batch(&p, 1, &p.omega, batch); \
  NAME##_fast_critical_velocity_batch(&p, 1, &p.omega, batch + 1); \
  const double all[] = {a.value, a.relative_error_bound, f.value, f.relative_error_bound, \
    NAME##_critical_velocity(&p), NAME##_fast_critical_velocity(&p), batch[0], batch[1]}; \
  print(all, sizeof all / sizeof all[0]); \
  GRADIENTS(NAME) \
}
)" + main_of_c(scenes);
}

/// With nvcc and a device, batches go through the kernels.
inline std::string cuda_driver(std::size_t scenes, Asked asked) {
  std::string out = "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n";
  for (std::size_t i = 0; i < scenes; ++i) out += "#include \"" + library(i) + ".cuh\"\n";
  return out + c_reading +
         gradients_of_c(asked, "NAME::Gradient", "NAME::critical_velocity_gradient",
                        "NAME::fast::critical_velocity_gradient", "p") +
         R"(
#ifdef __CUDACC__
#define BATCH(NAME) { \
  int devices = 0; \
  double *memory = nullptr; \
  if (cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0 && \
      cudaMallocManaged(&memory, 5 * sizeof(double)) == cudaSuccess) { \
    memory[0] = p.omega; \
    NAME::critical_velocity_kernel<<<1, 32>>>(p, 1, memory, memory + 1, memory + 2); \
    NAME::fast::critical_velocity_kernel<<<1, 32>>>(p, 1, memory, memory + 3, nullptr); \
    if (cudaDeviceSynchronize() != cudaSuccess) exit(1); \
    batch[0] = memory[1], batch[1] = memory[3]; \
    cudaFree(memory); \
  } \
}
#else
#define BATCH(NAME)
#endif
#define CALL(NAME) { \
  NAME::Parameters p; \
  numbers(sizeof p / sizeof(double)); \
  memcpy(&p, x, sizeof p); \
  const NAME::Certified a = NAME::critical_velocity_certified(p); \
  const NAME::Certified f = NAME::fast::critical_velocity_certified(p); \
  double batch[2]; \
  NAME::critical_velocity(p, 1, &p.omega, batch); \
  NAME::fast::critical_velocity(p, 1, &p.omega, batch + 1); \
  BATCH(NAME) \
  const double all[] = {a.value, a.relative_error_bound, f.value, f.relative_error_bound, \
    NAME::critical_velocity(p), NAME::fast::critical_velocity(p), batch[0], batch[1]}; \
  print(all, sizeof all / sizeof all[0]); \
  GRADIENTS(NAME) \
}
)" + main_of_c(scenes);
}

/// [["mu0", 0], ["k", 10]], as Python and JavaScript read it.
inline std::string layout(const Scene& scene) {
  const symbolic::ParameterList parameters(scene, symbolic::derive(scene));
  std::vector<std::string> members;
  for (const symbolic::Member& member : parameters.members())
    members.push_back(fmt::format("[\"{}\", {}]", member.name, member.length));
  return fmt::format("[{}]", fmt::join(members, ", "));
}

inline std::string layouts(const std::vector<Scene>& scenes) {
  std::vector<std::string> all;
  for (const Scene& scene : scenes) all.push_back(layout(scene));
  return fmt::format("[{}]", fmt::join(all, ",\n  "));
}

inline std::string python_driver(const std::vector<Scene>& scenes, Asked asked) {
  return "import sys\nfrom importlib import import_module\n\nimport numpy as np\n\nLAYOUTS = " +
         layouts(scenes) + (asked == Asked::values ? "\nGRADIENTS = False" : "\nGRADIENTS = True") +
         R"(


def parameters(module, layout, x):
    members, at = {}, 0
    for name, length in layout:
        members[name] = x[at : at + length] if length else x[at]
        at += length or 1
    return module.Parameters(**members)


def flat(layout, p):
    return [x for name, n in layout for x in (getattr(p, name) if n else [getattr(p, name)])]


def answers(scene, rows):
    """All rows at once, and batches one by one."""
    module, layout = import_module(f"scene_{scene}"), LAYOUTS[scene]
    p = parameters(module, layout, np.array(rows).T)
    batches = [[], []]
    for row in rows:
        one = parameters(module, layout, row)
        batches[0].append(module.critical_velocity(one, omega=[one.omega])[0])
        batches[1].append(module.fast_critical_velocity(one, omega=[one.omega])[0])
    columns = [*module.critical_velocity_certified(p), *module.fast_critical_velocity_certified(p)]
    columns += [module.critical_velocity(p), module.fast_critical_velocity(p), *batches]
    if GRADIENTS:
        for g in module.critical_velocity_gradient(p), module.fast_critical_velocity_gradient(p):
            columns += [g.value, *flat(layout, g.partial)]
    return np.array(columns).T


lines = [line.split() for line in sys.stdin]
found = [None] * len(lines)
for scene in range(len(LAYOUTS)):
    places = [i for i, line in enumerate(lines) if int(line[0]) == scene]
    rows = [[float(x) for x in lines[i][1:]] for i in places]
    if rows:
        for i, row in zip(places, answers(scene, rows)):
            found[i] = row
for row in found:
    print(*map(float, row))
)";
}

inline std::string javascript_driver(const std::vector<Scene>& scenes, Asked asked) {
  return "import { readFileSync } from \"node:fs\";\nconst layouts = " + layouts(scenes) +
         ";\nconst grades = " + (asked == Asked::values ? "[]" : R"(["", "fast_"])") + R"(;
const modules = await Promise.all(layouts.map((_, i) => import(`./scene_${i}.mjs`)));
const parameters = (layout, x) => {
  const p = {};
  let at = 0;
  for (const [name, length] of layout) {
    p[name] = length ? x.slice(at, at + length) : x[at];
    at += length || 1;
  }
  return p;
};
for (const line of readFileSync(0, "utf8").trim().split("\n")) {
  const [scene, ...x] = line.split(" ").map(Number);
  const m = modules[scene], layout = layouts[scene], p = parameters(layout, x);
  const a = m.critical_velocity_certified(p), f = m.fast_critical_velocity_certified(p);
  const gradients = grades.flatMap((grade) => {
    const g = m[`${grade}critical_velocity_gradient`](p);
    return [g.value, ...layout.flatMap(([name]) => g.partial[name])];
  });
  console.log(a.value, a.relative_error_bound, f.value, f.relative_error_bound, m.critical_velocity(p),
    m.fast_critical_velocity(p), m.critical_velocity_batch(p, [p.omega])[0],
    m.fast_critical_velocity_batch(p, [p.omega])[0], ...gradients);
}
)";
}

}  // namespace vcrit::test
