// Evaluators of each language but C++ in a folder, their drivers compiled and run.
#pragma once

#include <boost/test/unit_test.hpp>
#include <optional>
#include <sstream>

#include "emit/draw.hpp"
#include "emit/language_table.hpp"
#include "emit/library.hpp"
#include "support/numbers.hpp"

namespace vcrit::test {

/// One call: the scene with all values, and what the functions gave.
struct LanguageCall {
  std::size_t library = 0;
  Scene scene;
  Real exact;
  std::vector<double> answers;

  double value() const { return answers[0]; }
  double bound() const { return answers[1]; }
  double fast_value() const { return answers[2]; }
  double fast_bound() const { return answers[3]; }
};

inline constexpr std::size_t plain_answers = 8;

class LanguageFiles {
 public:
  explicit LanguageFiles(const std::vector<Scene>& scenes, Asked asked = Asked::values)
      : asked_(asked) {
    std::vector<symbolic::Derivation> derivations;
    for (const Scene& scene : scenes) {
      derivations.push_back(symbolic::derive(scene));
      parameters_.emplace_back(scene, derivations.back());
    }
    for (const LanguageRow& row : other_languages()) {
      for (std::size_t i = 0; i < derivations.size(); ++i)
        symbolic::generate(derivations[i], folder_.path(), library(i), {.language = row.name});
      write_file(folder_.path() / row.driver, driver_of(row, parameters_, asked));
    }
  }

  std::vector<double> members_of(const LanguageCall& call) const {
    return members(call.scene, parameters_[call.library]);
  }

  Outcome run(Command command, const std::string& input = "/dev/null") const {
    const std::string place = folder_.path().string();
    for (std::string& word : command)
      if (word.starts_with("FOLDER/")) word.replace(0, 6, place);
    return test::run(command, folder_.path(), input);
  }

  void evaluate(const Tool& tool, std::vector<LanguageCall>& calls) const {
    std::string input;
    for (const LanguageCall& call : calls) {
      input += std::to_string(call.library);
      for (const double x : members_of(call)) input += fmt::format(" {}", to_text(x));
      input += "\n";
    }
    const std::string file = (folder_.path() / "input.txt").string();
    write_file(file, input);
    const Outcome outcome = run(tool.run, file);
    if (outcome.status != 0) throw std::runtime_error(tool.label + ": " + outcome.output);
    std::istringstream lines(outcome.output);
    for (LanguageCall& call : calls) {
      std::string line, word;
      std::getline(lines, line);
      std::istringstream words(line);
      call.answers.clear();
      while (words >> word) call.answers.push_back(std::strtod(word.c_str(), nullptr));
      const std::size_t count = members_of(call).size();
      BOOST_REQUIRE_EQUAL(call.answers.size(),
                          plain_answers + (asked_ == Asked::values ? 0 : 2 * (1 + count)));
    }
  }

  /// The tools that are there, their drivers compiled. Large programs take nvcc too long. Very
  /// large ones take every optimiser too long: one tool a language, which does not optimise.
  enum class Length { usual, large, very_large };
  template <class Use>
  void with_each_tool(Use use, Length length = Length::usual) const {
    for (const LanguageRow& row : other_languages()) {
      bool tried = false;
      for (Tool tool : row.tools) {
        if (length != Length::usual && tool.label == "nvcc") continue;
        if (length == Length::very_large && tried) break;
        if (length == Length::very_large)
          tool.compile.insert(tool.compile.end(), row.quick.begin(), row.quick.end());
        if (!is_present(tool.present, folder_.path())) {
          BOOST_TEST(tool.is_optional, missing_tool(tool.label));
          continue;
        }
        // Interpreters are one as the other.
        if (tried && tool.compile.empty()) continue;
        if (!tool.compile.empty()) {
          const Outcome outcome = run(tool.compile);
          BOOST_REQUIRE_MESSAGE(outcome.status == 0, tool.label << ": " << outcome.output);
        }
        tried = true;
        BOOST_TEST_CONTEXT(tool.label) { use(tool); }
      }
      BOOST_TEST(tried, row.name);
    }
  }

 private:
  PrivateFolder folder_;
  std::vector<symbolic::ParameterList> parameters_;
  Asked asked_;
};

/// d v*/dx by nodes from x and two neighbours of it, 2^-50 apart, exact but for (2^-50/d)^2 where
/// v* changes over relative distances d. At x = 0 to one side, over a distance far below all
/// elements.
inline Real derivative(const Scene& scene, const Real& exact, const Symbol& symbol) {
  const auto at = [&](double x) {
    Scene changed = scene;
    for (auto& [name, value] : changed.elements)
      if (name == symbol) value = x;
    for (Quantity* quantity :
         {&changed.coefficient, &changed.angular_frequency, &changed.amplitude})
      if (quantity->symbol == symbol) quantity->value = x;
    if (auto* isotropic = std::get_if<Isotropic>(&changed.tangential))
      if (isotropic->quantity.symbol == symbol) isotropic->quantity.value = x;
    for (std::optional<Quantity>* mass : {&changed.mass, &changed.mount_mass})
      if (*mass && (*mass)->symbol == symbol) (*mass)->value = x;
    return critical_velocity_by_nodes(changed);
  };
  constexpr double tiny = 1e-100;
  if (test::numbers_of(scene).at(symbol) == 0) return (at(tiny) - exact) / Real(tiny);
  const double x = test::numbers_of(scene).at(symbol), low = x * (1 - 0x1p-50),
               high = x * (1 + 0x1p-50);
  const Real below = Real(x) - Real(low), above = Real(high) - Real(x);
  const Real left = (exact - at(low)) / below, right = (at(high) - exact) / above;
  return (left * above + right * below) / (above + below);
}

}  // namespace vcrit::test
