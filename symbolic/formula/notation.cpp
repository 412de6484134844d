#include "formula/notation.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace vcrit::symbolic {

namespace {

constexpr auto greek = std::to_array<std::string_view>(
    {"alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu",
     "nu",    "xi",   "rho",   "sigma", "tau",     "phi",  "chi", "psi",   "omega", "pi"});

/// The greek letter that `word` begins with and that ends at an index or with the word; the
/// longest.
std::size_t greek_prefix(const std::string& word) {
  std::size_t best = 0;
  for (const std::string_view letter : greek)
    if (word.starts_with(letter) && letter.size() > best) best = letter.size();
  const bool ends = best == word.size() || !std::islower(static_cast<unsigned char>(word[best]));
  return ends ? best : 0;
}

/// What reads as a function is no letter with an index.
constexpr auto functions =
    std::to_array<std::string_view>({"abs", "arg", "cos", "det", "dim", "exp", "gcd", "inf", "lim",
                                     "ln", "log", "max", "min", "mod", "sin", "sup", "tan"});

/// Elements are one letter with an index (kn, c1, kspring); other long names stand as words.
std::size_t base_length(const std::string& word) {
  if (const std::size_t letter = greek_prefix(word); letter > 0) return letter;
  std::size_t letters = 0;
  while (letters < word.size() && std::isalpha(static_cast<unsigned char>(word[letters])) != 0)
    ++letters;
  if (std::find(functions.begin(), functions.end(), word.substr(0, letters)) != functions.end())
    return letters;
  const bool element = word.starts_with('k') || word.starts_with('c');
  return element || letters <= 3 ? 1 : letters;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == '_')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  std::erase(parts, "");
  return parts;
}

}  // namespace

bool is_greek(const std::string& word) {
  return std::find(greek.begin(), greek.end(), word) != greek.end();
}

bool is_sensitivity(const std::string& name) { return name.starts_with("S_") && name.size() > 2; }

Notation notation(const std::string& name, bool bare_entry) {
  if (name == "du_z") return {"Delta", "u", {"z"}, {}, {}};
  if (name == "du_max") return {"Delta", "u", {"max"}, {}, {}};
  if (name.starts_with("dK_") && name.size() > 3) return {"d", "K", {name.substr(3)}, {}, {}};
  std::string rest = name;
  Notation result;
  while (!rest.empty() && (rest.back() == '*' || rest.back() == '\'')) {
    result.above += rest.back();
    rest.pop_back();
  }
  if (rest.starts_with("K_") && result.above.starts_with('\''))
    std::swap(result.above, result.primes);
  std::string entry;
  if (const std::size_t open = rest.find('['); open != std::string::npos) {
    entry = rest.substr(open + 1, rest.size() - open - 2);
    if (!bare_entry) entry = "(" + entry + ")";
    rest.erase(open);
  }
  const std::size_t length = base_length(rest);
  result.base = rest.substr(0, length);
  result.index = split(rest.substr(std::min(length, rest.size())));
  if (!entry.empty()) result.index.push_back(entry);
  return result;
}

}  // namespace vcrit::symbolic
