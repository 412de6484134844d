#include "run/driver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/files.hpp"
#include "base/joined.hpp"
#include "emit/generate.hpp"
#include "run/driver_source.hpp"

namespace vcrit::validation {

namespace {

constexpr std::chrono::seconds answer_limit{60};  // thousands of values take less than a second

/// Why there is no generated library; empty if there is one, its headers in `folder`.
std::string generate_into(const symbolic::Derivation& derivation,
                          const std::filesystem::path& folder) {
  try {
    std::vector<symbolic::CodeFile> files = symbolic::code_files(derivation, "scene");
    std::erase_if(files, [](const auto& file) { return !file.name.ends_with(".hpp"); });
    symbolic::write_code(files, folder, derivation.problem);
    return {};
  } catch (const ModelError& error) {
    return error.what();
  }
}

// As in the driver: the values, then a time.
WayAnswers read_answers(std::istream& stream, const Way& way, std::size_t count) {
  const auto next = [&stream] {
    std::string word;
    if (!(stream >> word)) throw std::runtime_error("the compiled evaluators wrote too little");
    return std::strtod(word.c_str(), nullptr);
  };
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(next());
  return {way, next(), std::move(values)};
}

}  // namespace

Driver::Driver(symbolic::Derivation derivation, const std::filesystem::path& compiler)
    : Driver(std::move(derivation)) {
  compile(compiler);
}

void Driver::generate() {
  if (folder_) return;
  folder_.emplace();
  no_library_ = generate_into(derivation_, folder_->path());
  for (const Call& call : generated_calls())
    if (no_library_.empty())
      ways_.push_back(call.way);
    else
      missing_.push_back({call.way, no_library_});
  ways_.push_back(complex_call().way);
  if (derivation_.definitions.empty())
    ways_.push_back(pasted_call().way);
  else
    missing_.push_back({pasted_call().way, "it stays nested: the same as Eq. 24 as written"});
}

void Driver::compile(const std::filesystem::path& compiler) {
  generate();
  if (compiled_) return;
  if (!failure_.empty()) throw std::runtime_error(failure_);
  write_file(folder_->path() / "driver.cpp", driver_source(derivation_, no_library_.empty()));
  // What the generated headers ask for.
  const ProgramResult result =
      validation::compile(compiler, folder_->path(), "driver.cpp", "driver",
                          {"-O3", "-march=native", "-fno-math-errno"});
  compiled_ = result.succeeded();
  if (!compiled_) failure_ = failure_words(result, "compiling the evaluators");
  if (!compiled_) throw std::runtime_error(failure_);
}

bool Driver::has(const std::string& key) const {
  return std::any_of(ways_.begin(), ways_.end(), [&](const Way& way) { return way.key == key; });
}

std::vector<double> Driver::bounds(const std::vector<std::vector<double>>& sets,
                                   const std::string& grade) const {
  return run(sets, std::vector<Way>{{grade + "_bound", {}}}).front().values;
}

std::vector<WayAnswers> Driver::run(const std::vector<std::vector<double>>& sets,
                                    const std::vector<std::string>& keys) const {
  std::vector<Way> ways;
  for (const std::string& key : keys) {
    const auto way =
        std::find_if(ways_.begin(), ways_.end(), [&](const Way& each) { return each.key == key; });
    ensure(way != ways_.end(), "the driver knows its ways");
    ways.push_back(*way);
  }
  return run(sets, ways);
}

std::vector<WayAnswers> Driver::run(const std::vector<std::vector<double>>& sets,
                                    const std::vector<Way>& ways) const {
  const std::filesystem::path in = folder_->path() / "sets", out = folder_->path() / "answers";
  std::string text = fmt::format("{}\n", sets.size());
  for (const std::vector<double>& set : sets) {
    std::vector<std::string> numbers;
    for (const double number : set) numbers.push_back(fmt::format("{:a}", number));
    text += joined(numbers, " ") + "\n";
  }
  write_file(in, text);
  std::vector<std::string> command{folder_->path() / "driver", in, out};
  for (const Way& way : ways) command.push_back(way.key);
  const ProgramResult ran = run_program(command, folder_->path(), answer_limit);
  if (!ran.succeeded()) throw std::runtime_error(failure_words(ran, "the compiled evaluators"));
  std::istringstream stream(read_file(out));
  std::vector<WayAnswers> result;
  for (const Way& way : ways) result.push_back(read_answers(stream, way, sets.size()));
  return result;
}

}  // namespace vcrit::validation
