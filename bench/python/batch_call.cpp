// The C++ batch call as a C++ program makes it, to be timed beside the Python module in one process
// and on the same arrays (benchmark.py).
#include "answers/critical_onsets.hpp"

#include <cstddef>
#include <memory>

using vcrit::CriticalOnsets;

// Frequency and k... by their names in the scene; the formula is never freed: there are few.
extern "C" void* vcrit_formula(const char* problem, const char* const* names, std::size_t count) {
  return new CriticalOnsets(vcrit::read_problem(problem),
                            std::vector<std::string>(names, names + count));
}

extern "C" void vcrit_evaluate(const void* formula, const double* const* columns, std::size_t count,
                               double* out, std::size_t size) {
  std::vector<std::span<const double>> values;
  for (std::size_t i = 0; i < count; ++i) values.emplace_back(columns[i], size);
  (*static_cast<const CriticalOnsets*>(formula))(values, {out, size});
}

// The same into memory of its own, as a call for a new array does.
extern "C" void vcrit_evaluate_new(const void* formula, const double* const* columns,
                                   std::size_t count, std::size_t size) {
  const auto out = std::make_unique_for_overwrite<double[]>(size);
  vcrit_evaluate(formula, columns, count, out.get(), size);
}
