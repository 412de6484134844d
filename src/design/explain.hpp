// Why nothing in a range reaches the wanted friction ratio, and what would.
#pragma once

#include <string>

#include "design/range.hpp"
#include "design/solve.hpp"

namespace vcrit::design {

struct Failure {
  const DesignQuestion& question;
  const NormalContact& contact;
  const SearchRange& range;
  std::optional<double> least;  ///< the least ratio that was found
  double least_at = 0;          ///< where, in the unit of what is sought
  int evaluations = 0, unanswered = 0;
  std::string first_reason;            ///< why the first of those without an answer has none
  std::optional<double> reached_at{};  ///< reaches the ratio, after some without an answer
};

/// A sentence or two for a ModelError.
std::string explanation(const Failure& failure);

}  // namespace vcrit::design
