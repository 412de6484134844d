#include "speed/library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cfenv>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "base/errors.hpp"

namespace vcrit::speed {

namespace {

constexpr std::chrono::minutes compile_limit{5};  // only a compiler that hangs takes so long

std::vector<std::string> with(std::vector<std::string> flags,
                              const std::vector<std::string>& more) {
  flags.insert(flags.end(), more.begin(), more.end());
  return flags;
}

/// clang's flags so that it takes a loop for what g++ does: whole, and as wide as the machine.
std::vector<std::string> clang_flags() {
  return {"-mprefer-vector-width=512", "-mllvm", "-inline-threshold=100000"};
}

}  // namespace

std::vector<std::string> Flags::scalar() { return {"-O3", "-march=native"}; }
std::vector<std::string> Flags::unsafe() {
  return with(scalar(), {"-ffast-math", "-fopenmp-simd"});
}
std::vector<std::string> Flags::by_hand() {
  return with(scalar(),
              {"-fno-math-errno", "-fno-trapping-math", "-ffp-contract=fast", "-fopenmp-simd"});
}
std::vector<std::string> Flags::generated() {
  return with(scalar(),
              {"-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fopenmp-simd"});
}

std::string to_text(const std::vector<std::string>& flags) {
  return fmt::format("{}", fmt::join(flags, " "));
}

Library::Library(const std::filesystem::path& compiler, const std::vector<std::string>& flags,
                 const std::filesystem::path& source) {
  const std::filesystem::path target = folder_.path() / "library.so";
  std::vector<std::string> command{compiler, "-std=c++20", "-fPIC", "-shared", "-I" VCRIT_BENCH};
  command = with(std::move(command), flags);
  if (compiler.filename().string().find("clang") != std::string::npos)
    command = with(std::move(command), clang_flags());
  command = with(std::move(command), {"-o", target, source});
  const auto result = validation::run_program(command, folder_.path(), compile_limit);
  if (!result.succeeded())
    throw std::runtime_error(fmt::format("compiling {} {}:\n{}", source.filename().string(),
                                         result.timed_out ? "took too long" : "failed",
                                         result.output.substr(0, 2000)));
  // What is linked with -ffast-math turns denormal numbers off for the whole process.
  std::fenv_t arithmetic;
  std::fegetenv(&arithmetic);
  handle_ = dlopen(target.c_str(), RTLD_NOW | RTLD_LOCAL);
  std::fesetenv(&arithmetic);
  if (handle_ == nullptr) throw std::runtime_error(dlerror());
}

Library::~Library() {
  if (handle_ != nullptr) dlclose(handle_);
}

Function Library::function(const std::string& name) const {
  void* const address = dlsym(handle_, name.c_str());
  if (address == nullptr) throw std::runtime_error(dlerror());
  return reinterpret_cast<Function>(address);
}

std::filesystem::path peer_source(const std::string& name) {
  return std::filesystem::path(VCRIT_BENCH) / "speed" / "peers" / name;
}

std::filesystem::path compiler_named(const std::string& name) {
  const char* search_path = std::getenv("PATH");
  std::istringstream folders(search_path == nullptr ? "" : search_path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder) / name;
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  throw InputError({"--compiler"}, "\"" + name + "\", which is not in PATH", "a C++ compiler");
}

}  // namespace vcrit::speed
