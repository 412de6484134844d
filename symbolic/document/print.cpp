#include "document/print.hpp"

#include "document/content.hpp"
#include "document/json.hpp"
#include "document/markup.hpp"

namespace vcrit::symbolic {

namespace {

Findings find(const Scene& scene, bool with_limits, bool with_sensitivities) {
  Findings findings{derive(scene), {}, {}, {}, {}};
  if (with_limits) {
    findings.limits = limits(scene);
    findings.asymptotes = asymptotes(scene);
    findings.resonances = resonances(scene);
  }
  if (with_sensitivities) findings.sensitivities = sensitivities(scene);
  return findings;
}

}  // namespace

std::string print(const Scene& scene, Format format, bool with_limits, bool with_sensitivities) {
  const Findings findings = find(scene, with_limits, with_sensitivities);
  switch (format) {
    case Format::text:
      return text_document(title_of(scene), sections(findings));
    case Format::latex:
      return latex_document(title_of(scene), sections(findings));
    case Format::markdown:
      return markdown_document(title_of(scene), sections(findings));
    case Format::json:
      break;
  }
  return json_document(scene, findings);
}

}  // namespace vcrit::symbolic
