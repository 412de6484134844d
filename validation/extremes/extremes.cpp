#include "extremes/extremes.hpp"

#include <thread>

#include "extremes/handover.hpp"
#include "run/compiler.hpp"

namespace vcrit::validation::extremes {

namespace {

std::string work_on(const Family& family, const std::optional<std::filesystem::path>& compiler,
                    const Progress& step) {
  const symbolic::Derivation derivation = symbolic::derive(problem_of(family));
  step("compiling its evaluators");
  return handed_over(examine(family, derivation, subjects_of(derivation, compiler), {}, step));
}

}  // namespace

Extremes go_to_extremes(const Watch& watch) {
  const auto compiler = find_compiler();
  Extremes result;
  if (compiler) result.compiler = describe_compiler(*compiler, PrivateFolder().path());
  std::vector<std::string> names;
  for (const Family& family : families()) names.push_back(family.key);
  const auto work = [&](std::size_t i, const Progress& step) {
    return work_on(families()[i], compiler, step);
  };
  for (const std::string& answer :
       in_processes(names, std::thread::hardware_concurrency(), work, watch))
    result.families.push_back(taken_over(answer));
  return result;
}

}  // namespace vcrit::validation::extremes
