// The C++ library: a header, and what accompanies it.
#include <fmt/core.h>

#include <cstdint>
#include <utility>

#include "base/errors.hpp"
#include "emit/generate.hpp"
#include "emit/languages/cpp/cpp_files.hpp"
#include "emit/languages/language.hpp"
#include "emit/names.hpp"
#include "emit/pieces.hpp"
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

std::vector<CodeFile> cpp_files(const Derivation& derivation, const std::string& name,
                                const GenerateOptions& options) {
  const AlgebraLock lock;
  check_library_name(name);
  const Evaluator evaluator(derivation, options, Zeros::out_of_range);
  std::string header = cpp_header(evaluator, name);
  const std::string hash = hash_of(header);
  stamp(header, name, hash);
  std::vector<CodeFile> files{{name + ".hpp", std::move(header), true}};
  const auto companion = [&](const std::string& file, std::string text, bool is_main) {
    insert_check(text, file, name, hash);
    files.push_back({file, std::move(text), is_main});
  };
  companion(name + "_batch.hpp", cpp_batch_header(evaluator, name), false);
  if (options.quantities)
    companion(name + "_quantities.hpp", emit_quantities(derivation, name, options), true);
  companion("test_" + name + ".cpp", cpp_test(evaluator, name), false);
  files.push_back({name + "_evaluator.cmake", emit_cmake(name)});
  files.push_back({"CMakeLists.txt", emit_cmake_of_folder()});
  return files;
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

extern const Language cpp{
    .name = "c++", .extension = ".hpp", .files = cpp_files, .has_quantities = true};

}  // namespace vcrit::symbolic
