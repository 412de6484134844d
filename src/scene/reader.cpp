// The scene format: sections, quantities with units, elements, and what of it is left out.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/complaints.hpp"
#include "base/constants.hpp"
#include "base/files.hpp"
#include "base/joined.hpp"
#include "base/sort_stably.hpp"
#include "base/units.hpp"
#include "network/masses.hpp"
#include "scene/document.hpp"
#include "scene/element_values.hpp"
#include "scene/findings.hpp"
#include "scene/fitted_range.hpp"
#include "scene/indenter.hpp"
#include "scene/measured_contact.hpp"
#include "scene/mount_section.hpp"
#include "scene/networks.hpp"
#include "scene/part_networks.hpp"
#include "scene/quantities.hpp"
#include "scene/realisation_keys.hpp"
#include "scene/scene.hpp"
#include "scene/section_keys.hpp"

namespace vcrit {

namespace {

using document::describe_node;
using document::Section;

class Reader {
 public:
  Reader(const std::string& text, const std::string& file, const Settings& settings,
         Complaints& complaints)
      : complaints_(complaints),
        document_(document::parse(text, file, complaints)),
        file_(file),
        networks_(document_, file, complaints),
        quantities_(settings, scene_.typed, complaints),
        elements_(document_, file, networks_, quantities_, scene_, complaints) {
    scene_.file = file;
    scene_.text = text;
    scene_.settings = settings;
  }

  /// Of no use where there are complaints.
  Scene read() {
    const Section top(&document_, "", file_, document::keys_of(""), complaints_);
    read_part([&] {
      if (top.find("title") != nullptr) scene_.title = top.text("title");
    });
    read_part([&] { read_contact(); });
    read_part([&] { read_drive(); });
    read_part([&] { read_mount(); });
    read_part([&] { read_indenter(); });
    networks_.read_unused();
    read_part([&] { read_body(); });
    read_part([&] { read_mount_mass(); });
    read_part([&] { read_oscillation(); });
    read_part([&] { read_load(); });
    read_part([&] { read_friction(); });
    read_part([&] { quantities_.refuse_equal_names(); });
    scene_.names = quantities_.names();
    read_part([&] { elements_.read(); });
    if (complaints_.any())
      warn_all(quantities_.warnings());
    else
      read_part([&] { finish(); });
    return std::move(scene_);
  }

  const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  template <class Part>
  void read_part(const Part& part) {
    complaints_.attempt(part);
  }

  // What takes a scene that is whole.
  void finish() {
    elements_.rename_elements();
    warn_all(elements_.warnings());
    settings().refuse_untaken();
    scene_.settable = settings().known();
    scene_.named = settings().named();
    leave_out_zeros();
    collect_elements();
    warn_all(networks_.warnings());
    warn_beyond_the_data();
    warn_all(quantities_.warnings());
    for (const Warning& warning : warnings_) scene_.warnings.push_back(to_text(warning));
  }

  void warn_all(const std::vector<Warning>& warnings) {
    warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
  }

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

  Network normal_network(const Section& contact) {
    if (has_measured(contact, MeasuredSide::normal))
      return read_measured_contact(contact, MeasuredSide::normal, scene_, networks_, warnings_);
    refuse_static_stiffness(contact);
    return contact_network(contact, "normal");
  }

  void read_contact() {
    const Section contact = section("contact");
    if (!contact.exists()) throw InputError({file_}, "no [contact]", "a section [contact]");
    read_part([&] { scene_.normal = normal_network(contact); });
    read_part([&] { scene_.separation = flag(contact, "separation"); });
    read_part([&] { scene_.fitted_range = read_fitted_range(contact); });
    read_tangential(contact);
  }

  void read_tangential(const Section& contact) {
    const auto given = std::count_if(ways_.begin(), ways_.end(),
                                     [&](const char* key) { return contact.find(key) != nullptr; });
    if (given != 1)
      throw InputError(
          contact.place(""),
          fmt::format("{} of {}", given == 0 ? "none" : std::to_string(given), joined(ways_, ", ")),
          "exactly one of them in [contact]");
    if (has_measured(contact, MeasuredSide::tangential)) {
      scene_.tangential =
          read_measured_contact(contact, MeasuredSide::tangential, scene_, networks_, warnings_);
      return;
    }
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
    if (!name) return key;
    std::set<std::string> others;
    for (const auto& [part, symbol] : symbols_of_sections)
      if (document_.contains(part)) others.insert(symbol);
    return own_name_of(*name, others);
  }

  void warn_beyond_the_data() {
    const std::optional<double>& omega = scene_.angular_frequency.value;
    if (!omega) return;
    if (const auto warning = beyond_fitted_range(scene_.fitted_range, file_, *omega, *omega))
      warnings_.push_back({{file_}, warning->substr(to_text(Place{file_}).size() + 2)});
  }

  void read_drive() {
    const Section drive = section("drive");
    if (!drive.exists()) return;
    if (drive.find("receptance") != nullptr) return read_measured(drive);
    refuse_realisation_keys(drive);
    networks_.read_drive_now();
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
    read_realisation_keys(drive, *scene_.receptance);
  }

  void read_mount() {
    const Section mount = section("mount");
    if (!mount.exists()) return;
    scene_.mount = checked_mount(network(mount, "network"), mount);
  }

  // By the body's name it is the body's mass, also under a rigid drive.
  void read_mount_mass() {
    const Section mount = section("mount");
    if (!scene_.mount || mount.find("mass") == nullptr) return;
    if (moves_the_body(mount, section("body"))) {
      scene_.mount_mass = body_mass_;
    } else {
      const Quantity mass = quantities_.read(mount, "mass", "m_n", Dimension::mass, nonnegative,
                                             {.setting = "mount.mass"});
      if (mass.value != 0.0) scene_.mount_mass = mass;
    }
  }

  void read_indenter() {
    const Section indenter = section("indenter");
    if (!indenter.exists()) return;
    refuse_beside_indenter(indenter);
    scene_.indenter =
        vcrit::read_indenter(indenter, std::filesystem::path(file_).parent_path(), quantities_);
  }

  // Whether the drive is a network or measured, and not rigid.
  bool gives() const { return scene_.drive.has_value() || scene_.receptance.has_value(); }

  // Cells of the contact that are of no half-space.
  void refuse_beside_indenter(const Section& indenter) const {
    if (document_.contains("mount"))
      throw InputError(indenter.place(""), "[indenter] with [mount]",
                       "one of the two: the force below an indenter is not harmonic, so that what "
                       "a mount leaves of the vibration is no amplitude");
    if (!scene_.measured.empty())
      throw InputError(indenter.place(""), "[indenter] with a measured stiffness",
                       "a network of the half-space's modulus in [contact]");
    const auto* isotropic = std::get_if<Isotropic>(&scene_.tangential);
    if (isotropic == nullptr || isotropic->by != Isotropic::By::poisson)
      throw InputError(indenter.place(""), "[indenter] without poisson",
                       "poisson = ... in [contact], of the half-space whose Young's modulus "
                       "normal = \"...\" is");
  }

  void read_body() {
    const Section body = section("body");
    if (!body.exists()) return;
    if (body.find("mass") == nullptr)
      throw InputError(body.place(""), "[body] without mass",
                       "mass = \"5 g\", or no section [body]");
    const Quantity mass = quantities_.read(body, "mass", "m", Dimension::mass, nonnegative);
    if (mass.value == 0.0) return;
    body_mass_ = mass;
    if (gives())
      scene_.mass = mass;
    else if (!moves_the_body(section("mount"), body))
      warnings_.push_back(
          {body.place("mass"), "under a rigid drive the mass has no effect and is left out"});
  }

  void read_oscillation() {
    const Section oscillation = section("oscillation");
    if (oscillation.find("frequency") != nullptr &&
        oscillation.find("angular_frequency") != nullptr)
      throw InputError(oscillation.place("angular_frequency"), "frequency and angular_frequency",
                       "one of the two");
    Quantity omega = quantities_.read(oscillation, "angular_frequency", "omega",
                                      Dimension::angular_frequency, positive);
    const Quantity frequency = quantities_.read(oscillation, "frequency", "frequency",
                                                Dimension::frequency, frequency_range);
    quantities_.refuse_both("frequency", "angular_frequency");
    quantities_.refuse_both("frequency", "omega");
    if (frequency.value && (!omega.value || settings().has("frequency")))
      omega.value = two_pi * *frequency.value;
    scene_.angular_frequency = omega;
    // That of the vibrator, which is the contact's where nothing gives between them.
    scene_.amplitude =
        quantities_.read(oscillation, "amplitude", "du_z", Dimension::length, nonnegative,
                         {.name = document_.contains("mount") ? "U" : ""});
    scene_.indentation = {{"u_z0"}, {}};
    if (!document_.contains("load"))
      scene_.indentation =
          quantities_.read(oscillation, "indentation", "u_z0", Dimension::length, nonnegative);
  }

  void read_load() {
    const Section load = section("load");
    if (!load.exists()) return;
    if (load.find("force") == nullptr)
      throw InputError(load.place(""), "[load] without force",
                       "force = \"20 N\", or no section [load]");
    const Section oscillation = section("oscillation");
    if (oscillation.find("indentation") != nullptr)
      throw InputError(
          load.place("force"),
          fmt::format("force in [load] as well as indentation in [oscillation], line {}",
                      oscillation.place("indentation").line),
          "one of the two: the force decides the indentation");
    scene_.load = quantities_.read(load, "force", "W", Dimension::force, positive);
  }

  void read_friction() {
    const Section friction = section("friction");
    scene_.coefficient =
        quantities_.read(friction, "coefficient", "mu0", Dimension::none, nonnegative);
  }

  Section section(const char* name) const {
    return {document_.get(name), name, file_, document::keys_of(name), complaints_};
  }

  void leave_out_zeros() {
    const auto zero = [this](const Symbol& symbol) { return elements_.is_zero(symbol); };
    scene_.normal = without_zeros(scene_.normal, zero, "normal", file_);
    if (auto* tangential = std::get_if<Network>(&scene_.tangential)) {
      *tangential = without_zeros(*tangential, zero, "tangential", file_);
      // Equal networks are an isotropic contact: the rheology cancels wherever it can.
      if (*tangential == scene_.normal)
        scene_.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, 1.0}};
    }
    if (scene_.drive) scene_.drive = without_zeros(*scene_.drive, zero, "drive", file_);
    if (scene_.mount) scene_.mount = without_zeros(*scene_.mount, zero, "mount", file_);
    if (scene_.mount) check_mount_without_zeros(*scene_.mount, file_);
  }

  void collect_elements() {
    std::set<Symbol> seen;
    const auto add = [&](const Network& network) {
      for (const Symbol& symbol : symbols_of(network)) {
        if (!seen.insert(symbol).second) continue;
        scene_.elements.emplace_back(symbol, elements_.value(symbol));
      }
    };
    add(scene_.normal);
    if (const auto* tangential = std::get_if<Network>(&scene_.tangential)) add(*tangential);
    if (scene_.drive) add(*scene_.drive);
    if (scene_.mount) add(*scene_.mount);
  }

  OverridingValues& settings() { return quantities_.settings(); }

  static constexpr std::array<const char*, 4> ways_{"poisson", "tangential_ratio", "tangential",
                                                    "tangential_dynamic_stiffness"};
  Complaints& complaints_;
  toml::table document_;
  std::string file_;
  Scene scene_;
  Networks networks_;
  Quantities quantities_;
  ElementValues elements_;
  std::vector<Warning> warnings_;
  std::optional<Quantity> body_mass_;  // above 0
};

/// Those of the scene's own file first, by line.
std::vector<Warning> sorted(std::vector<Warning> warnings) {
  sort_stably(warnings, [](const Warning& a, const Warning& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  return warnings;
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file, const Settings& settings) {
  Complaints first;
  return Reader(text, file, settings, first).read();
}

Scene read_scene(const std::string& file, const Settings& settings) {
  return parse_scene(read_file(file, document::longest_scene), file, settings);
}

SceneFindings examine_scene(const std::string& text, const std::string& file) {
  Complaints complaints(Complaints::Mode::all);
  SceneFindings found;
  complaints.attempt([&] {
    Reader reader(text, file, {}, complaints);
    Scene scene = reader.read();
    found.warnings = sorted(reader.warnings());
    if (!complaints.any()) found.scene = std::move(scene);
  });
  found.errors = complaints.sorted();
  return found;
}

}  // namespace vcrit
