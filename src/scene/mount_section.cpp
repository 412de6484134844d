#include "scene/mount_section.hpp"

#include "base/errors.hpp"
#include "network/graph.hpp"
#include "network/masses.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

// Its far end, the vibrator, moves: what is ground to a mass in a drive is none here.
Network checked_mount(Network mount, const document::Section& section) {
  if (has_masses(mount))
    throw InputError(section.place("network"), "a mass in the mount",
                     "springs and dampers: a mass inside acts against ground, and the vibrator "
                     "at the mount's far end is none",
                     "what moves with the contact is mass = ... in [mount]");
  if (!springs_alone(mount))
    throw InputError(section.place("network"), "a mount that carries no load at rest: K_m(0) = 0",
                     "a path of springs through it, for the mean normal force");
  return mount;
}

void check_mount_without_zeros(const Network& mount, const std::string& file) {
  if (!springs_alone(mount))
    throw InputError({file}, "a mount that carries no load at rest: K_m(0) = 0",
                     "springs above 0 through it, for the mean normal force");
}

bool moves_the_body(const document::Section& mount, const document::Section& body) {
  if (mount.find("mass") == nullptr || body.find("mass") == nullptr) return false;
  const auto given = bare_name(*mount.find("mass"));
  return given && *given == bare_name(*body.find("mass")).value_or("m");
}

}  // namespace vcrit
