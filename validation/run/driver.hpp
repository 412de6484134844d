// All compiled ways to v* of a scene in one program of its own: it reads parameter sets from a
// file, times each way itself, and writes the values back as hexadecimal doubles.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "derivation/derivation.hpp"
#include "run/compiler.hpp"

namespace vcrit::validation {

/// One way to evaluate v*.
struct Way {
  std::string key, name;
};

struct WayAnswers {
  Way way;
  double nanoseconds = 0;      ///< a value, median of several batches
  std::vector<double> values;  ///< m/s, one a set
};

/// A way that a scene does not have, and why.
struct Missing {
  Way way;
  std::string reason;
};

class Driver {
 public:
  explicit Driver(symbolic::Derivation derivation) : derivation_(std::move(derivation)) {}
  /// Compiled at once.
  Driver(symbolic::Derivation derivation, const std::filesystem::path& compiler);

  /// Generates the library; only once. From then on the ways are known.
  void generate();

  /// Compiles what is generated, for all who ask; takes a second or two. Throws std::runtime_error
  /// when it does not compile, and the same again without another try.
  void compile(const std::filesystem::path& compiler);

  /// What v* depends on: the numbers that a set holds, in the order of Inputs::symbols.
  const std::vector<Symbol>& symbols() const { return derivation_.parameters; }
  const symbolic::Derivation& derivation() const { return derivation_; }
  const std::vector<Way>& ways() const { return ways_; }
  const std::vector<Missing>& missing() const { return missing_; }
  bool has(const std::string& key) const;

  /// Relative error bounds that the generated library claims in `grade` ("certified": accurate,
  /// "fast"), one a set. Throws as run().
  std::vector<double> bounds(const std::vector<std::vector<double>>& sets,
                             const std::string& grade) const;

  /// Answers of the ways named by `keys`, in their order. Throws std::runtime_error when the
  /// program fails or takes more than a minute.
  std::vector<WayAnswers> run(const std::vector<std::vector<double>>& sets,
                              const std::vector<std::string>& keys) const;

 private:
  std::vector<WayAnswers> run(const std::vector<std::vector<double>>& sets,
                              const std::vector<Way>& ways) const;

  symbolic::Derivation derivation_;
  std::optional<PrivateFolder> folder_;
  std::string no_library_;  ///< why there is no generated library; empty if there is one
  std::string failure_;     ///< why it does not compile; empty if that is not known
  bool compiled_ = false;
  std::vector<Way> ways_;
  std::vector<Missing> missing_;
};

}  // namespace vcrit::validation
