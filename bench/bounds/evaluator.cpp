#include "bounds/evaluator.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string_view>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "derivation/derivation.hpp"
#include "emit/generate.hpp"
#include "emit/parameters.hpp"
#include "run/compiler.hpp"

namespace vcrit::bounds {

namespace {

// Of compiling an evaluator and of evaluating a chunk, which take seconds: what is longer hangs.
constexpr std::chrono::minutes limit{10};

const char* const driver = R"(#include "evaluator.hpp"
#include <cstdio>
#include <vector>
int main(int, char** words) {
  std::FILE* const in = std::fopen(words[1], "rb");
  std::FILE* const out = std::fopen(words[2], "wb");
  if (in == nullptr || out == nullptr) return 1;
  std::vector<evaluator::Parameters> cases(1000);
  std::vector<double> answers;
  while (const std::size_t count =
             std::fread(cases.data(), sizeof(evaluator::Parameters), cases.size(), in)) {
    answers.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const auto accurate = evaluator::critical_velocity_certified(cases[i]);
      const auto fast = evaluator::fast::critical_velocity_certified(cases[i]);
      answers.insert(answers.end(), {accurate.value, accurate.relative_error_bound, fast.value,
                                     fast.relative_error_bound});
    }
    if (std::fwrite(answers.data(), sizeof(double), answers.size(), out) != answers.size())
      return 1;
  }
  return std::fclose(out) == 0 ? 0 : 1;
}
)";

void run_or_throw(const std::vector<std::string>& command, const std::filesystem::path& folder) {
  const validation::ProgramResult result = validation::run_program(command, folder, limit);
  if (!result.succeeded())
    throw std::runtime_error(fmt::format("{} failed: {}", command.front(), result.output));
}

std::size_t slot_of(const TrialSystem& system, const std::string& name, int entry) {
  const auto slot = std::find_if(system.slots.begin(), system.slots.end(), [&](const Slot& each) {
    return each.name == name && each.entry == entry;
  });
  ensure(slot != system.slots.end(), "each member of Parameters is a number of the case");
  return static_cast<std::size_t>(slot - system.slots.begin());
}

}  // namespace

std::string header_for(const TrialSystem& system) {
  return symbolic::emit_header(symbolic::derive(system.problem), "evaluator");
}

CompiledHeader::CompiledHeader(const TrialSystem& system, const std::string& header,
                               const std::filesystem::path& folder)
    : system_(system), program_(folder / "evaluate") {
  const symbolic::ParameterList list(system.problem, symbolic::derive(system.problem));
  for (const symbolic::Member& member : list.members()) {
    Member mine{member.name, {}, member.length > 0};
    for (int entry = mine.is_array ? 1 : 0; entry <= member.length; ++entry)
      mine.slots.push_back(slot_of(system, member.name, entry));
    members_.push_back(std::move(mine));
  }
  write_file(folder / "evaluator.hpp", header);
  write_file(folder / "evaluate.cpp", driver);
}

void CompiledHeader::compile() const {
  const auto compiler = validation::find_compiler();
  if (!compiler) throw std::runtime_error("no C++ compiler on the path");
  const std::filesystem::path folder = program_.parent_path();
  run_or_throw(
      {*compiler, "-std=c++20", "-O2", "-march=native", "-o", program_, folder / "evaluate.cpp"},
      folder);
}

std::vector<double> CompiledHeader::ordered(std::span<const double> x) const {
  std::vector<double> result;
  const std::size_t slots = system_.slots.size();
  for (std::size_t first = 0; first < x.size(); first += slots)
    for (const Member& member : members_)
      for (const std::size_t slot : member.slots) result.push_back(x[first + slot]);
  return result;
}

std::vector<CertifiedAnswers> CompiledHeader::evaluate(std::span<const double> x,
                                                       const std::filesystem::path& folder) const {
  const std::vector<double> numbers = ordered(x);
  const std::filesystem::path in = folder / "cases", out = folder / "answers";
  std::ofstream(in, std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  run_or_throw({program_, in, out}, folder);
  std::vector<CertifiedAnswers> answers(x.size() / system_.slots.size());
  const auto bytes = static_cast<std::streamsize>(answers.size() * sizeof(CertifiedAnswers));
  std::ifstream stream(out, std::ios::binary);
  stream.read(reinterpret_cast<char*>(answers.data()), bytes);
  ensure(stream.gcount() == bytes, "the evaluator answers every case");
  return answers;
}

std::string CompiledHeader::parameters(std::span<const double> x) const {
  std::vector<std::string> members;
  for (const Member& member : members_) {
    std::vector<std::string> numbers;
    for (const std::size_t slot : member.slots) numbers.push_back(fmt::format("{:a}", x[slot]));
    const std::string value = fmt::format("{}", fmt::join(numbers, ", "));
    members.push_back(
        fmt::format(".{} = {}", member.name, member.is_array ? "{" + value + "}" : value));
  }
  return fmt::format("{{{}}}", fmt::join(members, ", "));
}

}  // namespace vcrit::bounds
