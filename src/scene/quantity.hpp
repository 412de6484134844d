// Numbers of a scene and what it says by them alone: isotropic contact, an indenter, the range of a
// fit.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "network/network.hpp"
#include "scene/profile.hpp"

namespace vcrit {

/// A number of the scene, in SI units; without a value it is a symbol.
struct Quantity {
  Symbol symbol;
  std::optional<double> value;
};

/// Isotropic contact: K_t = ratio K_n.
struct Isotropic {
  enum class By { poisson, ratio };
  By by = By::ratio;
  Quantity quantity;  ///< Poisson's ratio nu, ratio = 2(1 - nu)/(2 - nu), or the ratio itself
};

/// An axisymmetric indenter, pressed into a half-space whose Young's modulus the normal network is.
struct Indenter {
  enum class Shape { flat, cone, parabola, power, table };
  Shape shape = Shape::flat;
  /// flat, parabola: radius (m), of the punch or of curvature; cone: angle (rad) between flank and
  /// surface; power: prefactor (SI) and exponent of f(r) = prefactor r^exponent; table: none
  std::vector<Quantity> sizes;
  std::optional<Profile> profile;  ///< of a table
};

/// The angular frequencies (rad/s) of the data that a contact was fitted to.
struct FittedRange {
  double from = 0, to = 0;
};

/// What to warn of where a contact fitted to data of that range is evaluated at angular frequencies
/// `from` to `to` (rad/s); nothing within it, or where there is none. `file`: of the scene.
std::optional<std::string> beyond_fitted_range(const std::optional<FittedRange>& fitted,
                                               const std::string& file, double from, double to);

/// The values of --set, by name ("k0", "k[3]", "mu0", "frequency", ...); a number in SI or with a
/// unit.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// What is set or varied where omega is by its cycles a second.
inline const Symbol frequency_symbol{"frequency"};

/// K_t/K_n of an isotropic contact. Throws Bug if it has no value.
double tangential_ratio(const Isotropic& isotropic);

}  // namespace vcrit
