#include "document/print.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/limits.hpp"
#include "analysis/residues.hpp"
#include "derivation/derivation.hpp"
#include "document/form_lines.hpp"
#include "formula/dialect.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"

namespace vcrit::symbolic {

namespace {

const char* const title_of_derivation = "Critical velocity of controllability of sliding friction";
const char* const nested_note =
    "The formula is left nested: multiplied out, its polynomials would be too long to read.";

std::string equation(const Dialect& dialect, const Line& line) {
  return dialect.equation(form_of(line.left), form_of(line.right));
}

Line velocity_line(const GiNaC::ex& velocity) { return {"", quantity("v*"), velocity}; }

bool same(const std::vector<Line>& a, const std::vector<Line>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Line& x, const Line& y) {
    return x.left.is_equal(y.left) && x.right.is_equal(y.right);
  });
}

/// What a document says, apart from its markup.
struct Content {
  const Scene& scene;
  Derivation derivation;
  std::vector<Limit> limits;
  ResultForm form = ResultForm::by_size;
  std::vector<Line> form_lines;  ///< of the form that was asked for, behind the result
  std::string fingerprint;

  std::string title() const { return scene.title.empty() ? title_of_derivation : scene.title; }
  bool is_nested() const { return form == ResultForm::by_size && !derivation.definitions.empty(); }
  /// The lines of a limit: what its inner quantities are, where they differ, then v*.
  std::vector<Line> lines(const Limit& limit) const {
    std::vector<Line> result;
    if (!same(limit.definitions, derivation.definitions)) result = limit.definitions;
    result.push_back(velocity_line(limit.result));
    return result;
  }
  /// The last line is the result, with its number in the paper.
  std::string words(const Line& line) const {
    return &line == &derivation.lines.back() ? line.words + " " + derivation.equation : line.words;
  }
  std::string heading(const Limit& limit, const std::string& name) const {
    return limit.equation.empty() ? name : name + " " + limit.equation;
  }
};

/// The line above an equation that has words.
std::string heading(const std::string& words) { return words.empty() ? "" : words + ":\n"; }

std::string text_document(const Content& content) {
  const Dialect& dialect = text_dialect();
  std::string out = content.title() + "\n\n";
  for (const Line& line : content.derivation.lines)
    out += fmt::format("{}:\n    {}\n", content.words(line), equation(dialect, line));
  if (content.is_nested()) out += std::string(nested_note) + "\n";
  for (const Line& line : content.form_lines)
    out += fmt::format("{}    {}\n", heading(line.words), equation(dialect, line));
  if (!content.limits.empty()) out += "\nLimits and special cases:\n";
  for (const Limit& limit : content.limits) {
    out += content.heading(limit, limit.name) + ":\n";
    for (const Line& line : content.lines(limit))
      out += fmt::format("    {}\n", equation(dialect, line));
  }
  return out;
}

/// Words of a line as LaTeX text.
std::string latex_words(const std::string& words) {
  std::string out;
  for (const char c : words) {
    if (std::string("_%&#$").find(c) != std::string::npos) out += '\\';
    if (c == '^')
      out += "\\^{}";
    else
      out += c;
  }
  return out;
}

std::string latex_document(const Content& content) {
  const Dialect& dialect = latex_dialect();
  const auto display = [&](const Line& line) {
    return "\\[ " + equation(dialect, line) + " \\]\n";
  };
  std::string out = "\\section*{" + latex_words(content.title()) + "}\n";
  for (const Line& line : content.derivation.lines)
    out += latex_words(content.words(line)) + ":\n" + display(line);
  if (content.is_nested()) out += std::string(nested_note) + "\n\n";
  for (const Line& line : content.form_lines)
    out += latex_words(heading(line.words)) + display(line);
  if (!content.limits.empty()) out += "\\subsection*{Limits and special cases}\n";
  for (const Limit& limit : content.limits) {
    out += content.heading(limit, "$" + limit.latex_name + "$") + ":\n";
    for (const Line& line : content.lines(limit)) out += display(line);
  }
  return out;
}

std::string markdown_document(const Content& content) {
  const Dialect& dialect = latex_dialect();
  const auto display = [&](const Line& line) {
    return "\n$$" + equation(dialect, line) + "$$\n\n";
  };
  std::string out = "# " + content.title() + "\n\n";
  for (const Line& line : content.derivation.lines)
    out += content.words(line) + ":\n" + display(line);
  if (content.is_nested()) out += std::string(nested_note) + "\n\n";
  for (const Line& line : content.form_lines) out += heading(line.words) + display(line);
  if (!content.limits.empty()) out += "## Limits and special cases\n\n";
  for (const Limit& limit : content.limits) {
    out += content.heading(limit, "$" + limit.latex_name + "$") + ":\n";
    for (const Line& line : content.lines(limit)) out += display(line);
  }
  return out;
}

using Json = nlohmann::ordered_json;

Json json_lines(const std::vector<Line>& lines) {
  Json out = Json::array();
  for (const Line& line : lines)
    out.push_back({{"words", line.words},
                   {"text", equation(text_dialect(), line)},
                   {"latex", equation(latex_dialect(), line)}});
  return out;
}

std::string json_document(const Content& content) {
  const Derivation& d = content.derivation;
  Json out{{"title", content.scene.title},
           {"form", d.definitions.empty() ? "multiplied out" : "nested"},
           {"fingerprint", content.fingerprint},
           {"lines", json_lines(d.lines)},
           {"parameters", Json::array()},
           {"equation", d.equation},
           {"critical_velocity",
            {{"text", to_text(d.critical_velocity)}, {"latex", to_latex(d.critical_velocity)}}},
           {"definitions", json_lines(d.definitions)},
           {"limits", Json::array()}};
  for (const Symbol& parameter : d.parameters) out["parameters"].push_back(to_text(parameter));
  for (const Limit& limit : content.limits)
    out["limits"].push_back({{"name", limit.name},
                             {"equation", limit.equation},
                             {"text", to_text(limit.result)},
                             {"latex", to_latex(limit.result)},
                             {"definitions", json_lines(limit.definitions)}});
  if (!content.form_lines.empty()) {
    const bool rational = content.form == ResultForm::rational;
    out[rational ? "rational" : "dimensionless"] = json_lines(content.form_lines);
  }
  return out.dump(2) + "\n";
}

}  // namespace

std::string print(const Scene& scene, const DocumentOptions& options) {
  const Content content{scene,
                        derive(scene, options.form == ResultForm::nested),
                        options.limits ? limits(scene) : std::vector<Limit>{},
                        options.form,
                        form_lines(scene, options),
                        fingerprint(Model(scene))};
  switch (options.format) {
    case Format::text:
      return text_document(content);
    case Format::latex:
      return latex_document(content);
    case Format::markdown:
      return markdown_document(content);
    case Format::json:
      break;
  }
  return json_document(content);
}

}  // namespace vcrit::symbolic
