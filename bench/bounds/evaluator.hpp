// A generated header compiled into a program of its own, which takes cases and gives answers as
// they lie in memory.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bounds/systems.hpp"

namespace vcrit::bounds {

/// What critical_velocity_certified and fast::critical_velocity_certified return.
struct CertifiedAnswers {
  double value, bound, fast_value, fast_bound;
};

class CompiledHeader {
 public:
  /// `header`: what the generator makes of the system's scene, under the name "evaluator".
  CompiledHeader(const TrialSystem& system, const std::string& header,
                 const std::filesystem::path& folder);

  /// With the first compiler on the path, for this machine.
  void compile() const;

  /// The answers to all cases, one after the other in `x`, by files in `folder`.
  std::vector<CertifiedAnswers> evaluate(std::span<const double> x,
                                         const std::filesystem::path& folder) const;

  /// "{.mu0 = 0x1p-1, ...}": what to give to the header for this case.
  std::string parameters(std::span<const double> x) const;

 private:
  struct Member {
    std::string name;
    std::vector<std::size_t> slots;
    bool is_array;
  };
  std::vector<double> ordered(std::span<const double> x) const;

  const TrialSystem& system_;
  std::vector<Member> members_;
  std::filesystem::path program_;
};

/// The generated header, to be given to a CompiledHeader.
std::string header_for(const TrialSystem& system);

}  // namespace vcrit::bounds
