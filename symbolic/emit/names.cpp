#include "emit/names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/errors.hpp"
#include "base/identifiers.hpp"
#include "formula/c_names.hpp"

namespace vcrit::symbolic {

namespace {

// Namespaces that are taken, and what the generated code declares.
constexpr auto cpp_names = std::to_array<std::string_view>(
    {"Certified", "Parameters", "critical_velocity", "critical_velocity_certified", "detail",
     "fast", "posix", "std"});

/// As C names its functions of the types _Float32, _Float64x and the like: sinf32, f64addf128.
bool ends_like_a_type(std::string_view name) {
  for (const std::string_view rest : {"_l", "_r", "x"})
    if (name.ends_with(rest)) name.remove_suffix(rest.size());
  return name.ends_with("f16") || name.ends_with("f32") || name.ends_with("f64") ||
         name.ends_with("f128");
}

bool is_taken_in_cpp(std::string_view name) {
  return std::find(cpp_names.begin(), cpp_names.end(), name) != cpp_names.end() ||
         is_taken_in_c(name) || is_declared_by_c(name) || ends_like_a_type(name);
}

/// The library `pad` has a file pad_batch.hpp; one called `pad_batch` would replace it.
bool ends_like_a_file(std::string_view name) {
  return name.ends_with("_batch") || name.ends_with("_quantities");
}

[[noreturn]] void refuse_name(const Place& place, const std::string& name, const std::string& why) {
  throw InputError(place, fmt::format("\"{}\", which {}", name, why),
                   "another name, of letters, digits and underscores");
}

}  // namespace

void check_library_name(const std::string& name) {
  if (const auto why = unsafe_as_identifier(name)) refuse_name(argument("name"), name, *why);
  if (is_taken_in_cpp(name))
    refuse_name(argument("name"), name, "is taken in C++ or in the generated code");
  if (ends_like_a_file(name))
    refuse_name(argument("name"), name, "ends like a file of another evaluator");
}

void check_member_names(const Problem& problem, const std::vector<Symbol>& symbols) {
  for (const Symbol& symbol : symbols) {
    const std::string name = as_called(problem, symbol).name;
    if (const auto why = unsafe_as_identifier(name))
      refuse_name({problem->source->file}, name, *why);
    if (name == "Parameters")
      refuse_name({problem->source->file}, name,
                  "is the name of the struct that it would be a member of");
  }
}

}  // namespace vcrit::symbolic
