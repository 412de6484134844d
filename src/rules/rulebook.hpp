// The rulebook: which scenes which question has an answer for, and what to say and do where it has
// none. Everyone asks here, so that one question has one answer; a row a question, a column a kind
// of scene (cells.cpp).
#pragma once

#include <string>
#include <vector>

#include "rules/kinds.hpp"

namespace vcrit::rules {

enum class Question {
  admissible,   ///< Eq. 24 applies: (3), (4), and a load to carry
  formula,      ///< v* is Eq. 24, with the values of the scene
  closed_form,  ///< v* is Eq. 24 at least while the contact is closed where u_z rises fastest
  formula_of_all_values,  ///< v* is Eq. 24 whatever the values
  evaluator,              ///< code is generated for it
  rational_form,          ///< v*^2 is a quotient of polynomials
  all_frequencies,        ///< v* is a function of the frequency, at every one of them
  motion,                 ///< one contact moves
  motion_below_indenter,  ///< the cells of a half-space move
  normal_motion,          ///< the contact closes and opens
  motion_in_time,         ///< a law of motion is known, whatever the values
  comparison,             ///< v* by Eq. 24 has a motion to be compared with
  other_methods,          ///< methods besides the exact one
  report_simulation,      ///< a report simulates
  report_explorer,        ///< a page computes v*, and friction where there is a motion
  report_stability,       ///< a report maps the digits lost
  mean_load,              ///< the contact carries a load, as `solve` needs
  closed_range,           ///< the contact stays closed at some frequencies
  closed_amplitude,       ///< and at some amplitudes
  derivation,             ///< a formula is derived, whether or not v* is that one
};
inline constexpr std::size_t questions = static_cast<std::size_t>(Question::derivation) + 1;

/// Refused: the command cannot go on. Left out: it goes on without, or by another way.
enum class Ruling { unset, yes, refused, left_out };

struct Answer {
  Ruling verdict = Ruling::yes;
  std::string reason = {}, advice = {};
  const char* key = "";  ///< the kind that decided; see name_of()

  explicit operator bool() const { return verdict == Ruling::yes; }
  /// What a program ends with that goes no further.
  int status() const { return verdict == Ruling::refused ? 3 : 0; }
};

/// Throws InputError for missing values where the answer depends on them.
Answer answer(Question question, const Problem& problem);
/// Which of the two questions for a motion the scene has to be asked.
Question motion_question(const Problem& problem);
/// As answer() for one kind, whether or not the scene is of it: words that say numbers of the
/// scene stay patterns. For tables and tests.
Answer cell(Question question, SceneKind kind);

/// All that stands against it.
std::vector<std::string> reasons(Question question, const Problem& problem);

/// Throws ModelError with reason and advice where the answer is not yes; `asker` in front of the
/// reason.
void require(Question question, const Problem& problem, const std::string& asker = "");

/// "motion_in_time"
const char* name_of(Question question);

}  // namespace vcrit::rules
