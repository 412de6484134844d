#include "document/form_lines.hpp"

#include "analysis/dimensionless.hpp"
#include "analysis/rational_form.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

std::vector<Line> rational_lines(const Scene& scene, double budget) {
  const RationalForm form = rational_form(Model(scene), budget);
  std::vector<Line> lines = lines_of(form);
  const Polynomial slope = stationary(form);
  if (slope.degree("omega") == 0) return lines;
  const auto extrema = lines_by_omega(
      slope, "E", "e", "v* is largest or least, at frequencies besides 0, where E = 0");
  lines.insert(lines.end(), extrema.begin(), extrema.end());
  return lines;
}

std::vector<Line> dimensionless_lines(const Scene& scene) {
  const DimensionlessForm form = dimensionless(scene);
  std::vector<Line> lines = form.groups;
  if (!lines.empty()) lines.front().words = "In dimensionless groups";
  if (!form.definitions.empty()) {
    lines.insert(lines.end(), form.definitions.begin(), form.definitions.end());
    lines[form.groups.size()].words = "Stiffnesses over the one that the groups refer to";
  }
  lines.push_back(
      {"In these", quantity("v*"), symbol({"mu0"}) * omega() * symbol({"du_z"}) * form.velocity});
  return lines;
}

}  // namespace

std::vector<Line> form_lines(const Scene& scene, const DocumentOptions& options) {
  if (options.form == ResultForm::rational) return rational_lines(scene, options.budget);
  if (options.form == ResultForm::dimensionless) return dimensionless_lines(scene);
  return {};
}

}  // namespace vcrit::symbolic
