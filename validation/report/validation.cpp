#include "report/validation.hpp"

namespace vcrit::validation::report {

void Validation::add(const ComparisonVerdict& verdict) {
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

void Validation::write(const std::vector<NewFile>& all) {
  write_files(all);
  for (const NewFile& file : all) files.push_back(file.place);
}

}  // namespace vcrit::validation::report
