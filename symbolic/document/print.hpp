// The derivation of a scene as a document.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace vcrit::symbolic {

enum class Format { text, latex, markdown, json };

/// What `vcrit derive` prints; the same bytes in every run. With limits come asymptotes and
/// resonances.
std::string print(const Scene& scene, Format format, bool with_limits,
                  bool with_sensitivities = false);

}  // namespace vcrit::symbolic
