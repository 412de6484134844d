// The section [indenter]: a shape by name with its sizes, or a table of it.
#pragma once

#include <filesystem>

#include "scene/document.hpp"
#include "scene/quantities.hpp"
#include "scene/quantity.hpp"

namespace vcrit {

/// `folder`: where the name of a table begins. Throws InputError.
Indenter read_indenter(const document::Section& section, const std::filesystem::path& folder,
                       Quantities& quantities);

}  // namespace vcrit
