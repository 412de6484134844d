// Whether two networks are one network with other values.
#pragma once

#include <ginac/ginac.h>

#include <optional>

#include "network/network.hpp"

namespace vcrit::symbolic {

/// If `other` has the shape of `network` (the parts of a series or parallel combination in any
/// order), the ratio by which all its stiffnesses and dampers must exceed those of `network` for
/// the two to be proportional: the quotient of the first springs, or of the first dampers if there
/// is no spring. Nothing if the shapes differ.
std::optional<GiNaC::ex> ratio_of_same_shape(const Network& network, const Network& other);

}  // namespace vcrit::symbolic
