// What the rulebook says of each question to each kind of scene: its table, and the words in it.
#pragma once

#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::rules {

/// {du_z}, {u_z0}, {mu0} are names; {amplitude} and {indentation} are in m, {oscillating} and
/// {mean} in N, {load} the formula of {mean}, {share} is one over the other,
/// {what_keeps_it_closed} "an amplitude below 0.2 µm", or what else does.
struct Cell {
  Ruling verdict = Ruling::unset;
  const char* reason = "";
  const char* advice = "";
};

const Cell& table_entry(Question question, SceneKind kind);

}  // namespace vcrit::rules
