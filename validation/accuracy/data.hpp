// What is known of one scene about accuracy, cost and stability: plain data, with no way to compute
// it and no way to show it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "network/network.hpp"

namespace vcrit::validation::accuracy {

/// Histogram of errors in units in the last place of the correctly rounded value: 0, 1, 2, up to 4,
/// up to 8, ... up to 2^53, beyond; and those that are not finite.
struct Histogram {
  static constexpr std::size_t size = 56;  // 0; up to 2^0, ... 2^53; beyond
  std::array<std::size_t, size> counts{};
  std::size_t not_finite = 0;
  void add(double error);  ///< in units in the last place; NaN and infinity are not finite
  /// The largest error that bin `i` holds; the last bin has none.
  static double upper(std::size_t i);
};

struct WorstInput {
  std::vector<double> set;  ///< in the order of EvaluatorErrors::symbols, SI
  double found = 0, right = 0;
  double error = 0;  ///< units in the last place
};

/// One way to evaluate v* over all sets.
struct EvaluatorError {
  std::string key, name;
  bool measured = false;      ///< else `failure` says why not, and there are no numbers
  double nanoseconds = 0;     ///< a value
  double worst = 0, rms = 0;  ///< units in the last place, over the finite values
  Histogram histogram;
  std::vector<WorstInput> worst_inputs;  ///< at most ten, the worst first
  std::string failure;                   ///< why it is not ranked; empty if it is
  bool on_front = false;                 ///< none is both faster and, at its worst, more accurate
};

struct EvaluatorErrors {
  std::uint64_t seed = 0;
  std::size_t sets = 0, near_resonance = 0, near_antiresonance = 0;
  std::vector<Symbol> symbols;  ///< what varies
  std::string compiler;         ///< with version; empty without one
  std::vector<EvaluatorError> ways;
};

/// One steady state by one method at one setting.
struct Solve {
  std::string method, setting;
  bool answered = false;  ///< else `failure` says why not, and there are no numbers
  double seconds = 0;     ///< processor time, median of several
  double friction_ratio = 0;
  double error = 0;     ///< absolute, in mu_macro/mu0
  std::string failure;  ///< why it is not ranked; empty if it is
  bool on_front = false;
};

struct SpeedSolves {
  double ratio = 0;           ///< speed over the critical speed of the drive
  double friction_ratio = 0;  ///< of the reference
  std::string reference;      ///< what it is, in words
  /// By how much an independent method, named in `reference`, differs from the exact one, where
  /// that is the reference.
  std::optional<double> agreement;
  std::vector<Solve> solves;
};

/// A mark on a map: a cell where something went wrong.
struct Mark {
  double omega = 0, factor = 0;
  std::string words;
};

/// One quantity over the map.
struct Layer {
  std::string key, name;
  std::vector<double> lost;  ///< decimal digits, 0 to 16; NaN: no value. A row of one factor after
                             ///< the other, as in figures::Map
  std::vector<Mark> marks;
};

struct MapLine {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< omega (rad/s), factor
};

/// Decimal digits lost over omega and a factor on some numbers of the scene.
struct StabilityMap {
  std::string key, name;              ///< "stiffness", "relaxation"; what is varied
  std::vector<Symbol> scaled;         ///< by the factor
  std::vector<double> omega, factor;  ///< rad/s; 1
  std::vector<Layer> layers;
  std::vector<MapLine> lines;  ///< (anti)resonance
};

struct Accuracy {
  EvaluatorErrors evaluators;
  std::vector<SpeedSolves> simulators;
  std::vector<StabilityMap> maps;
  std::vector<std::string> left_out;  ///< sentences: what was not measured, and why
  std::string command;                ///< that measures again
};

}  // namespace vcrit::validation::accuracy
