#include "accuracy/driver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "accuracy/driver_source.hpp"
#include "base/files.hpp"
#include "derivation/derivation.hpp"
#include "emit/generate.hpp"

namespace vcrit::validation::accuracy {

namespace {

constexpr std::chrono::seconds answer_limit{60};

/// Why there is no generated library; empty if there is one, in `folder`.
std::string generate_into(const Scene& scene, const std::filesystem::path& folder) {
  try {
    symbolic::generate(scene, folder, "scene");
    return {};
  } catch (const ModelError& error) {
    return error.what();
  }
}

// As in the driver: a time, then the values.
Answers read_answers(std::istream& stream, const Way& way, std::size_t count) {
  const auto next = [&stream] {
    std::string word;
    if (!(stream >> word)) throw std::runtime_error("the driver program wrote too little");
    return std::strtod(word.c_str(), nullptr);
  };
  Answers answers{way, next(), {}};
  for (std::size_t i = 0; i < count; ++i) answers.values.push_back(next());
  return answers;
}

}  // namespace

Driver::Driver(const Scene& scene, const std::filesystem::path& compiler) {
  const std::filesystem::path& folder = folder_.path();
  const symbolic::Derivation formula = symbolic::derive(scene);
  const symbolic::Derivation nested = symbolic::derive(scene, true);
  symbols_ = formula.parameters;
  const std::string no_library = generate_into(scene, folder);
  std::vector<Call> calls;
  for (const Call& call : generated_calls())
    if (no_library.empty())
      calls.push_back(call);
    else
      missing_.push_back({call.way, no_library});
  calls.push_back(complex_call());
  if (formula.definitions.empty())
    calls.push_back(pasted_call());
  else
    missing_.push_back({pasted_call().way, "it stays nested: the same as Eq. 24 as written"});
  for (const Call& call : calls) ways_.push_back(call.way);
  if (no_library.empty()) calls.insert(calls.end(), bound_calls().begin(), bound_calls().end());
  write_file(folder / "driver.cpp",
             driver_source(scene, nested, formula, symbols_, calls, no_library.empty()));
  // What the generated headers ask for.
  output_or_throw(compile(compiler, folder, "driver.cpp", "driver",
                          {"-O3", "-march=native", "-fno-math-errno"}),
                  "compiling the driver program");
}

bool Driver::has(const std::string& key) const {
  return std::any_of(ways_.begin(), ways_.end(), [&](const Way& way) { return way.key == key; });
}

std::vector<double> Driver::bounds(const std::vector<std::vector<double>>& sets,
                                   const std::string& grade) const {
  return run(sets, std::vector<Way>{{grade + "_bound", {}}}).front().values;
}

std::vector<Answers> Driver::run(const std::vector<std::vector<double>>& sets,
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

std::vector<Answers> Driver::run(const std::vector<std::vector<double>>& sets,
                                 const std::vector<Way>& ways) const {
  const std::filesystem::path in = folder_.path() / "sets", out = folder_.path() / "answers";
  std::string text;
  for (const std::vector<double>& set : sets) text += fmt::format("{:a}\n", fmt::join(set, " "));
  write_file(in, text);
  std::vector<std::string> command{folder_.path() / "driver", in, out};
  for (const Way& way : ways) command.push_back(way.key);
  output_or_throw(run_program(command, folder_.path(), answer_limit), "the driver program");
  std::istringstream stream(read_file(out));
  std::vector<Answers> result;
  for (const Way& way : ways) result.push_back(read_answers(stream, way, sets.size()));
  return result;
}

}  // namespace vcrit::validation::accuracy
