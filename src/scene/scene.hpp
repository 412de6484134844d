// A scene: what is there, read from one TOML file. What a scene does not name is not in it: without
// [drive] the drive is rigid, without [body] (or with a rigid drive, whose far end moves uniformly)
// there is no mass from here on. Who asks something of it resolves it first (problem/problem.hpp).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "network/network.hpp"
#include "scene/quantity.hpp"
#include "scene/receptance.hpp"

namespace vcrit {

struct Scene : Source, Givens {
  std::vector<std::pair<Symbol, std::optional<double>>>
      elements;    ///< the numbers of the networks, in order of writing
  Network normal;  ///< K_n; E of the half-space below an indenter
  std::variant<Isotropic, Network>
      tangential;                ///< K_t; equal networks have become Isotropic, ratio 1
  std::optional<Network> drive;  ///< K_d, may hold masses; rigid without this and a receptance
  std::optional<Network> mount;  ///< K_m, springs and dampers; the vibrator is the body without
  std::optional<Receptance> receptance;  ///< R_d = 1/K_d, measured; never beside a drive network
  /// As numbers were typed, by symbol; "frequency" where that was, in place of omega, with or
  /// without a unit. Read by those who carry them and 2 pi f exactly, where the value beside it is
  /// still the scene's own.
  std::map<Symbol, TypedNumber> typed;
};

/// Throws InputError.
Scene read_scene(const std::string& file, const Settings& settings = {});
/// The same from text; `file` only names it in messages.
Scene parse_scene(const std::string& text, const std::string& file, const Settings& settings = {});

/// The symbol by the name that the scene gives it. Everything that people and other programs read
/// has that; within the program symbols are known by their own names, of which none is another's.
Symbol as_called(const Scene& scene, const Symbol& symbol);

}  // namespace vcrit
