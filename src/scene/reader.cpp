// The scene format: sections, quantities with units, elements, and what of it is left out.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <set>

#include "base/files.hpp"
#include "base/identifiers.hpp"
#include "base/units.hpp"
#include "network/graph.hpp"
#include "network/masses.hpp"
#include "scene/document.hpp"
#include "scene/networks.hpp"
#include "scene/scene.hpp"
#include "scene/settings.hpp"

namespace vcrit {

namespace {

using document::describe;
using document::Section;

/// What a quantity's value must satisfy.
struct Range {
  bool (*holds)(double);
  const char* expected;
};
constexpr Range nonnegative{[](double v) { return std::isfinite(v) && v >= 0; },
                            "a finite value of at least 0"};
constexpr Range positive{[](double v) { return std::isfinite(v) && v > 0; },
                         "a finite value above 0"};
constexpr Range poisson_range{[](double v) { return v > -1 && v <= 0.5; },
                              "a Poisson's ratio above -1, up to 0.5"};

double checked(double value, const Range& range, const std::string& name, const Place& place) {
  if (range.holds(value)) return value;
  throw InputError(place, fmt::format("{} = {}", name, value), range.expected);
}

/// A number, a text with a unit, or a bare name, which has no value.
std::optional<double> number(const toml::node& node, Dimension dimension, const std::string& name,
                             const Place& place) {
  // Not node.value<double>(), which has none for an integer that no double equals.
  if (node.is_integer()) return static_cast<double>(node.ref<std::int64_t>());
  if (node.is_floating_point()) return node.ref<double>();
  if (!node.is_string())
    throw InputError(place, fmt::format("{} = {}", name, describe(node)),
                     vcrit::describe(dimension));
  const auto& text = node.ref<std::string>();
  const auto word = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  const bool bare = !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
                    std::all_of(text.begin(), text.end(), word) && text != "inf" && text != "nan";
  if (bare) return std::nullopt;
  return parse_quantity(text, dimension, place);
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& file, const Settings& settings)
      : document_(document::parse(text, file)),
        file_(file),
        networks_(document_, file),
        settings_(settings) {
    scene_.file = file;
    scene_.text = text;
    scene_.settings = settings;
  }

  Scene read() {
    const Section top(
        &document_, "", file_,
        {"title", "contact", "drive", "body", "oscillation", "friction", "elements", "networks"});
    if (top.find("title") != nullptr) scene_.title = top.text("title");
    read_contact();
    read_drive();
    networks_.read_unused();
    read_body();
    read_oscillation();
    read_friction();
    read_elements();
    settings_.refuse_untaken();
    scene_.settable = settings_.known();
    leave_out_zeros();
    collect_elements();
    std::copy(networks_.warnings().begin(), networks_.warnings().end(),
              std::back_inserter(scene_.warnings));
    return std::move(scene_);
  }

 private:
  Network network(const Section& section, const char* key) {
    return networks_.read(section.text(key), section.place(key));
  }

  Network contact_network(const Section& section, const char* key) {
    Network read = network(section, key);
    if (has_masses(read))
      throw InputError(section.place(key), fmt::format("a mass in the {} network", key),
                       "springs and dampers: only a [drive] may hold masses");
    return read;
  }

  void read_contact() {
    const Section contact =
        section("contact", {"normal", "poisson", "tangential_ratio", "tangential"});
    if (!contact.exists()) throw InputError({file_}, "no [contact]", "a section [contact]");
    scene_.normal = contact_network(contact, "normal");
    const auto given = std::count_if(ways_.begin(), ways_.end(),
                                     [&](const char* key) { return contact.find(key) != nullptr; });
    if (given != 1)
      throw InputError(contact.place(""), fmt::format("{} of {}", given, fmt::join(ways_, ", ")),
                       "exactly one of them in [contact]");
    if (contact.find("tangential") != nullptr) {
      scene_.tangential = contact_network(contact, "tangential");
      return;
    }
    const bool poisson = contact.find("poisson") != nullptr;
    const char* key = poisson ? "poisson" : "tangential_ratio";
    const std::string symbol = ratio_symbol(contact, key);
    const Quantity ratio =
        quantity(contact, key, symbol, Dimension::none, poisson ? poisson_range : positive);
    scene_.tangential = Isotropic{poisson ? Isotropic::By::poisson : Isotropic::By::ratio, ratio};
  }

  // A ratio without a value keeps the name it was given; the other quantities have canonical
  // symbols.
  static std::string ratio_symbol(const Section& section, const char* key) {
    const toml::node* node = section.find(key);
    if (!node->is_string() || number(*node, Dimension::none, key, section.place(key))) return key;
    const auto& name = node->ref<std::string>();
    if (const auto why = unsafe_as_identifier(name))
      throw InputError(section.place(key), fmt::format("name \"{}\", which {}", name, *why),
                       "another name");
    return name;
  }

  void read_drive() {
    const Section drive = section("drive", {"network", "receptance"});
    if (!drive.exists()) return;
    if (drive.find("receptance") != nullptr) return read_measured(drive);
    scene_.drive = network(drive, "network");
    refuse_misplaced_masses(drive.place("network"));
  }

  void read_measured(const Section& drive) {
    if (drive.find("network") != nullptr)
      throw InputError(drive.place("receptance"), "network and receptance",
                       "one of the two in [drive]");
    const std::filesystem::path folder = std::filesystem::path(file_).parent_path();
    scene_.receptance =
        read_receptance(folder / drive.text("receptance"), drive.place("receptance"));
  }

  void refuse_misplaced_masses(const Place& place) const {
    const std::vector<Symbol> off = masses_off_the_far_end(*scene_.drive);
    if (!off.empty())
      throw InputError(
          place, fmt::format("mass \"{}\" between two moving points", to_text(off.front())),
          "one end of each mass at the far end of the drive, as in \"k1 - (mass(m1) | k2)\", or at "
          "node \"ground\" of a graph");
    if (!without_masses(*scene_.drive))
      throw InputError(place, "a drive in which only masses lead to the far end",
                       "a path of springs and dampers, to balance the mean friction");
  }

  void read_body() {
    const Section body = section("body", {"mass"});
    if (!body.exists()) return;
    if (body.find("mass") == nullptr)
      throw InputError(body.place(""), "[body] without mass",
                       "mass = \"5 g\", or no section [body]");
    const Quantity mass = quantity(body, "mass", "m", Dimension::mass, nonnegative);
    if (mass.value == 0.0) return;
    if (has_drive(scene_))
      scene_.mass = mass;
    else
      scene_.warnings.push_back(
          fmt::format("{}: under a rigid drive the mass has no effect and is left out",
                      to_text(body.place("mass"))));
  }

  void read_oscillation() {
    const Section oscillation =
        section("oscillation", {"frequency", "angular_frequency", "amplitude", "indentation"});
    if (oscillation.find("frequency") != nullptr &&
        oscillation.find("angular_frequency") != nullptr)
      throw InputError(oscillation.place("angular_frequency"), "frequency and angular_frequency",
                       "one of the two");
    Quantity omega =
        quantity(oscillation, "angular_frequency", "omega", Dimension::angular_frequency, positive);
    const Quantity frequency =
        quantity(oscillation, "frequency", "frequency", Dimension::frequency, positive);
    refuse_both("frequency", "angular_frequency");
    refuse_both("frequency", "omega");
    if (frequency.value && (!omega.value || settings_.has("frequency")))
      omega.value = 2 * std::numbers::pi * *frequency.value;
    scene_.angular_frequency = omega;
    scene_.amplitude = quantity(oscillation, "amplitude", "du_z", Dimension::length, nonnegative);
    scene_.indentation =
        quantity(oscillation, "indentation", "u_z0", Dimension::length, nonnegative);
  }

  void read_friction() {
    const Section friction = section("friction", {"coefficient"});
    scene_.coefficient = quantity(friction, "coefficient", "mu0", Dimension::none, nonnegative);
  }

  Section section(const char* name, std::initializer_list<const char*> keys) const {
    return {document_.get(name), name, file_, keys};
  }

  /// The value under `key`, unless --set gives one for the key or for the symbol.
  Quantity quantity(const Section& section, const char* key, const std::string& symbol,
                    Dimension dimension, const Range& range) {
    Quantity quantity{{symbol}, std::nullopt};
    if (key != symbol) refuse_both(key, symbol);
    for (const std::string& name : {std::string(key), symbol})
      if (const auto value = settings_.take(name, dimension))
        quantity.value = checked(*value, range, name, OverridingValues::place(name));
    const toml::node* node = section.find(key);
    if (node == nullptr) return quantity;
    const auto value = number(*node, dimension, key, section.place(key));
    if (value) checked(*value, range, key, section.place(key));
    if (!quantity.value) quantity.value = value;
    return quantity;
  }

  // Two names of one quantity.
  void refuse_both(const std::string& name, const std::string& other) const {
    if (settings_.has(name) && settings_.has(other))
      throw InputError(OverridingValues::place(other), fmt::format("{} as well as {}", other, name),
                       "one of the two");
  }

  void read_elements() {
    const toml::table* elements = document::table(document_, "elements", file_);
    for (const auto& [name, use] : networks_.uses()) {
      refuse_clash(name, use);
      read_element(name, use, elements == nullptr ? nullptr : elements->get(name));
    }
    if (elements == nullptr) return;
    for (const auto& [key, value] : *elements)
      if (!networks_.uses().contains(std::string(key.str())))
        scene_.warnings.push_back(fmt::format("{}: element \"{}\" is in no network of this scene",
                                              to_text(document::place_of(value, file_)),
                                              std::string(key.str())));
  }

  // Without a body, m is free for a mass of the drive.
  void refuse_clash(const std::string& name, const ElementUse& use) const {
    std::set<std::string> taken{"mu0", "omega", "du_z", "u_z0"};
    if (document_.contains("body") || use.dimension != Dimension::mass) taken.insert("m");
    if (const auto* isotropic = std::get_if<Isotropic>(&scene_.tangential))
      taken.insert(isotropic->quantity.symbol.name);
    if (taken.contains(name))
      throw InputError(
          use.place, fmt::format("\"{}\" as an element", name),
          fmt::format("another name: it is a quantity of the scene ({})", fmt::join(taken, ", ")));
  }

  void read_element(const std::string& name, const ElementUse& use, const toml::node* node) {
    if (use.length > 0) return read_array(name, use, node);
    const auto set = settings_.take(name, use.dimension);
    if (set) values_[{name}] = checked(*set, nonnegative, name, OverridingValues::place(name));
    if (node == nullptr) return;
    const Place place = document::place_of(*node, file_);
    const auto value = number(*node, use.dimension, name, place);
    if (value && !set) values_[{name}] = checked(*value, nonnegative, name, place);
  }

  void read_array(const std::string& name, const ElementUse& use, const toml::node* node) {
    scene_.arrays[name] = use.length;
    if (node != nullptr && !node->is_array())
      throw InputError(document::place_of(*node, file_),
                       fmt::format("{} = {}", name, describe(*node)),
                       fmt::format("an array of {} entries", use.length));
    for (int entry = 1; entry <= use.length; ++entry) {
      const Symbol symbol{name, entry};
      const std::string label = to_text(symbol);
      const auto set = settings_.take(label, use.dimension);
      if (set) values_[symbol] = checked(*set, nonnegative, label, OverridingValues::place(label));
      if (node == nullptr) continue;
      const toml::node& item = *node->as_array()->get(static_cast<std::size_t>(entry - 1));
      const Place place = document::place_of(item, file_);
      const auto value = number(item, use.dimension, label, place);
      if (value && !set) values_[symbol] = checked(*value, nonnegative, label, place);
    }
  }

  bool is_zero(const Symbol& symbol) const {
    const auto value = values_.find(symbol);
    return value != values_.end() && value->second == 0;
  }

  Network without_zeros(const Network& network, const std::string& role) const {
    auto left = without(network, [this](const Element& element) {
      return is_zero(element.coefficient) ||
             (element.kind == ElementKind::maxwell && is_zero(element.time));
    });
    if (!left || !without_masses(*left))
      throw InputError({file_},
                       fmt::format("a {} network that elements of value 0 cut in two", role),
                       "a path of springs and dampers above 0 between its terminals");
    return std::move(*left);
  }

  void leave_out_zeros() {
    scene_.normal = without_zeros(scene_.normal, "normal");
    if (auto* tangential = std::get_if<Network>(&scene_.tangential)) {
      *tangential = without_zeros(*tangential, "tangential");
      // Equal networks are an isotropic contact: the rheology cancels wherever it can.
      if (*tangential == scene_.normal)
        scene_.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, 1.0}};
    }
    if (scene_.drive) scene_.drive = without_zeros(*scene_.drive, "drive");
  }

  void collect_elements() {
    std::set<Symbol> seen;
    const auto add = [&](const Network& network) {
      for (const Symbol& symbol : symbols_of(network)) {
        if (!seen.insert(symbol).second) continue;
        const auto value = values_.find(symbol);
        scene_.elements.emplace_back(
            symbol, value == values_.end() ? std::nullopt : std::optional(value->second));
      }
    };
    add(scene_.normal);
    if (const auto* tangential = std::get_if<Network>(&scene_.tangential)) add(*tangential);
    if (scene_.drive) add(*scene_.drive);
  }

  static constexpr std::array<const char*, 3> ways_{"poisson", "tangential_ratio", "tangential"};
  toml::table document_;
  std::string file_;
  Networks networks_;
  OverridingValues settings_;
  Values values_;
  Scene scene_;
};

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file, const Settings& settings) {
  return Reader(text, file, settings).read();
}

Scene read_scene(const std::string& file, const Settings& settings) {
  return parse_scene(read_file(file, document::longest_scene), file, settings);
}

}  // namespace vcrit
