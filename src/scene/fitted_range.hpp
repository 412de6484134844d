// fitted_range of [contact]: the frequencies that the contact's networks were fitted to.
#pragma once

#include <toml++/toml.h>

#include "scene/document.hpp"
#include "scene/quantity.hpp"

namespace vcrit {

/// Nothing where the key is not there. Throws InputError for anything but two frequencies, the
/// lower one first.
std::optional<FittedRange> read_fitted_range(const document::Section& contact);

}  // namespace vcrit
