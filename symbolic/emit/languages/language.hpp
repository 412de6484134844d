// Languages of generated code: each is a row, in a folder of its own with the text that all its
// files have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/generate.hpp"
#include "emit/languages/evaluator.hpp"

namespace vcrit::symbolic {

struct Language {
  std::string_view name;       ///< of --language
  std::string_view extension;  ///< of the file to include or import
  std::string_view comment = "//";
  /// out_of_range: it has numbers of a wider exponent range.
  Zeros zeros = Zeros::out_of_range;
  /// Words that neither a parameter nor the library can be called by, and others that the library
  /// cannot, beyond those that no generated code can have.
  std::string_view reserved = {}, taken = {};
  /// Of parameters whose names are neither refused nor written as they are; no two are spelled
  /// alike.
  Spelled spelled = nullptr;
  /// The file of that name, but its opening comment.
  std::string (*text)(const Evaluator& evaluator, const std::string& name) = nullptr;
  /// All files where there is more than that one, the file to include first.
  std::vector<CodeFile> (*files)(const Derivation& derivation, const std::string& name,
                                 const GenerateOptions& options) = nullptr;
  bool has_quantities = false;
};

/// In the order of --language.
const std::vector<const Language*>& languages();

/// Throws InputError for a name that no language has.
const Language& language_of(const GenerateOptions& options);

/// Whether the name is one of the words, which blanks or lines part.
bool is_among(std::string_view words, std::string_view name);

/// Throws InputError unless `name` can be the prefix, module or namespace of a generated file.
void check_library_name(const std::string& name, const Language& language);

/// Throws InputError if a parameter cannot have the name of one of these symbols.
void check_member_names(const Problem& problem, const std::vector<Symbol>& symbols,
                        const Language& language);

}  // namespace vcrit::symbolic
