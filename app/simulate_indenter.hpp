// Friction below an indenter at one speed, as `vcrit simulate` prints it.
#pragma once

#include <vector>

#include "indenter/friction.hpp"
#include "record/fields.hpp"

namespace vcrit::app {

struct IndenterAnswer {
  indenter::Friction friction;
  std::vector<indenter::CellMotion> cells;  ///< evenly spaced over half of the width
  double radius = 0;                        ///< of contact under the mean indentation, m
  double edge = 0;                          ///< the largest radius of contact, m
  bool on_drive = false;                    ///< that gives: its cells are known as a whole alone
};

/// velocity in m/s. Throws InputError, ModelError.
IndenterAnswer simulate_indenter(const Problem& problem, double velocity);

/// What the cells do, beside the friction of the whole.
void print_indenter(const IndenterAnswer& answer, int digits);

}  // namespace vcrit::app

namespace vcrit::record {

void fields(Fields& f, const app::IndenterAnswer& answer);

}  // namespace vcrit::record
