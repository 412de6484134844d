// The evaluator generated for one scene, in C++ or another language.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "emit/options.hpp"

namespace vcrit::symbolic {

/// The header NAME.hpp as text; `name` is a C++ namespace. Throws InputError if it cannot be one,
/// ModelError for a scene of which no code is generated (rules/rulebook.hpp).
std::string emit_header(const Derivation& derivation, const std::string& name,
                        const GenerateOptions& options = {});

/// The header NAME_batch.hpp: batches over arrays of any parameters, with bounds or derivatives.
std::string emit_batch_header(const Derivation& derivation, const std::string& name,
                              const GenerateOptions& options = {});

/// The program test_NAME.cpp, which checks consequences of Eq. 24 on the generated functions, and
/// their values where the scene has all numbers.
std::string emit_test(const Derivation& derivation, const std::string& name,
                      const GenerateOptions& options = {});

/// The header NAME_quantities.hpp: stiffnesses, oscillations, the admissible amplitude and
/// dimensionless groups of the scene, in plain double. Throws like emit_header.
std::string emit_quantities(const Derivation& derivation, const std::string& name,
                            const GenerateOptions& options = {});

/// NAME_evaluator.cmake: the library NAME::NAME and its test.
std::string emit_cmake(const std::string& name);

/// CMakeLists.txt, the same for every scene: builds and tests all libraries of its folder.
std::string emit_cmake_of_folder();

/// What GenerateOptions::language can be: "c++", "c99", ...
const std::vector<std::string>& language_names();

/// The file NAME.hpp, NAME.h, NAME.py, ... as text. Throws InputError where there is no such
/// language or it does not allow `name` or the name of a parameter, ModelError as emit_header().
std::string emit(const Derivation& derivation, const std::string& name,
                 const GenerateOptions& options = {});

/// A file of generated code.
struct CodeFile {
  std::string name, text;
  bool is_main = false;  ///< to be included or imported
};

/// The files of the language. In C++ these are NAME.hpp, NAME_batch.hpp, NAME_evaluator.cmake,
/// CMakeLists.txt, test_NAME.cpp and, if asked for, NAME_quantities.hpp; the others refuse to be
/// compiled with a NAME.hpp of another run.
std::vector<CodeFile> code_files(const Derivation& derivation, const std::string& name,
                                 const GenerateOptions& options = {});

/// Writes files made from the problem to `directory`, all beside their places and then renamed.
/// Returns their paths. Throws InputError where one would take the place of what the problem was
/// read from, or of a file of another hand; then nothing is written.
std::vector<std::filesystem::path> write_code(const std::vector<CodeFile>& files,
                                              const std::filesystem::path& directory,
                                              const Problem& problem);

/// Both: writes the evaluator's files. Returns them, the one to include or import first.
std::vector<std::filesystem::path> generate(const Derivation& derivation,
                                            const std::filesystem::path& directory,
                                            const std::string& name,
                                            const GenerateOptions& options = {});

}  // namespace vcrit::symbolic
