// Mathematica (Wolfram Language): names have neither underscores, which make patterns, nor begin
// with capitals, as all of its own do.
#include <cctype>

#include "document/systems/system.hpp"

namespace vcrit::symbolic {

namespace {

bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
char capital(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

/// du_z is duZ, kappa_k1 kappaK1, but K_n is Kn and k_1 is k1: letters take an index as it is.
std::string spelled_in_mathematica(const std::string& name) {
  std::string out;
  std::size_t part = 0;  // length of the part before
  const std::string indexed = with_index(name);
  for (std::size_t i = 0; i < indexed.size(); ++i) {
    if (indexed[i] == '_') {
      const std::size_t next = std::min(indexed.find('_', i + 1), indexed.size()) - i - 1;
      if (++i == indexed.size()) break;
      out += part > 1 || next > 1 ? capital(indexed[i]) : indexed[i];
      part = 1;
    } else {
      out += indexed[i];
      ++part;
    }
  }
  return out;
}

std::string another_in_mathematica(const std::string& name, int attempt) {
  std::string capitalized = name;
  capitalized.front() = capital(capitalized.front());
  return "my" + (attempt == 1 ? "" : std::to_string(attempt)) + capitalized;
}

// Its own symbols begin with a capital. None of them is one with digits alone behind it, or one of
// our stiffnesses and R_d; those of one letter are C D E I K N O.
bool has_meaning_in_mathematica(const std::string& name) {
  if (!is_capital(name.front())) return false;
  if (name.size() == 1) return std::string_view("CDEIKNO").find(name) != std::string_view::npos;
  const bool index = name.find_first_not_of("0123456789", 1) == std::string::npos;
  return !index && name != "Kn" && name != "Kt" && name != "Kd" && name != "Rd";
}

const Syntax mathematica_syntax{.number = exact_number,
                                .power = "^",
                                .root = {"Sqrt[", "]"},
                                .absolute = {"Abs[", "]"},
                                .absolute_complex = {"Abs[", "]"},
                                .imaginary = "I"};

}  // namespace

extern const AlgebraSystem mathematica{.name = "mathematica",
                                       .result = "vStar",
                                       .has_meaning = has_meaning_in_mathematica,
                                       .spelled = spelled_in_mathematica,
                                       .another = another_in_mathematica,
                                       .syntax = &mathematica_syntax,
                                       .escape = in_comment};

}  // namespace vcrit::symbolic
