// All that is wrong with a scene, at once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/errors.hpp"
#include "scene/scene.hpp"

namespace vcrit {

struct SceneFindings {
  std::vector<InputError> errors;  ///< by line; the first one is what reading would throw, or near
  std::vector<Warning> warnings;   ///< by line
  std::optional<Scene> scene;      ///< where there is no error
};

/// Reads the text as parse_scene() does, and goes on behind what is wrong.
SceneFindings examine_scene(const std::string& text, const std::string& file);

}  // namespace vcrit
