// The section [mount] of a scene: what no mount may be, and whether the body's mass moves with it.
#pragma once

#include <string>

#include "network/network.hpp"
#include "scene/document.hpp"

namespace vcrit {

/// The mount. Throws InputError for masses inside, and where no spring carries the mean normal
/// force.
Network checked_mount(Network mount, const document::Section& section);

/// The same of one that elements of value 0 are left out of. `file`: the scene's.
void check_mount_without_zeros(const Network& mount, const std::string& file);

/// Whether the mass in [mount] is that in [body], by its name.
bool moves_the_body(const document::Section& mount, const document::Section& body);

}  // namespace vcrit
