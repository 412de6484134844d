#include "paper/verdicts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "paper/paper.hpp"

namespace vcrit::validation::paper {

bool shown(const Paper& paper, const std::vector<std::string>& keys) {
  const std::vector<Comparison> all = all_comparisons(paper);
  return std::all_of(keys.begin(), keys.end(), [&](const std::string& key) {
    const auto of_key = [&](const Comparison& each) { return each.key == key; };
    return std::any_of(all.begin(), all.end(), of_key) &&
           std::all_of(all.begin(), all.end(), [&](const Comparison& each) {
             return !of_key(each) || outcome(each) == Comparison::Outcome::passed;
           });
  });
}

std::vector<double> found(const Paper& paper, const std::string& key) {
  std::vector<double> numbers;
  for (const Comparison& each : all_comparisons(paper))
    if (each.key == key) numbers.push_back(each.found);
  return numbers;
}

std::string found_words(const Paper& paper, const std::string& key, int digits) {
  std::string words;
  for (const double number : found(paper, key))
    words += fmt::format("{}{:.{}f}", words.empty() ? "" : ", ", number, digits);
  return words;
}

std::string signed_words(double number, int digits) {
  return fmt::format("{}{:.{}f}", number < 0 ? "−" : "", std::abs(number), digits);
}

const char* to_text(Claim::Verdict verdict) {
  switch (verdict) {
    case Claim::Verdict::holds:
      return "holds";
    case Claim::Verdict::in_part:
      return "in part";
    case Claim::Verdict::fails:
      return "fails";
    case Claim::Verdict::not_legible:
      return "not legible";
    case Claim::Verdict::not_shown:
      return "not shown";
  }
  throw Bug("a verdict without a name");
}

}  // namespace vcrit::validation::paper
