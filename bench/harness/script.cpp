#include "harness/script.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "base/files.hpp"
#include "record/json_text.hpp"
#include "run/compiler.hpp"

namespace vcrit::bench {

std::string run_script(const std::string& name, const nlohmann::ordered_json& input,
                       const std::vector<std::string>& words, const std::filesystem::path& folder,
                       std::chrono::seconds longest) {
  const std::filesystem::path file = folder / "input.json";
  write_file(file, record::json_text(input));
  std::vector<std::string> command{"/usr/bin/python3", "-B", VCRIT_BENCH "/peers/" + name, file};
  command.insert(command.end(), words.begin(), words.end());
  const auto result = validation::run_program(command, folder, longest, std::nullopt);
  if (result.timed_out)
    throw std::runtime_error(fmt::format("{} was not back in {} s", name, longest.count()));
  if (!result.succeeded())
    throw std::runtime_error(fmt::format("{} failed: {}", name, result.output.substr(0, 2000)));
  return result.output;
}

}  // namespace vcrit::bench
