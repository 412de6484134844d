// A scene resolved: what all rooms after it work on. It is valid when it is made and never changes;
// other numbers make another problem (with(), variation.hpp), another structure too (variants.hpp).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "problem/reduced_network.hpp"
#include "scene/quantity.hpp"
#include "scene/receptance.hpp"

namespace vcrit {

struct Scene;

/// A drive that does not give: without [drive] in a scene.
struct Rigid {};

/// The parts of a problem; a `Problem` is a pointer to them.
struct Resolved : Givens {
  ReducedNetwork normal;  ///< K_n; E of the half-space below an indenter
  /// K_t; equal networks have become Isotropic, ratio 1
  std::variant<Isotropic, ReducedNetwork> tangential;
  /// K_d, a network that may hold masses, or 1/K_d as a table. Who acts on it visits all three.
  std::variant<Rigid, ReducedNetwork, Receptance> drive;
  /// The symbols of its networks' numbers, in order of writing.
  std::shared_ptr<const std::vector<Symbol>> elements;
  std::shared_ptr<const BySymbol<TypedNumber>> typed;  ///< as of a scene
  std::optional<TypedNumber> frequency;                ///< f (Hz), where omega was given by it
  std::shared_ptr<const Source> source;
  std::vector<Amount> expressions = {};  ///< numbers of elements that are made of others
  /// K_m between vibrator and body along the normal; without it the vibrator is the body.
  std::optional<ReducedNetwork> mount = {};

  /// Whether the number of an element is that of a table, at omega.
  bool of_table(const Symbol& symbol) const {
    for (const MeasuredStiffness& each : measured)
      if (symbol == each.storage || symbol == each.loss_factor) return true;
    return false;
  }
  bool rigid() const { return std::holds_alternative<Rigid>(drive); }
  bool has_masses() const { return drive_network() != nullptr && drive_network()->has_masses(); }
  /// The drive where it is a network, and where it is measured; else null.
  const ReducedNetwork* drive_network() const { return std::get_if<ReducedNetwork>(&drive); }
  const Receptance* receptance() const { return std::get_if<Receptance>(&drive); }
};

/// Cheap to copy, and safe to hold: parts that are the same are shared, and nobody changes them.
/// May be asked from several threads at once.
class Problem {
 public:
  /// Throws InputError for a value that no scene may have, as one whose members were changed after
  /// reading can, and for parts that do not fit together (scene/members.hpp). An element of value 0
  /// is such a one: reading leaves it out of the networks, so give it as a setting. Values may be
  /// missing.
  Problem(const Scene& scene);  // NOLINT(google-explicit-constructor): a scene is a problem

  const Resolved* operator->() const { return &resolved(); }
  const Resolved& operator*() const { return resolved(); }

  /// All values (elements and quantities) by symbol, SI. Throws InputError naming every missing one
  /// at once, ModelError where omega is outside the table of a measured contact.
  const Values& values() const&;
  Values values() && { return std::as_const(*this).values(); }
  double value(const Quantity& quantity) const { return values().at(quantity.symbol); }
  /// Those that are there.
  const Values& known_values() const&;
  Values known_values() && { return std::as_const(*this).known_values(); }

  /// What `find` tells of its mean indentation, which is asked once for all copies. Who wants to
  /// know asks mean_indentation() (normal/).
  double found_indentation(const std::function<double()>& find) const;

  /// Another problem, with these values (SI) in place of its own; that of frequency_symbol is f,
  /// and omega 2 pi f; what a measured contact is follows omega. Throws InputError for one that no
  /// scene may have, and for a symbol that the problem does not have.
  Problem with(const Values& values) const;

 private:
  friend class Variant;
  struct Checked;
  /// `numbers`: those of its elements.
  Problem(Resolved resolved, const Values& numbers);
  const Resolved& resolved() const;

  std::shared_ptr<const Checked> checked_;
};

/// Throws InputError as making a Problem does.
Problem resolve(const Scene& scene);
/// Of a file, or of text that `file` names in messages. Throw InputError as reading does.
Problem read_problem(const std::string& file, const Settings& settings = {});
Problem parse_problem(const std::string& text, const std::string& file,
                      const Settings& settings = {});

/// What presses the contact: the mean normal force W of a scene with a load, else the mean
/// indentation u_z0 (m). What the other one is then is a question of the contact (normal/).
const Quantity& pressing(const Problem& problem);

/// The quantities that have names of their own; those of isotropic contact, body and indenter among
/// them.
std::vector<Quantity> quantities(const Problem& problem);

/// The numbers of its networks, in the order of writing, with their values.
std::vector<Quantity> elements_with_values(const Problem& problem);

/// Calls `visit` for every element of its networks: normal, tangential, drive, mount, in the order
/// of writing.
void for_each_element(const Problem& problem, const std::function<void(const Element&)>& visit);

/// What to warn of where a problem is evaluated at angular frequencies `from` to `to` (rad/s):
/// nothing where all of them are in its fitted range, or it has none. Reading a scene asks this for
/// the scene's own frequency; who varies that asks again.
std::optional<std::string> beyond_fitted_range(const Problem& problem, double from, double to);

/// The symbol by the name that the scene gives it. Everything that people and other programs read
/// has that; within the program symbols are known by their own names, of which none is another's.
Symbol as_called(const Problem& problem, const Symbol& symbol);

/// "m", or what the scene calls it.
std::string name_in(const Problem& problem, const Quantity& quantity);

/// K_t as a network times a number; of an isotropic contact that is the normal one. Throws Bug
/// where the ratio has no value.
struct ScaledNetwork {
  ReducedNetwork network;
  double factor;
};
ScaledNetwork tangential_network(const Problem& problem);

/// For std::visit: a function for each alternative.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace vcrit
