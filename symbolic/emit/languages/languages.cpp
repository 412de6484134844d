#include "emit/languages/languages.hpp"

#include <fmt/core.h>

#include "emit/languages/language_names.hpp"
#include "emit/languages/printers.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"
#include "emit/written.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"

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

/// Numbers of a wider exponent range.
bool has_wide(Language language) { return language == Language::c99 || language == Language::cuda; }

std::string accuracy_lines(Language language) {
  return comment(accuracy) + comment(has_wide(language) ? unlimited : limited);
}

std::string evaluator_text(const Evaluator& evaluator, const std::string& name, Language language) {
  switch (language) {
    case Language::c99:
      return c99_text(evaluator, name);
    case Language::python:
      return python_text(evaluator);
    case Language::javascript:
      return javascript_text(evaluator);
    case Language::cuda:
      return cuda_text(evaluator, name);
  }
  return {};
}

}  // namespace

const std::vector<std::string>& language_names() {
  static const std::vector<std::string> names{"c99", "python", "javascript", "cuda"};
  return names;
}

std::string extension(Language language) {
  static const std::vector<std::string> extensions{".h", ".py", ".mjs", ".cuh"};
  return extensions[static_cast<std::size_t>(language)];
}

std::string emit(const Derivation& derivation, const std::string& name, Language language,
                 const GenerateOptions& options) {
  const AlgebraLock lock;
  const Scene& scene = derivation.scene;
  const NamesOfScene names(scene);
  check_library_name(name, language);
  GenerateOptions own = options;
  own.language = language_names()[static_cast<std::size_t>(language)];
  const Evaluator evaluator(derivation, own,
                            has_wide(language) ? Zeros::out_of_range : Zeros::in_range);
  check_member_names(scene, derivation.parameters, language);
  std::string head = banner(derivation, command_line(scene, name, own), evaluator.fixed) +
                     comment(fmt::format("{} operations.", evaluator.operations)) +
                     accuracy_lines(language);
  if (language == Language::python) head = "#" + replaced(head.substr(2), "\n//", "\n#");
  return head + evaluator_text(evaluator, name, language);
}

std::filesystem::path generate(const Derivation& derivation, const std::filesystem::path& directory,
                               const std::string& name, Language language,
                               const GenerateOptions& options) {
  const AlgebraLock lock;
  const std::string text = emit(derivation, name, language, options);
  std::filesystem::path file = directory / (name + extension(language));
  write_generated({{file, text}});
  return file;
}

}  // namespace vcrit::symbolic
