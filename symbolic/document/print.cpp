#include "document/print.hpp"

#include "analysis/half_space.hpp"
#include "analysis/parting.hpp"
#include "analysis/residues.hpp"
#include "document/content.hpp"
#include "document/form_lines.hpp"
#include "document/json.hpp"
#include "document/markup.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

// Terms in v* up to which the equation for its extrema is short enough to be shown unasked.
constexpr double readable_extrema = 8;

Findings find(const Scene& scene, const DocumentOptions& options) {
  Findings findings{derive(scene, options.form == ResultForm::nested),
                    fingerprint(Model(scene)),
                    options.form,
                    form_lines(scene, options),
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {}};
  if (scene.indenter) findings.half_space = half_space_lines(scene);
  if (scene.separation) findings.parting = parting_lines(scene);
  if (options.limits) {
    findings.limits = limits(scene);
    findings.asymptotes = asymptotes(scene);
    findings.resonances = resonances(scene);
    if (options.form != ResultForm::rational)
      findings.extrema = extrema_lines(scene, readable_extrema);
  }
  if (options.sensitivities) findings.sensitivities = sensitivities(scene);
  return findings;
}

}  // namespace

std::string print(const Scene& scene, const DocumentOptions& options) {
  const AlgebraLock lock;
  const NamesOfScene names(scene);
  const Findings findings = find(scene, options);
  switch (options.format) {
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
