// Maple: names that it protects or keeps as keywords are avoided.
#include <algorithm>
#include <cctype>

#include "document/systems/system.hpp"
#include "formula/notation.hpp"

namespace vcrit::symbolic {

namespace {

// Those with less than three letters, or with digits or underscores.
const char* const maple_words = R"(
Ci D Ei I Im Li O Pi Re Si by do fi gamma if in is ln od of op or pi to
HankelH1 HankelH2 JacobiTheta1 JacobiTheta2 JacobiTheta3 JacobiTheta4 LegendreEc1 LegendreKc1
LegendrePic1 Maple_floats Ore_algebra geom3d ilog10 ilog2 log10 log2 map2 modp1 modp2 plot3d
)";

// Hundreds of words are Maple's, and more with each version: greek letters but gamma are not.
bool has_meaning_in_maple(const std::string& name) {
  const bool letters = std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
  });
  return letters && name.size() > 2 && !is_greek(name);
}

const Syntax maple_syntax{.number = exact_number,
                          .power = "^",
                          .root = {"sqrt("},
                          .absolute = {"abs("},
                          .absolute_complex = {"abs("},
                          .imaginary = "I"};

}  // namespace

extern const AlgebraSystem maple{.name = "maple",
                                 .result = "v_star",
                                 .reserved = maple_words,
                                 .has_meaning = has_meaning_in_maple,
                                 .spelled = with_index,
                                 .another = with_underscore,
                                 .syntax = &maple_syntax,
                                 .escape = in_comment};

}  // namespace vcrit::symbolic
