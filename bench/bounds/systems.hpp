// The systems on which bounds are tried: small networks of known kinds, as scene and as numbers in
// a row.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::bounds {

/// What stands between two points; formulas.hpp says which numbers each takes, in which order.
enum class NetworkShape { spring, kelvin, maxwell, zener, burgers, prony, ladder, bridge, grid };

enum class Role { coefficient, omega, amplitude, mass, poisson, spring, damper, time };

/// One number of a case; its name is the member of the generated Parameters, entry 0 or that of an
/// array.
struct Slot {
  Role role;
  std::string name;
  int entry = 0;
};

/// Slots of one network.
struct SlotRange {
  std::size_t first = 0, count = 0;
  template <class Number>
  std::span<Number> of(std::span<Number> all) const {
    return all.subspan(first, count);
  }
};

struct TrialSystem {
  std::string name;
  Problem problem;
  std::vector<Slot> slots;
  NetworkShape contact{};
  std::optional<NetworkShape> drive;
  SlotRange normal, tangential, driving;
  std::optional<std::size_t> mass, poisson;  ///< slots; an isotropic contact has no tangential one
};

inline constexpr std::size_t coefficient_slot = 0, omega_slot = 1,
                             amplitude_slot = 2;  // of every case

/// All systems, the smallest networks first.
std::vector<TrialSystem> all_systems();

}  // namespace vcrit::bounds
