// Evaluators in languages other than C++, each from the same programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "emit/options.hpp"

namespace vcrit::symbolic {

enum class Language { c99, python, javascript, cuda };

/// "c99", "python", "javascript", "cuda", in the order of the enumeration.
const std::vector<std::string>& language_names();
/// ".h", ".py", ".mjs", ".cuh"
std::string extension(Language language);

/// The file NAME.h, NAME.py, NAME.mjs or NAME.cuh as text. Throws InputError where the language
/// does not allow `name` or the name of a parameter, ModelError as emit_header() does.
std::string emit(const Derivation& derivation, const std::string& name, Language language,
                 const GenerateOptions& options = {});

/// Writes that file to `directory`. Returns the file.
std::filesystem::path generate(const Derivation& derivation, const std::filesystem::path& directory,
                               const std::string& name, Language language,
                               const GenerateOptions& options = {});

}  // namespace vcrit::symbolic
