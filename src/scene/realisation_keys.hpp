// The keys of a measured drive beside its table: what is asked of the structure that moves in time
// like it.
#pragma once

#include "scene/document.hpp"
#include "scene/receptance.hpp"

namespace vcrit {

/// static_compliance (m/N) and order of [drive], where they are given. Throws InputError for a
/// value that they may not have.
void read_realisation_keys(const document::Section& drive, Receptance& receptance);
/// Throws InputError where one of them is given, as for a drive that is a network.
void refuse_realisation_keys(const document::Section& drive);

}  // namespace vcrit
