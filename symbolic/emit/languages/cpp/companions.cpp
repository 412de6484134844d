// What accompanies a generated header: a test program and what CMake builds both by.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "base/joined.hpp"
#include "base/numbers.hpp"
#include "critical/certified.hpp"
#include "emit/generate.hpp"
#include "emit/languages/cpp/cpp_files.hpp"
#include "emit/languages/cpp/dialect.hpp"
#include "emit/names.hpp"
#include "emit/parameters.hpp"
#include "emit/pieces.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic {

namespace {

bool has_force(NumberRole role) {
  return role == NumberRole::stiffness || role == NumberRole::damping || role == NumberRole::mass;
}

bool has_all_values(const Problem& problem) {
  for (const auto& [symbol, value] : elements_with_values(problem))
    if (!value) return false;
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic != nullptr && !isotropic->quantity.value) return false;
  return problem->coefficient.value && problem->angular_frequency.value &&
         problem->amplitude.value && (!problem->mass || problem->mass->value) &&
         (!problem->mount_mass || problem->mount_mass->value);
}

/// A frequency that the table of a measured drive has, where the scene's is none.
std::optional<double> inside_table(const Problem& problem) {
  if (problem->receptance() == nullptr) return std::nullopt;
  const double first = problem->receptance()->rows.front().omega,
               last = problem->receptance()->rows.back().omega,
               own = problem->angular_frequency.value.value_or(0);
  return own >= first && own <= last ? std::nullopt : std::optional(0.5 * (first + last));
}

/// The scene's values, and values of the size of real devices for symbols without one.
std::map<Symbol, double> example_values(const Problem& problem) {
  std::map<Symbol, double> values;
  const auto put = [&values](const Quantity& quantity, double otherwise) {
    values[quantity.symbol] = quantity.value.value_or(otherwise);
  };
  put(problem->coefficient, 0.25);
  put(problem->angular_frequency, 125000.0);
  put(problem->amplitude, 1e-7);
  if (const auto within = inside_table(problem))
    values[problem->angular_frequency.symbol] = *within;
  if (problem->mass) put(*problem->mass, 0.00025);
  if (problem->mount_mass) put(*problem->mount_mass, 0.00025);
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic != nullptr) put(isotropic->quantity, 0.25);
  int count = 0;
  const auto add = [&](const Symbol& symbol, double otherwise) {
    values.try_emplace(symbol, otherwise * (1 + count++ / 8.0));
  };
  for (const auto& [symbol, value] : elements_with_values(problem))
    if (value) values[symbol] = *value;
  const auto element = [&](const Element& e) {
    for_each_number(
        e, [&](const Symbol& symbol, NumberRole role) { add(symbol, number_row(role).example); });
  };
  for_each_element(problem, element);
  return values;
}

std::string example(const Problem& problem, const ParameterList& parameters) {
  const std::map<Symbol, double> values = example_values(problem);
  std::string out = "  Parameters p{};\n";
  for (const Member& member : parameters.members())
    for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry) {
      const Symbol symbol{member.symbol, entry};
      const auto value = values.find(symbol);
      // An entry of value 0 stands in no network.
      if (value == values.end()) continue;
      out += fmt::format("  {} = {};\n", parameters.reference(symbol), literal(value->second));
    }
  return out;
}

/// The symbols of the mass and of all stiffnesses, dampers and masses: an expression of the first
/// power of a force is of the first degree in them.
std::vector<Symbol> scaled_symbols(const Problem& problem) {
  std::vector<Symbol> symbols;
  if (problem->mass) symbols.push_back(problem->mass->symbol);
  if (problem->mount_mass &&
      (!problem->mass || problem->mass->symbol != problem->mount_mass->symbol))
    symbols.push_back(problem->mount_mass->symbol);
  const auto element = [&](const Element& e) {
    for_each_number(e, [&](const Symbol& symbol, NumberRole role) {
      if (has_force(role)) symbols.push_back(symbol);
    });
  };
  for_each_element(problem, element);
  return symbols;
}

bool has_table(const Evaluator& evaluator) { return evaluator.has(Node::Operation::place); }

/// Whether no call can scale all elements: one of them is a number of the code, or the drive a
/// table.
bool keeps_some_elements(const Evaluator& evaluator) {
  const std::vector<Symbol> symbols = scaled_symbols(evaluator.derivation.problem);
  return has_table(evaluator) ||
         std::any_of(symbols.begin(), symbols.end(),
                     [&](const Symbol& symbol) { return evaluator.fixed.contains(symbol); });
}

/// Those of them that are parameters, as "p.k0", each once.
std::vector<std::string> element_members(const Problem& problem, const ParameterList& parameters) {
  std::vector<std::string> members;
  for (const Symbol& symbol : scaled_symbols(problem)) {
    if (!parameters.contains(symbol)) continue;
    const std::string member = parameters.reference(symbol);
    if (std::find(members.begin(), members.end(), member) == members.end())
      members.push_back(member);
  }
  return members;
}

/// Multiplies them by 2. Nothing where one of them is a number of the code.
std::string doubled(const Evaluator& evaluator) {
  if (keeps_some_elements(evaluator)) return "";
  const Problem& problem = evaluator.derivation.problem;
  std::string out = fmt::format(
      "  // A power of two changes no rounding, and a common factor of all stiffnesses, dampers{}\n"
      "  // does not change v*.\n"
      "  Parameters doubled = p;\n",
      problem->has_masses()                  ? " and masses"
      : problem->mass || problem->mount_mass ? " and the mass"
                                             : "");
  for (const std::string& member : element_members(problem, evaluator.parameters))
    out += "  doubled" + member.substr(1) + " *= 2.0;\n";
  return out +
         "  expect(critical_velocity(doubled) == v.value, \"a common factor of all elements "
         "cancels\");\n"
         "  expect(fast::critical_velocity(doubled) == f.value, \"fast: a common factor "
         "cancels\");\n";
}

/// Each times its partial derivative; nothing where one of them is a number of the code.
std::string euler(const Evaluator& evaluator) {
  if (keeps_some_elements(evaluator)) return "0.0";
  std::vector<std::string> terms{"0.0"};
  for (const std::string& member :
       element_members(evaluator.derivation.problem, evaluator.parameters))
    terms.push_back(member + " * d" + member.substr(1));
  return joined(terms, ", ");
}

/// A fast sweep gives the bits of single calls, or takes polynomials in omega: T, Q, D and N
/// then err by 5 roundings a term, 11 terms, times 2^5 for cancellation, 3500 in all, where the
/// bound of the single call counts 9 or more for the network.
std::string fast_sweep(const Evaluator& evaluator) {
  if (!evaluator.sweep)
    return "    expect(fast_out[i] == fast_one.value, \"fast sweep equals scalar\");";
  return "    // Polynomials in omega: a few digits less.\n"
         "    expect(near(fast_out[i], fast_one.value, 400.0 * fast_one.relative_error_bound), "
         "\"fast sweep\");";
}

// v* correctly rounded errs by at most 2^-53, the function by its own bound.
std::string known_value(const Problem& problem) {
  if (!has_all_values(problem) || inside_table(problem)) return "";
  const CertifiedVelocity v = certified_critical_velocity(problem);
  if (!v.reason.empty()) return "";
  return fmt::format(
      "  const double known = {};\n"
      "  expect(near(v.value, known, v.relative_error_bound + 0x1p-52), \"value of the scene\");\n"
      "  expect(near(f.value, known, f.relative_error_bound + 0x1p-52), \"fast value\");\n",
      literal(v.value));
}

// In the namespace of the library, so that names of the latter hide a library that is called like
// one of them.
const char* const frame =
    R"(// Generated by vcrit, do not edit: checks what Eq. 24 implies for the functions of {name}.hpp.
{include}
#include <cmath>
#include <cstdio>

namespace {name} {{
namespace {{

int failures = 0;

void expect(bool holds, const char* what) {{
  if (holds) return;
  std::fprintf(stderr, "failed: %s\n", what);
  ++failures;
}}

// Tolerances are the functions' own bounds, where these are finite.
bool near(double a, double b, double tolerance) {{
  return !std::isfinite(tolerance) || std::abs(a - b) <= tolerance * std::abs(b);
}}

void check() {{
{example}
  const Certified v = critical_velocity_certified(p), f = fast::critical_velocity_certified(p);
  expect(v.value == critical_velocity(p), "certified value is the value");
  expect(f.value == fast::critical_velocity(p), "certified fast value is the fast value");
  expect(near(f.value, v.value, f.relative_error_bound + 2.0 * v.relative_error_bound), "both grades agree");
{known}
  // Powers of two change no rounding of numbers that are not subnormal: v* is linear in {mu0} and {du_z}.
  const bool ordinary = v.value == 0 || v.value >= 0x1p-1000;
  Parameters other = p;
  other.{mu0} = 2.0 * p.{mu0};
  expect(!ordinary || critical_velocity(other) == 2.0 * v.value, "linear in {mu0}");
  other = p;
  other.{du_z} = 0.5 * p.{du_z};
  expect(!ordinary || critical_velocity(other) == 0.5 * v.value, "linear in {du_z}");
{doubled}
  // v* does not change with a common factor of all elements: Euler's identity for their partial derivatives. Each
  // is known as well as the parts of the size of v* that it is the difference of, in plain double or in twice its digits.
  const Gradient g = critical_velocity_gradient(p), fast_g = fast::critical_velocity_gradient(p);
  expect(g.value == v.value && fast_g.value == f.value, "value beside the gradient");
  const bool smooth = ordinary && std::isnormal(v.value);  // v* has no derivatives where it is 0 or infinite
  expect(!smooth || std::abs(g.partial.{mu0} * p.{mu0} - v.value) <= 0x1p-51 * v.value, "d v/d {mu0} = v/{mu0}");
  const auto identity = [&]([[maybe_unused]] const Parameters& d, double parts) {{
    const double terms[] = {{{euler}}};
    double sum = 0, size = parts;
    for (const double term : terms) sum += term, size += std::abs(term);
    return !smooth || std::abs(sum) <= 1e-12 * size;
  }};
  expect(identity(g.partial, 0x1p-53 * v.value), "partial derivatives by the elements");
  expect(!(f.relative_error_bound < 1e-13) || identity(fast_g.partial, v.value), "the same in plain double");

  constexpr std::size_t size = 75;
  double omega[size], columns[size], fast_columns[size], out[size], fast_out[size], bounds[size];
  for (std::size_t i = 0; i < size; ++i)
    omega[i] = columns[i] = fast_columns[i] = {omegas};
  critical_velocity(p, omega, out);
  fast::critical_velocity(p, omega, fast_out);
  critical_velocity(p, Columns{{.{omega} = columns}}, columns, std::span<double>(bounds));
  fast::critical_velocity<Varying{{.{omega} = true}}>(p, {{.{omega} = fast_columns}}, fast_columns);
  for (std::size_t i = 0; i < size; ++i) {{
    Parameters at = p;
    at.{omega} = omega[i];
    const Certified one = critical_velocity_certified(at);
    expect(out[i] == one.value && columns[i] == one.value, "batch equals scalar");
    expect(bounds[i] == one.relative_error_bound, "bound of the batch");
    const Certified fast_one = fast::critical_velocity_certified(at);
    expect(fast_columns[i] == fast_one.value, "fast batch equals scalar");
{sweep}
  }}
{outside}}}

}}  // namespace
}}  // namespace {name}

int main() {{
  {name}::check();
  return {name}::failures == 0 ? 0 : 1;
}}
)";

/// The frequencies of a sweep: around the scene's, or inside of the table of its drive, whose first
/// row may be at rest.
std::string frequencies_of_sweep(const Evaluator& evaluator) {
  const std::vector<double>& table = evaluator.velocity.program.table();
  if (table.empty())
    return evaluator.parameters.named("p.THE_OMEGA * (0.25 + 0.125 * static_cast<double>(i))");
  return fmt::format("{0} + ({1} - {0}) * static_cast<double>(i + 1) / 76.0",
                     literal(table.front()), literal(table[table.size() - 3]));
}

const char* const outside_of_table =
    R"(  other = p;
  other.THE_OMEGA = 2.0 * THE_LAST;
  const Certified none = critical_velocity_certified(other), fast_none = fast::critical_velocity_certified(other);
  expect(std::isnan(none.value) && std::isinf(none.relative_error_bound), "outside of the table");
  expect(std::isnan(fast_none.value) && std::isinf(fast_none.relative_error_bound), "fast: outside of the table");
)";

std::string check_outside(const Evaluator& evaluator) {
  if (!has_table(evaluator)) return "";
  const std::vector<double>& table = evaluator.velocity.program.table();
  return evaluator.parameters.named(
      replaced(outside_of_table, "THE_LAST", literal(table[table.size() - 3])));
}

}  // namespace

std::string cpp_test(const Evaluator& evaluator, const std::string& name) {
  const Problem& problem = evaluator.derivation.problem;
  const ParameterList& parameters = evaluator.parameters;
  return fmt::format(
      fmt::runtime(frame), fmt::arg("name", name),
      fmt::arg("mu0", name_in(problem, problem->coefficient)),
      fmt::arg("omega", name_in(problem, problem->angular_frequency)),
      fmt::arg("du_z", name_in(problem, problem->amplitude)),
      fmt::arg("include", fmt::format("#include \"{}_batch.hpp\"\n", name)),
      fmt::arg("example", example(problem, parameters)), fmt::arg("known", known_value(problem)),
      fmt::arg("doubled", doubled(evaluator)), fmt::arg("euler", euler(evaluator)),
      fmt::arg("omegas", frequencies_of_sweep(evaluator)),
      fmt::arg("outside", check_outside(evaluator)), fmt::arg("sweep", fast_sweep(evaluator)));
}

std::string emit_cmake(const std::string& name) {
  check_library_name(name);
  return fmt::format(
      "# Generated by vcrit, do not edit: the header-only library {0}::{0} and its test.\n"
      "add_library({0}_evaluator INTERFACE)\n"
      "add_library({0}::{0} ALIAS {0}_evaluator)\n"
      "target_include_directories({0}_evaluator INTERFACE ${{CMAKE_CURRENT_LIST_DIR}})\n"
      "target_compile_features({0}_evaluator INTERFACE cxx_std_20)\n\n"
      "# A project that takes this folder in gets the library alone.\n"
      "if(CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_LIST_DIR AND BUILD_TESTING)\n"
      "  add_executable(test_{0} ${{CMAKE_CURRENT_LIST_DIR}}/test_{0}.cpp)\n"
      "  target_link_libraries(test_{0} PRIVATE {0}::{0})\n"
      "  add_test(NAME test_{0} COMMAND test_{0})\n"
      "endif()\n",
      name);
}

std::string emit_cmake_of_folder() {
  return "# Generated by vcrit, do not edit: all evaluators that were generated into this folder.\n"
         "cmake_minimum_required(VERSION 3.16)\n"
         "project(vcrit_evaluators LANGUAGES CXX)\n\n"
         "if(CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR)\n"
         "  include(CTest)\n"
         "endif()\n"
         "file(GLOB evaluators CONFIGURE_DEPENDS "
         "\"${CMAKE_CURRENT_SOURCE_DIR}/*_evaluator.cmake\")\n"
         "foreach(evaluator IN LISTS evaluators)\n"
         "  include(\"${evaluator}\")\n"
         "endforeach()\n";
}

}  // namespace vcrit::symbolic
