#include "report/validation.hpp"

#include "base/files.hpp"

namespace vcrit::validation::report {

void Validation::add(const Verdict& verdict) {
  verdicts.push_back(verdict);
  const std::string line = verdict.subject + ": " + verdict.name;
  if (verdict.outcome == to_text(Comparison::Outcome::failed)) failed.push_back(line);
  if (verdict.outcome == to_text(Comparison::Outcome::not_run)) not_run.push_back(line);
  passed = failed.empty();
}

void Validation::add(const std::string& subject, const std::vector<Comparison>& comparisons) {
  for (const Comparison& comparison : comparisons)
    add({subject, comparison.key, comparison.name, to_text(outcome(comparison))});
}

void Validation::write(const std::filesystem::path& file, const std::string& text) {
  write_file(file, text);
  files.push_back(file);
}

}  // namespace vcrit::validation::report
