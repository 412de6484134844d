// All compiled ways to v* of a scene in one program of its own: it reads parameter sets from a
// file, times each way itself, and writes the values back as hexadecimal doubles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compiler.hpp"
#include "scene/scene.hpp"

namespace vcrit::validation::accuracy {

/// One way to evaluate v*.
struct Way {
  std::string key, name;
};

struct Answers {
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
  /// Derives, generates and compiles; takes a second or two. Throws std::runtime_error when the
  /// program does not compile.
  Driver(const Scene& scene, const std::filesystem::path& compiler);

  /// What v* depends on: the numbers that a set holds, in the order of Inputs::symbols.
  const std::vector<Symbol>& symbols() const { return symbols_; }
  const std::vector<Way>& ways() const { return ways_; }
  const std::vector<Missing>& missing() const { return missing_; }
  bool has(const std::string& key) const;

  /// Relative error bounds that the generated library claims in `grade` ("certified": accurate,
  /// "fast"), one a set. Throws as run().
  std::vector<double> bounds(const std::vector<std::vector<double>>& sets,
                             const std::string& grade) const;

  /// Answers of the ways named by `keys`, in their order. Throws std::runtime_error when the
  /// program fails or takes more than a minute.
  std::vector<Answers> run(const std::vector<std::vector<double>>& sets,
                           const std::vector<std::string>& keys) const;

 private:
  std::vector<Answers> run(const std::vector<std::vector<double>>& sets,
                           const std::vector<Way>& ways) const;

  PrivateFolder folder_;
  std::vector<Symbol> symbols_;
  std::vector<Way> ways_;
  std::vector<Missing> missing_;
};

}  // namespace vcrit::validation::accuracy
