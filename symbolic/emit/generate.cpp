#include "emit/generate.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <utility>

#include "base/errors.hpp"
#include "emit/cpp_files.hpp"
#include "emit/names.hpp"
#include "emit/pieces.hpp"
#include "emit/written.hpp"
#include "formula/algebra_lock.hpp"

namespace vcrit::symbolic {

namespace {

/// FNV-1a, as a literal.
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("0x{:016x}ULL", hash);
}

void insert_after(std::string& text, const std::string& line, const std::string& inserted) {
  const std::size_t at = text.find(line + "\n");
  ensure(at != std::string::npos, "the line is there");
  text.insert(at + line.size(), inserted);
}

/// The files are renamed one by one. Whoever is killed between two of them leaves whole files of
/// two runs, which the compiler must not take for one library: the header's guard carries its hash,
/// and what includes it asks for that.
void stamp(std::string& header, const std::string& name, const std::string& hash) {
  insert_after(header, "#define " + guard_of(name), " " + hash);
}

void insert_check(std::string& text, const std::string& file, const std::string& name,
                  const std::string& hash) {
  const std::string included = name + (file == "test_" + name + ".cpp" ? "_batch" : "");
  insert_after(text, fmt::format("#include \"{}.hpp\"", included),
               fmt::format("\n\n#if {} != {}\n#error \"{} and {}.hpp are of two runs: vcrit "
                           "generate again\"\n#endif",
                           guard_of(name), hash, file, name));
}

/// One of the files made by itself.
std::string alone(const Derivation& derivation, const std::string& name,
                  const GenerateOptions& options,
                  std::string (*file)(const Evaluator&, const std::string&)) {
  const AlgebraLock lock;
  check_library_name(name);
  return file(Evaluator(derivation, options, Zeros::out_of_range), name);
}

}  // namespace

std::string emit_header(const Derivation& derivation, const std::string& name,
                        const GenerateOptions& options) {
  return alone(derivation, name, options, cpp_header);
}

std::string emit_batch_header(const Derivation& derivation, const std::string& name,
                              const GenerateOptions& options) {
  return alone(derivation, name, options, cpp_batch_header);
}

std::string emit_test(const Derivation& derivation, const std::string& name,
                      const GenerateOptions& options) {
  return alone(derivation, name, options, cpp_test);
}

std::vector<std::filesystem::path> generate(const Derivation& derivation,
                                            const std::filesystem::path& directory,
                                            const std::string& name,
                                            const GenerateOptions& options) {
  const AlgebraLock lock;
  check_library_name(name);
  const Evaluator evaluator(derivation, options, Zeros::out_of_range);
  std::string header = cpp_header(evaluator, name);
  const std::string hash = hash_of(header);
  stamp(header, name, hash);
  std::vector<NewFile> written;
  const auto companion = [&](const std::string& file, std::string text) {
    insert_check(text, file, name, hash);
    written.push_back({directory / file, std::move(text)});
  };
  companion(name + "_batch.hpp", cpp_batch_header(evaluator, name));
  if (options.quantities)
    companion(name + "_quantities.hpp", emit_quantities(derivation, name, options));
  companion("test_" + name + ".cpp", cpp_test(evaluator, name));
  written.push_back({directory / (name + "_evaluator.cmake"), emit_cmake(name)});
  written.push_back({directory / "CMakeLists.txt", emit_cmake_of_folder()});
  written.insert(written.begin(), {directory / (name + ".hpp"), std::move(header)});
  write_generated(written);
  std::vector<std::filesystem::path> files;
  for (const NewFile& file : written) files.push_back(file.place);
  return files;
}

}  // namespace vcrit::symbolic
