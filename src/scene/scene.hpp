// A scene: what is there, read from one TOML file. What a scene does not name is not in it: without
// [drive] the drive is rigid, without [body] (or with a rigid drive, whose far end moves uniformly)
// there is no mass from here on.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "network/network.hpp"
#include "scene/profile.hpp"
#include "scene/receptance.hpp"

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

/// The values of --set, by name ("k0", "k[3]", "mu0", "frequency", ...); a number in SI or with a
/// unit.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// What is set or varied where omega is by its cycles a second.
inline const Symbol frequency_symbol{"frequency"};

struct Scene {
  std::string file;  ///< as the user named it
  std::string title;
  std::string text;   ///< the file's content
  Settings settings;  ///< that replaced values of it
  Network normal;     ///< K_n; E of the half-space below an indenter
  std::variant<Isotropic, Network>
      tangential;                ///< K_t; equal networks have become Isotropic, ratio 1
  std::optional<Network> drive;  ///< K_d, may hold masses; rigid without this and a receptance
  std::optional<Receptance> receptance;     ///< R_d = 1/K_d, measured; never beside a drive network
  std::optional<Quantity> mass;             ///< m (kg) of the body; only under a drive that gives
  std::optional<FittedRange> fitted_range;  ///< of the contact's networks
  bool separation = false;                  ///< the surfaces may part: F_n = max(0, reaction)
  std::optional<Indenter> indenter;  ///< only under a rigid drive, of an isotropic half-space
  Quantity coefficient, angular_frequency, amplitude, indentation;  ///< mu0, omega, du_z, u_z0
  std::vector<std::pair<Symbol, std::optional<double>>>
      elements;  ///< of the networks, in order of writing
  /// As numbers were typed, by symbol; "frequency" where that was, in place of omega, with or
  /// without a unit. Read by those who carry them and 2 pi f exactly, where the value beside it is
  /// still the scene's own.
  std::map<Symbol, TypedNumber> typed;
  std::map<std::string, int> arrays;          ///< length of each array among the elements
  std::map<std::string, Dimension> settable;  ///< what --set may name, and what it measures
  std::map<std::string, Symbol> named;        ///< what each of these is; may be frequency_symbol
  /// The names that a scene gives its symbols, by the names that they have here: "M" of "m" where
  /// mass = "M". All that is not among them is written as it is called here.
  std::map<std::string, std::string> names;
  std::vector<std::string> warnings;
};

/// Throws InputError.
Scene read_scene(const std::string& file, const Settings& settings = {});
/// The same from text; `file` only names it in messages.
Scene parse_scene(const std::string& text, const std::string& file, const Settings& settings = {});

/// The quantities that have names of their own; those of isotropic contact, body and indenter among
/// them.
std::vector<const Quantity*> quantities(const Scene& scene);
std::vector<Quantity*> quantities(Scene& scene);

/// Calls `visit` for every element of its networks: normal, tangential, drive, in the order of
/// writing.
void for_each_element(const Scene& scene, const std::function<void(const Element&)>& visit);

/// What to warn of where a scene is evaluated at angular frequencies `from` to `to` (rad/s):
/// nothing where all of them are in its fitted range, or it has none. Reading a scene asks this for
/// the scene's own frequency; who varies that asks again.
std::optional<std::string> beyond_fitted_range(const Scene& scene, double from, double to);

/// The symbol by the name that the scene gives it. Everything that people and other programs read
/// has that; within the program symbols are known by their own names, of which none is another's.
Symbol as_called(const Scene& scene, const Symbol& symbol);

/// "m", or what the scene calls it.
std::string name_in(const Scene& scene, const Quantity& quantity);

/// As evaluators and simulators take it: no number as it was typed.
Scene as_doubles(Scene scene);

/// Whether the drive is a network or measured, and not rigid.
bool has_drive(const Scene& scene);

/// K_t/K_n of an isotropic contact. Throws InputError if it has no value.
double tangential_ratio(const Isotropic& isotropic);

/// All values of the scene (elements and quantities) by symbol. Throws InputError naming every
/// missing one at once, and for one that no scene may have: whoever evaluates a scene asks this, so
/// that one whose members were changed after reading is checked as well. An element of value 0 is
/// such a one: reading leaves it out of the networks, so give it as a setting.
Values values_of(const Scene& scene);

/// The tangential network as such: with an isotropic contact, the normal one and a factor.
struct ScaledNetwork {
  const Network* network;
  double factor;
};
ScaledNetwork tangential_network(const Scene& scene);

}  // namespace vcrit
