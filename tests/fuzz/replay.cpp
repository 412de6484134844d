// Runs a fuzz target without libFuzzer: over every file of a folder, then over variants of them
// made by a fixed seed.
//
//   fuzz --TARGET FOLDER
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "targets.hpp"

namespace {

constexpr std::uint64_t seed = 20240607;
constexpr int variants = 5000;
constexpr std::size_t longest_variant = 2000;

using Random = std::mt19937_64;

std::size_t below(std::size_t bound, Random& random) { return random() % std::max(bound, 1UL); }

// A stretch of one input, of at most 32 bytes.
std::string stretch(const std::string& text, Random& random) {
  const std::size_t begin = below(text.size(), random);
  return text.substr(begin, 1 + below(32, random));
}

// Loses a stretch, gets one of another input, or has one byte changed.
void edit(std::string& text, const std::string& other, Random& random) {
  const std::size_t at = below(text.size(), random);
  switch (random() % 3) {
    case 0:
      text.erase(at, 1 + below(8, random));
      break;
    case 1:
      text.insert(at, stretch(other, random));
      break;
    default:
      if (!text.empty()) text[at] = static_cast<char>(random());
  }
}

std::vector<std::string> inputs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files(std::filesystem::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return inputs;
}

void run(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::string variant(const std::vector<std::string>& inputs, Random& random) {
  std::string text = inputs[below(inputs.size(), random)].substr(0, longest_variant);
  for (std::size_t edits = 1 + below(5, random); edits > 0; --edits)
    edit(text, inputs[below(inputs.size(), random)], random);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  LLVMFuzzerInitialize(&argc, &argv);
  if (argc != 3) return 2;
  const std::vector<std::string> inputs = inputs_in(argv[2]);
  if (inputs.empty()) return 1;
  for (const std::string& input : inputs) run(input);
  Random random(seed);
  for (int i = 0; i < variants; ++i) run(variant(inputs, random));
  std::printf("%zu inputs, %d variants of them from seed %llu\n", inputs.size(), variants,
              static_cast<unsigned long long>(seed));
}
