#include "scene/section_keys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/errors.hpp"

namespace vcrit::document {

namespace {

struct SectionKeys {
  std::string name;
  std::vector<std::string> keys;
};

const std::vector<SectionKeys>& sections() {
  static const std::vector<SectionKeys> all{
      {"",
       {"title", "contact", "indenter", "drive", "body", "mount", "oscillation", "load", "friction",
        "elements", "networks"}},
      {"contact",
       {"normal", "dynamic_stiffness", "static_stiffness", "poisson", "tangential_ratio",
        "tangential", "tangential_dynamic_stiffness", "separation", "fitted_range"}},
      {"indenter", {"shape", "radius", "angle", "prefactor", "exponent"}},
      {"drive", {"network", "receptance", "static_compliance", "order"}},
      {"body", {"mass"}},
      {"mount", {"network", "mass"}},
      {"oscillation", {"frequency", "angular_frequency", "amplitude", "indentation"}},
      {"load", {"force"}},
      {"friction", {"coefficient"}}};
  return all;
}

struct OtherWord {
  const char* word;
  const char* advice;
};

constexpr const char* load_advice =
    "a mean normal force is force in [load], in place of the indentation: force = \"50 N\"";
constexpr const char* speed_advice =
    "a sliding speed belongs to the command: vcrit simulate SCENE --velocity \"1 mm/s\"";
constexpr const char* elements_advice = "springs and dampers have their values in [elements]";

constexpr std::array<OtherWord, 37> other_words{
    {{"load", load_advice},
     {"force", load_advice},
     {"normal_force", load_advice},
     {"normal_load", load_advice},
     {"static_force", load_advice},
     {"preload", load_advice},
     {"weight", load_advice},
     {"speed", speed_advice},
     {"velocity", speed_advice},
     {"sliding_speed", speed_advice},
     {"sliding_velocity", speed_advice},
     {"v0", speed_advice},
     {"springs", elements_advice},
     {"dampers", elements_advice},
     {"parameters", elements_advice},
     {"values", elements_advice},
     {"nu", "Poisson's ratio is poisson"},
     {"mu", "the coefficient of friction is coefficient"},
     {"mu0", "the coefficient of friction is coefficient"},
     {"f", "the frequency is frequency, as in \"20 kHz\""},
     {"omega", "the angular frequency is angular_frequency, as in \"1.2e5 rad/s\""},
     {"du_z", "the amplitude is amplitude, half of peak to peak"},
     {"peak_to_peak", "give the amplitude, half of peak to peak"},
     {"amplitude_pp", "give the amplitude, half of peak to peak"},
     {"u_z0", "the mean indentation is indentation"},
     {"depth", "the mean indentation is indentation"},
     {"m", "the mass of the body is mass"},
     {"spring", "a spring is an element: network = \"kd\", and kd = \"2 N/um\" in [elements]"},
     {"vibration", "what vibrates is said in [oscillation]"},
     {"material", "the material is a network, normal in [contact], of elements in [elements]"},
     {"simulation", "a simulation is asked for by the command: vcrit simulate SCENE"},
     {"stiffness", "a spring is an element: network = \"kd\", and kd = \"2 N/um\" in [elements]"},
     {"young",
      "below an [indenter] Young's modulus is normal = \"spring(E)\", with E in [elements]"},
     {"modulus",
      "below an [indenter] Young's modulus is normal = \"spring(E)\", with E in [elements]"},
     {"E", "below an [indenter] Young's modulus is normal = \"spring(E)\", with E in [elements]"},
     {"punch_radius",
      "vcrit fit --punch-radius makes a contact of a table of moduli, below a flat punch"},
     {"density", "vcrit takes the mass itself: mass = \"5 g\" in [body]"}}};

}  // namespace

const std::vector<std::string>& keys_of(const std::string& name) {
  for (const SectionKeys& section : sections())
    if (section.name == name) return section.keys;
  throw Bug("a section without its keys");
}

std::string advice_on_key(const std::string& key, const std::string& section) {
  for (const auto& [name, keys] : sections())
    if (!name.empty() && name != section && std::find(keys.begin(), keys.end(), key) != keys.end())
      return fmt::format("{} belongs in [{}]", key, name);
  for (const auto& [word, advice] : other_words)
    if (key == word) return advice;
  return "";
}

}  // namespace vcrit::document
