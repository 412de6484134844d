// What reading lets no scene be, asked of one whose members were changed: networks with elements
// that it has no entry for, masses off the drive's far end, two drives, an indenter on no
// half-space or without its sizes.
#pragma once

#include "base/errors.hpp"
#include "scene/quantity.hpp"

namespace vcrit {

struct Scene;

/// Values and ranges are not looked at (problem/problem.hpp does). `elements`: the scene's, by
/// symbol. Throws InputError with the scene's file and the member.
void check_members(const Scene& scene, const Values& elements);

/// Throws InputError, with `place`, for an indenter that reading would not have made: without one
/// of its sizes or with one out of range, or by a table that is none.
void check_indenter(const Indenter& indenter, const Place& place);

/// The same for the rows of its table.
void check_profile(const Profile& profile, const Place& place);

}  // namespace vcrit
