#include "document/print.hpp"

#include <utility>

#include "base/errors.hpp"
#include "document/appendix.hpp"
#include "document/content.hpp"
#include "document/json.hpp"
#include "document/markup.hpp"
#include "document/shares_text.hpp"
#include "document/systems/system.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

/// The result alone is taken: the system has its own ways to limits and derivatives.
void check_system(const DocumentOptions& options) {
  for (const auto& [name, asked] :
       {std::pair("limits", options.limits), {"sensitivities", options.sensitivities}})
    if (asked)
      throw InputError(argument(name), "the format " + options.system,
                       "text, latex, markdown or json: other formats have v* alone");
}

/// HTML is always a page of its own; text, Markdown and JSON have nothing to stand alone with.
void check_standalone(const DocumentOptions& options) {
  const bool stands = options.format == Format::latex || options.format == Format::html;
  if (options.standalone && !stands)
    throw InputError(argument("standalone"), "a format that is no page",
                     "the format latex, for an article, or html, a page with or without it");
}

}  // namespace

void check_options(const DocumentOptions& options) {
  if (options.format == Format::system) check_system(options);
  check_standalone(options);
}

std::string print(const Problem& problem, const DocumentOptions& options) {
  check_options(options);
  const std::string document = [&] {
    const AlgebraLock lock;
    const NamesOfScene names(problem);
    return print_findings(problem, findings_of(problem, options), options.format, options.system,
                          options.standalone);
  }();
  const bool in_numbers = options.sensitivities && options.format == Format::text;
  return in_numbers ? document + shares_text(problem) : document;
}

std::string print_findings(const Problem& problem, const Findings& findings, Format format,
                           const std::string& system, bool standalone) {
  const AlgebraLock lock;
  const NamesOfScene names(problem);
  if (format == Format::system) return system_document(system, problem, findings);
  if (format == Format::json) return json_document(problem, findings);
  return markup_document(
      format, title_of(problem),
      format == Format::text ? sections(findings, FactsPlace::first) : appendix(findings),
      standalone);
}

}  // namespace vcrit::symbolic
