// The keys of a contact that was measured: its tables, and what it carries at rest.
#pragma once

#include <optional>
#include <vector>

#include "base/errors.hpp"
#include "network/network.hpp"
#include "scene/document.hpp"
#include "scene/networks.hpp"
#include "scene/scene.hpp"

namespace vcrit {

enum class MeasuredSide { normal, tangential };

/// Whether [contact] has a table there in place of a network.
bool has_measured(const document::Section& contact, MeasuredSide side);

/// The table's element, which `scene` gets with the names of its numbers: k_n and eta_n at omega,
/// k_n0 at rest; k_t and eta_t. Throws InputError, also for a table beside a network.
Network read_measured_contact(const document::Section& contact, MeasuredSide side, Scene& scene,
                              Networks& networks, std::vector<Warning>& warnings);

/// Throws InputError for static_stiffness without a table.
void refuse_static_stiffness(const document::Section& contact);

}  // namespace vcrit
