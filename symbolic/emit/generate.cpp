#include "emit/generate.hpp"

#include <fmt/core.h>

#include "base/output_places.hpp"
#include "emit/languages/language.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"
#include "emit/written.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "problem/input_files.hpp"

namespace vcrit::symbolic {

namespace {

const char* const accuracy =
    "Accuracy: critical_velocity errs by little more than half an ulp unless v* is badly "
    "conditioned, "
    "critical_velocity_certified says by how much at most. The fast grade is in plain double. A "
    "bound is infinite "
    "where nothing is known.";
const char* const unlimited =
    "As in C++, what leaves the guarded range of doubles is computed again with numbers of a wider "
    "exponent range.";
const char* const limited =
    "Missing compared with C++: numbers of a wider exponent range. Outside of the guarded range "
    "(see in_range; elements of value 0 are inside) the "
    "answer is that of plain double, with an infinite bound. No fused multiply-add: products are "
    "split by Dekker's "
    "method.";

std::string opening_comment(const std::string& name, const Language& language,
                            const Evaluator& evaluator) {
  const Derivation& derivation = evaluator.derivation;
  const std::string lines =
      banner(derivation, command_line(derivation.problem, name, evaluator.options),
             evaluator.fixed) +
      table_words(evaluator.velocity.program) +
      comment(fmt::format("{} operations.", evaluator.operations)) + comment(accuracy) +
      comment(language.zeros == Zeros::out_of_range ? unlimited : limited);
  const std::string sign(language.comment);
  return sign + replaced(lines.substr(2), "\n//", "\n" + sign);
}

CodeFile only_file(const Derivation& derivation, const std::string& name, const Language& language,
                   const GenerateOptions& options) {
  const AlgebraLock lock;
  const NamesOfScene names(derivation.problem);
  check_library_name(name, language);
  const Evaluator evaluator(derivation, options, language.zeros, language.spelled);
  check_member_names(derivation.problem, derivation.parameters, language);
  return {name + std::string(language.extension),
          opening_comment(name, language, evaluator) + language.text(evaluator, name), true};
}

}  // namespace

std::string emit(const Derivation& derivation, const std::string& name,
                 const GenerateOptions& options) {
  return code_files(derivation, name, options).front().text;
}

std::vector<CodeFile> code_files(const Derivation& derivation, const std::string& name,
                                 const GenerateOptions& options) {
  const Language& language = language_of(options);
  if (language.files != nullptr) return language.files(derivation, name, options);
  return {only_file(derivation, name, language, options)};
}

std::vector<std::filesystem::path> write_code(const std::vector<CodeFile>& files,
                                              const std::filesystem::path& directory,
                                              const Problem& problem) {
  std::vector<NewFile> written;
  std::vector<std::filesystem::path> places;
  for (const CodeFile& file : files) {
    places.push_back(directory / file.name);
    written.push_back({places.back(), file.text});
  }
  const std::vector<std::filesystem::path> read = input_files(problem);
  for (const auto& place : places) refuse_input_as_output(place, read);
  write_generated(written);
  return places;
}

std::vector<std::filesystem::path> generate(const Derivation& derivation,
                                            const std::filesystem::path& directory,
                                            const std::string& name,
                                            const GenerateOptions& options) {
  return write_code(code_files(derivation, name, options), directory, derivation.problem);
}

}  // namespace vcrit::symbolic
