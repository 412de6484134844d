// What a sweep may ask of each point.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

struct SweptQuantity {
  enum class Kind {
    critical_velocity,     ///< v*, m/s
    friction_ratio,        ///< mu_macro/mu0
    friction_ratio_error,  ///< estimate of its absolute error
    regime,                ///< of the simulated motion, as its flag
    admissible,            ///< whether Eq. 24 applies, as its flag
    indentation,           ///< u_z0, m: of a load as found
    mean_normal_force,     ///< <F_n>, N
    contact_amplitude,     ///< du_z, m: below a mount as found
    sensitivity            ///< (p/v*) dv*/dp
  };
  Kind kind = Kind::critical_velocity;
  Symbol parameter{};      ///< p of a sensitivity
  bool separates = false;  ///< of a scene whose contact may open
  std::string name{};      ///< what the scene calls p
  friend bool operator==(const SweptQuantity&, const SweptQuantity&) = default;
};

/// "critical_velocity", "friction_ratio", "friction_ratio_error", "regime", "admissible",
/// "indentation", "mean_normal_force", "contact_amplitude", or
/// "sensitivity:NAME", NAME as for --set. Throws InputError.
SweptQuantity parse_swept_quantity(const std::string& text, const Problem& problem);

/// The names, for help; the last one with NAME.
const std::vector<std::string>& swept_quantity_names();

/// The name of a column or variable: "critical_velocity", "sensitivity_k0".
std::string column_name(const SweptQuantity& quantity);
/// "m/s", "m", "N" or "1".
std::string unit(const SweptQuantity& quantity);
/// In words.
std::string description(const SweptQuantity& quantity);
/// What the flags mean, from the first one on, of a quantity of words; empty for numbers.
const std::vector<std::string>& words(const SweptQuantity& quantity);
/// 1 where 0 stands for no answer; 0 where there always is one.
int first_flag(const SweptQuantity& quantity);
/// The word of a flag, empty where there is no answer.
std::string word_of(const SweptQuantity& quantity, double flag);

/// Whether the motion must be simulated for it.
bool needs_motion(const SweptQuantity& quantity);

}  // namespace vcrit
