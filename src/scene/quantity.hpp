// Numbers of a scene and what it says by them alone: isotropic contact, an indenter, the range of a
// fit. What a scene and the problem that it becomes have in common stands here once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/units.hpp"
#include "network/network.hpp"
#include "scene/measured_stiffness.hpp"
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

/// What a scene says besides its physics, for those who write it down and read it again.
struct Source {
  std::string file;  ///< as the user named it
  std::string title;
  std::string text;                           ///< the file's content
  Settings settings;                          ///< that replaced values of it
  std::map<std::string, int> arrays;          ///< length of each array among the elements
  std::map<std::string, Dimension> settable;  ///< what --set may name, and what it measures
  std::map<std::string, Symbol> named;        ///< what each of these is; may be frequency_symbol
  std::map<std::string, std::string> expressions;  ///< of elements, as they are written
  std::map<std::string, std::string> tabulated;    ///< files of elements that follow a table
  std::vector<std::string> warnings;
};

/// Its physics but for the networks.
struct Givens {
  std::optional<Quantity> mass;             ///< m (kg) of the body; only under a drive that gives
  std::optional<FittedRange> fitted_range;  ///< of the contact's networks
  bool separation = false;                  ///< the contact may open: F_n = max(0, reaction)
  std::optional<Indenter> indenter;         ///< of an isotropic half-space
  Quantity coefficient, angular_frequency, amplitude;  ///< mu0, omega, du_z
  Quantity indentation;          ///< u_z0, m; without a value where there is a load
  std::optional<Quantity> load;  ///< W (N), the mean normal force, in place of the indentation
  /// m_n (kg), what moves with the contact along the normal; may be the body's own symbol. Only
  /// with a mount.
  std::optional<Quantity> mount_mass;
  std::vector<MeasuredStiffness> measured = {};  ///< of the contact, normal and tangential
  /// The names that a scene gives its symbols, by the names that they have here: "M" of "m" where
  /// mass = "M". All that is not among them is written as it is called here.
  std::map<std::string, std::string> names;
};

/// K_t/K_n of an isotropic contact. Throws Bug if it has no value.
double tangential_ratio(const Isotropic& isotropic);

}  // namespace vcrit
