// Documents of `vcrit derive`, in several formats of what was found out once. Each line that it
// reads is
// {"scene": FILE, "form": FORM, "limits": BOOL, "sensitivities": BOOL, "formats": [FORMAT, ...]},
// each line that it writes {FORMAT: DOCUMENT, ...}. For tests that look at thousands of documents.
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "document/findings.hpp"
#include "document/print.hpp"
#include "document/printed.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "problem/problem.hpp"
#include "record/json_text.hpp"

namespace vcrit::test {

namespace {

using symbolic::Format;
using symbolic::ResultForm;

/// A system's name is its format.
Format format_called(const std::string& name) {
  static const std::map<std::string, Format> formats{{"text", Format::text},
                                                     {"latex", Format::latex},
                                                     {"markdown", Format::markdown},
                                                     {"html", Format::html},
                                                     {"json", Format::json}};
  const auto found = formats.find(name);
  return found == formats.end() ? Format::system : found->second;
}

symbolic::DocumentOptions options_of(const nlohmann::ordered_json& asked) {
  static const std::map<std::string, ResultForm> forms{
      {"shortest", ResultForm::shortest},           {"nested", ResultForm::nested},
      {"storage-loss", ResultForm::storage_loss},   {"rational", ResultForm::rational},
      {"dimensionless", ResultForm::dimensionless}, {"expanded", ResultForm::expanded}};
  symbolic::DocumentOptions options;
  options.form = forms.at(asked.value("form", "shortest"));
  options.limits = asked.value("limits", false);
  options.sensitivities = asked.value("sensitivities", false);
  return options;
}

nlohmann::ordered_json documents(const Problem& problem, const nlohmann::ordered_json& asked) {
  symbolic::DocumentOptions options = options_of(asked);
  const symbolic::AlgebraLock lock;
  const symbolic::NamesOfScene names(problem);
  std::map<Format, symbolic::Findings> found;
  nlohmann::ordered_json documents;
  for (const std::string name : asked.at("formats")) {
    options.format = format_called(name);
    // Sensitivities of JSON are others: text has the numbers of the scene besides.
    const bool own = options.sensitivities && options.format == Format::json;
    const Format like = own ? Format::json : Format::latex;
    if (found.count(like) == 0) found.emplace(like, symbolic::findings_of(problem, options));
    documents[name] = symbolic::print_findings(problem, found.at(like), options.format, name);
  }
  return documents;
}

}  // namespace

void print_asked() {
  std::string file;  // most scenes are asked for in several forms, one after the other
  std::optional<Problem> problem;
  for (std::string line; std::getline(std::cin, line);) {
    const nlohmann::ordered_json asked = record::read_json(line);
    const std::string scene = asked.at("scene");
    if (file != scene) problem = read_problem(file = scene);
    std::cout << documents(*problem, asked).dump() << '\n';
  }
}

}  // namespace vcrit::test
