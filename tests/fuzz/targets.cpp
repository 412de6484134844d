#include "targets.hpp"

#include <cstdlib>
#include <map>
#include <string>

#include "fuzz.hpp"

namespace {

using Target = void (*)(const std::string& text);

Target chosen;

Target target_of(const std::string& argument) {
  using namespace vcrit::fuzz;
  const std::map<std::string, Target> targets{
      {"--scene", read_scene},           {"--expression", read_expression},
      {"--setting", read_setting},       {"--quantity", read_quantity},
      {"--receptance", read_receptance}, {"--profile", read_profile},
      {"--fit_data", read_fit_data},     {"--axis", read_axis}};
  const auto found = targets.find(argument);
  return found == targets.end() ? nullptr : found->second;
}

}  // namespace

int LLVMFuzzerInitialize(int* argc, char*** argv) {
  chosen = *argc > 1 ? target_of((*argv)[1]) : nullptr;
  if (chosen == nullptr) std::exit(2);
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen({reinterpret_cast<const char*>(data), size});
  return 0;
}
