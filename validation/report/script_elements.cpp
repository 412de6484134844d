#include "report/script_elements.hpp"

#include <fmt/format.h>

#include "report/assets.hpp"

namespace vcrit::validation::report {

std::string script_policy() {
  std::string allowed;
  for (const Script& script : scripts()) allowed += fmt::format(" '{}'", script.hash);
  return fmt::format(
      "default-src 'none'; script-src{}; style-src 'unsafe-inline'; img-src data: blob:; "
      "base-uri 'none'; form-action 'none'",
      allowed);
}

std::string script_elements() {
  std::string text;
  for (const Script& script : scripts()) text += fmt::format("<script>{}</script>\n", script.text);
  return text;
}

}  // namespace vcrit::validation::report
