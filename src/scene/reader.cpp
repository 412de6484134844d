// The scene format: sections, quantities with units, elements, and what of it is left out.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "base/constants.hpp"
#include "base/files.hpp"
#include "base/identifiers.hpp"
#include "base/units.hpp"
#include "network/masses.hpp"
#include "scene/document.hpp"
#include "scene/element_expressions.hpp"
#include "scene/fitted_range.hpp"
#include "scene/indenter.hpp"
#include "scene/networks.hpp"
#include "scene/part_networks.hpp"
#include "scene/quantities.hpp"
#include "scene/scene.hpp"

namespace vcrit {

namespace {

using document::describe_node;
using document::Section;

class Reader {
 public:
  Reader(const std::string& text, const std::string& file, const Settings& settings)
      : document_(document::parse(text, file)),
        file_(file),
        networks_(document_, file),
        quantities_(settings, scene_.typed) {
    scene_.file = file;
    scene_.text = text;
    scene_.settings = settings;
  }

  Scene read() {
    const Section top(&document_, "", file_,
                      {"title", "contact", "indenter", "drive", "body", "oscillation", "friction",
                       "elements", "networks"});
    if (top.find("title") != nullptr) scene_.title = top.text("title");
    read_contact();
    read_drive();
    read_indenter();
    networks_.read_unused();
    read_body();
    read_oscillation();
    read_friction();
    quantities_.refuse_equal_names();
    scene_.names = quantities_.names();
    read_elements();
    settings().refuse_untaken();
    scene_.settable = settings().known();
    scene_.named = settings().named();
    leave_out_zeros();
    collect_elements();
    std::copy(networks_.warnings().begin(), networks_.warnings().end(),
              std::back_inserter(scene_.warnings));
    warn_beyond_the_data();
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
    const Section contact = section("contact", {"normal", "poisson", "tangential_ratio",
                                                "tangential", "separation", "fitted_range"});
    if (!contact.exists()) throw InputError({file_}, "no [contact]", "a section [contact]");
    scene_.normal = contact_network(contact, "normal");
    scene_.separation = flag(contact, "separation");
    scene_.fitted_range = read_fitted_range(contact);
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
        quantities_.read(contact, key, symbol, Dimension::none, poisson ? poisson_range : positive);
    scene_.tangential = Isotropic{poisson ? Isotropic::By::poisson : Isotropic::By::ratio, ratio};
  }

  static bool flag(const Section& section, const char* key) {
    const toml::node* node = section.find(key);
    if (node == nullptr) return false;
    if (!node->is_boolean())
      throw InputError(section.place(key), fmt::format("{} = {}", key, describe_node(*node)),
                       "true or false");
    return node->ref<bool>();
  }

  // A ratio has no symbol but the name that it is given; the other quantities have one of their
  // own.
  std::string ratio_symbol(const Section& section, const char* key) const {
    const auto name = bare_name(*section.find(key));
    return name ? own_name_of(*name, has_body()) : key;
  }

  bool has_body() const { return document_.contains("body"); }

  void warn_beyond_the_data() {
    const std::optional<double>& omega = scene_.angular_frequency.value;
    if (!omega) return;
    if (const auto warning = beyond_fitted_range(scene_.fitted_range, file_, *omega, *omega))
      scene_.warnings.push_back(*warning);
  }

  void read_drive() {
    const Section drive = section("drive", {"network", "receptance"});
    if (!drive.exists()) return;
    if (drive.find("receptance") != nullptr) return read_measured(drive);
    scene_.drive = network(drive, "network");
    refuse_misplaced_masses(*scene_.drive, drive.place("network"));
  }

  void read_measured(const Section& drive) {
    if (drive.find("network") != nullptr)
      throw InputError(drive.place("receptance"), "network and receptance",
                       "one of the two in [drive]");
    const std::filesystem::path folder = std::filesystem::path(file_).parent_path();
    scene_.receptance =
        read_receptance(folder / drive.text("receptance"), drive.place("receptance"));
  }

  void read_indenter() {
    const Section indenter = section("indenter", indenter_keys);
    if (!indenter.exists()) return;
    refuse_beside_indenter(indenter);
    scene_.indenter =
        vcrit::read_indenter(indenter, std::filesystem::path(file_).parent_path(), quantities_);
  }

  // Whether the drive is a network or measured, and not rigid.
  bool gives() const { return scene_.drive.has_value() || scene_.receptance.has_value(); }

  // Cells of the contact that would move one another, or are of no half-space.
  void refuse_beside_indenter(const Section& indenter) const {
    if (gives())
      throw InputError(indenter.place(""), "[indenter] with [drive]",
                       "a rigid drive: one that gives would let the parts of the contact move one "
                       "another");
    const auto* isotropic = std::get_if<Isotropic>(&scene_.tangential);
    if (isotropic == nullptr || isotropic->by != Isotropic::By::poisson)
      throw InputError(indenter.place(""), "[indenter] without poisson",
                       "poisson = ... in [contact], of the half-space whose Young's modulus "
                       "normal = \"...\" is");
  }

  void read_body() {
    const Section body = section("body", {"mass"});
    if (!body.exists()) return;
    if (body.find("mass") == nullptr)
      throw InputError(body.place(""), "[body] without mass",
                       "mass = \"5 g\", or no section [body]");
    const Quantity mass = quantities_.read(body, "mass", "m", Dimension::mass, nonnegative);
    if (mass.value == 0.0) return;
    if (gives())
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
    Quantity omega = quantities_.read(oscillation, "angular_frequency", "omega",
                                      Dimension::angular_frequency, positive);
    const Quantity frequency =
        quantities_.read(oscillation, "frequency", "frequency", Dimension::frequency, positive);
    quantities_.refuse_both("frequency", "angular_frequency");
    quantities_.refuse_both("frequency", "omega");
    if (frequency.value && (!omega.value || settings().has("frequency")))
      omega.value = two_pi * *frequency.value;
    scene_.angular_frequency = omega;
    scene_.amplitude =
        quantities_.read(oscillation, "amplitude", "du_z", Dimension::length, nonnegative);
    scene_.indentation =
        quantities_.read(oscillation, "indentation", "u_z0", Dimension::length, nonnegative);
  }

  void read_friction() {
    const Section friction = section("friction", {"coefficient"});
    scene_.coefficient =
        quantities_.read(friction, "coefficient", "mu0", Dimension::none, nonnegative);
  }

  Section section(const char* name, std::initializer_list<const char*> keys) const {
    return {document_.get(name), name, file_, keys};
  }

  void read_elements() {
    const toml::table* elements = document::table(document_, "elements", file_);
    std::set<std::string> taken;
    for (const auto& [name, dimension] : settings().known()) taken.insert(name);
    auto uses = networks_.names().resolve(networks_.uses());
    expressions_.emplace(elements, file_, networks_.names(), uses, document_.contains("indenter"));
    uses.insert(expressions_->parameters().begin(), expressions_->parameters().end());
    for (const auto& [element, text] : expressions_->all())
      scene_.expressions[to_text(element)] = text;
    for (const auto& [name, use] : uses) {
      refuse_clash(name, use, taken);
      if (const std::string own_name = own({name}).name; own_name != name)
        scene_.names[own_name] = name;
      read_element(name, use, elements == nullptr ? nullptr : elements->get(name));
    }
    read_other_keys(uses);
    rename_elements();
    expressions_->refuse_divisions([this](const Symbol& part) { return is_zero(own(part)); });
    if (elements == nullptr) return;
    for (const auto& [key, value] : *elements)
      if (!uses.contains(std::string(key.str())) &&
          !networks_.names().is_used(std::string(key.str())) &&
          !expressions_->is_used(std::string(key.str())))
        scene_.warnings.push_back(fmt::format("{}: element \"{}\" is in no network of this scene",
                                              to_text(document::place_of(value, file_)),
                                              std::string(key.str())));
  }

  // Without a body, m is free for a mass of the drive.
  void refuse_clash(const std::string& name, const ElementUse& use,
                    std::set<std::string> taken) const {
    if (!has_body() && use.dimension != Dimension::mass) taken.insert("m");
    check_symbol_name(name, "an element", use.place, std::move(taken));
    const toml::table* networks = document::table(document_, "networks", file_);
    if (networks != nullptr && networks->contains(name))
      throw InputError(use.place, fmt::format("\"{}\" as a network and as an element", name),
                       "one of the two");
  }

  // --set may name the key of an element that is called otherwise, as it may name the keys of
  // quantities, unless other elements are called so as well.
  void read_other_keys(const ElementNames::Uses& uses) {
    for (const auto& [key, element] : networks_.names().sole()) {
      if (expressions_->has(element)) {
        refuse_to_set(key, element);
        continue;
      }
      quantities_.refuse_both(to_text(element), key);
      const auto set = settings().take(key, uses.at(element.name).dimension, own(element));
      if (set) put(own(element), *set, OverridingValues::place(key));
    }
    for (const auto& [key, element] : networks_.names().shared())
      if (settings().has(key))
        throw InputError(OverridingValues::place(key),
                         fmt::format("\"{}\", which this scene calls {}, as other elements", key,
                                     to_text(element)),
                         fmt::format("\"{}\", which sets them all", to_text(element)));
  }

  // By what an element is known in the program, which may have a quantity that is called otherwise
  // in this scene, but so there.
  Symbol own(const Symbol& element) const {
    return {own_name_of(element.name, scene_.names.contains("m")), element.entry};
  }

  void rename_elements() {
    const auto name = [this](const Symbol& symbol) {
      return expressions_->amount(networks_.names().of(symbol),
                                  [this](const Symbol& element) { return own(element); });
    };
    rename(scene_.normal, name);
    if (auto* tangential = std::get_if<Network>(&scene_.tangential)) rename(*tangential, name);
    if (scene_.drive) rename(*scene_.drive, name);
  }

  // Whose number is that of an expression.
  void refuse_to_set(const std::string& key, const Symbol& element) const {
    if (quantities_.settings().has(key))
      refuse_expression(scene_, to_text(element), OverridingValues::place(key));
  }

  void read_element(const std::string& name, const ElementUse& use, const toml::node* node) {
    if (use.length > 0) return read_array(name, use, node);
    if (expressions_->has({name})) return refuse_to_set(name, {name});
    const Symbol symbol = own({name});
    const auto set = settings().take(name, use.dimension, symbol);
    if (set) put(symbol, *set, OverridingValues::place(name));
    if (node == nullptr) return;
    const Place place = document::place_of(*node, file_);
    const auto value = number(*node, use.dimension, name, place);
    if (value && !set) put(symbol, *value, place);
  }

  void read_array(const std::string& name, const ElementUse& use, const toml::node* node) {
    scene_.arrays[own({name}).name] = use.length;
    if (node != nullptr && !node->is_array())
      throw InputError(document::place_of(*node, file_),
                       fmt::format("{} = {}", name, describe_node(*node)),
                       fmt::format("an array of {} entries", use.length));
    for (int entry = 1; entry <= use.length; ++entry) {
      if (networks_.names().is_used(to_text(Symbol{name, entry}))) continue;
      const Symbol symbol = own({name, entry});
      const std::string label = to_text(Symbol{name, entry});
      if (expressions_->has({name, entry})) {
        refuse_to_set(label, {name, entry});
        continue;
      }
      const auto set = settings().take(label, use.dimension, symbol);
      if (set) put(symbol, *set, OverridingValues::place(label));
      if (node == nullptr) continue;
      const toml::node& item = *node->as_array()->get(static_cast<std::size_t>(entry - 1));
      const Place place = document::place_of(item, file_);
      const auto value = number(item, use.dimension, label, place);
      if (value && !set) put(symbol, *value, place);
    }
  }

  void put(const Symbol& symbol, const TypedNumber& number, const Place& place) {
    values_[symbol] = checked(number.value, nonnegative, to_text(as_called(scene_, symbol)), place);
    scene_.typed[symbol] = number;
  }

  bool is_zero(const Symbol& symbol) const {
    const auto value = values_.find(symbol);
    return value != values_.end() && value->second == 0;
  }

  void leave_out_zeros() {
    const auto zero = [this](const Symbol& symbol) { return is_zero(symbol); };
    scene_.normal = without_zeros(scene_.normal, zero, "normal", file_);
    if (auto* tangential = std::get_if<Network>(&scene_.tangential)) {
      *tangential = without_zeros(*tangential, zero, "tangential", file_);
      // Equal networks are an isotropic contact: the rheology cancels wherever it can.
      if (*tangential == scene_.normal)
        scene_.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, 1.0}};
    }
    if (scene_.drive) scene_.drive = without_zeros(*scene_.drive, zero, "drive", file_);
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

  OverridingValues& settings() { return quantities_.settings(); }

  static constexpr std::array<const char*, 3> ways_{"poisson", "tangential_ratio", "tangential"};
  toml::table document_;
  std::string file_;
  Networks networks_;
  Quantities quantities_;
  std::optional<ElementExpressions> expressions_;  // once networks and --set have been read
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
