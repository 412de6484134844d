#include "problem/input_files.hpp"

#include "problem/problem.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit {

std::vector<std::filesystem::path> input_files(const Problem& problem) {
  std::vector<std::filesystem::path> files{problem->source->file};
  if (const Receptance* drive = problem->receptance()) files.emplace_back(drive->file);
  for (const MeasuredStiffness& each : problem->measured) files.emplace_back(each.table->file);
  if (problem->indenter && problem->indenter->profile)
    files.emplace_back(problem->indenter->profile->file);
  return files;
}

}  // namespace vcrit
