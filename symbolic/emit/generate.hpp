// The evaluator library generated for one scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "emit/options.hpp"

namespace vcrit::symbolic {

/// The header NAME.hpp as text; `name` is a C++ namespace. Throws InputError if it cannot be one,
/// ModelError for a drive that generated code does not know.
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

/// Writes DIR/NAME.hpp, DIR/NAME_batch.hpp, DIR/NAME_evaluator.cmake, DIR/CMakeLists.txt,
/// DIR/test_NAME.cpp and, if asked for, DIR/NAME_quantities.hpp, all beside their places and then
/// renamed. The others refuse to be compiled with a NAME.hpp of another run. Returns the files.
std::vector<std::filesystem::path> generate(const Derivation& derivation,
                                            const std::filesystem::path& directory,
                                            const std::string& name,
                                            const GenerateOptions& options = {});

}  // namespace vcrit::symbolic
