// Systems that a derived formula can be taken to: each is a row, in a file of its own, and a
// template of the same name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "document/content.hpp"

namespace vcrit::symbolic {

/// A function around its argument: "sqrt(", ")".
struct Around {
  const char *before = "", *after = ")";
};

/// How it writes expressions; sums, products and quotients are + - * / everywhere.
struct Syntax {
  std::string (*number)(const std::string& digits) = nullptr;  ///< of "17" and "17/14"
  const char* power = nullptr;                                 ///< an operator; null: pow(x, n)
  Around root, absolute;
  Around absolute_complex;  ///< of what may not be real
  const char* imaginary = nullptr;
  bool power_of_complex = true;  ///< else such powers are written as products
};

struct AlgebraSystem {
  std::string_view name;    ///< of --format
  std::string_view result;  ///< what v* is called there
  /// Names that it has a meaning for, or that its reader would expect one of, as words; and others.
  std::string_view reserved = {};
  bool (*has_meaning)(const std::string& name) = nullptr;
  /// A printed name ("k[1]", "K_n") in characters that names have there.
  std::string (*spelled)(const std::string& name) = nullptr;
  /// Other names after one that is taken: attempt 1, 2, ...
  std::string (*another)(const std::string& name, int attempt) = nullptr;
  /// No syntax: presentation MathML, in which nothing is taken.
  const Syntax* syntax = nullptr;
  /// Prose where it has no effect: in comments.
  std::string (*escape)(std::string_view) = nullptr;
};

/// In the order of --format.
const std::vector<const AlgebraSystem*>& systems();

/// "k_1" for "k[1]"; "K_n_loss" for K_n'', and "K_n_storage".
std::string with_index(const std::string& name);
/// "k_1_", "k_1_2", ...
std::string with_underscore(const std::string& name, int attempt);

/// Prose for a comment, whatever the system: nothing in it ends a line or a comment, or goes on
/// with either.
std::string in_comment(std::string_view text);

/// The digits as they are, as of systems with exact numbers.
std::string exact_number(const std::string& digits);

/// What `vcrit derive --format NAME` prints. Throws InputError for a system that is not there.
std::string system_document(const std::string& system, const Problem& problem,
                            const Findings& findings);

}  // namespace vcrit::symbolic
