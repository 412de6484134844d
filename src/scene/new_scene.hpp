// A scene to be filled in: each number has its unit, a typical value and where to find it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vcrit {

/// What stands in a new scene in the place of a value; reading refuses it.
constexpr const char* to_be_filled_in = "?";

struct NewScene {
  std::string rheology;              ///< of the contact, by a name in the catalogue
  std::optional<std::string> drive;  ///< likewise; rigid without
  bool has_body = false;             ///< only under a drive that gives
  bool may_open = false;             ///< separation = true
};

/// The names of rheologies that a contact or a drive may have by itself: not of masses alone.
std::vector<std::string> rheologies_of_parts();

/// The text, in TOML. Throws InputError for unknown rheologies and a body under a rigid drive.
std::string new_scene_text(const NewScene& scene);

/// How many numbers are to be filled in.
std::size_t numbers_to_fill_in(const std::string& text);

}  // namespace vcrit
